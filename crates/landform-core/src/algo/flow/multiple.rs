//! Multiple flow: water that is shared among all lower neighbours.
//!
//! # Method
//! Every node shares its amount among its lower neighbours in proportion to (slope)^p. Lower means
//! by the level to which water rises, so that a lake passes all on along its carved path and no
//! water runs in a circle. Nodes are taken from the highest level down; of equal levels donors come
//! first.
//!
//! # Sources
//! Freeman (1991), with p = 1.1 there; Quinn et al. (1991) weigh by contour length instead, which
//! is left out here.

use super::Flow;
use crate::grid::Domain;
use crate::{math, parallel};

impl Flow {
    /// Nodes from the highest water level down; of equal levels donors come first.
    pub(super) fn highest_first(&self, level: &[f64]) -> Vec<u32> {
        let mut place = vec![0u32; level.len()];
        for (k, &i) in self.order.iter().enumerate() {
            place[i as usize] = k as u32;
        }
        let mut order = self.order.clone();
        parallel::sort_by(&mut order, |&a, &b| {
            let (a, b) = (a as usize, b as usize);
            level[b].total_cmp(&level[a]).then(place[a].cmp(&place[b]))
        });
        order
    }

    /// Replaces `amount` (the amount of each node itself) by the amount that passes through each
    /// node, shared among all lower neighbours. To be called after [`Flow::route`] over the same
    /// elevation. **Cost** O(n log n).
    pub fn accumulate_multiple<D: Domain>(&self, domain: &D, elevation: &[f64], exponent: f64, amount: &mut [f64]) {
        let level = self.water_level(elevation);
        let mut shares: Vec<(usize, f64)> = Vec::new();
        for &i in &self.highest_first(&level) {
            let i = i as usize;
            let r = self.receiver[i] as usize;
            if r == i {
                continue;
            }
            shares.clear();
            if level[i] == elevation[i] {
                let lower = domain.neighbours(i).filter(|l| level[l.to] < level[i]);
                shares.extend(lower.map(|l| (l.to, math::pow((level[i] - level[l.to]) / l.distance, exponent))));
            }
            let total: f64 = shares.iter().map(|s| s.1).sum();
            if total > 0.0 {
                for &(to, share) in &shares {
                    amount[to] += amount[i] * (share / total);
                }
            } else {
                amount[r] += amount[i];
            }
        }
    }
}
