//! Nodes of a raster off the centres of their cells, so that water that follows their slopes does not follow the lattice.
//!
//! Node (r, c) stands at (c + a j₁, r + a j₂) cells, a = 0.5 and j in (−1, 1) by the seed and the node. Areas stay those of cells;
//! the distances to the eight neighbours change, and none is less than 0.3 of a cell. Nodes on the sides stay.
//!
//! # Sources
//! Ours. Fairfield & Leymarie (1991) draw a diagonal's length instead (rho8): the mean direction is right, but a third of the
//! cells of channels still lie in straight runs.

use serde::{Deserialize, Serialize};

use super::{Grid, Shape, Status};
use crate::parallel;
use crate::random::Seed;

/// Greatest way of a node from the centre of its cell, along each axis, in cells.
const AMOUNT: f64 = 0.5;
/// Least distance between neighbours, in cells.
const NEAREST: f64 = 0.3;
/// Distance at which a node no longer counts for the centre of a cell, in cells.
const FARTHEST: f64 = 1.9;

/// By which seed the nodes of a raster stand off the centres of their cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Jitter {
    /// The seed.
    pub seed: Seed,
}

impl Jitter {
    /// Where the node in a row and a column stands off the centre of its cell: columns east and rows south, in cells.
    #[inline]
    pub fn offset(&self, grid: &Grid, row: usize, col: usize) -> [f64; 2] {
        let (first, shape) = grid.frame.map_or(([0, 0], grid.shape), |frame| (frame.first, frame.shape));
        let (row, col) = (first[0] + row, first[1] + col);
        if row == 0 || col == 0 || row + 1 == shape.rows || col + 1 == shape.cols {
            return [0.0; 2];
        }
        let bits = self.seed.bits(shape.index(row, col) as u64);
        let part = |bits: u64| (f64::from(bits as u32) / f64::from(u32::MAX) * 2.0 - 1.0) * AMOUNT;
        [part(bits), part(bits >> 32)]
    }
}

/// Where the eight neighbours of the nodes stand.
#[derive(Clone, Debug)]
pub(super) struct Jittered {
    /// One over the distance to the neighbours in slots 0 to 3, 1/m; 0 where there is none.
    pub(super) inverse: [Vec<f32>; 4],
    /// Columns east and rows south of the centre of each node's cell.
    pub(super) offset: Vec<[f32; 2]>,
}

impl Jittered {
    /// `step` gives the node one step away in a direction; `moves` its columns and rows.
    pub(super) fn new(
        grid: &Grid,
        jitter: Jitter,
        moves: [[f64; 2]; 4],
        step: impl Fn(usize, usize) -> Option<usize> + Sync,
    ) -> Self {
        let offset = offsets(grid, jitter);
        let [dx, dy] = grid.spacing;
        let least = NEAREST * dx.min(dy);
        let inverse = std::array::from_fn(|k| {
            parallel::map(grid.len(), |i| {
                let Some(to) = step(i, k) else { return 0.0 };
                let (a, b) = (offset[i], offset[to]);
                let x = dx * (moves[k][0] + f64::from(b[0]) - f64::from(a[0]));
                let y = dy * (moves[k][1] + f64::from(b[1]) - f64::from(a[1]));
                (1.0 / (x * x + y * y).sqrt().max(least)) as f32
            })
        });
        Self { inverse, offset }
    }
}

fn offsets(grid: &Grid, jitter: Jitter) -> Vec<[f32; 2]> {
    parallel::map(grid.len(), |i| {
        let cell = grid.shape.cell(i);
        jitter.offset(grid, cell.row, cell.col).map(|v| v as f32)
    })
}

/// The value at the centre of every cell: that of the plane through the nodes of the nine cells around it, those near the centre
/// counting most. Base levels keep the node's, as do sides; nodata is left out.
#[derive(Clone, Debug)]
pub struct Centres {
    shape: Shape,
    /// Weights of the differences of the eight neighbours, by row.
    weights: Vec<[f32; 8]>,
}

/// Rows and columns of the eight cells around one.
const AROUND: [[isize; 2]; 8] = [[-1, -1], [-1, 0], [-1, 1], [0, -1], [0, 1], [1, -1], [1, 0], [1, 1]];

impl Centres {
    /// The weights for nodes that stand so many columns east and rows south of the centres.
    pub(super) fn new(shape: Shape, offset: &[[f32; 2]], status: &[Status]) -> Self {
        let weights = parallel::map(offset.len(), |i| {
            let cell = shape.cell(i);
            let on_rim = cell.row == 0 || cell.col == 0 || cell.row + 1 == shape.rows || cell.col + 1 == shape.cols;
            if on_rim || status[i] != Status::Interior {
                return [0.0; 8];
            }
            plane(offset[i], |k| {
                let to = at(shape, i, AROUND[k]);
                (status[to] != Status::Masked).then_some(offset[to])
            })
        });
        Self { shape, weights }
    }

    /// The values at the centres.
    pub fn values(&self, nodes: &[f64]) -> Vec<f64> {
        parallel::map(nodes.len(), |i| {
            let own = nodes[i];
            let linked = self.weights[i].iter().enumerate().filter(|(_, w)| **w != 0.0);
            let sum: f64 = linked.map(|(k, &w)| f64::from(w) * (nodes[at(self.shape, i, AROUND[k])] - own)).sum();
            own + sum
        })
    }

    /// Amounts at the centres as amounts at the nodes, by the same weights: their sum stays.
    pub fn spread(&self, centres: &[f64]) -> Vec<f64> {
        let Shape { rows, cols } = self.shape;
        parallel::map(centres.len(), |i| {
            let given: f64 = self.weights[i].iter().map(|&w| f64::from(w)).sum();
            let mut sum = centres[i] * (1.0 - given);
            let cell = self.shape.cell(i);
            for (k, &[row, col]) in AROUND.iter().enumerate() {
                let (r, c) = (cell.row.checked_add_signed(row), cell.col.checked_add_signed(col));
                if let (Some(r), Some(c)) = (r.filter(|r| *r < rows), c.filter(|c| *c < cols)) {
                    let from = self.shape.index(r, c);
                    // Seen from there this node lies the other way.
                    let weight = self.weights[from][7 - k];
                    sum += if weight == 0.0 { 0.0 } else { f64::from(weight) * centres[from] };
                }
            }
            sum
        })
    }
}

#[inline]
fn at(shape: Shape, node: usize, [row, col]: [isize; 2]) -> usize {
    (node as isize + row * shape.cols as isize + col) as usize
}

/// Weights of the eight neighbours' differences in the plane's value at the centre.
fn plane(own: [f32; 2], other: impl Fn(usize) -> Option<[f32; 2]>) -> [f32; 8] {
    let weight = |[x, y]: [f64; 2]| {
        let near = (1.0 - (x * x + y * y) / (FARTHEST * FARTHEST)).max(0.0);
        let square = near * near;
        square * square
    };
    let mut all = [([0.0; 2], 0.0); 9];
    for (k, [row, col]) in AROUND.into_iter().enumerate() {
        if let Some(o) = other(k) {
            let place = [col as f64 + f64::from(o[0]), row as f64 + f64::from(o[1])];
            all[k] = (place, weight(place));
        }
    }
    let own = own.map(f64::from);
    all[8] = (own, weight(own));
    let sum = |f: &dyn Fn([f64; 2]) -> f64| all.iter().map(|&(p, w)| w * f(p)).sum::<f64>();
    let (s, sx, sy) = (sum(&|_| 1.0), sum(&|[x, _]| x), sum(&|[_, y]| y));
    let (sxx, sxy, syy) = (sum(&|[x, _]| x * x), sum(&|[x, y]| x * y), sum(&|[_, y]| y * y));
    let minors = [sxx * syy - sxy * sxy, sxy * sy - sx * syy, sx * sxy - sxx * sy];
    let determinant = s * minors[0] + sx * minors[1] + sy * minors[2];
    let mut weights = [0.0; 8];
    if determinant > 1e-6 * s * s * s {
        for (k, w) in weights.iter_mut().enumerate() {
            let ([x, y], weight) = all[k];
            *w = (weight * (minors[0] + minors[1] * x + minors[2] * y) / determinant) as f32;
        }
    }
    weights
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Domain, Edge, Edges, Neighbours, RasterDomain, Status};

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
