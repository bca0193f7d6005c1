//! What comes in from files.

mod degrees;
mod elevation_file;
mod file_maps;
mod lines;

pub use degrees::{in_degrees, metres_from_degrees};
pub use elevation_file::ElevationFile;
pub use file_maps::FileMaps;
pub use lines::{Line, lines};

landform_core::stages! {
    generate ElevationFile => landform_core::terrain::HeightField;
}
