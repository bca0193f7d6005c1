//! Passages under the ground: lines in space with the size of the passage, and the graph that they
//! form.
//!
//! Two conduits meet where they have a place in common, to the last bit.

use std::collections::BTreeMap;

use super::{Feature, FeatureKind, Features, Geometry, Property};
use crate::math::distance;

/// Distances from a place of a conduit's line to the walls of the passage, m, as cavers measure
/// them: left and right looking along the line, up and down.
///
/// ```
/// use landform_core::feature::Passage;
///
/// let tube = Passage::round(2.0);
/// assert_eq!((tube.width(), tube.height()), (4.0, 4.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passage {
    /// To the left wall, m.
    pub left: f64,
    /// To the right wall, m.
    pub right: f64,
    /// To the roof, m.
    pub up: f64,
    /// To the floor, m.
    pub down: f64,
}

impl Passage {
    /// A round passage of a radius (m).
    ///
    /// ```
    /// assert_eq!(landform_core::feature::Passage::round(1.5).left, 1.5);
    /// ```
    pub const fn round(radius: f64) -> Self {
        Self { left: radius, right: radius, up: radius, down: radius }
    }

    /// From wall to wall, m.
    ///
    /// ```
    /// use landform_core::feature::Passage;
    ///
    /// assert_eq!(Passage { left: 1.0, right: 3.0, ..Passage::default() }.width(), 4.0);
    /// ```
    pub fn width(self) -> f64 {
        self.left + self.right
    }

    /// From floor to roof, m.
    ///
    /// ```
    /// use landform_core::feature::Passage;
    ///
    /// assert_eq!(Passage { up: 1.0, down: 2.0, ..Passage::default() }.height(), 3.0);
    /// ```
    pub fn height(self) -> f64 {
        self.up + self.down
    }

    fn get(self, name: &str) -> f64 {
        match name {
            "left_m" => self.left,
            "right_m" => self.right,
            "up_m" => self.up,
            _ => self.down,
        }
    }
}

/// Properties of a conduit, a number for each of its places.
const WALLS: [&str; 4] = ["left_m", "right_m", "up_m", "down_m"];

/// A passage between two junctions or ends.
///
/// ```
/// use landform_core::feature::{Conduit, Passage};
///
/// let conduit = Conduit { nodes: vec![3, 4], passages: vec![Passage::round(1.0); 2] };
/// assert_eq!(conduit.nodes.len(), conduit.passages.len());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conduit {
    /// Nodes along it, two at least. Of a ring the first is the last.
    pub nodes: Vec<u32>,
    /// The passage at each of these nodes.
    pub passages: Vec<Passage>,
}

/// The graph of passages.
///
/// ```
/// use landform_core::feature::{ConduitNetwork, Features, Passage};
///
/// // A way down that forks.
/// let nodes = vec![[0.0, 0.0, 90.0], [10.0, 0.0, 80.0], [20.0, 9.0, 75.0], [20.0, -9.0, 76.0]];
/// let network = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
/// assert_eq!(network.conduits.len(), 3);
/// let features: Features = network.features().into_iter().collect();
/// assert_eq!(ConduitNetwork::of(&features), network);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ConduitNetwork {
    /// Places, m.
    pub nodes: Vec<[f64; 3]>,
    /// Passages between junctions and ends.
    pub conduits: Vec<Conduit>,
}

impl ConduitNetwork {
    /// The network that the conduits of a landscape form. Conduits that do not say how far the
    /// walls are have passages without width.
    ///
    /// **Cost** O(places · log places).
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let fork = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
    /// let features = fork.features().into_iter().collect();
    /// assert_eq!(ConduitNetwork::of(&features).length(), 25.0);
    /// ```
    pub fn of(features: &Features) -> Self {
        let mut network = Self::default();
        let mut known: BTreeMap<[u64; 3], u32> = BTreeMap::new();
        for feature in features.of(FeatureKind::Conduit) {
            let Geometry::Line(line) = &feature.geometry else { continue };
            let mut node = |place: &[f64; 3]| {
                // Zero has two signs.
                let key = place.map(|v| (v + 0.0).to_bits());
                *known.entry(key).or_insert_with(|| {
                    network.nodes.push(*place);
                    (network.nodes.len() - 1) as u32
                })
            };
            let nodes: Vec<u32> = line.iter().map(&mut node).collect();
            let walls = WALLS.map(|name| feature.numbers(name));
            let at = |wall: usize, k: usize| walls[wall].and_then(|w| w.get(k)).copied().unwrap_or_default();
            let passage = |k: usize| Passage { left: at(0, k), right: at(1, k), up: at(2, k), down: at(3, k) };
            let passages = (0..nodes.len()).map(passage).collect();
            network.conduits.push(Conduit { nodes, passages });
        }
        network
    }

    /// A network of places and the edges between them; `passage` is that at a node. Edges that
    /// follow each other without a junction become one conduit, in the order of edges; a conduit
    /// runs from the end of the lower index to the other.
    ///
    /// **Cost** O(nodes + edges).
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let fork = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
    /// assert_eq!((fork.nodes.len(), fork.conduits.len()), (4, 3));
    /// ```
    pub fn from_edges(nodes: Vec<[f64; 3]>, edges: &[[u32; 2]], passage: impl Fn(u32) -> Passage) -> Self {
        Self::from_edges_with_ends(nodes, edges, &[], passage)
    }

    /// As [`ConduitNetwork::from_edges`], and conduits end at the nodes `ends` too, such as springs
    /// along a passage.
    ///
    /// **Cost** O(nodes + edges).
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0]];
    /// let cut = ConduitNetwork::from_edges_with_ends(nodes, &[[0, 1], [1, 2]], &[1], |_| Passage::round(1.0));
    /// assert_eq!(cut.conduits.len(), 2);
    /// ```
    pub fn from_edges_with_ends(
        nodes: Vec<[f64; 3]>,
        edges: &[[u32; 2]],
        ends: &[u32],
        passage: impl Fn(u32) -> Passage,
    ) -> Self {
        let mut at: Vec<Vec<u32>> = vec![Vec::new(); nodes.len()];
        for (k, edge) in edges.iter().enumerate() {
            edge.iter().for_each(|&n| at[n as usize].push(k as u32));
        }
        let mut is_end = vec![false; nodes.len()];
        ends.iter().for_each(|&n| is_end[n as usize] = true);
        let mut used = vec![false; edges.len()];
        let mut conduits = Vec::new();
        let through = |n: u32| at[n as usize].len() == 2 && !is_end[n as usize];
        // Chains between junctions and ends first; what is left are rings.
        let starts = (0..nodes.len() as u32).filter(|&n| !through(n));
        for first in starts.chain((0..nodes.len() as u32).filter(|&n| through(n))) {
            for &edge in &at[first as usize] {
                if std::mem::replace(&mut used[edge as usize], true) {
                    continue;
                }
                let other = |edge: u32, n: u32| edges[edge as usize].iter().sum::<u32>() - n;
                let mut chain = vec![first, other(edge, first)];
                let mut node = chain[1];
                while through(node) && node != first {
                    let Some(&next) = at[node as usize].iter().find(|e| !used[**e as usize]) else { break };
                    used[next as usize] = true;
                    node = other(next, node);
                    chain.push(node);
                }
                let passages = chain.iter().map(|&n| passage(n)).collect();
                conduits.push(Conduit { nodes: chain, passages });
            }
        }
        Self { nodes, conduits }
    }

    /// The conduits as features, numbered from 1, with their length and the distances to the walls
    /// at each place.
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let fork = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
    /// assert_eq!(fork.features().len(), 3);
    /// ```
    pub fn features(&self) -> Vec<Feature> {
        let feature = |(k, conduit): (usize, &Conduit)| {
            let line: Vec<[f64; 3]> = conduit.nodes.iter().map(|&n| self.nodes[n as usize]).collect();
            let walls = WALLS.map(|name| {
                let values = conduit.passages.iter().map(|p| p.get(name)).collect();
                (name.to_string(), Property::Numbers(values))
            });
            let length = ("length_m".to_string(), Property::Number((self.length_of(conduit) * 100.0).round() / 100.0));
            let properties = std::iter::once(length).chain(walls).collect();
            Feature { id: (k + 1).to_string(), kind: FeatureKind::Conduit, geometry: Geometry::Line(line), properties }
        };
        self.conduits.iter().enumerate().map(feature).collect()
    }

    /// The two ends of every straight piece, conduit by conduit.
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let fork = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
    /// assert_eq!(fork.edges().len(), 3);
    /// ```
    pub fn edges(&self) -> Vec<[u32; 2]> {
        self.conduits.iter().flat_map(|c| c.nodes.windows(2).map(|w| [w[0], w[1]])).collect()
    }

    /// Nodes joined to each node.
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let fork = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
    /// assert_eq!(fork.neighbours()[1].len(), 3);
    /// ```
    pub fn neighbours(&self) -> Vec<Vec<u32>> {
        adjacency(self.nodes.len(), &self.edges())
    }

    /// For each node the node of lowest index in the part of the network that hangs together with
    /// it. **Cost** O(nodes + edges).
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let fork = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
    /// assert_eq!(fork.parts(), [0; 4]);
    /// ```
    pub fn parts(&self) -> Vec<u32> {
        let joined = self.neighbours();
        let mut part = vec![u32::MAX; self.nodes.len()];
        for first in 0..self.nodes.len() as u32 {
            let mut stack = vec![first];
            while let Some(node) = stack.pop() {
                if part[node as usize] == u32::MAX {
                    part[node as usize] = first;
                    stack.extend(joined[node as usize].iter().filter(|n| part[**n as usize] == u32::MAX));
                }
            }
        }
        part
    }

    /// Length of all conduits, m.
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [20.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let fork = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2], [1, 3]], |_| Passage::round(1.0));
    /// assert_eq!(fork.length(), 25.0);
    /// ```
    pub fn length(&self) -> f64 {
        let piece = |[a, b]: [u32; 2]| distance(self.nodes[a as usize], self.nodes[b as usize]);
        self.edges().into_iter().map(piece).sum()
    }

    /// The length of one of its conduits, m.
    ///
    /// ```
    /// use landform_core::feature::{ConduitNetwork, Passage};
    ///
    /// let nodes = vec![[0.0, 0.0, 9.0], [10.0, 0.0, 9.0], [10.0, 5.0, 9.0]];
    /// let bend = ConduitNetwork::from_edges(nodes, &[[0, 1], [1, 2]], |_| Passage::round(1.0));
    /// assert_eq!(bend.length_of(&bend.conduits[0]), 15.0);
    /// ```
    pub fn length_of(&self, conduit: &Conduit) -> f64 {
        conduit.nodes.windows(2).map(|w| distance(self.nodes[w[0] as usize], self.nodes[w[1] as usize])).sum()
    }
}

/// The nodes joined to each of so many nodes, in the order of the edges.
///
/// ```
/// use landform_core::feature::adjacency;
///
/// assert_eq!(adjacency(3, &[[0, 1], [2, 1]]), [vec![1], vec![0, 2], vec![1]]);
/// ```
pub fn adjacency(nodes: usize, edges: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let mut joined = vec![Vec::new(); nodes];
    for &[a, b] in edges {
        joined[a as usize].push(b);
        joined[b as usize].push(a);
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_a_fork_and_a_lone_ring_are_chains() {
        // 0-1-2 with a ring 2-3-4-2, and a ring 5-6-7 apart.
        let place = |k: u32| [f64::from(k), f64::from(k * k % 7), 10.0 - f64::from(k)];
        let edges = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 2], [5, 6], [6, 7], [7, 5]];
        let network = ConduitNetwork::from_edges((0..8).map(place).collect(), &edges, |n| Passage {
            left: f64::from(n),
            ..Passage::round(1.0)
        });
        let chains: Vec<&[u32]> = network.conduits.iter().map(|c| c.nodes.as_slice()).collect();
        assert_eq!(chains, [&[0, 1, 2][..], &[2, 3, 4, 2], &[5, 6, 7, 5]]);
        assert_eq!(network.edges().len(), edges.len());
        assert_eq!(network.parts(), [0, 0, 0, 0, 0, 5, 5, 5]);
        let features: Features = network.features().into_iter().collect();
        assert_eq!(ConduitNetwork::of(&features), network);
        let direct: f64 = edges.iter().map(|[a, b]| distance(place(*a), place(*b))).sum();
        assert!((network.length() - direct).abs() < 1e-9);
    }

    #[test]
    fn conduits_end_where_they_must() {
        // A ring 0-1-2-3 and a way 3-4-5; 1 and 4 lie along them.
        let nodes: Vec<[f64; 3]> = (0..6).map(|k| [f64::from(k), f64::from(k * k % 5), 0.0]).collect();
        let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [3, 4], [4, 5]];
        let cut = ConduitNetwork::from_edges_with_ends(nodes, &edges, &[1, 4, 4], |_| Passage::default());
        let mut ends: Vec<[u32; 2]> = cut.conduits.iter().map(|c| [c.nodes[0], c.nodes[c.nodes.len() - 1]]).collect();
        ends.sort_unstable();
        assert_eq!(ends, [[1, 3], [1, 3], [3, 4], [4, 5]]);
        assert_eq!(cut.edges().len(), edges.len());
    }

    #[test]
    fn nothing_makes_nothing() {
        assert_eq!(ConduitNetwork::of(&Features::default()), ConduitNetwork::default());
        assert!(ConduitNetwork::from_edges(vec![[0.0; 3]], &[], |_| Passage::default()).conduits.is_empty());
    }
}
