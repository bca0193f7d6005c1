//! The part of a raster that is transformed.

use serde::{Deserialize, Serialize};

use crate::grid::{Grid, Shape};
use crate::{math, parallel};

/// A square of nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Window {
    /// First row.
    pub row: usize,
    /// First column.
    pub col: usize,
    /// Nodes along a side.
    pub side: usize,
}

/// The largest square of nodes without nodata; of equal ones that with the top-most, then left-most
/// corner. **Cost** O(n).
pub fn largest_square(shape: Shape, z: &[f64]) -> Option<Window> {
    // Side of the largest square whose lower right corner is here.
    let mut above = vec![0u32; shape.cols];
    let mut best: Option<Window> = None;
    for row in 0..shape.rows {
        let (mut left, mut diagonal) = (0, 0);
        for col in 0..shape.cols {
            let up = above[col];
            let side = if z[shape.index(row, col)].is_nan() { 0 } else { up.min(left).min(diagonal) + 1 };
            (diagonal, left, above[col]) = (up, side, side);
            let side = side as usize;
            let larger = best
                .is_none_or(|b| side > b.side || (side == b.side && (row + 1 - side, col + 1 - side) < (b.row, b.col)));
            if side > 0 && larger {
                best = Some(Window { row: row + 1 - side, col: col + 1 - side, side });
            }
        }
    }
    best
}

impl Window {
    /// Node of a place in the window.
    pub fn node(self, shape: Shape, row: usize, col: usize) -> usize {
        shape.index(self.row + row, self.col + col)
    }

    /// Elevations without their best plane and tapered to the rim; also the mean square of the
    /// taper.
    pub(super) fn cut(self, grid: &Grid, z: &[f64], taper: bool) -> (Vec<f64>, f64) {
        let n = self.side;
        let at = |i: usize| z[self.node(grid.shape, i / n, i % n)];
        let middle = 0.5 * (n - 1) as f64;
        let (x, y) = (|i: usize| (i % n) as f64 - middle, |i: usize| (i / n) as f64 - middle);
        let count = (n * n) as f64;
        let mean = parallel::sum(n * n, at) / count;
        let moment = parallel::sum(n * n, |i| x(i) * x(i));
        let [east, south] =
            [parallel::sum(n * n, |i| x(i) * at(i)) / moment, parallel::sum(n * n, |i| y(i) * at(i)) / moment];
        if !taper {
            return (parallel::map(n * n, |i| at(i) - mean), 1.0);
        }
        let hann: Vec<f64> =
            (0..n).map(|k| 0.5 - 0.5 * math::cos(std::f64::consts::TAU * k as f64 / n as f64)).collect();
        let values = parallel::map(n * n, |i| (at(i) - mean - east * x(i) - south * y(i)) * hann[i % n] * hann[i / n]);
        let one: f64 = hann.iter().map(|h| h * h).sum::<f64>() / n as f64;
        (values, one * one)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_square_avoids_holes() {
        let shape = Shape::new(6, 9);
        let mut z = vec![0.0; 54];
        assert_eq!(largest_square(shape, &z), Some(Window { row: 0, col: 0, side: 6 }));
        z[shape.index(2, 3)] = f64::NAN;
        assert_eq!(largest_square(shape, &z), Some(Window { row: 0, col: 4, side: 5 }));
        assert_eq!(largest_square(shape, &[f64::NAN; 54]), None);
    }
}
