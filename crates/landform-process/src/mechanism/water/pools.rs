//! Standing water with a level: pools that fill, overflow, join and are emptied.
//!
//! # Method
//! A pool floods from a pit outwards, always over the lowest node of its rim, until its water is
//! used up or a node of the rim leads down elsewhere: its exit. A pool that would flow into one
//! that already stands at the same pass joins it. Levels follow from the areas flooded, so they are
//! exact whatever the volume.
//!
//! # Sources
//! The flood is that of Priority-Flood (Barnes, Lehman & Mulla 2014) with a volume; that finite
//! water fills, spills and merges is Barnes, Callaghan & Wickert (2021), without their hierarchy:
//! pools form and vanish with the ground.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use landform_core::algo::depression::Height;
use landform_core::algo::flow::{fall, spread_steps};
use landform_core::grid::{Neighbours, RasterDomain};

/// No pool, or no node.
pub(super) const DRY: u32 = u32::MAX;

#[derive(Clone, Debug, Default)]
struct Pool {
    level: f64,
    /// Where it began.
    pit: u32,
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
    marks: Vec<Mark>,
    /// Emptied small pools, whose memory is used again.
    spare: Vec<Pool>,
    /// Number of steps to a pool's exit and to its rim.
    to_exit: Vec<u32>,
    to_rim: Vec<u32>,
}

/// Pool and rim of a node.
#[derive(Clone, Copy, Debug)]
struct Mark {
    /// Its pool, as numbered when it was flooded.
    pool: u32,
    /// The pool whose rim last took it in.
    rim_of: u32,
}

/// Lists longer than this are given back to the system: lakes are few, puddles many.
const MOST_SPARED: usize = 16;

const NOWHERE: Mark = Mark { pool: DRY, rim_of: DRY };

/// A node's neighbours.
struct Around {
    list: [u32; 8],
    len: usize,
}

impl Around {
    #[inline]
    fn of(domain: &RasterDomain, node: usize) -> Self {
        let mut around = Self { list: [DRY; 8], len: 0 };
        for link in domain.neighbours(node) {
            around.list[around.len & 7] = link.to as u32;
            around.len += 1;
        }
        around
    }

    #[inline]
    fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.list.iter().take(self.len).map(|&i| i as usize)
    }
}

impl Pools {
    /// Removes all water.
    pub(super) fn clear(&mut self, nodes: usize) {
        self.spare.truncate(self.pools.len());
        while let Some(pool) = self.pools.pop() {
            self.put_by(pool);
        }
        self.joined.clear();
        self.marks.clear();
        self.marks.resize(nodes, NOWHERE);
    }

    fn put_by(&mut self, mut pool: Pool) {
        if (1..=MOST_SPARED).contains(&pool.nodes.capacity()) && pool.rim.capacity() <= MOST_SPARED {
            pool.nodes.clear();
            pool.rim.clear();
            self.spare.push(Pool { exit: None, ..pool });
        }
    }

    /// The pool that a node lies in.
    #[inline]
    pub(super) fn at(&self, node: usize) -> u32 {
        match self.marks[node].pool {
            DRY => DRY,
            pool => self.root(pool),
        }
    }

    /// The pool that a node lies in, with the chain of pools that have joined shortened.
    #[inline]
    fn find(&mut self, node: usize) -> u32 {
        let mut pool = self.marks[node].pool;
        if pool == DRY {
            return DRY;
        }
        while self.joined[pool as usize] != pool {
            let next = self.joined[self.joined[pool as usize] as usize];
            self.joined[pool as usize] = next;
            pool = next;
        }
        pool
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
        let fresh = self.spare.pop().unwrap_or_default();
        self.pools.push(Pool { level: ground[pit], pit: pit as u32, ..fresh });
        self.flood(ground, id, pit, &Around::of(domain, pit));
        id
    }

    fn flood(&mut self, ground: &[f64], id: u32, node: usize, around: &Around) {
        self.marks[node].pool = id;
        self.pools[id as usize].nodes.push(node as u32);
        for to in around.iter() {
            if self.marks[to].rim_of != id && self.find(to) != id {
                self.marks[to].rim_of = id;
                self.pools[id as usize].rim.push(Reverse((Height(ground[to]), to as u32)));
            }
        }
    }

    /// Pours depths summed over nodes (m) into a pool. Returns the water that does not fit, with
    /// the exit by which it leaves.
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
                    Some(&Reverse((height, node))) => {
                        if self.find(node as usize) != id {
                            break Some((height.0, node as usize));
                        }
                        self.pools[id as usize].rim.pop();
                    }
                    None => break None,
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
        let around = Around::of(domain, node);
        let (mut from, mut leads_out) = (node, false);
        let (mut partners, mut count) = ([DRY; 8], 0);
        for to in around.iter() {
            match self.find(to) {
                DRY => leads_out |= ground[to] < level,
                other if other == id => from = to,
                other if self.pools[other as usize].level >= level => {
                    partners[count & 7] = other;
                    count += 1;
                }
                _ => leads_out = true,
            }
        }
        let own = self.find(node);
        if own != DRY && !is_end(node) {
            // Only level ground lies in two pools at once.
            self.join(ground, id, own);
            return;
        }
        if leads_out || is_end(node) {
            self.pools[id as usize].exit = Some(Exit { node: node as u32, from: from as u32 });
            return;
        }
        partners.into_iter().take(count).for_each(|other| self.join(ground, id, other));
        self.flood(ground, id, node, &around);
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
        // Equal but for rounding; the higher one, or water would run in a circle over the pass
        // between them.
        pool.level = pool.level.max(taken.level);
        if taken.nodes.len() > pool.nodes.len() {
            std::mem::swap(&mut pool.nodes, &mut taken.nodes);
        }
        pool.nodes.append(&mut taken.nodes);
        pool.rim.append(&mut taken.rim);
        if let Some(exit) = taken.exit {
            // It may still be one.
            pool.rim.push(Reverse((Height(ground[exit.node as usize]), exit.node)));
        }
        self.put_by(taken);
    }

    /// Writes the depth of standing water.
    pub(super) fn depths(&self, ground: &[f64], depth: &mut [f64]) {
        for pool in &self.pools {
            // Depths that add up to the volume to the last bit would not be level; this is level,
            // and adds up but for rounding.
            for &i in &pool.nodes {
                depth[i as usize] = (pool.level - ground[i as usize]).max(0.0);
            }
        }
    }

    /// Where a pool overflows, on its own side.
    pub(super) fn brink(&self, pool: u32) -> Option<usize> {
        self.pools[pool as usize].exit.map(|e| e.from as usize)
    }

    /// Calls `visit` with every node of a pool that water crosses on its way along the pool's
    /// middle to the exit, and how much. `net` is what came into the pool at a node less what once
    /// left there, m of depth; it is used up.
    pub(super) fn ways_through(&mut self, domain: &RasterDomain, net: &mut [f64], mut visit: impl FnMut(usize, f64)) {
        let marks = &mut self.marks;
        for (id, pool) in self.pools.iter().enumerate() {
            pool.nodes.iter().for_each(|&i| marks[i as usize].pool = id as u32);
        }
        self.to_exit.resize(marks.len(), 0);
        self.to_rim.resize(marks.len(), 0);
        let (marks, to_exit, to_rim) = (&self.marks, &mut self.to_exit, &mut self.to_rim);
        for (id, pool) in self.pools.iter().enumerate().filter(|p| !p.1.nodes.is_empty()) {
            let joined = |_, j: usize| marks[j].pool == id as u32;
            let root = pool.exit.map(|e| e.from as usize).filter(|&b| joined(b, b)).unwrap_or(pool.pit as usize);
            net[root] = net[root].max(0.0);
            if let [only] = pool.nodes[..] {
                let through = std::mem::take(&mut net[only as usize]);
                if through != 0.0 {
                    visit(only as usize, through);
                }
                continue;
            }
            for &i in &pool.nodes {
                (to_exit[i as usize], to_rim[i as usize]) = (0, 0);
            }
            let is_rim = |i: &usize| domain.neighbours(*i).any(|l| !joined(*i, l.to));
            spread_steps(domain, joined, pool.nodes.iter().map(|&i| i as usize).filter(is_rim), to_rim);
            let reached = spread_steps(domain, joined, std::iter::once(root), to_exit);
            let mut order: Vec<u64> = Vec::with_capacity(reached.len());
            for i in reached {
                let fall = fall(to_exit[i as usize], to_rim[i as usize]);
                to_exit[i as usize] = fall;
                order.push(u64::from(u32::MAX - fall) << 32 | u64::from(i));
            }
            order.sort_unstable();
            for i in order.into_iter().map(|key| key as u32 as usize) {
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
    }
}
