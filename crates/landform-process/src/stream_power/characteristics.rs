//! The sharp sweep: along characteristics.
//!
//! # Model
//! For n = 1 the law is an advection: elevations travel up the rivers at the speed K Aᵐ, and rise
//! on their way with the ground. The elevation that a node has after a step is that which lay, at
//! its start, a step's travel time down the river, plus what it rose on the way:
//!
//! z(τ, t + Δt) = z(τ − Δt, t) + ∫ U dτ, with τ = ∫ dx/(K Aᵐ) from the outlet.
//!
//! # Method
//! From each node the flow is followed down until a step's time is used up; there the profile of
//! the river is read by the cubic through the two nodes on either side, held between the nearer
//! two, so that it makes no new steps or pits and hardly smears those that are there. A wave that
//! left the outlet within the step has the base level of that moment. What other processes raised
//! or lowered in the step is spread over the way as a rate. No node sinks below its receiver.
//!
//! A steady state is that of the implicit sweep, whatever the step. **Cost** O(n) times the number
//! of nodes that a wave passes in a step: for short steps it is that of the implicit sweep.
//!
//! # Limits
//! n = 1, no deposition, no threshold, no limiting slope, no layers. Waves cross lakes at the speed
//! of the river through them.
//!
//! # Sources
//! Royden & Perron (2013) for the characteristics; Campforts & Govers (2015) and Campforts,
//! Schwanghart & Govers (2017) for knickpoints that a first-order scheme smears (their remedy is a
//! flux limiter with short steps); Bermejo & Staniforth (1992) for a cubic that is held between.
//!
//! # Checked by
//! `tests/sharp.rs`: place and width of a knickpoint after 2 Myr, steady states, base levels that
//! sink, mass.

use landform_core::algo::flow::Flow;
use landform_core::grid::{Domain, NO_SLOT};
use landform_core::parallel;

use super::law::Law;
use super::rock::Rock;

/// No node.
const NONE: u32 = u32::MAX;

/// The surface at the start of a step, and how long waves take on it.
#[derive(Clone, Debug, Default)]
pub(super) struct Waves {
    /// Elevation at the start of the step, m; then the level of the water there.
    pub(super) start: Vec<f64>,
    /// What the ground rose by since, m.
    raised: Vec<f64>,
    /// Time from a node to its receiver, s.
    time: Vec<f64>,
    /// The donor of the greatest area.
    upstream: Vec<u32>,
}

impl Waves {
    /// Lowers every node to what reaches it in a step. `area` is drainage area; where a node has a
    /// receiver, it becomes what the node was lowered by, m.
    pub(super) fn sweep<D: Domain>(
        &mut self,
        domain: &D,
        flow: &Flow,
        law: &Law,
        rock: &Rock,
        area: &mut [f64],
        z: &mut [f64],
    ) {
        self.prepare(domain, flow, law, rock, area, z);
        let (slots, waves) = (flow.slots(), &*self);
        flow.up_with(z, area, |i, old, below, area| {
            let base = below.max(law.sea_level);
            *area = 0.0;
            // Lake floors lie at or below their receivers.
            if !(old > base) {
                return old;
            }
            let arrived = waves.arriving(flow, law, i).clamp(base, old);
            let length = domain.distance(i, slots[i]);
            let new = base + law.standing(arrived - base, law.greatest_slope * length, length).0;
            *area = old - new;
            new
        });
    }

    fn prepare<D: Domain>(&mut self, domain: &D, flow: &Flow, law: &Law, rock: &Rock, area: &[f64], z: &[f64]) {
        let (slots, receivers) = (flow.slots(), flow.receivers());
        self.raised = parallel::map(z.len(), |i| z[i] - self.start[i]);
        self.start = flow.water_level(&self.start);
        self.time = parallel::map(z.len(), |i| match slots[i] {
            NO_SLOT => f64::INFINITY,
            slot => law.dt / law.strength(rock.erodibility.at(i), area[i], domain.distance(i, slot)),
        });
        self.upstream.clear();
        self.upstream.resize(z.len(), NONE);
        for &donor in flow.order() {
            let r = receivers[donor as usize] as usize;
            if r != donor as usize {
                let known = self.upstream[r];
                let larger = known == NONE || area[donor as usize] > area[known as usize];
                self.upstream[r] = if larger { donor } else { known };
            }
        }
    }

    /// Elevation of what reaches a node at the end of the step.
    fn arriving(&self, flow: &Flow, law: &Law, node: usize) -> f64 {
        let receivers = flow.receivers();
        let (mut at, mut behind, mut left, mut gained) = (node, self.upstream[node], law.dt, 0.0);
        loop {
            let below = receivers[at] as usize;
            if below == at {
                // It left the outlet when `left` had passed.
                let then = self.start[at].max(law.sea_level);
                let now = (self.start[at] + self.raised[at]).max(law.sea_level);
                return then + (now - then) * (left / law.dt) + gained / law.dt;
            }
            let time = self.time[at];
            if !(time < left) {
                gained += self.raised[at] * left;
                let part = if time.is_finite() { left / time } else { 0.0 };
                return self.between(behind, at, below, receivers[below] as usize, part) + gained / law.dt;
            }
            gained += self.raised[at] * time;
            left -= time;
            (behind, at) = (at as u32, below);
        }
    }

    /// Level at the start of the step, a part of the way from a node down to the next: of the cubic
    /// through both and the nodes beyond them, as far as these are there; between the two.
    fn between(&self, behind: u32, at: usize, below: usize, beyond: usize, part: f64) -> f64 {
        let (high, low, time) = (self.start[at], self.start[below], self.time[at]);
        if part == 0.0 || !(high > low) {
            return high;
        }
        // Travel times upwards from the lower node, and levels.
        let mut places = [(0.0, low), (time, high), (0.0, 0.0), (0.0, 0.0)];
        let mut count = 2;
        if beyond != below {
            places[count] = (-self.time[below], self.start[beyond]);
            count += 1;
        }
        if behind != NONE && self.time[behind as usize].is_finite() {
            places[count] = (time + self.time[behind as usize], self.start[behind as usize]);
            count += 1;
        }
        lagrange(&places[..count], (1.0 - part) * time).clamp(low, high)
    }
}

/// The polynomial through some points, at a place.
fn lagrange(points: &[(f64, f64)], at: f64) -> f64 {
    let weight = |k: usize| {
        let others = points.iter().enumerate().filter(|&(j, _)| j != k);
        others.fold(1.0, |product, (_, point)| product * (at - point.0) / (points[k].0 - point.0))
    };
    (0..points.len()).map(|k| weight(k) * points[k].1).sum()
}
