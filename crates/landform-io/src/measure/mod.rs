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

use landform_core::verb::relative_path;
use landform_core::{Error, Result};

/// Refuses a path that leaves the output folder or does not end as one of `ends`.
pub(crate) fn check_path(path: &str, ends: &[&str]) -> Result<()> {
    relative_path(path)?;
    if ends.iter().any(|e| path.to_lowercase().ends_with(e)) {
        return Ok(());
    }
    Err(Error::parameter("path", format!("\"{path}\""), &format!("a name that ends with {}", ends.join(" or "))))
}
