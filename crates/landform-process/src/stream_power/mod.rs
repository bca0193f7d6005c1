//! Stream-power erosion and deposition.
//!
//! Rivers lower their beds at a rate set by drainage area and slope, and may lay down again what they carry; hillslopes cannot
//! stand steeper than the talus angle.
//!
//! # Model
//! ∂z/∂t = −K Aᵐ Sⁿ + (G/A) Q, with S the slope to the receiver and Q the sediment flux; base levels are held.
//!
//! | symbol | here | unit | meaning |
//! |---|---|---|---|
//! | K | `erodibility` | m^(1−2m)/s (n = 1) | how easily the bed is cut |
//! | A | drainage area | m² | weighted by rainfall over its mean, if rainfall is given |
//! | m, n | `area_exponent`, `slope_exponent` | – | exponents |
//! | G | `deposition` | – | how readily sediment settles |
//! | α | `talus_angle` | rad | steepest stable slope |
//!
//! # Method
//! Receivers, lakes through their passes, order and area by [`Flow`], over the surface at
//! the start of the step: uplift of a long step, with base levels held, would bend the flow near them. Base levels are put
//! back to their elevation; then from the outlets upwards z ← (z + f z_r)/(1 + f), f = K Δt Aᵐ/L, with the
//! receiver's *new* elevation (n = 1; a guarded Newton iteration otherwise), and z ≤ z_r + L tan α. First order in time and
//! space, stable for any Δt, O(n). Ground under a lake's surface, which stands at or below its receiver, is left alone.
//! With deposition, one linear system on the tree of rivers ([`yuan_2019`]).
//!
//! With outlets "sea" every node at or under sea level at the start of a step is an outlet in it; it is not held, so that
//! uplift and subsidence move the shore, and rivers end at the surface of the water, not at its floor.
//!
//! # Limits
//! One receiver a node (drainage area alone can be shared). What reaches the sea or the border leaves the domain. On a raster
//! drainage area follows eight directions.
//!
//! # Sources
//! Braun & Willett (2013), eqs. 12–16 and 22–24; Cordonnier et al. (2019) for lakes; Yuan et al. (2019) for deposition; Bell
//! (thesis), eqs. 3.5–3.7. The seed's listing updates children from the receiver's old elevation, which is not the scheme
//! that it states (validation notes 3.3).
//!
//! # Checked by
//! `tests`: slope–area at every node (SP1, SP2), χ-linearity (SP3), the river of Hack's law (SP4), knickpoints (SP5), z ∝ U/K
//! (SP6, SP7), one long step = steady state (SP8), order in time (SP9), rescaling (SP10), mass (SP11), (1 + G), the sea.

mod braun_willett_2013;
mod params;
#[cfg(test)]
mod tests;
mod yuan_2019;

use std::sync::Arc;

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::algo::outlets::at_or_under;
use landform_core::field::names;
use landform_core::grid::{BASE_LEVEL, Domain, INTERIOR, MASKED};
use landform_core::terrain::NodeSurface;
use landform_core::units::MYR;
use landform_core::verb::{Change, Context, Process, Resolved, Step};
use landform_core::{Error, Result, parallel};
use serde::{Deserialize, Serialize};

use crate::mechanism::{leave_drainage, leave_steepness};
use braun_willett_2013::sweep;
pub use params::StreamPower;
use yuan_2019::Sediment;

/// Parameters on the nodes, base levels, and scratch.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(bound = "")]
pub struct State<D> {
    erodibility: Resolved,
    /// Rainfall over its mean; none where it is uniform.
    rain: Option<Vec<f64>>,
    /// Nodes held at a base level, and the level, m; none with outlets at the sea.
    base: Vec<(u32, f64)>,
    /// Level of the sea after the last step, m.
    sea_level: f64,
    #[serde(skip)]
    scratch: Scratch<D>,
}

#[derive(Clone, Debug)]
struct Scratch<D> {
    domain: Option<Arc<D>>,
    flow: Flow,
    /// Area per node times relative rainfall.
    weight: Vec<f64>,
    /// Accumulated weight.
    amount: Vec<f64>,
    sediment: Sediment,
    /// Rate of lowering in the last step, m/s.
    erosion: Vec<f64>,
}

impl<D> Default for Scratch<D> {
    fn default() -> Self {
        Self {
            domain: None,
            flow: Flow::new(),
            weight: Vec::new(),
            amount: Vec::new(),
            sediment: Sediment::default(),
            erosion: Vec::new(),
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
        self.scratch.weight = node_areas(&*domain);
        if let Some(rain) = &self.rain {
            parallel::update(&mut self.scratch.weight, |i, w| *w *= rain[i]);
        }
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
        "drainage_area",
        "erosion_rate",
        "lake_depth",
        "rainfall",
        "receiver",
    ];
    type State = State<T::Domain>;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<Self::State> {
        let erodibility = self.erodibility.resolve("erodibility", terrain, context)?;
        if let Resolved::PerNode(k) = &erodibility
            && let Some(i) = parallel::find_first(k.len(), |i| k[i] < 0.0)
        {
            return Err(Error::parameter("erodibility", format!("negative at node {i}"), "at least 0 everywhere"));
        }
        if let Some(outlets) = &self.outlets {
            outlets.apply(terrain, self.sea_at(0.0).unwrap_or(0.0), context)?;
        }
        let base = if self.ends_in_sea() { afloat(terrain) } else { base_levels(terrain)? };
        let rain = match &self.rainfall {
            Some(rainfall) => {
                let rain = rainfall.resolve("rainfall", terrain, context)?;
                let relative = relative_rain(&rain, &*terrain.domain())?;
                let all = parallel::map(terrain.elevation().len(), |i| rain.at(i));
                terrain.fields_mut().insert(&names::RAINFALL, all);
                relative
            }
            None => None,
        };
        let sea_level = self.sea_at(0.0).unwrap_or(0.0);
        Ok(State { erodibility, rain, base, sea_level, scratch: Scratch::default() })
    }

    fn begin(&self, terrain: &T, state: &mut Self::State, at: &Step) -> Result<()> {
        let mut domain = state.prepare(self, terrain);
        if self.ends_in_sea() {
            // The only other owner is the state itself, so nothing is copied after the first step.
            state.scratch.domain = None;
            let status = at_or_under(state.sea_level, terrain);
            if !status.contains(&BASE_LEVEL) {
                return Err(the_sea_is_gone(state.sea_level, at));
            }
            Arc::make_mut(&mut domain).set_status(status);
            state.scratch.domain = Some(domain.clone());
        }
        let Scratch { flow, weight, amount, .. } = &mut state.scratch;
        amount.clone_from(weight);
        flow.route(&*domain, terrain.elevation(), amount);
        if let Some(exponent) = self.multiple_flow {
            amount.clone_from(weight);
            flow.accumulate_multiple(&*domain, terrain.elevation(), exponent, amount);
        }
        if self.specific_area {
            parallel::update(amount, |i, a| *a /= domain.area(i).sqrt());
        }
        Ok(())
    }

    fn step(&self, terrain: &mut T, state: &mut Self::State, at: &Step) -> Result<Change> {
        let domain = state.prepare(self, terrain);
        let risen = self.sea_at(at.time + at.dt).zip(self.sea_at(0.0)).map_or(0.0, |(now, then)| now - then);
        let mut change = hold_base_level(terrain, &*domain, &state.base, risen);
        let Scratch { flow, amount, sediment, erosion, .. } = &mut state.scratch;
        let floor = if self.ends_in_sea() { state.sea_level } else { f64::NEG_INFINITY };
        let law = self.law(floor, at.dt);
        let z = terrain.elevation_mut();
        erosion.clear();
        if at.may_be_last {
            erosion.extend_from_slice(z);
        }
        if self.deposition > 0.0 {
            change = change.plus(sediment.sweep(&*domain, flow, &law, &state.erodibility, amount, z));
        } else {
            let eroded = sweep(&*domain, flow, &law, &state.erodibility, amount, z);
            change.eroded += eroded;
            change.exported += eroded;
        }
        parallel::update(erosion, |i, e| *e = (*e - z[i]) / at.dt);
        state.sea_level = self.sea_at(at.time + at.dt).unwrap_or(0.0);
        Ok(change)
    }

    fn finish(&self, terrain: &mut T, state: &mut Self::State) -> Result<()> {
        let mut domain = state.prepare(self, terrain);
        if self.ends_in_sea() {
            let status = at_or_under(state.sea_level, terrain);
            terrain.set_status(Some(status));
            domain = terrain.domain();
        }
        let flow = &mut state.scratch.flow;
        leave_drainage(terrain, &domain, flow, self.ends_in_sea().then_some(state.sea_level));
        leave_steepness(terrain, &domain, flow, self.area_exponent / self.slope_exponent);
        let erosion = std::mem::take(&mut state.scratch.erosion);
        if !erosion.is_empty() {
            terrain.fields_mut().insert(&names::EROSION_RATE, erosion);
        }
        Ok(())
    }
}

fn the_sea_is_gone(level: f64, at: &Step) -> Error {
    let when = format!("\"sea\", but after {:.4} Myr no ground is at or under {level} m", at.time / MYR);
    Error::parameter("outlets", when, "ground that stays under the sea (no uplift there), or outlets = \"border\"")
}

/// Lets every node move: at the sea nothing is held.
fn afloat<T: NodeSurface>(terrain: &mut T) -> Vec<(u32, f64)> {
    let domain = terrain.domain();
    let loose = domain.status().iter().map(|&s| if s == MASKED { MASKED } else { INTERIOR }).collect();
    terrain.set_status(Some(loose));
    Vec::new()
}

fn base_levels<T: NodeSurface>(terrain: &T) -> Result<Vec<(u32, f64)>> {
    let domain = terrain.domain();
    let status = domain.status();
    let base: Vec<_> =
        (0..status.len()).filter(|&i| status[i] == BASE_LEVEL).map(|i| (i as u32, terrain.elevation()[i])).collect();
    if base.is_empty() {
        return Err(Error::parameter("outlets", "without a single node", "at least one node where water leaves"));
    }
    Ok(base)
}

/// Rainfall over its area-weighted mean, so that erodibility keeps its meaning; none where it is uniform.
fn relative_rain<D: Domain>(rain: &Resolved, domain: &D) -> Result<Option<Vec<f64>>> {
    let rain = match rain {
        Resolved::Uniform(rain) if *rain > 0.0 => return Ok(None),
        Resolved::Uniform(_) => return Err(Error::parameter("rainfall", "0 everywhere", "rain somewhere")),
        Resolved::PerNode(rain) => rain,
    };
    let areas = node_areas(domain);
    let valid = |i: usize| domain.status()[i] != MASKED;
    if let Some(i) = parallel::find_first(rain.len(), |i| valid(i) && rain[i] < 0.0) {
        return Err(Error::parameter("rainfall", format!("negative at node {i}"), "at least 0 everywhere"));
    }
    let total = parallel::sum(rain.len(), |i| if valid(i) { rain[i] * areas[i] } else { 0.0 });
    let mean = total / parallel::sum(areas.len(), |i| areas[i]);
    if !(mean > 0.0) {
        return Err(Error::parameter("rainfall", "0 everywhere", "rain somewhere"));
    }
    Ok(Some(parallel::map(rain.len(), |i| if valid(i) { rain[i] / mean } else { 0.0 })))
}

/// Puts base levels back to their elevation, `risen` since the start; what was above is carried away, what was below is supplied.
fn hold_base_level<T: NodeSurface>(terrain: &mut T, domain: &T::Domain, base: &[(u32, f64)], risen: f64) -> Change {
    let mut change = Change::default();
    let z = terrain.elevation_mut();
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
