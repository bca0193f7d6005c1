//! What runs on from pools: late water, over ground where the first water has been.

use super::pools::{DRY, Height};
use super::spread::Lower;
use super::sweep::{Over, Sweep};

/// What waits for water that comes late.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Late {
    Pool(u32),
    Node(u32),
}

impl Sweep {
    /// A pit gets a pool, with what came to it and what stood there before, which is no flow.
    pub(super) fn new_pool(&mut self, over: &Over, pit: usize, came: f64, stood: f64) {
        let pool = self.pools.begin(over.domain, over.ground, pit);
        self.inflow.push(0.0);
        self.send_to_pool(pool, pit, came + stood);
        self.net[pit] -= stood;
    }

    /// Fills pools and lets run on what leaves them, the highest first, until all stands or has left.
    pub(super) fn run_off(&mut self, over: &Over) {
        while let Some((_, late)) = self.queue.pop() {
            match late {
                Late::Node(node) => self.run_on(over, node as usize),
                Late::Pool(pool) => {
                    let water = std::mem::take(&mut self.inflow[pool as usize]);
                    let pool = self.pools.root(pool);
                    if let Some((exit, more)) =
                        self.pools.pour(over.domain, over.ground, |i| over.is_end(i), pool, water)
                    {
                        if let Some(brink) = self.pools.brink(pool) {
                            self.net[brink] -= more;
                        }
                        self.send_to_node(over, exit, more);
                    }
                }
            }
        }
    }

    /// Late water at a node runs on.
    fn run_on(&mut self, over: &Over, i: usize) {
        let water = std::mem::take(&mut self.late[i]);
        self.passed[i] += water;
        if over.is_end(i) {
            self.left += water;
            return;
        }
        let pool = self.pools.at(i);
        if pool != DRY {
            self.send_to_pool(pool, i, water);
            return;
        }
        // Standing water counts with its surface.
        let mut lower = Lower::around(over.domain, over.ground, i, |to| self.pools.surface(over.ground, to));
        if lower.is_empty() {
            self.new_pool(over, i, water, 0.0);
            return;
        }
        lower.share(self.rule, over.ground[i], self.part(over, i));
        for (j, share) in lower.shares() {
            let amount = water * share;
            if amount == 0.0 {
                // Divided until nothing was left: it must not wake anyone.
                continue;
            }
            match self.pools.at(j) {
                DRY => self.send_to_node(over, j, amount),
                pool => {
                    self.passed[j] += amount;
                    self.send_to_pool(pool, j, amount);
                }
            }
        }
    }

    fn send_to_node(&mut self, over: &Over, node: usize, amount: f64) {
        if self.late[node] == 0.0 {
            self.queue.push((Height(over.ground[node]), Late::Node(node as u32)));
        }
        self.late[node] += amount;
    }

    /// Water comes into a pool at one of its nodes.
    fn send_to_pool(&mut self, pool: u32, node: usize, amount: f64) {
        self.net[node] += amount;
        let waiting = self.inflow[pool as usize];
        if waiting == 0.0 {
            self.queue.push((Height(self.pools.level(pool)), Late::Pool(pool)));
        }
        self.inflow[pool as usize] = waiting + amount;
    }
}
