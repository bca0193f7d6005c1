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
//! slope. The rounds end when less than one node of five hundred decides otherwise, and less than
//! one of ten lies further from its tangent than three hundredths of what is worn off: what that
//! costs is small beside the error of a step in time. At a steady state the first tangent is
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
/// One node of so many may still lie off its tangent when rounds end: more rounds cost more than
/// the error of a step in time is worth.
const FEW: usize = 10;
/// A node that decides otherwise counts as so many that lie off their tangents: it may send its
/// whole cell.
const DECISION: usize = 50;
/// Distance of the law from its tangent, over what is worn off, that is not worth another round.
const TANGENT: f64 = 0.03;
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
#[derive(Clone, Debug)]
pub(super) struct Sediment {
    nodes: Vec<Node>,
    ends: Vec<End>,
    /// What donors send: α and β.
    upstream: Vec<[f64; 2]>,
    /// How far from the end rounds may stop, over what is usual.
    tolerance: f64,
}

impl Default for Sediment {
    fn default() -> Self {
        Self { nodes: Vec::new(), ends: Vec::new(), upstream: Vec::new(), tolerance: 1.0 }
    }
}

/// What a node's donors need to know of it.
#[derive(Clone, Copy, Debug, Default)]
struct End {
    /// Net lowering, m.
    lowering: f64,
    /// Surface of the water at the node, m.
    level: f64,
}

/// A node in a step: all that a pass reads of it lies together.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Node {
    /// F of the law.
    strength: f64,
    /// G/A: the part of the flux that is laid down, per area.
    share: f64,
    /// Slope of the law's tangent, and what it wears off where the receiver stands still, m.
    slope: f64,
    still: f64,
    /// Drop at which the tangent is laid, m; for [`Regime::Filled`] its lowering.
    at: f64,
    /// Drop that the ground approaches and does not exceed, m.
    most: f64,
    /// Drop that the ground can stand at, m.
    limit: f64,
    regime: Regime,
}

const EMPTY: Node = Node {
    strength: 0.0,
    share: 0.0,
    slope: 0.0,
    still: 0.0,
    at: 1.0,
    most: f64::INFINITY,
    limit: f64::INFINITY,
    regime: Regime::Lake,
};

impl Sediment {
    /// A solver whose rounds go on until nothing changes.
    #[cfg(test)]
    pub(super) fn to_the_end() -> Self {
        Self { tolerance: 1e-6, ..Self::default() }
    }

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
        let step = Step { domain, flow, law, rock, before: z };
        self.guess(&step, area);
        let few = (self.nodes.len() / FEW) as f64;
        for _ in 0..MOST_ROUNDS {
            self.down(&step);
            if self.up(&step) <= (self.tolerance * few) as usize {
                break;
            }
            parallel::update(&mut self.nodes, |i, node| step.lay_tangent(i, node));
        }
        let ends = &self.ends;
        parallel::fill(area, |i| ends[i].lowering);
        settle(domain, area, z)
    }

    /// Each node by itself: it wears as if its receiver stood still.
    fn guess<D: Domain>(&mut self, step: &Step<'_, D>, area: &[f64]) {
        let Step { domain, flow, law, rock, before } = *step;
        let slots = flow.slots();
        self.upstream.resize(before.len(), [0.0; 2]);
        self.nodes.resize(before.len(), EMPTY);
        self.ends.resize(before.len(), End::default());
        parallel::fill(&mut self.ends, |i| End { lowering: 0.0, level: before[i].max(law.sea_level) });
        parallel::fill(&mut self.nodes, |i| {
            if slots[i] == NO_SLOT {
                return EMPTY;
            }
            let length = domain.distance(i, slots[i]);
            let strength = law.strength(rock.erodibility(i, before[i]), area[i], length);
            let share = if area[i] > 0.0 { law.deposition / area[i] } else { 0.0 };
            let most = rock.limiting_slope(law, i, before[i]) * length;
            let mut node = Node { strength, share, most, ..EMPTY };
            let drop = step.drop(i);
            if drop > 0.0 {
                let worn = || law.worn(drop, strength, most);
                node.limit = rock.stable_drop(law, i, before[i], before[i] - drop, length);
                let slides = drop > node.limit && worn() > node.limit;
                node.regime = if slides { Regime::Talus } else { Regime::River };
                // Rivers near a balance have the drop that they had.
                node.at = if drop < 0.9 * most { drop } else { worn() };
                step.lay_tangent(i, &mut node);
            }
            node
        });
    }

    /// From the leaves down: what each subtree sends, as a function of the lowering of the node
    /// below.
    fn down<D: Domain>(&mut self, step: &Step<'_, D>) {
        let nodes = &self.nodes;
        parallel::update(&mut self.upstream, |_, sums| *sums = [0.0; 2]);
        let add = |a: [f64; 2], b: [f64; 2]| [a[0] + b[0], a[1] + b[1]];
        step.flow.down(step.domain, &mut self.upstream, add, |i, [alpha, beta]| {
            let through = step.domain.area(i) + beta;
            let [constant, factor] = step.lowering(i, &nodes[i], alpha, through);
            [alpha + through * constant, through * factor]
        });
    }

    /// From the outlets up: lowering; returns how many nodes lie off their tangents, those that
    /// decide otherwise than before [`DECISION`] times.
    fn up<D: Domain>(&mut self, step: &Step<'_, D>) -> usize {
        let Step { domain, flow, law, rock, before } = *step;
        let (slots, receivers, upstream) = (flow.slots(), flow.receivers(), &self.upstream);
        let tolerance = self.tolerance;
        let (is_curved, may_slide) = (law.is_curved(), rock.may_slide(law));
        let off = AtomicUsize::new(0);
        flow.up_with(&mut self.ends, &mut self.nodes, |i, was, below, node| {
            let [alpha, beta] = upstream[i];
            let base = (before[receivers[i] as usize] - below.lowering).max(law.sea_level);
            let own = 1.0 + node.share * (domain.area(i) + beta);
            let per_own = 1.0 / own;
            let laid = node.share * alpha * per_own;
            let drop = before[i] - base;
            // What the river leaves of the drop, what it lays down included.
            let standing = drop + laid;
            let left = if standing > 0.0 { law.worn(standing, node.strength * per_own, node.most) } else { standing };
            let (regime, lowering, otherwise);
            let mut bends = false;
            if base + left <= below.level {
                let fills = before[i] + laid > below.level;
                regime = if fills { Regime::Filled } else { Regime::Lake };
                lowering = if fills { before[i] - below.level } else { -laid };
                otherwise = fills && (below.level - was.level).abs() > LEVEL;
                node.at = lowering;
            } else {
                let (mut kept, mut slides) = (left, false);
                if may_slide {
                    let length = domain.distance(i, slots[i]);
                    node.limit = rock.stable_drop(law, i, before[i], base, length);
                    (kept, slides) = law.standing(left, node.limit, length);
                }
                regime = if slides { Regime::Talus } else { Regime::River };
                lowering = drop - kept;
                let worn = own * (standing - left);
                let by_tangent = node.still + node.slope * (left + below.lowering - drop);
                bends = is_curved && (worn - by_tangent).abs() > tolerance * (TANGENT * worn + LEVEL);
                otherwise = false;
                node.at = left;
            }
            if otherwise || regime != node.regime {
                off.fetch_add(DECISION, Ordering::Relaxed);
            } else if bends {
                off.fetch_add(1, Ordering::Relaxed);
            }
            node.regime = regime;
            End { lowering, level: below.level.max(before[i] - lowering) }
        });
        off.into_inner()
    }
}

/// Lowers the ground, and adds up the volumes.
fn settle<D: Domain>(domain: &D, lowering: &[f64], z: &mut [f64]) -> Change {
    let pieces = parallel::map_pieces_mut([z], parallel::PIECE, |first, [piece]| {
        let (mut eroded, mut deposited) = (0.0, 0.0);
        for (k, z) in piece.iter_mut().enumerate() {
            let lowering = lowering[first + k];
            *z -= lowering;
            let volume = lowering * domain.area(first + k);
            eroded += volume.max(0.0);
            deposited -= volume.min(0.0);
        }
        [eroded, deposited]
    });
    let sum = |k: usize| pieces.iter().map(|sums| sums[k]).sum::<f64>();
    let (eroded, deposited) = (sum(0), sum(1));
    // Every way ends at an outlet, so what does not stay leaves.
    Change { eroded, deposited, exported: eroded - deposited, ..Change::default() }
}

/// What does not change in the step.
struct Step<'a, D> {
    domain: &'a D,
    flow: &'a Flow,
    law: &'a Law,
    rock: &'a Rock<'a>,
    before: &'a [f64],
}

impl<D: Domain> Step<'_, D> {
    /// The drop to the receiver, should that stand still, m.
    #[inline]
    fn drop(&self, i: usize) -> f64 {
        self.before[i] - self.before[self.flow.receivers()[i] as usize].max(self.law.sea_level)
    }

    /// Lays the tangent to the law of a node that wears.
    #[inline]
    fn lay_tangent(&self, i: usize, node: &mut Node) {
        (node.slope, node.still) = (0.0, 0.0);
        if matches!(node.regime, Regime::River | Regime::Talus) {
            let [slope, intercept] = self.law.tangent(node.strength, node.at, 1.0 / node.most);
            (node.slope, node.still) = (slope, slope * self.drop(i) + intercept);
        }
    }

    /// A node's lowering as a function of its receiver's: constant and factor. `through` is its
    /// area with what its donors send for each metre that it is lowered by, m².
    #[inline]
    fn lowering(&self, i: usize, node: &Node, alpha: f64, through: f64) -> [f64; 2] {
        let per_all = 1.0 / (1.0 + node.share * through + node.slope);
        let [constant, factor] = [(node.still - node.share * alpha) * per_all, node.slope * per_all];
        match node.regime {
            Regime::River | Regime::Lake => [constant, factor],
            Regime::Talus => {
                let slide = self.law.slide(self.domain.distance(i, self.flow.slots()[i]));
                let slid = self.drop(i) - node.limit;
                [constant + slide * (slid - constant), factor + slide * (1.0 - factor)]
            }
            Regime::Filled => [node.at, 0.0],
        }
    }
}
