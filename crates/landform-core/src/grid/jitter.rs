//! Nodes of a raster off the centres of their cells, so that water that follows their slopes does
//! not follow the lattice.
//!
//! Node (r, c) stands at (c + a j₁, r + a j₂) cells, a = 0.5 and j in (−1, 1) by the seed and the
//! node. Areas stay those of cells; the distances to the eight neighbours change, and none is less
//! than 0.3 of a cell. Nodes on the sides stay.
//!
//! # Sources
//! Ours. Fairfield & Leymarie (1991) draw a diagonal's length instead (rho8): the mean direction is
//! right, but a third of the cells of channels still lie in straight runs.

use serde::{Deserialize, Serialize};

use super::Shape;
use crate::parallel;
use crate::random::Seed;

/// Greatest way of a node from the centre of its cell, along each axis, in cells.
const AMOUNT: f64 = 0.5;
/// Least distance between neighbours, in cells.
const NEAREST: f64 = 0.3;

/// By which seed the nodes of a raster stand off the centres of their cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Jitter {
    /// The seed.
    pub seed: Seed,
}

impl Jitter {
    /// Where the node in a row and a column of a whole raster stands off the centre of its cell:
    /// columns east and rows south, in cells.
    #[inline]
    pub fn offset(&self, whole: Shape, row: usize, col: usize) -> [f64; 2] {
        if row == 0 || col == 0 || row + 1 == whole.rows || col + 1 == whole.cols {
            return [0.0; 2];
        }
        let bits = self.seed.bits(whole.index(row, col) as u64);
        let part = |bits: u64| (f64::from(bits as u32) / f64::from(u32::MAX) * 2.0 - 1.0) * AMOUNT;
        [part(bits), part(bits >> 32)]
    }
}

/// Where the eight neighbours of the nodes stand.
#[derive(Clone, Debug)]
pub(super) struct Jittered {
    /// One over the distance to the neighbours in slots 0 to 3, 1/m; 0 where there is none.
    inverse: [Vec<f32>; 4],
    /// Columns east and rows south of the centre of each node's cell.
    pub(super) offset: Vec<[f32; 2]>,
}

impl Jittered {
    /// From the offsets; `step` gives the node one step away in a direction, `moves` its columns
    /// and rows.
    pub(super) fn new(
        offset: Vec<[f32; 2]>,
        [dx, dy]: [f64; 2],
        moves: [[f64; 2]; 4],
        step: impl Fn(usize, usize) -> Option<usize> + Sync,
    ) -> Self {
        let least = NEAREST * dx.min(dy);
        let inverse = std::array::from_fn(|k| {
            parallel::map(offset.len(), |i| {
                let Some(to) = step(i, k) else { return 0.0 };
                let (a, b) = (offset[i], offset[to]);
                let x = dx * (moves[k][0] + f64::from(b[0]) - f64::from(a[0]));
                let y = dy * (moves[k][1] + f64::from(b[1]) - f64::from(a[1]));
                (1.0 / (x * x + y * y).sqrt().max(least)) as f32
            })
        });
        Self { inverse, offset }
    }

    /// One over the distance from a node to its neighbour `to` in direction `k`, 1/m.
    #[inline]
    pub(super) fn per_length(&self, k: usize, node: usize, to: impl FnOnce() -> usize) -> f64 {
        // Links to the west and south are held by the neighbour.
        f64::from(self.inverse[k & 3][if k < 4 { node } else { to() }])
    }

    /// The same for columns 1..cols−1 of a row that has one below, by direction.
    #[inline]
    pub(super) fn around_row(&self, row: usize, cols: usize) -> [&[f32]; 8] {
        let part = |k: usize, first: usize| &self.inverse[k][row * cols + first..][..cols - 2];
        let held = [part(0, 0), part(1, cols), part(2, cols + 1), part(3, cols + 2)];
        [part(0, 1), part(1, 1), part(2, 1), part(3, 1), held[0], held[1], held[2], held[3]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Domain, Edge, Edges, Grid, Neighbours, RasterDomain, Status};

    fn grid(edges: Edges) -> Grid {
        let mut grid = Grid::new(Shape::new(30, 40), [10.0, 12.0]).unwrap();
        grid.edges = edges;
        grid.jitter = Some(Jitter { seed: Seed(4) });
        grid
    }

    #[test]
    fn links_have_the_distances_of_the_places() {
        for edges in [Edges::default(), Edges::all(Edge::Periodic)] {
            let grid = grid(edges);
            let domain = RasterDomain::new(&grid, &[]);
            for i in 0..grid.len() {
                for link in domain.neighbours(i) {
                    let (a, b) = (grid.position(i), grid.position(link.to));
                    // Around the sides the shorter way.
                    let d = |k: usize, n: f64| {
                        let d = (a[k] - b[k]).abs();
                        d.min((n - d).abs())
                    };
                    let (x, y) = (d(0, 400.0), d(1, 360.0));
                    let expected = (x * x + y * y).sqrt().max(3.0);
                    assert!((link.distance - expected).abs() < 1e-4, "{i} {link:?} {expected}");
                    assert_eq!(link.distance, domain.distance(i, link.slot));
                    assert_eq!(link.distance, domain.distance(link.to, domain.slot_back(i, link.slot)));
                }
            }
        }
    }

    #[test]
    fn sides_stay_and_windows_are_those_of_the_whole() {
        let grid = grid(Edges::default());
        let plain = Grid { jitter: None, ..grid.clone() };
        assert!((0..40).all(|i| grid.position(i) == plain.position(i)));
        assert_ne!(grid.position(41), plain.position(41));
        let window = grid.window([3, 4], [12, 20]).unwrap();
        assert_eq!(window.position(0), grid.position(3 * 40 + 4));
        assert_eq!(window.position(18), grid.position(4 * 40 + 5));
    }

    #[test]
    fn a_plane_is_one_at_the_centres_too() {
        let grid = grid(Edges::default());
        let plain = Grid { jitter: None, ..grid.clone() };
        let plane = |[x, y]: [f64; 2]| 500.0 + 0.7 * x - 0.4 * y;
        let nodes: Vec<f64> = (0..grid.len()).map(|i| plane(grid.position(i))).collect();
        let mut domain = RasterDomain::new(&grid, &[]);
        let mut status = domain.status().to_vec();
        status[45] = Status::BaseLevel;
        domain.set_status(status);
        let centres = domain.centres().unwrap().values(&nodes);
        for i in (0..grid.len()).filter(|&i| i != 45) {
            assert!((centres[i] - plane(plain.position(i))).abs() < 1e-4, "{i}");
        }
        assert_eq!(centres[45], nodes[45]);
        // The other way keeps the sum, and is the transpose.
        let weights = domain.centres().unwrap();
        let rough = |k: u64| (0..grid.len()).map(|i| Seed(k).uniform(i as u64) - 0.5).collect::<Vec<f64>>();
        let (a, b) = (rough(1), rough(2));
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        assert!((weights.spread(&a).iter().sum::<f64>() - a.iter().sum::<f64>()).abs() < 1e-9);
        assert!((dot(&weights.values(&b), &a) - dot(&b, &weights.spread(&a))).abs() < 1e-9);
        // Creep there and back must not amplify: the greatest factor is below 2.
        let mut v = a;
        for _ in 0..100 {
            let norm = dot(&v, &v).sqrt();
            v.iter_mut().for_each(|v| *v /= norm);
            v = weights.spread(&weights.values(&v));
        }
        assert!(dot(&v, &v).sqrt() < 1.9, "{}", dot(&v, &v).sqrt());
        assert!(RasterDomain::new(&plain, &[]).centres().is_none());
    }
}
