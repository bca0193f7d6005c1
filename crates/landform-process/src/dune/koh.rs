//! Koh's automaton (2002), section 5.2.
//!
//! Wind enters at full strength and is swept downwind: the mean of the three places upwind, less a
//! part of the height by which the next place to windward stands above. (The thesis' "next cell in
//! the wind direction" is read as it reads "the three neighbouring cells in the wind direction" a
//! sentence before: towards the wind. If the rise ahead slows the wind instead, sand never comes to
//! rest in a lee.) Its strength is the probability that a slab moves, to the lowest of the three
//! places downwind. All cells move at once.
//!
//! A slab stays where its cell stands too steeply above one of the three places to windward. This
//! rule, the thesis' own, is what ends the growth of dunes: if the rise ahead holds the slab
//! instead, dunes grow for ever.
//!
//! The places are one step away and lie across the wind, whatever its direction; heights and winds
//! there are linear between cells, and a slab lands on one of the cells around its place at random,
//! so that no direction of the lattice is preferred. For winds along the axes they are the three
//! cells of the thesis. Two rules are added to the thesis: slabs slip at the angle of repose, and
//! slowed wind recovers over a distance; without the second the first dune would shield all others.

use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::verb::Rose;
use landform_core::{math, parallel};

use super::field::Field;
use super::params::Dunes;

/// Weights below this are rounding.
const NO_WEIGHT: f64 = 1e-9;

/// A place beside a cell: columns east, rows south and weights of the cells that it lies between.
type Place = Vec<(i64, i64, f64)>;

/// How a wind crosses a raster.
pub(super) struct Air {
    shape: Shape,
    torus: bool,
    /// A step downwind, in columns east and rows south.
    ahead: [f64; 2],
    /// The same across the wind.
    aside: [f64; 2],
    /// Length of a step downwind, m.
    pub(super) length: f64,
}

impl Air {
    /// A wind that blows along `towards` (x east, y north). A step is about one cell.
    pub(super) fn new(grid: &Grid, torus: bool, towards: [f64; 2]) -> Self {
        let [dx, dy] = grid.spacing;
        let step = |[x, y]: [f64; 2]| {
            let cells = [x / dx, -y / dy];
            let many = math::hypot(cells[0], cells[1]);
            (cells.map(|c| c / many), 1.0 / many)
        };
        let ((ahead, length), (aside, _)) = (step(towards), step([-towards[1], towards[0]]));
        Self { shape: grid.shape, torus, ahead, aside, length }
    }

    /// The point this many steps downwind and to the side of a cell.
    fn point(&self, along: f64, across: f64) -> [f64; 2] {
        [0, 1].map(|k| along * self.ahead[k] + across * self.aside[k])
    }

    /// The three points one step along, the middle one first.
    fn three(&self, along: f64) -> [Place; 3] {
        [0.0, -1.0, 1.0].map(|across| between(self.point(along, across)))
    }

    /// Cells that come before any cell in the sweep, with their parts of the mean of the three
    /// places upwind of it.
    fn upwind(&self) -> Place {
        let mut mean: Place = Vec::new();
        for (c, r, weight) in self.three(-1.0).into_iter().flatten().filter(|&(c, r, _)| self.is_before(c, r)) {
            match mean.iter_mut().find(|m| (m.0, m.1) == (c, r)) {
                Some(known) => known.2 += weight,
                None => mean.push((c, r, weight)),
            }
        }
        let total: f64 = mean.iter().map(|m| m.2).sum();
        mean.iter_mut().for_each(|m| m.2 /= total);
        mean
    }

    /// Whether lines are columns (else rows): those that the wind crosses more squarely.
    fn crosses_cols(&self) -> bool {
        self.ahead[0].abs() >= self.ahead[1].abs()
    }

    /// Whether the cell so many columns east and rows south of another is swept before it.
    fn is_before(&self, cols: i64, rows: i64) -> bool {
        let along = |by: i64, ahead: f64| if ahead < 0.0 { -by } else { by };
        let (c, r) = (along(cols, self.ahead[0]), along(rows, self.ahead[1]));
        if self.crosses_cols() { (c, r) < (0, 0) } else { (r, c) < (0, 0) }
    }

    /// Row and column of the cell at a place of the sweep.
    fn cell(&self, k: usize) -> (usize, usize) {
        let Shape { rows, cols } = self.shape;
        let (r, c) = if self.crosses_cols() { (k % rows, k / rows) } else { (k / cols, k % cols) };
        let turned = |at: usize, n: usize, ahead: f64| if ahead < 0.0 { n - 1 - at } else { at };
        (turned(r, rows, self.ahead[1]), turned(c, cols, self.ahead[0]))
    }

    /// The cell so many columns east and rows south of one; none off a side that does not wrap.
    #[inline]
    fn moved(&self, (row, col): (usize, usize), cols: i64, rows: i64, wraps: [bool; 2]) -> Option<usize> {
        let go = |at: usize, by: i64, n: usize, wraps: bool| {
            let to = at as i64 + by;
            if (0..n as i64).contains(&to) {
                Some(to as usize)
            } else {
                wraps.then(|| to.rem_euclid(n as i64) as usize)
            }
        };
        let (c, r) = (go(col, cols, self.shape.cols, wraps[0])?, go(row, rows, self.shape.rows, wraps[1])?);
        Some(self.shape.index(r, c))
    }

    /// A value at a place beside a cell; none where the map does not reach.
    fn value(&self, at: (usize, usize), place: &Place, of: impl Fn(usize) -> f64) -> Option<f64> {
        let (mut sum, mut total) = (0.0, 0.0);
        for &(c, r, weight) in place {
            if let Some(cell) = self.moved(at, c, r, [self.torus; 2]) {
                sum += weight * of(cell);
                total += weight;
            }
        }
        (total > NO_WEIGHT).then(|| sum / total)
    }
}

/// The cells around a point and its parts in them.
fn between(point: [f64; 2]) -> Place {
    let [(c, p), (r, q)] = point.map(|v| (v.floor() as i64, v - v.floor()));
    [(0, 0, (1.0 - p) * (1.0 - q)), (1, 0, p * (1.0 - q)), (0, 1, (1.0 - p) * q), (1, 1, p * q)]
        .into_iter()
        .filter(|part| part.2 > NO_WEIGHT)
        .map(|(dc, dr, weight)| (c + dc, r + dr, weight))
        .collect()
}

/// The strength of a wind over a surface (in m), into `out`.
pub(super) fn wind_over(air: &Air, height: impl Fn(usize) -> f64, loss: f64, recovery: f64, out: &mut [f32]) {
    // Wind that recovers does not depend on where it began, so it may cross the seam of a torus
    // without a trace. Any other begins anew there.
    let recovers = recovery > 0.0;
    let passes = if air.torus && recovers { 2 } else { 1 };
    let wraps = air.ahead.map(|a| air.torus && (recovers || a == 0.0));
    let (upwind, windward) = (air.upwind(), between(air.point(-1.0, 0.0)));
    out.fill(1.0);
    for k in 0..passes * out.len() {
        let at = air.cell(k % out.len());
        let node = air.shape.index(at.0, at.1);
        let strength = |c: i64, r: i64| air.moved(at, c, r, wraps).map_or(1.0, |n| f64::from(out[n]));
        let mut wind: f64 = upwind.iter().map(|&(c, r, weight)| weight * strength(c, r)).sum();
        wind += (1.0 - wind) * recovery;
        let shielding = air.value(at, &windward, &height).map_or(0.0, |h| h - height(node));
        // Nodata neither slows nor stops the wind.
        let shielding = if shielding.is_nan() { 0.0 } else { shielding.max(0.0) };
        out[node] = (wind - loss * shielding / air.length).clamp(0.0, 1.0) as f32;
    }
}

/// A round.
#[expect(clippy::too_many_arguments, reason = "one call, from the step")]
pub(super) fn round(
    params: &Dunes,
    grid: &Grid,
    field: &mut Field,
    strength: &mut Vec<f32>,
    rose: &Rose,
    wind: usize,
    part: f64,
    seed: Seed,
) {
    let air = Air::new(grid, field.is_torus(), rose.winds()[wind].towards());
    let surface = field.sand.surface();
    let recovery = 1.0 - math::exp(-air.length / params.wind_recovery());
    strength.resize(grid.len(), 0.0);
    wind_over(&air, |i| f64::from(surface[i]) * field.unit, params.wind_loss(), recovery, strength);
    let climb = f64::from(field.fall(params.steepest_climb(), air.length));
    let (up, down) = (air.three(-1.0), air.three(1.0));
    let height = |i: usize| f64::from(surface[i]);
    let (shape, known): (_, &Field) = (grid.shape, field);
    // Where the slab of each cell goes, for all at once.
    let moves: Vec<Vec<(u32, Option<u32>)>> = parallel::map(shape.rows, |row| {
        let mut moves = Vec::new();
        for node in shape.index(row, 0)..shape.index(row, 0) + shape.cols {
            let force = f64::from(strength[node]);
            if known.sand.depth(node) <= 0
                || force <= params.threshold()
                || seed.uniform(node as u64) >= force * part
                || is_held(&air, (row, node - shape.index(row, 0)), &up, height, climb)
            {
                continue;
            }
            let chance = [1, 2].map(|k| seed.with(k).uniform(node as u64));
            let to = landing(&air, known, node, &down, chance);
            if to != Some(node) {
                moves.push((node as u32, to.map(|to| to as u32)));
            }
        }
        moves
    });
    let slab = field.sand.slab();
    for &(from, to) in moves.iter().flatten() {
        let taken = field.sand.lift(from as usize, slab);
        match to {
            None => field.left += i64::from(taken),
            Some(to) => field.sand.lay(to as usize, taken),
        }
    }
    field.sand.settle();
}

/// Whether a cell stands more than `climb` above one of the places upwind.
fn is_held(air: &Air, at: (usize, usize), up: &[Place; 3], height: impl Fn(usize) -> f64, climb: f64) -> bool {
    let own = height(air.shape.index(at.0, at.1));
    up.iter().filter_map(|place| air.value(at, place, &height)).any(|h| own - h > climb)
}

/// The cell where a slab lands: at the lowest of the three places downwind, the middle one of
/// equals; none off the field.
fn landing(air: &Air, field: &Field, node: usize, down: &[Place; 3], chance: [f64; 2]) -> Option<usize> {
    let cell = air.shape.cell(node);
    let height = |i: usize| f64::from(field.sand.surface()[i]);
    let mut lowest = (f64::INFINITY, 0.0);
    for (place, across) in down.iter().zip([0.0, -1.0, 1.0]) {
        if let Some(h) = air.value((cell.row, cell.col), place, height).filter(|h| *h < lowest.0 - NO_WEIGHT) {
            lowest = (h, across);
        }
    }
    let point = air.point(1.0, lowest.1);
    let whole = [0, 1].map(|k| {
        let (near, low) = (point[k].round(), point[k].floor());
        match (point[k] - near).abs() < NO_WEIGHT {
            true => near as i64,
            false => low as i64 + i64::from(chance[k] < point[k] - low),
        }
    });
    field.hop((cell.row, cell.col), whole[0], whole[1])
}
