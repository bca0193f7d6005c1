//! What comes in from files.

mod elevation_file;
mod file_maps;

pub use elevation_file::ElevationFile;
pub use file_maps::FileMaps;
