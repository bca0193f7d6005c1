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

use landform_core::grid::RasterDomain;
use landform_core::parallel;
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
    /// Speed in the pipes to the east and to the south of every node, m/s.
    speed: Vec<[f64; 2]>,
    /// Manning's roughness, s/m^(1/3).
    roughness: f64,
    spacing: [f64; 2],
    #[serde(skip)]
    scratch: Scratch,
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    /// Speeds before the step.
    before: Vec<[f64; 2]>,
    /// Volume that crosses the pipes in the step, m³, as they would have it.
    volume: Vec<[f64; 2]>,
    /// Part of it that the column can give.
    gives: Vec<f64>,
    /// Volume that has crossed to the east and to the south since the sums were begun, m³, and the time, s.
    sums: Vec<[f64; 2]>,
    time: f64,
}

/// What a pipe joins: water and ground at its ends.
#[derive(Clone, Copy)]
struct Ends {
    water: [f64; 2],
    ground: [f64; 2],
}

/// What all pipes of a direction share in a step.
#[derive(Clone, Copy)]
struct Kind {
    length: f64,
    dt: f64,
    /// Change of speed by a metre of difference in level, 1/s.
    pull: f64,
    friction: f64,
    /// The greatest speed, m/s.
    most: f64,
    /// Volume that crosses by depth and speed, m s.
    opening: f64,
}

impl Kind {
    fn new(length: f64, width: f64, dt: f64, roughness: f64) -> Self {
        let friction = GRAVITY * roughness * roughness * dt;
        // No faster than a wave would cross the cell.
        Self { length, dt, pull: dt * GRAVITY / length, friction, most: 0.9 * length / dt, opening: width * dt }
    }
}

/// The pipe in line with another: its speed, and the water at its far end.
type InLine = (f64, f64);

impl Pipes {
    /// Still water.
    pub fn new(nodes: usize, spacing: [f64; 2], roughness: f64) -> Self {
        Self { speed: vec![[0.0; 2]; nodes], roughness, spacing, scratch: Scratch::default() }
    }

    /// Longest stable step, s: dt <= 0.4 dx / (|u| + sqrt(g w)).
    pub fn max_step(&self, water: &[f64]) -> f64 {
        let deepest = parallel::max(water.len(), |i| water[i]).max(THIN);
        let fastest = parallel::max(water.len(), |i| self.speed[i][0].abs().max(self.speed[i][1].abs())).max(0.0);
        COURANT * self.spacing[0].min(self.spacing[1]) / (fastest + (GRAVITY * deepest).sqrt())
    }

    /// Begins to sum what crosses.
    pub fn begin_sums(&mut self) {
        self.scratch.sums.clear();
        self.scratch.sums.resize(self.speed.len(), [0.0; 2]);
        self.scratch.time = 0.0;
    }

    /// Mean net discharge through each node since sums were begun, m³/s: what sloshes to and fro is no flow.
    pub fn net_discharge(&self, domain: &RasterDomain) -> Vec<f64> {
        let cols = domain.shape().cols;
        let Scratch { sums, time, .. } = &self.scratch;
        // Along an axis: what goes through; of what comes from both sides, or leaves to both, the difference.
        let through = |a: f64, b: f64| if a * b >= 0.0 { a.abs().max(b.abs()) } else { 0.5 * (a + b).abs() };
        parallel::map(sums.len(), |i| {
            let west = if i % cols > 0 { sums[i - 1][0] } else { 0.0 };
            let north = if i >= cols { sums[i - cols][1] } else { 0.0 };
            (through(west, sums[i][0]) + through(north, sums[i][1])) / time
        })
    }

    /// What a node gave to its neighbours in the east, south, west and north since sums were begun, m³; less than 0 if it received.
    pub fn gave(&self, domain: &RasterDomain, node: usize) -> impl Iterator<Item = (usize, f64)> {
        let (sums, shape) = (&self.scratch.sums, domain.shape());
        let (row, col) = (node / shape.cols, node % shape.cols);
        let east = (col + 1 < shape.cols).then(|| (node + 1, sums[node][0]));
        let south = (row + 1 < shape.rows).then(|| (node + shape.cols, sums[node][1]));
        let west = (col > 0).then(|| (node - 1, -sums[node - 1][0]));
        let north = (row > 0).then(|| (node - shape.cols, -sums[node - shape.cols][1]));
        [east, south, west, north].into_iter().flatten()
    }

    /// One step of `dt` seconds. The supply is what comes and goes in a second; `ends` are the nodes where water leaves.
    pub fn step(
        &mut self,
        domain: &RasterDomain,
        ground: &[f64],
        (supply, ends): (&Supply, &[u32]),
        dt: f64,
        water: &mut [f64],
    ) -> Ledger {
        let mut ledger = Ledger { entered: supply.total * dt, ..Ledger::default() };
        let dries = supply.evaporation * dt;
        if dries > 0.0 {
            ledger.evaporated = parallel::sum(water.len(), |i| (water[i] + supply.depth[i] * dt).min(dries));
        }
        parallel::update(water, |i, w| *w = (*w + supply.depth[i] * dt - dries).max(0.0));
        self.accelerate(domain, ground, water, dt);
        self.share_out(domain, water);
        self.carry(domain, water, dt);
        for &end in ends {
            ledger.left += std::mem::take(&mut water[end as usize]);
        }
        ledger
    }

    /// Speeds in the pipes after the step, and the volumes they would carry.
    fn accelerate(&mut self, domain: &RasterDomain, ground: &[f64], water: &[f64], dt: f64) {
        let shape = domain.shape();
        let (cols, rows) = (shape.cols, shape.rows);
        let [dx, dy] = self.spacing;
        let eastward = Kind::new(dx, dy, dt, self.roughness);
        let southward = Kind::new(dy, dx, dt, self.roughness);
        let Scratch { before: old, volume, .. } = &mut self.scratch;
        volume.resize(water.len(), [0.0; 2]);
        old.resize(water.len(), [0.0; 2]);
        std::mem::swap(old, &mut self.speed);
        let old = &*old;
        let ends = |i: usize, j: usize| Ends { water: [water[i], water[j]], ground: [ground[i], ground[j]] };
        parallel::for_rows_mut2(&mut self.speed, cols, volume, cols, |row, speeds, volumes| {
            for col in 0..cols {
                let i = row * cols + col;
                if col + 1 < cols {
                    let west = if col > 0 { (old[i - 1][0], water[i - 1]) } else { (0.0, 0.0) };
                    let east = if col + 2 < cols { (old[i + 1][0], water[i + 2]) } else { (0.0, 0.0) };
                    (speeds[col][0], volumes[col][0]) = ends(i, i + 1).flow(&eastward, old[i][0], west, east);
                }
                if row + 1 < rows {
                    let j = i + cols;
                    let north = if row > 0 { (old[i - cols][1], water[i - cols]) } else { (0.0, 0.0) };
                    let south = if row + 2 < rows { (old[j][1], water[j + cols]) } else { (0.0, 0.0) };
                    (speeds[col][1], volumes[col][1]) = ends(i, j).flow(&southward, old[i][1], north, south);
                }
            }
        });
    }

    /// The part of the outflow that each column has.
    fn share_out(&mut self, domain: &RasterDomain, water: &[f64]) {
        let cols = domain.shape().cols;
        let area = self.spacing[0] * self.spacing[1];
        let Scratch { volume, gives, .. } = &mut self.scratch;
        gives.resize(water.len(), 1.0);
        parallel::for_rows_mut(gives, cols, |row, gives| {
            for (col, g) in gives.iter_mut().enumerate() {
                let i = row * cols + col;
                let west = if col > 0 { -volume[i - 1][0] } else { 0.0 };
                let north = if row > 0 { -volume[i - cols][1] } else { 0.0 };
                let out = volume[i][0].max(0.0) + volume[i][1].max(0.0) + west.max(0.0) + north.max(0.0);
                let has = water[i] * area;
                *g = if out > has { has / out } else { 1.0 };
            }
        });
    }

    /// Moves the water.
    fn carry(&mut self, domain: &RasterDomain, water: &mut [f64], dt: f64) {
        let cols = domain.shape().cols;
        let per_area = 1.0 / (self.spacing[0] * self.spacing[1]);
        let Scratch { volume, gives, sums, time, .. } = &mut self.scratch;
        *time += dt;
        sums.resize(water.len(), [0.0; 2]);
        let real = |volume: f64, from: usize, to: usize| volume * if volume > 0.0 { gives[from] } else { gives[to] };
        parallel::for_rows_mut2(water, cols, sums, cols, |row, water, sums| {
            for (col, w) in water.iter_mut().enumerate() {
                let i = row * cols + col;
                let e = if col + 1 < cols { real(volume[i][0], i, i + 1) } else { 0.0 };
                let s = if i + cols < gives.len() { real(volume[i][1], i, i + cols) } else { 0.0 };
                let from_west = if col > 0 { real(volume[i - 1][0], i - 1, i) } else { 0.0 };
                let from_north = if row > 0 { real(volume[i - cols][1], i - cols, i) } else { 0.0 };
                *w = (*w + (from_west + from_north - e - s) * per_area).max(0.0);
                sums[col][0] += e;
                sums[col][1] += s;
            }
        });
    }
}

impl Ends {
    /// Speed after the step and volume that crosses, with the pipes `before` and `after` in line with this one.
    #[inline(always)]
    fn flow(&self, kind: &Kind, speed: f64, before: InLine, after: InLine) -> (f64, f64) {
        let [wi, wj] = self.water;
        let [hi, hj] = [self.ground[0] + wi, self.ground[1] + wj];
        let height = hi.max(hj) - self.ground[0].max(self.ground[1]);
        // Ground without a height is a wall.
        if !(height > THIN) || self.ground[0].is_nan() || self.ground[1].is_nan() {
            return (0.0, 0.0);
        }
        // Momentum comes with the flow into the nodes at both ends, from upstream; implicit, since a thin front takes it up at once.
        let flow = |speed: f64, from: f64, to: f64| speed * if speed > 0.0 { from } else { to };
        let moved = if wj < THIN && before.0 > speed {
            // A front runs as fast as what follows it.
            before.0
        } else if wi < THIN && after.0 < speed {
            after.0
        } else {
            let own = flow(speed, wi, wj);
            let depth = kind.length * (wi + wj).max(2.0 * THIN);
            let from_before = kind.dt * (flow(before.0, before.1, wi) + own).max(0.0);
            let from_after = kind.dt * (-flow(after.0, wj, after.1) - own).max(0.0);
            (speed * depth + from_before * before.0 + from_after * after.0) / (depth + from_before + from_after)
        };
        let pushed = moved - kind.pull * (hj - hi);
        let slowed = if kind.friction > 0.0 {
            let r = inverse_cube_root(height);
            pushed / (1.0 + kind.friction * pushed.abs() * (r * r) * (r * r))
        } else {
            pushed
        };
        let limited = slowed.clamp(-kind.most, kind.most);
        let upstream = if limited > 0.0 { wi } else { wj };
        (limited, limited * upstream.min(height) * kind.opening)
    }
}

/// x^(-1/3) for normal x > 0, to 1e-9: Newton's method without a division, from the exponent.
#[inline]
fn inverse_cube_root(x: f64) -> f64 {
    // Minus a third of the exponent, with the bias put right; within 4 %.
    let mut r = f64::from_bits(0x553E_F0FF_289D_D796 - x.to_bits() / 3);
    for _ in 0..3 {
        r *= (4.0 - x * (r * r * r)) * (1.0 / 3.0);
    }
    r
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_cube_root_is_one() {
        for k in -60..60 {
            let x = 1.37 * f64::powi(1.7, k);
            let r = inverse_cube_root(x);
            assert!((x * r * r * r - 1.0).abs() < 1e-9, "{x} {r}");
        }
    }
}
