//! Channels that running water cuts, with their width, and lakes that break through.
//!
//! # Model
//! In each round a year of rain runs off ([`crate::mechanism::water`]). The water that passes a
//! node erodes it ([`wear`]). A river also erodes the ground uphill beside it ([`mod@banks`]), so
//! that large rivers widen and capture streams near them. Depressions fill, spill, and drain as
//! their outlets are cut; this needs no rule of its own.
//!
//! # Method
//! First water, then erosion, both on the ground at the start of the round. With a graded slope the
//! water carries the sediment on, and it settles ([`sediment`]). Rounds are not years of erosion:
//! the weights say how much a round erodes. Flow is a mean over the last rounds, in which each
//! round counts half as much as the next, so that threads which shift in a wide bed erode all of
//! it.
//!
//! **Cost** the water of a round on a million nodes takes some 0.07 s without lakes, and 0.3 s if a
//! quarter of them is under lakes; wear is a fixed number of passes.
//!
//! Open borders are eroded like any node: the ground beyond is taken to fall as steeply as the map
//! does on the whole, down to its lowest elevation at the start. Outlets that are chosen are held.
//!
//! # Limits
//! Water does not seep, and lakes do not freeze.
//!
//! # Sources
//! Pytel (2015), 4.3; each module names its own.
//!
//! # Checked by
//! `tests`: never up (without sediment, with smoothing in channels only), fans and filled
//! depressions, lakes that break through, capture, width against flow, threads.

mod banks;
mod engine;
mod params;
mod sediment;
#[cfg(test)]
mod tests;
mod ways;
mod wear;

use std::borrow::Cow;
use std::sync::Arc;

use landform_core::field::names;
use landform_core::grid::{Domain, Grid, RasterDomain, Side, Status};
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::{Length, YEAR};
use landform_core::verb::{Change, Context, OwnClock, Process, Resolved, Step};
use landform_core::{Error, Result, parallel};
use serde::{Deserialize, Serialize};

use banks::{Bank, River, banks};
use engine::Water;
pub use params::{ChannelErosion, Inflow, Smoothing, Spring, Transport};
use sediment::Sediment;
use wear::{Ground, Weights, eroded_bed, uplift};

use crate::mechanism::{add_to_sums, begin_sums, within_map};

landform_core::stages! {
    process ChannelErosion where HeightField;
}

/// Half-widths of the greatest river along the map's longer side.
const RADII_ACROSS: f64 = 40.0;
/// Elevations beyond this hold no depths of a micrometre, m.
const HIGHEST: f64 = 1e9;
/// Standing water thinner than this does not count, m: heights are less exact than that.
const FILM: f64 = 1e-6;

/// Water between rounds, what feeds it, and scratch.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    water: Water,
    /// Water that comes to each node in every round, m/s.
    rate: Vec<f64>,
    /// Springs that run in some rounds only.
    timed: Vec<TimedSpring>,
    /// Sinkholes.
    sinks: Vec<bool>,
    softness: Resolved,
    /// The lowest elevation at the start, m.
    bottom: f64,
    /// Slope of the ground beyond the open border; none where base levels are held.
    beyond: Option<f64>,
    /// Sediment that is carried; none if all of it leaves the map.
    sediment: Option<Sediment>,
    /// By which seed the places where water runs lie off the centres of the cells; none if it runs
    /// over the centres.
    off_centres: Option<Seed>,
    #[serde(skip)]
    scratch: Scratch,
}

/// A spring that runs in some rounds only.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct TimedSpring {
    node: usize,
    /// Depth over its node, m/s.
    rate: f64,
    /// The first and the last round, counted from 1.
    rounds: [u64; 2],
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    domain: Option<Arc<RasterDomain>>,
    /// The graph that water runs over, if it is another.
    off_centres: Option<Arc<RasterDomain>>,
    banks: Vec<Bank>,
}

impl Process<HeightField> for ChannelErosion {
    const WRITES: &'static [&'static str] =
        &["elevation", "deposition", "discharge", "incision", "water_depth", "water_supply"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        Some(OwnClock { dt: YEAR, rounds: self.iterations, is_timed: false })
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        let edges = terrain.grid().edges;
        if self.transport == Transport::Pipes && (edges.wraps_cols() || edges.wraps_rows()) {
            return Err(Error::parameter(
                "transport",
                "\"pipes\" on a map without ends",
                "another, or sides that are not periodic",
            ));
        }
        if let Some(radius) = self.channel_radius {
            within_map("channel_radius", radius, terrain.grid())?;
        }
        if let Some(outlets) = &self.outlets {
            outlets.apply(terrain, 0.0, context)?;
        }
        let domain = terrain.domain();
        let (rate, timed) = self.supply(terrain, &domain, context)?;
        let always = parallel::sum(rate.len(), |i| rate[i]);
        if !(always > 0.0 || timed.iter().any(|s| s.rate > 0.0)) {
            return Err(Error::parameter(
                "rainfall",
                "no water at all",
                "rain, a spring or an inflow somewhere inside",
            ));
        }
        let sinks = match &self.sinks {
            Some(map) => {
                let map = map.resolve("sinks", terrain, context)?;
                parallel::map(rate.len(), |i| map.at(i) >= 0.5)
            }
            None => Vec::new(),
        };
        let softness = self.softness.resolve("softness", terrain, context)?;
        begin_sums(terrain)?;
        let standing = vec![0.0; rate.len()];
        let z = terrain.elevation();
        let farthest = parallel::max(z.len(), |i| z[i].abs());
        if farthest > HIGHEST {
            let allowed = format!("ground within {HIGHEST:e} m of 0 m, where depths of water still count");
            return Err(Error::parameter("elevation", format!("{farthest:e} m"), &allowed));
        }
        let (bottom, slope) = bottom_and_slope(terrain);
        let beyond = (self.outlets.is_none() && terrain.chosen_status().is_none()).then_some(slope);
        Ok(State {
            bottom,
            beyond,
            water: Water::new(self, standing, terrain.grid().spacing),
            rate,
            timed,
            sinks,
            softness,
            sediment: Sediment::of(self, terrain.grid()),
            off_centres: self.runs_off_centres().then(|| context.seed.named("lattice")),
            scratch: Scratch::default(),
        })
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        let now = supply_in(at.index + 1, &state.rate, &state.timed);
        let rate = &*now;
        if !state.timed.is_empty() && !(parallel::sum(rate.len(), |i| rate[i]) > 0.0) {
            // Until a spring begins nothing moves.
            return Ok(Change::default());
        }
        let State { water, sinks, softness, bottom, beyond, sediment, off_centres, scratch, .. } = state;
        let domain = scratch.domain.get_or_insert_with(|| terrain.domain()).clone();
        let carried_before = sediment.as_ref().map_or(0.0, Sediment::under_way);
        let bed = Bed::of(terrain, *off_centres, &domain, &mut scratch.off_centres);
        let ledger = water.round(self, &bed.domain, &bed.z, (rate, sinks, at.dt));
        debug_assert!(ledger.imbalance() < 1e-9, "{ledger:?}");
        let river = self.river(terrain.grid());
        let stands = |d: f64| if self.transport != Transport::Pipes && d > FILM { d } else { 0.0 };
        // Lakes are level: over the centre of a cell they are as much deeper as it is lower.
        let over = |i: usize| water.depth[i] + (bed.z[i] - terrain.elevation()[i]);
        let still = parallel::map(rate.len(), |i| if stands(water.depth[i]) > 0.0 { stands(over(i)) } else { 0.0 });
        banks(terrain.grid(), terrain.elevation(), &water.flow, &still, &river, &mut scratch.banks);
        let (weights, area) = (self.weights(), terrain.grid().cell_area());
        let ground = Ground {
            grid: terrain.grid(),
            domain: &domain,
            z: terrain.elevation(),
            standing: &still,
            flow: &water.flow,
            banks: &scratch.banks,
            river,
            softness,
            bottom: *bottom,
            beyond: *beyond,
        };
        let mut new = eroded_bed(&ground, &weights);
        let exported = sediment
            .as_mut()
            .and_then(|s| Some((s, water.ways((&bed.domain, &bed.z), sinks)?)))
            .map(|(s, ways)| s.carry(&ground, &*ways, sinks, &mut new) * area);
        // Lakes keep their surface over the ground that was cut under them.
        let surface = parallel::map(rate.len(), |i| if still[i] > 0.0 { ground.z[i] + still[i] } else { f64::NAN });
        let status = domain.status();
        let is_inner = |i: usize| status[i] == Status::Interior;
        let old = terrain.elevation();
        let sum = |sign: f64| {
            let moved = |i: usize| (sign * (new[i] - old[i])).max(0.0);
            parallel::sum(old.len(), |i| if status[i] == Status::Masked { 0.0 } else { moved(i) }) * area
        };
        let (eroded, deposited) = (sum(-1.0), sum(1.0));
        let raised = uplift(terrain.grid(), &weights);
        let inner = parallel::sum(old.len(), |i| f64::from(u8::from(is_inner(i))));
        let lowered = parallel::map(old.len(), |i| if status[i] == Status::Masked { 0.0 } else { old[i] - new[i] });
        terrain.change(Layer::Surface("sediment"), |z| {
            parallel::update(z, |i, z| *z = if status[i] != Status::Masked { new[i] } else { *z });
        });
        add_to_sums(terrain, &lowered);
        if raised != 0.0 {
            terrain
                .change(Layer::Bedrock, |z| parallel::update(z, |i, z| *z += if is_inner(i) { raised } else { 0.0 }));
        }
        let carried = state.sediment.as_ref().map_or(0.0, |s| (s.under_way() - carried_before) * area);
        self.write_water(terrain, state, rate, &surface)?;
        Ok(Change {
            supplied: raised * inner * area,
            eroded,
            deposited,
            exported: exported.unwrap_or(eroded - deposited),
            carried,
            raised,
        })
    }
}

/// The ground that water runs over.
struct Bed<'a> {
    domain: Arc<RasterDomain>,
    z: Cow<'a, [f64]>,
}

impl<'a> Bed<'a> {
    /// Off the centres by a seed, or the ground itself; `kept` is the graph of the last round.
    fn of(
        terrain: &'a HeightField,
        seed: Option<Seed>,
        domain: &Arc<RasterDomain>,
        kept: &mut Option<Arc<RasterDomain>>,
    ) -> Self {
        let mut make = |seed: Seed| kept.take().or_else(|| terrain.domain_off_centres(seed).map(Arc::new));
        match seed.and_then(|seed| Some((seed, make(seed)?))) {
            Some((seed, off)) => {
                *kept = Some(off.clone());
                Self { domain: off, z: Cow::Owned(terrain.elevation_off_centres(seed)) }
            }
            None => Self { domain: domain.clone(), z: Cow::Borrowed(terrain.elevation()) },
        }
    }
}

impl ChannelErosion {
    fn river(&self, grid: &Grid) -> River {
        let [w, h] = grid.extent();
        let radius = self.channel_radius.map_or(w.max(h) / RADII_ACROSS, Length::si);
        River { radius, exponent: self.width_exponent, depth: self.river_depth.si() }
    }

    fn weights(&self) -> Weights {
        Weights {
            avalanche: self.avalanche_weight,
            flow: self.flow_weight,
            exponent: self.flow_exponent,
            diffusion: self.diffusion_weight,
            advection: self.advection_weight,
            base: self.base_weight,
            uplift: self.uplift_weight,
            everywhere: self.smoothing == Smoothing::Everywhere,
        }
    }

    /// Water that comes to each node in every round, m/s, and springs that run in some.
    fn supply(
        &self,
        terrain: &HeightField,
        domain: &RasterDomain,
        context: &Context,
    ) -> Result<(Vec<f64>, Vec<TimedSpring>)> {
        let rain = self.rainfall.resolve("rainfall", terrain, context)?;
        let (grid, status, area) = (terrain.grid(), domain.status(), terrain.grid().cell_area());
        if let Some(i) = parallel::find_first(status.len(), |i| status[i] != Status::Masked && !(rain.at(i) >= 0.0)) {
            let value = format!("{} m/s at node {i}", rain.at(i));
            return Err(Error::parameter("rainfall", value, "at least 0 everywhere"));
        }
        let mut rate = parallel::map(status.len(), |i| if status[i] == Status::Masked { 0.0 } else { rain.at(i) });
        let mut timed = Vec::new();
        for spring in &self.springs {
            let at = spring.at.map(Length::si);
            let node = grid.node_at(at).filter(|&i| status[i] == Status::Interior);
            let Some(node) = node else {
                let [[w, s], [e, n]] = terrain.bounds();
                let inside =
                    format!("a place inside the map ({w:.0} to {e:.0} m, {s:.0} to {n:.0} m), not on its open border");
                return Err(Error::parameter("springs", format!("one at {:.0}, {:.0} m", at[0], at[1]), &inside));
            };
            match spring.rounds {
                Some(rounds) => timed.push(TimedSpring { node, rate: spring.discharge.si() / area, rounds }),
                None => rate[node] += spring.discharge.si() / area,
            }
        }
        for inflow in &self.inflow {
            let nodes = inside_of(grid, inflow.side);
            let nodes: Vec<usize> = nodes.into_iter().filter(|&i| status[i] == Status::Interior).collect();
            if nodes.is_empty() {
                return Err(Error::parameter("inflow", "on a side without inner ground", "a side that has some"));
            }
            for &i in &nodes {
                rate[i] += inflow.discharge.si() / (area * nodes.len() as f64);
            }
        }
        Ok((rate, timed))
    }

    /// Adds depth, discharge and supply of the water as fields.
    fn write_water(&self, terrain: &mut HeightField, state: &State, rate: &[f64], surface: &[f64]) -> Result<()> {
        let State { water, scratch, .. } = state;
        let z = terrain.elevation();
        let area = terrain.grid().cell_area();
        let whole = parallel::sum(rate.len(), |i| rate[i]) * area;
        let river = self.river(terrain.grid());
        let is_real = self.transport == Transport::Pipes;
        let depth = parallel::map(z.len(), |i| {
            if z[i].is_nan() || is_real {
                return water.depth[i];
            }
            // A river that crosses a shallow lake is as deep there as elsewhere.
            let lake = if surface[i].is_nan() { 0.0 } else { (surface[i] - z[i]).max(0.0) };
            let bank = &scratch.banks[i];
            let beside = (bank.stage - z[i]).clamp(0.0, bank.depth);
            lake.max(beside).max(river.depth(water.flow[i]))
        });
        let discharge = parallel::map(z.len(), |i| water.flow[i] * whole);
        let fields = terrain.fields_mut();
        fields.insert(&names::WATER_DEPTH, depth)?;
        fields.insert(&names::WATER_SUPPLY, rate.to_vec())?;
        fields.insert(&names::DISCHARGE, discharge)
    }
}

/// What comes to each node in a round, m/s.
fn supply_in<'a>(round: u64, rate: &'a [f64], timed: &[TimedSpring]) -> Cow<'a, [f64]> {
    let runs = |s: &&TimedSpring| (s.rounds[0]..=s.rounds[1]).contains(&round);
    let mut now = Cow::Borrowed(rate);
    for spring in timed.iter().filter(runs) {
        now.to_mut()[spring.node] += spring.rate;
    }
    now
}

/// The lowest elevation of a map, and its relief over half its extent.
fn bottom_and_slope(terrain: &HeightField) -> (f64, f64) {
    let z = terrain.elevation();
    let range = |(a, b): (f64, f64), &z: &f64| (a.min(z), b.max(z));
    let (lo, hi) = z.iter().filter(|z| z.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), range);
    let [w, h] = terrain.grid().extent();
    (lo, (hi - lo) / (0.5 * w.max(h)).max(terrain.grid().spacing[0]))
}

/// Nodes one row or column inside a side.
fn inside_of(grid: &Grid, side: Side) -> Vec<usize> {
    let (rows, cols) = (grid.shape.rows, grid.shape.cols);
    let at = |r: usize, c: usize| grid.shape.index(r.min(rows - 1), c.min(cols - 1));
    match side {
        Side::North => (0..cols).map(|c| at(1, c)).collect(),
        Side::South => (0..cols).map(|c| at(rows.saturating_sub(2), c)).collect(),
        Side::West => (0..rows).map(|r| at(r, 1)).collect(),
        Side::East => (0..rows).map(|r| at(r, cols.saturating_sub(2))).collect(),
    }
}
