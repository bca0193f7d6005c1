//! What users should know of ground that stands at its talus angle: planes of one slope.
//!
//! # Sources
//! At a steady state K Aᵐ tanⁿ α = U where rivers begin to keep slopes below α: above, for smaller
//! drainage areas, the ground is planes.

use landform_core::algo::flow::Flow;
use landform_core::grid::{Domain, NO_SLOT, Status};
use landform_core::units::Angle;
use landform_core::verb::Estimate;
use landform_core::{math, parallel};

/// Drainage area up to which planes pass for hillsides, m², and in nodes.
const HILLSIDE: f64 = 1e5;
const HILLSIDE_NODES: f64 = 50.0;
/// Share of the land at the angle from which it is told.
const TOLD: f64 = 0.1;
/// How far from the angle ground counts as standing at it, rad: one degree.
const NEAR: f64 = std::f64::consts::PI / 180.0;

/// A law of rivers on slopes of one angle: K (SI), m and n.
pub(super) struct Uniform {
    pub(super) angle: Angle,
    pub(super) erodibility: f64,
    pub(super) area_exponent: f64,
    pub(super) slope_exponent: f64,
}

/// That planes will be larger than hillsides, where uplift and erodibility say so before a run.
pub(super) fn warning(law: &Uniform, before: &Estimate, raised: f64) -> Option<String> {
    let Uniform { angle, erodibility, area_exponent, slope_exponent } = *law;
    if !(raised > 0.0 && area_exponent > 0.0) {
        return None;
    }
    let slope = math::tan(angle.si());
    let area = math::pow(raised / (erodibility * math::pow(slope, slope_exponent)), 1.0 / area_exponent);
    let node = before.spacing().map(|d| d * d);
    let large = area > HILLSIDE || node.is_some_and(|node| area > HILLSIDE_NODES * node);
    large.then(|| {
        let nodes = node.map(|node| format!(", {:.0} nodes", area / node)).unwrap_or_default();
        format!(
            "`talus_angle` will hold up to drainage areas of {:.2} km2{nodes}: planes of one slope; without it \
             `limiting_slope` makes gullies instead",
            area * 1e-6
        )
    })
}

/// The share of the land that stands at the angle, where that is much.
pub(super) fn note<D: Domain>(angle: Angle, domain: &D, flow: &Flow, z: &[f64]) -> Option<String> {
    let (slots, receivers, status) = (flow.slots(), flow.receivers(), domain.status());
    if slots.len() != z.len() {
        return None;
    }
    let least = math::tan((angle.si() - NEAR).max(0.0));
    let stands =
        |i: usize| slots[i] != NO_SLOT && z[i] - z[receivers[i] as usize] >= least * domain.distance(i, slots[i]);
    let count = |of: &(dyn Fn(usize) -> bool + Sync)| parallel::sum(z.len(), |i| if of(i) { 1.0 } else { 0.0 });
    let share = count(&stands) / count(&|i| status[i] != Status::Masked).max(1.0);
    (share > TOLD).then(|| {
        format!(
            "{:.0} % of the land stands at the talus angle of {:.0} degrees",
            100.0 * share,
            angle.si().to_degrees()
        )
    })
}
