//! Water second by second: columns joined by pipes.
//!
//! # Model
//! Between neighbours runs a pipe as wide as a cell and as high as the water stands over the higher of their beds. Water in it is
//! accelerated by the difference of levels and slowed by friction and by the momentum that it takes along; no column gives more than it
//! has.
//!
//! # Method
//! Explicit: fluxes on faces, then the part of them that the columns can give, then columns. The step is at most 0.4 of the time that a
//! wave needs across a cell. Friction is implicit. Each pass is over rows, in parallel; every face is computed once, so what leaves one
//! column is what enters the next.
//!
//! # Sources
//! O'Brien & Hodgins (1995) and Mei, Decaudin & Hu (2007) for pipes with scaled outflow (listing 4.3 of Pytel 2015); Bates, Horritt &
//! Fewtrell (2010) for the height of the pipe and implicit friction; Stelling & Duinmeijer (2003) for the momentum that columns bring
//! along, without which a dam break runs at a fourth of its speed.

use landform_core::grid::{BASE_LEVEL, Domain, MASKED, RasterDomain};
use landform_core::{math, parallel};
use serde::{Deserialize, Serialize};

use super::{Ledger, Supply};

const GRAVITY: f64 = 9.81;
/// Part of the time that a wave needs across a cell.
const COURANT: f64 = 0.4;
/// Water thinner than this does not run, m.
const THIN: f64 = 1e-6;

/// Water in pipes between the nodes of a raster; nothing crosses its sides but where they are base level.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Pipes {
    /// Speed in the pipe to the east and to the south of every node, m/s.
    east: Vec<f64>,
    south: Vec<f64>,
    /// Manning's roughness, s/m^(1/3).
    roughness: f64,
    spacing: [f64; 2],
    #[serde(skip)]
    scratch: Scratch,
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    /// Volume that crosses the pipe in the step, m³, as the pipe would have it.
    east: Vec<f64>,
    south: Vec<f64>,
    /// Part of it that the column can give.
    gives: Vec<f64>,
    /// Discharge through each node, m³/s.
    discharge: Vec<f64>,
}

impl Pipes {
    /// Still water.
    pub fn new(nodes: usize, spacing: [f64; 2], roughness: f64) -> Self {
        Self { east: vec![0.0; nodes], south: vec![0.0; nodes], roughness, spacing, scratch: Scratch::default() }
    }

    /// Longest stable step, s: dt <= 0.4 dx / (|u| + sqrt(g w)).
    pub fn max_step(&self, water: &[f64]) -> f64 {
        let deepest = parallel::max(water.len(), |i| water[i]).max(THIN);
        let fastest = parallel::max(water.len(), |i| self.east[i].abs().max(self.south[i].abs())).max(0.0);
        COURANT * self.spacing[0].min(self.spacing[1]) / (fastest + (GRAVITY * deepest).sqrt())
    }

    /// Discharge through each node in the last step, m³/s.
    pub fn discharge(&self) -> &[f64] {
        &self.scratch.discharge
    }

    /// One step of `dt` seconds; the supply is what comes in it.
    pub fn step(
        &mut self,
        domain: &RasterDomain,
        ground: &[f64],
        supply: &Supply,
        dt: f64,
        water: &mut [f64],
    ) -> Ledger {
        let mut ledger =
            Ledger { entered: supply.total, before: parallel::sum(water.len(), |i| water[i]), ..Ledger::default() };
        let status = domain.status();
        parallel::update(water, |i, w| *w += if status[i] == MASKED { 0.0 } else { supply.depth[i] });
        if supply.evaporation > 0.0 {
            ledger.evaporated = parallel::sum(water.len(), |i| water[i].min(supply.evaporation));
            parallel::update(water, |_, w| *w = (*w - supply.evaporation).max(0.0));
        }
        self.accelerate(domain, ground, water, dt);
        self.share_out(domain, water);
        self.carry(domain, water, dt);
        let is_end = |i: usize| status[i] == BASE_LEVEL || supply.sinks.get(i).copied().unwrap_or(false);
        ledger.left = parallel::sum(water.len(), |i| if is_end(i) { water[i] } else { 0.0 });
        parallel::update(water, |i, w| *w = if is_end(i) { 0.0 } else { *w });
        ledger.stored = parallel::sum(water.len(), |i| water[i]);
        ledger
    }

    /// Speeds in the pipes after the step, and the volumes they would carry.
    fn accelerate(&mut self, domain: &RasterDomain, ground: &[f64], water: &[f64], dt: f64) {
        let shape = domain.shape();
        let (cols, rows) = (shape.cols, shape.rows);
        let Scratch { east: across, south: down, .. } = &mut self.scratch;
        across.resize(water.len(), 0.0);
        down.resize(water.len(), 0.0);
        let [dx, dy] = self.spacing;
        let friction = GRAVITY * self.roughness * self.roughness * dt;
        // Speed and volume of the pipe from `i` to `j`; `before` and `after` are speeds in the pipes in line with it, with the water
        // of their far ends.
        let pipe = |i: usize, j: usize, speed: f64, before: (f64, f64), after: (f64, f64), length: f64, width: f64| {
            let (wi, wj) = (water[i], water[j]);
            let (hi, hj) = (ground[i] + wi, ground[j] + wj);
            let height = hi.max(hj) - ground[i].max(ground[j]);
            if !(height > THIN) || ground[i].is_nan() || ground[j].is_nan() {
                return (0.0, 0.0);
            }
            // Momentum comes with the flow into the nodes at both ends, from upstream; implicit, since a thin front takes it up at once.
            let flow = |speed: f64, from: f64, to: f64| speed * if speed > 0.0 { from } else { to };
            let own = flow(speed, wi, wj);
            let part = 0.5 * dt / (length * (0.5 * (wi + wj)).max(THIN));
            let from_before = part * (flow(before.0, before.1, wi) + own).max(0.0);
            let from_after = part * (-flow(after.0, wj, after.1) - own).max(0.0);
            let moved = if wj < THIN && before.0 > speed {
                // A front runs as fast as what follows it.
                before.0
            } else if wi < THIN && after.0 < speed {
                after.0
            } else {
                (speed + from_before * before.0 + from_after * after.0) / (1.0 + from_before + from_after)
            };
            let pushed = moved - dt * GRAVITY * (hj - hi) / length;
            let slowed = if friction > 0.0 {
                pushed / (1.0 + friction * pushed.abs() / (height * math::cbrt(height)))
            } else {
                pushed
            };
            // No faster than a wave would cross the cell.
            let limited = slowed.clamp(-0.9 * length / dt, 0.9 * length / dt);
            let upstream = if limited > 0.0 { water[i] } else { water[j] };
            (limited, limited * upstream.min(height) * width * dt)
        };
        let old_east = self.east.clone();
        parallel::for_rows_mut2(&mut self.east, cols, across, cols, |row, speeds, volumes| {
            let start = row * cols;
            for col in 0..cols - 1 {
                let i = start + col;
                let before = if col > 0 { (old_east[i - 1], water[i - 1]) } else { (0.0, 0.0) };
                let after = if col + 2 < cols { (old_east[i + 1], water[i + 2]) } else { (0.0, 0.0) };
                (speeds[col], volumes[col]) = pipe(i, i + 1, old_east[i], before, after, dx, dy);
            }
        });
        let old_south = self.south.clone();
        parallel::for_rows_mut2(&mut self.south, cols, down, cols, |row, speeds, volumes| {
            if row + 1 == rows {
                return;
            }
            for col in 0..cols {
                let i = row * cols + col;
                let before = if row > 0 { (old_south[i - cols], water[i - cols]) } else { (0.0, 0.0) };
                let after = if row + 2 < rows { (old_south[i + cols], water[i + 2 * cols]) } else { (0.0, 0.0) };
                (speeds[col], volumes[col]) = pipe(i, i + cols, old_south[i], before, after, dy, dx);
            }
        });
    }

    /// The part of the outflow that each column has.
    fn share_out(&mut self, domain: &RasterDomain, water: &[f64]) {
        let cols = domain.shape().cols;
        let area = self.spacing[0] * self.spacing[1];
        let Scratch { east, south, gives, .. } = &mut self.scratch;
        gives.resize(water.len(), 1.0);
        parallel::for_rows_mut(gives, cols, |row, gives| {
            for (col, g) in gives.iter_mut().enumerate() {
                let i = row * cols + col;
                let west = if col > 0 { -east[i - 1] } else { 0.0 };
                let north = if row > 0 { -south[i - cols] } else { 0.0 };
                let out = east[i].max(0.0) + south[i].max(0.0) + west.max(0.0) + north.max(0.0);
                let has = water[i] * area;
                *g = if out > has { has / out } else { 1.0 };
            }
        });
    }

    /// Moves the water.
    fn carry(&mut self, domain: &RasterDomain, water: &mut [f64], dt: f64) {
        let cols = domain.shape().cols;
        let area = self.spacing[0] * self.spacing[1];
        let Scratch { east, south, gives, discharge } = &mut self.scratch;
        discharge.resize(water.len(), 0.0);
        let real = |volume: f64, from: usize, to: usize| volume * if volume > 0.0 { gives[from] } else { gives[to] };
        parallel::for_rows_mut2(water, cols, discharge, cols, |row, water, discharge| {
            for (col, w) in water.iter_mut().enumerate() {
                let i = row * cols + col;
                let e = if col + 1 < cols { real(east[i], i, i + 1) } else { 0.0 };
                let s = if i + cols < gives.len() { real(south[i], i, i + cols) } else { 0.0 };
                let from_west = if col > 0 { real(east[i - 1], i - 1, i) } else { 0.0 };
                let from_north = if row > 0 { real(south[i - cols], i - cols, i) } else { 0.0 };
                *w = (*w + (from_west + from_north - e - s) / area).max(0.0);
                let out = e.max(0.0) + s.max(0.0) + (-from_west).max(0.0) + (-from_north).max(0.0);
                let into = (-e).max(0.0) + (-s).max(0.0) + from_west.max(0.0) + from_north.max(0.0);
                discharge[col] = out.max(into) / dt;
            }
        });
    }
}
