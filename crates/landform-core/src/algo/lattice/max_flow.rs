//! The greatest flow through voxels, over their 26 neighbours.
//!
//! # Method
//! Blocking flows on level graphs (Dinic 1970) over edges with at least so much room, a bound that
//! is halved until it is 1 (capacity scaling, Ahuja & Orlin 1991): the widest ways fill first, so a
//! flow that stays small follows them. The graph is implicit: an edge has the capacity of the
//! narrower of its two voxels, and its flow is stored once, 26 bytes a voxel.
//!
//! # Checked by
//! `tests`: brute force over all cuts of small boxes; flow that is kept at every voxel; a minimum
//! cut found in the residual graph of random boxes.

use super::{Lattice, NEIGHBOURS};

/// Half of the neighbours: those with the higher index own their edges.
const HALF: usize = NEIGHBOURS / 2;
const UNSEEN: u32 = u32::MAX;

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
    capacity: &'a [u16],
    parts: &'a [u8],
    /// Flow to the neighbours 13 to 25 of each voxel; negative the other way.
    flow: Vec<i16>,
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
    /// **Cost** a search through the box for each blocking flow, 26 bytes a voxel and 9 while it
    /// works.
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
    pub fn between(
        lattice: &'a Lattice,
        capacity: &'a [u16],
        parts: &'a [u8],
        sources: &[usize],
        sinks: &[usize],
    ) -> Self {
        let mut flow = Self { lattice, capacity, parts, flow: vec![0; HALF * capacity.len()], value: 0 };
        let mut is_sink = vec![false; capacity.len()];
        sinks.iter().for_each(|&i| is_sink[i] = true);
        let sources: Vec<usize> = sources.iter().copied().filter(|&i| !is_sink[i]).collect();
        let most = capacity.iter().copied().max().unwrap_or(0).min(Self::MOST);
        let mut search =
            Search { level: vec![UNSEEN; capacity.len()], arc: vec![0; capacity.len()], queue: Vec::new() };
        let mut least = if most > 0 { 1 << most.ilog2() } else { 0 };
        while least > 0 {
            while search.levels(&flow, &sources, &is_sink, least) {
                for &source in &sources {
                    flow.block(source, &is_sink, least, &mut search);
                }
            }
            least /= 2;
        }
        flow
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
        if k >= HALF {
            i32::from(self.flow[HALF * i + k - HALF])
        } else {
            -i32::from(self.flow[HALF * self.lattice.neighbour(i, k) + HALF - 1 - k])
        }
    }

    /// What could still flow to a neighbour.
    #[inline]
    fn room(&self, i: usize, k: usize) -> i32 {
        let to = self.lattice.neighbour(i, k);
        let capacity = self.capacity[i].min(self.capacity[to]);
        if capacity == 0 || self.parts[i] != self.parts[to] { 0 } else { i32::from(capacity) - self.to(i, k) }
    }

    #[inline]
    fn push(&mut self, i: usize, k: usize, amount: i32) {
        if k >= HALF {
            self.flow[HALF * i + k - HALF] += amount as i16;
        } else {
            self.flow[HALF * self.lattice.neighbour(i, k) + HALF - 1 - k] -= amount as i16;
        }
    }

    /// Fills ways from a source down the levels until none is left.
    fn block(&mut self, source: usize, is_sink: &[bool], least: i32, search: &mut Search) {
        let (mut way, mut at): (Vec<(usize, usize)>, usize) = (Vec::new(), source);
        loop {
            if is_sink[at] {
                let room = way.iter().map(|&(i, k)| self.room(i, k)).min().unwrap_or(0);
                way.iter().for_each(|&(i, k)| self.push(i, k, room));
                self.value += room as u64;
                // On from the first edge that is full now.
                let full = way.iter().position(|&(i, k)| self.room(i, k) < least).unwrap_or(0);
                at = way.get(full).map_or(source, |step| step.0);
                way.truncate(full);
                continue;
            }
            let next = (usize::from(search.arc[at])..NEIGHBOURS).find(|&k| {
                let to = self.lattice.neighbour(at, k);
                search.level[to] == search.level[at] + 1 && self.room(at, k) >= least
            });
            match next {
                Some(k) => {
                    search.arc[at] = k as u8;
                    way.push((at, k));
                    at = self.lattice.neighbour(at, k);
                }
                None => {
                    search.arc[at] = NEIGHBOURS as u8;
                    let Some((before, _)) = way.pop() else { return };
                    search.arc[before] += 1;
                    at = before;
                }
            }
        }
    }
}

/// Steps from the sources, and which neighbour of each voxel is next.
struct Search {
    level: Vec<u32>,
    arc: Vec<u8>,
    queue: Vec<u32>,
}

impl Search {
    /// Counts steps over edges with room until a sink is met; whether one was.
    fn levels(&mut self, flow: &MaxFlow, sources: &[usize], is_sink: &[bool], least: i32) -> bool {
        self.level.fill(UNSEEN);
        self.arc.fill(0);
        self.queue.clear();
        for &source in sources {
            self.level[source] = 0;
            self.queue.push(source as u32);
        }
        let (mut first, mut last_level) = (0, UNSEEN);
        while let Some(&i) = self.queue.get(first) {
            let i = i as usize;
            first += 1;
            // Voxels as far as the nearest sink need not be passed.
            if self.level[i] >= last_level {
                break;
            }
            for k in 0..NEIGHBOURS {
                let to = flow.lattice.neighbour(i, k);
                if flow.capacity[to] > 0 && self.level[to] == UNSEEN && flow.room(i, k) >= least {
                    self.level[to] = self.level[i] + 1;
                    self.queue.push(to as u32);
                    if is_sink[to] {
                        last_level = self.level[to];
                    }
                }
            }
        }
        last_level != UNSEEN
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
            assert!(lattice.voxels().all(|i| (0..NEIGHBOURS).all(|k| flow.room(i, k) >= 0)));
            // What can still be reached from the sources is one side of a least cut.
            let mut search =
                Search { level: vec![UNSEEN; capacity.len()], arc: vec![0; capacity.len()], queue: Vec::new() };
            assert!(!search.levels(&flow, &sources, &vec![false; capacity.len()], 1));
            let mut cut = 0;
            for i in lattice.voxels().filter(|&i| search.level[i] != UNSEEN) {
                assert!(!sinks.contains(&i));
                let over = lattice.neighbours(i).filter(|&to| lattice.is_inside(to) && search.level[to] == UNSEEN);
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
