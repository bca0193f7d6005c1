//! The greatest flow through voxels, over their 26 neighbours.
//!
//! # Method
//! Highest-label push-relabel with heights found anew now and then, and gaps (Goldberg & Tarjan
//! 1988; Cherkassky & Goldberg 1997): water that cannot reach a sink goes back to the sources at
//! the end. Where the widest ways are to fill first, only whole multiples of a unit flow, which
//! begins at the greatest capacity and falls to 1 (capacity scaling, Ahuja & Orlin 1991); a flow
//! that stays small follows wide ways then. The graph is implicit: an edge has the capacity of the
//! narrower of its two voxels, and only the room that is left in it is stored, 52 bytes a voxel.
//!
//! # Checked by
//! `tests`: brute force over all cuts of small boxes; flow that is kept at every voxel; a minimum
//! cut found in the residual graph of random boxes.

use super::{Lattice, NEIGHBOURS};

/// By which power of two the unit falls from round to round.
const FALL: u32 = 2;
/// The height of voxels from which no way is left.
const CUT_OFF: u32 = u32::MAX;

/// A greatest flow from sources to sinks.
///
/// ```
/// use landform_core::algo::lattice::{Lattice, MaxFlow};
///
/// let pair = Lattice::new([2, 1, 1], [1.0; 3]);
/// let (capacity, parts) = (pair.padded([7, 4].into_iter(), 0), vec![0; pair.stored()]);
/// let flow = MaxFlow::between(&pair, &capacity, &parts, &[pair.at([0; 3])], &[pair.at([1, 0, 0])]);
/// assert_eq!(flow.value(), 4);
/// ```
#[derive(Clone, Debug)]
pub struct MaxFlow<'a> {
    lattice: &'a Lattice,
    /// What could still flow to each neighbour.
    room: Vec<[u16; NEIGHBOURS]>,
    value: u64,
}

impl<'a> MaxFlow<'a> {
    /// Greatest capacity of a voxel.
    ///
    /// ```
    /// use landform_core::algo::lattice::MaxFlow;
    ///
    /// assert_eq!(MaxFlow::MOST, 16_383);
    /// ```
    pub const MOST: u16 = 16_383;

    /// The greatest flow from any of `sources` to any of `sinks`, voxels without bounds of their
    /// own. `capacity` (at most [`MaxFlow::MOST`]; 0 in the border) and `parts` are stored as
    /// [`Lattice`] says; nothing flows between voxels of different parts.
    ///
    /// **Cost** mostly O(voxels), at worst the square of their number times its root; 52 bytes a
    /// voxel and 11 while it works.
    ///
    /// ```
    /// use landform_core::algo::lattice::{Lattice, MaxFlow};
    ///
    /// let lattice = Lattice::new([3, 2, 1], [1.0; 3]);
    /// let capacity = lattice.padded([9, 3, 9, 9, 5, 9].into_iter(), 0);
    /// let parts = vec![0; lattice.stored()];
    /// let (west, east) = ([0, 1].map(|y| lattice.at([0, y, 0])), [0, 1].map(|y| lattice.at([2, y, 0])));
    /// let flow = MaxFlow::between(&lattice, &capacity, &parts, &west, &east);
    /// // Each of the voxels in the middle has an edge to both of the west and both of the east.
    /// assert_eq!(flow.value(), 2 * 3 + 2 * 5);
    /// ```
    pub fn between(lattice: &'a Lattice, capacity: &[u16], parts: &[u8], sources: &[usize], sinks: &[usize]) -> Self {
        Self::in_rounds(Self::unmoved(lattice, capacity, parts), sources, sinks, 0)
    }

    /// The same flow, of which as much as can takes wide ways. It costs up to three times as much.
    ///
    /// ```
    /// use landform_core::algo::lattice::{Lattice, MaxFlow};
    ///
    /// // Around an obstacle there is a narrow way in the north and a wide one in the south.
    /// let lattice = Lattice::new([3, 3, 1], [1.0; 3]);
    /// let capacity = lattice.padded([9, 3, 9, 9, 0, 9, 9, 9, 9].into_iter(), 0);
    /// let (parts, ends) = (vec![0; lattice.stored()], [[0, 1, 0], [2, 1, 0]].map(|place| lattice.at(place)));
    /// let flow = MaxFlow::widest_first(&lattice, &capacity, &parts, &ends[..1], &ends[1..]);
    /// assert_eq!(flow.value(), 2 * 3 + 2 * 9);
    /// ```
    pub fn widest_first(
        lattice: &'a Lattice,
        capacity: &[u16],
        parts: &[u8],
        sources: &[usize],
        sinks: &[usize],
    ) -> Self {
        let most = capacity.iter().copied().max().unwrap_or(0).min(Self::MOST);
        Self::in_rounds(Self::unmoved(lattice, capacity, parts), sources, sinks, most.max(1).ilog2())
    }

    fn unmoved(lattice: &'a Lattice, capacity: &[u16], parts: &[u8]) -> Self {
        let room = |i: usize, k: usize| {
            let to = lattice.neighbour(i, k);
            if parts[i] == parts[to] { capacity[i].min(capacity[to]).min(Self::MOST) } else { 0 }
        };
        let mut rooms = vec![[0; NEIGHBOURS]; capacity.len()];
        lattice.voxels().for_each(|i| rooms[i] = std::array::from_fn(|k| room(i, k)));
        Self { lattice, room: rooms, value: 0 }
    }

    /// Rounds with units from a power of two down to 1.
    fn in_rounds(mut self, sources: &[usize], sinks: &[usize], mut power: u32) -> Self {
        let mut push = Push::new(self.room.len(), sources, sinks);
        loop {
            push.round(&mut self, 1 << power);
            if power == 0 {
                self.value = push.arrived;
                return self;
            }
            power = power.saturating_sub(FALL);
        }
    }

    /// The flow from all sources together.
    ///
    /// ```
    /// use landform_core::algo::lattice::{Lattice, MaxFlow};
    ///
    /// let row = Lattice::new([3, 1, 1], [1.0; 3]);
    /// let (capacity, parts) = (row.padded([5, 2, 5].into_iter(), 0), vec![0; row.stored()]);
    /// let [west, east] = [0, 2].map(|x| row.at([x, 0, 0]));
    /// let flow = MaxFlow::between(&row, &capacity, &parts, &[west], &[east]);
    /// assert_eq!(flow.value(), 2);
    /// ```
    pub fn value(&self) -> u64 {
        self.value
    }

    /// The flow from a voxel to its neighbour of a number; negative if it comes from there.
    ///
    /// ```
    /// use landform_core::algo::lattice::{Lattice, MaxFlow};
    ///
    /// let row = Lattice::new([3, 1, 1], [1.0; 3]);
    /// let (capacity, parts) = (row.padded([5, 2, 5].into_iter(), 0), vec![0; row.stored()]);
    /// let [west, east] = [0, 2].map(|x| row.at([x, 0, 0]));
    /// let flow = MaxFlow::between(&row, &capacity, &parts, &[west], &[east]);
    /// // The neighbour in the east is number 13.
    /// assert_eq!((flow.to(west, 13), flow.to(east, 12)), (2, -2));
    /// ```
    #[inline]
    pub fn to(&self, i: usize, k: usize) -> i32 {
        // Room grew on the other side by what fell on this.
        let back = self.room[self.lattice.neighbour(i, k)][NEIGHBOURS - 1 - k];
        (i32::from(back) - i32::from(self.room[i][k])) / 2
    }
}

/// What a voxel is to water on its way.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Way,
    Source,
    Sink,
}

/// Water on its way from sources to sinks.
struct Push {
    role: Vec<Role>,
    sources: Vec<u32>,
    sinks: Vec<u32>,
    arrived: u64,
    /// Water that waits in each voxel between the ends.
    waiting: Vec<u32>,
    /// Steps to where the water is to go, at least.
    height: Vec<u32>,
    /// The neighbour that is next, of each voxel.
    next: Vec<u8>,
    /// Voxels with water that waits, by height; some may have moved since.
    at_height: Vec<Vec<u32>>,
    /// How many voxels have each height.
    count: Vec<u32>,
    queue: Vec<u32>,
}

impl Push {
    fn new(n: usize, sources: &[usize], sinks: &[usize]) -> Self {
        let mut role = vec![Role::Way; n];
        sources.iter().for_each(|&i| role[i] = Role::Source);
        sinks.iter().for_each(|&i| role[i] = Role::Sink);
        let all = |wanted| (0..n).filter(|&i| role[i] == wanted).map(|i| i as u32).collect();
        Self {
            sources: all(Role::Source),
            sinks: all(Role::Sink),
            role,
            arrived: 0,
            waiting: vec![0; n],
            height: vec![CUT_OFF; n],
            next: vec![0; n],
            at_height: Vec::new(),
            count: Vec::new(),
            queue: Vec::new(),
        }
    }

    /// Sends as many whole units as find a way.
    fn round(&mut self, flow: &mut MaxFlow, unit: u16) {
        self.heights(flow, unit, Role::Sink);
        for s in 0..self.sources.len() {
            let source = self.sources[s] as usize;
            for k in 0..NEIGHBOURS {
                let (to, amount) = (flow.lattice.neighbour(source, k), flow.room[source][k] & unit.wrapping_neg());
                if amount > 0 && self.role[to] != Role::Source && self.height[to] != CUT_OFF {
                    self.pass(flow, source, k, amount.into());
                }
            }
        }
        self.flow_down(flow, unit, Role::Sink);
        self.heights(flow, unit, Role::Source);
        self.flow_down(flow, unit, Role::Source);
    }

    /// Moves water to a neighbour.
    #[inline]
    fn pass(&mut self, flow: &mut MaxFlow, from: usize, k: usize, amount: u32) {
        let to = flow.lattice.neighbour(from, k);
        flow.room[from][k] -= amount as u16;
        flow.room[to][NEIGHBOURS - 1 - k] += amount as u16;
        match self.role[to] {
            Role::Way => {
                if self.waiting[to] == 0 {
                    self.at_height[self.height[to] as usize].push(to as u32);
                }
                self.waiting[to] += amount;
            }
            Role::Sink => self.arrived += u64::from(amount),
            Role::Source => {}
        }
    }

    /// Heights are steps to the nearest of the ends, over edges with room. Nothing passes the other
    /// ends.
    fn heights(&mut self, flow: &MaxFlow, unit: u16, ends: Role) {
        self.height.fill(CUT_OFF);
        self.next.fill(0);
        self.at_height.iter_mut().for_each(Vec::clear);
        self.count.fill(0);
        self.queue.clear();
        self.queue.extend(if ends == Role::Sink { &self.sinks } else { &self.sources });
        self.queue.iter().for_each(|&i| self.height[i as usize] = 0);
        let mut first = 0;
        while let Some(&i) = self.queue.get(first) {
            first += 1;
            let i = i as usize;
            self.reach(self.height[i]);
            self.count[self.height[i] as usize] += 1;
            if self.waiting[i] > 0 {
                self.at_height[self.height[i] as usize].push(i as u32);
            }
            for k in 0..NEIGHBOURS {
                let from = flow.lattice.neighbour(i, k);
                if self.height[from] == CUT_OFF
                    && self.role[from] == Role::Way
                    && flow.room[from][NEIGHBOURS - 1 - k] >= unit
                {
                    self.height[from] = self.height[i] + 1;
                    self.queue.push(from as u32);
                }
            }
        }
    }

    /// Makes place for a height.
    fn reach(&mut self, height: u32) {
        let wanted = (height as usize + 1).max(self.count.len());
        self.count.resize(wanted, 0);
        self.at_height.resize(wanted, Vec::new());
    }

    /// Lets the highest water flow down until none is left that can.
    fn flow_down(&mut self, flow: &mut MaxFlow, unit: u16, ends: Role) {
        // Heights are found anew after that many voxels were lifted.
        let often = (self.queue.len() / 2).max(16);
        let (mut lifted, mut top) = (0, self.at_height.len());
        while top > 0 {
            let Some(i) = self.at_height[top - 1].pop() else {
                top -= 1;
                continue;
            };
            let i = i as usize;
            while self.waiting[i] > 0 && self.height[i] != CUT_OFF {
                top = top.max(self.height[i] as usize);
                self.empty(flow, unit, i);
                if self.waiting[i] > 0 {
                    self.lift(flow, unit, i);
                    lifted += 1;
                }
            }
            if lifted > often {
                self.heights(flow, unit, ends);
                (lifted, top) = (0, self.at_height.len());
            }
        }
    }

    /// Moves water to lower neighbours while some waits.
    fn empty(&mut self, flow: &mut MaxFlow, unit: u16, i: usize) {
        for k in usize::from(self.next[i])..NEIGHBOURS {
            self.next[i] = k as u8;
            let to = flow.lattice.neighbour(i, k);
            if self.height[to].wrapping_add(1) == self.height[i] {
                let amount = u32::from(flow.room[i][k] & unit.wrapping_neg()).min(self.waiting[i]);
                if amount > 0 {
                    self.waiting[i] -= amount;
                    self.pass(flow, i, k, amount);
                    if self.waiting[i] == 0 {
                        return;
                    }
                }
            }
        }
    }

    /// Lifts a voxel over its lowest neighbour with room. Where a height is left by its last voxel,
    /// nothing above it leads down any more.
    fn lift(&mut self, flow: &MaxFlow, unit: u16, i: usize) {
        let old = self.height[i] as usize;
        let open = (0..NEIGHBOURS).filter(|&k| flow.room[i][k] >= unit);
        let lowest = open.map(|k| (self.height[flow.lattice.neighbour(i, k)], k)).min();
        self.count[old] -= 1;
        if self.count[old] == 0 {
            self.height.iter_mut().filter(|h| **h != CUT_OFF && **h as usize >= old).for_each(|h| *h = CUT_OFF);
            self.count[old..].fill(0);
            self.at_height[old..].iter_mut().for_each(Vec::clear);
            return;
        }
        self.height[i] = CUT_OFF;
        if let Some((below, k)) = lowest.filter(|l| l.0 != CUT_OFF) {
            self.height[i] = below + 1;
            self.next[i] = k as u8;
            self.reach(below + 1);
            self.count[below as usize + 1] += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Seed;

    /// The least cut of a small box, over all ways to part its voxels.
    fn least_cut(lattice: &Lattice, capacity: &[u16], source: usize, sink: usize) -> u64 {
        let all: Vec<usize> = lattice.voxels().collect();
        let cut = |side: u32| {
            let with_source = |i: usize| all.iter().position(|v| *v == i).is_some_and(|n| side >> n & 1 == 1);
            let edges = all.iter().flat_map(|&i| lattice.neighbours(i).map(move |to| (i, to)));
            let over = edges.filter(|&(i, to)| lattice.is_inside(to) && with_source(i) && !with_source(to));
            over.map(|(i, to)| u64::from(capacity[i].min(capacity[to]))).sum::<u64>()
        };
        let number = |i: usize| all.iter().position(|v| *v == i).unwrap();
        let parts = |side: &u32| side >> number(source) & 1 == 1 && side >> number(sink) & 1 == 0;
        (0..1_u32 << all.len()).filter(parts).map(cut).min().unwrap()
    }

    #[test]
    fn the_flow_is_the_least_cut_of_small_boxes() {
        for (seed, size) in (0..24).zip([[4, 3, 1], [3, 2, 2], [6, 2, 1], [2, 3, 2]].into_iter().cycle()) {
            let lattice = Lattice::new(size, [1.0; 3]);
            let draw = |i: usize| Seed(seed).uniform(i as u64);
            let capacity =
                lattice.padded((0..12).map(|i| if draw(i) < 0.2 { 0 } else { (draw(i + 50) * 40.0) as u16 }), 0);
            let (source, sink) = (lattice.at([0; 3]), lattice.at(size.map(|n| n - 1)));
            let parts = vec![0; capacity.len()];
            let flow = MaxFlow::between(&lattice, &capacity, &parts, &[source], &[sink]);
            assert_eq!(flow.value(), least_cut(&lattice, &capacity, source, sink), "{seed}");
        }
    }

    #[test]
    fn water_is_kept_and_a_cut_of_the_same_value_is_full() {
        for seed in 0..20 {
            let lattice = Lattice::new([11, 9, 7], [1.0; 3]);
            let draw = |i: usize| Seed(seed).named("capacity").uniform(i as u64);
            let capacity = lattice.padded((0..693).map(|i| (draw(i) * draw(i) * 900.0) as u16), 0);
            let parts = vec![0; capacity.len()];
            let sources = [lattice.at([0, 4, 3]), lattice.at([1, 4, 3])];
            let sinks: Vec<usize> = lattice.voxels().filter(|&i| lattice.place(i)[0] == 10).collect();
            let flow = MaxFlow::between(&lattice, &capacity, &parts, &sources, &sinks);
            let net = |i: usize| (0..NEIGHBOURS).map(|k| i64::from(flow.to(i, k))).sum::<i64>();
            for i in lattice.voxels().filter(|i| !sources.contains(i) && !sinks.contains(i)) {
                assert_eq!(net(i), 0);
            }
            assert_eq!(sources.iter().map(|&i| net(i)).sum::<i64>(), flow.value() as i64);
            let most = |i: usize, k: usize| i32::from(capacity[i].min(capacity[lattice.neighbour(i, k)]));
            assert!(lattice.voxels().all(|i| (0..NEIGHBOURS).all(|k| flow.to(i, k) <= most(i, k))));
            // What can still be reached from the sources is one side of a least cut.
            let mut reached = vec![false; capacity.len()];
            let mut queue = sources.to_vec();
            sources.iter().for_each(|&i| reached[i] = true);
            while let Some(i) = queue.pop() {
                for k in (0..NEIGHBOURS).filter(|&k| flow.room[i][k] > 0) {
                    let to = lattice.neighbour(i, k);
                    if !std::mem::replace(&mut reached[to], true) {
                        queue.push(to);
                    }
                }
            }
            let mut cut = 0;
            for i in lattice.voxels().filter(|&i| reached[i]) {
                assert!(!sinks.contains(&i));
                let over = lattice.neighbours(i).filter(|&to| lattice.is_inside(to) && !reached[to]);
                cut += over.map(|to| u64::from(capacity[i].min(capacity[to]))).sum::<u64>();
            }
            assert_eq!(cut, flow.value(), "{seed}");
        }
    }

    #[test]
    fn nothing_flows_from_part_to_part_or_without_room() {
        let lattice = Lattice::new([4, 4, 1], [1.0; 3]);
        let capacity = lattice.padded((0..16).map(|_| 10), 0);
        let parts = lattice.padded((0..16).map(|i| u8::from(i % 4 > 1)), 9);
        let ends = ([lattice.at([0, 0, 0])], [lattice.at([3, 3, 0])]);
        assert_eq!(MaxFlow::between(&lattice, &capacity, &parts, &ends.0, &ends.1).value(), 0);
        let same = vec![0; capacity.len()];
        assert_eq!(MaxFlow::between(&lattice, &capacity, &same, &ends.0, &ends.1).value(), 30);
        assert_eq!(MaxFlow::between(&lattice, &vec![0; capacity.len()], &same, &ends.0, &ends.1).value(), 0);
        assert_eq!(MaxFlow::between(&lattice, &capacity, &same, &ends.0, &ends.0).value(), 0);
    }
}
