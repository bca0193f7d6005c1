//! Facets, and how sharp hollows are.

use crate::grid::{Grid, Shape};
use crate::parallel;

/// Root mean square distance from the plane, over the rise of a cell, below which ground is one.
const FLAT: f64 = 0.03;
/// Share of hollows and of crests that are the sharpest.
const SHARPEST: f64 = 0.05;

/// The share of some nodes around which ground is a plane over five by five nodes; none of no
/// nodes.
pub(super) fn plane_share(grid: &Grid, z: &[f64], nodes: &[usize]) -> Option<f64> {
    let (rows, cols) = (grid.shape.rows, grid.shape.cols);
    let is_flat = |node: usize| {
        let cell = grid.shape.cell(node);
        if cell.row < 2 || cell.col < 2 || cell.row + 3 > rows || cell.col + 3 > cols {
            return None;
        }
        let (mut sum, mut square, mut bx, mut by) = (0.0, 0.0, 0.0, 0.0);
        for r in 0..5 {
            for c in 0..5 {
                let v = z[(cell.row + r - 2) * cols + cell.col + c - 2] - z[node];
                sum += v;
                square += v * v;
                bx += v * (c as f64 - 2.0);
                by += v * (r as f64 - 2.0);
            }
        }
        let (mean, bx, by) = (sum / 25.0, bx / 50.0, by / 50.0);
        let variance = square / 25.0 - mean * mean - 2.0 * (bx * bx + by * by);
        let rise = (bx * bx + by * by).sqrt();
        (!variance.is_nan()).then(|| variance.max(0.0).sqrt() < FLAT * rise)
    };
    let found = parallel::map(nodes.len(), |k| is_flat(nodes[k]));
    let count = |wanted: bool| found.iter().filter(|f| **f == Some(wanted)).count() as f64;
    let (flat, other) = (count(true), count(false));
    (flat + other > 0.0).then(|| flat / (flat + other))
}

/// Mean curvature of the sharpest hollows over that of the sharpest crests, by the Laplacian; none
/// where either is missing.
pub(super) fn sharpness(shape: Shape, z: &[f64], nodes: &[usize]) -> Option<f64> {
    let cols = shape.cols;
    let mut curved = parallel::map(nodes.len(), |k| {
        let i = nodes[k];
        z[i - cols] + z[i + cols] + z[i - 1] + z[i + 1] - 4.0 * z[i]
    });
    parallel::sort_by(&mut curved, f64::total_cmp);
    let few = (curved.len() as f64 * SHARPEST) as usize;
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len().max(1) as f64;
    let (crests, hollows) = (-mean(&curved[..few]), mean(&curved[curved.len() - few..]));
    (crests > 0.0 && hollows > 0.0).then(|| hollows / crests)
}
