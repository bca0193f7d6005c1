//! Stream-power erosion and deposition.
//!
//! Rivers lower their beds at a rate set by drainage area and slope, and may deposit the sediment
//! that they carry. Hillslopes cannot stand steeper than the talus angle.
//!
//! # Model
//! ∂z/∂t = −K Aᵐ Sⁿ/(1 − S/S_d) + (G/A) Q, with S the slope to the receiver and Q the sediment
//! flux; base levels are held. Where S ≪ S_d it is the law of rivers; steep heads of valleys
//! approach S_d and stay gullies, rather than planes of one angle. With it A is at least 5,000 m²,
//! so that slopes do not grow as cells shrink.
//!
//! | symbol | here | unit | meaning |
//! |---|---|---|---|
//! | K | `erodibility` | m^(1−2m)/s (n = 1) | how easily the bed is cut |
//! | A | drainage area | m² | weighted by rainfall over 1 m/yr, if rainfall is given |
//! | m, n | `area_exponent`, `slope_exponent` | – | exponents |
//! | G | `deposition` | – | how readily sediment settles |
//! | S_d | `limiting_slope` | – | slope that ground does not exceed |
//! | α | `talus_angle` | rad | steepest stable slope |
//!
//! # Method
//! Receivers, lakes through their passes, order and area by [`Flow`], over the surface at the start
//! of the step: uplift of a long step, with base levels held, would bend the flow near them. Base
//! levels are put back to their elevation; then from the outlets upwards z ← (z + f z_r)/(1 + f),
//! f = K Δt Aᵐ/L, with the receiver's *new* elevation (n = 1; a guarded Newton iteration
//! otherwise), and z ≤ z_r + L tan α. First order in time and space, stable for any Δt, O(n). It
//! smears knickpoints; for n = 1 the scheme along [`characteristics`] does not.
//! Ground under a lake's surface, which stands at or below its receiver, is left alone. With
//! deposition, one linear system on the tree of rivers ([`yuan_2019`]).
//!
//! With a limiting slope the step at a node is the root of a quadratic for n = 1: x + f x/(1 −
//! x/(S_d L)) = drop.
//!
//! Nodes of a raster stand off the centres of their cells while a recipe runs ([`Lattice`]).
//!
//! On layered ground a step wears through strata one after the other, each with its own
//! erodibility, and slopes stand at the angle of repose of each stratum ([`rock`]): resistant beds
//! become ledges and caps.
//!
//! With outlets "sea" every node at or under sea level at the start of a step is an outlet in that
//! step. Such a node is not held, so that uplift and subsidence move the shore. Rivers end at the
//! surface of the water, not at its floor.
//!
//! # Limits
//! Each node has one receiver (only drainage area can be shared). Sediment that reaches the sea or
//! the border leaves the domain. On a regular raster drainage area follows eight directions.
//!
//! # Sources
//! Braun & Willett (2013), eqs. 12–16 and 22–24; Cordonnier et al. (2019) for lakes; Yuan et al.
//! (2019) for deposition; Stock & Dietrich (2003) and McGuire et al. (2023) for the form of valleys
//! where debris flows, which the limiting slope gives at a steady state, S = S_d/(1 + (K S_d/U)
//! Aᵐ); Bell (2024), eqs. 3.5–3.7 and algorithm 8 for rainfall, which we measure in 1 m/yr. The
//! thesis' listing updates children from the receiver's old elevation, which is not the scheme that
//! it states (validation notes 3.3).
//!
//! # Checked by
//! `tests`: slope–area at every node (SP1, SP2), χ-linearity (SP3), the river of Hack's law (SP4),
//! knickpoints (SP5; sharp within a cell and a tenth of their time), z ∝ U/K (SP6, SP7), one long
//! step = steady state (SP8), order in time (SP9), rescaling (SP10), mass (SP11), (1 + G), the sea.
//!
//! # Example
//! On a ramp that falls to the east every row is a river. At the steady state S √A = U/K. Here U/K
//! is 1 mm/yr over 1e-5 1/yr: 100 m.
//!
//! ```
//! # use landform_core::{grid::{Edge, Edges, Grid, Shape}, sim::Model, terrain::{HeightField, NodeSurface}};
//! use landform_core::units::{Erodibility, MYR, Rate};
//! use landform_process::{stream_power::StreamPower, uplift::Uplift};
//!
//! # let mut grid = Grid::new(Shape::new(3, 4), [100.0, 100.0])?;
//! # grid.edges = Edges { east: Edge::Open, ..Edges::all(Edge::Closed) };
//! let ramp = HeightField::new(grid, [3.0, 2.0, 1.0, 0.0].repeat(3))?;
//! let mut model = Model::new(ramp).dt(10.0 * MYR);
//! model.add(Uplift { rate: Rate::of(1.0).into() })?;
//! let rock = Some(Erodibility::of(1e-5).into());
//! model.add(StreamPower { erodibility: rock, limiting_slope: Some(0.0), ..StreamPower::default() })?;
//! model.advance_steps(10)?;
//! let z = model.terrain().elevation();
//! let (slope, area) = ((z[6] - z[7]) / 100.0, 3e4_f64);
//! assert!((slope * area.sqrt() - 100.0).abs() < 1e-3);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod braun_willett_2013;
mod characteristics;
mod law;
mod params;
mod rock;
mod talus;
#[cfg(test)]
mod tests;
mod yuan_2019;

use std::sync::Arc;

use landform_core::algo::flow::Flow;
use landform_core::algo::outlets::at_or_under;
use landform_core::field::names;
use landform_core::grid::{Domain, NO_SLOT, Status};
use landform_core::terrain::{HeightField, Layer, Layers, Mesh, NodeSurface};
use landform_core::units::{MYR, YEAR};
use landform_core::verb::{Change, Context, Environment, Process, Resolved, Step, Varying};
use landform_core::{Error, Result, parallel};
use serde::{Deserialize, Serialize};

use crate::mechanism::{
    add_to_incision, add_to_sums, begin_sums, write_channel_steepness_fields, write_drainage_fields,
};
use braun_willett_2013::sweep;
use characteristics::Waves;
pub use params::{Scheme, StreamPower};

pub use crate::mechanism::Lattice;
use rock::{Rock, sweep_layers};
use yuan_2019::Sediment;

landform_core::stages! {
    process StreamPower where HeightField, Mesh;
}

/// Parameters on the nodes, base levels, and scratch.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(bound = "")]
pub struct State<D> {
    /// Erodibility of the parameter, by weakness.
    erodibility: Resolved,
    /// How many times as fast rock wears.
    weakness: Option<Resolved>,
    /// Rainfall over its mean; none where it is uniform.
    rain: Option<Vec<f64>>,
    /// Rainfall in the last step, where it changes in time, m/s.
    rain_now: Option<f64>,
    /// Nodes held at a base level, and the level, m; none with outlets at the sea.
    base: Vec<(u32, f64)>,
    /// Level of the sea after the last step, m.
    sea_level: f64,
    /// Level of the sea when base levels were taken, m.
    sea_start: f64,
    #[serde(skip)]
    scratch: Scratch<D>,
}

#[derive(Clone, Debug)]
struct Scratch<D> {
    domain: Option<Arc<D>>,
    flow: Flow,
    /// Drainage area, weighted by rainfall, until the step; then what nodes were lowered by, m.
    amount: Vec<f64>,
    sediment: Sediment,
    /// Of the sharp scheme.
    waves: Waves,
    /// The last step, s; none before the first.
    dt: Option<f64>,
}

impl<D> Default for Scratch<D> {
    fn default() -> Self {
        Self {
            domain: None,
            flow: Flow::new(),
            amount: Vec::new(),
            sediment: Sediment::default(),
            waves: Waves::default(),
            dt: None,
        }
    }
}

impl<D: Domain> State<D> {
    fn prepare<T: NodeSurface<Domain = D>>(&mut self, params: &StreamPower, terrain: &T) -> Arc<D> {
        if let Some(domain) = &self.scratch.domain {
            return domain.clone();
        }
        let domain = terrain.domain();
        self.scratch.flow = Flow::by(params.descent);
        self.scratch.domain = Some(domain.clone());
        domain
    }
}

impl<T: NodeSurface> Process<T> for StreamPower {
    const WRITES: &'static [&'static str] = &[
        "elevation",
        "basin",
        "channel_slope",
        "chi",
        "deposition",
        "drainage_area",
        "erosion_rate",
        "incision",
        "lake_depth",
        "rainfall",
        "receiver",
    ];
    type State = State<T::Domain>;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<Self::State> {
        if self.is_sharp() && terrain.layers().is_some() {
            let expected = "\"implicit\", which wears through layers";
            return Err(Error::parameter("scheme", "\"sharp\" on layered ground", expected));
        }
        let erodibility = match &self.erodibility {
            Some(given) => given.resolve("erodibility", terrain, context)?,
            None => Resolved::Uniform(StreamPower::usual_erodibility().si()),
        };
        let erodibility = erodibility.at_least_zero("erodibility")?;
        let weakness = match &self.weakness {
            Some(given) => Some(given.resolve("weakness", terrain, context)?.at_least_zero("weakness")?),
            None => None,
        };
        let erodibility = weakened(erodibility, weakness.as_ref(), terrain.elevation().len());
        let sea_level = self.sea_at(context.time, context.environment).unwrap_or(0.0);
        if let Some(outlets) = &self.outlets {
            outlets.apply(terrain, sea_level, context)?;
        }
        let base = if self.ends_in_sea() { nodes_below_sea(terrain) } else { base_levels(terrain)? };
        let rain = match self.rainfall.as_ref().or(context.environment.rainfall.as_ref()) {
            // Its weight is found in every step.
            Some(Varying::InTime(_)) => None,
            Some(rainfall) => {
                let rain = rainfall.resolve("rainfall", terrain, context)?;
                let relative = relative_rain(&rain, &*terrain.domain())?;
                let all = parallel::map(terrain.elevation().len(), |i| rain.at(i));
                terrain.fields_mut().insert(&names::RAINFALL, all)?;
                relative
            }
            None => None,
        };
        begin_sums(terrain)?;
        Ok(State {
            erodibility,
            weakness,
            rain,
            rain_now: None,
            base,
            sea_level,
            sea_start: sea_level,
            scratch: Scratch::default(),
        })
    }

    fn begin(&self, terrain: &T, state: &mut Self::State, at: &Step) -> Result<()> {
        let mut domain = state.prepare(self, terrain);
        if self.ends_in_sea() {
            // The only other owner is the state itself, so nothing is copied after the first step.
            state.scratch.domain = None;
            let status = at_or_under(state.sea_level, terrain);
            if !status.contains(&Status::BaseLevel) {
                return Err(no_sea_error(state.sea_level, at));
            }
            Arc::make_mut(&mut domain).set_status(status);
            state.scratch.domain = Some(domain.clone());
        }
        let rainfall = self.rainfall.as_ref().or(at.environment.rainfall.as_ref());
        state.rain_now = rainfall.and_then(|rain| rain.in_time(at.time, at.time + at.dt));
        let share = state.rain_now.map_or(1.0, |rain| (rain / REFERENCE_RAIN).max(0.0));
        let Scratch { flow, amount, waves, .. } = &mut state.scratch;
        if self.is_sharp() {
            waves.start.clear();
            waves.start.extend_from_slice(terrain.elevation());
        }
        amount.resize(terrain.elevation().len(), 0.0);
        let (rain, status) = (&state.rain, domain.status());
        let rained = |amount: &mut [f64]| {
            parallel::fill(amount, |i| match rain {
                _ if status[i] == Status::Masked => 0.0,
                Some(rain) => domain.area(i) * rain[i] * share,
                None => domain.area(i) * share,
            });
        };
        rained(amount);
        flow.route(&*domain, terrain.elevation(), amount);
        if let Some(exponent) = self.multiple_flow {
            rained(amount);
            flow.accumulate_multiple(&*domain, terrain.elevation(), exponent, amount);
        }
        if self.specific_area {
            parallel::update(amount, |i, a| *a /= domain.area(i).sqrt());
        }
        Ok(())
    }

    fn step(&self, terrain: &mut T, state: &mut Self::State, at: &Step) -> Result<Change> {
        let domain = state.prepare(self, terrain);
        let sea = self.sea_at(at.time + at.dt, &at.environment);
        let risen = sea.map_or(0.0, |now| now - state.sea_start);
        if let Some(now) = self.erodibility.as_ref().and_then(|k| k.in_time(at.time, at.time + at.dt)) {
            let nodes = terrain.elevation().len();
            state.erodibility = weakened(Resolved::Uniform(now), state.weakness.as_ref(), nodes);
        }
        let Scratch { flow, amount, sediment, waves, dt, .. } = &mut state.scratch;
        *dt = Some(at.dt);
        let floor = if self.ends_in_sea() { state.sea_level } else { f64::NEG_INFINITY };
        let law = self.law(floor, at.dt, terrain.layers().is_some());
        let (base, erodibility, weakness) = (&state.base, &state.erodibility, state.weakness.as_ref());
        let by_material = self.erodibility.is_none();
        // Layers are read while elevations are found, and follow afterwards; without layers
        // elevations change in place.
        let mut work = |z: &mut [f64], layers: Option<&Layers>| {
            let mut change = hold_base_level(z, &*domain, base, risen);
            let rock = Rock { erodibility, layers, weakness, by_material };
            if self.deposition > 0.0 {
                change = change.plus(sediment.sweep(&*domain, flow, &law, &rock, amount, z));
            } else {
                match layers {
                    Some(layers) => sweep_layers(&*domain, flow, &law, &rock, layers, amount, z),
                    None if self.is_sharp() => waves.sweep(&*domain, flow, &law, &rock, amount, z),
                    None => sweep(&*domain, flow, &law, &rock, amount, z),
                }
            }
            if self.deposition == 0.0 {
                let lowered = lowered(&*domain, flow, amount);
                change.eroded += lowered;
                change.exported += lowered;
            }
            change
        };
        let change = match terrain.layers() {
            None => terrain.change(LAID, |z| work(z, None)),
            Some(layers) => {
                let mut z = terrain.elevation().to_vec();
                let change = work(&mut z, Some(layers));
                terrain.change(LAID, |old| old.copy_from_slice(&z));
                change
            }
        };
        let lowered = &state.scratch.amount;
        if self.deposition > 0.0 {
            add_to_sums(terrain, lowered)
        } else {
            add_to_incision(terrain, lowered)
        }
        state.sea_level = sea.unwrap_or(0.0);
        Ok(change)
    }

    fn note(&self, terrain: &T, state: &Self::State) -> Option<String> {
        let domain = state.scratch.domain.as_ref()?;
        talus::note(self.talus_angle?, &**domain, &state.scratch.flow, terrain.elevation())
    }

    fn finish(&self, terrain: &mut T, state: &mut Self::State, _: &Environment) -> Result<()> {
        let mut domain = state.prepare(self, terrain);
        if self.ends_in_sea() {
            let status = at_or_under(state.sea_level, terrain);
            terrain.set_status(Some(status));
            domain = terrain.domain();
        }
        let flow = &mut state.scratch.flow;
        write_drainage_fields(terrain, &domain, flow, self.ends_in_sea().then_some(state.sea_level))?;
        write_channel_steepness_fields(terrain, &domain, flow, self.area_exponent / self.slope_exponent)?;
        if let Some(rain) = state.rain_now {
            let all = vec![rain; terrain.elevation().len()];
            terrain.fields_mut().insert(&names::RAINFALL, all)?;
        }
        if let Some(dt) = state.scratch.dt {
            let (lowered, status) = (&state.scratch.amount, domain.status());
            let rate = |i: usize| if status[i] == Status::Masked { f64::NAN } else { lowered[i] / dt };
            let rates = parallel::map(lowered.len(), rate);
            terrain.fields_mut().insert(&names::EROSION_RATE, rates)?;
        }
        Ok(())
    }
}

/// Erodibility of rock that wears `weakness` times as fast.
fn weakened(erodibility: Resolved, weakness: Option<&Resolved>, nodes: usize) -> Resolved {
    match (erodibility, weakness) {
        (erodibility, None) => erodibility,
        (Resolved::Uniform(k), Some(Resolved::Uniform(w))) => Resolved::Uniform(k * w),
        (k, Some(w)) => Resolved::PerNode(parallel::map(nodes, |i| k.at(i) * w.at(i))),
    }
}

/// Rainfall at which drainage area stands for discharge, m/s: 1 m/yr.
const REFERENCE_RAIN: f64 = 1.0 / YEAR;

/// The layer that rivers deposit.
const LAID: Layer = Layer::Surface("sediment");

fn no_sea_error(level: f64, at: &Step) -> Error {
    let when = format!("\"sea\", but after {:.4} Myr no ground is at or under {level} m", at.time / MYR);
    Error::parameter("outlets", when, "ground that stays under the sea (no uplift there), or outlets = \"border\"")
}

/// Lets every node move: at the sea nothing is held.
fn nodes_below_sea<T: NodeSurface>(terrain: &mut T) -> Vec<(u32, f64)> {
    let domain = terrain.domain();
    let loose =
        domain.status().iter().map(|&s| if s == Status::Masked { Status::Masked } else { Status::Interior }).collect();
    terrain.set_status(Some(loose));
    Vec::new()
}

fn base_levels<T: NodeSurface>(terrain: &T) -> Result<Vec<(u32, f64)>> {
    let domain = terrain.domain();
    let status = domain.status();
    let base: Vec<_> = (0..status.len())
        .filter(|&i| status[i] == Status::BaseLevel)
        .map(|i| (i as u32, terrain.elevation()[i]))
        .collect();
    if base.is_empty() {
        return Err(Error::parameter("outlets", "without a single node", "at least one node where water leaves"));
    }
    Ok(base)
}

/// Rainfall over [`REFERENCE_RAIN`]; none where it is that.
fn relative_rain<D: Domain>(rain: &Resolved, domain: &D) -> Result<Option<Vec<f64>>> {
    if matches!(rain, Resolved::Uniform(rain) if *rain == REFERENCE_RAIN) {
        return Ok(None);
    }
    let valid = |i: usize| domain.status()[i] != Status::Masked;
    let relative = parallel::map(domain.len(), |i| if valid(i) { rain.at(i) / REFERENCE_RAIN } else { 0.0 });
    if let Some(i) = parallel::find_first(relative.len(), |i| !(relative[i] >= 0.0)) {
        return Err(Error::AtNode { name: "rainfall".into(), node: i, value: rain.at(i), expected: "at least 0" });
    }
    if !(parallel::max(relative.len(), |i| relative[i]) > 0.0) {
        return Err(Error::parameter("rainfall", "0 everywhere", "rain somewhere"));
    }
    Ok(Some(relative))
}

/// The volume that was worn off, m³; `by` is what nodes were lowered by, m, which nodes without a
/// receiver were not.
fn lowered<D: Domain>(domain: &D, flow: &Flow, by: &mut [f64]) -> f64 {
    let slots = flow.slots();
    let pieces = parallel::map_pieces_mut([by], parallel::PIECE, |first, [piece]| {
        let mut volume = 0.0;
        for (k, by) in piece.iter_mut().enumerate() {
            *by = if slots[first + k] == NO_SLOT { 0.0 } else { *by };
            volume += *by * domain.area(first + k);
        }
        volume
    });
    pieces.into_iter().sum()
}

/// Puts base levels back to their elevation, `risen` since the start: material above it is carried
/// away, material below it is supplied.
fn hold_base_level<D: Domain>(z: &mut [f64], domain: &D, base: &[(u32, f64)], risen: f64) -> Change {
    let mut change = Change::default();
    for &(node, level) in base {
        let (node, level) = (node as usize, level + risen);
        let above = (z[node] - level) * domain.area(node);
        change.eroded += above.max(0.0);
        change.exported += above.max(0.0);
        change.supplied += (-above).max(0.0);
        z[node] = level;
    }
    change
}
