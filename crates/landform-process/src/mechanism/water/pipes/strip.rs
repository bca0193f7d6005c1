//! A step for some rows, from the first to the last: the values that a row needs of its neighbours
//! are kept in a moving window.

use std::ops::Range;

use super::face::{Kind, Line, greater};

/// What a step reads.
pub(super) struct Before<'a> {
    pub(super) rows: usize,
    pub(super) cols: usize,
    pub(super) ground: &'a [f64],
    pub(super) water: &'a [f64],
    /// Depth that comes in a second, m/s.
    pub(super) supply: &'a [f64],
    /// Depth that dries in the step, m.
    pub(super) dries: f64,
    pub(super) dt: f64,
    pub(super) area: f64,
    pub(super) east: &'a [f64],
    pub(super) south: &'a [f64],
    pub(super) eastward: Kind,
    pub(super) southward: Kind,
    /// A row of zeros: what lies beyond the map.
    pub(super) nothing: &'a [f64],
}

impl<'a> Before<'a> {
    /// A row of a field, or nothing beyond the map; counted from one before the first.
    fn row(&self, field: &'a [f64], row_and_one: usize) -> &'a [f64] {
        if (1..=self.rows).contains(&row_and_one) {
            &field[(row_and_one - 1) * self.cols..row_and_one * self.cols]
        } else {
            self.nothing
        }
    }
}

/// What a step writes: its speeds and water, and the sums of what crossed.
pub(super) struct After<'a> {
    pub(super) east: &'a mut [f64],
    pub(super) south: &'a mut [f64],
    pub(super) water: &'a mut [f64],
    pub(super) crossed_east: &'a mut [f64],
    pub(super) crossed_south: &'a mut [f64],
}

/// The window around row r. Rows may be padded, so that every node has neighbours.
struct Window {
    /// Water after the supply in rows r - 1 to r + 2: one column before the row, two after it.
    water: [Vec<f64>; 4],
    /// Speeds in row r.
    speed: [Vec<f64>; 2],
    /// Volumes to the east in rows r - 1 and r; one column before the row.
    east: [Vec<f64>; 2],
    /// Volumes to the south in rows r - 1 and r.
    south: [Vec<f64>; 2],
    /// Fractions of their outflow that columns hold, in rows r - 1 and r; one column after the row.
    gives: [Vec<f64>; 2],
    /// What really crosses to the east in row r - 1; one column before the row.
    real_east: Vec<f64>,
    /// What really crosses to the south in rows r - 2 and r - 1.
    real_south: [Vec<f64>; 2],
}

/// Moves the water of the rows from `first` on; returns the greatest speed.
pub(super) fn step(before: &Before<'_>, first: usize, after: &mut After<'_>) -> f64 {
    let cols = before.cols;
    let last = first + after.water.len() / cols;
    // The two rows before and the one after give the flow across the strip's sides.
    let begin = first.saturating_sub(2);
    let mut window = Window::new(before, begin);
    let mut fastest: f64 = 0.0;
    for row in begin..=last {
        window.advance(before, row);
        fastest = greater(fastest, window.accelerate(before, row));
        window.share_out(before);
        window.cross(cols);
        if (first..last).contains(&row) {
            let at = (row - first) * cols..(row - first + 1) * cols;
            after.east[at.clone()].copy_from_slice(&window.speed[0][..cols]);
            after.south[at].copy_from_slice(&window.speed[1][..cols]);
        }
        if row > first {
            window.carry((row - 1 - first) * cols..(row - first) * cols, 1.0 / before.area, after);
        }
    }
    fastest
}

impl Window {
    /// The window before row `begin`.
    fn new(before: &Before<'_>, begin: usize) -> Self {
        let row = || vec![0.0; before.cols + 3];
        let pair = || [row(), row()];
        let mut window = Self {
            water: [row(), row(), row(), row()],
            speed: pair(),
            east: pair(),
            south: pair(),
            gives: pair(),
            real_east: row(),
            real_south: pair(),
        };
        for (k, water) in window.water[1..].iter_mut().enumerate() {
            fill(before, begin + k, water);
        }
        window
    }

    fn advance(&mut self, before: &Before<'_>, row: usize) {
        self.water.rotate_left(1);
        self.east.rotate_left(1);
        self.south.rotate_left(1);
        self.gives.rotate_left(1);
        self.real_south.rotate_left(1);
        fill(before, row + 3, &mut self.water[3]);
    }

    /// Speeds in the pipes of a row and the volumes they would carry.
    fn accelerate<'a>(&mut self, before: &Before<'a>, row: usize) -> f64 {
        let cols = before.cols;
        let [eastward, southward] = &mut self.speed;
        let (east, south) = (&mut self.east[1], &mut self.south[1]);
        if row >= before.rows {
            east.fill(0.0);
            south.fill(0.0);
            return 0.0;
        }
        let ground = before.row(before.ground, row + 1);
        let speed = before.row(before.east, row + 1);
        let (south_above, south_here) = (before.row(before.south, row), before.row(before.south, row + 1));
        let water = &self.water[1];
        let pipes = cols - 1;
        let mut fastest: f64 = 0.0;
        for part in [0..pipes.min(1), 1..pipes.max(1)].into_iter().filter(|part| !part.is_empty()) {
            let (a, b) = (part.start, part.end);
            let line = Line {
                ground: [&ground[a..b], &ground[a + 1..b + 1]],
                water: [&water[a + 1..b + 1], &water[a + 2..b + 2]],
                speed: &speed[a..b],
                speed_beyond: [if a == 0 { &before.nothing[..b] } else { &speed[a - 1..b - 1] }, &speed[a + 1..b + 1]],
                water_beyond: [&water[a..b], &water[a + 3..b + 3]],
                speed_across: [
                    &south_above[a..b],
                    &south_above[a + 1..b + 1],
                    &south_here[a..b],
                    &south_here[a + 1..b + 1],
                ],
            };
            fastest = greater(fastest, before.eastward.flow(&line, &mut eastward[a..b], &mut east[a + 1..b + 1]));
        }
        if row + 1 == before.rows {
            southward.fill(0.0);
            south.fill(0.0);
            return fastest;
        }
        let [w0, w1, w2, w3] = self.water.each_ref().map(|w| &w[1..=cols]);
        let (below, next) = (before.row(before.ground, row + 2), before.row(before.east, row + 2));
        let speeds = [0, 1, 2].map(|k| before.row(before.south, row + k));
        for (a, b) in [(0, 1), (1, cols)].into_iter().filter(|(a, b)| a < b) {
            let cut = |row: &'a [f64]| &row[a..b];
            let west = |row: &'a [f64]| if a == 0 { &before.nothing[..b] } else { &row[a - 1..b - 1] };
            let line = Line {
                ground: [cut(ground), cut(below)],
                water: [&w1[a..b], &w2[a..b]],
                speed: cut(speeds[1]),
                speed_beyond: [cut(speeds[0]), cut(speeds[2])],
                water_beyond: [&w0[a..b], &w3[a..b]],
                speed_across: [west(speed), cut(speed), west(next), cut(next)],
            };
            fastest = greater(fastest, before.southward.flow(&line, &mut southward[a..b], &mut south[a..b]));
        }
        fastest
    }

    /// The part of their outflow that the columns of row r have.
    fn share_out(&mut self, before: &Before<'_>) {
        let n = before.cols;
        let (west, east) = (&self.east[1][..n], &self.east[1][1..=n]);
        let (north, south) = (&self.south[0][..n], &self.south[1][..n]);
        let (water, gives) = (&self.water[1][1..=n], &mut self.gives[1][..n]);
        for i in 0..n {
            let along = greater(east[i], 0.0) - lesser(west[i], 0.0);
            let out = along + greater(south[i], 0.0) - lesser(north[i], 0.0);
            let has = water[i] * before.area;
            gives[i] = if out > has { has / out } else { 1.0 };
        }
    }

    /// What really crosses from row r - 1.
    fn cross(&mut self, n: usize) {
        let [above, here] = self.gives.each_ref();
        let (mine, to_east, to_south) = (&above[..n], &above[1..=n], &here[..n]);
        let (east, south) = (&self.east[0][1..=n], &self.south[0][..n]);
        let (real_east, real_south) = (&mut self.real_east[1..=n], &mut self.real_south[1][..n]);
        for i in 0..n {
            real_east[i] = east[i] * if east[i] > 0.0 { mine[i] } else { to_east[i] };
            real_south[i] = south[i] * if south[i] > 0.0 { mine[i] } else { to_south[i] };
        }
    }

    /// Moves the water of row r - 1, which is `at` in the strip.
    fn carry(&self, at: Range<usize>, per_area: f64, after: &mut After<'_>) {
        let n = at.len();
        let (west, east) = (&self.real_east[..n], &self.real_east[1..=n]);
        let [north, south] = self.real_south.each_ref().map(|row| &row[..n]);
        let old = &self.water[0][1..=n];
        let water = &mut after.water[at.clone()];
        let (crossed_east, crossed_south) = (&mut after.crossed_east[at.clone()], &mut after.crossed_south[at]);
        for i in 0..n {
            water[i] = greater(old[i] + (west[i] + north[i] - east[i] - south[i]) * per_area, 0.0);
            crossed_east[i] += east[i];
            crossed_south[i] += south[i];
        }
    }
}

/// Water of a row (counted from one before the first) after the supply.
fn fill(before: &Before<'_>, row_and_one: usize, out: &mut [f64]) {
    let n = before.cols;
    let (water, supply) = (before.row(before.water, row_and_one), before.row(before.supply, row_and_one));
    let (out, water, supply) = (&mut out[1..=n], &water[..n], &supply[..n]);
    for i in 0..n {
        out[i] = greater(water[i] + supply[i] * before.dt - before.dries, 0.0);
    }
}

fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
