//! The raster of a generator, as a parameter.

use landform_core::Result;
use landform_core::grid::Grid;
use landform_core::units::Length;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Extent and distance between nodes of a raster.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct GridParams {
    /// Extent east and north.
    #[schemars(extend("x-above" = 0.0))]
    pub size: [Length; 2],
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub cell_size: Length,
}

impl Default for GridParams {
    fn default() -> Self {
        Self { size: [Length::of(10_240.0); 2], cell_size: Length::of(10.0) }
    }
}

impl GridParams {
    /// Keys of earlier recipes, in which a generator had both itself.
    pub const RENAMED: &'static [(&'static str, &'static str)] =
        &[("size", "grid.size"), ("cell_size", "grid.cell_size")];

    /// From an extent east and north and a distance between nodes, m.
    pub fn of(size: [f64; 2], cell_size: f64) -> Self {
        Self { size: size.map(Length::of), cell_size: Length::of(cell_size) }
    }

    /// The raster.
    ///
    /// # Errors
    /// Where [`Grid::covering`] fails.
    pub fn grid(&self) -> Result<Grid> {
        Grid::covering(self.size.map(Length::si), self.cell_size.si())
    }

    /// Refuses sizes that are not positive.
    ///
    /// # Errors
    /// Where [`Grid::covering`] fails.
    pub fn check(&self) -> Result<()> {
        self.grid().map(drop)
    }
}
