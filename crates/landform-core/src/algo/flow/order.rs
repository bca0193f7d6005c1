//! Donors before receivers, and sums down the flow, in one pass.
//!
//! # Method
//! A scan over all nodes follows, from each node that waits for no donor, the chain of receivers as
//! long as it runs through nodes that the scan has passed; so the order keeps to neighbours in
//! memory. A donor gives when the scan stands at the highest index upstream of it: this *time*
//! follows from the tree alone, and sums take donors in its order.
//!
//! Strips scan side by side. Nodes downstream of a seam are left out; they are few, since streams
//! join. Amounts that reach them are noted with their time and added at the end in order of time.
//! So every sum is that of one scan over all, to the bit.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use super::strips::{Strips, fetch, split};
use crate::parallel;

const DONE: u8 = u8::MAX;
/// Set on the count of donors of a node downstream of a seam.
const BEYOND: u8 = 1 << 7;

/// An amount that a strip passes on to nodes downstream of seams.
struct Inflow {
    donor: u32,
    /// Where the scan stood.
    time: u32,
}

/// Orders nodes by counting donors and adds `amount` down the flow on the way.
pub(super) fn order_and_accumulate(
    receiver: &[u32],
    cuts: Vec<Range<usize>>,
    donors: &mut [u8],
    order: &mut [u32],
    amount: &mut [f64],
) -> Strips {
    let leaving = count_donors(receiver, &cuts, donors);
    mark_beyond(receiver, &leaving, donors);
    let parts = split(donors, &cuts).into_iter().zip(split(order, &cuts)).zip(split(amount, &cuts));
    let parts: Vec<_> = cuts.iter().zip(parts).collect();
    let scanned = parallel::run_all(parts, |(strip, ((donors, order), amount))| {
        scan(&receiver[strip.clone()], strip.start, donors, order, amount)
    });
    let mut own = Vec::with_capacity(cuts.len());
    let mut end = 0;
    for (strip, (placed, _)) in cuts.iter().zip(&scanned) {
        order.copy_within(strip.start..strip.start + placed, end);
        own.push(end..end + placed);
        end += placed;
    }
    let mut rest = BeyondSeams { receiver, donors, order, amount, placed: end, later: BinaryHeap::new() };
    // Strips come one after the other, and so do their times.
    for inflow in scanned.iter().flat_map(|(_, inflows)| inflows) {
        rest.until(inflow.time);
        rest.pass_on(inflow.donor as usize, inflow.time);
    }
    rest.until(u32::MAX);
    debug_assert_eq!(rest.placed, receiver.len(), "receivers form a cycle");
    Strips { nodes: cuts, own, leaving }
}

/// Counts donors; returns the nodes of each strip whose receiver lies in another.
fn count_donors(receiver: &[u32], cuts: &[Range<usize>], donors: &mut [u8]) -> Vec<Vec<u32>> {
    let parts: Vec<_> = cuts.iter().zip(split(donors, cuts)).collect();
    let leaving = parallel::run_all(parts, |(strip, donors)| {
        donors.fill(0);
        let mut leaving = Vec::new();
        for (i, &to) in strip.clone().zip(&receiver[strip.clone()]) {
            match donors.get_mut((to as usize).wrapping_sub(strip.start)) {
                Some(count) => *count += u8::from(to as usize != i),
                None => leaving.push(i as u32),
            }
        }
        leaving
    });
    for &i in leaving.iter().flatten() {
        donors[receiver[i as usize] as usize] += 1;
    }
    leaving
}

/// Marks the nodes downstream of seams.
fn mark_beyond(receiver: &[u32], leaving: &[Vec<u32>], donors: &mut [u8]) {
    for &i in leaving.iter().flatten() {
        let mut node = receiver[i as usize] as usize;
        while donors[node] & BEYOND == 0 {
            donors[node] |= BEYOND;
            node = receiver[node] as usize;
        }
    }
}

/// Orders a strip's own nodes; returns how many there are, and what they pass_on to beyond.
fn scan(
    receiver: &[u32],
    first: usize,
    donors: &mut [u8],
    order: &mut [u32],
    amount: &mut [f64],
) -> (usize, Vec<Inflow>) {
    let (mut placed, mut inflows) = (0, Vec::new());
    fetch(receiver);
    fetch(amount);
    for from in 0..receiver.len() {
        let mut at = from;
        while donors[at] == 0 {
            donors[at] = DONE;
            order[placed] = (first + at) as u32;
            placed += 1;
            let next = (receiver[at] as usize).wrapping_sub(first);
            if next == at {
                break;
            }
            if next >= donors.len() || donors[next] & BEYOND != 0 {
                inflows.push(Inflow { donor: (first + at) as u32, time: (first + from) as u32 });
                break;
            }
            amount[next] += amount[at];
            donors[next] -= 1;
            if next > from {
                break;
            }
            at = next;
        }
    }
    (placed, inflows)
}

/// The nodes downstream of seams.
struct BeyondSeams<'a> {
    receiver: &'a [u32],
    donors: &'a mut [u8],
    order: &'a mut [u32],
    amount: &'a mut [f64],
    placed: usize,
    /// Nodes that wait for no donor any more, but for the scan to come.
    later: BinaryHeap<Reverse<u32>>,
}

impl BeyondSeams<'_> {
    /// Lets the scan come to a time.
    fn until(&mut self, time: u32) {
        while self.later.peek().is_some_and(|next| next.0 < time) {
            if let Some(Reverse(node)) = self.later.pop() {
                self.place(node as usize, node);
            }
        }
    }

    /// Gives what a node has to its receiver, and places what then waits for nothing.
    fn pass_on(&mut self, donor: usize, time: u32) {
        let to = self.receiver[donor] as usize;
        self.amount[to] += self.amount[donor];
        self.donors[to] -= 1;
        if self.donors[to] != BEYOND {
            return;
        }
        if to as u32 <= time { self.place(to, time) } else { self.later.push(Reverse(to as u32)) }
    }

    /// Places a node and those downstream that then wait for nothing.
    fn place(&mut self, node: usize, time: u32) {
        let mut node = node;
        loop {
            self.donors[node] = DONE;
            self.order[self.placed] = node as u32;
            self.placed += 1;
            let to = self.receiver[node] as usize;
            if to == node {
                return;
            }
            self.amount[to] += self.amount[node];
            self.donors[to] -= 1;
            if self.donors[to] != BEYOND {
                return;
            }
            if to as u32 > time {
                self.later.push(Reverse(to as u32));
                return;
            }
            node = to;
        }
    }
}
