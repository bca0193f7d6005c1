//! All measures, with the report card.

use landform_core::Result;
use landform_core::terrain::Rasterize;
use landform_core::units::Length;
use landform_core::verb::{Landscape, Measure, Params, Source, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::report::Analysis;

/// Measures all that the report shows, and writes it as JSON: report card, elevations, surface,
/// drainage, spectrum, coast.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureLandscape {
    /// Path below the output folder.
    pub path: String,
    /// Sea level: ground at or under it is left out of all measures but the coast. If not given, it
    /// is the environment's; without one, nothing is left out.
    pub sea_level: Option<Length>,
}

impl Default for MeasureLandscape {
    fn default() -> Self {
        Self { path: "metrics.json".into(), sea_level: None }
    }
}

impl Params for MeasureLandscape {
    const NAME: &'static str = "measure_landscape";
    const SOURCES: &'static [Source] = &[];

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["json"])
    }
}

impl<T: Rasterize> Measure<T> for MeasureLandscape {
    type Out = Analysis;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, landscape: &Landscape<'_, T>) -> Result<Analysis> {
        let terrain = landscape.terrain;
        Analysis::of(&*terrain.rasterized()?, landscape.environment.sea(self.sea_level))
    }
}
