//! Slope and shading by Horn's third-order differences, as GDAL computes them.
//!
//! # Sources
//! Horn (1981). At the border and beside nodata the missing neighbour takes the value that the
//! plane through the centre and the opposite neighbour gives (GDAL leaves these cells out unless
//! told to compute edges).

use crate::grid::Grid;
use crate::{math, parallel};

/// Rise over run along x (east) and y (north).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gradient {
    /// ∂z/∂x, rise over run.
    pub x: f64,
    /// ∂z/∂y, rise over run.
    pub y: f64,
}

impl Gradient {
    /// Slope: rise over run.
    pub fn slope(self) -> f64 {
        (self.x * self.x + self.y * self.y).sqrt()
    }

    /// Compass direction that the slope faces, radians clockwise from north; NaN on level ground.
    pub fn aspect(self) -> f64 {
        if self.x == 0.0 && self.y == 0.0 {
            return f64::NAN;
        }
        let a = math::atan2(-self.x, -self.y);
        if a < 0.0 { a + std::f64::consts::TAU } else { a }
    }
}

/// The nine values around a node, row by row from the north-west. A missing one (beyond the border,
/// or nodata) takes the value that the plane through the centre and the opposite neighbour gives;
/// all are NaN on nodata.
pub(super) fn window(grid: &Grid, values: &[f64], node: usize) -> [f64; 9] {
    let cell = grid.shape.cell(node);
    let z = values[node];
    if z.is_nan() {
        return [f64::NAN; 9];
    }
    let cols = grid.shape.cols;
    let inner = cell.row > 0 && cell.col > 0 && cell.row + 1 < grid.shape.rows && cell.col + 1 < cols;
    if inner {
        let (up, down) = (node - cols, node + cols);
        let all = [
            values[up - 1],
            values[up],
            values[up + 1],
            values[node - 1],
            z,
            values[node + 1],
            values[down - 1],
            values[down],
            values[down + 1],
        ];
        if all.iter().all(|v| !v.is_nan()) {
            return all;
        }
    }
    let at = |dr: isize, dc: isize| -> Option<f64> {
        let row = cell.row.checked_add_signed(dr).filter(|&r| r < grid.shape.rows)?;
        let col = cell.col.checked_add_signed(dc).filter(|&c| c < grid.shape.cols)?;
        Some(values[grid.shape.index(row, col)]).filter(|v| !v.is_nan())
    };
    let straight = |dr: isize, dc: isize| at(dr, dc).or_else(|| at(-dr, -dc).map(|o| 2.0 * z - o)).unwrap_or(z);
    let [n, e, s, w] = [straight(-1, 0), straight(0, 1), straight(1, 0), straight(0, -1)];
    let corner =
        |dr: isize, dc: isize, plane: f64| at(dr, dc).or_else(|| at(-dr, -dc).map(|o| 2.0 * z - o)).unwrap_or(plane);
    let [nw, ne] = [corner(-1, -1, n + w - z), corner(-1, 1, n + e - z)];
    let [sw, se] = [corner(1, -1, s + w - z), corner(1, 1, s + e - z)];
    [nw, n, ne, w, z, e, sw, s, se]
}

/// The gradient (rise over run) at a node; NaN on nodata.
pub fn gradient(grid: &Grid, values: &[f64], node: usize) -> Gradient {
    let [nw, n, ne, w, _, e, sw, s, se] = window(grid, values, node);
    Gradient {
        x: ((ne + 2.0 * e + se) - (nw + 2.0 * w + sw)) / (8.0 * grid.spacing[0]),
        y: ((nw + 2.0 * n + ne) - (sw + 2.0 * s + se)) / (8.0 * grid.spacing[1]),
    }
}

/// Slope (rise over run) of every node.
pub fn slope(grid: &Grid, values: &[f64]) -> Vec<f64> {
    parallel::map(values.len(), |i| gradient(grid, values, i).slope())
}

/// Cosine between the ground's normal and the direction to the sun, 0 in its own shadow. `azimuth`
/// clockwise from north and `altitude`, radians; `exaggeration` multiplies the relief.
pub fn hillshade(grid: &Grid, values: &[f64], azimuth: f64, altitude: f64, exaggeration: f64) -> Vec<f64> {
    let (ca, sa) = (math::cos(altitude), math::sin(altitude));
    let sun = [math::sin(azimuth) * ca, math::cos(azimuth) * ca, sa];
    parallel::map(values.len(), |i| {
        let g = gradient(grid, values, i);
        let (gx, gy) = (g.x * exaggeration, g.y * exaggeration);
        ((sun[2] - gx * sun[0] - gy * sun[1]) / (1.0 + gx * gx + gy * gy).sqrt()).max(0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;

    #[test]
    fn a_plane_has_its_slope_everywhere_and_up_to_the_border() {
        let grid = Grid::new(Shape::new(5, 6), [10.0, 20.0]).unwrap();
        let z: Vec<f64> = (0..30).map(|i| 0.3 * grid.position(i)[0] - 0.4 * grid.position(i)[1]).collect();
        for i in 0..30 {
            let g = gradient(&grid, &z, i);
            assert!((g.x - 0.3).abs() < 1e-12 && (g.y + 0.4).abs() < 1e-12 && (g.slope() - 0.5).abs() < 1e-12);
        }
    }

    #[test]
    fn a_slope_towards_the_sun_is_bright() {
        let grid = Grid::new(Shape::new(3, 3), [1.0, 1.0]).unwrap();
        let facing_west: Vec<f64> = (0..9).map(|i| grid.position(i)[0]).collect();
        let shade = hillshade(&grid, &facing_west, 1.5 * std::f64::consts::PI, std::f64::consts::FRAC_PI_4, 1.0);
        assert!((shade[4] - 1.0).abs() < 1e-12);
    }
}
