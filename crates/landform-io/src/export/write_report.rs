//! The report as a file.

use landform_core::Result;
use landform_core::terrain::Rasterize;
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Source, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::report::{Analysis, report};

/// Writes a report: one HTML file with pictures, plots, a report card of how natural the numbers
/// are, the history of the landscape and the papers behind it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteReport {
    /// Path below the output folder.
    pub path: String,
    /// Sea level: ground at or under it is left out of all measures but the coast. If not given, it
    /// is the environment's; without one, nothing is left out.
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

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["html", "htm"])
    }
}

impl<T: Rasterize> Export<T> for WriteReport {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let raster = landscape.terrain.rasterized()?;
        let analysis = Analysis::of(&raster, landscape.environment.sea(self.sea_level))?;
        out.put(&self.path, report(landscape, &raster, &analysis)?.as_bytes())
    }
}
