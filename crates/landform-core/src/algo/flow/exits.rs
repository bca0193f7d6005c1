//! Where the water of every basin leaves it: the minimum spanning tree of basins, with its ways
//! turned outwards.
//!
//! # Method
//! Borůvka's rounds. Every tree of basins takes the lowest pass on its rim; its ways are turned so
//! that all its basins drain over that pass. A tree has one basin without an exit, its root. The
//! outside is a root for ever.
//!
//! Strips work side by side. A basin that has passes in several strips is *shared*; the lowest of
//! its passes may lie in another strip, so a tree that holds one waits. All other trees grow until
//! they have joined one that waits. Of the passes between those that wait, each strip keeps a
//! spanning forest: the highest pass of a cycle is never in the tree. What is kept is little, and
//! is joined at the end. Passes of one height are ordered by node, so there is one tree, and no cut
//! of the work changes it.
//!
//! # Sources
//! Borůvka (1926) by Nešetřil, Milková & Nešetřilová (2001); Cordonnier, Bovy & Braun (2019) for
//! the tree of basins.

use std::ops::Range;

use super::labels::OUTSIDE;
use super::passes::{Pass, find_passes};
use super::strips::split;
use crate::algo::disjoint_sets::DisjointSets;
use crate::grid::{Domain, NO_SLOT};
use crate::parallel;

const NONE: (f64, u32) = (f64::INFINITY, u32::MAX);

/// Where the water of a basin leaves it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exit {
    /// The last node in the basin.
    pub(super) node: u32,
    /// The slot that leads on from there; [`NO_SLOT`] if the water stays.
    pub(super) slot: u8,
    /// The basin beyond.
    to: u32,
}

const NO_EXIT: Exit = Exit { node: u32::MAX, slot: NO_SLOT, to: u32::MAX };

/// Numbers of the basins whose pits lie in a strip.
pub(super) fn home(pits: &[usize], strip: &Range<usize>) -> Range<u32> {
    let before = |node: usize| pits.partition_point(|&p| p < node) as u32 + 1;
    before(strip.start)..before(strip.end)
}

/// The exit of every basin, by its number; the outside has none. Basins that no pass joins to the
/// outside (a closed domain) drain to the pit of the first among them.
///
/// **Cost** O(nodes + passes · log basins), in practice a few rounds over passes that are halved
/// each time.
pub(super) fn find_exits<D: Domain>(
    domain: &D,
    elevation: &[f64],
    saddle: &[u8],
    slot: &[u8],
    label: &[u32],
    pits: &[usize],
    cuts: &[Range<usize>],
) -> Vec<Exit> {
    let strips = parallel::run_all(cuts.iter().collect(), |cut| {
        Strip::new(home(pits, cut), find_passes(domain, elevation, saddle, slot, label, cut))
    });
    let mut shared = vec![false; pits.len() + 1];
    strips.iter().flat_map(|s| &s.foreign).for_each(|&basin| shared[basin as usize] = true);
    let mut exits = vec![NO_EXIT; pits.len() + 1];
    let homes: Vec<_> = strips.iter().map(|s| s.home.start as usize..s.home.end as usize).collect();
    let parts = strips.into_iter().zip(split(&mut exits[1..], &homes)).collect();
    let basins = Basins { domain, label };
    let left = parallel::run_all(parts, |(strip, exits)| strip.join_inner(&basins, &shared, exits));
    join_rest(&basins, left.concat(), &mut exits);
    drain_to_first(&basins, &mut exits);
    exits
}

/// The passes of a strip. In it basins have numbers of their own: those at home, then the others.
struct Strip {
    home: Range<u32>,
    /// Basins whose pits lie elsewhere, ascending; the outside is always one.
    foreign: Vec<u32>,
    passes: Vec<Pass>,
}

impl Strip {
    fn new(home: Range<u32>, passes: Vec<Pass>) -> Self {
        let foreign = passes.iter().flat_map(|p| p.basins).filter(|basin| !home.contains(basin));
        let mut foreign: Vec<u32> = foreign.chain([OUTSIDE]).collect();
        foreign.sort_unstable();
        foreign.dedup();
        Self { home, foreign, passes }
    }

    /// The strip's own number of a basin.
    fn own(&self, basin: u32) -> u32 {
        if self.home.contains(&basin) {
            return basin - self.home.start;
        }
        let at = self.foreign.partition_point(|&b| b < basin);
        self.home.len() as u32 + at as u32
    }

    /// The number of a basin among all.
    fn global(&self, own: u32) -> u32 {
        match self.foreign.get((own as usize).wrapping_sub(self.home.len())) {
            Some(basin) => *basin,
            None => self.home.start + own,
        }
    }

    /// Joins all trees that hold no shared basin; returns the passes that may join the others,
    /// between their roots.
    fn join_inner<D: Domain>(mut self, basins: &Basins<D>, shared: &[bool], exits: &mut [Exit]) -> Vec<Pass> {
        let mut passes = std::mem::take(&mut self.passes);
        for pass in &mut passes {
            pass.basins = pass.basins.map(|basin| self.own(basin));
        }
        let mut trees = Forest::new(self.home.len() + self.foreign.len());
        let inner = |own: u32| !shared[self.global(own) as usize];
        trees.grow(&mut passes, inner, |pass, side| basins.leave_by(pass, side, exits, self.home.start));
        let mut kept = spanning_forest(passes, |pass| {
            let ends = basins.of(pass).map(|basin| trees.root(self.own(basin)));
            Pass { basins: ends.map(|own| self.global(own)), ..*pass }
        });
        kept.sort_unstable_by_key(|p| (p.node, p.nth));
        kept
    }
}

/// The passes of a spanning forest, each as `told`. Passes that are left out can be in no tree.
fn spanning_forest(mut passes: Vec<Pass>, mut told: impl FnMut(&Pass) -> Pass) -> Vec<Pass> {
    let ids = number_anew(&mut passes);
    let mut kept = Vec::new();
    Forest::new(ids.len()).grow(&mut passes, |_| true, |pass, _| kept.push(told(pass)));
    kept
}

/// Joins the trees that waited.
fn join_rest<D: Domain>(basins: &Basins<D>, mut passes: Vec<Pass>, exits: &mut [Exit]) {
    let ids = number_anew(&mut passes);
    let inner = |own: u32| ids[own as usize] != OUTSIDE;
    Forest::new(ids.len()).grow(&mut passes, inner, |pass, side| basins.leave_by(pass, side, exits, 0));
}

/// Numbers the basins of some passes from 0 on; returns what they were, ascending.
fn number_anew(passes: &mut [Pass]) -> Vec<u32> {
    let mut ids: Vec<u32> = passes.iter().flat_map(|p| p.basins).collect();
    ids.sort_unstable();
    ids.dedup();
    for pass in passes {
        pass.basins = pass.basins.map(|basin| ids.partition_point(|&id| id < basin) as u32);
    }
    ids
}

/// Lets trees that the outside is not part of drain to their first basin.
fn drain_to_first<D: Domain>(basins: &Basins<D>, exits: &mut [Exit]) {
    let first = OUTSIDE as usize + 1;
    if exits[first..].iter().all(|e| e.slot != NO_SLOT) {
        return;
    }
    let mut seen = vec![false; exits.len()];
    seen[OUTSIDE as usize] = true;
    for basin in first..exits.len() {
        let mut at = basin;
        while !std::mem::replace(&mut seen[at], true) {
            match exits[at] {
                Exit { slot: NO_SLOT, .. } => basins.turn(basin as u32, NO_EXIT, exits, 0),
                Exit { to, .. } => at = to as usize,
            }
        }
    }
}

/// Basins and the ground that they lie on.
struct Basins<'a, D> {
    domain: &'a D,
    label: &'a [u32],
}

impl<D: Domain> Basins<'_, D> {
    /// The basins on both sides of a pass.
    fn of(&self, pass: &Pass) -> [u32; 2] {
        let node = pass.node as usize;
        [self.label[node], self.label[self.domain.neighbour(node, pass.slot)]]
    }

    /// Lets the tree on one side of a pass drain over it. `exits` are those of the basins from
    /// `first` on.
    fn leave_by(&self, pass: &Pass, side: usize, exits: &mut [Exit], first: u32) {
        let basins = self.of(pass);
        let over = Exit { node: pass.node, slot: pass.slot, to: basins[1] };
        let exit = if side == 0 { over } else { self.back(over, basins[0]) };
        self.turn(basins[side], exit, exits, first);
    }

    /// The exit over the same link, the other way, into `basin`.
    fn back(&self, exit: Exit, basin: u32) -> Exit {
        let node = exit.node as usize;
        let slot = self.domain.slot_back(node, exit.slot);
        Exit { node: self.domain.neighbour(node, exit.slot) as u32, slot, to: basin }
    }

    /// Makes `exit` that of a basin, and turns round the way on which the basin drained before.
    fn turn(&self, mut basin: u32, mut exit: Exit, exits: &mut [Exit], first: u32) {
        loop {
            let old = std::mem::replace(&mut exits[(basin - first) as usize], exit);
            if old.slot == NO_SLOT {
                return;
            }
            exit = self.back(old, basin);
            basin = old.to;
        }
    }
}

/// Trees of basins that grow together.
struct Forest {
    /// Basins of each tree.
    sets: DisjointSets,
    /// The lowest pass of each root: height and place in the list.
    lowest: Vec<(f64, u32)>,
    /// Roots that may have passes left.
    roots: Vec<u32>,
}

impl Forest {
    /// Each basin is a tree.
    fn new(basins: usize) -> Self {
        Self { sets: DisjointSets::new(basins), lowest: vec![NONE; basins], roots: (0..basins as u32).collect() }
    }

    fn root(&mut self, x: u32) -> u32 {
        self.sets.root(x)
    }

    /// Rounds in which each tree whose root `takes` joins another by its lowest pass:
    /// `join(pass, its side of it)`. Leaves the passes between trees that remain.
    fn grow(&mut self, passes: &mut Vec<Pass>, takes: impl Fn(u32) -> bool, mut join: impl FnMut(&Pass, usize)) {
        loop {
            self.find_lowest(passes);
            let before = self.roots.len();
            let Self { sets, lowest, roots } = self;
            roots.retain(|&root| {
                let (_, k) = lowest[root as usize];
                if k == u32::MAX || !takes(root) {
                    return k != u32::MAX;
                }
                let pass = &passes[k as usize];
                let side = usize::from(pass.basins[1] == root);
                let other = pass.basins[1 - side];
                // One of two trees that take the same pass is enough.
                if other > root && takes(other) && lowest[other as usize].1 == k {
                    return true;
                }
                join(pass, side);
                sets.put_under(root, other);
                false
            });
            if roots.len() == before {
                return;
            }
        }
    }

    /// Drops passes within a tree, and finds the lowest of each root.
    fn find_lowest(&mut self, passes: &mut Vec<Pass>) {
        for &root in &self.roots {
            self.lowest[root as usize] = NONE;
        }
        let mut kept = 0;
        for k in 0..passes.len() {
            let mut pass = passes[k];
            pass.basins = pass.basins.map(|x| self.root(x));
            if pass.basins[0] == pass.basins[1] {
                continue;
            }
            for root in pass.basins {
                if pass.height < self.lowest[root as usize].0 {
                    self.lowest[root as usize] = (pass.height, kept as u32);
                }
            }
            passes[kept] = pass;
            kept += 1;
        }
        passes.truncate(kept);
    }
}
