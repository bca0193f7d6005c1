//! Level ground.

use landform_core::Result;
use landform_core::grid::Grid;
use landform_core::units::Length;
use landform_core::verb::{Context, Params, Reach, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, OnGrid};

/// Level ground on a raster.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Flat {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Elevation everywhere.
    pub elevation: Length,
}

impl Default for Flat {
    fn default() -> Self {
        Self { grid: GridParams::default(), elevation: Length::of(0.0) }
    }
}

impl Params for Flat {
    const NAME: &'static str = "flat";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[];

    fn reach(&self) -> Reach {
        Reach::Point
    }
}

impl OnGrid for Flat {
    fn grid(&self) -> &GridParams {
        &self.grid
    }

    fn elevations(&self, grid: &Grid, _: &Context) -> Result<Vec<f64>> {
        Ok(vec![self.elevation.si(); grid.len()])
    }
}
