//! The stages that measure a terrain and write JSON. Meshes are measured on the raster made of
//! them.
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::HeightField;
//! use landform_core::verb::{Landscape, Measure};
//! use landform_io::measure::MeasureHypsometry;
//!
//! let ramp = (0..25).map(f64::from).collect();
//! let ground = HeightField::new(Grid::new(Shape::new(5, 5), [10.0, 10.0])?, ramp)?;
//! let found = MeasureHypsometry::default().measure(&Landscape::plain(&ground))?;
//! assert!((found.integral - 0.5).abs() < 1e-12);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod cave;
mod coast;
mod dunes;
mod landscape;
mod network;
mod simple;
mod summary;

pub(crate) use cave::no_cave;
pub use cave::{CaveMeasured, InletMeasured, MeasureCave};
pub use coast::{CoastMeasured, MeasureCoast};
pub use dunes::MeasureDunes;
pub use landscape::MeasureLandscape;
pub use network::MeasureNetwork;
pub use simple::{
    DrainageMeasured, MeasureDirections, MeasureDrainage, MeasureHypsometry, MeasureSpectrum, MeasureSurface,
    SpectrumMeasured, SurfaceMeasured,
};
pub use summary::{MeasureSummary, Measured};

use landform_core::terrain::{HeightField, Mesh, VoxelGrid};

landform_core::stages! {
    measure MeasureSummary where HeightField, Mesh;
    measure MeasureCave where VoxelGrid;
    measure MeasureCoast where HeightField, Mesh;
    measure MeasureDirections where HeightField, Mesh;
    measure MeasureDrainage where HeightField, Mesh;
    measure MeasureDunes where HeightField;
    measure MeasureHypsometry where HeightField, Mesh;
    measure MeasureLandscape where HeightField, Mesh;
    measure MeasureNetwork where HeightField, Mesh, VoxelGrid;
    measure MeasureSpectrum where HeightField, Mesh;
    measure MeasureSurface where HeightField, Mesh;
}
