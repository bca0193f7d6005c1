//! The variogram: growth of elevation differences with distance.
//!
//! # Method
//! Mean squared difference over all pairs of valid nodes 1, 2, 4, … 32 nodes apart along rows and
//! columns; H is half the slope of its logarithm on that of the lag. Nothing is removed, or the
//! best plane.
//!
//! # Sources
//! Mandelbrot & Van Ness (1968): E|Δz|² ~ lag^(2H). The estimate is biased (on surfaces of H = 0.3,
//! 0.5, 0.7, 0.9 it reads 0.385, 0.538, 0.697, 0.837): compare it with itself, not with theory.

use serde::{Deserialize, Serialize};

use crate::grid::Grid;
use crate::{math, parallel};

/// Lags, nodes.
pub const LAGS: [usize; 6] = [1, 2, 4, 8, 16, 32];

/// Mean squared differences and the exponents that follow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Variogram {
    /// (lag in m, mean squared difference in m²), rows and columns together.
    pub points: Vec<(f64, f64)>,
    /// Exponent H over all lags.
    pub hurst: f64,
    /// Exponent H over lags 1 to 4: how smooth the finest ground is.
    pub hurst_near: f64,
    /// Exponent H over lags 8 to 32.
    pub hurst_far: f64,
    /// Exponent H along rows alone.
    pub hurst_rows: f64,
    /// Exponent H along columns alone.
    pub hurst_columns: f64,
    /// Exponent H after removing the best plane.
    pub hurst_detrended: f64,
}

/// The variogram of a raster of elevations (m). **Cost** O(n).
pub fn variogram(grid: &Grid, z: &[f64]) -> Variogram {
    let (rows, columns) = (sums(grid, z, false), sums(grid, z, true));
    let mean = |s: &(f64, f64)| s.0 / s.1;
    let both: Vec<f64> = rows.iter().zip(&columns).map(|(a, b)| (a.0 + b.0) / (a.1 + b.1)).collect();
    let one_way = |list: &[(f64, f64)]| hurst(&list.iter().map(mean).collect::<Vec<_>>(), 0..6);
    let plane = plane(grid, z);
    let spacing = (grid.spacing[0] * grid.spacing[1]).sqrt();
    let detrended: Vec<f64> = LAGS
        .iter()
        .zip(rows.iter().zip(&columns))
        .map(|(&lag, (r, c))| {
            // A plane adds (slope · lag)² to each mean square of what is left, up to a cross term
            // that its fit makes zero in the mean.
            let (px, py) = (plane[0] * lag as f64, plane[1] * lag as f64);
            (r.0 - 2.0 * px * sum_of_differences(grid, z, lag, false) + px * px * r.1 + c.0
                - 2.0 * py * sum_of_differences(grid, z, lag, true)
                + py * py * c.1)
                / (r.1 + c.1)
        })
        .collect();
    Variogram {
        points: LAGS.iter().zip(&both).map(|(&lag, &v)| (lag as f64 * spacing, v)).collect(),
        hurst: hurst(&both, 0..6),
        hurst_near: hurst(&both, 0..3),
        hurst_far: hurst(&both, 3..6),
        hurst_rows: one_way(&rows),
        hurst_columns: one_way(&columns),
        hurst_detrended: hurst(&detrended, 0..6),
    }
}

fn hurst(values: &[f64], range: std::ops::Range<usize>) -> f64 {
    let points = range.map(|k| (math::log(LAGS[k] as f64), math::log(values[k])));
    0.5 * math::line_fit(points.filter(|p| p.1.is_finite()).collect::<Vec<_>>().into_iter()).0
}

/// Calls `f` with the difference of every valid pair of a lag and adds up.
fn over_pairs(grid: &Grid, z: &[f64], lag: usize, down: bool, f: impl Fn(f64) -> f64 + Sync) -> (f64, f64) {
    let (rows, cols) = (grid.shape.rows, grid.shape.cols);
    let (far, rows, cols) =
        if down { (lag * cols, rows.saturating_sub(lag), cols) } else { (lag, rows, cols.saturating_sub(lag)) };
    let each = |row: usize| {
        let first = row * grid.shape.cols;
        (first..first + cols).fold((0.0, 0.0), |(sum, count), i| {
            let d = z[i + far] - z[i];
            if d.is_nan() { (sum, count) } else { (sum + f(d), count + 1.0) }
        })
    };
    parallel::map(rows, each).into_iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1))
}

fn sums(grid: &Grid, z: &[f64], down: bool) -> Vec<(f64, f64)> {
    LAGS.iter().map(|&lag| over_pairs(grid, z, lag, down, |d| d * d)).collect()
}

fn sum_of_differences(grid: &Grid, z: &[f64], lag: usize, down: bool) -> f64 {
    over_pairs(grid, z, lag, down, |d| d).0
}

/// Rise per node along columns and rows of the best plane through all valid nodes.
fn plane(grid: &Grid, z: &[f64]) -> [f64; 2] {
    let shape = grid.shape;
    let valid = |i: usize| !z[i].is_nan();
    let sum = |f: &(dyn Fn(f64, f64, f64) -> f64 + Sync)| {
        parallel::sum(z.len(), |i| {
            let c = shape.cell(i);
            if valid(i) { f(c.col as f64, c.row as f64, z[i]) } else { 0.0 }
        })
    };
    let n = sum(&|_, _, _| 1.0);
    let [mx, my, mz] = [sum(&|x, _, _| x) / n, sum(&|_, y, _| y) / n, sum(&|_, _, z| z) / n];
    let [xx, xy, yy] =
        [sum(&|x, _, _| (x - mx) * (x - mx)), sum(&|x, y, _| (x - mx) * (y - my)), sum(&|_, y, _| (y - my) * (y - my))];
    let [xz, yz] = [sum(&|x, _, z| (x - mx) * (z - mz)), sum(&|_, y, z| (y - my) * (z - mz))];
    let det = xx * yy - xy * xy;
    if det > 0.0 { [(xz * yy - yz * xy) / det, (yz * xx - xz * xy) / det] } else { [0.0, 0.0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::noise::{Faults, faults, self_affine};
    use crate::grid::Shape;
    use crate::random::Seed;

    #[test]
    fn exponents_are_those_of_the_calibrated_estimator() {
        // FB4 against what the estimator reads on surfaces of known H (see Sources).
        let grid = Grid::new(Shape::new(512, 512), [1.0, 1.0]).unwrap();
        for (hurst, reads) in [(0.3, 0.385), (0.5, 0.538), (0.7, 0.697), (0.9, 0.837)] {
            let mean = (1..=3)
                .map(|s| variogram(&grid, &self_affine(grid.shape, grid.spacing, hurst, Seed(s))).hurst)
                .sum::<f64>()
                / 3.0;
            assert!((mean - reads).abs() < 0.03 && (mean - hurst).abs() < 0.09, "H = {hurst}: {mean}");
        }
    }

    #[test]
    fn faults_make_brownian_ground() {
        let grid = Grid::new(Shape::new(300, 300), [1.0, 1.0]).unwrap();
        let mean = (1..=3)
            .map(|s| variogram(&grid, &faults(&grid, Faults { count: 2_000, width: 0.0 }, Seed(s))).hurst)
            .sum::<f64>()
            / 3.0;
        assert!((mean - 0.5).abs() < 0.06, "{mean}");
    }

    #[test]
    fn a_plane_is_taken_off() {
        let grid = Grid::new(Shape::new(90, 80), [1.0, 1.0]).unwrap();
        let rough: Vec<f64> = (0..grid.len()).map(|i| Seed(1).uniform(i as u64)).collect();
        let tilted: Vec<f64> =
            (0..grid.len()).map(|i| rough[i] + 0.7 * (i % 80) as f64 - 0.3 * (i / 80) as f64).collect();
        let (a, b) = (variogram(&grid, &rough), variogram(&grid, &tilted));
        assert!((a.hurst_detrended - b.hurst_detrended).abs() < 1e-6 && b.hurst > 0.9, "{a:?} {b:?}");
    }
}
