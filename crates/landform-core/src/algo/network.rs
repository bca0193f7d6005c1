//! Rivers as lines: a network of reaches between heads, confluences and mouths.
//!
//! # Method
//! Nodes that drain at least a given area are channels. A reach runs down from a head or a
//! confluence to the next confluence or to the end; it holds the node at which it ends. Reaches
//! join to *rivers*: at each confluence, the branch with the greatest area goes on upstream under
//! the river's number. Rivers are numbered by drainage area at their end, the greatest first, and
//! their reaches from the mouth upwards, so that numbers follow from the land and not from the
//! order of nodes.
//!
//! # Sources
//! Strahler (1957) for orders; Hack (1957) for main streams followed up the larger branch.
//!
//! # Example
//! Five streams of first order meet in the middle and leave as one of second order:
//!
//! ```
//! use landform_core::algo::flow::{Flow, node_areas};
//! use landform_core::algo::network::reaches;
//! use landform_core::grid::{Edge, Edges, Grid, RasterDomain, Shape};
//!
//! let mut grid = Grid::new(Shape::new(3, 3), [1.0, 1.0])?;
//! grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
//! let domain = RasterDomain::new(&grid, &[]);
//! let (mut flow, mut area) = (Flow::new(), node_areas(&domain));
//! flow.route(&domain, &[2.0, 9.0, 2.0, 9.0, 1.0, 9.0, 9.0, 0.0, 9.0], &mut area);
//! let trunk = &reaches(&flow, &area, 1.0)[0];
//! assert_eq!((trunk.order, trunk.nodes.as_slice()), (2, &[4, 7][..]));
//! # Ok::<(), landform_core::Error>(())
//! ```

use super::flow::Flow;

/// A part of a river between two confluences.
#[derive(Clone, Debug, PartialEq)]
pub struct Reach {
    /// Nodes from the upper end down; the last one is the confluence or the end of the flow.
    pub nodes: Vec<u32>,
    /// Strahler's order.
    pub order: u32,
    /// Number of the river, from 1, the greatest first.
    pub river: u32,
    /// Number of the reach in its river, from 1 at the mouth.
    pub number: u32,
    /// Position in the list of the reach that it flows into.
    pub to: Option<usize>,
}

impl Reach {
    /// The lowest node of its own: the last one before the confluence (or the end).
    pub fn last_own(&self) -> usize {
        self.nodes[self.nodes.len().saturating_sub(2)] as usize
    }
}

const NONE: u32 = u32::MAX;

/// The reaches of all nodes whose `area` is at least `least`, rivers in turn, each from its mouth
/// upwards. **Cost** O(n).
pub fn reaches(flow: &Flow, area: &[f64], least: f64) -> Vec<Reach> {
    let receivers = flow.receivers();
    let is_channel = |i: usize| area[i] >= least && receivers[i] as usize != i;
    let orders = strahler(flow, is_channel);
    let mut donors = vec![0u8; area.len()];
    for i in (0..area.len()).filter(|&i| is_channel(i)) {
        donors[receivers[i] as usize] = donors[receivers[i] as usize].saturating_add(1);
    }
    // The reach that begins at a node.
    let mut begins = vec![NONE; area.len()];
    let mut list: Vec<Reach> = Vec::new();
    for &i in flow.order() {
        if !is_channel(i as usize) || donors[i as usize] == 1 {
            continue;
        }
        begins[i as usize] = list.len() as u32;
        let mut nodes = vec![i];
        let mut at = i as usize;
        loop {
            at = receivers[at] as usize;
            nodes.push(at as u32);
            if !is_channel(at) || donors[at] > 1 {
                break;
            }
        }
        list.push(Reach { order: orders[i as usize], nodes, river: 0, number: 0, to: None });
    }
    for k in 0..list.len() {
        let end = list[k].nodes[list[k].nodes.len() - 1] as usize;
        list[k].to = Some(begins[end]).filter(|&b| b != NONE).map(|b| b as usize);
    }
    number(list, area)
}

/// Strahler's order of every channel node, 0 elsewhere. **Cost** O(n).
pub fn strahler(flow: &Flow, is_channel: impl Fn(usize) -> bool) -> Vec<u32> {
    let n = flow.receivers().len();
    // Greatest order among donors, and whether two have it.
    let (mut order, mut twice) = (vec![0u32; n], vec![false; n]);
    for &i in flow.order() {
        let i = i as usize;
        if !is_channel(i) {
            continue;
        }
        order[i] = (order[i] + u32::from(twice[i])).max(1);
        let r = flow.receivers()[i] as usize;
        match order[i].cmp(&order[r]) {
            std::cmp::Ordering::Greater => (order[r], twice[r]) = (order[i], false),
            std::cmp::Ordering::Equal => twice[r] = true,
            std::cmp::Ordering::Less => {}
        }
    }
    order
}

/// Numbers rivers and reaches, and sorts them so.
fn number(mut list: Vec<Reach>, area: &[f64]) -> Vec<Reach> {
    let size = |r: &Reach| area[r.last_own()];
    let mut upstream: Vec<Vec<usize>> = vec![Vec::new(); list.len()];
    let mut mouths = Vec::new();
    for (k, reach) in list.iter().enumerate() {
        match reach.to {
            Some(to) => upstream[to].push(k),
            None => mouths.push(k),
        }
    }
    let larger_first = |list: &[Reach], ks: &mut Vec<usize>| {
        ks.sort_by(|&a, &b| {
            size(&list[b]).total_cmp(&size(&list[a])).then(list[a].last_own().cmp(&list[b].last_own()))
        });
    };
    // Each entry is a river's lowest reach; side branches are found on the way up.
    let mut stems = Vec::new();
    let mut open = mouths;
    while let Some(mouth) = open.pop() {
        let mut stem = vec![mouth];
        let mut at = mouth;
        loop {
            let mut branches = std::mem::take(&mut upstream[at]);
            larger_first(&list, &mut branches);
            let Some((&main, sides)) = branches.split_first() else { break };
            open.extend(sides);
            stem.push(main);
            at = main;
        }
        stems.push(stem);
    }
    stems.sort_by(|a, b| {
        let (a, b) = (&list[a[0]], &list[b[0]]);
        size(b).total_cmp(&size(a)).then(a.last_own().cmp(&b.last_own()))
    });
    let mut place = vec![0; list.len()];
    let mut sequence = Vec::with_capacity(list.len());
    for (river, stem) in stems.iter().enumerate() {
        for (k, &reach) in stem.iter().enumerate() {
            (list[reach].river, list[reach].number) = (river as u32 + 1, k as u32 + 1);
            place[reach] = sequence.len();
            sequence.push(reach);
        }
    }
    let mut taken: Vec<Option<Reach>> = list.into_iter().map(Some).collect();
    let sorted = sequence.into_iter().filter_map(|k| taken[k].take());
    sorted.map(|r| Reach { to: r.to.map(|t| place[t]), ..r }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::flow::node_areas;
    use crate::grid::{Edge, Edges, Grid, RasterDomain, Shape};
    use crate::random::Seed;

    #[test]
    fn two_streams_of_first_order_make_one_of_second() {
        // A Y: two arms join in the middle and run south.
        let (n, mut z) = (7, vec![100.0; 49]);
        for (k, (row, col)) in
            [(0, 1), (1, 2), (0, 5), (1, 4), (2, 3), (3, 3), (4, 3), (5, 3), (6, 3)].iter().enumerate()
        {
            z[row * n + col] = 50.0 - k as f64;
        }
        let mut grid = Grid::new(Shape::new(n, n), [1.0, 1.0]).unwrap();
        grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
        let domain = RasterDomain::new(&grid, &[]);
        let (mut flow, mut area) = (Flow::new(), node_areas(&domain));
        flow.route(&domain, &z, &mut area);
        let list = reaches(&flow, &area, 7.0);
        let trunk = &list[0];
        assert_eq!((trunk.order, trunk.river, trunk.number, trunk.to), (2, 1, 1, None));
        assert_eq!(trunk.nodes.last(), Some(&45));
        assert!(list.iter().filter(|r| r.to == Some(0)).count() == 2 && list.len() == 3, "{list:?}");
        let side: Vec<_> = list[1..].iter().map(|r| (r.order, r.river, r.number)).collect();
        assert_eq!(side, [(1, 1, 2), (1, 2, 1)]);
    }

    #[test]
    fn every_channel_node_is_in_one_reach_and_areas_grow_downstream() {
        let domain = RasterDomain::new(&Grid::new(Shape::new(60, 80), [1.0, 1.0]).unwrap(), &[]);
        let z: Vec<f64> = (0..4800).map(|i| 100.0 * Seed(3).uniform(i)).collect();
        let (mut flow, mut area) = (Flow::new(), node_areas(&domain));
        flow.route(&domain, &z, &mut area);
        let list = reaches(&flow, &area, 5.0);
        let mut seen = vec![0; z.len()];
        for reach in &list {
            for pair in reach.nodes.windows(2) {
                assert_eq!(flow.receivers()[pair[0] as usize], pair[1]);
                seen[pair[0] as usize] += 1;
            }
            if let Some(to) = reach.to {
                assert_eq!(list[to].nodes[0], reach.nodes[reach.nodes.len() - 1]);
                assert!(list[to].order >= reach.order);
            }
        }
        for i in 0..z.len() {
            let channel = area[i] >= 5.0 && flow.receivers()[i] as usize != i;
            assert_eq!(seen[i], i32::from(channel));
        }
    }
}
