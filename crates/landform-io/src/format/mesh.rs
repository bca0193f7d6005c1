//! A surface in the form that mesh files need.

use std::collections::HashSet;

use landform_core::algo::decimate::decimate;
use landform_core::algo::polygonise::polygonise;
use landform_core::analysis::cave::cave_voxels;
use landform_core::field::names;
use landform_core::terrain::{Bounds, Ground, HeightField, Mesh, NodeSurface, VoxelGrid, mesh_parts_from_height_field};
use landform_core::{Error, Result};

use super::smooth::smooth;
use crate::vector::{Vector, cross, sub};

/// Points and triangles, z up, metres, counter-clockwise seen from above.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// Positions, m.
    pub points: Vec<[f64; 3]>,
    /// Triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Middle of the whole that this is a part of, m, so that parts stored about it fit together.
    /// If none, it is its own middle.
    pub middle: Option<[f64; 2]>,
    /// A picture on it; formats other than glTF leave it out.
    pub texture: Option<Texture>,
    /// Numbers of each point; PLY, VTK and tables hold them.
    pub fields: Vec<PointField>,
}

/// Numbers of the points of a mesh.
///
/// ```
/// use landform_io::format::PointField;
///
/// let field = PointField { name: "drainage_area".into(), unit: "m2".into(), values: vec![900.0] };
/// assert_eq!(field.values.len(), 1);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PointField {
    /// Name.
    pub name: String,
    /// Unit.
    pub unit: String,
    /// A number for each point.
    pub values: Vec<f64>,
}

impl PointField {
    /// Name and unit in one word, for the head of a column.
    pub(crate) fn title(&self) -> String {
        match self.unit.as_str() {
            "1" => self.name.clone(),
            unit => format!("{}_{}", self.name, unit.replace('/', "_per_").replace(' ', "")),
        }
    }
}

/// A picture that lies on a surface.
///
/// ```
/// use landform_io::format::Texture;
///
/// let texture = Texture { places: vec![[0.5, 0.5]], png: Vec::new() };
/// assert_eq!(texture.places.len(), 1);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Place of each point on the picture, 0 to 1: to the right, and down.
    pub places: Vec<[f32; 2]>,
    /// The picture, as PNG.
    pub png: Vec<u8>,
}

/// The triangles of a mesh.
pub fn mesh_file_from_mesh(mesh: &Mesh) -> MeshFile {
    let points = mesh.positions().iter().zip(mesh.elevation()).map(|(p, z)| [p[0], p[1], *z]).collect();
    MeshFile { points, triangles: mesh.triangles().to_vec(), middle: None, texture: None, fields: Vec::new() }
}

/// The faces of voxels, or their surface nets, two triangles each; `rounds` of smoothing, in which
/// no point leaves the half of a voxel around it.
pub fn mesh_file_from_voxels(ground: &VoxelGrid, rounds: u32, nets: bool) -> MeshFile {
    let shape = ground.plan().shape;
    // Rows run from the north, the lattice from the south.
    let node = |x: usize, y: usize| shape.index(shape.rows - 1 - y, x);
    let size = [shape.cols, shape.rows, ground.levels()];
    let quads = polygonise(size, |[x, y, z]| ground.material(z, node(x, y)).is_some());
    let Bounds { low, .. } = ground.bounding_box();
    let [dx, dy] = ground.plan().spacing;
    let side = [dx, dy, ground.height()];
    let at = |v: [f64; 3]| std::array::from_fn(|k| low[k] + v[k] * side[k]);
    let points = smooth(&quads, size, rounds, nets).into_iter().map(at).collect();
    MeshFile { points, triangles: quads.triangles(), middle: None, texture: None, fields: Vec::new() }
}

/// The walls of the cave alone, as seen from inside; closed where it leaves the box.
pub(crate) fn mesh_file_of_cave(ground: &VoxelGrid, rounds: u32, nets: bool) -> MeshFile {
    let (lattice, cave) = cave_voxels(ground);
    let inner = lattice.size();
    // A layer of rock all around keeps ends closed.
    let size = inner.map(|n| n + 2);
    let is_cave = |[x, y, z]: [usize; 3]| {
        let at = [x.wrapping_sub(1), inner[1].wrapping_sub(y), z.wrapping_sub(1)];
        (0..3).all(|k| at[k] < inner[k]) && cave[lattice.at(at)]
    };
    let quads = polygonise(size, |at| !is_cave(at));
    let Bounds { low, .. } = ground.bounding_box();
    let side = lattice.sides();
    let at = |v: [f64; 3]| std::array::from_fn(|k| low[k] + (v[k] - 1.0) * side[k]);
    let lattice_points = smooth(&quads, size, rounds, nets);
    // The outside of that layer is no part of the cave.
    let is_out = |i: u32| (0..3).any(|k| [0.0, size[k] as f64].contains(&lattice_points[i as usize][k]));
    let (mut number, mut points, mut triangles) = (vec![u32::MAX; lattice_points.len()], Vec::new(), Vec::new());
    for triangle in quads.triangles().into_iter().filter(|t| !t.iter().any(|&i| is_out(i))) {
        triangles.push(triangle.map(|i| {
            let new = &mut number[i as usize];
            if *new == u32::MAX {
                *new = points.len() as u32;
                points.push(at(lattice_points[i as usize]));
            }
            *new
        }));
    }
    MeshFile { points, triangles, middle: None, texture: None, fields: Vec::new() }
}

/// Two triangles a cell of a raster; holes stay open.
pub fn mesh_file_from_height_field(field: &HeightField) -> MeshFile {
    let (points, triangles) = mesh_parts_from_height_field(field);
    MeshFile { points, triangles, middle: Some(middle(field)), texture: None, fields: Vec::new() }
}

/// The surface of the water on a raster where it is at least `least` metres deep, by its field of
/// depth.
///
/// # Errors
/// If the terrain lacks that field, or has no water.
pub fn mesh_file_of_water(field: &HeightField, least: f64) -> Result<MeshFile> {
    let depth = field.fields().get(&names::WATER_DEPTH, "the surface of the water")?;
    let surface = |i: usize| if depth[i] >= least { field.elevation()[i] + depth[i] } else { f64::NAN };
    let surface: Vec<f64> = (0..depth.len()).map(surface).collect();
    if surface.iter().all(|z| z.is_nan()) {
        return Err(Error::Empty { what: "the water".into() });
    }
    let (points, triangles) = mesh_parts_from_height_field(&HeightField::new(field.grid().clone(), surface)?);
    if triangles.is_empty() {
        return Err(Error::NoFace { what: "the sheet of water" });
    }
    Ok(MeshFile { points, triangles, middle: Some(middle(field)), texture: None, fields: Vec::new() })
}

fn middle(field: &HeightField) -> [f64; 2] {
    let [lo, hi] = field.bounds();
    [0.5 * (lo[0] + hi[0]), 0.5 * (lo[1] + hi[1])]
}

impl MeshFile {
    /// The surface with as few nodes as its nodes allow, of which none lies farther from it than
    /// `tolerance`, above or below, m; and how far the farthest does.
    pub(crate) fn decimated(&self, tolerance: f64) -> (Self, f64) {
        let thin = decimate(&self.points, &self.triangles, tolerance);
        let texture = self.texture.as_ref().map(|texture| Texture {
            places: thin.kept.iter().map(|&i| texture.places[i as usize]).collect(),
            png: texture.png.clone(),
        });
        let points = thin.kept.iter().map(|&i| self.points[i as usize]).collect();
        let picked = |field: &PointField| PointField {
            values: thin.kept.iter().map(|&i| field.values[i as usize]).collect(),
            ..field.clone()
        };
        let fields = self.fields.iter().map(picked).collect();
        (Self { points, triangles: thin.triangles, middle: self.middle, texture, fields }, thin.error)
    }

    /// The ground as a watertight body: walls along every edge that has one triangle only, and a
    /// level floor `thickness` metres under the lowest point.
    pub fn solid(mut self, thickness: f64) -> Self {
        let floor = self.points.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min) - thickness;
        let n = self.points.len() as u32;
        let top = self.triangles.len();
        let edges: HashSet<(u32, u32)> =
            self.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect();
        for k in 0..top {
            let [a, b, c] = self.triangles[k];
            // The ground's side is on the left of a rim edge, the outside on its right.
            for (a, b) in [(a, b), (b, c), (c, a)] {
                if !edges.contains(&(b, a)) {
                    self.triangles.extend([[a, a + n, b + n], [a, b + n, b]]);
                }
            }
            self.triangles.push([c + n, b + n, a + n]);
        }
        self.points.extend_from_within(..);
        self.points[n as usize..].iter_mut().for_each(|p| p[2] = floor);
        if let Some(texture) = &mut self.texture {
            texture.places.extend_from_within(..);
        }
        self.fields.iter_mut().for_each(|field| field.values.extend_from_within(..));
        self
    }

    /// Middle of the bounding box: what is subtracted where only 32-bit numbers are stored, so that
    /// large coordinates keep their centimetres.
    pub(super) fn centre(&self) -> [f64; 3] {
        let mut centre = [0.0; 3];
        if let Some([x, y]) = self.middle {
            return [x, y, 0.0];
        }
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
    pub(crate) fn normals(&self) -> Vec<[f32; 3]> {
        let mut normals = vec![[0.0_f64; 3]; self.points.len()];
        for t in &self.triangles {
            let n = across(t.map(|i| self.points[i as usize]));
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
        unit(across(triangle.map(|i| self.points[i as usize])))
    }
}

/// Twice the area of a triangle, across it.
fn across([a, b, c]: [Vector; 3]) -> Vector {
    cross(sub(b, a), sub(c, a))
}

fn unit(v: [f64; 3]) -> [f32; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    if length > 0.0 { v.map(|x| (x / length) as f32) } else { [0.0, 0.0, 1.0] }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};

    use super::*;

    #[test]
    fn a_solid_is_closed_and_has_the_volume_under_the_ground() {
        let n = 9;
        let mut z: Vec<f64> = (0..n * n).map(|i| (i % 7) as f64).collect();
        z[4 * n + 4] = f64::NAN;
        let field = HeightField::new(Grid::new(Shape::new(n, n), [2.0, 2.0]).unwrap(), z).unwrap();
        let surface = mesh_file_from_height_field(&field);
        let prism = |t: &[u32; 3]| {
            let mean = t.iter().map(|&i| surface.points[i as usize][2]).sum::<f64>() / 3.0;
            0.5 * across(t.map(|i| surface.points[i as usize]))[2] * (mean + 5.0)
        };
        let expected: f64 = surface.triangles.iter().map(prism).sum();
        let body = surface.clone().solid(5.0);
        let mut edges = std::collections::HashMap::new();
        for &[a, b, c] in &body.triangles {
            for e in [(a, b), (b, c), (c, a)] {
                *edges.entry(e).or_insert(0) += 1;
            }
        }
        assert!(edges.iter().all(|(&(a, b), &count)| count == 1 && edges.get(&(b, a)) == Some(&1)));
        let volume: f64 = body
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| body.points[i as usize]);
                let d = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
                (a[0] * d[0] + a[1] * d[1] + a[2] * d[2]) / 6.0
            })
            .sum();
        assert!((volume / expected - 1.0).abs() < 1e-12, "{volume} {expected}");
    }
}
