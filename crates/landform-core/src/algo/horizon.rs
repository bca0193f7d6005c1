//! Visibility: shadows of a sun or a wind, and the ground in view of a point.
//!
//! # Method
//! From each node a line is followed in steps of one cell, with linear elevations between nodes,
//! until no ground of the map can hide it. **Cost** O(n · relief / (cell · tan altitude)) for
//! shadows, O(n · side) for a view.
//!
//! # Example
//! A wall of 15 m throws a shadow of 15 m where the sun stands at 45 degrees:
//!
//! ```
//! use landform_core::algo::horizon::shadow;
//! use landform_core::grid::{Grid, Shape};
//!
//! let grid = Grid::new(Shape::new(3, 7), [10.0, 10.0])?;
//! let wall = [0.0, 0.0, 15.0, 0.0, 0.0, 0.0, 0.0].repeat(3);
//! let dark = shadow(&grid, &wall, 270_f64.to_radians(), 45_f64.to_radians());
//! assert_eq!(dark[7..14], [false, false, false, true, false, false, false]);
//! # Ok::<(), landform_core::Error>(())
//! ```

use crate::grid::Grid;
use crate::{math, parallel};

/// The line between nodes that is looked along: bilinear elevation at a real (column, row), or none
/// off the map or beside nodata.
fn elevation_at(grid: &Grid, z: &[f64], c: f64, r: f64) -> Option<f64> {
    let shape = grid.shape;
    if !(c >= 0.0 && r >= 0.0 && c <= (shape.cols - 1) as f64 && r <= (shape.rows - 1) as f64) {
        return None;
    }
    let (c0, r0) = (c as usize, r as usize);
    let (c1, r1) = ((c0 + 1).min(shape.cols - 1), (r0 + 1).min(shape.rows - 1));
    let at = |r: usize, c: usize| z[shape.index(r, c)];
    let (fc, fr) = (c - c0 as f64, r - r0 as f64);
    let row = |r: usize| if fc == 0.0 { at(r, c0) } else { math::lerp(at(r, c0), at(r, c1), fc) };
    let value = if fr == 0.0 { row(r0) } else { math::lerp(row(r0), row(r1), fr) };
    (!value.is_nan()).then_some(value)
}

/// Whether each node lies in the shadow of other ground: the sun (or the wind) comes from compass
/// direction `azimuth` at `altitude` above level, radians. Nodata is not in shadow.
pub fn shadow(grid: &Grid, z: &[f64], azimuth: f64, altitude: f64) -> Vec<bool> {
    let highest = parallel::max(z.len(), |i| z[i]);
    let unit = grid.spacing[0].min(grid.spacing[1]);
    let step = [math::sin(azimuth) * unit / grid.spacing[0], -math::cos(azimuth) * unit / grid.spacing[1]];
    let rise = math::tan(altitude) * unit;
    parallel::map(z.len(), |i| {
        if z[i].is_nan() {
            return false;
        }
        let cell = grid.shape.cell(i);
        let mut k = 1.0;
        loop {
            let ray = z[i] + k * rise;
            let (c, r) = (cell.col as f64 + k * step[0], cell.row as f64 + k * step[1]);
            let inside = c >= 0.0 && r >= 0.0 && c <= (grid.shape.cols - 1) as f64 && r <= (grid.shape.rows - 1) as f64;
            if !inside || ray > highest {
                return false;
            }
            if elevation_at(grid, z, c, r).is_some_and(|ground| ground > ray) {
                return true;
            }
            k += 1.0;
        }
    })
}

/// Whether each node can be seen from `height` m above the node `from`. Curvature of the Earth is
/// left out.
pub fn viewshed(grid: &Grid, z: &[f64], from: usize, height: f64) -> Vec<bool> {
    let eye = z[from] + height;
    let here = grid.shape.cell(from);
    parallel::map(z.len(), |i| {
        let cell = grid.shape.cell(i);
        let (dc, dr) = (cell.col as f64 - here.col as f64, cell.row as f64 - here.row as f64);
        let steps = dc.abs().max(dr.abs());
        if z[i].is_nan() {
            return false;
        }
        let mut k = 1.0;
        while k < steps {
            let t = k / steps;
            let line = eye + (z[i] - eye) * t;
            let ground = elevation_at(grid, z, here.col as f64 + dc * t, here.row as f64 + dr * t);
            if ground.is_some_and(|g| g > line) {
                return false;
            }
            k += 1.0;
        }
        true
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;

    #[test]
    fn a_wall_throws_a_shadow_of_its_height_over_the_tangent() {
        let grid = Grid::new(Shape::new(21, 61), [10.0, 10.0]).unwrap();
        let z: Vec<f64> = (0..grid.len()).map(|i| if grid.shape.cell(i).col == 10 { 100.0 } else { 0.0 }).collect();
        let dark = shadow(&grid, &z, 1.5 * std::f64::consts::PI, math::atan(0.5));
        let row: Vec<usize> = (0..61).filter(|&c| dark[10 * 61 + c]).collect();
        // 100 m at 1 : 2 reach 200 m, 20 cells; the last one is grazed.
        assert_eq!((row[0], row[row.len() - 1]), (11, 29));
    }

    #[test]
    fn what_is_behind_a_wall_is_out_of_view() {
        let grid = Grid::new(Shape::new(21, 61), [10.0, 10.0]).unwrap();
        let z: Vec<f64> = (0..grid.len()).map(|i| if grid.shape.cell(i).col == 30 { 50.0 } else { 0.0 }).collect();
        let seen = viewshed(&grid, &z, 10 * 61 + 5, 2.0);
        assert!(seen[10 * 61 + 29] && seen[10 * 61 + 30] && !seen[10 * 61 + 31] && !seen[10 * 61 + 60]);
        assert!(viewshed(&grid, &z, 10 * 61 + 5, 1e6).iter().all(|&s| s));
    }
}
