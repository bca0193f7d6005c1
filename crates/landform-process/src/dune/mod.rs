//! Dunes.
//!
//! # Model
//! Slabs of sand lie on hard ground. In a round the wind acts once on average on every site: if
//! sand lies there without shelter, a slab is lifted and hops downwind. Where it lands it stays for
//! certain in shelter, likely on sand, less likely on hard ground; else it hops on. Sand steeper
//! than the angle of repose slips. Shelter depends on the model: a shadow with `werner`, a cone
//! with `protection`, a wind field with `koh`.
//!
//! # Method
//! Heights are whole numbers of 1/64 slab, so sand is conserved exactly. Sites are drawn at random
//! within strips that fit in the cache. Shelter is found anew four times a round. Hops that are no
//! whole number of cells are rounded at random to either side. At the end slabs get finer, and
//! diffusion removes the grooves of the lattice.
//!
//! # Limits
//! Dunes have no least size: a cell should be 1 to 3 m, or dunes appear that do not occur in
//! nature. Thesis and erratum differ on a hop of length 0 (table 4.2): there is none here. Sand
//! slips to eight neighbours (Werner: four); along axes slopes do not exceed repose, diagonally
//! they may by up to half a slab.
//!
//! # Sources
//! Werner (1995); Pytel (2015), 4.1, in whose tables a site is taken to be 15 m wide: a slab of 5
//! is then a third of it, as in Werner; Koh (2002), 5.2.
//!
//! # Checked by
//! `tests`: sand kept, slopes, coarsening, bare ground, barchans' speed and shape, classes by wind,
//! grooves, Koh's wind.
//!
//! # Example
//! Wind moves sand. With periodic borders the amount of sand stays the same:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_process::dune::Dunes;
//!
//! let ground = HeightField::new(Grid::new(Shape::new(16, 16), [1.0, 1.0])?, vec![0.0; 256])?;
//! let mut model = Model::new(ground).dt(1e12);
//! model.add(Dunes::default())?;
//! let sand = |field: &HeightField| field.depth("sand").map_or(0.0, |d| d.iter().sum::<f64>());
//! model.start()?;
//! let before = sand(model.terrain());
//! model.advance_steps(3)?;
//! assert!(before > 0.0 && (sand(model.terrain()) - before).abs() < 1e-6);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod field;
mod koh;
mod params;
mod protection;
mod shelter;
mod slabs;
mod smooth;
#[cfg(test)]
mod tests;

use landform_core::Result;
use landform_core::field::names;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::{Change, Context, Environment, OwnClock, Process, Step};
use serde::{Deserialize, Serialize};

use field::Field;
pub use params::{Borders, Dunes, Model};
use protection::Protection;
use shelter::Shelter;

use crate::mechanism::within_map;

landform_core::stages! {
    process Dunes where HeightField;
}

/// Sand on its ground, and its shelter.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    field: Field,
    protection: Option<Protection>,
    /// Seed of the whole run: it draws the wind of several rounds, a spell.
    seed: Seed,
    /// Koh: strength of the wind.
    #[serde(skip)]
    air: Vec<f32>,
    /// Sand at the start of a step, units.
    #[serde(skip)]
    before: Vec<i32>,
}

impl Process<HeightField> for Dunes {
    const WRITES: &'static [&'static str] = &["elevation", "sand_depth", "shelter", "surface_material", "wind"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        // The length of a round follows from the cells, by `max_step`.
        Some(OwnClock { dt: 1e12, rounds: self.iterations + self.fine_rounds(), is_timed: true })
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        if let Some(reach) = self.reach {
            within_map("reach", reach, terrain.grid())?;
        }
        let mut field = Field::lay(self, terrain, context)?;
        let rose = self.rose(context.environment)?;
        let is_protection = self.model == Model::Protection;
        let protection = is_protection.then(|| Protection::new(self, &rose, terrain.grid(), &field));
        terrain.make_layered(&context.environment.materials);
        field.write(terrain)?;
        Ok(State { field, protection, seed: context.seed, air: Vec::new(), before: Vec::new() })
    }

    fn max_step(&self, terrain: &HeightField, state: &State) -> Option<f64> {
        Some(self.round(terrain.grid(), state.field.slab()))
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        let State { field, protection, seed, air, before } = state;
        field.take_over(terrain);
        before.clear();
        before.extend(field.sand.depths());
        let rose = self.rose(&at.environment)?;
        let wind = rose.draw(seed.named("wind"), at.index / self.spell);
        let part = (at.dt / self.round(terrain.grid(), field.slab())).min(1.0);
        // Finer slabs belong to the end of a run of known length.
        let is_own = at.of == Some(self.iterations + self.fine_rounds());
        field.sand.set_slab(self.slab_units(if is_own { at.index } else { 0 }));
        // As sand is laid, before the first step, some may slide off the map.
        let at_first = field.newly_lost() as f64;
        match self.model {
            Model::Koh => koh::round(self, terrain.grid(), field, air, &rose, wind, part, at.seed),
            _ => slabs::round(self, terrain.grid(), field, protection.as_mut(), &rose, wind, part, at.seed),
        }
        let unit = field.unit * terrain.grid().cell_area();
        let (mut eroded, mut deposited) = (0u64, 0u64);
        for (old, new) in before.iter().zip(field.sand.depths()) {
            let d = new - old;
            deposited += u64::from(d.max(0) as u32);
            eroded += u64::from((-d).max(0) as u32);
        }
        let lost = field.newly_lost() as f64;
        field.write(terrain)?;
        Ok(Change {
            eroded: (eroded as f64 + at_first) * unit,
            deposited: deposited as f64 * unit,
            supplied: at_first * unit,
            exported: (at_first + lost) * unit,
            ..Change::default()
        })
    }

    fn finish(&self, terrain: &mut HeightField, state: &mut State, environment: &Environment) -> Result<()> {
        if self.smoothing > 0.0 {
            smooth::diffuse(terrain, &state.field, self.smoothing, self.borders == Borders::Periodic)?;
        }
        if self.model != Model::Koh {
            let shelter = self.shelter(terrain, state, environment)?;
            terrain.fields_mut().insert(&names::SHELTER, shelter)?;
        } else {
            let wind = state.air.iter().map(|&w| f64::from(w)).collect::<Vec<_>>();
            if wind.len() == terrain.grid().len() {
                terrain.fields_mut().insert(&names::WIND, wind)?;
            }
        }
        Ok(())
    }
}

impl Dunes {
    /// Fraction of the winds from which each site is sheltered by the model's own rule, on the sand
    /// as it lies.
    fn shelter(&self, terrain: &HeightField, state: &mut State, environment: &Environment) -> Result<Vec<f64>> {
        let State { field, protection, .. } = state;
        let rose = self.rose(environment)?;
        let total: f64 = rose.winds().iter().map(|w| w.weight).sum();
        let mut part = vec![0.0; terrain.grid().len()];
        for (k, wind) in rose.winds().iter().enumerate() {
            let shelter = Shelter::from(self, terrain.grid(), field, protection.as_mut(), (k, wind.towards()));
            shelter.find(field.sand.surface(), |first, are_sheltered| {
                for (part, &is_sheltered) in part[first..].iter_mut().zip(are_sheltered) {
                    *part += f64::from(u8::from(is_sheltered)) * wind.weight / total;
                }
            });
        }
        Ok(part)
    }
}
