//! Runoff: all the water of a round runs down in one sweep, from the highest node to the lowest.
//!
//! # Method
//! Every node passes on what reached it, shared among its lower neighbours by a [`Rule`]. Pits make [`Pools`]; what leaves a pool by its
//! exit runs on from there, also over nodes that the sweep has passed. What pools hold stays for the next round. Ground that differs by
//! less than 2⁻²² m is level, and level ground is tilted by a few units of the last place: water on it has a way, not a way for
//! every error of rounding.
//!
//! **Cost** O(n) for the sweep, O(m log m) for the m nodes under standing water. One thread: every node waits for those above it.

use std::collections::{BinaryHeap, HashMap};

use landform_core::algo::flow::tilt_flats;
use landform_core::grid::{BASE_LEVEL, Domain, INTERIOR, RasterDomain, Shape};
use landform_core::parallel;

use super::order::HighestFirst;
use super::pools::{DRY, Height, Pools};
use super::spread::{GRAIN, Lower, Rule};
use super::{Ledger, Supply};

/// A node as the sweep sees it: ground and water side by side, since memory is what a visit waits for.
#[derive(Clone, Copy, Debug)]
struct Site {
    ground: f64,
    /// Water that has reached the node (m of depth); once the sweep has passed it, less than 0 (or -0): minus what passed.
    water: f64,
}

impl Site {
    #[inline]
    fn is_passed(self) -> bool {
        self.water.is_sign_negative()
    }
}

/// What a round runs over.
struct Over<'a> {
    domain: &'a RasterDomain,
    ground: &'a [f64],
    supply: &'a Supply<'a>,
}

impl Over<'_> {
    /// Whether water leaves here.
    #[inline]
    fn is_end(&self, i: usize) -> bool {
        self.domain.status()[i] == BASE_LEVEL || self.supply.sinks.get(i).copied().unwrap_or(false)
    }
}

/// What waits for water that comes late.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Late {
    Pool(u32),
    Node(u32),
}

/// Runoff over a raster.
#[derive(Clone, Debug)]
pub struct Sweep {
    pub(super) rule: Rule,
    pub(super) order: HighestFirst,
    pub(super) pools: Pools,
    sites: Vec<Site>,
    /// Water for nodes that the sweep has passed, m of depth, and the nodes by height.
    late: Vec<f64>,
    queue: BinaryHeap<(Height, Late)>,
    /// Water for pools, m of depth, by pool.
    inflow: Vec<f64>,
    /// What passed each node, m of depth.
    passed: Vec<f64>,
    left: f64,
    /// What came into a pool at each node less what left there, m of depth.
    net: Vec<f64>,
    /// Where most water goes, so that a visit need not look around.
    glance: Vec<Glance>,
    /// The ground without what is less than a grain, and with its flats tilted.
    even: Vec<f64>,
}

/// The lowest of a node's eight neighbours.
#[derive(Clone, Copy, Debug, Default)]
struct Glance {
    /// By how much the second lowest is higher, m; as much as the node itself if none is lower. Rounded down.
    gap: f32,
    /// Index in the window of nine, by rows; [`UNKNOWN`] for nodes without eight neighbours, [`PIT`] if none is lower.
    lowest: u8,
}

const UNKNOWN: u8 = u8::MAX;
const PIT: u8 = 9;

impl Sweep {
    /// Empty.
    pub fn new(rule: Rule) -> Self {
        Self {
            rule,
            order: HighestFirst::default(),
            pools: Pools::default(),
            sites: Vec::new(),
            late: Vec::new(),
            queue: BinaryHeap::new(),
            inflow: Vec::new(),
            glance: Vec::new(),
            passed: Vec::new(),
            net: Vec::new(),
            left: 0.0,
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
        parallel::fill(&mut even, |i| (ground[i] / GRAIN).round() * GRAIN);
        if let Some(tilted) = tilt_flats(domain, &even) {
            even = tilted;
        }
        let ledger = self.run(domain, &even, supply, standing);
        self.even = even;
        ledger
    }

    fn run(&mut self, domain: &RasterDomain, ground: &[f64], supply: &Supply, standing: &mut [f64]) -> Ledger {
        let n = ground.len();
        self.sites.clear();
        self.sites.extend(
            ground.iter().zip(supply.depth).map(|(&ground, &water)| Site { ground, water: water.max(0.0) + 0.0 }),
        );
        self.left = 0.0;
        self.late.resize(n, 0.0);
        self.net.clear();
        self.net.resize(n, 0.0);
        self.inflow.clear();
        self.glance.resize(n, Glance::default());
        look_around(domain, ground, &mut self.glance);
        let mut ledger = Ledger { entered: supply.total, ..Ledger::default() };
        let mut held = self.take_up(domain, ground, supply.evaporation, standing, &mut ledger);
        self.pools.clear(n);
        let over = Over { domain, ground, supply };
        let mut order = std::mem::take(&mut self.order);
        for &key in order.sort(ground) {
            let i = key as u32 as usize;
            self.visit(&over, i, &mut held);
        }
        // Hollows that nothing else came to.
        let mut left: Vec<(u32, f64)> = held.into_iter().collect();
        left.sort_by_key(|h| h.0);
        for (pit, water) in left {
            // What stood there all along is no flow.
            self.net[pit as usize] -= water;
            match self.pools.at(pit as usize) {
                _ if over.is_end(pit as usize) => self.left += water,
                DRY => self.new_pool(&over, pit as usize, water),
                pool => self.send_to_pool(pool, pit as usize, water),
            }
            self.run_off(&over);
        }
        self.order = order;
        let sites = &mut self.sites;
        self.pools.ways_through(domain, &mut self.net, |i, all| sites[i].water = sites[i].water.min(-all));
        self.passed.clear();
        self.passed.extend(self.sites.iter().map(|s| s.water.abs()));
        standing.fill(0.0);
        self.pools.depths(ground, standing);
        ledger.stored = standing.iter().sum();
        ledger.left = self.left;
        ledger
    }

    /// Takes the standing water up, pool by pool: what held a hollow is kept for its lowest node, the rest of it (where the ground gave
    /// way since) runs off with the rain.
    fn take_up(
        &mut self,
        domain: &RasterDomain,
        ground: &[f64],
        evaporation: f64,
        standing: &mut [f64],
        ledger: &mut Ledger,
    ) -> HashMap<u32, f64> {
        let mut held = HashMap::new();
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
                let dried = evaporation.min(depth);
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
                self.sites[lowest].water += volume;
            }
        }
        held
    }

    /// The sweep has come to a node.
    #[inline]
    fn visit(&mut self, over: &Over, i: usize, held: &mut HashMap<u32, f64>) {
        let water = self.sites[i].water;
        self.sites[i].water = -water;
        let pool = self.pools.at(i);
        if over.is_end(i) {
            self.left += water;
        } else if pool != DRY {
            // Ground that a pool has already flooded.
            if water > 0.0 {
                let kept = self.kept(i, held);
                self.send_to_pool(pool, i, water + kept);
                self.run_off(over);
            }
        } else if water > 0.0 && !self.drops(over, i, water) {
            let lower = self.lower(over, i);
            if lower.is_empty() {
                let kept = self.kept(i, held);
                self.new_pool(over, i, water + kept);
            } else {
                self.pass_on(over, i, lower, water);
            }
            self.run_off(over);
        }
    }

    /// What stood over a pit before the round; it is no flow.
    fn kept(&mut self, pit: usize, held: &mut HashMap<u32, f64>) -> f64 {
        let kept = held.remove(&(pit as u32)).unwrap_or(0.0);
        self.net[pit] -= kept;
        kept
    }

    /// Passes water on if the lowest neighbour takes all of it.
    #[inline]
    fn drops(&mut self, over: &Over, i: usize, water: f64) -> bool {
        let Rule::Columns { depth } = self.rule else { return false };
        let Glance { gap, lowest } = self.glance[i];
        if lowest >= PIT || depth * (water / over.supply.total).sqrt() > f64::from(gap) {
            return false;
        }
        let (row, col) = (lowest as usize / 3, lowest as usize % 3);
        let to = &mut self.sites[i + row * over.domain.shape().cols + col - over.domain.shape().cols - 1];
        let takes = !to.is_passed();
        if takes {
            to.water += water;
        }
        takes
    }

    /// Lower neighbours of a node; standing water counts with its surface.
    #[inline]
    fn lower(&self, over: &Over, i: usize) -> Lower {
        let mut lower = Lower::default();
        let z = self.sites[i].ground;
        let mut look = |to: usize| {
            let site = self.sites[to];
            let mut level = site.ground;
            if level < z {
                if site.is_passed() {
                    level = self.pools.surface(over.ground, to);
                }
                if level < z {
                    lower.push(to, level);
                }
            }
        };
        over.domain.neighbours(i).for_each(|link| look(link.to));
        lower
    }

    #[inline]
    fn pass_on(&mut self, over: &Over, i: usize, mut lower: Lower, water: f64) {
        lower.share(self.rule, over.ground[i], (self.sites[i].water.abs() / over.supply.total).min(1.0));
        for (j, share) in lower.shares() {
            let amount = water * share;
            if amount == 0.0 {
                // Divided until nothing was left: it must not wake anyone.
                continue;
            }
            if !self.sites[j].is_passed() {
                self.sites[j].water += amount;
                continue;
            }
            match self.pools.at(j) {
                DRY => self.send_to_node(over, j, amount),
                pool => {
                    self.sites[j].water -= amount;
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

    fn new_pool(&mut self, over: &Over, pit: usize, amount: f64) {
        let pool = self.pools.begin(over.domain, over.ground, pit);
        self.inflow.push(0.0);
        self.send_to_pool(pool, pit, amount);
    }

    /// Fills pools and lets run on what leaves them, the highest first, until all waits for nodes that the sweep has yet to reach.
    fn run_off(&mut self, over: &Over) {
        while let Some((_, late)) = self.queue.pop() {
            match late {
                Late::Node(node) => {
                    let i = node as usize;
                    let water = std::mem::take(&mut self.late[i]);
                    self.sites[i].water -= water;
                    if over.is_end(i) {
                        self.left += water;
                        continue;
                    }
                    let pool = self.pools.at(i);
                    if pool != DRY {
                        self.send_to_pool(pool, i, water);
                        continue;
                    }
                    let lower = self.lower(over, i);
                    if lower.is_empty() {
                        self.new_pool(over, i, water);
                    } else {
                        self.pass_on(over, i, lower, water);
                    }
                }
                Late::Pool(pool) => {
                    let water = std::mem::take(&mut self.inflow[pool as usize]);
                    let pool = self.pools.root(pool);
                    if let Some((exit, more)) =
                        self.pools.pour(over.domain, over.ground, |i| over.is_end(i), pool, water)
                    {
                        if let Some(brink) = self.pools.brink(pool) {
                            self.net[brink] -= more;
                        }
                        self.leave_by(over, exit, more);
                    }
                }
            }
        }
    }

    /// Water leaves a pool by its exit.
    fn leave_by(&mut self, over: &Over, exit: usize, water: f64) {
        if !self.sites[exit].is_passed() {
            // The sweep has yet to reach the exit.
            self.sites[exit].water += water;
            return;
        }
        self.send_to_node(over, exit, water);
    }
}

/// Fills in the glance of every node.
fn look_around(domain: &RasterDomain, ground: &[f64], glance: &mut [Glance]) {
    let Shape { rows, cols } = domain.shape();
    let unknown = Glance { gap: 0.0, lowest: UNKNOWN };
    parallel::for_rows_mut(glance, cols, |row, out| {
        if row == 0 || row + 1 >= rows || cols < 3 {
            out.fill(unknown);
            return;
        }
        let three = &ground[(row - 1) * cols..(row + 2) * cols];
        for col in 1..cols - 1 {
            let at = |k: usize| three[(k / 3) * cols + col + k % 3 - 1];
            let (mut lowest, mut least, mut second) = (PIT, at(4), at(4));
            for k in [0, 1, 2, 3, 5, 6, 7, 8] {
                let z = at(k);
                // Nodata is NaN, which is never lower.
                let is_lowest = z < least;
                second = if is_lowest {
                    least
                } else if z < second {
                    z
                } else {
                    second
                };
                lowest = if is_lowest { k as u8 } else { lowest };
                least = if is_lowest { z } else { least };
            }
            out[col] = Glance { gap: ((second - least) * (1.0 - 1e-6)) as f32, lowest };
        }
        (out[0], out[cols - 1]) = (unknown, unknown);
    });
}
