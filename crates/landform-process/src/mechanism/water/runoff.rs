//! Overflow of pools: water that runs later than the first, over the same ground.

use landform_core::algo::depression::Height;

use super::input::{OverflowEvent, RunoffInput};
use super::pools::DRY;
use super::spread::FlowPartition;
use super::sweep::Sweep;

impl Sweep {
    /// Makes a pool at a pit, of the water that came to it and the water that stood there before,
    /// which is no flow.
    pub(super) fn new_pool(&mut self, input: &RunoffInput, pit: usize, came: f64, stood: f64) {
        let pool = self.pools.begin(input.domain, input.ground, pit);
        self.inflow.push(0.0);
        self.send_to_pool(pool, pit, came + stood);
        self.net[pit] -= stood;
    }

    /// Fills pools and routes their overflow, the highest first, until all water stands or has
    /// left.
    pub(super) fn route_overflow(&mut self, input: &RunoffInput) {
        while let Some((_, event)) = self.queue.pop() {
            match event {
                OverflowEvent::Node(node) => self.route_from(input, node as usize),
                OverflowEvent::Pool(pool) => {
                    let water = std::mem::take(&mut self.inflow[pool as usize]);
                    let pool = self.pools.root(pool);
                    if let Some((exit, more)) =
                        self.pools.pour(input.domain, input.ground, |i| input.is_end(i), pool, water)
                    {
                        if let Some(brink) = self.pools.brink(pool) {
                            self.net[brink] -= more;
                        }
                        self.send_to_node(input, exit, more);
                    }
                }
            }
        }
    }

    /// Routes overflow on from a node.
    fn route_from(&mut self, input: &RunoffInput, i: usize) {
        let water = std::mem::take(&mut self.overflow[i]);
        self.passed[i] += water;
        if input.is_end(i) {
            self.left += water;
            return;
        }
        let pool = self.pools.at(i);
        if pool != DRY {
            self.send_to_pool(pool, i, water);
            return;
        }
        // Standing water counts by its surface.
        let mut lower =
            FlowPartition::from_neighbours(input.domain, input.ground, i, |to| self.pools.surface(input.ground, to));
        if lower.is_empty() {
            self.new_pool(input, i, water, 0.0);
            return;
        }
        lower.set_weights(self.rule, self.part(input, i));
        for (j, share) in lower.weights() {
            let amount = water * share;
            if amount == 0.0 {
                // Divided until nothing was left: it must cause no further event.
                continue;
            }
            match self.pools.at(j) {
                DRY => self.send_to_node(input, j, amount),
                pool => {
                    self.passed[j] += amount;
                    self.send_to_pool(pool, j, amount);
                }
            }
        }
    }

    fn send_to_node(&mut self, input: &RunoffInput, node: usize, amount: f64) {
        if self.overflow[node] == 0.0 {
            self.queue.push((Height(input.ground[node]), OverflowEvent::Node(node as u32)));
        }
        self.overflow[node] += amount;
    }

    /// Water comes into a pool at one of its nodes.
    fn send_to_pool(&mut self, pool: u32, node: usize, amount: f64) {
        self.net[node] += amount;
        let waiting = self.inflow[pool as usize];
        if waiting == 0.0 {
            self.queue.push((Height(self.pools.level(pool)), OverflowEvent::Pool(pool)));
        }
        self.inflow[pool as usize] = waiting + amount;
    }
}
