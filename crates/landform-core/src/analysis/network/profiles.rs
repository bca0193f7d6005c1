//! Rivers from their mouths to their heads: distance, χ, steepness at every node.
//!
//! # Method
//! χ is the integral of (A0 / A)^θ upstream from where the flow ends, by the trapezoid rule; k_sn at
//! a node is the slope of elevation on χ, by least squares over the nodes of the same river within
//! half a window up and down, times A0^θ. A river goes up the larger branch at each confluence; its
//! first node is the confluence with the river that it joins.
//!
//! # Sources
//! Perron & Royden (2013); Wobus et al. (2006) for k_sn over a window.
//!
//! # Checked by
//! `tests`: a profile of known θ and k_sn, at every node.

use crate::algo::network::reaches;
use crate::analysis::Drainage;
use crate::grid::Domain;
use crate::math;

/// How profiles are measured.
///
/// ```
/// use landform_core::analysis::ProfileSearch;
///
/// assert_eq!(ProfileSearch::default().reference_area, 1e6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileSearch {
    /// Least drainage area of a channel, m².
    pub least_area: f64,
    /// θ, a ratio.
    pub concavity: f64,
    /// A0, m².
    pub reference_area: f64,
    /// Length of river over which steepness is measured, m.
    pub window: f64,
}

impl Default for ProfileSearch {
    fn default() -> Self {
        Self { least_area: 1e6, concavity: 0.45, reference_area: 1e6, window: 500.0 }
    }
}

/// A river from its mouth up.
#[derive(Clone, Debug, PartialEq)]
pub struct RiverProfile {
    /// Number, from 1, the greatest first.
    pub river: u32,
    /// The river that it joins.
    pub into: Option<u32>,
    /// Its nodes.
    pub nodes: Vec<ProfileNode>,
}

/// A node of a river.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileNode {
    /// The node.
    pub node: u32,
    /// Strahler's order of the reach above it.
    pub order: u32,
    /// Distance along the flow to where it ends, m.
    pub distance: f64,
    /// χ, m.
    pub chi: f64,
    /// k_sn, m^(2θ); NaN where the window holds fewer than three nodes.
    pub steepness: f64,
}

/// All rivers of a routed terrain with elevations (m) that do not rise downstream
/// ([`carved`](super::carved)). **Cost** O(n).
pub fn river_profiles<D: Domain>(drainage: &Drainage<D>, carved: &[f64], search: &ProfileSearch) -> Vec<RiverProfile> {
    let (distance, chi) = integrals(drainage, search);
    let list = reaches(&drainage.flow, &drainage.area, search.least_area);
    let mut rivers: Vec<RiverProfile> = Vec::new();
    for reach in &list {
        let upward = reach.nodes.iter().rev().copied();
        let of = |node: u32| ProfileNode {
            node,
            order: reach.order,
            distance: distance[node as usize],
            chi: chi[node as usize],
            steepness: f64::NAN,
        };
        if reach.number == 1 {
            let into = reach.to.map(|to| list[to].river);
            rivers.push(RiverProfile { river: reach.river, into, nodes: upward.map(of).collect() });
        } else if let Some(river) = rivers.last_mut() {
            // The confluence is there already.
            river.nodes.extend(upward.skip(1).map(of));
        }
    }
    let scale = math::pow(search.reference_area, search.concavity);
    for river in &mut rivers {
        steepen(&mut river.nodes, carved, search.window, scale);
    }
    rivers
}

/// Distance along the flow to its end, and χ, of every node.
fn integrals<D: Domain>(drainage: &Drainage<D>, search: &ProfileSearch) -> (Vec<f64>, Vec<f64>) {
    let (area, receivers) = (&drainage.area, drainage.flow.receivers());
    let weight = |i: usize| math::pow(search.reference_area / area[i], search.concavity);
    let (mut distance, mut chi) = (vec![0.0; area.len()], vec![0.0; area.len()]);
    for &i in drainage.flow.order().iter().rev() {
        let (i, r) = (i as usize, receivers[i as usize] as usize);
        if r != i {
            let step = drainage.domain.distance(i, drainage.flow.slots()[i]);
            distance[i] = distance[r] + step;
            chi[i] = chi[r] + 0.5 * (weight(i) + weight(r)) * step;
        }
    }
    (distance, chi)
}

/// Finds the steepness of every node of a river.
fn steepen(nodes: &mut [ProfileNode], carved: &[f64], window: f64, scale: f64) {
    let Some(&first) = nodes.first() else { return };
    let base = carved[first.node as usize];
    // Sums of 1, χ, z, χ², χ z over the nodes before each.
    let mut sums = vec![[0.0; 5]];
    for node in nodes.iter() {
        let (x, z) = (node.chi - first.chi, carved[node.node as usize] - base);
        let last = sums[sums.len() - 1];
        let add = [1.0, x, z, x * x, x * z];
        sums.push([0, 1, 2, 3, 4].map(|k| last[k] + add[k]));
    }
    let (mut low, mut high) = (0, 0);
    for k in 0..nodes.len() {
        let at = nodes[k].distance;
        while at - nodes[low].distance > 0.5 * window {
            low += 1;
        }
        while high < nodes.len() && nodes[high].distance - at <= 0.5 * window {
            high += 1;
        }
        let [n, x, z, xx, xz] = [0, 1, 2, 3, 4].map(|k| sums[high][k] - sums[low][k]);
        let spread = xx - x * x / n;
        if n >= 3.0 && spread > 0.0 {
            nodes[k].steepness = (xz - x * z / n) / spread * scale;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::carved;
    use crate::grid::{Edge, Edges, Grid, Shape};
    use crate::terrain::HeightField;

    #[test]
    fn a_channel_of_known_steepness_has_it_at_every_node() {
        // One column of cells that drains south: areas are known, heights follow from χ.
        let (rows, cell, theta, steepness) = (200, 100.0, 0.4, 50.0);
        let mut grid = Grid::new(Shape::new(rows, 1), [cell, cell]).unwrap();
        grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
        let search =
            ProfileSearch { least_area: 10.0 * cell * cell, concavity: theta, reference_area: 1e5, window: 900.0 };
        let area = |row: usize| (row + 1) as f64 * cell * cell;
        let weight = |row: usize| math::pow(1e5 / area(row), theta);
        let mut chi = vec![0.0; rows];
        for row in (0..rows - 1).rev() {
            chi[row] = chi[row + 1] + 0.5 * (weight(row) + weight(row + 1)) * cell;
        }
        let slope = steepness / math::pow(1e5, theta);
        let z: Vec<f64> = chi.iter().map(|x| 7.0 + slope * x).collect();
        let field = HeightField::new(grid, z.clone()).unwrap();
        let drainage = Drainage::with_open_holes(&field);
        let rivers = river_profiles(&drainage, &carved(&drainage, &z), &search);
        assert_eq!((rivers.len(), rivers[0].river, rivers[0].into), (1, 1, None));
        assert_eq!(rivers[0].nodes.len(), rows - 9);
        for node in &rivers[0].nodes {
            let row = node.node as usize;
            assert!((node.chi - chi[row]).abs() < 1e-9 * chi[0]);
            assert!((node.distance - (rows - 1 - row) as f64 * cell).abs() < 1e-9);
            assert!((node.steepness / steepness - 1.0).abs() < 1e-6, "{row}: {}", node.steepness);
        }
        // A window that holds fewer than three nodes has no slope.
        let narrow = river_profiles(&drainage, &z, &ProfileSearch { window: 150.0, ..search });
        assert!(narrow[0].nodes.iter().all(|n| n.steepness.is_nan()));
    }

    #[test]
    fn rivers_join_where_they_say() {
        let grid = Grid::new(Shape::new(60, 80), [10.0, 10.0]).unwrap();
        let z: Vec<f64> = (0..4800).map(|i| 50.0 * crate::random::Seed(3).uniform(i)).collect();
        let field = HeightField::new(grid, z.clone()).unwrap();
        let drainage = Drainage::with_open_holes(&field);
        let search = ProfileSearch { least_area: 5e3, window: 60.0, ..ProfileSearch::default() };
        let rivers = river_profiles(&drainage, &carved(&drainage, &z), &search);
        assert!(rivers.len() > 5);
        for (k, river) in rivers.iter().enumerate() {
            assert_eq!(river.river as usize, k + 1);
            assert!(river.nodes.windows(2).all(|w| w[1].distance > w[0].distance && w[1].chi > w[0].chi));
            if let Some(into) = river.into {
                let trunk = &rivers[into as usize - 1];
                assert!(trunk.nodes.iter().any(|n| n.node == river.nodes[0].node));
            }
        }
    }
}
