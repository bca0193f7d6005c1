//! Erosion and deposition in one implicit step.
//!
//! # Model
//! ∂z/∂t = U − K Aᵐ Sⁿ + (G/A) Q, with Q the sediment that leaves a node: all that was eroded
//! upstream, its own included, less the deposits there.
//!
//! # Method
//! Let d be the net lowering of a node in the step. Its equation holds the receiver's d (through
//! the slope) and its donors' d (through Q): a linear system on a tree, for n = 1. It is
//! solved *directly*: from the leaves down, the flux out of a subtree is a linear function of the
//! lowering of the node below, Q = α + β d_r; from the outlets up the d follow. O(n), without the
//! iterations of Gauss–Seidel, whatever G. What is not linear is decided node by node on the way up
//! and the two passes repeated: slopes at the talus angle; floors of lakes, where nothing is worn
//! off and fill stops at the water's surface; the tangent of the law, for n ≠ 1 or a limiting
//! slope. The rounds end when less than one node of a hundred decides otherwise or lies further
//! from its tangent than a hundredth of what is worn off. At a steady state the first tangent is
//! exact.
//!
//! Volumes are conserved by construction: Q is made of the d.
//!
//! # Sources
//! Yuan, Braun, Guerit, Rouby & Cordonnier (2019), eqs. 5–9, who exclude the node's own cell from
//! Q; here it is included, so that the steady slope is ((1 + G) U/K)^(1/n) A^(−m/n) exactly
//! (validation notes 2.19). Davy & Lague (2009) for the ξ–q law behind it.

use std::sync::atomic::{AtomicUsize, Ordering};

use landform_core::algo::flow::Flow;
use landform_core::grid::{Domain, NO_SLOT};
use landform_core::parallel;
use landform_core::verb::Change;

use super::law::Law;
use super::rock::Rock;

const MOST_ROUNDS: usize = 60;
/// One node of so many may still decide otherwise when rounds end: more rounds cost more than the
/// error of a step in time is worth.
const FEW: usize = 100;
/// Distance of the law from its tangent, over what is worn off, that is not worth another round.
const TANGENT: f64 = 0.01;
/// Change of a lake's level after which fill is good to it, m.
const LEVEL: f64 = 1e-3;

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
    /// F of the law, and G/A: the part of the flux that is laid down, per area.
    strength: Vec<[f64; 2]>,
    /// What donors send: α and β.
    upstream: Vec<[f64; 2]>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    /// Net lowering, m.
    lowering: f64,
    /// Drop to the receiver before the step, m.
    drop: f64,
    /// Drop at which the law's tangent is laid, where the law is curved, m.
    at: f64,
    /// Surface of the water at the node, m.
    level: f64,
    /// Drop that the ground can stand at, m.
    limit: f64,
    regime: Regime,
}

const EMPTY: Node = Node { lowering: 0.0, drop: 0.0, at: 1.0, level: 0.0, limit: 0.0, regime: Regime::Lake };

impl Sediment {
    /// Erodes and deposits over `z`. `area` is drainage area, and becomes what nodes were lowered
    /// by, m.
    pub(super) fn sweep<D: Domain>(
        &mut self,
        domain: &D,
        flow: &Flow,
        law: &Law,
        rock: &Rock,
        area: &mut [f64],
        z: &mut [f64],
    ) -> Change {
        self.strength.resize(z.len(), [0.0; 2]);
        let slots = flow.slots();
        parallel::fill(&mut self.strength, |i| match slots[i] {
            NO_SLOT => [0.0; 2],
            slot => {
                let strength = law.strength(rock.erodibility(i, z[i]), area[i], domain.distance(i, slot));
                [strength, if area[i] > 0.0 { law.deposition / area[i] } else { 0.0 }]
            }
        });
        let strength = std::mem::take(&mut self.strength);
        let step = Step { domain, flow, law, rock, strength: &strength, before: z };
        self.prepare(&step);
        for _ in 0..MOST_ROUNDS {
            self.down(&step);
            if self.up(&step) <= self.nodes.len() / FEW {
                break;
            }
        }
        self.strength = strength;
        let nodes = &self.nodes;
        parallel::fill(area, |i| nodes[i].lowering);
        self.settle(domain, z)
    }

    /// Lowers the ground, and adds up the volumes.
    fn settle<D: Domain>(&self, domain: &D, z: &mut [f64]) -> Change {
        let nodes = &self.nodes;
        parallel::update(z, |i, z| *z -= nodes[i].lowering);
        let sum = |sign: f64| parallel::sum(nodes.len(), |i| (sign * nodes[i].lowering * domain.area(i)).max(0.0));
        let (eroded, deposited) = (sum(1.0), sum(-1.0));
        // Every way ends at an outlet, so what does not stay leaves.
        Change { eroded, deposited, exported: eroded - deposited, ..Change::default() }
    }

    /// Without deposition: the first guess.
    fn prepare<D: Domain>(&mut self, step: &Step<'_, D>) {
        let Step { domain, flow, law, rock, strength, before, .. } = *step;
        let (slots, receivers) = (flow.slots(), flow.receivers());
        self.upstream.resize(before.len(), [0.0; 2]);
        self.nodes.resize(before.len(), EMPTY);
        parallel::fill(&mut self.nodes, |i| Node { level: before[i].max(law.sea_level), ..EMPTY });
        flow.up(&mut self.nodes, |i, _, below| {
            let base = (before[receivers[i] as usize] - below.lowering).max(law.sea_level);
            let (drop, level) = (before[i] - base, below.level.max(before[i]));
            let node = Node { drop: drop - below.lowering, level, ..EMPTY };
            if !(before[i] > below.level) {
                return node;
            }
            let length = domain.distance(i, slots[i]);
            let most = rock.limiting_slope(law, i, before[i]) * length;
            let worn = law.worn(drop, strength[i][0], most);
            let limit = rock.stable_drop(law, i, before[i], base, length);
            let (kept, slides) = law.standing(worn, limit, length);
            let regime = if slides { Regime::Talus } else { Regime::River };
            // Rivers near a balance have the drop that they had.
            let had = drop - below.lowering;
            let at = if had > worn && had < 0.9 * most { had } else { worn };
            Node { lowering: drop - kept, level: base + kept, at, limit, regime, ..node }
        });
    }

    /// From the leaves down: what each subtree sends, as a function of the lowering of the node
    /// below.
    fn down<D: Domain>(&mut self, step: &Step<'_, D>) {
        let nodes = &self.nodes;
        parallel::update(&mut self.upstream, |_, sums| *sums = [0.0; 2]);
        let add = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        step.flow.down(step.domain, &mut self.upstream, add, |i, [alpha, beta]| {
            let [constant, factor] = step.lowering(i, &nodes[i], [alpha, beta]);
            let own = step.domain.area(i) + beta;
            [alpha + own * constant, own * factor]
        });
    }

    /// From the outlets up: lowering; returns how many nodes decide otherwise than before.
    fn up<D: Domain>(&mut self, step: &Step<'_, D>) -> usize {
        let Step { domain, flow, law, rock, strength, before, .. } = *step;
        let (slots, receivers, upstream) = (flow.slots(), flow.receivers(), &self.upstream);
        let changed = AtomicUsize::new(0);
        flow.up(&mut self.nodes, |i, was, below| {
            let [alpha, beta] = upstream[i];
            let base = (before[receivers[i] as usize] - below.lowering).max(law.sea_level);
            let [strength, share] = strength[i];
            let own = 1.0 + share * (domain.area(i) + beta);
            let per_own = 1.0 / own;
            let laid = share * alpha * per_own;
            let drop = before[i] - base;
            let length = domain.distance(i, slots[i]);
            let most = rock.limiting_slope(law, i, before[i]) * length;
            let mut node = Node { drop: drop - below.lowering, ..was };
            let mut differs = false;
            // What the river leaves of the drop, what it lays down included.
            let left = if drop + laid > 0.0 { law.worn(drop + laid, strength * per_own, most) } else { drop + laid };
            if base + left <= below.level {
                let fills = before[i] + laid > below.level;
                node.regime = if fills { Regime::Filled } else { Regime::Lake };
                node.lowering = if fills { before[i] - below.level } else { -laid };
            } else {
                let limit = rock.stable_drop(law, i, before[i], base, length);
                let (kept, slides) = law.standing(left, limit, length);
                node.limit = limit;
                node.regime = if slides { Regime::Talus } else { Regime::River };
                node.lowering = drop - kept;
                node.at = left;
                if law.is_curved() {
                    let [slope, intercept] = law.tangent(strength, was.at, 1.0 / most);
                    let worn = own * (drop + laid - left);
                    differs = (worn - slope * left - intercept).abs() > TANGENT * worn + LEVEL;
                }
            }
            node.level = below.level.max(before[i] - node.lowering);
            differs |= node.regime != was.regime;
            differs |= node.regime == Regime::Filled && (node.level - was.level).abs() > LEVEL;
            if differs {
                changed.fetch_add(1, Ordering::Relaxed);
            }
            node
        });
        changed.into_inner()
    }
}

/// What does not change in the step.
struct Step<'a, D> {
    domain: &'a D,
    flow: &'a Flow,
    law: &'a Law,
    rock: &'a Rock<'a>,
    /// F of the law and G/A.
    strength: &'a [[f64; 2]],
    before: &'a [f64],
}

impl<D: Domain> Step<'_, D> {
    /// A node's lowering as a function of its receiver's: constant and factor.
    #[inline]
    fn lowering(&self, i: usize, node: &Node, [alpha, beta]: [f64; 2]) -> [f64; 2] {
        let [strength, share] = self.strength[i];
        let own = 1.0 + share * (self.domain.area(i) + beta);
        let river = || {
            let limit = self.rock.limiting_slope(self.law, i, self.before[i]);
            let per_most = self.domain.inverse_distance(i, self.flow.slots()[i]) / limit;
            let [slope, intercept] = self.law.tangent(strength, node.at, per_most);
            let per_all = 1.0 / (own + slope);
            [(slope * node.drop + intercept - share * alpha) * per_all, slope * per_all]
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
