//! Rounds of a uniform sea that all coasts damp together, without looking at every site.
//!
//! # Method
//! The force is the same at every site, so the sites that fall are those of least resistance: they
//! are kept in a heap. A site whose resistance changes is put in again; what is out of date is
//! dropped when it comes up. A round costs O(c log n) for c changes; those of [`Front::round`],
//! which falls the same sites, cost the coast's length.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use landform_core::algo::depression::Height;

use super::front::{Drive, Front, Round};

/// Sites of the coast by their resistance, those out of date among them.
pub(super) struct Weakest {
    heap: BinaryHeap<Reverse<(Height, u32)>>,
}

impl Weakest {
    /// Of all sites of a front's coast.
    pub(super) fn new(front: &mut Front) -> Self {
        let sites = front.follow();
        let mut weakest = Self { heap: BinaryHeap::new() };
        sites.into_iter().for_each(|site| weakest.put(front, site));
        weakest
    }

    fn put(&mut self, front: &Front, site: usize) {
        if let Some(resistance) = front.resists(site) {
            self.heap.push(Reverse((Height(resistance), site as u32)));
        }
    }

    /// A round of [`Front::round`] by a sea of `force` and `damping`, without wear.
    pub(super) fn round(&mut self, front: &mut Front, (force, damping): (f64, f64), drive: &Drive) -> Round {
        front.take_changed().into_iter().for_each(|site| self.put(front, site));
        let pressure = force / (1.0 + damping * front.lengthened());
        let (mut fallen, mut needed) = (Vec::new(), f64::INFINITY);
        while let Some(&Reverse((Height(resistance), site))) = self.heap.peek() {
            let site = site as usize;
            if front.resists(site) == Some(resistance) {
                if resistance >= pressure {
                    needed = if pressure > 0.0 { resistance / pressure } else { f64::INFINITY };
                    break;
                }
                fallen.push(site);
            }
            self.heap.pop();
        }
        fallen.sort_unstable();
        fallen.dedup();
        front.fall(&fallen, drive);
        Round { fallen, needed }
    }
}
