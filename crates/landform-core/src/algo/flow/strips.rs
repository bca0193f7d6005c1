//! Strips of nodes that are worked on side by side.
//!
//! # Method
//! Nodes are cut into strips of neighbouring indices. Within a strip everything is found that needs nothing from beyond its seams; what
//! lies downstream of a seam is left to the end and done in one go: few nodes, since streams join. How the cut runs changes no bit:
//! sums take donors in the order of slots, and a value found upwards depends on the receiver's alone.
//!
//! The number of strips follows from the number of nodes, not from that of threads, so that the order of nodes is the same on any machine.

use std::ops::Range;

use super::Flow;
use crate::grid::{Domain, NO_SLOT};
use crate::parallel;

/// Nodes of a strip, at least.
const LEAST: usize = 1 << 16;
/// Strips, at most.
const MOST: usize = 16;

/// The strips of `n` nodes: `wanted` of them, or as many as suit `n`.
pub(super) fn cut(n: usize, wanted: Option<usize>) -> Vec<Range<usize>> {
    let count = wanted.unwrap_or((n / LEAST).clamp(1, MOST)).clamp(1, n.max(1));
    (0..count).map(|k| n * k / count..n * (k + 1) / count).collect()
}

/// A slice as its strips.
pub(super) fn split<'a, T>(mut values: &'a mut [T], strips: &[Range<usize>]) -> Vec<&'a mut [T]> {
    let mut parts = Vec::with_capacity(strips.len());
    for strip in strips {
        let (part, rest) = values.split_at_mut(strip.len());
        parts.push(part);
        values = rest;
    }
    parts
}

/// The order of nodes, by strips: each strip's own nodes, then all that lies downstream of a seam.
#[derive(Clone, Debug, Default)]
pub(super) struct Strips {
    /// The nodes of each strip.
    pub(super) nodes: Vec<Range<usize>>,
    /// The places in the order of each strip's own nodes.
    pub(super) own: Vec<Range<usize>>,
    /// Nodes of each strip whose receiver lies in another, in order.
    pub(super) leaving: Vec<Vec<u32>>,
}

impl Strips {
    /// The first place in the order of what lies downstream of a seam.
    pub(super) fn rest(&self) -> usize {
        self.own.last().map_or(0, |r| r.end)
    }
}

impl Flow {
    /// Finds values from the outlets upwards: `value(node, its own, its receiver's new one)` becomes the node's; nodes without a
    /// receiver keep theirs. **Cost** O(n), strips side by side.
    pub fn up<T: Copy + Send + Sync>(&self, values: &mut [T], value: impl Fn(usize, T, T) -> T + Sync) {
        let rest = self.strips.rest();
        for &i in self.order[rest..].iter().rev() {
            let i = i as usize;
            if self.slot[i] != NO_SLOT {
                values[i] = value(i, values[i], values[self.receiver[i] as usize]);
            }
        }
        // What strips need of each other lies downstream of seams, and is found by now.
        let beyond = |nodes: &Vec<u32>| nodes.iter().map(|&i| values[self.receiver[i as usize] as usize]).collect();
        let beyond: Vec<Vec<T>> = self.strips.leaving.iter().map(beyond).collect();
        let parts = split(values, &self.strips.nodes).into_iter().enumerate().collect();
        parallel::run_all(parts, |(k, part): (usize, &mut [T])| {
            let (strip, leaving) = (&self.strips.nodes[k], &self.strips.leaving[k]);
            for &node in self.order[self.strips.own[k].clone()].iter().rev() {
                let i = node as usize;
                if self.slot[i] == NO_SLOT {
                    continue;
                }
                let receiver = self.receiver[i] as usize;
                let below = match receiver.wrapping_sub(strip.start) {
                    r if r < part.len() => part[r],
                    _ => leaving.binary_search(&node).map_or(part[i - strip.start], |at| beyond[k][at]),
                };
                part[i - strip.start] = value(i, part[i - strip.start], below);
            }
        });
    }

    /// Sums values from the divides downwards: each node's becomes its own and, in the order of slots, what its donors pass on:
    /// `passed(donor, its sum)`. **Cost** O(n) looks at all neighbours, strips side by side.
    pub fn down<D: Domain, T: Copy + Send + Sync>(
        &self,
        domain: &D,
        values: &mut [T],
        add: impl Fn(T, T) -> T + Sync,
        passed: impl Fn(usize, T) -> T + Sync,
    ) {
        let sum = |node: usize, own: T, of: &dyn Fn(usize) -> T| {
            let donors = domain.neighbours(node).map(|l| l.to).filter(|&j| self.gives_to(j, node));
            donors.fold(own, |sum, j| add(sum, passed(j, of(j))))
        };
        let parts = split(values, &self.strips.nodes).into_iter().enumerate().collect();
        parallel::run_all(parts, |(k, part): (usize, &mut [T])| {
            let first = self.strips.nodes[k].start;
            for &node in &self.order[self.strips.own[k].clone()] {
                let i = node as usize;
                part[i - first] = sum(i, part[i - first], &|j| part[j - first]);
            }
        });
        for &node in &self.order[self.strips.rest()..] {
            let i = node as usize;
            values[i] = sum(i, values[i], &|j| values[j]);
        }
    }

    /// Whether a node passes its water on to another.
    #[inline]
    pub(super) fn gives_to(&self, donor: usize, node: usize) -> bool {
        self.receiver[donor] as usize == node && self.slot[donor] != NO_SLOT
    }
}
