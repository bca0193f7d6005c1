//! A surface as files of meshes want it.

use landform_core::terrain::{HeightField, Mesh, NodeSurface, mesh_parts_from_height_field};

/// Points and triangles, z up, metres, counter-clockwise seen from above.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// Positions, m.
    pub points: Vec<[f64; 3]>,
    /// Triangles.
    pub triangles: Vec<[u32; 3]>,
}

/// The triangles of a mesh.
pub fn mesh_file_from_mesh(mesh: &Mesh) -> MeshFile {
    let points = mesh.positions().iter().zip(mesh.elevation()).map(|(p, z)| [p[0], p[1], *z]).collect();
    MeshFile { points, triangles: mesh.triangles().to_vec() }
}

/// Two triangles a cell of a raster; holes stay open.
pub fn mesh_file_from_height_field(field: &HeightField) -> MeshFile {
    let (points, triangles) = mesh_parts_from_height_field(field);
    MeshFile { points, triangles }
}

impl MeshFile {
    /// Middle of the bounding box: what is subtracted where only 32-bit numbers are stored, so that large coordinates keep
    /// their centimetres.
    pub(super) fn centre(&self) -> [f64; 3] {
        let mut centre = [0.0; 3];
        for (k, c) in centre.iter_mut().enumerate().take(2) {
            let axis = || self.points.iter().map(|p| p[k]);
            let (lo, hi) = (axis().fold(f64::INFINITY, f64::min), axis().fold(f64::NEG_INFINITY, f64::max));
            if lo <= hi {
                *c = 0.5 * (lo + hi);
            }
        }
        centre
    }

    /// Normal of each point: the sum of its triangles' normals, unit length.
    pub(super) fn normals(&self) -> Vec<[f32; 3]> {
        let mut normals = vec![[0.0_f64; 3]; self.points.len()];
        for t in &self.triangles {
            let n = cross(t.map(|i| self.points[i as usize]));
            for &i in t {
                for k in 0..3 {
                    normals[i as usize][k] += n[k];
                }
            }
        }
        normals.into_iter().map(unit).collect()
    }

    /// Unit normal of a triangle.
    pub(super) fn face_normal(&self, triangle: [u32; 3]) -> [f32; 3] {
        unit(cross(triangle.map(|i| self.points[i as usize])))
    }
}

fn cross([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let (u, v) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

fn unit(v: [f64; 3]) -> [f32; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if length > 0.0 { v.map(|x| (x / length) as f32) } else { [0.0, 0.0, 1.0] }
}
