//! Vectors in space.

use landform_core::feature::adjacency;
pub(super) use landform_core::math::distance;

/// A place or a direction.
pub(super) type Vector = [f64; 3];

pub(super) fn plus(a: Vector, b: Vector, times: f64) -> Vector {
    [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]]
}

pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    plus(a, b, -1.0)
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The direction of a vector; the vector itself where it has none.
pub(super) fn unit(a: Vector) -> Vector {
    let l = length(a);
    if l > 0.0 { a.map(|v| v / l) } else { a }
}

/// A place between two others.
pub(super) fn between(a: Vector, b: Vector, t: f64) -> Vector {
    plus(a, minus(b, a), t)
}

/// Places and the edges between them, as it grows.
#[derive(Clone, Debug, Default)]
pub(super) struct Skeleton {
    pub(super) nodes: Vec<Vector>,
    pub(super) edges: Vec<[u32; 2]>,
}

impl Skeleton {
    pub(super) fn node(&mut self, at: Vector) -> u32 {
        self.nodes.push(at);
        (self.nodes.len() - 1) as u32
    }

    /// A new node beyond another.
    pub(super) fn grow(&mut self, from: u32, at: Vector) -> u32 {
        let node = self.node(at);
        self.edges.push([from, node]);
        node
    }

    /// A straight passage between two nodes, in steps of about `step` m.
    pub(super) fn join(&mut self, from: u32, to: u32, step: f64) {
        let (a, b) = (self.nodes[from as usize], self.nodes[to as usize]);
        let pieces = (distance(a, b) / step).round().max(1.0) as usize;
        let mut last = from;
        for k in 1..pieces {
            last = self.grow(last, between(a, b, k as f64 / pieces as f64));
        }
        self.edges.push([last, to]);
    }

    pub(super) fn joined(&self) -> Vec<Vec<u32>> {
        adjacency(self.nodes.len(), &self.edges)
    }
}
