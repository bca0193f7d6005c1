//! Thinning: voxels are taken from the outside until a line, or a sheet, is left.
//!
//! # Method
//! Palágyi et al. (2001): rounds of six sub-iterations, one for each way a face can look. A voxel
//! goes if its neighbour that way is empty, if it is simple, and if it is not the end of a curve.
//! Each candidate is tested again when its turn comes. It is simple if its neighbours in the set
//! are one piece (26) and the empty ones over its faces are one piece among its 18 neighbours (6)
//! (Bertrand & Malandain 1994; equivalent to Saha & Chaudhuri 1994).
//!
//! # Checked by
//! `tests`: Euler's number, pieces, tunnels and cavities on balls, rings and random sets; square
//! bars; that nothing is left to take, and that thinning again changes nothing.

use super::{Lattice, NEIGHBOURS};

/// What thinning leaves.
///
/// ```
/// use landform_core::algo::lattice::{Lattice, Thinning, thin};
///
/// let lattice = Lattice::new([9, 3, 3], [1.0; 3]);
/// let mut bar = lattice.padded((0..81).map(|_| true), false);
/// thin(&lattice, &mut bar, Thinning::Line);
/// assert_eq!(bar.iter().filter(|b| **b).count(), 9, "one voxel a slice");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Thinning {
    /// The line along the middle.
    Line,
    /// The sheet between roofs and floors: voxels are taken from above and below alone, where
    /// there is another under or over them.
    Sheet,
}

/// Neighbours over faces: up, down, along +y, −y, +x, −x.
const FACES: [usize; 6] = [21, 4, 15, 10, 13, 12];

/// Thins a set of voxels, stored as [`Lattice`] says with a border of `false`. Its pieces, tunnels
/// and cavities are kept. Returns how many voxels went.
///
/// **Cost** O(voxels) and about 0.2 µs for each voxel that goes.
///
/// ```
/// use landform_core::algo::lattice::{Lattice, Thinning, thin, topology};
///
/// let lattice = Lattice::new([7, 7, 3], [1.0; 3]);
/// // A thick ring.
/// let ring = |i: usize| !(3..4).contains(&(i % 7)) || !(3..4).contains(&(i / 7 % 7));
/// let mut set = lattice.padded((0..147).map(ring), false);
/// let before = topology(&lattice, &set);
/// thin(&lattice, &mut set, Thinning::Line);
/// assert_eq!(topology(&lattice, &set), before);
/// ```
pub fn thin(lattice: &Lattice, set: &mut [bool], what: Thinning) -> usize {
    let test = Simple::new();
    let faces = if what == Thinning::Line { &FACES[..] } else { &FACES[..2] };
    let is_border = |set: &[bool], i: usize| faces.iter().any(|&k| !set[lattice.neighbour(i, k)]);
    let mut border: Vec<u32> = lattice.voxels().filter(|&i| set[i] && is_border(set, i)).map(|i| i as u32).collect();
    let mut listed = vec![false; set.len()];
    border.iter().for_each(|&i| listed[i as usize] = true);
    let goes = |set: &[bool], i: usize, face: usize| {
        if set[lattice.neighbour(i, face)] {
            return false;
        }
        let around = around(lattice, set, i);
        let is_kept = match what {
            Thinning::Line => around.count_ones() == 1,
            // A sheet of one voxel is thin enough, at its rim too.
            Thinning::Sheet => !set[lattice.neighbour(i, NEIGHBOURS - 1 - face)],
        };
        !is_kept && test.is_simple(around)
    };
    let (mut gone, mut candidates) = (0, Vec::new());
    loop {
        let before = gone;
        for &face in faces {
            candidates.clear();
            candidates.extend(border.iter().copied().filter(|&i| set[i as usize] && goes(set, i as usize, face)));
            for &i in &candidates {
                let i = i as usize;
                if !goes(set, i, face) {
                    continue;
                }
                set[i] = false;
                gone += 1;
                for &k in faces {
                    let next = lattice.neighbour(i, k);
                    if set[next] && !std::mem::replace(&mut listed[next], true) {
                        border.push(next as u32);
                    }
                }
            }
        }
        if gone == before {
            return gone;
        }
        border.retain(|&i| set[i as usize]);
        border.sort_unstable();
    }
}

/// Which neighbours are in the set, a bit each.
fn around(lattice: &Lattice, set: &[bool], i: usize) -> u32 {
    (0..NEIGHBOURS).fold(0, |bits, k| bits | u32::from(set[lattice.neighbour(i, k)]) << k)
}

/// Neighbourhoods within the 26 neighbours of a voxel.
struct Simple {
    /// Those that touch each of the 26, at a corner too.
    touching: [u32; NEIGHBOURS],
    /// Those of the 18 that share a face with each.
    over_face: [u32; NEIGHBOURS],
    faces: u32,
    eighteen: u32,
}

impl Simple {
    fn new() -> Self {
        let lattice = Lattice::new([1; 3], [1.0; 3]);
        let apart = |a: usize, b: usize| {
            let (a, b) = (lattice.step(a), lattice.step(b));
            [0, 1, 2].map(|k| (a[k] - b[k]).abs())
        };
        let bits = |is_in: &dyn Fn(usize) -> bool| (0..NEIGHBOURS).filter(|&k| is_in(k)).fold(0, |b, k| b | 1 << k);
        let axes = |k: usize| lattice.step(k).iter().filter(|s| **s != 0).count();
        let eighteen = bits(&|k| axes(k) < 3);
        Self {
            touching: std::array::from_fn(|a| bits(&|b| a != b && apart(a, b).iter().all(|d| *d <= 1))),
            over_face: std::array::from_fn(|a| bits(&|b| apart(a, b).iter().sum::<i8>() == 1) & eighteen),
            faces: bits(&|k| axes(k) == 1),
            eighteen,
        }
    }

    /// Whether a voxel with these neighbours can go without a change of what hangs together.
    fn is_simple(&self, set: u32) -> bool {
        let empty = !set & ((1 << NEIGHBOURS) - 1);
        let (around, open) = (empty & self.eighteen, empty & self.faces);
        if set == 0 || open == 0 {
            return false;
        }
        reached(set, set & set.wrapping_neg(), &self.touching) == set
            && open & !reached(around, open & open.wrapping_neg(), &self.over_face) == 0
    }
}

/// What of a set hangs together with a part of it.
fn reached(set: u32, from: u32, beside: &[u32; NEIGHBOURS]) -> u32 {
    let (mut all, mut fresh) = (from, from);
    while fresh != 0 {
        let k = fresh.trailing_zeros() as usize;
        fresh &= fresh - 1;
        let new = beside[k] & set & !all;
        (all, fresh) = (all | new, fresh | new);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::super::{Topology, topology};
    use super::*;
    use crate::random::Seed;

    fn shape(size: [usize; 3], set: impl Fn([f64; 3]) -> bool) -> (Lattice, Vec<bool>) {
        let lattice = Lattice::new(size, [1.0; 3]);
        let set = lattice.padded(lattice.voxels().map(|i| set(lattice.place(i).map(|v| v as f64))), false);
        (lattice, set)
    }

    /// Checks that all numbers are kept and nothing is left to take.
    fn check(lattice: &Lattice, set: &[bool], what: Thinning) -> (Vec<bool>, Topology) {
        let before = topology(lattice, set);
        let mut thinned = set.to_vec();
        let gone = thin(lattice, &mut thinned, what);
        assert_eq!(topology(lattice, &thinned), before);
        let left = |set: &[bool]| set.iter().filter(|v| **v).count();
        assert_eq!(left(set) - left(&thinned), gone);
        assert!(thinned.iter().zip(set).all(|(after, before)| *before || !after));
        let again = thinned.clone();
        assert_eq!(thin(lattice, &mut thinned, what), 0);
        assert!(thinned == again);
        (thinned, before)
    }

    #[test]
    fn square_bars_become_lines() {
        for thick in 1..=8 {
            let (lattice, bar) = shape([40, thick, thick], |_| true);
            let (line, _) = check(&lattice, &bar, Thinning::Line);
            let count = line.iter().filter(|v| **v).count();
            assert!((40 - thick - 1..=41).contains(&count), "{thick}: {count}");
            let ends = lattice.voxels().filter(|&i| line[i] && around(&lattice, &line, i).count_ones() == 1);
            assert_eq!(ends.count(), 2, "{thick}");
        }
    }

    #[test]
    fn rings_balls_and_random_sets_keep_what_hangs_together() {
        let ring = |p: [f64; 3], x: f64, y: f64| {
            let r = ((p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y)).sqrt() - 5.0;
            r * r + (p[2] - 3.0) * (p[2] - 3.0) <= 4.0
        };
        let four = |p: [f64; 3]| [(8.0, 8.0), (18.0, 8.0), (8.0, 18.0), (18.0, 18.0)].iter().any(|c| ring(p, c.0, c.1));
        let (lattice, set) = shape([27, 27, 7], four);
        let (skeleton, numbers) = check(&lattice, &set, Thinning::Line);
        // Four rings, and the one that they make.
        assert_eq!((numbers.tunnels, numbers.pieces), (5, 1));
        assert!(skeleton.iter().filter(|v| **v).count() < set.iter().filter(|v| **v).count() / 8);
        let far = |p: [f64; 3]| (0..3).map(|k| (p[k] - 5.0) * (p[k] - 5.0)).sum::<f64>();
        let (lattice, hollow) = shape([11, 11, 11], |p| far(p) <= 26.0 && far(p) >= 5.0);
        assert_eq!(check(&lattice, &hollow, Thinning::Line).1.cavities, 1);
        let (lattice, ball) = shape([11, 11, 11], |p| far(p) <= 26.0);
        let left = check(&lattice, &ball, Thinning::Line).0.iter().filter(|v| **v).count();
        assert!(left <= 3, "{left}");
        for seed in 0..12 {
            let draw = |p: [f64; 3]| Seed(seed).uniform((p[0] + 20.0 * (p[1] + 20.0 * p[2])) as u64);
            let (lattice, set) = shape([13, 11, 9], |p| draw(p) < 0.15 + 0.07 * seed as f64);
            check(&lattice, &set, Thinning::Line);
            check(&lattice, &set, Thinning::Sheet);
        }
    }

    #[test]
    fn a_sheet_has_the_plan_area_and_no_voxel_over_another() {
        let (lattice, slab) = shape([12, 9, 5], |p| (p[2] - (p[0] / 4.0).floor()).abs() <= 1.0);
        let (sheet, _) = check(&lattice, &slab, Thinning::Sheet);
        assert!(lattice.voxels().all(|i| !sheet[i] || FACES[..2].iter().all(|&k| !sheet[lattice.neighbour(i, k)])));
        assert!(sheet.iter().filter(|v| **v).count() >= 12 * 9);
        let (lattice, shaft) = shape([3, 3, 9], |p| p[0] == 1.0 && p[1] == 1.0);
        assert_eq!(check(&lattice, &shaft, Thinning::Sheet).0.iter().filter(|v| **v).count(), 1);
    }
}
