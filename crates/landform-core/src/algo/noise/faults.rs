//! Ground broken by faults.
//!
//! # Method
//! Straight lines thrown at random (their number in a disc around the map is given, their
//! directions even, their distances from the middle even: a Poisson process of lines); each lifts
//! the ground on one side by a Gaussian throw. The sum of many is Brownian: H = ½. A width makes
//! each step a smooth ramp. Along a row, ground beyond a ramp is added by running sums: cost
//! O(faults × rows + nodes), not their product.
//!
//! # Sources
//! Mandelbrot (1975); Voss (1985); Pytel's thesis 2.1.3.

use super::spectral::standardized;
use crate::grid::Grid;
use crate::random::Seed;
use crate::{math, parallel};

/// Number and width of faults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faults {
    /// Number of faults.
    pub count: usize,
    /// Width of the ramp at a fault, m; 0 is a cliff.
    pub width: f64,
}

/// A surface of mean 0 and standard deviation 1 (all 0 without faults).
pub fn faults(grid: &Grid, what: Faults, seed: Seed) -> Vec<f64> {
    let [dx, dy] = grid.extent();
    let middle = [grid.origin[0] + 0.5 * dx, grid.origin[1] - 0.5 * dy];
    let radius = 0.5 * math::hypot(dx, dy);
    let half = 0.5 * what.width;
    // Normal (towards the lifted side), distance from the middle, throw.
    let lines: Vec<([f64; 2], f64, f64)> = (0..what.count as u64)
        .map(|k| {
            let seed = seed.with(k);
            let turn = std::f64::consts::TAU * seed.uniform(1);
            let normal = [math::cos(turn), math::sin(turn)];
            (normal, radius * (2.0 * seed.uniform(2) - 1.0), seed.normal_pair(3).0)
        })
        .collect();
    let cols = grid.shape.cols;
    let (west, step) = (grid.origin[0] - middle[0], grid.spacing[0]);
    let mut z = vec![0.0; grid.len()];
    parallel::for_rows_mut(&mut z, cols, |row, out| {
        let y = grid.position(row * cols)[1] - middle[1];
        let mut change = vec![0.0; cols + 1];
        for &([nx, ny], distance, throw) in &lines {
            // Signed distance along the row: rise · col + at_west.
            let (rise, at_west) = (nx * step, nx * west + ny * y - distance);
            let height = |d: f64| throw * math::smoothstep(-half, half, d);
            if rise.abs() < 1e-12 * step {
                change[0] += height(at_west);
                continue;
            }
            // Columns at which the ramp begins and ends, from west to east.
            let at = |d: f64| ((d - at_west) / rise).clamp(-1.0, cols as f64);
            let (from, to) = if rise > 0.0 { (at(-half), at(half)) } else { (at(half), at(-half)) };
            let (first, last) = ((from.floor() + 1.0) as usize, (to.ceil().max(0.0) as usize).min(cols));
            let (west_side, east_side) = if rise > 0.0 { (0.0, throw) } else { (throw, 0.0) };
            change[0] += west_side;
            let first = first.min(cols);
            for (col, o) in out.iter_mut().enumerate().take(last).skip(first) {
                *o += height(at_west + rise * col as f64) - west_side;
            }
            change[last.max(first)] += east_side - west_side;
        }
        let mut sum = 0.0;
        for (o, c) in out.iter_mut().zip(&change) {
            sum += c;
            *o += sum;
        }
    });
    standardized(z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;

    #[test]
    fn running_sums_agree_with_the_definition() {
        let grid = Grid::new(Shape::new(20, 30), [10.0, 15.0]).unwrap();
        for width in [0.0, 4.0, 60.0, 1e4] {
            let what = Faults { count: 40, width };
            let found = faults(&grid, what, Seed(9));
            let [dx, dy] = grid.extent();
            let radius = 0.5 * math::hypot(dx, dy);
            let z = (0..grid.len()).map(|i| {
                let [x, y] = grid.position(i);
                (0..40)
                    .map(|k| {
                        let seed = Seed(9).with(k);
                        let turn = std::f64::consts::TAU * seed.uniform(1);
                        let d = math::cos(turn) * (x - 0.5 * dx) + math::sin(turn) * (y - 0.5 * dy)
                            - radius * (2.0 * seed.uniform(2) - 1.0);
                        seed.normal_pair(3).0 * math::smoothstep(-0.5 * width, 0.5 * width, d)
                    })
                    .sum()
            });
            let expected = standardized(z.collect());
            let worst = found.iter().zip(&expected).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(worst < 1e-9, "width {width}: {worst}");
        }
    }
}
