//! Stream-power incision.
//!
//! Rivers lower their beds at a rate set by drainage area and slope; hillslopes cannot stand steeper than the talus angle.
//!
//! # Model
//! ∂z/∂t = −K Aᵐ Sⁿ, with S the slope to the receiver; base levels are held.
//!
//! | symbol | here | unit | meaning |
//! |---|---|---|---|
//! | K | `erodibility` | m^(1−2m)/s (n = 1) | how easily the bed is cut |
//! | A | drainage area | m² | weighted by rainfall over its mean, if rainfall is given |
//! | m, n | `area_exponent`, `slope_exponent` | – | exponents |
//! | α | `talus_angle` | rad | steepest stable slope |
//!
//! # Method
//! Receivers, lakes through their passes, order and area by [`Flow`], over the surface at
//! the start of the step: uplift of a long step, with base levels held, would bend the flow near them. Base levels are put
//! back to their elevation; then from the outlets upwards z ← (z + f z_r)/(1 + f), f = K Δt Aᵐ/L, with the
//! receiver's *new* elevation (n = 1; a guarded Newton iteration otherwise), and z ≤ z_r + L tan α. First order in time and
//! space, stable for any Δt, O(n). Ground under a lake's surface, which stands at or below its receiver, is left alone.
//!
//! # Limits
//! Detachment-limited: what is cut leaves the domain. One receiver a node. On a raster drainage area follows eight directions.
//!
//! # Sources
//! Braun & Willett (2013), eqs. 12–16 and 22–24; Cordonnier et al. (2019) for lakes; Bell (thesis), eqs. 3.5–3.7. The seed's
//! listing updates children from the receiver's old elevation, which is not the scheme that it states; its equation 3.7 is a
//! rate law where its code is the clamp that is built here (validation notes 3.3).
//!
//! # Checked by
//! `tests`: slope–area at every node (SP1), χ-linearity (SP3), z ∝ U/K (SP6), one long step = steady state (SP8), mass (SP11).

mod braun_willett_2013;
mod params;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::grid::{BASE_LEVEL, Domain, MASKED};
use landform_core::terrain::NodeSurface;
use landform_core::verb::{Change, Context, Process, Resolved, Step};
use landform_core::{Error, Result, parallel};
use serde::{Deserialize, Serialize};

use crate::mechanism::leave_drainage;
use braun_willett_2013::{Law, sweep};
pub use params::StreamPower;

/// Parameters on the nodes, base levels, and scratch.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(bound = "")]
pub struct State<D> {
    erodibility: Resolved,
    /// Rainfall over its mean; none where it is uniform.
    rain: Option<Vec<f64>>,
    /// Nodes held at a base level, and the level, m.
    base: Vec<(u32, f64)>,
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
}

impl<D> Default for Scratch<D> {
    fn default() -> Self {
        Self { domain: None, flow: Flow::new(), weight: Vec::new(), amount: Vec::new() }
    }
}

impl<D: Domain> State<D> {
    fn prepare<T: NodeSurface<Domain = D>>(&mut self, terrain: &T) -> Arc<D> {
        if let Some(domain) = &self.scratch.domain {
            return domain.clone();
        }
        let domain = terrain.domain();
        self.scratch.weight = node_areas(&*domain);
        if let Some(rain) = &self.rain {
            parallel::update(&mut self.scratch.weight, |i, w| *w *= rain[i]);
        }
        self.scratch.domain = Some(domain.clone());
        domain
    }
}

impl<T: NodeSurface> Process<T> for StreamPower {
    const WRITES: &'static [&'static str] = &["elevation", "basin", "drainage_area", "lake_depth", "receiver"];
    type State = State<T::Domain>;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<Self::State> {
        let erodibility = self.erodibility.resolve("erodibility", terrain, context)?;
        if let Resolved::PerNode(k) = &erodibility
            && let Some(i) = parallel::find_first(k.len(), |i| k[i] < 0.0)
        {
            return Err(Error::parameter("erodibility", format!("negative at node {i}"), "at least 0 everywhere"));
        }
        if let Some(outlets) = &self.outlets {
            outlets.apply(terrain);
        }
        let domain = terrain.domain();
        let rain = match &self.rainfall {
            Some(rainfall) => relative_rain(&rainfall.resolve("rainfall", terrain, context)?, &*domain)?,
            None => None,
        };
        let status = domain.status();
        let base: Vec<_> = (0..status.len())
            .filter(|&i| status[i] == BASE_LEVEL)
            .map(|i| (i as u32, terrain.elevation()[i]))
            .collect();
        if base.is_empty() {
            return Err(Error::parameter("outlets", "without a single node", "at least one node where water leaves"));
        }
        Ok(State { erodibility, rain, base, scratch: Scratch::default() })
    }

    fn begin(&self, terrain: &T, state: &mut Self::State) -> Result<()> {
        let domain = state.prepare(terrain);
        let Scratch { flow, weight, amount, .. } = &mut state.scratch;
        amount.clone_from(weight);
        flow.route(&*domain, terrain.elevation(), amount);
        Ok(())
    }

    fn step(&self, terrain: &mut T, state: &mut Self::State, at: &Step) -> Result<Change> {
        let domain = state.prepare(terrain);
        let mut change = hold_base_level(terrain, &*domain, &state.base);
        let Scratch { flow, amount, .. } = &mut state.scratch;
        let law = Law {
            area_exponent: self.area_exponent,
            slope_exponent: self.slope_exponent,
            greatest_slope: self.greatest_slope(),
            dt: at.dt,
        };
        let eroded = sweep(&*domain, flow, &law, &state.erodibility, amount, terrain.elevation_mut());
        change.eroded += eroded;
        change.exported += eroded;
        Ok(change)
    }

    fn finish(&self, terrain: &mut T, state: &mut Self::State) -> Result<()> {
        let domain = state.prepare(terrain);
        leave_drainage(terrain, &domain, &mut state.scratch.flow);
        Ok(())
    }
}

/// Rainfall over its area-weighted mean, so that erodibility keeps its meaning; none where it is uniform.
fn relative_rain<D: Domain>(rain: &Resolved, domain: &D) -> Result<Option<Vec<f64>>> {
    let Resolved::PerNode(rain) = rain else { return Ok(None) };
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

/// Puts base levels back to their elevation; what was above is carried away, what was below is supplied.
fn hold_base_level<T: NodeSurface>(terrain: &mut T, domain: &T::Domain, base: &[(u32, f64)]) -> Change {
    let mut change = Change::default();
    let z = terrain.elevation_mut();
    for &(node, level) in base {
        let node = node as usize;
        let above = (z[node] - level) * domain.area(node);
        change.eroded += above.max(0.0);
        change.exported += above.max(0.0);
        change.supplied += (-above).max(0.0);
        z[node] = level;
    }
    change
}
