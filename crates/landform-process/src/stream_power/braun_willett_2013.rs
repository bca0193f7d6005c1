//! The implicit sweep.
//!
//! # Sources
//! Braun & Willett (2013): one pass from the outlets upwards, with the receiver's new elevation.

use landform_core::algo::flow::Flow;
use landform_core::grid::Domain;

use super::law::Law;
use super::rock::Rock;

/// Lowers every node towards its receiver, from the outlets upwards. `area` is drainage area; where
/// a node has a receiver, it becomes what the node was lowered by, m.
pub(super) fn sweep<D: Domain>(domain: &D, flow: &Flow, law: &Law, rock: &Rock, area: &mut [f64], z: &mut [f64]) {
    let slots = flow.slots();
    flow.up_with(z, area, |i, old, below, area| {
        let base = below.max(law.sea_level);
        let through = std::mem::take(area);
        // Lake floors lie at or below their receivers.
        if !(old > base) {
            return old;
        }
        // Roots and divisions overlap with the wait for memory: a pass of their own would cost
        // more, even on two threads.
        let (length, erodibility) = (domain.distance(i, slots[i]), rock.erodibility.at(i));
        let strength = law.strength(erodibility, through, length);
        // The threshold reduces the rate of lowering.
        let spared = law.threshold * erodibility * law.dt;
        let worn = law.worn(old + spared - base, strength, law.limiting_slope * length).min(old - base);
        let new = base + law.standing(worn, law.greatest_slope * length, length).0;
        *area = old - new;
        new
    });
}
