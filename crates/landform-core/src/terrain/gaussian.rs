//! A raster of a mesh by a Gaussian kernel.

use super::{HeightField, Mesh, NodeSurface};
use crate::{math, parallel};

/// Elevation on the nodes of `onto` as the mean of the mesh's nodes under a Gaussian kernel of
/// `sigma` cells.
///
/// Every node is shared among the four cells around it, sums and weights are blurred along rows and
/// then columns: O(cells · sigma), where the thesis' sum over all nodes for every cell is O(cells ·
/// nodes). Where the kernel (cut at 4 sigma) reaches no node, the value of `onto` is kept.
///
/// # Sources
/// Bell (thesis), algorithm 10, with the distance taken from the cell's own position and the sum
/// returned (validation notes 3.3). A kernel mean lowers ridges and does not reproduce slopes.
pub fn gaussian_from_mesh(mesh: &Mesh, onto: &HeightField, sigma: f64) -> Vec<f64> {
    let grid = onto.grid();
    let shape = grid.shape;
    let (mut sum, mut weight) = (vec![0.0; shape.len()], vec![0.0; shape.len()]);
    for (i, &position) in mesh.positions().iter().enumerate() {
        let [u, v] = grid.col_row(position);
        let (c, r) = (u.max(0.0) as usize, v.max(0.0) as usize);
        let (fu, fv) = (u - c as f64, v - r as f64);
        for (dr, wr) in [(0, 1.0 - fv), (1, fv)] {
            for (dc, wc) in [(0, 1.0 - fu), (1, fu)] {
                let k = shape.index((r + dr).min(shape.rows - 1), (c + dc).min(shape.cols - 1));
                sum[k] += wr * wc * mesh.elevation()[i];
                weight[k] += wr * wc;
            }
        }
    }
    let kernel: Vec<f64> = (0..=(4.0 * sigma).ceil() as usize)
        .map(|k| math::exp(-0.5 * (k as f64 / sigma) * (k as f64 / sigma)))
        .collect();
    let blur = |values: &[f64]| along(&along(values, shape.rows, shape.cols, &kernel), shape.cols, shape.rows, &kernel);
    let (sum, weight) = (blur(&sum), blur(&weight));
    let kept = onto.elevation();
    parallel::map(shape.len(), |i| if weight[i] > 0.0 && !kept[i].is_nan() { sum[i] / weight[i] } else { kept[i] })
}

/// Blurs along rows and transposes: the result has `cols` rows.
fn along(values: &[f64], rows: usize, cols: usize, kernel: &[f64]) -> Vec<f64> {
    parallel::map(values.len(), |k| {
        let (col, row) = (k / rows, k % rows);
        let line = &values[row * cols..(row + 1) * cols];
        let mut sum = kernel[0] * line[col];
        for (d, w) in kernel.iter().enumerate().skip(1) {
            if col >= d {
                sum += w * line[col - d];
            }
            if col + d < cols {
                sum += w * line[col + d];
            }
        }
        sum
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::sampling::poisson_disk;
    use crate::grid::Edges;
    use crate::random::Seed;
    use crate::terrain::{Layer, height_field_from_mesh};

    #[test]
    fn the_kernel_mean_is_the_sum_over_nodes() {
        let sites = poisson_disk([1000.0, 700.0], 40.0, Seed(1)).unwrap();
        let mut mesh = Mesh::delaunay(&sites, Edges::default()).unwrap();
        for i in 0..mesh.positions().len() {
            let [x, y] = mesh.positions()[i];
            mesh.change(Layer::Bedrock, |z| z[i] = 0.3 * x + 50.0 * math::sin(y / 90.0));
        }
        let onto = height_field_from_mesh(&mesh, 10.0).unwrap();
        let sigma = 6.0;
        let fast = gaussian_from_mesh(&mesh, &onto, sigma);
        for i in (0..onto.grid().len()).step_by(37) {
            let p = onto.grid().position(i);
            let (mut sum, mut weight) = (0.0, 0.0);
            for (q, z) in mesh.positions().iter().zip(mesh.elevation()) {
                let d2 = crate::math::powi(p[0] - q[0], 2) + crate::math::powi(p[1] - q[1], 2);
                let w = math::exp(-0.5 * d2 / (100.0 * sigma * sigma));
                sum += w * z;
                weight += w;
            }
            // The sharing among four cells widens the kernel by half a cell at most.
            assert!((fast[i] - sum / weight).abs() < 2.0, "{} {}", fast[i], sum / weight);
        }
    }
}
