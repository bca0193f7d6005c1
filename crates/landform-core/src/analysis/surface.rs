//! Slopes, directions, curvature and relief of a raster as numbers.
//!
//! # Sources
//! Horn (1981) for slope and aspect, over nodes whose eight neighbours have data; Evans (1972) for
//! curvature; Pytel's thesis, Table 4.1, for the share of slopes within 10 % of the angle of
//! repose.

use serde::{Deserialize, Serialize};

use crate::algo::derivative::{gradient, local_relief, quadratic};
use crate::grid::Grid;
use crate::{math, parallel};

/// The angle of repose of dry sand and scree, degrees.
pub const REPOSE: f64 = 33.0;

/// Slopes and shapes of a raster.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Nodes whose eight neighbours have data.
    pub nodes: usize,
    /// Mean slope, degrees.
    pub slope_mean: f64,
    /// Median slope, degrees.
    pub slope_median: f64,
    /// 90th percentile of the slope, degrees.
    pub slope_p90: f64,
    /// 99th percentile of the slope, degrees.
    pub slope_p99: f64,
    /// Greatest slope, degrees.
    pub slope_max: f64,
    /// Share of nodes within 10 % of the angle of repose, 33 degrees.
    pub talus_share: f64,
    /// Share of nodes below half a degree.
    pub level_share: f64,
    /// Share of nodes by slope, in classes of 2 degrees from 0.
    pub slope_histogram: Vec<f64>,
    /// Share of sloping ground that faces north, north-east, east, … north-west.
    pub aspect_rose: [f64; 8],
    /// Standard deviation of profile curvature, 1/m.
    pub profile_curvature: f64,
    /// Share of sloping nodes whose contours bulge outwards (spurs); the rest are concave.
    pub spur_share: f64,
    /// Mean relief within windows of 11 × 11 nodes, m.
    pub local_relief: f64,
}

/// The surface of a raster of elevations (m); none if no node has eight neighbours with
/// data. **Cost** O(n log n).
pub fn surface(grid: &Grid, z: &[f64]) -> Option<Surface> {
    let whole = |i: usize| has_all_neighbours(grid, z, i);
    let mut slopes: Vec<f64> =
        parallel::map(
            z.len(),
            |i| {
                if whole(i) { math::atan(gradient(grid, z, i).slope()).to_degrees() } else { f64::NAN }
            },
        );
    let share = |f: &(dyn Fn(f64) -> bool + Sync), slopes: &[f64]| {
        parallel::sum(slopes.len(), |i| f64::from(u8::from(f(slopes[i]))))
    };
    let (mut rose, mut sloping, mut spurs) = ([0.0; 8], 0.0, 0.0);
    let mut curvature = (0.0, 0.0);
    let per_piece = parallel::map_pieces(z.len(), |range| {
        let mut sums = [0.0; 12];
        for i in range.filter(|&i| whole(i)) {
            let g = gradient(grid, z, i);
            let q = quadratic(grid, z, i);
            let k = q.profile_curvature();
            (sums[9], sums[10]) = (sums[9] + k, sums[10] + k * k);
            if g.slope() > 0.0 {
                let eighth = (g.aspect() / std::f64::consts::FRAC_PI_4).round() as usize % 8;
                sums[eighth] += 1.0;
                sums[8] += f64::from(u8::from(q.plan_curvature() > 0.0));
            }
            sums[11] += 1.0;
        }
        sums
    });
    let mut count = 0.0;
    for sums in per_piece {
        for k in 0..8 {
            rose[k] += sums[k];
            sloping += sums[k];
        }
        spurs += sums[8];
        curvature = (curvature.0 + sums[9], curvature.1 + sums[10]);
        count += sums[11];
    }
    if count == 0.0 {
        return None;
    }
    let talus = share(&|s| (s - REPOSE).abs() <= 0.1 * REPOSE, &slopes) / count;
    let level = share(&|s| s < 0.5, &slopes) / count;
    let mut histogram = vec![0.0; 45];
    for s in slopes.iter().filter(|s| !s.is_nan()) {
        histogram[((s / 2.0) as usize).min(44)] += 1.0 / count;
    }
    slopes.retain(|s| !s.is_nan());
    parallel::sort_by(&mut slopes, f64::total_cmp);
    let at = |q: f64| {
        let place = q * (slopes.len() - 1) as f64;
        let k = (place as usize).min(slopes.len().saturating_sub(2));
        math::lerp(slopes[k], slopes[(k + 1).min(slopes.len() - 1)], place - k as f64)
    };
    let last = histogram.iter().rposition(|&h| h > 0.0).map_or(0, |k| k + 1);
    histogram.truncate(last);
    let mean_curvature = curvature.0 / count;
    Some(Surface {
        nodes: count as usize,
        slope_mean: parallel::sum(slopes.len(), |i| slopes[i]) / count,
        slope_median: at(0.5),
        slope_p90: at(0.9),
        slope_p99: at(0.99),
        slope_max: at(1.0),
        talus_share: talus,
        level_share: level,
        slope_histogram: histogram,
        aspect_rose: rose.map(|r| if sloping > 0.0 { r / sloping } else { 0.0 }),
        profile_curvature: (curvature.1 / count - mean_curvature * mean_curvature).max(0.0).sqrt(),
        spur_share: if sloping > 0.0 { spurs / sloping } else { 0.0 },
        local_relief: {
            drop(slopes);
            let relief = local_relief(grid.shape, z, 5);
            parallel::sum(z.len(), |i| if whole(i) { relief[i] } else { 0.0 }) / count
        },
    })
}

/// Whether a node and its eight neighbours have data.
pub(super) fn has_all_neighbours(grid: &Grid, z: &[f64], i: usize) -> bool {
    let shape = grid.shape;
    let c = shape.cell(i);
    if c.row == 0 || c.col == 0 || c.row + 1 == shape.rows || c.col + 1 == shape.cols {
        return false;
    }
    let valid = |first: usize| z[first..first + 3].iter().all(|v| !v.is_nan());
    valid(i - shape.cols - 1) && valid(i - 1) && valid(i + shape.cols - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;

    #[test]
    fn a_plane_has_one_slope_and_one_aspect() {
        let grid = Grid::new(Shape::new(30, 40), [10.0, 10.0]).unwrap();
        let tangent = math::tan(33.0_f64.to_radians());
        let z: Vec<f64> = (0..grid.len()).map(|i| -tangent * grid.position(i)[0]).collect();
        let s = surface(&grid, &z).unwrap();
        assert!((s.slope_mean - 33.0).abs() < 1e-9 && (s.slope_max - 33.0).abs() < 1e-9);
        assert_eq!((s.talus_share, s.level_share, s.nodes, s.aspect_rose[2]), (1.0, 0.0, 28 * 38, 1.0));
        assert!((s.local_relief / (tangent * 100.0) - 1.0).abs() < 0.1);
        assert!(surface(&grid, &vec![f64::NAN; 1200]).is_none());
    }

    #[test]
    fn turning_by_a_right_angle_turns_the_rose_only() {
        let n = 64;
        let grid = Grid::new(Shape::new(n, n), [10.0, 10.0]).unwrap();
        let z = crate::algo::noise::self_affine(grid.shape, grid.spacing, 0.7, crate::random::Seed(1));
        let turned: Vec<f64> = (0..n * n).map(|i| z[(i % n) * n + n - 1 - i / n]).collect();
        let (a, b) = (surface(&grid, &z).unwrap(), surface(&grid, &turned).unwrap());
        assert!((a.slope_mean - b.slope_mean).abs() < 1e-9 && (a.slope_p99 - b.slope_p99).abs() < 1e-9);
        assert!(
            (a.profile_curvature / b.profile_curvature - 1.0).abs() < 1e-9
                && (a.spur_share - b.spur_share).abs() < 1e-9
        );
        // What faced east (2) faces north (0).
        assert!((0..8).all(|k| (a.aspect_rose[(k + 2) % 8] - b.aspect_rose[k]).abs() < 1e-9));
    }
}
