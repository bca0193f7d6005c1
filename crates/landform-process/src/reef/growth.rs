//! Growth of reefs as a process.

use landform_core::field::names;
use landform_core::grid::{Domain, Status};
use landform_core::terrain::NodeSurface;
use landform_core::verb::{Change, Context, Environment, Process, Resolved, Step};
use landform_core::{Error, Result, math, parallel};
use serde::{Deserialize, Serialize};

use super::labels::label;
use super::light::{Light, Water};
use super::open_water::{Shore, cell_width};
use super::params::ReefGrowth;
use super::talus::{Slipped, slip};
use super::{CORAL, SEDIMENT};

/// Restrictions from open water beyond which nothing grows: half a hundredth of the rate is left.
const FURTHEST: f64 = 5.3;

/// Part of a cell's width by which the sea may move over the ground before shelter is found anew
/// and slopes slip.
const STALE: f64 = 0.15;

/// Rates, the sea and shelter, and scratch.
///
/// ```
/// use landform_core::{terrain::HeightField, verb::Process};
/// use landform_process::reef::ReefGrowth;
///
/// fn state_of<P: Process<HeightField>>() -> &'static str {
///     std::any::type_name::<P::State>()
/// }
/// assert!(state_of::<ReefGrowth>().contains("reef"));
/// ```
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    max_rate: Resolved,
    /// Level of the sea after the last step, m.
    level: f64,
    shelter: Shelter,
    #[serde(skip)]
    scratch: Option<Scratch>,
}

/// Which nodes are open water and how far the others are from it, as it was last found.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
struct Shelter {
    open: Vec<bool>,
    /// Distance to open water, m.
    distance: Vec<f64>,
    /// Greatest way of the sea over the ground since then, m.
    moved: f64,
}

#[derive(Clone, Debug)]
struct Scratch {
    shore: Shore,
    /// Elevations at the start of the step, before any process, m.
    before: Vec<f64>,
}

/// What grew on a node in a step.
#[derive(Clone, Copy, Debug, Default)]
struct Grown {
    /// Height, m.
    height: f64,
    /// Height for which there was no room under low water, m.
    unused: f64,
}

impl ReefGrowth {
    /// The law of growth, as a part of the greatest rate.
    fn law(&self) -> Light {
        Light::new(1.0, self.light, self.saturation, self.extinction.si())
    }

    /// Finds shelter anew where ground or sea have moved so far that it may differ; whether it did.
    fn find_shelter<T: NodeSurface>(
        &self,
        terrain: &T,
        scratch: &Scratch,
        shelter: &mut Shelter,
        levels: [f64; 2],
    ) -> bool {
        let (domain, z) = (terrain.domain(), terrain.elevation());
        let rise = |i: usize| ((levels[1] - z[i]) - (levels[0] - scratch.before[i])).abs();
        shelter.moved += parallel::max(z.len(), rise).max(0.0);
        if shelter.open.len() == z.len() && shelter.moved < STALE * cell_width(&*domain, z) {
            return false;
        }
        let depth = |i: usize| levels[1] - z[i];
        shelter.open = scratch.shore.open(&*domain, depth, self.open_depth.si());
        let most = FURTHEST * self.restriction.si();
        shelter.distance = scratch.shore.distance(&*domain, depth, &shelter.open, most);
        shelter.moved = 0.0;
        true
    }

    /// Growth of all nodes; `rise` of the sea (m) from its level at the start to that at the end.
    fn grow<T: NodeSurface>(
        &self,
        terrain: &T,
        state: &State,
        before: &[f64],
        levels: [f64; 2],
        dt: f64,
    ) -> Vec<Grown> {
        let distance = &state.shelter.distance;
        let (domain, z, law) = (terrain.domain(), terrain.elevation(), self.law());
        let (restriction, low) = (self.restriction.si(), self.low_water.si());
        let status = domain.status();
        let depth = |i: usize| levels[1] - z[i];
        let surface = law.rate(low);
        parallel::map(z.len(), |i| {
            if status[i] != Status::Interior || distance[i] == f64::INFINITY {
                return Grown::default();
            }
            // Open water begins half-way to its nearest node.
            let inside = (distance[i] - 0.5 * domain.area(i).sqrt()).max(0.0);
            let shelter = if inside > 0.0 { math::exp(-inside / restriction) } else { 1.0 };
            let factor = shelter * state.max_rate.at(i).max(0.0);
            let start = levels[0] - before[i];
            let water = Water { depth: start, rise: depth(i) - start, low, factor, time: dt };
            let height = law.grown(&water);
            let is_full = (depth(i) - height - low).abs() < 1e-6;
            let unused = if is_full { (factor * surface * dt - height).max(0.0) } else { 0.0 };
            Grown { height, unused }
        })
    }

    /// Depths of sediment that settle in enclosed water when `supply` (m³) is shed, m.
    fn settle<T: NodeSurface>(&self, terrain: &T, open: &[bool], level: f64, supply: f64) -> Vec<f64> {
        let (domain, z) = (terrain.domain(), terrain.elevation());
        let status = domain.status();
        let room = |i: usize| {
            let is_lagoon = !open[i] && status[i] == Status::Interior;
            if is_lagoon { (level - z[i] - self.lagoon_depth.si()).max(0.0) } else { 0.0 }
        };
        let whole = parallel::sum(z.len(), |i| room(i) * domain.area(i));
        let part = if whole > supply { supply / whole } else { 1.0 };
        parallel::map(z.len(), |i| part * room(i))
    }
}

/// Depth of a layer on every node, m; 0 where there is none.
fn depth_of<T: NodeSurface>(terrain: &T, material: &str) -> Vec<f64> {
    terrain.depth(material).map_or_else(|| vec![0.0; terrain.elevation().len()], <[f64]>::to_vec)
}

impl<T: NodeSurface> Process<T> for ReefGrowth {
    const WRITES: &'static [&'static str] =
        &["elevation", "coral_depth", "labels", "sediment_depth", "surface_material"];
    type State = State;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<State> {
        let max_rate = self.max_rate.resolve("max_rate", terrain, context)?;
        terrain.make_layered(&context.environment.materials);
        let coral = depth_of(terrain, CORAL);
        terrain.change_depth(CORAL, &coral)?;
        let level = context.environment.level_or(self.sea_level, context.time);
        Ok(State { max_rate, level, shelter: Shelter::default(), scratch: None })
    }

    fn begin(&self, terrain: &T, state: &mut State, _: &Step) -> Result<()> {
        let z = terrain.elevation();
        match &mut state.scratch {
            Some(scratch) => scratch.before.copy_from_slice(z),
            none => *none = Some(Scratch { shore: Shore::of(terrain), before: z.to_vec() }),
        }
        Ok(())
    }

    fn step(&self, terrain: &mut T, state: &mut State, at: &Step) -> Result<Change> {
        if let Some(now) = self.max_rate.in_time(at.time, at.time + at.dt) {
            state.max_rate = Resolved::Uniform(now);
        }
        let levels = [at.time, at.time + at.dt].map(|time| at.environment.level_or(self.sea_level, time));
        state.level = levels[1];
        let domain = terrain.domain();
        let Some(scratch) = state.scratch.take() else { return Ok(Change::default()) };
        let is_stale = self.find_shelter(terrain, &scratch, &mut state.shelter, levels);
        let grown = self.grow(terrain, state, &scratch.before, levels, at.dt);
        if at.cancel.is_cancelled() {
            return Err(Error::Interrupted);
        }
        let (mut coral, mut z) = (depth_of(terrain, CORAL), terrain.elevation().to_vec());
        let volume = |of: &(dyn Fn(usize) -> f64 + Sync)| parallel::sum(grown.len(), |i| of(i) * domain.area(i));
        let built = volume(&|i| grown[i].height);
        let shed = self.shed.si() * volume(&|i| grown[i].unused);
        parallel::update(&mut coral, |i, c| *c += grown[i].height);
        parallel::update(&mut z, |i, z| *z += grown[i].height);
        let slope = math::tan(self.talus_angle.si());
        let slipped = if is_stale {
            slip(&*domain, scratch.shore.positions(), &mut z, &mut coral, levels[1], slope)
        } else {
            Slipped::default()
        };
        terrain.change_depth(CORAL, &coral)?;
        let mut supplied = built;
        if shed > 0.0 {
            let mut sediment = depth_of(terrain, SEDIMENT);
            let settled = self.settle(terrain, &state.shelter.open, levels[1], shed);
            supplied += volume(&|i| settled[i]);
            parallel::update(&mut sediment, |i, s| *s += settled[i]);
            terrain.change_depth(SEDIMENT, &sediment)?;
        }
        let raised = parallel::max(grown.len(), |i| grown[i].height).max(0.0);
        state.scratch = Some(scratch);
        let Slipped { eroded, deposited, exported } = slipped;
        Ok(Change { supplied, eroded, deposited, exported, raised, ..Change::default() })
    }

    fn finish(&self, terrain: &mut T, state: &mut State, _: &Environment) -> Result<()> {
        let shore = state.scratch.take().map_or_else(|| Shore::of(terrain), |scratch| scratch.shore);
        let coral = depth_of(terrain, CORAL);
        let parts = label(&shore, &*terrain.domain(), terrain.elevation(), &coral, state.level);
        terrain.fields_mut().insert(&names::LABELS, parts)
    }
}
