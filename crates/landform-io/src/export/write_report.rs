//! The report as a file.

use landform_core::Result;
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Drawable;
use crate::measure::check_path;
use crate::report::{Analysis, report};

/// Writes a report: one HTML file with pictures, a report card of how natural the numbers are, plots, how the landscape came to be and the
/// papers behind it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteReport {
    /// Path below the output folder.
    pub path: String,
    /// Level of the sea: ground at or under it is left out of all measures but the coast.
    pub sea_level: Option<Length>,
}

impl Default for WriteReport {
    fn default() -> Self {
        Self { path: "report.html".into(), sea_level: None }
    }
}

impl Params for WriteReport {
    const NAME: &'static str = "write_report";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        check_path(&self.path, &[".html", ".htm"])
    }
}

impl<T: Drawable> Export<T> for WriteReport {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let raster = landscape.terrain.raster()?;
        let analysis = Analysis::of(&raster, self.sea_level.map(Length::si))?;
        out.put(&self.path, report(landscape, &raster, &analysis)?.as_bytes())
    }
}
