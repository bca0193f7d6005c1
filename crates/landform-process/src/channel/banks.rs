//! The banks of rivers: a river erodes them, and its water stands over them.
//!
//! # Model
//! A node with flow f gives part of it to nodes uphill of it within R = R_max f^b, less with
//! distance (f_a of Eq. 4.5). The part is chosen so that a straight river adds f to its own line
//! for any size of cells. Nodes beside a river whose ground lies under the river's surface are
//! under water.
//!
//! # Sources
//! Pytel (2015), 4.3.1: R = f_c R_max there; with the exponent b of 0.4 to 0.5 widths grow as those
//! of rivers do.

use landform_core::grid::Grid;
use landform_core::{math, parallel};

/// Flow below this part of the whole has no banks, for any radius.
const LEAST: f64 = 1e-4;
/// Rows that are done together.
const BAND: usize = 32;

/// A node beside rivers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bank {
    /// Flow that rivers nearby add to it (f_a).
    pub(super) lateral_flow: f64,
    /// Surface of the river that it is nearest to, in radii, m.
    pub(super) stage: f64,
    /// Depth of that river, m.
    pub(super) depth: f64,
    nearness: f64,
}

const NOWHERE: Bank = Bank { lateral_flow: 0.0, stage: f64::NEG_INFINITY, depth: 0.0, nearness: f64::INFINITY };

/// How wide and deep rivers are.
#[derive(Clone, Copy, Debug)]
pub(super) struct River {
    pub(super) radius: f64,
    pub(super) exponent: f64,
    pub(super) depth: f64,
}

impl River {
    /// Half the width of a river, m.
    pub(super) fn half_width(&self, flow: f64) -> f64 {
        self.radius * math::pow(flow, self.exponent)
    }

    /// Depth of a river, m.
    pub(super) fn depth(&self, flow: f64) -> f64 {
        self.depth * flow.sqrt()
    }
}

/// Writes every node's bank. Nodes in `still` add nothing: they lie under standing water.
pub(super) fn banks(grid: &Grid, ground: &[f64], flow: &[f64], still: &[f64], river: &River, out: &mut Vec<Bank>) {
    let (shape, [dx, dy]) = (grid.shape, grid.spacing);
    let cell = dx.min(dy);
    let sources: Vec<(u32, f64)> = parallel::map_pieces(flow.len(), |range| {
        let of = |i: usize| (i as u32, river.half_width(flow[i]));
        let is_source = |i: &usize| flow[*i] > LEAST && still[*i] <= river.depth(flow[*i]);
        range.filter(is_source).map(of).filter(|s| s.1 >= cell).collect::<Vec<_>>()
    })
    .concat();
    let reach = sources.iter().fold(0.0, |a: f64, s| a.max(s.1));
    let rows_of = |metres: f64| (metres / dy) as usize;
    out.clear();
    out.resize(flow.len(), NOWHERE);
    parallel::for_rows_mut(out, BAND * shape.cols, |band, out| {
        let (first, last) = (band * BAND, band * BAND + out.len() / shape.cols);
        let (above, below) = (first.saturating_sub(rows_of(reach) + 1), last + rows_of(reach) + 1);
        let from = sources.partition_point(|s| (s.0 as usize) < above * shape.cols);
        let to = sources.partition_point(|s| (s.0 as usize) < below.saturating_mul(shape.cols));
        for &(node, radius) in &sources[from..to] {
            let at = shape.cell(node as usize);
            let z = ground[node as usize];
            let (f, rows) = (flow[node as usize], rows_of(radius));
            let depth = river.depth(f);
            // A line of such nodes adds to a node on it the sum of (1 - d/R) dx/R over 2 R: f.
            let part = f * cell / radius;
            for row in at.row.saturating_sub(rows).max(first)..(at.row + rows + 1).min(last) {
                let y = (row as f64 - at.row as f64) * dy;
                let half = ((radius * radius - y * y).max(0.0).sqrt() / dx) as usize;
                for col in at.col.saturating_sub(half)..(at.col + half + 1).min(shape.cols) {
                    let x = (col as f64 - at.col as f64) * dx;
                    let nearness = (x * x + y * y).sqrt() / radius;
                    let bank = &mut out[(row - first) * shape.cols + col];
                    if ground[shape.index(row, col)] > z {
                        bank.lateral_flow += part * (1.0 - nearness);
                    }
                    if nearness < bank.nearness {
                        *bank = Bank { nearness, stage: z + depth, depth, ..*bank };
                    }
                }
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use landform_core::grid::Shape;

    use super::*;

    #[test]
    fn a_straight_river_lends_its_flow_whatever_the_cells() {
        for (n, dx) in [(41, 20.0), (161, 5.0)] {
            let grid = Grid::new(Shape::new(n, n), [dx; 2]).unwrap();
            let middle = n / 2;
            let mut flow = vec![0.0; n * n];
            let ground: Vec<f64> = (0..n * n).map(|i| ((i % n) as f64 - middle as f64).abs() * 1e-3 * dx).collect();
            (0..n).for_each(|r| flow[r * n + middle] = 0.25);
            let river = River { radius: 200.0, exponent: 0.5, depth: 2.0 };
            let mut out = Vec::new();
            banks(&grid, &ground, &flow, &vec![0.0; n * n], &river, &mut out);
            // Beside the river, nearly on it.
            let near = out[(n / 2) * n + middle + 1];
            assert!((near.lateral_flow / 0.25 - 1.0).abs() < 0.35, "{}", near.lateral_flow);
            assert_eq!(out[(n / 2) * n + middle + (110.0 / dx) as usize].lateral_flow, 0.0);
            assert_eq!(near.stage, 1.0);
        }
    }
}
