//! The report as a file.

use landform_core::Result;
use landform_core::verb::{Export, Landscape, Output, Params, Source, relative_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Drawable;
use crate::report::report;

/// Writes a report: one HTML file with pictures, numbers, plots, how the landscape came to be and the papers behind it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteReport {
    /// Path below the output folder.
    pub path: String,
}

impl Default for WriteReport {
    fn default() -> Self {
        Self { path: "report.html".into() }
    }
}

impl Params for WriteReport {
    const NAME: &'static str = "write_report";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        relative_path(&self.path).map(drop)
    }
}

impl<T: Drawable> Export<T> for WriteReport {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let raster = landscape.terrain.raster()?;
        out.put(&self.path, report(landscape, &raster)?.as_bytes())
    }
}
