//! Where a river comes from, where it goes, and which nodes are its banks.

use landform_core::grid::{Domain, Neighbours, Status};
use landform_core::terrain::NodeSurface;

/// In place of a node that is not there.
const NO_NODE: u32 = u32::MAX;

/// A side of a river, for one who looks downstream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// Least sine of the angle between the river and the direction of its bank.
const SQUAREST_BELOW: f64 = 0.5;

/// The rivers of a surface.
pub(super) struct Course<'a, T: NodeSurface> {
    terrain: &'a T,
    domain: &'a T::Domain,
    receiver: &'a [u32],
    /// Nodes with at least the least drainage area that drain to another.
    rivers: Vec<usize>,
    /// The donor with the largest drainage area of each node, if it is a river.
    above: Vec<u32>,
}

impl<'a, T: NodeSurface> Course<'a, T> {
    pub(super) fn new(terrain: &'a T, domain: &'a T::Domain, receiver: &'a [u32], area: &[f64], least: f64) -> Self {
        let status = domain.status();
        let runs = |i: usize| area[i] >= least && receiver[i] as usize != i && status[i] == Status::Interior;
        let rivers: Vec<usize> = (0..area.len()).filter(|&i| runs(i)).collect();
        let mut above = vec![NO_NODE; area.len()];
        for &node in &rivers {
            let slot = &mut above[receiver[node] as usize];
            if *slot == NO_NODE || area[node] > area[*slot as usize] {
                *slot = node as u32;
            }
        }
        Self { terrain, domain, receiver, rivers, above }
    }

    /// Nodes of rivers, in order.
    pub(super) fn rivers(&self) -> &[usize] {
        &self.rivers
    }

    /// The node below a node of a river, and the distance to it, m.
    pub(super) fn below(&self, node: usize) -> (usize, f64) {
        let below = self.receiver[node] as usize;
        let link = self.domain.neighbours(node).find(|link| link.to == below);
        // Through a pass the node below is no neighbour.
        let [x, y] = self.way(node, below);
        (below, link.map_or((x * x + y * y).sqrt(), |link| link.distance))
    }

    /// The share of a river's wear that a side takes.
    pub(super) fn share(&self, node: usize, side: Side) -> f64 {
        let two = |mut node: usize, next: &dyn Fn(usize) -> usize| {
            node = next(node);
            next(node)
        };
        let up = |i: usize| if self.above[i] == NO_NODE { i } else { self.above[i] as usize };
        let down = |i: usize| self.receiver[i] as usize;
        let (came, goes) = (self.way(two(node, &up), node), self.way(node, two(node, &down)));
        // Above 0 where the river turns left, and wears its right bank.
        let left = sine(came, goes);
        match side {
            Side::Left => 0.5 * (1.0 - left),
            Side::Right => 0.5 * (1.0 + left),
        }
    }

    /// The node beside a river on a side that stands most squarely to its course; none if none
    /// does.
    pub(super) fn bank(&self, node: usize, side: Side) -> Option<usize> {
        let (above, below) = (self.above[node] as usize, self.receiver[node] as usize);
        let came = if self.above[node] == NO_NODE { node } else { above };
        let along = self.way(came, below);
        let mut best = (SQUAREST_BELOW, None);
        for link in self.domain.neighbours(node) {
            if link.to == below || link.to == above {
                continue;
            }
            let left = sine(along, self.way(node, link.to));
            let square = if side == Side::Left { left } else { -left };
            if square > best.0 {
                best = (square, Some(link.to));
            }
        }
        best.1
    }

    /// From one node to another, m. Around periodic sides it leads the wrong way: a river there has
    /// no bank.
    fn way(&self, from: usize, to: usize) -> [f64; 2] {
        let (a, b) = (self.terrain.position(from), self.terrain.position(to));
        [b[0] - a[0], b[1] - a[1]]
    }
}

/// Sine of the angle from one direction to another, above 0 to the left; 0 where either is none.
fn sine(a: [f64; 2], b: [f64; 2]) -> f64 {
    let product = ((a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1])).sqrt();
    if product > 0.0 { (a[0] * b[1] - a[1] * b[0]) / product } else { 0.0 }
}
