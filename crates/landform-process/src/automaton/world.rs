//! The states of all cells, and what the words of formulas mean there.

use landform_core::grid::{Grid, Status};
use landform_core::random::Seed;
use landform_core::verb::{CellCall, Cells};

use super::around::Around;
use super::program::FARTHEST;
use super::words::{GROUND, Told};

/// The states of all cells at one time.
pub(super) struct World<'a> {
    pub(super) grid: &'a Grid,
    pub(super) around: &'a Around,
    /// Values of each state, `height` first.
    pub(super) states: &'a [Vec<f64>],
    /// Number of the step, from 0 in each effect.
    pub(super) step: u64,
    /// Seed of noise.
    pub(super) seed: Seed,
    /// Seed of the rule's random numbers in this step.
    pub(super) draws: Seed,
}

impl World<'_> {
    /// Writes what `tell` says of each cell of a row that is no hole.
    fn each(&self, row: usize, out: &mut [f64], tell: impl Fn(usize, usize) -> f64) {
        let first = row * self.grid.shape.cols;
        for (col, out) in out.iter_mut().enumerate() {
            let cell = first + col;
            *out = if self.around.status()[cell] == Status::Masked { 0.0 } else { tell(cell, col) };
        }
    }

    /// `start`, and `add` to it for each neighbour.
    fn fold(&self, values: &[f64], cell: usize, start: f64, add: impl Fn(f64, f64) -> f64) -> f64 {
        let mut all = start;
        self.around.each(cell, |to, _| all = add(all, values[to]));
        all
    }

    fn mean(&self, values: &[f64], cell: usize) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        self.around.each(cell, |to, _| (sum, count) = (sum + values[to], count + 1.0));
        if count > 0.0 { sum / count } else { values[cell] }
    }

    /// The least or the greatest of the neighbours' values, as `pick` picks of two.
    fn pick(&self, values: &[f64], cell: usize, pick: impl Fn(f64, f64) -> f64) -> f64 {
        let mut found = None;
        self.around.each(cell, |to, _| found = Some(found.map_or(values[to], |f| pick(f, values[to]))));
        found.unwrap_or(values[cell])
    }
}

impl Cells for World<'_> {
    fn grid(&self) -> &Grid {
        self.grid
    }

    fn seed(&self) -> Seed {
        self.seed
    }

    fn plane(&self, variable: usize) -> Option<&[f64]> {
        // `z` follows the states: it is another word for the ground.
        let state = if variable == self.states.len() { GROUND } else { variable };
        self.states.get(state).map(Vec::as_slice)
    }

    fn variable(&self, variable: usize, row: usize, out: &mut [f64]) {
        let cols = self.grid.shape.cols;
        if let Some(plane) = self.plane(variable) {
            out.copy_from_slice(&plane[row * cols..(row + 1) * cols]);
            return;
        }
        match variable - self.states.len() {
            1 => out.fill(self.step as f64),
            2 => out.fill(self.grid.spacing[0]),
            _ => self.each(row, out, |cell, _| f64::from(u8::from(self.around.status()[cell] == Status::Interior))),
        }
    }

    fn call(&self, call: CellCall<'_>, row: usize, out: &mut [f64]) {
        let ground = self.states[GROUND].as_slice();
        let value = call.expressions.first().copied().unwrap_or(ground);
        let around = self.around;
        match Told::ALL[call.function] {
            Told::Sum => self.each(row, out, |cell, _| self.fold(value, cell, 0.0, |all, v| all + v)),
            Told::Mean => self.each(row, out, |cell, _| self.mean(value, cell)),
            Told::Min => self.each(row, out, |cell, _| self.pick(value, cell, f64::min)),
            Told::Max => self.each(row, out, |cell, _| self.pick(value, cell, f64::max)),
            Told::Count => {
                let add = |all: f64, v: f64| if v != 0.0 { all + 1.0 } else { all };
                self.each(row, out, |cell, _| self.fold(value, cell, 0.0, add));
            }
            Told::AtLowest => {
                let surface = call.expressions.get(1).copied().unwrap_or(ground);
                self.each(row, out, |cell, _| value[around.lowest(surface, cell).unwrap_or(cell)]);
            }
            Told::At => {
                let cells = |number: f64| (number.round() as i64).clamp(-FARTHEST, FARTHEST);
                self.each(row, out, |cell, col| {
                    let by = [cells(call.numbers[0][col]), cells(call.numbers[1][col])];
                    value[around.offset(cell, by).unwrap_or(cell)]
                });
            }
            Told::Drop => {
                self.each(row, out, |cell, _| around.lowest(value, cell).map_or(0.0, |to| value[cell] - value[to]));
            }
            Told::Slope => self.each(row, out, |cell, _| around.steepest(value, cell).map_or(0.0, |(_, slope)| slope)),
            Told::Random => {
                let draws = self.draws.with(call.call as u64);
                self.each(row, out, |cell, _| draws.uniform(cell as u64));
            }
        }
    }
}
