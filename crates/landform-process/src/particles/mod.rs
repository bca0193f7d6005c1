//! Erosion by particles, on every kind of ground that can be removed and laid.
//!
//! # Model
//! A particle moves by gravity, buoyancy and drag through air, water and their currents
//! ([`motion`], [`flow`], [`wind`]); at each contact with the ground it wears it and lays down a
//! part of its load ([`law`]); at its end it lays down the rest, or leaves with it.
//!
//! # Method
//! Each iteration sends out a batch. The ways of up to 256 particles are followed over ground that
//! stands still ([`path`]), side by side; then what they do to it is done in the order of the
//! particles ([`ledger`]): any number of threads, the same bytes. The physics never asks which
//! ground it is on. **Cost** O(steps · nodes under the brush).
//!
//! # Limits
//! Particles do not meet each other. Whole voxels are steps, which slow particles down: on a hill
//! they wore six tenths of what parts of voxels did. Base levels are not held: the ground moves
//! wherever particles touch it. The flow does not feel what particles do before the next iteration.
//! A particle that rests on its way through water lets its load fall straight down. A voxel is of
//! one material: in a mixture the larger part gives the name.
//!
//! # Sources
//! Hartley (thesis), chapter 6, with the corrections that [`motion`], [`law`] and [`presets`] name.
//!
//! # Checked by
//! `tests`: Stokes, hindered settling, volumes of brushes, mass, limits of loads, bounces, energy
//! on slopes without friction, rest, buoyancy, cones, layers against plain ground, threads, the
//! wind.
//!
//! # Example
//! Rain on a hill carries ground from its top to its foot:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::HeightField;
//! use landform_core::units::YEAR;
//! use landform_process::particles::ParticleErosion;
//!
//! let grid = Grid::new(Shape::new(41, 41), [10.0; 2])?;
//! let hill = (0..41 * 41).map(|i| 4.0 * (20.0 - (i as f64 % 41.0 - 20.0).abs())).collect();
//! let mut model = Model::new(HeightField::new(grid, hill)?).dt(YEAR);
//! model.add(ParticleErosion::default())?;
//! model.advance_steps(5)?;
//! assert!(model.budget().change.eroded > 0.0 && model.budget().imbalance() < 1e-9);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod emit;
mod flow;
mod law;
mod ledger;
mod motion;
mod params;
mod path;
mod presets;
mod surroundings;
#[cfg(test)]
mod tests;
mod wind;

use landform_core::random::Seed;
use landform_core::terrain::{Bounds, Erodible, HeightField, VoxelGrid};
use landform_core::units::YEAR;
use landform_core::verb::{Change, Context, OwnClock, Process, Step};
use landform_core::{Error, Result, math, parallel};
use serde::{Deserialize, Serialize};

use emit::Source;
use flow::Fluids;
use law::Law;
use ledger::{Books, Deposits, Stock};
use motion::{AIR, Body, GRAVITY, WATER};
pub use params::{Hindrance, ParticleErosion, Voxels};
use path::{Particle, Trace, trace};
pub use presets::Phenomenon;
use presets::Preset;
pub use surroundings::{BoxParams, Emitter, Flow, FlowIn, PointParams, WindParams};

landform_core::stages! {
    process ParticleErosion where HeightField, VoxelGrid;
}

/// Particles whose ways are followed over ground that stands still.
const BATCH: u64 = 256;
/// Particles that one thread follows in a row.
const PIECE: usize = 8;

/// What particles that ended have left in transport.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    stock: Stock,
}

impl<T: Erodible> Process<T> for ParticleErosion {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        let rounds = self.iterations.unwrap_or(self.phenomenon.preset().iterations);
        Some(OwnClock { dt: YEAR, rounds, is_timed: false })
    }

    fn start(&self, terrain: &mut T, _: &Context) -> Result<State> {
        if self.voxels == Voxels::Density {
            terrain.make_divisible();
        }
        self.deposits_on(terrain)?;
        let load = vec![0.0; terrain.table().map_or(1, |table| table.all().len())];
        Ok(State { stock: Stock::of(load) })
    }

    fn step(&self, terrain: &mut T, state: &mut State, at: &Step) -> Result<Change> {
        let (preset, bounds) = (self.phenomenon.preset(), terrain.bounding_box());
        let sea = self.sea_level.map(|level| level.si());
        let level = sea.or(at.environment.sea_level.as_ref().map(|level| level.at(at.time + at.dt)));
        let fluids = Fluids::new(self, terrain, &bounds, level, at.seed)?;
        let emitter = self.emitter_in(&preset, &fluids, &bounds)?;
        let iterations = self.iterations.unwrap_or(preset.iterations);
        let part = at.index as f64 / iterations.max(2).saturating_sub(1) as f64;
        let law = Law::new(self, &preset, terrain.table(), part);
        let deposits = self.deposits_on(terrain)?;
        let sizes = self.sizes(&preset, terrain.resolution(), &bounds)?;
        let (mut books, carried, mut started) = (Books::default(), state.stock.volume(), 0);
        let particles = self.particles.unwrap_or(preset.particles);
        for first in (0..particles).step_by(BATCH as usize) {
            let batch = first..(first + BATCH).min(particles);
            let source =
                Source { ground: terrain, bounds, fluids: &fluids, emitter: emitter.0.clone(), towards: emitter.1 };
            let one = |number: u64| self.follow(&source, &law, &preset, sizes, at.seed.with(number));
            for trace in follow_all(batch, one)?.iter().flatten() {
                started += 1;
                state.stock.apply(terrain, &bounds, &deposits, trace, &mut books);
            }
        }
        if started == 0 && at.index == 0 {
            return Err(Error::parameter(
                "emitter",
                "where no particle finds a place to start",
                "a place over ground, in the open",
            ));
        }
        Ok(books.change(state.stock.volume() - carried))
    }
}

/// The ways of some particles, in their order.
fn follow_all(
    batch: std::ops::Range<u64>,
    one: impl Fn(u64) -> Result<Option<Trace>> + Sync,
) -> Result<Vec<Option<Trace>>> {
    let pieces: Vec<_> = batch.clone().step_by(PIECE).map(|k| k..(k + PIECE as u64).min(batch.end)).collect();
    let ways = parallel::run_all(pieces, |piece| piece.map(&one).collect::<Result<Vec<_>>>());
    Ok(ways.into_iter().collect::<Result<Vec<_>>>()?.into_iter().flatten().collect())
}

impl ParticleErosion {
    /// Least and greatest radius, m.
    fn sizes(&self, preset: &Preset, cell: f64, bounds: &Bounds) -> Result<[f64; 2]> {
        let least = self.radius.map_or(preset.radius[0] * cell, |r| r.si());
        let of_table = if self.radius.is_some() { least } else { preset.radius[1] * cell };
        let most = self.greatest_radius.map_or(of_table, |r| r.si()).max(least);
        let widest = math::hypot(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1]).max(cell);
        let given = self.greatest_radius.or(self.radius);
        match given.filter(|radius| radius.si() > widest) {
            Some(radius) => {
                let name = if self.greatest_radius.is_some() { "greatest_radius" } else { "radius" };
                Err(Error::parameter(name, radius, &format!("at most {widest:.0} m, the diagonal of the map")))
            }
            None => Ok([least, most]),
        }
    }

    /// The emitter, and the direction of the flow for one that needs it.
    fn emitter_in(&self, preset: &Preset, fluids: &Fluids, bounds: &Bounds) -> Result<(Emitter, Option<[f64; 2]>)> {
        let emitter = self.emitter.clone().unwrap_or_else(|| preset.emitter.clone());
        if emitter == Emitter::Water && !fluids.level.is_finite() {
            return Err(Error::parameter("sea_level", "not given", "the level of the water in which particles start"));
        }
        let middle = [0, 1, 2].map(|k| if k == 2 { bounds.high[2] } else { 0.5 * (bounds.low[k] + bounds.high[k]) });
        let towards = if emitter == Emitter::Upwind { fluids.direction(middle)? } else { None };
        match (&emitter, towards) {
            // Without a flow grains fall on all of the ground.
            (Emitter::Upwind, None) if fluids.is_still() => Ok((Emitter::Sky, None)),
            (Emitter::Upwind, None) => {
                Err(Error::parameter("flow", "at rest over the middle of the map", "a flow, or another `emitter`"))
            }
            _ => Ok((emitter, towards)),
        }
    }

    /// As what worn ground is laid.
    fn deposits_on<T: Erodible>(&self, terrain: &T) -> Result<Deposits> {
        let Some(table) = terrain.table() else { return Ok(Deposits { of_rock: 0, rocks: 0 }) };
        // Loose materials follow the rocks in the table.
        Ok(Deposits { of_rock: table.need(&self.deposits, "deposits")?, rocks: table.find("clay").unwrap_or(0) })
    }

    /// The way of one particle; none where it finds no place to start.
    fn follow<T: Erodible>(
        &self,
        source: &Source<'_, T>,
        law: &Law,
        preset: &Preset,
        [least, most]: [f64; 2],
        seed: Seed,
    ) -> Result<Option<Trace>> {
        let radius = least + (most - least) * seed.named("radius").uniform(0);
        let body = Body {
            radius,
            density: self.density.unwrap_or(preset.density),
            viscosity: self.viscosity.unwrap_or_else(|| usual_viscosity(radius)),
        };
        let Some(state) = source.draw(&body, seed)? else { return Ok(None) };
        let load = self.initial_load.unwrap_or(preset.initial_load) * law.capacity * body.volume();
        trace(source.ground, source.fluids, law, Particle { body, state, load }).map(Some)
    }
}

/// Viscosity in which a particle of water falls through air at half of the speed of waves of its
/// radius, Pa s.
fn usual_viscosity(radius: f64) -> f64 {
    2.0 / 9.0 * (WATER - AIR) * GRAVITY * radius * radius / (0.5 * motion::wave_speed(radius))
}
