//! The surface as a file of triangles.

use std::path::Path;

use landform_core::grid::Shape;
use landform_core::terrain::{HeightField, Mesh, NodeSurface, VoxelGrid, nothing_solid};
use landform_core::units::Length;
use landform_core::verb::{Environment, Export, Landscape, Output, Params, Reach, Source, file_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{
    MeshFile, RasterFile, Texture, blurred, encode_png, mesh_file_from_height_field, mesh_file_from_mesh,
    mesh_file_from_voxels, mesh_file_of_cave, mesh_file_of_water, mesh_format,
};
use crate::measure::no_cave;
use crate::render::colour_map;

/// Surface that is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MeshSurface {
    /// The ground.
    #[default]
    Ground,
    /// The water on it, where its depth is known: a sheet that lies on rivers and lakes.
    Water,
    /// The walls of the cave in voxels, as seen from inside.
    Cave,
}

/// How the surface of voxels is made.
///
/// ```
/// use landform_io::export::{VoxelSurface, WriteMesh};
///
/// assert_eq!(WriteMesh::default().voxels, VoxelSurface::Faces);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum VoxelSurface {
    /// The faces of voxels, which enclose their volume exactly.
    #[default]
    Faces,
    /// Manifold surface nets: edges are chamfered, and parts that touch along an edge lie apart.
    SurfaceNets,
}

/// Water shallower than this is left out of its sheet, m.
const SHALLOWEST: f64 = 0.1;

/// Writes the surface as triangles in metres; the extension sets the format: glb (y up), obj, ply,
/// stl (z up).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteMesh {
    /// Path below the output folder.
    pub path: String,
    /// "ground"; "water": the surface of rivers and lakes, on a raster that knows their depth; or
    /// "cave": the walls of passages in voxels, closed, as seen from inside.
    pub surface: MeshSurface,
    /// Depth of a floor under the lowest point: with walls down to it the mesh is watertight, for
    /// printing. If not given, only the surface is written.
    #[schemars(extend("x-above" = 0.0))]
    pub solid_base: Option<Length>,
    /// Voxels only: rounds that smooth their steps and keep the volume of each body. No point moves
    /// by more than half a voxel along an axis, and those on the sides of the box stay in them. 0
    /// keeps the faces of voxels.
    #[schemars(extend("x-min" = 0, "x-max" = 100))]
    pub smoothing: u32,
    /// Voxels only: "faces", as they are; or "surface_nets", with a vertex between voxels for each
    /// part of the surface there, so that every edge has two triangles in files without numbered
    /// points too.
    pub voxels: VoxelSurface,
    /// Rasters in glb only: whether the ground's colours lie on it as a picture, without light and
    /// shadow: what grows there, rock, sand and snow, rivers, lakes and roads.
    pub texture: bool,
    /// Longer side of that picture, pixels. If not given, each side has the power of two that is
    /// nearest to the number of nodes, and 4096 at most.
    #[schemars(extend("x-min" = 16, "x-max" = 16_384))]
    pub texture_size: Option<usize>,
}

impl Default for WriteMesh {
    fn default() -> Self {
        Self {
            path: "terrain.glb".into(),
            surface: MeshSurface::Ground,
            solid_base: None,
            smoothing: 0,
            voxels: VoxelSurface::Faces,
            texture: false,
            texture_size: None,
        }
    }
}

/// Pixels along the longer side of a texture, where no other number is asked for.
const MOST_PIXELS: usize = 4096;

impl Params for WriteMesh {
    const NAME: &'static str = "write_mesh";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(if self.texture { 260 } else { 182 })
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path)?;
        if self.surface == MeshSurface::Water && self.solid_base.is_some() {
            return Err(Error::parameter("solid_base", "with the water", "no base: water is a sheet"));
        }
        if self.texture_size.is_some() && !self.texture {
            return Err(Error::Incomplete { name: "texture_size".into(), needs: "texture = true" });
        }
        if self.texture && !(self.surface == MeshSurface::Ground && self.path.to_lowercase().ends_with(".glb")) {
            let expected = "false, or the ground in a file that ends with .glb";
            return Err(Error::parameter("texture", format!("true for \"{}\"", self.path), expected));
        }
        mesh_format(Path::new(&self.path)).map(drop)
    }
}

/// The power of two nearest to a number by its ratio.
fn power_of_two(n: usize) -> usize {
    let above = n.next_power_of_two();
    if above > 1 && n * n < above * (above / 2) { above / 2 } else { above }
}

impl WriteMesh {
    /// Refuses colours for what is no raster.
    fn check_no_texture(&self, on: &str) -> Result<()> {
        if self.texture {
            let expected = "false; `to_height_field` or `uppermost_surface` make a raster, which has colours";
            return Err(Error::parameter("texture", format!("true on {on}"), expected));
        }
        Ok(())
    }

    /// The ground's colours on a mesh of all nodes of a raster that have data, in their order.
    fn texture(&self, field: &HeightField, environment: &Environment) -> Result<Texture> {
        let shape = field.grid().shape;
        let longer = shape.rows.max(shape.cols);
        let pixels = |n: usize| match self.texture_size {
            Some(size) => ((size * n) as f64 / longer as f64).round().max(1.0) as usize,
            None => power_of_two(n).min(MOST_PIXELS),
        };
        let picture = colour_map(field, Shape::new(pixels(shape.rows), pixels(shape.cols)), environment.sea(None));
        // Pixels stand over nodes: the outer ones reach half a cell beyond.
        let place = |i: usize| {
            let cell = shape.cell(i);
            let part = |k: usize, n: usize| ((k as f64 + 0.5) / n as f64) as f32;
            [part(cell.col, shape.cols), part(cell.row, shape.rows)]
        };
        let nodes = 0..field.elevation().len();
        let places = nodes.filter(|&i| !field.elevation()[i].is_nan()).map(place).collect();
        Ok(Texture { places, png: encode_png(&picture.pixels, picture.shape)? })
    }

    fn nets(&self) -> bool {
        self.voxels == VoxelSurface::SurfaceNets
    }

    /// A surface with one elevation a node has no steps.
    fn check_surface(&self) -> Result<()> {
        if self.nets() {
            return Err(Error::parameter("voxels", "\"surface_nets\" for a surface without voxels", "\"faces\""));
        }
        match self.smoothing {
            0 => Ok(()),
            given => {
                let given = format!("{given} for a surface without voxels");
                Err(Error::parameter("smoothing", given, "0"))
            }
        }
    }

    fn check_no_cave(&self) -> Result<()> {
        match self.surface {
            MeshSurface::Cave => {
                let expected = "\"ground\"; caves are in voxels, as `rock_volume` or `to_voxels` make them";
                Err(Error::parameter("surface", "\"cave\" on a surface", expected))
            }
            _ => Ok(()),
        }
    }

    fn write(&self, mesh: MeshFile, out: &mut dyn Output) -> Result<()> {
        if mesh.triangles.is_empty() {
            return Err(Error::NoFace { what: "the surface" });
        }
        let mesh = match self.solid_base {
            Some(thickness) => mesh.solid(thickness.si()),
            None => mesh,
        };
        out.put(&self.path, &(mesh_format(Path::new(&self.path))?.write)(&mesh)?)
    }
}

impl Export<Mesh> for WriteMesh {
    fn export(&self, landscape: &Landscape<'_, Mesh>, out: &mut dyn Output) -> Result<()> {
        self.check_surface()?;
        self.check_no_cave()?;
        self.check_no_texture("a mesh")?;
        if self.surface == MeshSurface::Water {
            return Err(Error::parameter(
                "surface",
                "\"water\" on a mesh",
                "\"ground\"; `to_height_field` makes a raster",
            ));
        }
        self.write(mesh_file_from_mesh(landscape.terrain), out)
    }
}

impl Export<VoxelGrid> for WriteMesh {
    fn export(&self, landscape: &Landscape<'_, VoxelGrid>, out: &mut dyn Output) -> Result<()> {
        self.check_no_texture("voxels")?;
        if self.surface == MeshSurface::Water {
            return Err(Error::parameter("surface", "\"water\" on voxels", "\"ground\" or \"cave\""));
        }
        if let Some(base) = self.solid_base {
            let expected = "none: voxels are closed all around";
            return Err(Error::parameter("solid_base", format!("{base} for voxels"), expected));
        }
        if self.surface == MeshSurface::Cave {
            let mesh = mesh_file_of_cave(landscape.terrain, self.smoothing, self.nets());
            return if mesh.triangles.is_empty() { Err(no_cave()) } else { self.write(mesh, out) };
        }
        if landscape.terrain.solids() == 0 {
            return Err(nothing_solid());
        }
        self.write(mesh_file_from_voxels(landscape.terrain, self.smoothing, self.nets()), out)
    }
}

impl Export<HeightField> for WriteMesh {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        self.check_surface()?;
        self.check_no_cave()?;
        let terrain = landscape.terrain;
        let heights = RasterFile::real(terrain.grid(), terrain.elevation(), "elevation", "m", 0);
        if let Some(note) = blurred(&self.path, &heights) {
            out.note(note);
        }
        let mut mesh = match self.surface {
            MeshSurface::Ground | MeshSurface::Cave => mesh_file_from_height_field(terrain),
            MeshSurface::Water => mesh_file_of_water(terrain, SHALLOWEST)?,
        };
        if self.texture {
            mesh.texture = Some(self.texture(terrain, landscape.environment)?);
        }
        self.write(mesh, out)
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::Grid;
    use landform_core::verb::MemoryOutput;
    use serde_json::Value;

    use super::*;

    fn hills() -> HeightField {
        let grid = Grid::new(Shape::new(24, 40), [10.0; 2]).unwrap();
        let mut z: Vec<f64> = (0..grid.len()).map(|i| f64::from((i * 7919 % 101) as u32)).collect();
        z[3] = f64::NAN;
        HeightField::new(grid, z).unwrap()
    }

    fn chunks(bytes: &[u8]) -> (Value, Vec<u8>) {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&bytes[..4], word(4), word(8)), (&b"glTF"[..], 2, bytes.len()));
        let text = word(12);
        let json = serde_json::from_slice(&bytes[20..20 + text]).unwrap();
        let data = word(20 + text);
        assert_eq!((text % 4, data % 4, 28 + text + data), (0, 0, bytes.len()));
        (json, bytes[28 + text..].to_vec())
    }

    #[test]
    fn a_texture_lies_on_the_nodes_and_every_view_fits_its_buffer() {
        let field = hills();
        for solid_base in [None, Some(Length::of(5.0))] {
            let mesh = WriteMesh { texture: true, solid_base, ..WriteMesh::default() };
            mesh.validate().unwrap();
            let mut out = MemoryOutput::default();
            mesh.export(&Landscape::plain(&field), &mut out).unwrap();
            let (json, data) = chunks(&out.0["terrain.glb"]);
            let view = |k: u64| {
                let view = &json["bufferViews"][k as usize];
                let at = view["byteOffset"].as_u64().unwrap() as usize;
                &data[at..at + view["byteLength"].as_u64().unwrap() as usize]
            };
            let primitive = &json["meshes"][0]["primitives"][0];
            let accessor = |name: &str| &json["accessors"][primitive["attributes"][name].as_u64().unwrap() as usize];
            let (points, places) = (accessor("POSITION"), accessor("TEXCOORD_0"));
            let faces = if solid_base.is_some() { 2 } else { 1 };
            assert_eq!((points["count"].as_u64(), places["count"].as_u64()), (Some(959 * faces), Some(959 * faces)));
            assert_eq!((places["type"].as_str(), places["componentType"].as_u64()), (Some("VEC2"), Some(5126)));
            let floats: Vec<f32> = view(places["bufferView"].as_u64().unwrap())
                .chunks(4)
                .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
                .collect();
            // The first node is at the north-west: to the left and at the top.
            assert_eq!(floats[..2], [0.5 / 40.0, 0.5 / 24.0]);
            assert!(floats.iter().all(|v| (0.0..=1.0).contains(v)));
            let image = &json["images"][json["textures"][0]["source"].as_u64().unwrap() as usize];
            let png = view(image["bufferView"].as_u64().unwrap());
            let info = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
            assert_eq!((info.info().width, info.info().height), (32, 32));
            assert_eq!(json["buffers"][0]["byteLength"].as_u64(), Some(data.len() as u64));
            let again = WriteMesh { path: "again.glb".into(), ..mesh };
            again.export(&Landscape::plain(&field), &mut out).unwrap();
            assert!(out.0["again.glb"] == out.0["terrain.glb"]);
        }
    }

    #[test]
    fn colours_where_there_can_be_none_are_refused() {
        let refused = |mesh: WriteMesh| mesh.validate().unwrap_err().parameter_name().map(String::from);
        let texture = || WriteMesh { texture: true, ..WriteMesh::default() };
        assert_eq!(refused(WriteMesh { path: "a.obj".into(), ..texture() }).as_deref(), Some("texture"));
        assert_eq!(refused(WriteMesh { surface: MeshSurface::Water, ..texture() }).as_deref(), Some("texture"));
        assert_eq!(
            refused(WriteMesh { texture_size: Some(64), ..WriteMesh::default() }).as_deref(),
            Some("texture_size")
        );
        assert!(WriteMesh { texture_size: Some(usize::MAX), ..texture() }.validate().is_err());
    }
}
