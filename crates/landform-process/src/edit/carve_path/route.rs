//! The way of least cost over a raster.
//!
//! # Method
//! A* over a lattice of the raster's nodes, every so many of them that it stays small, in states of
//! place and direction, so that bends cost too: without that, a way up a slope would go to and fro
//! from cell to cell, and straight up once it is smoothed.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use landform_core::grid::Grid;
use landform_core::math::hypot;
use landform_core::units::place_text;
use landform_core::{Error, Result};

use super::Dry;

/// Steps of at most so many places along an axis, in all directions that no shorter step has.
const REACH: i64 = 4;
/// Places along the longer side of the lattice.
const PLACES: i64 = 128;
/// What a metre over water costs more.
const BRIDGE: f64 = 12.0;
/// The most that a metre costs for being steep.
const STEEPEST: f64 = 60.0;
/// What a hairpin bend costs, in widths of the strip.
const HAIRPIN: f64 = 12.0;

/// The least-cost line through places: positions, m. `half` is half the width of the strip.
///
/// # Errors
/// [`Error::Parameter`] if there is no ground between two of them.
pub(super) fn find(grid: &Grid, ground: &Dry, places: &[[f64; 2]], steepest: f64, half: f64) -> Result<Vec<[f64; 2]>> {
    let mut line = vec![places[0]];
    for leg in places.windows(2) {
        let search = Search::between(grid, ground, [leg[0], leg[1]], steepest, 2.0 * half);
        let way = search.and_then(Search::run).ok_or_else(|| {
            let found = format!("{} and {}, with no ground between them", place_text(leg[0]), place_text(leg[1]));
            Error::parameter("points", found, "places that are joined by ground")
        })?;
        let inner = way.len().saturating_sub(2);
        line.extend(way.into_iter().skip(1).take(inner));
        line.push(leg[1]);
    }
    line.dedup();
    Ok(line)
}

/// A step on the lattice.
struct Stride {
    /// Rows and columns.
    by: [i64; 2],
    /// Length, m.
    length: f64,
    /// Direction, of length 1.
    ahead: [f64; 2],
}

/// A search from place to place, in a part of the raster.
struct Search<'a> {
    grid: &'a Grid,
    ground: &'a Dry,
    steepest: f64,
    /// Nodes from place to place of the lattice.
    every: i64,
    /// First row and column, and numbers of rows and columns of the lattice.
    first: [i64; 2],
    size: [i64; 2],
    from: [i64; 2],
    to: [i64; 2],
    strides: Vec<Stride>,
    /// What a hairpin bend costs, m.
    hairpin: f64,
}

impl<'a> Search<'a> {
    /// A search in the rectangle around both places, half as large again on every side.
    fn between(grid: &'a Grid, ground: &'a Dry, ends: [[f64; 2]; 2], steepest: f64, width: f64) -> Option<Self> {
        let shape = grid.shape;
        let cells = [shape.cell(grid.node_at(ends[0])?), shape.cell(grid.node_at(ends[1])?)];
        let [from, to] = cells.map(|c| [c.row as i64, c.col as i64]);
        let longer = (0..2).map(|k| (from[k] - to[k]).abs()).max()?;
        let every = (2 * longer / PLACES).max(1);
        let margin = longer / 2 + 20;
        // The lattice has the start among its places.
        let most = [shape.rows as i64 - 1, shape.cols as i64 - 1];
        let before = [0, 1].map(|k| (from[k] - (from[k].min(to[k]) - margin).max(0)) / every);
        let first = [0, 1].map(|k| from[k] - before[k] * every);
        let size = [0, 1].map(|k| ((from[k].max(to[k]) + margin).min(most[k]) - first[k]) / every + 1);
        let on = |at: [i64; 2]| [0, 1].map(|k| ((2 * (at[k] - first[k]) + every) / (2 * every)).clamp(0, size[k] - 1));
        let [dx, dy] = grid.spacing.map(|s| s * every as f64);
        let all = (-REACH..=REACH).flat_map(|r| (-REACH..=REACH).map(move |c| [r, c]));
        let stride = |by: [i64; 2]| {
            let (east, south) = (by[1] as f64 * dx, by[0] as f64 * dy);
            let length = hypot(east, south);
            Stride { by, length, ahead: [east / length, south / length] }
        };
        let strides = all.filter(|&[r, c]| common_divisor(r.abs(), c.abs()) == 1).map(stride).collect();
        let hairpin = HAIRPIN * width.max(dx.max(dy));
        Some(Self { grid, ground, steepest, every, first, size, from: on(from), to: on(to), strides, hairpin })
    }

    /// The raster's node at a place of the lattice and parts of the way to others.
    fn node(&self, at: [i64; 2], by: [i64; 2], part: i64, of: i64) -> usize {
        let along = |k: usize| {
            let way = by[k] * self.every * part;
            self.first[k] + at[k] * self.every + (2 * way + way.signum() * of) / (2 * of)
        };
        self.grid.shape.index(along(0) as usize, along(1) as usize)
    }

    fn place(&self, at: [i64; 2]) -> Option<usize> {
        let is_in = (0..2).all(|k| (0..self.size[k]).contains(&at[k]));
        is_in.then(|| (at[0] * self.size[1] + at[1]) as usize)
    }

    /// What a step costs, m; none where there is no ground.
    fn cost(&self, at: [i64; 2], stride: &Stride) -> Option<f64> {
        let parts = stride.by[0].abs().max(stride.by[1].abs()) * self.every.min(3);
        let level = |part: i64| self.ground.level[self.node(at, stride.by, part, parts)];
        let (start, end) = (level(0), level(parts));
        let (mut wet, mut off) = (0, 0.0_f64);
        for part in 1..=parts {
            let node = self.node(at, stride.by, part, parts);
            let z = self.ground.level[node];
            if z.is_nan() {
                return None;
            }
            wet += i64::from(self.ground.wet[node]);
            off = off.max((z - start - (end - start) * part as f64 / parts as f64).abs());
        }
        // What stands out of the way must be cut or filled.
        let q = ((end - start).abs() + off) / (stride.length * self.steepest);
        let steep = if q <= 1.0 { 0.5 * q * q } else { (0.5 + 10.0 * (q - 1.0)).min(STEEPEST) };
        Some(stride.length * (1.0 + steep + BRIDGE * wet as f64 / parts as f64))
    }

    /// The straight way that is left, m: no way costs less.
    fn least(&self, at: [i64; 2]) -> f64 {
        let away = |k: usize, spacing: f64| ((at[k] - self.to[k]) * self.every) as f64 * spacing;
        hypot(away(1, self.grid.spacing[0]), away(0, self.grid.spacing[1]))
    }

    /// A* (Hart, Nilsson & Raphael 1968) over places and the direction in which they are reached;
    /// ties go to the lower index.
    fn run(self) -> Option<Vec<[f64; 2]>> {
        let ways = self.strides.len();
        let count = (self.size[0] * self.size[1]) as usize * ways;
        let (mut cost, mut from) = (vec![f64::INFINITY; count], vec![u32::MAX; count]);
        let mut done = vec![false; count];
        // A step costs the same in whatever direction its place was reached: NaN until it is known.
        let mut steps = vec![f64::NAN; count];
        let (start, goal) = (self.place(self.from)?, self.place(self.to)?);
        if start == goal {
            return Some(vec![self.position(start), self.position(goal)]);
        }
        let mut heap = BinaryHeap::new();
        // From the start every direction is as good.
        for way in 0..ways {
            cost[start * ways + way] = 0.0;
            heap.push(Reverse((self.least(self.from).to_bits(), start * ways + way)));
        }
        while let Some(Reverse((_, state))) = heap.pop() {
            let (place, way) = (state / ways, state % ways);
            if place == goal {
                return Some(self.way(&from, state));
            }
            if std::mem::replace(&mut done[state], true) {
                continue;
            }
            let at = [place as i64 / self.size[1], place as i64 % self.size[1]];
            for (new, stride) in self.strides.iter().enumerate() {
                let to = [at[0] + stride.by[0], at[1] + stride.by[1]];
                let Some(next) = self.place(to).map(|p| p * ways + new).filter(|&next| !done[next]) else { continue };
                let before = self.strides[way].ahead;
                let bend = 0.5 * (1.0 - before[0] * stride.ahead[0] - before[1] * stride.ahead[1]);
                let bend = if place == start { 0.0 } else { self.hairpin * bend.max(0.0) };
                if cost[state] + bend + stride.length >= cost[next] {
                    continue;
                }
                let step = &mut steps[place * ways + new];
                if step.is_nan() {
                    *step = self.cost(at, stride).unwrap_or(f64::INFINITY);
                }
                let all = cost[state] + bend + *step;
                if all < cost[next] {
                    (cost[next], from[next]) = (all, state as u32);
                    // Costs are not negative, so that their bits are in their order.
                    heap.push(Reverse(((all + self.least(to)).to_bits(), next)));
                }
            }
        }
        None
    }

    fn position(&self, place: usize) -> [f64; 2] {
        let at = [place as i64 / self.size[1], place as i64 % self.size[1]];
        let [row, col] = [0, 1].map(|k| (self.first[k] + at[k] * self.every) as usize);
        [self.grid.x(col), self.grid.y(row)]
    }

    fn way(&self, from: &[u32], last: usize) -> Vec<[f64; 2]> {
        let before = |state: &usize| from.get(*state).filter(|f| **f != u32::MAX).map(|f| *f as usize);
        let states = std::iter::successors(Some(last), before);
        let mut way: Vec<_> = states.map(|state| self.position(state / self.strides.len())).collect();
        way.reverse();
        way
    }
}

fn common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}
