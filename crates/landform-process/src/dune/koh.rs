//! Koh's automaton (2002), section 5.2.
//!
//! Wind enters at full strength and is swept row by row: the mean of the three cells upwind, less a part of the height by which
//! the next cell to windward stands above. (The thesis' "next cell in the wind direction" is read as it reads "the three
//! neighbouring cells in the wind direction" a sentence before: towards the wind. If the rise ahead slows the wind instead, sand
//! never comes to rest in a lee.) Its strength is the probability that a slab moves, to the lowest of the three cells downwind,
//! unless the rise is too steep. All cells move at once. Two rules are added to the thesis: slabs slip at the angle of repose,
//! and slowed wind recovers over a distance; without the second the first dune would shield all others. Wind that does not
//! recover begins anew at the seam of the torus in every round.

use landform_core::random::Seed;
use landform_core::terrain::HeightField;
use landform_core::units::Length;
use landform_core::verb::Rose;
use landform_core::{math, parallel};

use super::field::Field;
use super::params::Dunes;
use crate::mechanism::wind::WindScan;

/// The strength of the wind over a surface (in m), swept along `sweep`, into `out`.
pub(super) fn wind_over(sweep: &WindScan, height: impl Fn(usize) -> f64, loss: f64, recovery: f64, out: &mut [f32]) {
    let (lines, length) = sweep.scan_lines();
    let (mut before, mut here) = (vec![1.0f64; length], vec![1.0f64; length]);
    // Wind that recovers does not depend on where it began, so it may cross the seam of a torus without a trace.
    let passes = if sweep.is_torus() && recovery > 0.0 { 2 } else { 1 };
    for k in 0..lines * passes {
        let (line, first) = (k % lines, k == 0);
        let drift = sweep.lateral_shift(line);
        for at in 0..length {
            let upwind = |by: i64| sweep.along(at, by - drift).map_or(1.0, |a| before[a]);
            let mut wind = if first { 1.0 } else { (upwind(-1) + upwind(0) + upwind(1)) / 3.0 };
            wind += (1.0 - wind) * recovery;
            let windward = match (line > 0, sweep.is_torus()) {
                (true, _) => sweep.along(at, -drift).map(|a| sweep.node(line - 1, a)),
                (false, true) => Some(sweep.node(lines - 1, at)),
                _ => None,
            };
            let node = sweep.node(line, at);
            let shielding = windward.map_or(0.0, |n| height(n) - height(node));
            // Nodata neither slows nor stops the wind.
            let shielding = if shielding.is_nan() { 0.0 } else { shielding.max(0.0) };
            here[at] = (wind - loss * shielding / sweep.line_spacing).clamp(0.0, 1.0);
            out[node] = here[at] as f32;
        }
        std::mem::swap(&mut before, &mut here);
    }
}

/// A round.
#[expect(clippy::too_many_arguments, reason = "one call, from the step")]
pub(super) fn round(
    params: &Dunes,
    terrain: &HeightField,
    field: &mut Field,
    air: &mut Vec<f32>,
    rose: &Rose,
    wind: usize,
    part: f64,
    seed: Seed,
) {
    let grid = terrain.grid();
    let sweep = WindScan::new(grid.shape, grid.spacing, field.is_torus(), rose.winds()[wind].towards());
    let surface = field.sand.surface();
    let recovery = params.wind_recovery.map(Length::si).map_or(0.0, |d| 1.0 - math::exp(-sweep.line_spacing / d));
    air.resize(grid.len(), 0.0);
    wind_over(&sweep, |i| f64::from(surface[i]) * field.unit, params.wind_loss, recovery, air);
    let climb = f64::from(field.fall(params.steepest_climb.si(), sweep.line_spacing));
    let (lines, length) = sweep.scan_lines();
    // Where the slab of each cell goes, for all at once.
    let moves: Vec<Vec<(u32, u32)>> = parallel::map(lines, |line| {
        let mut moves = Vec::new();
        for at in 0..length {
            let node = sweep.node(line, at);
            let strength = f64::from(air[node]);
            let draw = seed.uniform(node as u64);
            if field.sand.depth(node) <= 0 || strength <= params.threshold || draw >= strength * part {
                continue;
            }
            let Some(lowest) = downwind(&sweep, line, at, surface) else {
                moves.push((node as u32, u32::MAX));
                continue;
            };
            if f64::from(surface[lowest] - surface[node]) <= climb {
                moves.push((node as u32, lowest as u32));
            }
        }
        moves
    });
    let slab = field.sand.slab();
    for &(from, to) in moves.iter().flatten() {
        let taken = field.sand.lift(from as usize, slab);
        match to {
            u32::MAX => field.left += i64::from(taken),
            to => field.sand.lay(to as usize, taken),
        }
    }
    field.sand.settle();
}

/// The lowest of the three cells downwind, the middle one of equals; none off the field.
fn downwind(sweep: &WindScan, line: usize, at: usize, surface: &[i32]) -> Option<usize> {
    let lines = sweep.scan_lines().0;
    let (next, drift) = match line + 1 < lines {
        true => (line + 1, sweep.lateral_shift(line + 1)),
        false if sweep.is_torus() => (0, 0),
        false => return None,
    };
    let node = |by: i64| sweep.along(at, drift + by).map(|a| sweep.node(next, a));
    let mut best = node(0)?;
    for by in [-1, 1] {
        if let Some(n) = node(by).filter(|&n| surface[n] < surface[best]) {
            best = n;
        }
    }
    Some(best)
}
