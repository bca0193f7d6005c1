//! The water of a round, by any of the transports.

use std::sync::Arc;

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::grid::{Domain, RasterDomain, Status};
use landform_core::parallel;
use serde::{Deserialize, Serialize};

use super::params::{ChannelErosion, Transport};
use super::ways::{PipePaths, SedimentRouting, SweepPaths};
use crate::mechanism::water::{Ledger, Pipes, Rule, Supply, Sweep};

/// Water on the ground, between rounds.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Water {
    /// Depth of standing water (of all water, in pipes), m.
    pub(super) depth: Vec<f64>,
    /// Flow through each node as a part of the map's, over the last rounds.
    pub(super) flow: Vec<f64>,
    pipes: Option<Pipes>,
    rounds: u64,
    #[serde(skip)]
    scratch: Scratch,
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    sweep: Option<Sweep>,
    routed: Flow,
}

/// Fraction of the flow that is of this round; the rest is of rounds before.
const FRESH: f64 = 0.5;

impl Water {
    /// Water of this depth, at rest.
    pub(super) fn new(params: &ChannelErosion, depth: Vec<f64>, spacing: [f64; 2]) -> Self {
        let pipes = Pipes::new(depth.len(), spacing, params.roughness());
        Self {
            flow: vec![0.0; depth.len()],
            pipes: (params.transport == Transport::Pipes).then_some(pipes),
            rounds: 0,
            depth,
            scratch: Scratch::default(),
        }
    }

    /// A round. `rate` is the water that comes to each node, m/s; `dt` the round's length, s.
    pub(super) fn round(
        &mut self,
        params: &ChannelErosion,
        domain: &Arc<RasterDomain>,
        ground: &[f64],
        (rate, sinks, dt): (&[f64], &[bool], f64),
    ) -> Ledger {
        let (ledger, now) = match params.transport {
            Transport::Columns => {
                self.sweep(Rule::Columns { depth: params.river_depth.si() }, params, domain, ground, (rate, sinks, dt))
            }
            Transport::Average => self.sweep(Rule::Average, params, domain, ground, (rate, sinks, dt)),
            Transport::WeightedAverage => self.sweep(Rule::Weighted, params, domain, ground, (rate, sinks, dt)),
            Transport::Pipes => self.flood(params, domain, ground, (rate, sinks)),
            Transport::AreaMap => self.route(domain, ground, rate),
        };
        let fresh = if self.rounds == 0 { 1.0 } else { FRESH };
        parallel::update(&mut self.flow, |i, f| *f += fresh * (now[i] - *f));
        self.rounds += 1;
        ledger
    }

    /// The paths of the last round over the ground that its water ran on; none for area maps.
    pub(super) fn ways<'a>(
        &'a self,
        (domain, ground): (&'a RasterDomain, &'a [f64]),
        sinks: &[bool],
    ) -> Option<Box<dyn SedimentRouting + 'a>> {
        if let Some(pipes) = &self.pipes {
            return Some(Box::new(PipePaths::new(pipes, (domain, ground), sinks)));
        }
        let sweep = self.scratch.sweep.as_ref()?;
        Some(Box::new(SweepPaths { sweep, domain }))
    }

    fn sweep(
        &mut self,
        rule: Rule,
        params: &ChannelErosion,
        domain: &RasterDomain,
        ground: &[f64],
        (rate, sinks, dt): (&[f64], &[bool], f64),
    ) -> (Ledger, Vec<f64>) {
        let depth = parallel::map(rate.len(), |i| rate[i] * dt);
        let total = parallel::sum(depth.len(), |i| depth[i]);
        let supply = Supply { depth: &depth, total, evaporation: params.evaporation.si() * dt, sinks };
        let sweep = self.scratch.sweep.get_or_insert_with(|| Sweep::new(rule));
        let ledger = sweep.round(domain, ground, &supply, &mut self.depth);
        let passed = sweep.passed();
        (ledger, parallel::map(passed.len(), |i| (passed[i] / total).min(1.0)))
    }

    fn flood(
        &mut self,
        params: &ChannelErosion,
        domain: &RasterDomain,
        ground: &[f64],
        (rate, sinks): (&[f64], &[bool]),
    ) -> (Ledger, Vec<f64>) {
        let Some(pipes) = &mut self.pipes else { return (Ledger::default(), vec![0.0; ground.len()]) };
        let status = domain.status();
        let sum = parallel::sum(rate.len(), |i| rate[i]);
        let wet = parallel::sum(rate.len(), |i| f64::from(u8::from(!ground[i].is_nan())));
        // Wherever rain falls, the storm brings as much water in all as if it fell everywhere.
        let faster = params.storm() * wet / sum;
        let depth = parallel::map(rate.len(), |i| rate[i] * faster);
        let supply = Supply { depth: &depth, total: sum * faster, evaporation: params.evaporation.si(), sinks };
        let is_end = |i: &usize| status[*i] == Status::BaseLevel || sinks.get(*i).copied().unwrap_or(false);
        let ends: Vec<u32> = (0..status.len()).filter(is_end).map(|i| i as u32).collect();
        let mut ledger = Ledger { before: parallel::sum(ground.len(), |i| self.depth[i]), ..Ledger::default() };
        pipes.begin_sums();
        for _ in 0..params.pipe_steps() {
            let dt = pipes.max_step(&self.depth).min(60.0);
            let part = pipes.step(domain, ground, (&supply, &ends), dt, &mut self.depth);
            ledger.entered += part.entered;
            ledger.left += part.left;
            ledger.evaporated += part.evaporated;
        }
        ledger.stored = parallel::sum(ground.len(), |i| self.depth[i]);
        let through = pipes.net_discharge(domain);
        let whole = sum * faster * domain.area(0);
        (ledger, parallel::map(through.len(), |i| (through[i] / whole).min(1.0)))
    }

    fn route(&mut self, domain: &RasterDomain, ground: &[f64], rate: &[f64]) -> (Ledger, Vec<f64>) {
        let mut amount = node_areas(domain);
        parallel::update(&mut amount, |i, a| *a *= rate[i]);
        let total = parallel::sum(amount.len(), |i| amount[i]);
        let flow = &mut self.scratch.routed;
        flow.route(domain, ground, &mut amount);
        let level = flow.water_level(ground);
        parallel::fill(&mut self.depth, |i| (level[i] - ground[i]).max(0.0));
        (Ledger::default(), parallel::map(amount.len(), |i| amount[i] / total))
    }
}
