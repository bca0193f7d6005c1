//! Lines of equal elevation.
//!
//! # Method
//! Marching squares with linear crossings. A node is high if it lies at the level or above; lines
//! run with the high ground on their left, so that islands run counter-clockwise and depressions
//! clockwise. At every saddle the high corners are separated (both ambiguous cases, as appendix B
//! of Pytel's thesis needs): land is joined by sides, the sea by corners too. Squares with nodata
//! hold no line.
//!
//! # Sources
//! Lorensen & Cline (1987) in two dimensions; Pytel's thesis, appendix B.
//!
//! # Example
//! One closed line runs around a peak:
//!
//! ```
//! use landform_core::algo::isoline::isolines;
//! use landform_core::grid::{Grid, Shape};
//!
//! let grid = Grid::new(Shape::new(3, 3), [1.0, 1.0])?;
//! let peak = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
//! let lines = isolines(&grid, &peak, 0.5);
//! assert!(lines.len() == 1 && lines[0].closed);
//! assert!((lines[0].area() - 0.5).abs() < 1e-12);
//! # Ok::<(), landform_core::Error>(())
//! ```

use crate::grid::Grid;

/// A line at one level.
#[derive(Clone, Debug, PartialEq)]
pub struct Isoline {
    /// Positions, m; the first is repeated at the end of a closed line.
    pub points: Vec<[f64; 2]>,
    /// Whether it closes on itself rather than end at the border or at nodata.
    pub closed: bool,
}

impl Isoline {
    /// Length, m.
    pub fn length(&self) -> f64 {
        let side = |a: [f64; 2], b: [f64; 2]| crate::math::hypot(b[0] - a[0], b[1] - a[1]);
        self.points.windows(2).map(|p| side(p[0], p[1])).sum()
    }

    /// Enclosed area, m²: positive around high ground, negative around low ground; 0 for an open
    /// line.
    pub fn area(&self) -> f64 {
        if !self.closed {
            return 0.0;
        }
        let [x0, y0] = self.points[0];
        let cross = |a: [f64; 2], b: [f64; 2]| (a[0] - x0) * (b[1] - y0) - (b[0] - x0) * (a[1] - y0);
        0.5 * self.points.windows(2).map(|p| cross(p[0], p[1])).sum::<f64>()
    }
}

/// All lines at `level`, open ones first, each kind in the order of its first crossing from the
/// north-west. **Cost** O(n + m log m) for m crossings.
pub fn isolines(grid: &Grid, z: &[f64], level: f64) -> Vec<Isoline> {
    let mut steps = steps(grid, z, level);
    steps.sort_unstable();
    let next = |edge: u64| steps.binary_search_by_key(&edge, |s| s.0).ok();
    let mut ends: Vec<u64> = steps.iter().map(|s| s.1).collect();
    ends.sort_unstable();
    let mut used = vec![false; steps.len()];
    let mut lines = Vec::new();
    let open_starts = (0..steps.len()).filter(|&k| ends.binary_search(&steps[k].0).is_err());
    for start in open_starts.chain(0..steps.len()).collect::<Vec<_>>() {
        if used[start] {
            continue;
        }
        let mut points = vec![crossing(grid, z, level, steps[start].0)];
        let mut at = Some(start);
        while let Some(k) = at.filter(|&k| !used[k]) {
            used[k] = true;
            points.push(crossing(grid, z, level, steps[k].1));
            at = next(steps[k].1);
        }
        let closed = at.is_some();
        lines.push(Isoline { points, closed });
    }
    lines
}

/// Edges of the raster: 2 i joins node i with its eastern neighbour, 2 i + 1 with its southern one.
fn steps(grid: &Grid, z: &[f64], level: f64) -> Vec<(u64, u64)> {
    let shape = grid.shape;
    let mut steps = Vec::new();
    for row in 0..shape.rows.saturating_sub(1) {
        for col in 0..shape.cols.saturating_sub(1) {
            let nw = shape.index(row, col);
            let [ne, sw, se] = [nw + 1, nw + shape.cols, nw + shape.cols + 1];
            // Counter-clockwise, each with the edge to the next corner.
            let corners = [sw, se, ne, nw];
            let high = corners.map(|i| z[i] >= level);
            if high[0] == high[1] && high[1] == high[2] && high[2] == high[3] {
                continue;
            }
            if corners.iter().any(|&i| z[i].is_nan()) {
                continue;
            }
            let edges = [2 * sw, 2 * ne + 1, 2 * nw, 2 * nw + 1].map(|e| e as u64);
            for k in 0..4 {
                // A line begins where the ground falls below the level and ends where it rose above
                // it last.
                if high[k] && !high[(k + 1) % 4] {
                    let before = (1..4).map(|d| (k + 4 - d) % 4).find(|&j| !high[j] && high[(j + 1) % 4]);
                    steps.extend(before.map(|j| (edges[k], edges[j])));
                }
            }
        }
    }
    steps
}

fn crossing(grid: &Grid, z: &[f64], level: f64, edge: u64) -> [f64; 2] {
    let i = (edge / 2) as usize;
    let j = if edge.is_multiple_of(2) { i + 1 } else { i + grid.shape.cols };
    let t = (level - z[i]) / (z[j] - z[i]);
    let (a, b) = (grid.position(i), grid.position(j));
    [crate::math::lerp(a[0], b[0], t), crate::math::lerp(a[1], b[1], t)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;
    use crate::random::Seed;

    #[test]
    fn a_cone_has_round_contours() {
        let grid = Grid::new(Shape::new(101, 101), [1.0, 1.0]).unwrap();
        let z: Vec<f64> = (0..grid.len())
            .map(|i| grid.position(i))
            .map(|[x, y]| 50.0 - crate::math::hypot(x - 50.0, y - 50.0))
            .collect();
        let lines = isolines(&grid, &z, 20.0);
        assert!(lines.len() == 1 && lines[0].closed);
        assert!((lines[0].length() / (60.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
        assert!((lines[0].area() / (900.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn areas_of_noise_are_those_of_its_complement() {
        let grid = Grid::new(Shape::new(40, 50), [2.0, 3.0]).unwrap();
        let rim = |i: usize| {
            let c = grid.shape.cell(i);
            c.row == 0 || c.col == 0 || c.row == 39 || c.col == 49
        };
        let z: Vec<f64> =
            (0..grid.len()).map(|i| if rim(i) { -1.0 } else { Seed(5).uniform(i as u64) - 0.5 }).collect();
        let lines = isolines(&grid, &z, 0.0);
        assert!(lines.len() > 50 && lines.iter().all(|l| l.closed && l.points.first() == l.points.last()));
        let low: Vec<f64> = z.iter().map(|v| -v).collect();
        let total = |lines: &[Isoline]| lines.iter().map(Isoline::length).sum::<f64>();
        assert!(lines.iter().map(Isoline::area).sum::<f64>() > 0.0);
        // The same crossings whichever side is called high; saddles are resolved by the high side,
        // so only about.
        let upside = isolines(&grid, &low, 0.0);
        assert!((total(&upside) / total(&lines) - 1.0).abs() < 0.05);
        // Every line is one line: no crossing is visited twice.
        let crossings: usize = lines.iter().map(|l| l.points.len() - 1).sum();
        assert_eq!(crossings, steps(&grid, &z, 0.0).len());
    }

    #[test]
    fn lines_end_at_the_border_and_at_nodata() {
        let grid = Grid::new(Shape::new(5, 9), [1.0, 1.0]).unwrap();
        let mut z: Vec<f64> = (0..45).map(|i| 2.5 - grid.shape.cell(i).row as f64).collect();
        assert_eq!(isolines(&grid, &z, 0.0).len(), 1);
        z[2 * 9 + 4] = f64::NAN;
        let lines = isolines(&grid, &z, 0.0);
        assert!(lines.len() == 2 && lines.iter().all(|l| !l.closed));
        assert_eq!(lines[0].points[0][1], 4.0 - 2.5);
    }
}
