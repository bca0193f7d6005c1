//! Level ground.

use landform_core::Result;
use landform_core::grid::Grid;
use landform_core::units::Length;
use landform_core::verb::{Context, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{OnGrid, generator_on_grid};

/// Level ground on a raster.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Flat {
    /// Extent east and north.
    #[schemars(extend("x-above" = 0.0))]
    pub size: [Length; 2],
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0))]
    pub cell_size: Length,
    /// Elevation everywhere.
    pub elevation: Length,
}

impl Default for Flat {
    fn default() -> Self {
        Self { size: [Length::of(10_240.0); 2], cell_size: Length::of(10.0), elevation: Length::of(0.0) }
    }
}

impl Params for Flat {
    const NAME: &'static str = "flat";
    const SOURCES: &'static [Source] = &[];
}

impl OnGrid for Flat {
    fn frame(&self) -> ([Length; 2], Length) {
        (self.size, self.cell_size)
    }

    fn elevations(&self, grid: &Grid, _: &Context) -> Result<Vec<f64>> {
        Ok(vec![self.elevation.si(); grid.len()])
    }
}

generator_on_grid!(Flat);
