//! Numbers about a terrain.

use landform_core::Result;
use landform_core::analysis::{Hypsometry, SlopeArea, Summary, hypsometry, slope_area, summary};
use landform_core::terrain::{NodeSurface, Rasterize};
use landform_core::verb::{Landscape, Measure, Params, Source, file_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measures elevations, slopes, hypsometry and the slope-area relation, and writes them as JSON.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureSummary {
    /// Path below the output folder.
    pub path: String,
}

impl Default for MeasureSummary {
    fn default() -> Self {
        Self { path: "summary.json".into() }
    }
}

impl Params for MeasureSummary {
    const NAME: &'static str = "measure_summary";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Strahler (1952)",
            title: "Hypsometric (area-altitude) analysis of erosional topography, GSA Bulletin 63",
            doi: "10.1130/0016-7606(1952)63[1117:HAAOET]2.0.CO;2",
        },
        Source {
            authors: "Flint (1974)",
            title: "Stream gradient as a function of order, magnitude, and discharge, Water Resources Research 10(5)",
            doi: "10.1029/WR010i005p00969",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(73)
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path).map(drop)
    }
}

/// Results of the measure.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// Elevations and slopes.
    pub summary: Summary,
    /// Hypsometry: the area of ground at each height.
    pub hypsometry: Hypsometry,
    /// Slope against drainage area.
    pub slope_area: SlopeArea,
}

impl<T: Rasterize> Measure<T> for MeasureSummary {
    type Out = Measured;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, landscape: &Landscape<'_, T>) -> Result<Measured> {
        let terrain = landscape.terrain;
        let summary = summary(terrain);
        let least = 4.0 * summary.area / summary.nodes.max(1) as f64;
        Ok(Measured {
            hypsometry: hypsometry(terrain.rasterized()?.elevation()),
            slope_area: slope_area(terrain, least),
            summary,
        })
    }
}
