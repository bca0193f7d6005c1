//! Erosion and deposition in one implicit step.
//!
//! # Model
//! ∂z/∂t = U − K Aᵐ Sⁿ + (G/A) Q, with Q the sediment that leaves a node: all that was eroded upstream, its own included, less
//! the deposits there.
//!
//! # Method
//! Let d be the net lowering of a node in the step. Its equation holds the receiver's d (through the slope) and its donors' d
//! (through Q): a linear system on a tree, for n = 1. It is solved *directly*: from the leaves down, the flux out of a subtree is
//! a linear function of the lowering of the node below, Q = α + β d_r; from the outlets up the d follow. O(n), without the
//! iterations of Gauss–Seidel, whatever G. What is not linear is decided node by node on the way up and the two passes repeated
//! until no decision changes (a few rounds): slopes at the talus angle; floors of lakes, where nothing is worn off and fill stops
//! at the water's surface; and, for n ≠ 1, the tangent of the law.
//!
//! Volumes are conserved by construction: Q is made of the d.
//!
//! # Sources
//! Yuan, Braun, Guerit, Rouby & Cordonnier (2019), eqs. 5–9, who exclude the node's own cell from Q; here it is included, so that
//! the steady slope is ((1 + G) U/K)^(1/n) A^(−m/n) exactly (validation notes 2.19). Davy & Lague (2009) for the ξ–q law behind
//! it.

use std::sync::atomic::{AtomicBool, Ordering};

use landform_core::algo::flow::Flow;
use landform_core::grid::{Domain, NO_SLOT};
use landform_core::verb::Change;
use landform_core::{math, parallel};

use super::law::Law;
use super::rock::Rock;

const MOST_ROUNDS: usize = 60;
const TOLERANCE: f64 = 1e-11;

/// State of a node in the step.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Regime {
    /// The river erodes and deposits.
    River,
    /// The slope above the receiver is at, or on its way to, the talus slope.
    Talus,
    /// Under water: deposition only.
    Lake,
    /// Filled, or worn, to the surface of the water.
    Filled,
}

/// Buffers of the solver; empty until they are needed.
#[derive(Clone, Debug, Default)]
pub(super) struct Sediment {
    nodes: Vec<Node>,
    /// What donors send: α and β.
    upstream: Vec<[f64; 2]>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    /// Net lowering, m.
    lowering: f64,
    /// Drop to the receiver before the step, m.
    drop: f64,
    /// Drop at which the law's tangent is laid, for n ≠ 1.
    at: f64,
    /// Surface of the water at the node, m.
    level: f64,
    /// F of the law.
    strength: f64,
    /// Drop that the ground can stand at, m.
    limit: f64,
    regime: Regime,
}

impl Sediment {
    /// Erodes and deposits over `z`; `area` is drainage area.
    pub(super) fn sweep<D: Domain>(
        &mut self,
        domain: &D,
        flow: &Flow,
        law: &Law,
        rock: &Rock,
        area: &[f64],
        z: &mut [f64],
    ) -> Change {
        let step = Step { domain, flow, law, rock, area, before: z };
        self.prepare(&step);
        for _ in 0..MOST_ROUNDS {
            self.down(&step);
            if !self.up(&step) {
                break;
            }
        }
        self.settle(domain, flow, z)
    }

    /// Lowers the ground, and follows the volumes to where they leave.
    fn settle<D: Domain>(&mut self, domain: &D, flow: &Flow, z: &mut [f64]) -> Change {
        let nodes = &self.nodes;
        parallel::update(z, |i, z| *z -= nodes[i].lowering);
        let volume = |i: usize| nodes[i].lowering * domain.area(i);
        let sum = |sign: f64| parallel::sum(nodes.len(), |i| (sign * volume(i)).max(0.0));
        let (eroded, deposited) = (sum(1.0), sum(-1.0));
        parallel::update(&mut self.upstream, |i, flux| *flux = [volume(i), 0.0]);
        flow.down(domain, &mut self.upstream, |a, b| [a[0] + b[0], 0.0], |_, flux| flux);
        let (flux, slots) = (&self.upstream, flow.slots());
        let exported = parallel::sum(nodes.len(), |i| if slots[i] == NO_SLOT { flux[i][0] } else { 0.0 });
        Change { eroded, deposited, exported, ..Change::default() }
    }

    /// Without deposition: the first guess.
    fn prepare<D: Domain>(&mut self, step: &Step<'_, D>) {
        let Step { domain, flow, law, rock, area, before } = *step;
        let (slots, receivers) = (flow.slots(), flow.receivers());
        let empty =
            Node { lowering: 0.0, drop: 0.0, at: 1.0, level: 0.0, strength: 0.0, limit: 0.0, regime: Regime::Lake };
        self.nodes.clear();
        self.nodes.extend(before.iter().map(|z| Node { level: z.max(law.sea_level), ..empty }));
        self.upstream.resize(before.len(), [0.0; 2]);
        flow.up(&mut self.nodes, |i, _, below| {
            let length = domain.distance(i, slots[i]);
            let strength = law.strength(rock.erodibility(i, before[i]), area[i], length);
            let base = (before[receivers[i] as usize] - below.lowering).max(law.sea_level);
            let mut node = Node { drop: before[i] - base - below.lowering, strength, ..empty };
            node.level = below.level.max(before[i]);
            if before[i] > below.level {
                let worn = law.worn(before[i] - base, strength);
                let limit = rock.stable_drop(law, i, before[i], base, length);
                let (kept, slides) = law.standing(worn, limit, length);
                node.regime = if slides { Regime::Talus } else { Regime::River };
                node.limit = limit;
                node.lowering = before[i] - base - kept;
                node.level = base + kept;
                node.at = worn;
            }
            node
        });
    }

    /// From the leaves down: what each subtree sends, as a function of the lowering of the node below.
    fn down<D: Domain>(&mut self, step: &Step<'_, D>) {
        let nodes = &self.nodes;
        self.upstream.fill([0.0; 2]);
        let add = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        step.flow.down(step.domain, &mut self.upstream, add, |i, [alpha, beta]| {
            let [constant, factor] = step.lowering(i, &nodes[i], [alpha, beta]);
            let own = step.domain.area(i) + beta;
            [alpha + own * constant, own * factor]
        });
    }

    /// From the outlets up: lowering, and whether any node decides otherwise than before.
    fn up<D: Domain>(&mut self, step: &Step<'_, D>) -> bool {
        let Step { domain, flow, law, rock, before, .. } = *step;
        let (slots, receivers, upstream) = (flow.slots(), flow.receivers(), &self.upstream);
        let changed = AtomicBool::new(false);
        flow.up(&mut self.nodes, |i, was, below| {
            let [alpha, beta] = upstream[i];
            let base = (before[receivers[i] as usize] - below.lowering).max(law.sea_level);
            let share = step.share(i);
            let own = 1.0 + share * (domain.area(i) + beta);
            let laid = share * alpha / own;
            let drop = before[i] - base;
            let mut node = Node { drop: drop - below.lowering, ..was };
            let mut differs = false;
            // What the river leaves of the drop, what it lays down included.
            let left = if drop + laid > 0.0 { law.worn(drop + laid, was.strength / own) } else { drop + laid };
            if base + left <= below.level {
                let fills = before[i] + laid > below.level;
                node.regime = if fills { Regime::Filled } else { Regime::Lake };
                node.lowering = if fills { before[i] - below.level } else { -laid };
            } else {
                let length = domain.distance(i, slots[i]);
                let limit = rock.stable_drop(law, i, before[i], base, length);
                let (kept, slides) = law.standing(left, limit, length);
                node.limit = limit;
                node.regime = if slides { Regime::Talus } else { Regime::River };
                node.lowering = drop - kept;
                node.at = left;
                differs = law.slope_exponent != 1.0 && (left - was.at).abs() > TOLERANCE * (left + was.at);
            }
            node.level = below.level.max(before[i] - node.lowering);
            let risen = (node.level - was.level).abs() > TOLERANCE * (1.0 + node.level.abs());
            differs |= node.regime != was.regime || (node.regime == Regime::Filled && risen);
            if differs {
                changed.store(true, Ordering::Relaxed);
            }
            node
        });
        changed.into_inner()
    }
}

/// Slope and intercept of the tangent of F xⁿ at x.
fn tangent(law: &Law, strength: f64, x: f64) -> [f64; 2] {
    let n = law.slope_exponent;
    if n == 1.0 {
        return [strength, 0.0];
    }
    let power = strength * math::pow(x.max(1e-9), n - 1.0);
    [n * power, (1.0 - n) * power * x.max(1e-9)]
}

/// What does not change in the step.
struct Step<'a, D> {
    domain: &'a D,
    flow: &'a Flow,
    law: &'a Law,
    rock: &'a Rock<'a>,
    area: &'a [f64],
    before: &'a [f64],
}

impl<D: Domain> Step<'_, D> {
    /// G/A: the part of the flux that is laid down, per area.
    fn share(&self, i: usize) -> f64 {
        if self.area[i] > 0.0 { self.law.deposition / self.area[i] } else { 0.0 }
    }

    /// A node's lowering as a function of its receiver's: constant and factor.
    fn lowering(&self, i: usize, node: &Node, [alpha, beta]: [f64; 2]) -> [f64; 2] {
        let share = self.share(i);
        let own = 1.0 + share * (self.domain.area(i) + beta);
        let river = || {
            let [slope, intercept] = tangent(self.law, node.strength, node.at);
            let all = own + slope;
            [(slope * node.drop + intercept - share * alpha) / all, slope / all]
        };
        match node.regime {
            Regime::River => river(),
            Regime::Talus => {
                let length = self.domain.distance(i, self.flow.slots()[i]);
                let (slide, [constant, factor]) = (self.law.slide(length), river());
                let slid = node.drop - node.limit;
                [constant + slide * (slid - constant), factor + slide * (1.0 - factor)]
            }
            Regime::Lake => [-share * alpha / own, 0.0],
            Regime::Filled => [node.lowering, 0.0],
        }
    }
}
