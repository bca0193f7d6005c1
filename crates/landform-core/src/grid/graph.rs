//! An irregular planar graph with areas: the graph of a mesh.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::{Domain, Link, NO_SLOT, Neighbours, Status, is_below};
use crate::parallel;

/// Nodes with links in compressed rows. Links of a node are sorted counter-clockwise from its
/// first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Graph {
    start: Vec<u32>,
    to: Vec<u32>,
    inverse_distance: Vec<f64>,
    conductance: Vec<f64>,
    back: Vec<u8>,
    closed_fan: Vec<bool>,
    area: Vec<f64>,
    status: Vec<Status>,
}

/// Links of all nodes while a graph is built: neighbour, 1/distance, conductance.
#[derive(Debug, Default)]
pub(crate) struct Links {
    to: Vec<u32>,
    inverse_distance: Vec<f64>,
    conductance: Vec<f64>,
}

impl Links {
    pub(crate) fn with_capacity(n: usize) -> Self {
        let reals = || Vec::with_capacity(n);
        Self { to: Vec::with_capacity(n), inverse_distance: reals(), conductance: reals() }
    }

    pub(crate) fn push(&mut self, to: u32, inverse_distance: f64, conductance: f64) {
        self.to.push(to);
        self.inverse_distance.push(inverse_distance);
        self.conductance.push(conductance);
    }

    pub(crate) fn len(&self) -> usize {
        self.to.len()
    }

    pub(crate) fn reverse_from(&mut self, begin: usize) {
        self.to[begin..].reverse();
        self.inverse_distance[begin..].reverse();
        self.conductance[begin..].reverse();
    }
}

impl Graph {
    /// From each node's links in counter-clockwise order (`start` has one entry more than there are
    /// nodes), whether they close a full turn, areas and status. Every link must be present from
    /// both ends.
    pub(crate) fn new(
        start: Vec<u32>,
        links: Links,
        closed_fan: Vec<bool>,
        area: Vec<f64>,
        status: Vec<Status>,
    ) -> Self {
        let Links { to, inverse_distance, conductance } = links;
        let row = |i: usize| start[i] as usize..start[i + 1] as usize;
        let mut back = vec![NO_SLOT; to.len()];
        for i in 0..area.len() {
            for q in row(i) {
                let j = to[q] as usize;
                back[q] = to[row(j)].iter().position(|&k| k as usize == i).map_or(NO_SLOT, |p| p as u8);
            }
        }
        Self { back, inverse_distance, conductance, start, to, closed_fan, area, status }
    }

    #[inline]
    fn row(&self, node: usize) -> Range<usize> {
        self.start[node] as usize..self.start[node + 1] as usize
    }

    /// Areas of all nodes, m².
    pub fn areas(&self) -> &[f64] {
        &self.area
    }
}

impl Neighbours for Graph {
    fn len(&self) -> usize {
        self.area.len()
    }

    fn neighbours(&self, node: usize) -> impl Iterator<Item = Link> {
        self.row(node).filter(|&q| self.status[self.to[q] as usize] != Status::Masked).map(move |q| Link {
            to: self.to[q] as usize,
            distance: 1.0 / self.inverse_distance[q],
            slot: (q - self.start[node] as usize) as u8,
        })
    }
}

impl Domain for Graph {
    #[inline]
    fn area(&self, node: usize) -> f64 {
        self.area[node]
    }

    fn status(&self) -> &[Status] {
        &self.status
    }

    #[inline]
    fn neighbour(&self, node: usize, slot: u8) -> usize {
        self.to[self.start[node] as usize + slot as usize] as usize
    }

    #[inline]
    fn distance(&self, node: usize, slot: u8) -> f64 {
        1.0 / self.inverse_distance[self.start[node] as usize + slot as usize]
    }

    #[inline]
    fn conductance(&self, node: usize, slot: u8) -> f64 {
        self.conductance[self.start[node] as usize + slot as usize]
    }

    #[inline]
    fn slot_back(&self, node: usize, slot: u8) -> u8 {
        self.back[self.start[node] as usize + slot as usize]
    }

    #[inline]
    fn steepest(&self, elevation: &[f64], node: usize) -> Option<(usize, u8)> {
        let z = elevation[node];
        let row = self.row(node);
        let (mut best, mut at) = (0.0, usize::MAX);
        let links = self.to[row.clone()].iter().zip(&self.inverse_distance[row.clone()]);
        for (q, (&to, &inverse)) in links.enumerate() {
            let slope = (z - elevation[to as usize]) * inverse;
            let steeper = slope > best;
            best = if steeper { slope } else { best };
            at = if steeper { q } else { at };
        }
        (at != usize::MAX).then(|| (self.to[row.start + at] as usize, at as u8))
    }

    fn saddles(&self, elevation: &[f64], saddle: &mut [u8]) {
        parallel::update(saddle, |node, saddle| {
            let row = self.row(node);
            let z = elevation[node];
            // Arcs begin where lower follows upon not lower.
            let (mut arcs, mut before, mut first) = (0, false, false);
            for (q, &to) in self.to[row].iter().enumerate() {
                let other = elevation[to as usize];
                let lower = (other < z) | ((other == z) & ((to as usize) < node));
                first = if q == 0 { lower } else { first };
                arcs += u8::from(lower & !before);
                before = lower;
            }
            // An arc that runs over the start of a closed fan was counted twice.
            arcs -= u8::from(self.closed_fan[node] & first & before & (arcs > 1));
            *saddle = u8::from(arcs > 1 || self.status[node] == Status::BaseLevel);
        });
    }

    fn lower_arcs(&self, elevation: &[f64], node: usize, own: u8, mut visit: impl FnMut(u8)) {
        let row = self.row(node);
        let lower = |slot: usize| {
            let to = self.to[row.start + slot] as usize;
            self.status[to] != Status::Masked && is_below(elevation, to, node)
        };
        let degree = row.len();
        // Begin after a gap, so that no arc is cut; without a gap all is one arc.
        let gap = (0..degree).find(|&k| !lower(k));
        let start = if self.closed_fan[node] { gap.map_or(0, |g| g + 1) } else { 0 };
        let mut arc: Option<(u8, bool)> = None;
        let mut close = |arc: Option<(u8, bool)>| {
            if let Some((slot, false)) = arc {
                visit(slot);
            }
        };
        for k in 0..degree {
            let slot = (start + k) % degree;
            if lower(slot) {
                let (first, owned) = arc.unwrap_or((slot as u8, false));
                arc = Some((first, owned || slot == own as usize));
            } else {
                close(arc.take());
            }
        }
        close(arc);
    }

    fn set_status(&mut self, status: Vec<Status>) {
        self.status = status;
    }
}
