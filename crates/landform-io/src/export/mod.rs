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

pub use write_contours::WriteContours;
pub use write_features::WriteFeatures;
pub use write_heightmap::{Preset, WriteHeightmap};
pub use write_maps::WriteMaps;
pub use write_mesh::{MeshSurface, WriteMesh};
pub use write_picture::{ViewKind, WritePicture};
pub use write_raster::WriteRaster;
pub use write_report::WriteReport;

use landform_core::terrain::{HeightField, Mesh};

landform_core::stages! {
    export WriteRaster where HeightField;
    export WriteHeightmap where HeightField;
    export WriteContours where HeightField, Mesh;
    export WriteFeatures where HeightField, Mesh;
    export WriteMaps where HeightField, Mesh;
    export WriteMesh where HeightField, Mesh;
    export WritePicture where HeightField, Mesh;
    export WriteReport where HeightField, Mesh;
}
