//! Ground from a map or a formula.

use landform_core::grid::Grid;
use landform_core::terrain::HeightField;
use landform_core::units::{Length, LengthDimension};
use landform_core::verb::{Context, Params, Source, Varying};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{OnGrid, generator_on_grid};

/// Ground that is painted or computed: from a picture, a raster, or a formula of x, y, u, v, r and noise().
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Surface {
    /// Extent east and north.
    #[schemars(extend("x-above" = 0.0))]
    pub size: [Length; 2],
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0))]
    pub cell_size: Length,
    /// Elevation; may vary in space.
    pub elevation: Varying<LengthDimension>,
}

impl Default for Surface {
    fn default() -> Self {
        Self { size: [Length::of(10_240.0); 2], cell_size: Length::of(10.0), elevation: Varying::default() }
    }
}

impl Params for Surface {
    const NAME: &'static str = "surface";
    const SOURCES: &'static [Source] = &[];
}

impl OnGrid for Surface {
    fn frame(&self) -> ([Length; 2], Length) {
        (self.size, self.cell_size)
    }

    fn elevations(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>> {
        let level = HeightField::new(grid.clone(), vec![0.0; grid.len()])?;
        let elevation = self.elevation.resolve("elevation", &level, context)?;
        let z = parallel::map(grid.len(), |i| elevation.at(i));
        match parallel::find_first(z.len(), |i| !z[i].is_finite()) {
            Some(node) => Err(Error::NonFinite { field: "elevation".into(), node, after: "`surface`".into() }),
            None => Ok(z),
        }
    }
}

generator_on_grid!(Surface);
