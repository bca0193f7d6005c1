//! An irregular planar graph with areas: a mesh as flow sees it.

use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::{Domain, INTERIOR, Link, MASKED, NO_SLOT};
use crate::parallel;

/// Nodes with links in compressed rows. Links of a node are sorted counter-clockwise from its first.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Graph {
    start: Vec<u32>,
    to: Vec<u32>,
    inverse_distance: Vec<f64>,
    conductance: Vec<f64>,
    back: Vec<u8>,
    closed_fan: Vec<bool>,
    area: Vec<f64>,
    status: Vec<u8>,
}

/// Links of one node while a graph is built: neighbour, distance, conductance.
pub(crate) type RawLink = (u32, f64, f64);

impl Graph {
    /// From each node's links in counter-clockwise order (`start` has one entry more than there are nodes), whether they
    /// close a full turn, areas and status. Every link must be present from both ends.
    pub(crate) fn new(start: Vec<u32>, links: &[RawLink], closed_fan: Vec<bool>, area: Vec<f64>, status: Vec<u8>) -> Self {
        let to: Vec<u32> = links.iter().map(|l| l.0).collect();
        let row = |i: usize| start[i] as usize..start[i + 1] as usize;
        let mut back = vec![NO_SLOT; to.len()];
        for i in 0..area.len() {
            for q in row(i) {
                let j = to[q] as usize;
                back[q] = to[row(j)].iter().position(|&k| k as usize == i).map_or(NO_SLOT, |p| p as u8);
            }
        }
        Self {
            back,
            inverse_distance: links.iter().map(|l| 1.0 / l.1).collect(),
            conductance: links.iter().map(|l| l.2).collect(),
            start,
            to,
            closed_fan,
            area,
            status,
        }
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

impl Domain for Graph {
    fn len(&self) -> usize {
        self.area.len()
    }

    #[inline]
    fn area(&self, node: usize) -> f64 {
        self.area[node]
    }

    fn status(&self) -> &[u8] {
        &self.status
    }

    fn neighbours(&self, node: usize) -> impl Iterator<Item = Link> {
        self.row(node)
            .filter(|&q| self.status[self.to[q] as usize] != MASKED)
            .map(move |q| Link {
                to: self.to[q] as usize,
                distance: 1.0 / self.inverse_distance[q],
                slot: (q - self.start[node] as usize) as u8,
            })
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
    fn adjacent_slots(&self, node: usize, a: u8, b: u8) -> bool {
        let apart = a.abs_diff(b);
        apart == 1 || (self.closed_fan[node] && apart as usize + 1 == self.row(node).len())
    }

    fn steepest_descent(&self, elevation: &[f64], receiver: &mut [u32], slot: &mut [u8]) {
        parallel::for_pieces_mut2(receiver, slot, parallel::PIECE, |first, receivers, slots| {
            for (k, (r, s)) in receivers.iter_mut().zip(slots).enumerate() {
                let node = first + k;
                (*r, *s) = (node as u32, NO_SLOT);
                if self.status[node] != INTERIOR {
                    continue;
                }
                let z = elevation[node];
                let row = self.row(node);
                let (mut best, mut at) = (0.0, usize::MAX);
                for (q, (&to, &inverse)) in self.to[row.clone()].iter().zip(&self.inverse_distance[row.clone()]).enumerate() {
                    let slope = (z - elevation[to as usize]) * inverse;
                    let steeper = slope > best;
                    best = if steeper { slope } else { best };
                    at = if steeper { q } else { at };
                }
                if at != usize::MAX {
                    (*r, *s) = (self.to[row.start + at], at as u8);
                }
            }
        });
    }

    #[inline]
    fn for_each_link(&self, nodes: Range<usize>, mut visit: impl FnMut(usize, u8, usize, u8)) {
        for a in nodes {
            let row = self.row(a);
            for q in row.clone() {
                let b = self.to[q] as usize;
                if b > a && self.status[a] != MASKED && self.status[b] != MASKED {
                    visit(a, (q - row.start) as u8, b, self.back[q]);
                }
            }
        }
    }

    fn with_status(&self, status: Vec<u8>) -> Self {
        Self { status, ..self.clone() }
    }
}
