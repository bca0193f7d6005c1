//! The coast.

use landform_core::Result;
use landform_core::analysis::{Coast, coast};
use landform_core::terrain::{NodeSurface, Rasterize};
use landform_core::units::Length;
use landform_core::verb::{Landscape, Measure, Params, Source, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measures the coast at a level: its length, its islands, and its fractal dimension by divider and
/// boxes. Where the divider's steps span less than a decade its dimension is null, and `why` says
/// so.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureCoast {
    /// Path below the output folder.
    pub path: String,
    /// Level of the sea.
    pub level: Length,
}

impl Default for MeasureCoast {
    fn default() -> Self {
        Self { path: "coast.json".into(), level: Length::of(0.0) }
    }
}

impl Params for MeasureCoast {
    const NAME: &'static str = "measure_coast";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Mandelbrot (1967)",
        title: "How long is the coast of Britain? Statistical self-similarity and fractional dimension, Science 156",
        doi: "10.1126/science.156.3775.636",
    }];

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["json"])
    }
}

/// The coast's numbers.
pub type CoastMeasured = Coast;

impl<T: Rasterize> Measure<T> for MeasureCoast {
    type Out = CoastMeasured;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, landscape: &Landscape<'_, T>) -> Result<Coast> {
        let terrain = landscape.terrain;
        let raster = terrain.rasterized()?;
        Ok(coast(raster.grid(), raster.elevation(), self.level.si()).0)
    }
}
