//! Statistics of a network of passages: geometry and topology, beside those of natural karst.
//!
//! # Method
//! Collon et al. (2017) as corrected in 2021. A branch is a chain of legs between places that do
//! not join exactly two. Lengths, tortuosity and orientation are of branches and legs; the rest is
//! of the reduced graph, in which each branch is an edge. It stays simple: a branch that returns to
//! its start is cut in three, each of several branches between the same two places in two.
//!
//! # Checked by
//! `tests`: two surveyed caves against karstnet 1.2.5; a star, a ring and a square by hand.

mod gates;
mod paths;
mod reduced;

use serde::Serialize;

pub use gates::{NaturalRange, Pattern};
use reduced::Reduced;

use crate::feature::{ConduitNetwork, Passage};
use crate::math::{self, distance};

/// Statistics of a network of passages. Ratios have no unit.
///
/// ```
/// use landform_core::analysis::network_statistics;
///
/// let ends = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [-8.0, -6.0, 0.0]];
/// let star = network_statistics(&ends, &[[0, 1], [0, 2], [0, 3]]);
/// assert_eq!((star.length, star.vertical_range, star.parts), (30.0, 0.0, 1));
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct NetworkStatistics {
    /// Places.
    pub nodes: usize,
    /// Straight legs between places.
    pub legs: usize,
    /// Length of all legs, m.
    pub length: f64,
    /// From the lowest place to the highest, m.
    pub vertical_range: f64,
    /// Parts that do not hang together.
    pub parts: usize,
    /// Places that join other than two legs, and those at which branches are cut.
    pub vertices: usize,
    /// Edges between vertices.
    pub edges: usize,
    /// Independent cycles.
    pub cycles: usize,
    /// Chains of legs between vertices, before any is cut.
    pub branches: usize,
    /// Branches that return to their start.
    pub looping_branches: usize,
    /// Mean length of a branch, m.
    pub mean_branch_length: f64,
    /// Ratio of the standard deviation of the lengths of branches to their mean.
    pub length_variation: f64,
    /// Entropy of the lengths of branches, a number from 0 to 1.
    pub length_entropy: f64,
    /// Mean ratio of the length of a branch to the distance of its ends.
    pub tortuosity: f64,
    /// Entropy of the azimuths of legs, weighted by length in plan: a number from 0 to 1.
    pub orientation_entropy: f64,
    /// Number of cycles over the most that a planar graph can have.
    pub alpha: f64,
    /// Number of edges a vertex.
    pub beta: f64,
    /// Number of edges over the most that a planar graph can have.
    pub gamma: f64,
    /// A number from alpha, beta and gamma: near 0 for a large tree, 1 for a net.
    pub complexity: f64,
    /// Mean number of edges at a vertex.
    pub mean_degree: f64,
    /// Standard deviation of that number over its mean.
    pub degree_variation: f64,
    /// Correlation of that number at the ends of edges.
    pub degree_correlation: f64,
    /// Mean number of edges on the shortest way between two vertices.
    pub mean_shortest_path: f64,
    /// Central point dominance, a number: 0 where all vertices are equal, 1 for a star.
    pub central_point_dominance: f64,
    /// Measures beside their range on natural networks.
    pub natural_ranges: Vec<NaturalRange>,
    /// How many of these are in their range.
    pub in_range: usize,
    /// Pattern that the complexity speaks for.
    pub pattern: Pattern,
    /// In words: whether the network is as natural ones are.
    pub verdict: String,
}

/// The statistics of a network of places (m) and the legs between them.
///
/// **Cost** O(vertices · edges) of the reduced graph, and O(legs).
///
/// ```
/// use landform_core::analysis::network_statistics;
///
/// let places = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [-8.0, -6.0, 0.0]];
/// let star = network_statistics(&places, &[[0, 1], [0, 2], [0, 3]]);
/// assert_eq!((star.vertices, star.edges, star.cycles), (4, 3, 0));
/// assert_eq!((star.mean_branch_length, star.central_point_dominance), (10.0, 1.0));
/// ```
pub fn network_statistics(places: &[[f64; 3]], legs: &[[u32; 2]]) -> NetworkStatistics {
    let mut legs: Vec<[u32; 2]> = legs.iter().map(|&[a, b]| [a.min(b), a.max(b)]).filter(|l| l[0] != l[1]).collect();
    legs.sort_unstable();
    legs.dedup();
    let network = ConduitNetwork::from_edges(places.to_vec(), &legs, |_| Passage::default());
    let chains: Vec<&[u32]> = network.conduits.iter().map(|c| c.nodes.as_slice()).collect();
    let reduced = Reduced::of(&chains);
    let graph = reduced.numbers();
    let branches = Branches::of(places, &chains);
    let used = {
        let mut used = vec![false; places.len()];
        legs.iter().flatten().for_each(|&n| used[n as usize] = true);
        used
    };
    let heights = places.iter().zip(&used).filter(|p| *p.1).map(|p| p.0[2]);
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
    let mut found = NetworkStatistics {
        nodes: used.iter().filter(|u| **u).count(),
        legs: legs.len(),
        length: branches.lengths.iter().sum(),
        vertical_range: if low <= high { high - low } else { 0.0 },
        parts: graph.parts,
        vertices: graph.vertices,
        edges: graph.edges,
        cycles: graph.cycles,
        branches: chains.len(),
        looping_branches: chains.iter().filter(|c| c.first() == c.last()).count(),
        mean_branch_length: mean(&branches.lengths),
        length_variation: variation(&branches.lengths),
        length_entropy: length_entropy(&branches.lengths),
        tortuosity: mean(&branches.tortuosities),
        orientation_entropy: orientation_entropy(places, &legs),
        alpha: graph.alpha,
        beta: graph.beta,
        gamma: graph.gamma,
        complexity: (graph.alpha / 0.25 + (graph.beta - 1.0) / 0.5 + (graph.gamma - 0.33) / 0.17) / 3.0,
        mean_degree: mean(&graph.degrees),
        degree_variation: variation(&graph.degrees),
        degree_correlation: graph.degree_correlation,
        mean_shortest_path: graph.mean_shortest_path,
        central_point_dominance: graph.central_point_dominance,
        natural_ranges: Vec::new(),
        in_range: 0,
        pattern: Pattern::Branchwork,
        verdict: String::new(),
    };
    gates::judge(&mut found);
    found
}

/// Lengths of all branches (m) and tortuosities of those that do not return to their start.
struct Branches {
    lengths: Vec<f64>,
    tortuosities: Vec<f64>,
}

impl Branches {
    fn of(places: &[[f64; 3]], chains: &[&[u32]]) -> Self {
        let at = |n: u32| places[n as usize];
        let length = |c: &&[u32]| c.windows(2).map(|w| distance(at(w[0]), at(w[1]))).sum::<f64>();
        let lengths: Vec<f64> = chains.iter().map(length).collect();
        let chord = |c: &&[u32]| distance(at(c[0]), at(c[c.len() - 1]));
        let pairs = chains.iter().map(chord).zip(&lengths);
        let tortuosities = pairs.filter(|p| p.0 > 0.0).map(|(chord, length)| length / chord).collect();
        Self { lengths, tortuosities }
    }
}

fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
}

/// Standard deviation of a sample over its mean; 0 for fewer than two values.
fn variation(values: &[f64]) -> f64 {
    let middle = mean(values);
    if values.len() < 2 || middle == 0.0 {
        return 0.0;
    }
    let squares: f64 = values.iter().map(|v| (v - middle) * (v - middle)).sum();
    (squares / (values.len() - 1) as f64).sqrt() / middle
}

/// Entropy of weights in bins, to the base of the number of bins.
fn entropy(bins: &[f64]) -> f64 {
    let total: f64 = bins.iter().sum();
    if !(total > 0.0) {
        return 0.0;
    }
    let part = |w: &f64| if *w > 0.0 { -w / total * math::log(w / total) } else { 0.0 };
    bins.iter().map(part).sum::<f64>() / math::log(bins.len() as f64)
}

/// Lengths over the greatest one, in ten bins.
fn length_entropy(lengths: &[f64]) -> f64 {
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    let mut bins = [0.0; 10];
    for length in lengths.iter().filter(|l| **l > 0.0) {
        bins[((length / longest * 10.0) as usize).min(9)] += 1.0;
    }
    entropy(&bins)
}

/// Azimuths from north, without sense, in bins of ten degrees.
fn orientation_entropy(places: &[[f64; 3]], legs: &[[u32; 2]]) -> f64 {
    let mut bins = [0.0; 18];
    for [a, b] in legs.iter().map(|l| l.map(|n| places[n as usize])) {
        let (east, north) = (b[0] - a[0], b[1] - a[1]);
        let in_plan = (east * east + north * north).sqrt();
        if in_plan > 0.0 {
            let azimuth = math::atan2(east, north).to_degrees();
            let azimuth = if azimuth < 0.0 { azimuth + 180.0 } else { azimuth };
            bins[(azimuth / 10.0) as usize % 18] += in_plan;
        }
    }
    entropy(&bins)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cave(nodes: &str, links: &str) -> NetworkStatistics {
        let numbers = |line: &str| line.split_whitespace().map(|v| v.parse::<f64>().unwrap()).collect::<Vec<_>>();
        let place = |line: &str| <[f64; 3]>::try_from(numbers(line)).unwrap();
        let leg = |line: &str| <[f64; 2]>::try_from(numbers(line)).unwrap().map(|v| v as u32 - 1);
        let places: Vec<_> = nodes.lines().filter(|l| !l.trim().is_empty()).map(place).collect();
        let legs: Vec<_> = links.lines().filter(|l| !l.trim().is_empty()).map(leg).collect();
        network_statistics(&places, &legs)
    }

    fn sakany() -> NetworkStatistics {
        cave(
            include_str!("../../../tests/data/caves/sakany_nodes.txt"),
            include_str!("../../../tests/data/caves/sakany_links.txt"),
        )
    }

    #[track_caller]
    fn near(found: f64, expected: f64) {
        assert!((found - expected).abs() <= 6e-5, "{found} {expected}");
    }

    #[test]
    fn sakany_has_its_published_statistics() {
        let s = sakany();
        assert_eq!((s.nodes, s.legs, s.vertices, s.edges, s.branches, s.parts), (1716, 1784, 344, 412, 361, 1));
        near(s.mean_branch_length, 20.7059);
        near(s.length_variation, 0.9149);
        near(s.length_entropy, 0.377);
        near(s.tortuosity, 1.4009);
        near(s.orientation_entropy, 0.9924);
        near(s.mean_shortest_path, 12.6189);
        near(s.central_point_dominance, 0.2677);
        near(s.mean_degree, 2.3953);
        near(s.degree_variation, 0.4708);
        assert!((s.degree_correlation + 0.168).abs() < 5e-4, "{}", s.degree_correlation);
        assert!((s.length - 7474.8).abs() < 0.05 && s.cycles == 69);
        assert_eq!(s.in_range, 8, "{}", s.verdict);
    }

    #[test]
    fn huttes_has_its_published_statistics() {
        let s = cave(
            include_str!("../../../tests/data/caves/huttes_nodes.txt"),
            include_str!("../../../tests/data/caves/huttes_links.txt"),
        );
        assert_eq!((s.nodes, s.legs, s.vertices, s.edges), (41, 41, 12, 12));
        near(s.mean_branch_length, 15.8719);
        near(s.length_variation, 1.0438);
        near(s.length_entropy, 0.6185);
        near(s.tortuosity, 1.2066);
        near(s.orientation_entropy, 0.9259);
        near(s.mean_shortest_path, 3.0152);
        near(s.central_point_dominance, 0.4744);
        near(s.mean_degree, 2.0);
        near(s.degree_variation, 0.5222);
        near(s.degree_correlation, -1.0 / 3.0);
    }

    #[test]
    fn rings_and_doubles_stay_simple() {
        // A lone ring of five is a triangle in the reduced graph.
        let ring: Vec<[f64; 3]> = (0..5).map(|k| [f64::from(k % 3), f64::from(k), 0.0]).collect();
        let s = network_statistics(&ring, &[[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]]);
        assert_eq!((s.vertices, s.edges, s.cycles, s.looping_branches), (3, 3, 1, 1));
        // Two ways between two forks, one of them without a place between.
        let s = network_statistics(&[[0.0; 3]; 5], &[[0, 1], [1, 2], [2, 3], [1, 3], [3, 4]]);
        assert_eq!((s.branches, s.vertices, s.edges, s.cycles), (4, 5, 5, 1));
        let none = network_statistics(&[], &[]);
        assert!(none.vertices == 0 && none.length == 0.0 && none.in_range < 8);
    }
}
