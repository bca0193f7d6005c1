//! Ground, maps and lines from files.

mod blocks;
mod degrees;
mod elevation_file;
mod file_maps;
mod lines;
mod volume_file;

pub use degrees::{in_degrees, mercator_stretch, metres_from_degrees, stretch_text};
pub use elevation_file::ElevationFile;
pub use file_maps::FileMaps;
pub use lines::{Line, lines};
pub use volume_file::VolumeFileParams;

landform_core::stages! {
    generate ElevationFile => landform_core::terrain::HeightField;
    generate VolumeFileParams => landform_core::terrain::VoxelGrid;
}
