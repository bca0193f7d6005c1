//! The stages that write files.

mod geojson;
mod write_contours;
mod write_features;
mod write_heightmap;
mod write_maps;
mod write_mesh;
mod write_picture;
mod write_raster;
mod write_report;

use std::borrow::Cow;

use landform_core::Result;
use landform_core::grid::Domain;
use landform_core::terrain::{HeightField, Mesh, NodeSurface, height_field_from_mesh};

pub use write_contours::WriteContours;
pub use write_features::WriteFeatures;
pub use write_heightmap::{Preset, WriteHeightmap};
pub use write_maps::WriteMaps;
pub use write_mesh::{MeshSurface, WriteMesh};
pub use write_picture::{ViewKind, WritePicture};
pub use write_raster::WriteRaster;
pub use write_report::WriteReport;

/// What can be drawn: a raster, or something that a raster can stand for.
pub trait Drawable: NodeSurface {
    /// The raster.
    ///
    /// # Errors
    /// As [`HeightField::new`].
    fn raster(&self) -> Result<Cow<'_, HeightField>>;
}

impl Drawable for HeightField {
    fn raster(&self) -> Result<Cow<'_, HeightField>> {
        Ok(Cow::Borrowed(self))
    }
}

impl Drawable for Mesh {
    /// Cells of half the mean distance between nodes, within 2048² cells.
    fn raster(&self) -> Result<Cow<'_, HeightField>> {
        let area = self.area();
        let cell = 0.5 * (area / self.graph().len() as f64).sqrt();
        height_field_from_mesh(self, cell.max((area / (2048.0 * 2048.0)).sqrt())).map(Cow::Owned)
    }
}
