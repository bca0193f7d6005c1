//! Which ground fails: Culmann's criterion.
//!
//! A slope of angle β and cohesion C, friction angle φ, weight ρ g of a volume, fails along a plane
//! through its foot at (β + φ)/2 if it is higher than
//! H = 4 C/(ρ g) · sin β cos φ/(1 − cos(β − φ)).
//!
//! # Sources
//! Culmann (1875), as in Campforts et al. (2020), eqs. 21–24.

use landform_core::grid::{Domain, Status};
use landform_core::parallel;
use landform_core::random::Seed;

/// Strength of the rock of a step.
pub(super) struct Strength {
    /// 4 C/(ρ g), m.
    pub(super) cohesion_height: f64,
    /// The length of the step over the return time.
    pub(super) chance: f64,
}

/// Ground that fails: a node, and the lower one that the rupture surface goes through.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Failure {
    pub(super) node: u32,
    pub(super) foot: u32,
    /// Distance between the two, m.
    pub(super) distance: f64,
    /// The number drawn, 0 to 1: of two the one that drew less fails first.
    pub(super) draw: f64,
}

impl Strength {
    /// The height to which a slope stands, m; infinite where friction alone holds it.
    pub(super) fn critical_height(&self, slope: f64, friction: f64) -> f64 {
        // Sine and cosine of the angle of which this is the tangent.
        let angle = |tangent: f64| {
            let cos = 1.0 / (1.0 + tangent * tangent).sqrt();
            if tangent.is_finite() { (tangent * cos, cos) } else { (1.0, 0.0) }
        };
        let ((sin, cos), (sin_f, cos_f)) = (angle(slope), angle(friction));
        let wedge = 1.0 - (cos * cos_f + sin * sin_f);
        if slope > friction && wedge > 0.0 { self.cohesion_height * sin * cos_f / wedge } else { f64::INFINITY }
    }

    /// All ground that fails in a step, in the order in which it does; `friction` is the tangent of
    /// the friction angle at a node. **Cost** O(nodes).
    pub(super) fn failures<D: Domain>(
        &self,
        domain: &D,
        z: &[f64],
        friction: impl Fn(usize) -> f64 + Sync,
        seed: Seed,
    ) -> Vec<Failure> {
        let status = domain.status();
        let pieces = parallel::map_pieces(z.len(), |range| {
            let inner = range.filter(|&i| status[i] == Status::Interior);
            inner.filter_map(|i| self.failure(domain, z, i, friction(i), seed)).collect::<Vec<_>>()
        });
        let mut all: Vec<Failure> = pieces.into_iter().flatten().collect();
        all.sort_unstable_by(|a, b| a.draw.total_cmp(&b.draw).then(a.node.cmp(&b.node)));
        all
    }

    fn failure<D: Domain>(&self, domain: &D, z: &[f64], node: usize, friction: f64, seed: Seed) -> Option<Failure> {
        let (foot, slot) = domain.steepest(z, node)?;
        let distance = domain.distance(node, slot);
        let height = z[node] - z[foot];
        let slope = height / distance;
        if !(slope > friction) {
            return None;
        }
        let draw = seed.uniform(node as u64);
        let probability = height / self.critical_height(slope, friction) * self.chance;
        (draw < probability).then_some(Failure { node: node as u32, foot: foot as u32, distance, draw })
    }
}
