//! From nodes off the centres of their cells to the centres, and back.

use super::Shape;
use crate::parallel;

/// Distance at which a node no longer counts for the centre of a cell, in cells. With less, planes
/// through nodes that stand badly are far off, and creep there and back grows.
const FARTHEST: f64 = 1.9;

/// The value at the centre of every cell: that of the plane through the nodes of the nine cells
/// around it, those near the centre counting most. Some keep the node's, as sides do; nodata is
/// left out.
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
    pub(super) fn new(
        shape: Shape,
        offset: &[[f32; 2]],
        keeps: impl Fn(usize) -> bool + Sync,
        is_nodata: impl Fn(usize) -> bool + Sync,
    ) -> Self {
        let weights = parallel::map(offset.len(), |i| {
            let cell = shape.cell(i);
            let on_rim = cell.row == 0 || cell.col == 0 || cell.row + 1 == shape.rows || cell.col + 1 == shape.cols;
            if on_rim || keeps(i) {
                return [0.0; 8];
            }
            plane(offset[i], |k| {
                let to = at(shape, i, AROUND[k]);
                (!is_nodata(to)).then_some(offset[to])
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
