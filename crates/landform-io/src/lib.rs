//! Bytes and pixels: file formats, pictures and reports. No physics.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@format`] | readers and writers of rasters and meshes, one file each |
//! | [`import`] | the `elevation_file` generator, maps by path |
//! | [`render`] | pictures: colour ramps, the shaded map, the perspective view |
//! | [`report`] | the one-file HTML report, the report card |
//! | [`measure`] | the stages that measure |
//! | [`export`] | the stages that write files |
//! | [`files`] | files that are written whole or not at all |
//! | [`memory`] | how much memory is left |

pub mod export;
pub mod files;
pub mod format;
pub mod import;
pub mod measure;
pub mod memory;
pub mod render;
pub mod report;
mod vector;

/// The rows of all stages that read, measure and write.
pub static STAGES: &[&[landform_core::stage::Stage]] = &[import::STAGES, measure::STAGES, export::STAGES];
