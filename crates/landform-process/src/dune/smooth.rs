//! Diffusion of the sand alone (Pytel 2015, Eq. 4.1), which removes the grooves of the lattice.

use landform_core::Result;
use landform_core::terrain::{HeightField, NodeSurface};

use super::field::{Field, SAND};

/// Largest part of a difference that crosses a face in one round: explicit diffusion is stable
/// below a quarter.
const MOST: f64 = 0.2;

/// Smooths the surface of the sand over a distance of `cells`; sand is conserved, the ground stays,
/// sinks take no part.
pub(super) fn diffuse(terrain: &mut HeightField, field: &Field, cells: f64, torus: bool) -> Result<()> {
    // After n rounds of strength w a point has spread over sqrt(2 n w) cells.
    let rounds = (cells * cells / (2.0 * MOST)).ceil();
    let strength = cells * cells / (2.0 * rounds);
    let Some(depth) = terrain.depth(SAND).map(<[f64]>::to_vec) else { return Ok(()) };
    let shape = terrain.grid().shape;
    let takes_part = |i: usize| !field.sand.is_sink(i);
    let (mut sand, mut flux) = (depth, vec![0.0; shape.len()]);
    let ground: Vec<f64> = (0..shape.len()).map(|i| terrain.elevation()[i] - sand[i]).collect();
    for _ in 0..rounds as u64 {
        // Total outflow of a cell, so that none loses more than it has.
        let links = |i: usize| {
            let cell = shape.cell(i);
            let east = if cell.col + 1 < shape.cols { Some(i + 1) } else { torus.then(|| i + 1 - shape.cols) };
            let south = if cell.row + 1 < shape.rows { Some(i + shape.cols) } else { torus.then_some(cell.col) };
            [east, south].into_iter().flatten().filter(move |&j| j != i && takes_part(i) && takes_part(j))
        };
        let flow = |sand: &[f64], i: usize, j: usize| strength * (ground[i] + sand[i] - ground[j] - sand[j]);
        let mut out = vec![0.0; shape.len()];
        for i in 0..shape.len() {
            for j in links(i) {
                let f = flow(&sand, i, j);
                out[if f > 0.0 { i } else { j }] += f.abs();
            }
        }
        flux.fill(0.0);
        for i in 0..shape.len() {
            for j in links(i) {
                let f = flow(&sand, i, j);
                let from = if f > 0.0 { i } else { j };
                let f = if out[from] > sand[from] { f * (sand[from] / out[from]) } else { f };
                flux[i] -= f;
                flux[j] += f;
            }
        }
        for i in 0..shape.len() {
            sand[i] = (sand[i] + flux[i]).max(0.0);
        }
    }
    terrain.change_depth(SAND, &sand)
}
