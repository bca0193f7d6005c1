//! Ground from a map or a formula.

use landform_core::grid::Grid;
use landform_core::terrain::HeightField;
use landform_core::units::LengthDimension;
use landform_core::verb::{Context, Params, Reach, Source, Varying};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, OnGrid};

/// Ground from a picture, a raster, or a formula of x, y, u, v, r and noise().
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Surface {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Elevation; may vary in space.
    pub elevation: Varying<LengthDimension>,
}

impl Params for Surface {
    const NAME: &'static str = "surface";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[];

    fn reach(&self) -> Reach {
        self.elevation.reach()
    }
}

impl OnGrid for Surface {
    fn grid(&self) -> &GridParams {
        &self.grid
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
