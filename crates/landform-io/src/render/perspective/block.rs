//! A block of land as a model: its sides, its foot, the water on it.

use landform_core::grid::{Grid, Shape};
use landform_core::terrain::{HeightField, NodeSurface};

use crate::render::ground::has_sea;
use crate::vector::Vector;

/// Blocks along a side whose highest points the frame must hold.
const FRAMED: usize = 96;

/// Sides of a block, m; not 0.
pub(super) fn extent(grid: &Grid) -> [f64; 2] {
    grid.extent().map(|e| e.max(1e-6))
}

/// Least and greatest elevation, m.
pub(super) fn range(z: &[f64]) -> (f64, f64) {
    let finite = z.iter().filter(|z| z.is_finite());
    finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &z| (a.min(z), b.max(z)))
}

/// Level of the foot of a block whose ground lies between two levels, m.
pub(super) fn foot(extent: [f64; 2], low: f64, high: f64) -> f64 {
    low - (0.06 * extent[0].min(extent[1])).max(0.15 * (high - low))
}

/// Points that the frame must hold: the corners of the foot, and the highest point of every part of
/// the surface.
pub(super) fn outline(grid: &Grid, surface: &[f64], foot: f64) -> Vec<Vector> {
    let Shape { rows, cols } = grid.shape;
    let [w, h] = extent(grid);
    let mut points = vec![[0.0, 0.0, foot], [w, 0.0, foot], [0.0, h, foot], [w, h, foot]];
    let step = (rows.max(cols) / FRAMED).max(1);
    for (r, c) in (0..rows).step_by(step).flat_map(|r| (0..cols).step_by(step).map(move |c| (r, c))) {
        let block = (r..(r + step).min(rows)).flat_map(|r| (c..(c + step).min(cols)).map(move |c| (r, c)));
        let height = |&(r, c): &(usize, usize)| surface[grid.shape.index(r, c)];
        if let Some((r, c)) = block.max_by(|a, b| height(a).total_cmp(&height(b))) {
            let [x, y] = [c as f64 * grid.spacing[0], (rows - 1 - r) as f64 * grid.spacing[1]];
            points.push([x, y, height(&(r, c))]);
        }
    }
    points
}

/// Depth of lakes (if `inland`) and of the sea over each node, m. Sea is what lies below its level
/// in a land that also rises above it.
pub(super) fn water_depth(field: &HeightField, lake: &[f64], range: (f64, f64), level: f64, inland: bool) -> Vec<f64> {
    let has_sea = has_sea(field, range, level);
    let depth = |(i, &z): (usize, &f64)| {
        if has_sea && z < level {
            level - z
        } else if inland {
            lake[i]
        } else {
            0.0
        }
    };
    field.elevation().iter().enumerate().map(depth).collect()
}
