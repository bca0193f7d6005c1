//! Everything, with the report card.

use landform_core::Result;
use landform_core::units::Length;
use landform_core::verb::{Measure, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::check_path;
use crate::export::Drawable;
use crate::report::Analysis;

/// Measures everything that the report tells, and writes it as JSON: report card, elevations, surface, drainage, spectrum, coast.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureLandscape {
    /// Path below the output folder.
    pub path: String,
    /// Level of the sea: ground at or under it is left out of all but the coast.
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

    fn check(&self) -> Result<()> {
        check_path(&self.path, &[".json"])
    }
}

impl<T: Drawable> Measure<T> for MeasureLandscape {
    type Out = Analysis;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, terrain: &T) -> Result<Analysis> {
        Analysis::of(&*terrain.raster()?, self.sea_level.map(Length::si))
    }
}
