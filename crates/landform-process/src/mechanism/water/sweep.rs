//! Runoff: all the water of a round runs down in one sweep.
//!
//! # Method
//! Once all its higher neighbours have done so, a node passes on its water, shared among its lower
//! neighbours by a [`Rule`]. Nodes are taken as they get ready, the last first: a sweep runs down
//! slopes rather than in order of height, and finds what it needs in the cache. Water that reaches
//! pits then makes [`Pools`]. Water that leaves a pool by its exit runs on from there, the highest
//! first (`runoff`). Water in pools stays for the next round. Heights are rounded to 2⁻²² m, and
//! level ground is tilted by a few units of the last place, so that rounding errors do not decide
//! the path of water on it.
//!
//! **Cost** O(n) for the sweep, O(log m) for each of the m nodes under standing water or below its
//! exits, which overflow may pass more than once (on rough ground 1.1 times in the mean). One
//! thread: every node waits for those above it.

use std::collections::{BTreeMap, BinaryHeap};

use landform_core::algo::depression::Height;
use landform_core::algo::flow::tilt_flats;
use landform_core::grid::{Domain, Neighbours, RasterDomain, Status};
use landform_core::parallel;

use super::input::{OverflowEvent, RunoffInput};
use super::neighbours::NeighbourTable;
use super::pools::Pools;
use super::spread::{FlowPartition, GRAIN, Rule};
use super::{Ledger, Supply};

/// Runoff over a raster.
#[derive(Clone, Debug)]
pub struct Sweep {
    pub(super) rule: Rule,
    /// Nodes in the order of the sweep.
    pub(super) order: Vec<u32>,
    pub(super) pools: Pools,
    /// Water that passed each node, m of depth.
    pub(super) passed: Vec<f64>,
    /// Overflow for nodes, m of depth, and the nodes and pools that have any, by height.
    pub(super) overflow: Vec<f64>,
    pub(super) queue: BinaryHeap<(Height, OverflowEvent)>,
    /// Water for pools, m of depth, by pool.
    pub(super) inflow: Vec<f64>,
    pub(super) left: f64,
    /// Water that entered a pool at each node less the water that left there, m of depth.
    pub(super) net: Vec<f64>,
    table: NeighbourTable,
    /// The ground without what is less than a grain, and with its flats tilted.
    routing_ground: Vec<f64>,
}

impl Sweep {
    /// Empty.
    pub fn new(rule: Rule) -> Self {
        Self {
            rule,
            order: Vec::new(),
            pools: Pools::default(),
            passed: Vec::new(),
            overflow: Vec::new(),
            queue: BinaryHeap::new(),
            inflow: Vec::new(),
            left: 0.0,
            net: Vec::new(),
            table: NeighbourTable::default(),
            routing_ground: Vec::new(),
        }
    }

    /// Water that passed each node in the last round, m of depth over the node.
    pub fn passed(&self) -> &[f64] {
        &self.passed
    }

    /// The ground (m) that the last round ran over, within a micrometre of its input.
    pub fn ran_over(&self) -> &[f64] {
        &self.routing_ground
    }

    /// One round: `standing` is the depth (m) of standing water before, and after.
    pub fn round(&mut self, domain: &RasterDomain, ground: &[f64], supply: &Supply, standing: &mut [f64]) -> Ledger {
        let mut even = std::mem::take(&mut self.routing_ground);
        even.resize(ground.len(), 0.0);
        let status = domain.status();
        parallel::fill(&mut even, |i| {
            if status[i] == Status::Masked { f64::NAN } else { (ground[i] / GRAIN).round_ties_even() * GRAIN }
        });
        if let Some(tilted) = tilt_flats(domain, &even) {
            even = tilted;
        }
        let ledger = self.run(&RunoffInput { domain, ground: &even, supply }, standing);
        self.routing_ground = even;
        ledger
    }

    fn run(&mut self, input: &RunoffInput, standing: &mut [f64]) -> Ledger {
        let n = input.ground.len();
        self.passed.clear();
        self.passed.extend(input.supply.depth.iter().map(|water| water.max(0.0)));
        self.left = 0.0;
        for list in [&mut self.overflow, &mut self.net] {
            list.clear();
            list.resize(n, 0.0);
        }
        self.inflow.clear();
        self.pools.clear(n);
        let mut ledger = Ledger { entered: input.supply.total, ..Ledger::default() };
        let mut held = self.collect_standing(input, standing, &mut ledger);
        for pit in self.route_runoff(input) {
            let stood = held.remove(&pit).unwrap_or(0.0);
            self.new_pool(input, pit as usize, self.passed[pit as usize], stood);
        }
        // Depressions that no other water reached.
        for (pit, stood) in held {
            if input.is_end(pit as usize) {
                self.left += stood;
            } else {
                self.new_pool(input, pit as usize, 0.0, stood);
            }
        }
        self.route_overflow(input);
        let passed = &mut self.passed;
        self.pools.ways_through(input.domain, &mut self.net, |i, all| passed[i] = passed[i].max(all));
        standing.fill(0.0);
        self.pools.depths(input.ground, standing);
        ledger.stored = standing.iter().sum();
        ledger.left = self.left;
        ledger
    }

    /// Takes up the standing water, pool by pool: water that a depression still holds is kept for
    /// its lowest node, the rest (where the ground was eroded since) runs off with the rain.
    fn collect_standing(
        &mut self,
        input: &RunoffInput,
        standing: &mut [f64],
        ledger: &mut Ledger,
    ) -> BTreeMap<u32, f64> {
        let RunoffInput { domain, ground, supply } = input;
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
            if is_pit && domain.status()[lowest] == Status::Interior {
                *held.entry(lowest as u32).or_insert(0.0) += volume;
            } else {
                self.passed[lowest] += volume;
            }
        }
        held
    }

    /// Routes the first water down over dry ground. Returns the pits that water has reached.
    fn route_runoff(&mut self, input: &RunoffInput) -> Vec<u32> {
        let mut table = std::mem::take(&mut self.table);
        table.build(input.domain, input.ground);
        self.order.clear();
        let (mut pits, mut ready) = (Vec::new(), Vec::new());
        for start in 0..input.ground.len() {
            if table.is_ready(start) {
                ready.push(start as u32);
            }
            while let Some(node) = ready.pop() {
                self.order.push(node);
                let i = node as usize;
                self.pass_on(input, &table, i, &mut pits);
                table.visited(input.domain, input.ground, i, |to| ready.push(to as u32));
            }
        }
        self.table = table;
        pits
    }

    /// A node passes on the water that has reached it.
    #[inline]
    fn pass_on(&mut self, input: &RunoffInput, table: &NeighbourTable, i: usize, pits: &mut Vec<u32>) {
        let water = self.passed[i];
        if input.is_end(i) {
            self.left += water;
            return;
        }
        if !(water > 0.0) {
            return;
        }
        if let Rule::Columns { depth } = self.rule
            && let Some(place) = table.at(i).sole_receiver(depth * self.part(input, i).sqrt())
        {
            self.passed[table.neighbour(i, place)] += water;
            return;
        }
        let mut lower = FlowPartition::from_neighbours(input.domain, input.ground, i, |to| input.ground[to]);
        if lower.is_empty() {
            pits.push(i as u32);
            return;
        }
        lower.set_weights(self.rule, self.part(input, i));
        lower.weights().for_each(|(j, share)| self.passed[j] += water * share);
    }

    /// Water that has passed a node, as a part of all that entered.
    #[inline]
    pub(super) fn part(&self, input: &RunoffInput, i: usize) -> f64 {
        (self.passed[i] / input.supply.total).min(1.0)
    }
}
