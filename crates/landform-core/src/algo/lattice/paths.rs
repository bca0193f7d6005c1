//! Shortest paths over the 26 neighbours of voxels, by whole numbers.
//!
//! # Method
//! Dijkstra with buckets (Dial 1969) whose width is not above the least cost of a step where that
//! is not too narrow; a voxel that is lowered again within its bucket goes on from there, so that
//! the result is exact for any width. Costs and values are whole numbers: sums have no rounding,
//! and the least over all paths does not depend on the order of visits.
//!
//! # Checked by
//! `tests`: equality with Bellman and Ford's sweeps; values that were lowered in part; mirror
//! images.

use super::{Lattice, NEIGHBOURS};

/// Most buckets in the ring, as a power of two.
const RING: u32 = 12;
/// Narrowest bucket, as a power of two: 2^32 values in at most 2^22 of them.
const NARROWEST: u32 = 10;

/// Lowers values until none exceeds a neighbour's by more than the cost of the step from there:
/// `v(N) ≤ v(S) + slope(S) · distance(S, N)`. Only voxels that can be reached from `seeds` are
/// looked at; whatever was lowered or whose slope fell since the last call must be among them.
/// Values, and slopes a metre, are stored as [`Lattice`] says; a border of zeros keeps paths
/// inside.
/// A step costs at least 1. Returns how many times a voxel was passed on from.
///
/// **Cost** O(voxels that change), about 0.1 µs each.
///
/// ```
/// use landform_core::algo::lattice::{Lattice, lower};
///
/// let lattice = Lattice::new([5, 1, 1], [1.0; 3]);
/// let mut values = lattice.padded([0, 100, 100, 100, 100].into_iter(), 0);
/// lower(&lattice, &mut values, &vec![10.0; lattice.stored()], &[lattice.at([0, 0, 0])]);
/// assert_eq!(lattice.unpadded(&values), [0, 10, 20, 30, 40]);
/// ```
pub fn lower(lattice: &Lattice, values: &mut [u32], slopes: &[f32], seeds: &[usize]) -> usize {
    let mut seeds: Vec<(u32, u32)> = seeds.iter().map(|&i| (values[i], i as u32)).collect();
    seeds.sort_unstable();
    seeds.dedup();
    let Some(&(first, _)) = seeds.first() else { return 0 };
    let lengths = Lengths::of(lattice);
    let mut queue = Queue::new(width(slopes, &lengths), first);
    let (mut next, mut passed) = (0, 0);
    loop {
        while next < seeds.len() && queue.key(seeds[next].0) <= queue.now {
            queue.push(seeds[next]);
            next += 1;
        }
        let Some((value, i)) = queue.pop() else {
            // Nothing is waiting: on to the next seed.
            match seeds.get(next) {
                Some(seed) => queue.now = queue.key(seed.0),
                None => return passed,
            }
            continue;
        };
        let i = i as usize;
        if values[i] != value {
            continue;
        }
        passed += 1;
        let costs = lengths.different.map(|length| ((slopes[i] * length) as u32).max(1));
        for k in 0..NEIGHBOURS {
            let (to, new) = (lattice.neighbour(i, k), value.saturating_add(costs[usize::from(lengths.class[k])]));
            if new < values[to] {
                values[to] = new;
                queue.push((new, to as u32));
            }
        }
    }
}

/// The lengths of steps: seven at most.
struct Lengths {
    different: [f32; 7],
    class: [u8; NEIGHBOURS],
}

impl Lengths {
    fn of(lattice: &Lattice) -> Self {
        let mut lengths = Self { different: [0.0; 7], class: [0; NEIGHBOURS] };
        for k in 0..NEIGHBOURS {
            let axes = lattice.step(k).map(|s| usize::from(s != 0));
            lengths.class[k] = (axes[0] + 2 * axes[1] + 4 * axes[2] - 1) as u8;
            lengths.different[usize::from(lengths.class[k])] = lattice.length(k) as f32;
        }
        lengths
    }
}

/// The width of a bucket, as a power of two.
fn width(slopes: &[f32], lengths: &Lengths) -> u32 {
    let range = |(low, high): (f32, f32), s: &f32| if *s > 0.0 { (low.min(*s), high.max(*s)) } else { (low, high) };
    let (least, most) = slopes.iter().fold((f32::INFINITY, 0.0), range);
    let shortest = lengths.different.iter().fold(f32::INFINITY, |a, b| a.min(*b));
    let longest = lengths.different.iter().fold(0.0_f32, |a, b| a.max(*b));
    let log = |v: f32| (v as u32).max(1).ilog2();
    let fits = (log(most * longest) + 2).saturating_sub(RING);
    log((least * shortest).min(u32::MAX as f32)).max(fits).max(NARROWEST)
}

/// A ring of buckets.
struct Queue {
    width: u32,
    now: u32,
    waiting: usize,
    ring: Vec<Vec<(u32, u32)>>,
}

impl Queue {
    fn new(width: u32, first: u32) -> Self {
        Self { width, now: first >> width, waiting: 0, ring: vec![Vec::new(); 1 << RING] }
    }

    fn key(&self, value: u32) -> u32 {
        value >> self.width
    }

    #[inline]
    fn push(&mut self, entry: (u32, u32)) {
        let slot = (entry.0 >> self.width) as usize & ((1 << RING) - 1);
        self.ring[slot].push(entry);
        self.waiting += 1;
    }

    /// The next of the current bucket, or of the first after it that has one; none if all are
    /// empty. It stops before another bucket so that seeds can enter it.
    fn pop(&mut self) -> Option<(u32, u32)> {
        while self.waiting > 0 {
            if let Some(entry) = self.ring[self.now as usize & ((1 << RING) - 1)].pop() {
                self.waiting -= 1;
                return Some(entry);
            }
            self.now += 1;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Seed;

    /// Bellman and Ford: sweeps until nothing changes.
    fn sweeps(lattice: &Lattice, values: &mut [u32], slopes: &[f32]) {
        loop {
            let mut changed = false;
            for i in lattice.voxels() {
                for k in 0..NEIGHBOURS {
                    let cost = ((slopes[i] * lattice.length(k) as f32) as u32).max(1);
                    let (to, new) = (lattice.neighbour(i, k), values[i].saturating_add(cost));
                    if new < values[to] {
                        (values[to], changed) = (new, true);
                    }
                }
            }
            if !changed {
                return;
            }
        }
    }

    fn random(lattice: &Lattice, seed: u64) -> (Vec<u32>, Vec<f32>) {
        let draw = |k: u64, i: usize| Seed(seed).with(k).uniform(i as u64);
        let (n, unit) = (lattice.size().iter().product::<usize>(), f64::from(1 << 24));
        let slopes = (0..n).map(|i| (unit * if draw(1, i) < 0.1 { 0.001 } else { 0.05 + draw(2, i) }) as f32);
        let values = (0..n).map(|i| (unit * (0.5 + 0.5 * draw(3, i))) as u32);
        (lattice.padded(values, 0), lattice.padded(slopes, 0.0))
    }

    #[test]
    fn values_are_those_of_bellman_and_ford() {
        for seed in 0..6 {
            let lattice = Lattice::new([9, 7, 6], [1.0, 1.5, 0.5]);
            let (mut values, slopes) = random(&lattice, seed);
            let low = lattice.at([4, 3, 2]);
            values[low] = 0;
            let (start, mut expected) = (values.clone(), values.clone());
            sweeps(&lattice, &mut expected, &slopes);
            let all: Vec<usize> = lattice.voxels().collect();
            lower(&lattice, &mut values, &slopes, &all);
            assert!(values == expected);
            assert!(values.iter().zip(&start).all(|(a, b)| a <= b), "it only lowers");
            let mut parts = start;
            // From one voxel alone, then from the others.
            lower(&lattice, &mut parts, &slopes, &[low]);
            lower(&lattice, &mut parts, &slopes, &all);
            assert!(parts == expected);
        }
    }

    #[test]
    fn what_fell_is_marched_again_from_where_it_fell() {
        let lattice = Lattice::new([12, 9, 5], [1.0; 3]);
        let (mut values, mut slopes) = random(&lattice, 9);
        let all: Vec<usize> = lattice.voxels().collect();
        values[lattice.at([0, 4, 2])] = 0;
        lower(&lattice, &mut values, &slopes, &all);
        for step in 0..8 {
            let changed: Vec<usize> = (0..3).map(|k| lattice.at([step + k, 4, 2])).collect();
            changed.iter().for_each(|&i| slopes[i] = 16_777.0);
            let mut whole = values.clone();
            let passed = lower(&lattice, &mut values, &slopes, &changed);
            sweeps(&lattice, &mut whole, &slopes);
            assert!(values == whole && passed < 540);
        }
        assert_eq!(lower(&lattice, &mut values, &slopes, &[]), 0);
    }

    #[test]
    fn a_mirror_image_has_the_mirrored_values() {
        let lattice = Lattice::new([8, 6, 5], [1.0, 2.0, 1.0]);
        let (values, slopes) = random(&lattice, 4);
        let mirror = |i: usize| {
            let [x, y, z] = lattice.place(i);
            lattice.at([7 - x, y, z])
        };
        let all: Vec<usize> = lattice.voxels().collect();
        let (mut one, mut other, mut mirrored) = (values.clone(), values.clone(), slopes.clone());
        for &i in &all {
            (other[mirror(i)], mirrored[mirror(i)]) = (values[i], slopes[i]);
        }
        lower(&lattice, &mut one, &slopes, &all);
        lower(&lattice, &mut other, &mirrored, &all);
        assert!(all.iter().all(|&i| one[i] == other[mirror(i)]));
    }
}
