//! Components, tunnels and cavities of a set of voxels.
//!
//! # Method
//! Voxels of the set hang together over faces, edges and corners (26), those beside it over faces
//! (6). Euler's number is that of the union of closed cubes: vertices less edges plus faces less
//! cubes. Tunnels follow from b0 − b1 + b2 (Kong & Rosenfeld 1989).
//!
//! # Checked by
//! `tests`: a ball, a ring, a double ring, a hollow ball, voxels that touch at corners.

use super::super::disjoint_sets::DisjointSets;
use super::Lattice;

/// Numbers that thinning keeps.
///
/// ```
/// use landform_core::algo::lattice::{Lattice, topology};
///
/// let lattice = Lattice::new([3, 3, 1], [1.0; 3]);
/// // A ring of eight voxels.
/// let ring = lattice.padded((0..9).map(|i| i != 4), false);
/// let found = topology(&lattice, &ring);
/// assert_eq!((found.euler, found.pieces, found.tunnels, found.cavities), (0, 1, 1, 0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Topology {
    /// Euler's number.
    pub euler: i64,
    /// Pieces that hang together (b0).
    pub pieces: usize,
    /// Independent loops (b1).
    pub tunnels: usize,
    /// Hollows that are closed all around (b2).
    pub cavities: usize,
}

/// What hangs together in a set of voxels, stored as [`Lattice`] says with a border of `false`.
///
/// **Cost** O(voxels), about 50 ns each.
///
/// ```
/// use landform_core::algo::lattice::{Lattice, topology};
///
/// let lattice = Lattice::new([3, 1, 1], [1.0; 3]);
/// let two = lattice.padded([true, false, true].into_iter(), false);
/// assert_eq!(topology(&lattice, &two).pieces, 2);
/// ```
pub fn topology(lattice: &Lattice, set: &[bool]) -> Topology {
    let (euler, pieces) = (euler(lattice, set), components(lattice, set).1);
    // The border is one piece with all that is open to it.
    let outside: Vec<bool> = set.iter().map(|b| !b).collect();
    let cavities = over_faces(lattice, &outside) - 1;
    Topology { euler, pieces, tunnels: (pieces as i64 + cavities as i64 - euler).max(0) as usize, cavities }
}

/// For each stored voxel the number of its piece, from 1 in the order of their first voxels, 0
/// beside the set; and how many pieces there are. Pieces hang together over faces, edges and
/// corners.
///
/// **Cost** O(voxels).
///
/// ```
/// use landform_core::algo::lattice::{Lattice, components};
///
/// let lattice = Lattice::new([4, 1, 1], [1.0; 3]);
/// let set = lattice.padded([true, false, true, true].into_iter(), false);
/// let (numbers, count) = components(&lattice, &set);
/// assert_eq!((lattice.unpadded(&numbers), count), (vec![1, 0, 2, 2], 2));
/// ```
pub fn components(lattice: &Lattice, set: &[bool]) -> (Vec<u32>, usize) {
    let mut sets = DisjointSets::new(set.len());
    for i in lattice.voxels().filter(|&i| set[i]) {
        // Those before it; the others find it.
        for k in (0..13).filter(|&k| set[lattice.neighbour(i, k)]) {
            sets.join(i as u32, lattice.neighbour(i, k) as u32);
        }
    }
    let (mut numbers, mut count) = (vec![0; set.len()], 0);
    for i in lattice.voxels().filter(|&i| set[i]) {
        let root = sets.root(i as u32) as usize;
        if root == i {
            count += 1;
            numbers[i] = count;
        } else {
            numbers[i] = numbers[root];
        }
    }
    (numbers, count as usize)
}

/// How many pieces hang together over faces, the border included.
fn over_faces(lattice: &Lattice, set: &[bool]) -> usize {
    let [nx, ny, _] = lattice.size().map(|n| n + 2);
    let mut sets = DisjointSets::new(set.len());
    for i in (0..set.len()).filter(|&i| set[i]) {
        let before = [(i % nx > 0, 1), (i / nx % ny > 0, nx), (i >= nx * ny, nx * ny)];
        for (_, step) in before.into_iter().filter(|&(there, step)| there && set[i - step]) {
            sets.join(i as u32, (i - step) as u32);
        }
    }
    (0..set.len()).filter(|&i| set[i] && sets.root(i as u32) as usize == i).count()
}

fn euler(lattice: &Lattice, set: &[bool]) -> i64 {
    let [nx, ny, nz] = lattice.size().map(|n| n + 2);
    let (sx, sy, sz) = (1, nx, nx * ny);
    let mut sum = 0;
    // At the lower corner of every voxel: the vertex there, and the edges, faces and the cube that
    // go from it up the axes.
    for z in 1..nz {
        for y in 1..ny {
            for x in 1..nx {
                let i = (z * ny + y) * nx + x;
                let any = |steps: &[usize]| steps.iter().any(|s| set[i - s]);
                let cube = set[i];
                let faces = [any(&[0, sx]), any(&[0, sy]), any(&[0, sz])];
                let edges = [any(&[0, sy, sz, sy + sz]), any(&[0, sx, sz, sx + sz]), any(&[0, sx, sy, sx + sy])];
                let vertex = edges[0] || any(&[sx, sx + sy, sx + sz, sx + sy + sz]);
                let count = |all: [bool; 3]| all.into_iter().map(i64::from).sum::<i64>();
                sum += i64::from(vertex) - count(edges) + count(faces) - i64::from(cube);
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(size: [usize; 3], set: impl Fn([f64; 3]) -> bool) -> [i64; 4] {
        let lattice = Lattice::new(size, [1.0; 3]);
        let set = lattice.padded(lattice.voxels().map(|i| set(lattice.place(i).map(|v| v as f64))), false);
        let t = topology(&lattice, &set);
        [t.euler, t.pieces as i64, t.tunnels as i64, t.cavities as i64]
    }

    fn ball(p: [f64; 3], middle: [f64; 3], radius: f64) -> bool {
        (0..3).map(|k| (p[k] - middle[k]) * (p[k] - middle[k])).sum::<f64>() <= radius * radius
    }

    #[test]
    fn shapes_whose_numbers_are_known() {
        assert_eq!(of([9, 9, 9], |p| ball(p, [4.0; 3], 4.2)), [1, 1, 0, 0]);
        assert_eq!(of([9, 9, 9], |p| ball(p, [4.0; 3], 4.2) && !ball(p, [4.0; 3], 2.0)), [2, 1, 0, 1]);
        let ring = |p: [f64; 3], x: f64| {
            let r = ((p[0] - x) * (p[0] - x) + (p[1] - 8.0) * (p[1] - 8.0)).sqrt() - 5.0;
            r * r + (p[2] - 3.0) * (p[2] - 3.0) <= 4.0
        };
        assert_eq!(of([17, 17, 7], |p| ring(p, 8.0)), [0, 1, 1, 0]);
        assert_eq!(of([30, 17, 7], |p| ring(p, 8.0) || ring(p, 20.0)), [-1, 1, 2, 0]);
        // Corners hold voxels together, and void between them is open over faces only.
        assert_eq!(of([2, 2, 2], |p| p == [0.0; 3] || p == [1.0; 3]), [1, 1, 0, 0]);
        assert_eq!(of([3, 1, 1], |_| false), [0, 0, 0, 0]);
    }
}
