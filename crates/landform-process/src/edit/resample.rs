//! Another cell size.

use landform_core::Result;
use landform_core::terrain::{HeightField, Interpolation, resample};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit, Estimate, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Puts the same ground on another raster: interpolated where cells shrink, averaged where they
/// grow.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Resample {
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub cell_size: Length,
    /// How elevations between nodes are found, where cells shrink.
    pub interpolation: Interpolation,
}

impl Default for Resample {
    fn default() -> Self {
        Self { cell_size: Length::of(30.0), interpolation: Interpolation::Linear }
    }
}

impl Params for Resample {
    const NAME: &'static str = "resample";
    const SOURCES: &'static [Source] = &[];
}

impl Edit<HeightField> for Resample {
    fn edit(&self, terrain: &mut HeightField, _: &Context) -> Result<()> {
        *terrain = resample(terrain, &terrain.grid().with_cell_size(self.cell_size.si())?, self.interpolation)?;
        Ok(())
    }

    fn estimate(&self, before: Estimate) -> Estimate {
        let nodes = before.raster_nodes(self.cell_size.si());
        Estimate { nodes, bytes: (before.nodes + nodes) * 50, ..before }
    }
}
