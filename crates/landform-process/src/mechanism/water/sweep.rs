//! Runoff: all the water of a round runs down in one sweep.
//!
//! # Method
//! Every node passes on what reached it once all higher neighbours have, shared among its lower neighbours by a [`Rule`]. Nodes are taken
//! as they get ready, the last first: a sweep runs down slopes, not from place to place by height, and finds what it needs in the cache.
//! What reaches pits then makes [`Pools`], and what leaves a pool by its exit runs on from there, the highest first (`runoff`). What
//! pools hold stays for the next round. Heights are rounded to 2⁻²² m, and level ground is tilted by a few units of the last place: water on it has a way, not a way for every error of rounding.
//!
//! **Cost** O(n) for the sweep, O(log m) for each of the m nodes under standing water or below its exits, which late water may pass more
//! than once (on rough ground 1.1 times in the mean). One thread: every node waits for those above it.

use std::collections::{BTreeMap, BinaryHeap};

use landform_core::algo::flow::tilt_flats;
use landform_core::grid::{BASE_LEVEL, Domain, INTERIOR, MASKED, RasterDomain};
use landform_core::parallel;

use super::glance::Glances;
use super::pools::{Height, Pools};
use super::runoff::Late;
use super::spread::{GRAIN, Lower, Rule};
use super::{Ledger, Supply};

/// What a round runs over.
pub(super) struct Over<'a> {
    pub(super) domain: &'a RasterDomain,
    pub(super) ground: &'a [f64],
    pub(super) supply: &'a Supply<'a>,
}

impl Over<'_> {
    /// Whether water leaves here.
    #[inline]
    pub(super) fn is_end(&self, i: usize) -> bool {
        self.domain.status()[i] == BASE_LEVEL || self.supply.sinks.get(i).copied().unwrap_or(false)
    }
}

/// Runoff over a raster.
#[derive(Clone, Debug)]
pub struct Sweep {
    pub(super) rule: Rule,
    /// Nodes as the sweep took them.
    pub(super) order: Vec<u32>,
    pub(super) pools: Pools,
    /// What passed each node, m of depth.
    pub(super) passed: Vec<f64>,
    /// Late water for nodes, m of depth, and what has any, by height.
    pub(super) late: Vec<f64>,
    pub(super) queue: BinaryHeap<(Height, Late)>,
    /// Water for pools, m of depth, by pool.
    pub(super) inflow: Vec<f64>,
    pub(super) left: f64,
    /// What came into a pool at each node less what left there, m of depth.
    pub(super) net: Vec<f64>,
    glances: Glances,
    /// The ground without what is less than a grain, and with its flats tilted.
    even: Vec<f64>,
}

impl Sweep {
    /// Empty.
    pub fn new(rule: Rule) -> Self {
        Self {
            rule,
            order: Vec::new(),
            pools: Pools::default(),
            passed: Vec::new(),
            late: Vec::new(),
            queue: BinaryHeap::new(),
            inflow: Vec::new(),
            left: 0.0,
            net: Vec::new(),
            glances: Glances::default(),
            even: Vec::new(),
        }
    }

    /// What passed each node in the last round, m of depth over the node.
    pub fn passed(&self) -> &[f64] {
        &self.passed
    }

    /// The ground that the last round ran over, within a micrometre of what it was given.
    pub fn ran_over(&self) -> &[f64] {
        &self.even
    }

    /// One round: `standing` is the depth of standing water before, and after.
    pub fn round(&mut self, domain: &RasterDomain, ground: &[f64], supply: &Supply, standing: &mut [f64]) -> Ledger {
        let mut even = std::mem::take(&mut self.even);
        even.resize(ground.len(), 0.0);
        let status = domain.status();
        parallel::fill(&mut even, |i| {
            if status[i] == MASKED { f64::NAN } else { (ground[i] / GRAIN).round_ties_even() * GRAIN }
        });
        if let Some(tilted) = tilt_flats(domain, &even) {
            even = tilted;
        }
        let ledger = self.run(&Over { domain, ground: &even, supply }, standing);
        self.even = even;
        ledger
    }

    fn run(&mut self, over: &Over, standing: &mut [f64]) -> Ledger {
        let n = over.ground.len();
        self.passed.clear();
        self.passed.extend(over.supply.depth.iter().map(|water| water.max(0.0)));
        self.left = 0.0;
        for list in [&mut self.late, &mut self.net] {
            list.clear();
            list.resize(n, 0.0);
        }
        self.inflow.clear();
        self.pools.clear(n);
        let mut ledger = Ledger { entered: over.supply.total, ..Ledger::default() };
        let mut held = self.take_up(over, standing, &mut ledger);
        for pit in self.run_down(over) {
            let stood = held.remove(&pit).unwrap_or(0.0);
            self.new_pool(over, pit as usize, self.passed[pit as usize], stood);
        }
        // Hollows that nothing else came to.
        for (pit, stood) in held {
            if over.is_end(pit as usize) {
                self.left += stood;
            } else {
                self.new_pool(over, pit as usize, 0.0, stood);
            }
        }
        self.run_off(over);
        let passed = &mut self.passed;
        self.pools.ways_through(over.domain, &mut self.net, |i, all| passed[i] = passed[i].max(all));
        standing.fill(0.0);
        self.pools.depths(over.ground, standing);
        ledger.stored = standing.iter().sum();
        ledger.left = self.left;
        ledger
    }

    /// Takes the standing water up, pool by pool: what held a hollow is kept for its lowest node, the rest of it (where the ground gave
    /// way since) runs off with the rain.
    fn take_up(&mut self, over: &Over, standing: &mut [f64], ledger: &mut Ledger) -> BTreeMap<u32, f64> {
        let Over { domain, ground, supply } = over;
        let mut held = BTreeMap::new();
        let mut stack = Vec::new();
        for start in 0..standing.len() {
            if !(standing[start] > 0.0) {
                continue;
            }
            // One connected body of water.
            let (mut lowest, mut volume) = (start, 0.0);
            stack.push(start);
            let mut take = |i: usize, standing: &mut [f64]| {
                let depth = std::mem::take(&mut standing[i]);
                let dried = supply.evaporation.min(depth);
                ledger.before += depth;
                ledger.evaporated += dried;
                volume += depth - dried;
            };
            take(start, standing);
            while let Some(i) = stack.pop() {
                if ground[i] < ground[lowest] || ground[i] == ground[lowest] && i < lowest {
                    lowest = i;
                }
                for link in domain.neighbours(i) {
                    if standing[link.to] > 0.0 {
                        take(link.to, standing);
                        stack.push(link.to);
                    }
                }
            }
            let is_pit = domain.neighbours(lowest).all(|l| !(ground[l.to] < ground[lowest]));
            if is_pit && domain.status()[lowest] == INTERIOR {
                *held.entry(lowest as u32).or_insert(0.0) += volume;
            } else {
                self.passed[lowest] += volume;
            }
        }
        held
    }

    /// Lets the first water run down, over dry ground. Returns the pits that any has come to.
    fn run_down(&mut self, over: &Over) -> Vec<u32> {
        let mut glances = std::mem::take(&mut self.glances);
        glances.look(over.domain, over.ground);
        self.order.clear();
        let (mut pits, mut ready) = (Vec::new(), Vec::new());
        for start in 0..over.ground.len() {
            if glances.is_ready(start) {
                ready.push(start as u32);
            }
            while let Some(node) = ready.pop() {
                self.order.push(node);
                let i = node as usize;
                self.pass_on(over, &glances, i, &mut pits);
                glances.visited(over.domain, over.ground, i, |to| ready.push(to as u32));
            }
        }
        self.glances = glances;
        pits
    }

    /// A node passes on what has come to it.
    #[inline]
    fn pass_on(&mut self, over: &Over, glances: &Glances, i: usize, pits: &mut Vec<u32>) {
        let water = self.passed[i];
        if over.is_end(i) {
            self.left += water;
            return;
        }
        if !(water > 0.0) {
            return;
        }
        if let Rule::Columns { depth } = self.rule
            && let Some(place) = glances.at(i).takes_all(depth * self.part(over, i).sqrt())
        {
            self.passed[glances.neighbour(i, place)] += water;
            return;
        }
        let mut lower = Lower::around(over.domain, over.ground, i, |to| over.ground[to]);
        if lower.is_empty() {
            pits.push(i as u32);
            return;
        }
        lower.share(self.rule, over.ground[i], self.part(over, i));
        lower.shares().for_each(|(j, share)| self.passed[j] += water * share);
    }

    /// What has passed a node, as a part of all that came in.
    #[inline]
    pub(super) fn part(&self, over: &Over, i: usize) -> f64 {
        (self.passed[i] / over.supply.total).min(1.0)
    }
}
