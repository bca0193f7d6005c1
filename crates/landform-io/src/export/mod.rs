//! The stages that write files.
//!
//! A NumPy array does not hold its scale and place. A sidecar holds them:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::HeightField;
//! use landform_core::verb::{Export, Landscape, MemoryOutput};
//! use landform_io::export::WriteRaster;
//!
//! let ground = HeightField::new(Grid::new(Shape::new(2, 2), [10.0, 10.0])?, vec![0.0, 1.0, 2.0, 3.0])?;
//! let write = WriteRaster { path: "ground.npy".into(), ..WriteRaster::default() };
//! let mut out = MemoryOutput::default();
//! write.export(&Landscape::plain(&ground), &mut out)?;
//! let files: Vec<&String> = out.0.keys().collect();
//! assert_eq!(files, ["ground.npy", "ground.npy.landform.json"]);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod colours;
mod geojson;
mod layout;
mod places;
mod write_contours;
mod write_features;
mod write_heightmap;
mod write_maps;
mod write_mesh;
mod write_picture;
mod write_points;
mod write_povray;
mod write_profiles;
mod write_raster;
mod write_report;
mod write_splines;
mod write_survey;
mod write_swath;
mod write_volume;
mod write_weights;
mod write_world;

pub use places::PlacePreset;
pub use write_contours::WriteContours;
pub use write_features::WriteFeatures;
pub use write_heightmap::{Preset, WriteHeightmap};
pub use write_maps::WriteMaps;
pub use write_mesh::{MeshSurface, VoxelSurface, WriteMesh};
pub use write_picture::{ViewKind, WritePicture};
pub use write_points::WritePoints;
pub use write_povray::WritePovray;
pub use write_profiles::WriteProfiles;
pub use write_raster::WriteRaster;
pub use write_report::WriteReport;
pub use write_splines::WriteSplines;
pub use write_survey::WriteSurvey;
pub use write_swath::WriteSwath;
pub use write_volume::WriteVolume;
pub use write_weights::{Bound, WeightLayer, WeightPreset, WriteWeights};
pub use write_world::{Simulator, WriteWorld};

use landform_core::terrain::{HeightField, Mesh, VoxelGrid};

landform_core::stages! {
    export WriteRaster where HeightField;
    export WriteHeightmap where HeightField;
    export WriteContours where HeightField, Mesh;
    export WriteFeatures where HeightField, Mesh;
    export WriteMaps where HeightField, Mesh;
    export WriteMesh where HeightField, Mesh, VoxelGrid;
    export WritePicture where HeightField, Mesh, VoxelGrid;
    export WritePoints where HeightField, Mesh;
    export WritePovray where HeightField, Mesh;
    export WriteProfiles where HeightField, Mesh;
    export WriteReport where HeightField, Mesh;
    export WriteSplines where HeightField, Mesh;
    export WriteSurvey where HeightField, Mesh, VoxelGrid;
    export WriteSwath where HeightField, Mesh;
    export WriteVolume where VoxelGrid;
    export WriteWeights where HeightField;
    export WriteWorld where HeightField, Mesh;
}
