//! The stages that tell something about a terrain, as JSON. Meshes are measured on the raster that stands for them.

mod coast;
mod dunes;
mod landscape;
mod simple;
mod summary;

pub use coast::{CoastMeasured, MeasureCoast};
pub use dunes::MeasureDunes;
pub use landscape::MeasureLandscape;
pub use simple::{
    DrainageMeasured, MeasureDrainage, MeasureHypsometry, MeasureSpectrum, MeasureSurface, SpectrumMeasured,
    SurfaceMeasured,
};
pub use summary::{MeasureSummary, Measured};

use landform_core::terrain::{HeightField, Mesh};

landform_core::stages! {
    measure MeasureSummary where HeightField, Mesh;
    measure MeasureCoast where HeightField, Mesh;
    measure MeasureDrainage where HeightField, Mesh;
    measure MeasureDunes where HeightField;
    measure MeasureHypsometry where HeightField, Mesh;
    measure MeasureLandscape where HeightField, Mesh;
    measure MeasureSpectrum where HeightField, Mesh;
    measure MeasureSurface where HeightField, Mesh;
}
