//! The surface as a file of triangles.

use std::path::Path;

use landform_core::field::names;
use landform_core::terrain::{HeightField, Mesh, NodeSurface, VoxelGrid, nothing_solid};
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Reach, Source, file_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::colours::ground_texture;
use super::layout::tile_path;
use crate::format::{
    MeshFile, PointField, RasterFile, blurred, mesh_file_from_height_field, mesh_file_from_mesh, mesh_file_from_voxels,
    mesh_file_of_cave, mesh_file_of_water, mesh_format,
};
use crate::measure::no_cave;

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
/// stl, vtk (z up), or csv: a table of the nodes alone.
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
    /// Greatest vertical distance of any node from the triangles that are written. As many nodes as
    /// can be are left out then; outlines, holes and watertight walls stay closed. If not given,
    /// all nodes are written. Surfaces only.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1e6))]
    pub max_error: Option<Length>,
    /// Levels of detail, as files name_LOD1 and so on beside the first, each with twice the error
    /// of the one before it. They need `max_error`.
    #[schemars(extend("x-min" = 1, "x-max" = 8))]
    pub levels: usize,
    /// Fields of the nodes that are written with them, such as "drainage_area" (ply, vtk, csv; the
    /// ground of rasters and meshes).
    pub fields: Vec<String>,
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
            max_error: None,
            levels: 1,
            fields: Vec::new(),
            smoothing: 0,
            voxels: VoxelSurface::Faces,
            texture: false,
            texture_size: None,
        }
    }
}

/// Bytes a node for leaving out nodes.
const DECIMATED: u64 = 170;
/// The most levels of detail.
const MOST_LEVELS: usize = 8;
impl Params for WriteMesh {
    const NAME: &'static str = "write_mesh";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        let all = if self.texture { 260 } else { 182 };
        Some(if self.max_error.is_some() { all + DECIMATED } else { all })
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        (0..self.levels.clamp(1, MOST_LEVELS)).map(|level| self.level_path(level)).collect()
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path)?;
        if self.surface == MeshSurface::Water && self.solid_base.is_some() {
            return Err(Error::parameter("solid_base", "with the water", "no base: water is a sheet"));
        }
        if self.levels > 1 && self.max_error.is_none() {
            return Err(Error::Incomplete { name: "levels".into(), needs: "max_error" });
        }
        let holds_fields = [".ply", ".vtk", ".csv"].iter().any(|end| self.path.to_lowercase().ends_with(end));
        let may_have = holds_fields && self.surface == MeshSurface::Ground;
        if !may_have && !self.fields.is_empty() {
            let expected = "none, or the ground in a file that ends with .ply, .vtk or .csv";
            return Err(Error::parameter("fields", format!("{:?}", self.fields), expected));
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

impl WriteMesh {
    /// Refuses colours for what is no raster.
    fn check_no_texture(&self, on: &str) -> Result<()> {
        if self.texture {
            let expected = "false; `to_height_field` or `uppermost_surface` make a raster, which has colours";
            return Err(Error::parameter("texture", format!("true on {on}"), expected));
        }
        Ok(())
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

    /// The fields that are asked for, at the nodes that have data.
    fn point_fields<T: NodeSurface>(&self, terrain: &T) -> Result<Vec<PointField>> {
        let z = terrain.elevation();
        let field = |name: &String| {
            let all = terrain.named(name, "`write_mesh`")?.to_f64();
            let values = all.into_iter().zip(z).filter(|(_, z)| !z.is_nan()).map(|(value, _)| value).collect();
            let unit = names::unit_of(name).unwrap_or("1").to_string();
            Ok(PointField { name: name.replace(char::is_whitespace, "_"), unit, values })
        };
        self.fields.iter().map(field).collect()
    }

    /// Voxels have more than one elevation a node.
    fn check_all_nodes(&self) -> Result<()> {
        if !self.fields.is_empty() {
            let expected = "none; `uppermost_surface` makes a raster of voxels";
            return Err(Error::parameter("fields", format!("{:?} for voxels", self.fields), expected));
        }
        match self.max_error {
            Some(error) => {
                let expected = "none; `uppermost_surface` makes a raster of voxels";
                Err(Error::parameter("max_error", format!("{error} for voxels"), expected))
            }
            None => Ok(()),
        }
    }

    fn level_path(&self, level: usize) -> String {
        if level == 0 { self.path.clone() } else { tile_path(&self.path, &format!("_LOD{level}")) }
    }

    fn write(&self, mesh: MeshFile, out: &mut dyn Output) -> Result<()> {
        if mesh.triangles.is_empty() {
            return Err(Error::NoFace { what: "the surface" });
        }
        let Some(tolerance) = self.max_error.map(Length::si) else { return self.write_level(0, mesh, out) };
        let all = mesh.points.len();
        for level in 0..self.levels {
            let (thin, error) = mesh.decimated(tolerance * f64::from(1_u32 << level));
            let (path, left) = (self.level_path(level), thin.points.len());
            out.note(format!("{path}: {left} of {all} nodes; every node lies within {error:.3} m of its triangles"));
            self.write_level(level, thin, out)?;
        }
        Ok(())
    }

    fn write_level(&self, level: usize, mesh: MeshFile, out: &mut dyn Output) -> Result<()> {
        let mesh = match self.solid_base {
            Some(thickness) => mesh.solid(thickness.si()),
            None => mesh,
        };
        out.put(&self.level_path(level), &(mesh_format(Path::new(&self.path))?.write)(&mesh)?)
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
        let fields = self.point_fields(landscape.terrain)?;
        self.write(MeshFile { fields, ..mesh_file_from_mesh(landscape.terrain) }, out)
    }
}

impl Export<VoxelGrid> for WriteMesh {
    fn export(&self, landscape: &Landscape<'_, VoxelGrid>, out: &mut dyn Output) -> Result<()> {
        self.check_no_texture("voxels")?;
        self.check_all_nodes()?;
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
        mesh.fields = self.point_fields(terrain)?;
        if self.texture {
            mesh.texture = Some(ground_texture(terrain, landscape.environment, self.texture_size)?);
        }
        self.write(mesh, out)
    }
}

#[cfg(test)]
mod tests;
