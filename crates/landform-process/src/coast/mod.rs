//! Coasts.
//!
//! # Model
//! Land on a raster has the sea around it. Every site has a resistance R, random from 0 to 1, which exposed sides lower. A site
//! of the coast falls where the force of the sea F = f / (1 + g L / L0) exceeds it (Eq. 2.8; locally Eq. 4.2). A site that falls
//! may weaken sites nearby (4.2.3). All sites that fall in a round do so at once; the land behind them is coast from the next
//! round on.
//!
//! # Method
//! The coast is a group of agents; a round costs as much as the coast is long, and with a local perimeter its length times the
//! radius.
//!
//! # Limits
//! Rounds have no length in time. All land that falls gets the same depth. Land and sea are separated at the start: land that
//! other processes on the same clock raise or drown is not examined again, so put the stages after one another. Without weakening
//! the model has no scale: the depth of its bays is a number of cells, not of metres.
//!
//! # Sources
//! Sapoval, Baldassarri & Gabrielli (2004); Pytel (2015), 2.3.3, 4.2, 4.3.4 and B.1, whose radii are read as metres on sites 15 m
//! apart (radii of 150 to 250 sites do not fit his run times). L in Eq. 4.2 is taken over 2 R: see `perimeter.rs`.
//!
//! # Checked by
//! `tests`: fractal dimension, width and final force of percolation fronts, global as the limit of local, rest, sea, weakening.
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
//! model.add(CoastErosion { force: Ratio::of(10.0).into(), ..CoastErosion::default() })?;
//! model.advance_steps(2)?;
//! let land = model.terrain().elevation().iter().filter(|&&z| z > 0.0).count();
//! assert_eq!(land, 25);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod front;
mod front_terrain;
mod heights;
mod interior;
mod levels;
mod params;
mod perimeter;
mod prune;
#[cfg(test)]
mod tests;

use landform_core::field::names;
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::YEAR;
use landform_core::verb::{Change, Context, Environment, OwnClock, Process, Resolved, Step};
use landform_core::{Error, Result};
use serde::{Deserialize, Serialize};

use front::{Drive, Front, flood};
pub use front_terrain::FrontTerrain;
pub use heights::LevelInterpolation;
pub use interior::IslandInterior;
pub use params::{CoastErosion, Exposure, Perimeter, Search, Stable, Until, Weakening, Whole};
pub use prune::PruneIslands;

use crate::mechanism::within_map;

landform_core::stages! {
    generate FrontTerrain => HeightField;
    edit IslandInterior where HeightField;
    edit PruneIslands where HeightField;
    process CoastErosion where HeightField;
}

/// Land, what is left of its resistance, and parameters on the nodes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    land: Vec<bool>,
    material: Vec<f64>,
    age: Vec<u32>,
    start_length: f64,
    start_land: usize,
    left: usize,
    rests: bool,
    /// Sea level, m.
    sea_level: f64,
    force: Resolved,
    damping: Resolved,
    wear: Resolved,
    weakening: Resolved,
    #[serde(skip)]
    front: Option<Front>,
}

impl CoastErosion {
    fn front(&self, terrain: &HeightField, land: Vec<bool>, material: Vec<f64>, length: Option<f64>) -> Result<Front> {
        let radius = self.weakening.map(|w| w.radius.si());
        Front::new(terrain.grid(), land, material, (self.exposure, self.perimeter), radius, length)
    }
}

impl Process<HeightField> for CoastErosion {
    const WRITES: &'static [&'static str] = &["elevation", "shore_age"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        Some(OwnClock { dt: YEAR, rounds: self.iterations, is_timed: false })
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        if let Some(w) = self.weakening {
            within_map("weakening", w.radius, terrain.grid())?;
        }
        let z = terrain.elevation();
        let level = context.environment.level_or(self.sea_level, context.time);
        let sea = flood(terrain.grid(), z, level)?;
        let land: Vec<bool> = (0..z.len()).map(|i| !sea[i] && !z[i].is_nan()).collect();
        let start_land = land.iter().filter(|l| **l).count();
        if start_land == 0 {
            return Err(Error::parameter("sea_level", format!("{level} m"), "a level that leaves land"));
        }
        let rock = self.resistance.resolve("resistance", terrain, context)?;
        let material = (0..z.len()).map(|i| rock.at(i) * context.seed.uniform(i as u64)).collect();
        let resolve = |v: &landform_core::verb::Varying<_>, name: &str| v.resolve(name, terrain, context);
        let mut state = State {
            sea_level: level,
            land,
            material,
            age: vec![0; z.len()],
            start_length: 0.0,
            start_land,
            left: start_land,
            rests: false,
            force: resolve(&self.force, "force")?,
            damping: resolve(&self.damping, "damping")?,
            wear: resolve(&self.wear, "wear")?,
            weakening: resolve(&self.weakening_factor, "weakening_factor")?,
            front: None,
        };
        if matches!(self.until, Until::Stable(_)) && state.wear.max() > 0.0 {
            return Err(Error::parameter(
                "until",
                "\"stable\" with `wear`",
                "{ land = 0.6 }: a coast that wears never rests",
            ));
        }
        let front = self.front(terrain, state.land.clone(), state.material.clone(), None)?;
        if front.is_done() {
            return Err(Error::parameter("sea_level", format!("{level} m"), "a level at which the sea reaches land"));
        }
        state.start_length = front.start_length;
        state.front = Some(front);
        Ok(state)
    }

    fn is_at_rest(&self, _: &HeightField, state: &State) -> bool {
        let enough = match self.until {
            Until::Stable(_) => false,
            Until::Land { land } => state.left as f64 <= land * state.start_land as f64,
        };
        state.rests || enough
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        // Land and material move between the state, which a checkpoint holds, and the front, which it does not.
        let (land, material) = (std::mem::take(&mut state.land), std::mem::take(&mut state.material));
        let mut front = match state.front.take() {
            Some(mut front) => {
                (front.land, front.material) = (land, material);
                front
            }
            None => self.front(terrain, land, material, Some(state.start_length))?,
        };
        let amount = self.weakening.map_or(0.0, |w| w.amount);
        let drive = Drive {
            force: &|i| state.force.at(i),
            damping: &|i| state.damping.at(i),
            wear: &|i| state.wear.at(i),
            weakening: &|i| amount * state.weakening.at(i),
        };
        let round = front.round(&drive);
        state.left -= round.fallen.len();
        state.rests = front.is_done() || round.fallen.is_empty() && state.wear.max() == 0.0;
        let (floor, area) = (state.sea_level - self.depth.si(), terrain.grid().cell_area());
        let mut eroded = 0.0;
        for &site in &round.fallen {
            state.age[site] = (at.index + 1).min(u64::from(u32::MAX)) as u32;
        }
        terrain.change(Layer::Surface("sediment"), |z| {
            for &site in &round.fallen {
                let new = z[site].min(floor);
                eroded += z[site] - new;
                z[site] = new;
            }
        });
        state.land = std::mem::take(&mut front.land);
        state.material = std::mem::take(&mut front.material);
        state.front = Some(front);
        Ok(Change { eroded: eroded * area, exported: eroded * area, ..Change::default() })
    }

    fn finish(&self, terrain: &mut HeightField, state: &mut State, _: &Environment) -> Result<()> {
        terrain.fields_mut().insert(&names::SHORE_AGE, state.age.clone())
    }
}
