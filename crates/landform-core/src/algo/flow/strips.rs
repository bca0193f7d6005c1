//! Strips of nodes that are worked on side by side.
//!
//! # Method
//! Nodes are cut into strips of neighbouring indices. Within a strip all values are found that need
//! none from beyond its seams. Nodes downstream of a seam are done in one pass at the end; they are
//! few, since streams join. The cut changes no bit: sums take donors in an order that does not
//! depend on strips, and a value found upwards depends on the receiver's alone.
//!
//! The number of strips follows from the number of nodes, not from that of threads, so that the
//! order of nodes is the same on any machine.

use std::ops::Range;

use super::Flow;
use crate::grid::Domain;
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

/// Brings a strip's values near in one sweep. Flow visits them in an order that no processor
/// foresees, and would wait for each.
pub(super) fn fetch<T: Copy>(values: &[T]) {
    let line = (64 / size_of::<T>().max(1)).max(1);
    values.iter().step_by(line).for_each(|v| _ = std::hint::black_box(*v));
}

/// Receivers of a strip's nodes, and their slots.
pub(super) struct Receivers<'a> {
    pub(super) strip: Range<usize>,
    pub(super) receiver: &'a mut [u32],
    pub(super) slot: &'a mut [u8],
}

/// Receivers and slots, strip by strip.
pub(super) fn split_receivers<'a>(
    receiver: &'a mut [u32],
    slot: &'a mut [u8],
    strips: &[Range<usize>],
) -> Vec<Receivers<'a>> {
    let parts = split(receiver, strips).into_iter().zip(split(slot, strips)).zip(strips);
    parts.map(|((receiver, slot), strip)| Receivers { strip: strip.clone(), receiver, slot }).collect()
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
    /// Finds values from the outlets upwards: `value(node, its own, its receiver's new one)`
    /// becomes the node's; nodes without a receiver keep theirs. **Cost** O(n), strips side by
    /// side.
    pub fn up<T: Copy + Send + Sync>(&self, values: &mut [T], value: impl Fn(usize, T, T) -> T + Sync) {
        let mut nothing = vec![(); values.len()];
        self.up_with(values, &mut nothing, |node, own, below, ()| value(node, own, below));
    }

    /// As [`Flow::up`], with a second value of each node that is at hand where its first is found,
    /// and may change there: `value(node, its own, its receiver's new one, its second)`. Memory
    /// that is used twice is fetched once.
    ///
    /// ```
    /// use landform_core::algo::flow::{Flow, node_areas};
    /// use landform_core::grid::{Edge, Edges, Grid, RasterDomain, Shape};
    ///
    /// let mut grid = Grid::new(Shape::new(3, 4), [10.0, 10.0])?;
    /// grid.edges = Edges { east: Edge::Open, ..Edges::all(Edge::Closed) };
    /// let domain = RasterDomain::new(&grid, &[]);
    /// let (mut flow, mut area) = (Flow::new(), node_areas(&domain));
    /// let mut z = [3.0, 2.0, 1.0, 0.0].repeat(3);
    /// flow.route(&domain, &z, &mut area);
    /// // Every node sinks half of the way to its receiver; its area becomes what it sank.
    /// flow.up_with(&mut z, &mut area, |_, own, below, area| {
    ///     *area = 0.5 * (own - below);
    ///     own - *area
    /// });
    /// assert_eq!(z[..4], [2.125, 1.25, 0.5, 0.0]);
    /// assert_eq!(area[..3], [0.875, 0.75, 0.5]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn up_with<T: Copy + Send + Sync, U: Copy + Send>(
        &self,
        values: &mut [T],
        seconds: &mut [U],
        value: impl Fn(usize, T, T, &mut U) -> T + Sync,
    ) {
        self.climb(&self.order[self.strips.rest()..], 0, (values, seconds), (&[], &[]), &value);
        // What strips need of each other lies downstream of seams, and is found by now.
        let beyond = |nodes: &Vec<u32>| nodes.iter().map(|&i| values[self.receiver[i as usize] as usize]).collect();
        let beyond: Vec<Vec<T>> = self.strips.leaving.iter().map(beyond).collect();
        let parts = split(values, &self.strips.nodes).into_iter().zip(split(seconds, &self.strips.nodes)).enumerate();
        parallel::run_all(parts.collect(), |(k, part): (usize, (&mut [T], &mut [U]))| {
            let Strips { nodes, own, leaving } = &self.strips;
            fetch(&self.receiver[nodes[k].clone()]);
            fetch(part.0);
            fetch(part.1);
            self.climb(&self.order[own[k].clone()], nodes[k].start, part, (&leaving[k], &beyond[k]), &value);
        });
    }

    /// Finds the values of nodes, the last of the order first; `part` and `seconds` hold those of
    /// the nodes from `first` on, `beyond` what receivers outside of it have, by donor. One place
    /// that calls `value`, so that it becomes part of the loop.
    fn climb<T: Copy, U: Copy>(
        &self,
        order: &[u32],
        first: usize,
        (part, seconds): (&mut [T], &mut [U]),
        beyond: (&[u32], &[T]),
        value: &impl Fn(usize, T, T, &mut U) -> T,
    ) {
        for &node in order.iter().rev() {
            let i = node as usize;
            let receiver = self.receiver[i] as usize;
            if receiver == i {
                continue;
            }
            let below = match part.get(receiver.wrapping_sub(first)) {
                Some(below) => *below,
                None => beyond.0.binary_search(&node).map_or(part[i - first], |at| beyond.1[at]),
            };
            part[i - first] = value(i, part[i - first], below, &mut seconds[i - first]);
        }
    }

    /// Sums values from the divides downwards: each node's becomes its own and, in the order of
    /// slots, what its donors pass on: `passed(donor, its sum)`. **Cost** O(n) looks at all
    /// neighbours, strips side by side.
    pub fn down<D: Domain, T: Copy + Send + Sync>(
        &self,
        domain: &D,
        values: &mut [T],
        add: impl Fn(T, T) -> T + Sync,
        passed: impl Fn(usize, T) -> T + Sync,
    ) {
        let parts = split(values, &self.strips.nodes).into_iter().enumerate().collect();
        parallel::run_all(parts, |(k, part): (usize, &mut [T])| {
            let first = self.strips.nodes[k].start;
            fetch(&self.receiver[self.strips.nodes[k].clone()]);
            fetch(part);
            for &node in &self.order[self.strips.own[k].clone()] {
                let i = node as usize;
                let mut sum = part[i - first];
                domain.each_donor(i, &self.receiver, |j| sum = add(sum, passed(j, part[j - first])));
                part[i - first] = sum;
            }
        });
        for &node in &self.order[self.strips.rest()..] {
            let i = node as usize;
            let mut sum = values[i];
            domain.each_donor(i, &self.receiver, |j| sum = add(sum, passed(j, values[j])));
            values[i] = sum;
        }
    }
}
