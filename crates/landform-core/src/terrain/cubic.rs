//! A raster of a mesh by smooth curves.
//!
//! On each triangle a surface of three cubic pieces (Clough & Tocher 1965): it goes through the
//! nodes, has their gradients there, and meets the next triangle without a crease, since the slope
//! across an edge is linear along it. Gradients are those of planes through a node and, by least
//! squares with one over the square of the distance as weight, its neighbours.
//!
//! # Sources
//! Clough & Tocher (1965); in Bernstein's form as Farin (1986), section 5.

use super::convert::{barycentric, locate};
use super::{HeightField, Mesh, NodeSurface};
use crate::parallel;

/// Elevation on the nodes of `onto`, m, without the creases that triangles have. It may go a little
/// beyond the nodes where the ground bends sharply. Planes stay planes.
///
/// **Cost** O(nodes + cells).
///
/// ```
/// use landform_core::grid::Edges;
/// use landform_core::terrain::{Layer, Mesh, NodeSurface, cubic_from_mesh, height_field_from_mesh};
///
/// let sites = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0], [5.0, 5.0]];
/// let mut mesh = Mesh::delaunay(&sites, Edges::default())?;
/// let rise: Vec<f64> = mesh.positions().iter().map(|p| 0.5 * p[0]).collect();
/// mesh.change(Layer::Bedrock, |z| z.copy_from_slice(&rise));
/// let raster = height_field_from_mesh(&mesh, 2.5)?;
/// let smooth = cubic_from_mesh(&mesh, &raster);
/// assert!((smooth[1] - 1.25).abs() < 1e-9);
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn cubic_from_mesh(mesh: &Mesh, onto: &HeightField) -> Vec<f64> {
    let grid = onto.grid();
    let (triangle, gradients) = (locate(mesh, grid), gradients(mesh));
    parallel::map(grid.len(), |i| match triangle[i] {
        u32::MAX => f64::NAN,
        t => {
            let corners = mesh.triangles()[t as usize];
            let weights = barycentric(mesh, corners, grid.position(i));
            Piece::of(mesh, corners, &gradients).at(weights)
        }
    })
}

/// The gradient at every node.
fn gradients(mesh: &Mesh) -> Vec<[f64; 2]> {
    let (places, z) = (mesh.positions(), mesh.elevation());
    // Sums of w x², w x y, w y², w x h, w y h over the links of a node.
    let mut sums = vec![[0.0; 5]; places.len()];
    for corners in mesh.triangles() {
        for k in 0..3 {
            for (a, b) in [(corners[k], corners[(k + 1) % 3]), (corners[(k + 1) % 3], corners[k])] {
                let (a, b) = (a as usize, b as usize);
                let (x, y, h) = (places[b][0] - places[a][0], places[b][1] - places[a][1], z[b] - z[a]);
                if h.is_nan() {
                    continue;
                }
                let w = 1.0 / (x * x + y * y);
                let terms = [x * x, x * y, y * y, x * h, y * h];
                sums[a].iter_mut().zip(terms).for_each(|(sum, term)| *sum += w * term);
            }
        }
    }
    parallel::map(sums.len(), |i| {
        let [xx, xy, yy, xh, yh] = sums[i];
        let determinant = xx * yy - xy * xy;
        // Neighbours on one line say nothing across it.
        if !(determinant > 1e-12 * (xx + yy) * (xx + yy)) {
            return [0.0; 2];
        }
        [(xh * yy - yh * xy) / determinant, (yh * xx - xh * xy) / determinant]
    })
}

/// The ordinates of the three pieces on a triangle.
struct Piece {
    /// At the corners.
    corner: [f64; 3],
    /// Along the edge opposite to a corner, the one nearer to the next corner first.
    edge: [[f64; 2]; 3],
    /// From a corner towards the centre: a third of the way, two thirds.
    spoke: [[f64; 2]; 3],
    /// Between an edge and the centre, by the opposite corner.
    inner: [f64; 3],
    centre: f64,
}

impl Piece {
    fn of(mesh: &Mesh, corners: [u32; 3], gradients: &[[f64; 2]]) -> Self {
        let place = corners.map(|i| mesh.positions()[i as usize]);
        let corner = corners.map(|i| mesh.elevation()[i as usize]);
        let gradient = corners.map(|i| gradients[i as usize]);
        let middle = [0, 1].map(|k| (place[0][k] + place[1][k] + place[2][k]) / 3.0);
        let towards = |k: usize, to: [f64; 2]| {
            corner[k] + (gradient[k][0] * (to[0] - place[k][0]) + gradient[k][1] * (to[1] - place[k][1])) / 3.0
        };
        let ends = [0, 1, 2].map(|k| [(k + 1) % 3, (k + 2) % 3]);
        let edge = ends.map(|[a, b]| [towards(a, place[b]), towards(b, place[a])]);
        let first = [0, 1, 2].map(|k| towards(k, middle));
        // The slope across an edge is linear along it.
        let inner = [0, 1, 2].map(|k| {
            let [a, b] = ends[k];
            let (e, m) = ([0, 1].map(|j| place[b][j] - place[a][j]), [0, 1].map(|j| middle[j] - place[a][j]));
            let t = (m[0] * e[0] + m[1] * e[1]) / (e[0] * e[0] + e[1] * e[1]);
            let along = |from: f64, to: f64| from + t * (to - from);
            let start = first[a] - along(corner[a], edge[k][0]);
            let end = first[b] - along(edge[k][1], corner[b]);
            0.5 * (start + end) + along(edge[k][0], edge[k][1])
        });
        let second = [0, 1, 2].map(|k| (first[k] + inner[(k + 1) % 3] + inner[(k + 2) % 3]) / 3.0);
        let centre = (second[0] + second[1] + second[2]) / 3.0;
        Self { corner, edge, spoke: [0, 1, 2].map(|k| [first[k], second[k]]), inner, centre }
    }

    /// The height at a point of given barycentric coordinates.
    fn at(&self, weights: [f64; 3]) -> f64 {
        let k = (0..3).min_by(|&a, &b| weights[a].total_cmp(&weights[b])).unwrap_or(0);
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (a, b, c) = (weights[i] - weights[k], weights[j] - weights[k], 3.0 * weights[k]);
        let [sa, sb] = [self.spoke[i], self.spoke[j]];
        let border = a * a * (a * self.corner[i] + 3.0 * b * self.edge[k][0])
            + b * b * (b * self.corner[j] + 3.0 * a * self.edge[k][1]);
        let between = 3.0 * c * (a * a * sa[0] + 2.0 * a * b * self.inner[k] + b * b * sb[0]);
        border + between + c * c * (3.0 * (a * sa[1] + b * sb[1]) + c * self.centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::sampling::poisson_disk;
    use crate::grid::Edges;
    use crate::math;
    use crate::random::Seed;
    use crate::terrain::{Layer, height_field_from_mesh};

    fn mesh(z: impl Fn([f64; 2]) -> f64) -> Mesh {
        let sites = poisson_disk([1000.0, 1000.0], 40.0, Seed(1)).unwrap();
        let mut mesh = Mesh::delaunay(&sites, Edges::default()).unwrap();
        let heights: Vec<f64> = mesh.positions().iter().map(|&p| z(p)).collect();
        mesh.change(Layer::Bedrock, |z| z.copy_from_slice(&heights));
        mesh
    }

    #[test]
    fn planes_stay_and_waves_are_nearer_than_by_triangles() {
        let plane = |[x, y]: [f64; 2]| 3.0 + 0.5 * x - 0.25 * y;
        let field = height_field_from_mesh(&mesh(plane), 10.0).unwrap();
        let cubic = cubic_from_mesh(&mesh(plane), &field);
        assert!((0..cubic.len()).all(|i| (cubic[i] - plane(field.grid().position(i))).abs() < 1e-9));
        let wave = |[x, y]: [f64; 2]| 50.0 * math::sin(x / 60.0) * math::cos(y / 70.0);
        let ground = mesh(wave);
        let field = height_field_from_mesh(&ground, 10.0).unwrap();
        let cubic = cubic_from_mesh(&ground, &field);
        let error = |z: &[f64]| {
            let sum: f64 = (0..z.len()).map(|i| (z[i] - wave(field.grid().position(i))).abs()).sum();
            sum / z.len() as f64
        };
        let (smooth, flat) = (error(&cubic), error(field.elevation()));
        assert!(smooth < 0.6 * flat, "{smooth} {flat}");
    }

    #[test]
    fn edges_of_triangles_have_no_crease() {
        let ground = mesh(|[x, y]| Seed(2).uniform((x * 7.0 + y) as u64) * 30.0);
        let gradients = gradients(&ground);
        let height = |t: usize, p: [f64; 2]| {
            let corners = ground.triangles()[t];
            let places = corners.map(|i| ground.positions()[i as usize]);
            let cross =
                |o: [f64; 2], u: [f64; 2], v: [f64; 2]| (u[0] - o[0]) * (v[1] - o[1]) - (u[1] - o[1]) * (v[0] - o[0]);
            let [a, b, c] = places;
            let all = cross(a, b, c);
            let w = [cross(p, b, c) / all, cross(p, c, a) / all, cross(p, a, b) / all];
            Piece::of(&ground, corners, &gradients).at(w)
        };
        let mut seen = 0;
        for (t, corners) in ground.triangles().iter().enumerate().take(200) {
            let shares = |o: &[u32; 3]| o.contains(&corners[0]) && o.contains(&corners[1]) && o != corners;
            let Some(other) = ground.triangles().iter().position(shares) else { continue };
            let [a, b] = [corners[0], corners[1]].map(|i| ground.positions()[i as usize]);
            let (e, h) = ([b[0] - a[0], b[1] - a[1]], 1e-4);
            for s in [0.2, 0.5, 0.9] {
                // Just inside of one and of the other, along the normal of the edge.
                let at = |side: f64| [a[0] + s * e[0] - side * h * e[1], a[1] + s * e[1] + side * h * e[0]];
                let (inside, on, outside) = (height(t, at(1.0)), height(t, at(0.0)), height(other, at(-1.0)));
                assert!((on - height(other, at(0.0))).abs() < 1e-9);
                assert!(((inside - on) - (on - outside)).abs() < 1e-4, "{inside} {on} {outside}");
                seen += 1;
            }
        }
        assert!(seen > 100);
    }
}
