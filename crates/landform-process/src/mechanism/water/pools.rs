//! Standing water with a level: pools that fill, overflow, join and are emptied.
//!
//! # Method
//! A pool floods from a pit outwards, always over the lowest node of its rim, until its water is used up or a node of the rim leads down
//! elsewhere: its exit. A pool that would flow into one that already stands at the same pass joins it. Levels follow from the areas
//! flooded, so they are exact whatever the volume.
//!
//! # Sources
//! The flood is that of Priority-Flood (Barnes, Lehman & Mulla 2014) with a volume; that finite water fills, spills and merges is
//! Barnes, Callaghan & Wickert (2021), without their hierarchy: pools are few and come and go with the ground.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use landform_core::algo::flow::{fall, spread_steps};
use landform_core::grid::{Domain, RasterDomain};

/// No pool, or no node.
pub(super) const DRY: u32 = u32::MAX;

/// A height that is ordered totally.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Height(pub(super) f64);

impl Eq for Height {}

impl PartialOrd for Height {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Height {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

#[derive(Clone, Debug, Default)]
struct Pool {
    level: f64,
    nodes: Vec<u32>,
    rim: BinaryHeap<Reverse<(Height, u32)>>,
    exit: Option<Exit>,
}

/// Where a pool overflows.
#[derive(Clone, Copy, Debug)]
struct Exit {
    node: u32,
    /// The pool's node beside it.
    from: u32,
}

/// All pools over one ground.
#[derive(Clone, Debug, Default)]
pub(super) struct Pools {
    pools: Vec<Pool>,
    /// The pool that a pool has joined; itself if none.
    joined: Vec<u32>,
    /// The pool of every node, as numbered when it was flooded.
    of: Vec<u32>,
    /// The pool whose rim last took a node in, and the node that it was reached from.
    rim_of: Vec<u32>,
    from: Vec<u32>,
}

impl Pools {
    /// Takes all water away.
    pub(super) fn clear(&mut self, nodes: usize) {
        self.pools.clear();
        self.joined.clear();
        for list in [&mut self.of, &mut self.rim_of, &mut self.from] {
            list.clear();
            list.resize(nodes, DRY);
        }
    }

    /// The pool that a node lies in.
    #[inline]
    pub(super) fn at(&self, node: usize) -> u32 {
        match self.of[node] {
            DRY => DRY,
            pool => self.root(pool),
        }
    }

    pub(super) fn root(&self, mut pool: u32) -> u32 {
        while self.joined[pool as usize] != pool {
            pool = self.joined[pool as usize];
        }
        pool
    }

    /// Surface of the water over a node, or its ground.
    #[inline]
    pub(super) fn surface(&self, ground: &[f64], node: usize) -> f64 {
        match self.at(node) {
            DRY => ground[node],
            pool => self.pools[pool as usize].level.max(ground[node]),
        }
    }

    /// Level of a pool.
    pub(super) fn level(&self, pool: u32) -> f64 {
        self.pools[pool as usize].level
    }

    /// Begins an empty pool at a pit.
    pub(super) fn begin(&mut self, domain: &RasterDomain, ground: &[f64], pit: usize) -> u32 {
        let id = self.pools.len() as u32;
        self.joined.push(id);
        self.pools.push(Pool { level: ground[pit], ..Pool::default() });
        self.flood(domain, ground, id, pit);
        id
    }

    fn flood(&mut self, domain: &RasterDomain, ground: &[f64], id: u32, node: usize) {
        self.of[node] = id;
        let pool = &mut self.pools[id as usize];
        pool.nodes.push(node as u32);
        for link in domain.neighbours(node) {
            if self.of[link.to] != id && self.rim_of[link.to] != id {
                (self.rim_of[link.to], self.from[link.to]) = (id, node as u32);
                pool.rim.push(Reverse((Height(ground[link.to]), link.to as u32)));
            }
        }
    }

    /// Pours depths summed over nodes (m) into a pool. What does not fit comes back, with the exit that it leaves by.
    pub(super) fn pour(
        &mut self,
        domain: &RasterDomain,
        ground: &[f64],
        is_end: impl Fn(usize) -> bool,
        id: u32,
        mut amount: f64,
    ) -> Option<(usize, f64)> {
        loop {
            if let Some(exit) = self.pools[id as usize].exit {
                return Some((exit.node as usize, amount));
            }
            let next = loop {
                match self.pools[id as usize].rim.peek() {
                    Some(Reverse((_, node))) if self.at(*node as usize) == id => {
                        self.pools[id as usize].rim.pop();
                    }
                    other => break other.map(|r| (r.0.0.0, r.0.1 as usize)),
                }
            };
            let pool = &mut self.pools[id as usize];
            let count = pool.nodes.len() as f64;
            let room = next.map_or(f64::INFINITY, |(height, _)| count * (height - pool.level).max(0.0));
            if amount < room {
                pool.level += amount / count;
                return None;
            }
            let (height, node) = next?;
            amount -= room;
            pool.level = pool.level.max(height);
            pool.rim.pop();
            self.reach(domain, ground, &is_end, id, node);
        }
    }

    /// A rising pool has reached a node of its rim: it is flooded, or the way out.
    fn reach(&mut self, domain: &RasterDomain, ground: &[f64], is_end: &impl Fn(usize) -> bool, id: u32, node: usize) {
        let level = self.pools[id as usize].level;
        let from = domain.neighbours(node).find(|l| self.at(l.to) == id).map_or(node, |l| l.to) as u32;
        let exit = Some(Exit { node: node as u32, from });
        if is_end(node) {
            self.pools[id as usize].exit = exit;
            return;
        }
        match self.at(node) {
            DRY => {}
            other => {
                // Only level ground lies in two pools at once.
                self.join(ground, id, other);
                return;
            }
        }
        let mut leads_out = false;
        let mut partners = Vec::new();
        for link in domain.neighbours(node) {
            match self.at(link.to) {
                other if other == id => {}
                DRY => leads_out |= ground[link.to] < level,
                other if self.pools[other as usize].level >= level => partners.push(other),
                other => leads_out |= self.pools[other as usize].level < level,
            }
        }
        if leads_out {
            self.pools[id as usize].exit = exit;
            return;
        }
        for other in partners {
            self.join(ground, id, other);
        }
        self.flood(domain, ground, id, node);
    }

    /// A pool takes in another that stands at its level.
    fn join(&mut self, ground: &[f64], id: u32, other: u32) {
        let other = self.root(other);
        if other == id {
            return;
        }
        let mut taken = std::mem::take(&mut self.pools[other as usize]);
        self.joined[other as usize] = id;
        let pool = &mut self.pools[id as usize];
        // Equal but for rounding; the higher one, or water would run in a circle over the pass between them.
        pool.level = pool.level.max(taken.level);
        pool.nodes.append(&mut taken.nodes);
        pool.rim.append(&mut taken.rim);
        if let Some(exit) = taken.exit {
            // It may still be one.
            pool.rim.push(Reverse((Height(ground[exit.node as usize]), exit.node)));
        }
    }

    /// Writes the depth of standing water.
    pub(super) fn depths(&self, ground: &[f64], depth: &mut [f64]) {
        for pool in &self.pools {
            // Depths that add up to the volume to the last bit would not be level; this is level, and adds up but for rounding.
            for &i in &pool.nodes {
                depth[i as usize] = (pool.level - ground[i as usize]).max(0.0);
            }
        }
    }

    /// Where a pool overflows, on its own side.
    pub(super) fn brink(&self, pool: u32) -> Option<usize> {
        self.pools[pool as usize].exit.map(|e| e.from as usize)
    }

    /// Calls `visit` with every node of a pool that water crosses on its way along the pool's middle to the exit, and how much. `net` is
    /// what came into the pool at a node less what once left there, m of depth; it is used up. Only the last call after a round: marks are
    /// overwritten.
    pub(super) fn ways_through(&mut self, domain: &RasterDomain, net: &mut [f64], mut visit: impl FnMut(usize, f64)) {
        for (id, pool) in self.pools.iter().enumerate() {
            pool.nodes.iter().for_each(|&i| self.of[i as usize] = id as u32);
        }
        let (mut to_exit, mut to_rim) = (std::mem::take(&mut self.rim_of), std::mem::take(&mut self.from));
        for id in 0..self.pools.len() as u32 {
            let nodes = &self.pools[id as usize].nodes;
            let Some(&first) = nodes.first() else { continue };
            let root = self.brink(id).filter(|&b| self.of[b] == id).unwrap_or(first as usize);
            let joined = |_, j: usize| self.of[j] == id;
            for &i in nodes {
                (to_exit[i as usize], to_rim[i as usize]) = (0, 0);
            }
            let is_rim = |i: &usize| domain.neighbours(*i).any(|l| !joined(*i, l.to));
            spread_steps(domain, joined, nodes.iter().map(|&i| i as usize).filter(is_rim), &mut to_rim);
            let mut order = spread_steps(domain, joined, std::iter::once(root), &mut to_exit);
            for &i in &order {
                to_exit[i as usize] = fall(to_exit[i as usize], to_rim[i as usize]);
            }
            order.sort_unstable_by_key(|&i| (std::cmp::Reverse(to_exit[i as usize]), i));
            net[root] = net[root].max(0.0);
            for i in order.into_iter().map(|i| i as usize) {
                let through = std::mem::take(&mut net[i]);
                if through != 0.0 {
                    visit(i, through.abs());
                    let inside = domain.neighbours(i).filter(|l| joined(i, l.to));
                    if let Some(next) = inside.min_by_key(|l| to_exit[l.to]).filter(|_| i != root) {
                        net[next.to] += through;
                    }
                }
            }
        }
        (self.rim_of, self.from) = (to_exit, to_rim);
    }
}
