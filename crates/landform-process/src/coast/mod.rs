//! Coasts.
//!
//! # Model
//! Land on a raster has the sea around it. Every site has a resistance R, random from 0 to 1, which
//! exposed sides lower. A site of the coast falls where the force of the sea F = f / (1 + g L / L0)
//! exceeds it (Eq. 2.8; locally Eq. 4.2). A site that falls may weaken sites nearby (4.2.3). All
//! sites that fall in a round do so at once; the land behind them is coast from the next round on.
//!
//! # Method
//! The coast is a group of agents; a round costs as much as the coast is long, and with a local
//! perimeter its length times the radius. Where other processes on the same clock moved the ground,
//! or the level of the sea changed, the sea floods anew before the round: what rose from it has all
//! its resistance again. With a `grain` sites are irregular grains of a size in metres rather than
//! cells, so that the same coast forms whatever the cells, and none of its lines follows them.
//!
//! # Limits
//! Rounds have no length in time. All land that falls gets the same depth. On cells, without
//! weakening, the model has no scale: the depth of its bays is a number of cells, not of metres.
//!
//! # Sources
//! Sapoval, Baldassarri & Gabrielli (2004); Pytel (2015), 2.3.3, 4.2, 4.3.4 and B.1, whose radii
//! are read as metres on sites 15 m apart (radii of 150 to 250 sites do not fit his run times).
//! Weakening in proportion to the missing neighbours is 4.2.1. L in Eq. 4.2 is taken over 2 R: see
//! `perimeter.rs`. With that the forces of tables 4.3 and 4.4 work as printed.
//!
//! # Checked by
//! `tests`: tables 4.3 and 4.4 as printed, fractal dimension, width and final force of percolation
//! fronts, global as the limit of local, rest, sea, weakening, ground that moves beside it.
//!
//! # Example
//! A sea that is stronger than any rock takes one ring of sites in each round:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::units::{Ratio, YEAR};
//! use landform_process::coast::CoastErosion;
//!
//! let island = HeightField::new(Grid::new(Shape::new(9, 9), [10.0, 10.0])?, vec![4.0; 81])?;
//! let mut model = Model::new(island).dt(YEAR);
//! model.add(CoastErosion { force: Some(Ratio::of(10.0).into()), ..CoastErosion::default() })?;
//! model.advance_steps(2)?;
//! let land = model.terrain().elevation().iter().filter(|&&z| z > 0.0).count();
//! assert_eq!(land, 25);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod any_front;
mod front;
mod front_terrain;
mod grains;
mod ground;
mod heights;
mod interior;
mod levels;
mod params;
mod perimeter;
mod prune;
#[cfg(test)]
mod tests;
mod trials;
mod weakest;

use std::borrow::Cow;

use landform_core::field::names;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::YEAR;
use landform_core::verb::{Change, Context, Environment, OwnClock, Process, Resolved, Step};
use landform_core::{Error, Result};
use serde::{Deserialize, Serialize};

use any_front::AnyFront;
use front::{Drive, flood};
pub use front_terrain::FrontTerrain;
use ground::{fingerprint, print_of};
pub use heights::LevelInterpolation;
pub use interior::IslandInterior;
pub use params::{CoastErosion, Exposure, Look, Perimeter, Search, Stable, Until, Weakening, Whole};
pub use prune::PruneIslands;

use crate::mechanism::within_map;

landform_core::stages! {
    generate FrontTerrain => HeightField;
    edit IslandInterior where HeightField;
    edit PruneIslands where HeightField;
    process CoastErosion where HeightField;
}

/// Force of the sea where none is given.
const USUAL_FORCE: f64 = 0.5;

/// Land, what is left of its resistance, and parameters on the nodes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    /// Fingerprint of the ground as it was left.
    ground: u64,
    land: Vec<bool>,
    material: Vec<f64>,
    age: Vec<u32>,
    start_length: f64,
    start_land: usize,
    left: usize,
    rests: bool,
    /// Sea level, m.
    sea_level: f64,
    /// Resistance of the rock, and the seed of its unevenness.
    rock: Resolved,
    seed: Seed,
    force: Resolved,
    damping: Resolved,
    wear: Resolved,
    weakening: Resolved,
    #[serde(skip)]
    front: Option<AnyFront>,
}

impl CoastErosion {
    /// The front as it was left. Land and material move between the state, which a checkpoint
    /// holds, and the front, which it does not.
    fn resume(&self, terrain: &HeightField, state: &mut State) -> Result<AnyFront> {
        let (land, material) = (std::mem::take(&mut state.land), std::mem::take(&mut state.material));
        match state.front.take() {
            Some(mut front) => {
                let (own_land, own_material) = front.parts();
                (*own_land, *own_material) = (land, material);
                Ok(front)
            }
            None => {
                AnyFront::resume(&self.on(terrain), terrain, (land, material), Some(state.start_length), state.seed)
            }
        }
    }
}

/// Sites above the sea, or cut off from it.
fn land_above(terrain: &HeightField, level: f64) -> Result<Vec<bool>> {
    let z = terrain.elevation();
    let sea = flood(terrain.grid(), z, level)?;
    Ok((0..z.len()).map(|i| !sea[i] && !z[i].is_nan()).collect())
}

impl State {
    /// What is left of a site's resistance before the sea came.
    fn fresh(&self, site: usize, node: usize) -> f64 {
        self.rock.at(node) * self.seed.uniform(site as u64)
    }

    /// Floods anew: land that rose from the sea has all its resistance, land that sank is sea.
    fn flood(&mut self, terrain: &HeightField, front: &mut AnyFront, round: u32) -> Result<()> {
        for site in front.take_over(land_above(terrain, self.sea_level)?) {
            let fresh = self.fresh(site, front.node(site));
            let (land, material) = front.parts();
            let age = if land[site] {
                material[site] = fresh;
                self.left += 1;
                0
            } else {
                self.left = self.left.saturating_sub(1);
                round
            };
            front.each_node(site, |i| self.age[i] = age);
        }
        Ok(())
    }
}

impl Process<HeightField> for CoastErosion {
    const WRITES: &'static [&'static str] = &["elevation", "shore_age"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        Some(OwnClock { dt: YEAR, rounds: self.iterations, is_timed: false })
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        let params = self.on(terrain);
        let mut state = params.begin(terrain, context)?;
        if let (Some(land), Until::Stable(_)) = (self.wanted_land(), params.until) {
            state.force = Resolved::Uniform(params.force_that_leaves(land, &state)?);
        }
        Ok(state)
    }

    fn is_at_rest(&self, terrain: &HeightField, state: &State) -> bool {
        let params = self.on(terrain);
        state.rests || matches!(params.until, Until::Land { .. }) && !params.falls_short(state)
    }

    fn is_short_of_its_end(&self, terrain: &HeightField, state: &State) -> bool {
        self.on(terrain).falls_short(state)
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        let mut front = self.resume(terrain, state)?;
        let round_number = (at.index + 1).min(u64::from(u32::MAX)) as u32;
        let level = at.environment.level_or(self.sea_level, at.time);
        if level != state.sea_level || fingerprint(terrain.elevation()) != state.ground {
            state.sea_level = level;
            state.ground = fingerprint(terrain.elevation());
            state.flood(terrain, &mut front, round_number)?;
        }
        let fallen = self.on(terrain).round(state, &state.force, &mut front);
        state.rests = front.is_done() || fallen.is_empty() && state.wear.max() == 0.0;
        state.left = state.left.saturating_sub(fallen.len());
        fallen.iter().for_each(|&site| front.each_node(site, |i| state.age[i] = round_number));
        let (floor, mut eroded) = (level - self.depth.si(), 0.0);
        terrain.change(Layer::Surface("sediment"), |z| {
            let mut sink = |i: usize| {
                let new = z[i].min(floor);
                let print = print_of(i, new).wrapping_sub(print_of(i, z[i]));
                state.ground = state.ground.wrapping_add(print);
                eroded += z[i] - new;
                z[i] = new;
            };
            fallen.iter().for_each(|&site| front.each_node(site, &mut sink));
        });
        if front.opens_lows(&fallen, terrain.elevation(), level) {
            state.flood(terrain, &mut front, round_number)?;
        }
        let (land, material) = front.parts();
        (state.land, state.material) = (std::mem::take(land), std::mem::take(material));
        state.front = Some(front);
        let eroded = eroded * terrain.grid().cell_area();
        Ok(Change { eroded, exported: eroded, ..Change::default() })
    }

    fn finish(&self, terrain: &mut HeightField, state: &mut State, _: &Environment) -> Result<()> {
        terrain.fields_mut().insert(&names::SHORE_AGE, state.age.clone())
    }
}

impl CoastErosion {
    /// The parameters on a terrain's cells, with those that a look stands for.
    fn on(&self, terrain: &HeightField) -> Cow<'_, Self> {
        let [dx, dy] = terrain.grid().spacing;
        self.with_look(0.5 * (dx + dy))
    }

    /// The state before the first round.
    fn begin(&self, terrain: &HeightField, context: &Context) -> Result<State> {
        if let Some(w) = self.weakening {
            within_map("weakening", w.radius, terrain.grid())?;
        }
        let n = terrain.elevation().len();
        let level = context.environment.level_or(self.sea_level, context.time);
        let land = land_above(terrain, level)?;
        let start_land = land.iter().filter(|l| **l).count();
        if start_land == 0 {
            return Err(Error::parameter("sea_level", format!("{level} m"), "a level that leaves land"));
        }
        let resolve = |v: &landform_core::verb::Varying<_>, name: &str| v.resolve(name, terrain, context);
        let mut state = State {
            ground: fingerprint(terrain.elevation()),
            sea_level: level,
            land,
            material: Vec::new(),
            age: vec![0; n],
            start_length: 0.0,
            start_land,
            left: start_land,
            rests: false,
            rock: resolve(&self.resistance, "resistance")?,
            seed: context.seed,
            force: match &self.force {
                Some(force) => resolve(force, "force")?,
                None => Resolved::Uniform(USUAL_FORCE),
            },
            damping: resolve(&self.damping, "damping")?,
            wear: resolve(&self.wear, "wear")?,
            weakening: match &self.weakening_factor {
                Some(factor) => resolve(factor, "weakening_factor")?,
                None => Resolved::Uniform(1.0),
            },
            front: None,
        };
        if matches!(self.until, Until::Stable(_)) && state.wear.max() > 0.0 {
            return Err(params::never_rests());
        }
        let land = std::mem::take(&mut state.land);
        let mut front = AnyFront::new(self, terrain, land, state.seed, |site, node| state.fresh(site, node))?;
        if front.is_done() {
            return Err(Error::parameter("sea_level", format!("{level} m"), "a level at which the sea reaches land"));
        }
        state.start_length = front.start_length();
        let (land, material) = front.parts();
        state.start_land = land.iter().filter(|l| **l).count();
        state.left = state.start_land;
        (state.land, state.material) = (std::mem::take(land), std::mem::take(material));
        state.front = Some(front);
        Ok(state)
    }

    /// One round by a force; returns the sites that fell.
    fn round(&self, state: &State, force: &Resolved, front: &mut AnyFront) -> Vec<usize> {
        let amount = self.weakening.map_or(0.0, |w| w.amount);
        let grains = front.grains();
        let node = |site: usize| grains.as_ref().map_or(site, |g| g.node(site));
        let drive = Drive {
            force: &|i| force.at(node(i)),
            damping: &|i| state.damping.at(node(i)),
            wear: &|i| state.wear.at(node(i)),
            weakening: &|i| amount * state.weakening.at(node(i)),
        };
        front.round(&drive).fallen
    }

    /// Whether more land is left than was asked for.
    fn falls_short(&self, state: &State) -> bool {
        match self.until {
            Until::Stable(_) => false,
            Until::Land { land } => state.left as f64 > land * state.start_land as f64,
        }
    }
}
