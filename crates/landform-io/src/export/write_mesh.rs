//! The surface as a file of triangles.

use std::path::Path;

use landform_core::Result;
use landform_core::terrain::{HeightField, Mesh};
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Source, relative_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{MeshFile, mesh_file_from_height_field, mesh_file_from_mesh, mesh_format};

/// Writes the surface as triangles; the extension says which: glb (y up), obj, ply, stl (z up), metres.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteMesh {
    /// Path below the output folder.
    pub path: String,
    /// Makes a watertight body, with walls and a floor so far under the lowest point, for printing; the surface alone if not
    /// given.
    #[schemars(extend("x-above" = 0.0))]
    pub solid_base: Option<Length>,
}

impl Default for WriteMesh {
    fn default() -> Self {
        Self { path: "terrain.glb".into(), solid_base: None }
    }
}

impl Params for WriteMesh {
    const NAME: &'static str = "write_mesh";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        relative_path(&self.path)?;
        mesh_format(Path::new(&self.path)).map(drop)
    }
}

impl WriteMesh {
    fn write(&self, mesh: MeshFile, out: &mut dyn Output) -> Result<()> {
        let mesh = match self.solid_base {
            Some(thickness) => mesh.solid(thickness.si()),
            None => mesh,
        };
        out.put(&self.path, &(mesh_format(Path::new(&self.path))?.write)(&mesh)?)
    }
}

impl Export<Mesh> for WriteMesh {
    fn export(&self, landscape: &Landscape<'_, Mesh>, out: &mut dyn Output) -> Result<()> {
        self.write(mesh_file_from_mesh(landscape.terrain), out)
    }
}

impl Export<HeightField> for WriteMesh {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        self.write(mesh_file_from_height_field(landscape.terrain), out)
    }
}
