//! Donors before receivers, and sums down the flow, in one pass.

use std::ops::Range;

use super::strips::{Strips, split};
use crate::grid::{Domain, NO_SLOT};
use crate::parallel;

const DONE: u8 = u8::MAX;
/// Set on the count of a node with several donors: their sum waits until all are there, and takes them in the order of slots.
const SEVERAL: u8 = 1 << 7;

/// Where water goes.
pub(super) struct Network<'a, D> {
    pub(super) domain: &'a D,
    pub(super) receiver: &'a [u32],
    pub(super) slot: &'a [u8],
}

impl<D> Clone for Network<'_, D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D> Copy for Network<'_, D> {}

/// Orders nodes by counting donors and adds `amount` down the flow on the way.
///
/// From each node without waiting donors the chain of receivers is followed as long as it runs through nodes that the scan
/// has passed; so the order keeps to neighbours in memory. Strips do so side by side, and what lies downstream of a seam comes last.
pub(super) fn order_and_accumulate<D: Domain>(
    network: Network<D>,
    cuts: Vec<Range<usize>>,
    donors: &mut [u8],
    order: &mut [u32],
    amount: &mut [f64],
) -> Strips {
    let leaving = count_donors(network, &cuts, donors);
    let parts = split(donors, &cuts).into_iter().zip(split(order, &cuts)).zip(split(amount, &cuts));
    let parts: Vec<_> = cuts.iter().zip(parts).collect();
    let placed = parallel::run_all(parts, |(strip, ((donors, order), amount))| {
        let mut work = Work { network, first: strip.start, donors, order, amount, placed: 0 };
        (0..strip.len()).for_each(|k| work.follow(k, true));
        work.placed
    });
    let mut own = Vec::with_capacity(cuts.len());
    let mut end = 0;
    for (strip, placed) in cuts.iter().zip(placed) {
        order.copy_within(strip.start..strip.start + placed, end);
        own.push(end..end + placed);
        end += placed;
    }
    // What was done within its strip gives to beyond the seam now.
    let ready: Vec<u32> = leaving.iter().flatten().copied().filter(|&i| donors[i as usize] == DONE).collect();
    let mut work = Work { network, first: 0, donors, order, amount, placed: end };
    for i in ready {
        let next = network.receiver[i as usize] as usize;
        if work.give(i as usize, next) {
            work.follow(next, false);
        }
    }
    debug_assert_eq!(work.placed, work.donors.len(), "receivers form a cycle");
    Strips { nodes: cuts, own, leaving }
}

/// Counts donors; returns the nodes of each strip whose receiver lies in another.
fn count_donors<D: Domain>(network: Network<D>, cuts: &[Range<usize>], donors: &mut [u8]) -> Vec<Vec<u32>> {
    let parts: Vec<_> = cuts.iter().zip(split(donors, cuts)).collect();
    let leaving = parallel::run_all(parts, |(strip, donors)| {
        donors.fill(0);
        let mut leaving = Vec::new();
        for i in strip.clone().filter(|&i| network.slot[i] != NO_SLOT) {
            match donors.get_mut((network.receiver[i] as usize).wrapping_sub(strip.start)) {
                Some(count) => *count += 1,
                None => leaving.push(i as u32),
            }
        }
        leaving
    });
    for &i in leaving.iter().flatten() {
        donors[network.receiver[i as usize] as usize] += 1;
    }
    let mark = |count: u8| if count > 1 { count | SEVERAL } else { count };
    parallel::update(donors, |_, count| *count = mark(*count));
    leaving
}

/// Nodes from `first` on that are ordered in one go.
struct Work<'a, D> {
    network: Network<'a, D>,
    first: usize,
    donors: &'a mut [u8],
    order: &'a mut [u32],
    amount: &'a mut [f64],
    placed: usize,
}

impl<D: Domain> Work<'_, D> {
    /// Places a node (counted from `first`) that waits for no donor, and those downstream that then wait for none. A scan stops where
    /// it will come by itself.
    #[inline]
    fn follow(&mut self, from: usize, scanning: bool) {
        let mut at = from;
        while self.donors[at] & !SEVERAL == 0 {
            let node = self.first + at;
            if self.donors[at] == SEVERAL {
                self.amount[at] = self.sum(node);
            }
            self.donors[at] = DONE;
            self.order[self.placed] = node as u32;
            self.placed += 1;
            if self.network.slot[node] == NO_SLOT {
                return;
            }
            let next = (self.network.receiver[node] as usize).wrapping_sub(self.first);
            if next >= self.donors.len() || !self.give(at, next) || scanning && next > from {
                return;
            }
            at = next;
        }
    }

    /// Passes on what a node has; whether the receiver waits for no other.
    #[inline]
    fn give(&mut self, at: usize, next: usize) -> bool {
        let count = self.donors[next] - 1;
        self.donors[next] = count;
        if count & SEVERAL == 0 {
            self.amount[next] += self.amount[at];
        }
        count & !SEVERAL == 0
    }

    /// A node's own amount and those of its donors, in the order of slots.
    #[inline]
    fn sum(&self, node: usize) -> f64 {
        let Network { domain, receiver, slot } = self.network;
        let gives = |j: usize| receiver[j] as usize == node && slot[j] != NO_SLOT;
        let donors = domain.neighbours(node).map(|l| l.to).filter(|&j| gives(j));
        donors.fold(self.amount[node - self.first], |sum, j| sum + self.amount[j - self.first])
    }
}
