//! The graph in which each branch is an edge.

use std::collections::BTreeMap;

use super::paths;
use crate::feature::adjacency;

/// Vertices, and the edges between them.
pub(super) struct Reduced {
    edges: Vec<[u32; 2]>,
    vertices: usize,
}

/// Numbers of the reduced graph.
pub(super) struct Numbers {
    pub(super) vertices: usize,
    pub(super) edges: usize,
    pub(super) parts: usize,
    pub(super) cycles: usize,
    pub(super) alpha: f64,
    pub(super) beta: f64,
    pub(super) gamma: f64,
    pub(super) degrees: Vec<f64>,
    pub(super) degree_correlation: f64,
    pub(super) mean_shortest_path: f64,
    pub(super) central_point_dominance: f64,
}

impl Reduced {
    /// The reduced graph of chains between vertices.
    pub(super) fn of(chains: &[&[u32]]) -> Self {
        let ends = |c: &[u32]| {
            let [a, b] = [c[0], c[c.len() - 1]];
            [a.min(b), a.max(b)]
        };
        let mut doubles: BTreeMap<[u32; 2], usize> = BTreeMap::new();
        chains.iter().for_each(|c| *doubles.entry(ends(c)).or_default() += 1);
        let mut pieces: Vec<[u32; 2]> = Vec::new();
        for chain in chains {
            let last = chain.len() - 1;
            let [a, b] = ends(chain);
            let cuts: &[usize] = match (a == b, doubles[&[a, b]]) {
                (true, _) => &[0, last / 3, 2 * last / 3, last],
                (false, 1) => &[0, last],
                (false, _) if last > 1 => &[0, last / 2, last],
                (false, _) => &[0, last],
            };
            pieces.extend(cuts.windows(2).map(|w| [chain[w[0]], chain[w[1]]]));
        }
        let mut number: BTreeMap<u32, u32> = BTreeMap::new();
        let mut numbered = |n: u32| {
            let next = number.len() as u32;
            *number.entry(n).or_insert(next)
        };
        let edges = pieces.into_iter().map(|e| e.map(&mut numbered)).collect();
        Self { edges, vertices: number.len() }
    }

    pub(super) fn numbers(&self) -> Numbers {
        let joined = adjacency(self.vertices, &self.edges);
        let paths = paths::of(&joined);
        let (n, s) = (self.vertices, self.edges.len());
        let cycles = s + paths.parts - n;
        let degrees: Vec<f64> = joined.iter().map(|j| j.len() as f64).collect();
        let over = |part: usize, whole: f64| if whole > 0.0 { part as f64 / whole } else { 0.0 };
        Numbers {
            vertices: n,
            edges: s,
            parts: paths.parts,
            cycles,
            alpha: over(cycles, 2.0 * n as f64 - 5.0),
            beta: over(s, n as f64),
            gamma: over(s, 3.0 * (n as f64 - 2.0)),
            degree_correlation: self.correlation(&degrees),
            degrees,
            mean_shortest_path: paths.mean,
            central_point_dominance: paths.dominance,
        }
    }

    /// Pearson's correlation of the degrees at both ends of edges; 1 where all are equal.
    fn correlation(&self, degrees: &[f64]) -> f64 {
        let ends = || self.edges.iter().map(|e| e.map(|n| degrees[n as usize]));
        let count = 2.0 * self.edges.len() as f64;
        let mean = ends().map(|[a, b]| a + b).sum::<f64>() / count;
        let spread: f64 = ends().map(|[a, b]| (a - mean) * (a - mean) + (b - mean) * (b - mean)).sum();
        let shared: f64 = ends().map(|[a, b]| 2.0 * (a - mean) * (b - mean)).sum();
        if spread > 0.0 { shared / spread } else { 1.0 }
    }
}
