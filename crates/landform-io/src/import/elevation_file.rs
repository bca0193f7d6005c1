//! Ground from a file.

use std::path::Path;
use std::sync::Arc;

use landform_core::grid::Grid;
use landform_core::terrain::{HeightField, Interpolation, resample};
use landform_core::units::Length;
use landform_core::verb::{Context, Estimate, Generator, NamedOutlets, Outlets, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::blocks::{blocks, grid_of_blocks};
use super::degrees::{check_stretch, in_degrees, metres_from_degrees};

/// Real ground, or any raster, from a GeoTIFF, ASCII grid, PNG, EXR, NPY or RAW16 file. Nodata
/// remains outside the landscape.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ElevationFile {
    /// Path of the file, relative to the recipe.
    pub path: String,
    /// Distance between nodes that the file is resampled to. If not given, it is the file's own.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub cell_size: Option<Length>,
    /// Size of the square blocks of samples whose mean becomes one node, in samples a side; without
    /// `cell_size`.
    #[schemars(extend("x-min" = 1, "x-max" = 4_096, "x-role" = "coarsening"))]
    pub coarsen: u32,
    /// How elevations between the file's samples are found, where `cell_size` is smaller than their
    /// spacing.
    pub interpolation: Interpolation,
    /// Whether longitude and latitude are converted to metres at the middle latitude. A file for
    /// which that is more than 5 % wrong is refused. Without it degrees are refused, since slope
    /// and drainage need metres.
    pub degrees_to_metres: bool,
    /// Where water leaves: "valleys" (the low points of the border, since a cut through a hillside
    /// is no river mouth), "holes" (these, and the rims of nodata inside, such as lakes that were
    /// cut out), "border", or a list of sides.
    pub outlets: Outlets,
}

impl Default for ElevationFile {
    fn default() -> Self {
        Self {
            path: String::new(),
            cell_size: None,
            coarsen: 1,
            interpolation: Interpolation::Linear,
            degrees_to_metres: false,
            outlets: Outlets::Named(NamedOutlets::Valleys),
        }
    }
}

impl Params for ElevationFile {
    const NAME: &'static str = "elevation_file";
    const SOURCES: &'static [Source] = &[];
    const INPUTS: &'static [&'static str] = &["path"];

    fn check(&self) -> Result<()> {
        if self.path.is_empty() {
            return Err(Error::parameter("path", "\"\"", "the path of an elevation file"));
        }
        if self.cell_size.is_some() && self.coarsen > 1 {
            return Err(Error::parameter("coarsen", self.coarsen, "1 where `cell_size` is given"));
        }
        Ok(())
    }
}

impl ElevationFile {
    /// The grid that the file's samples are brought to; none if they stay.
    fn target(&self, source: &Grid) -> Result<Option<Grid>> {
        match self.cell_size {
            Some(cell_size) => source.with_cell_size(cell_size.si()).map(Some),
            None if self.coarsen > 1 => grid_of_blocks(source, self.coarsen as usize).map(Some),
            None => Ok(None),
        }
    }

    /// The file's grid in metres.
    fn in_metres(&self, mut grid: Grid) -> Result<Grid> {
        if in_degrees(&grid) {
            if !self.degrees_to_metres {
                return Err(Error::InDegrees { path: self.path.clone(), convertible: true });
            }
            metres_from_degrees(&mut grid)?;
        }
        check_stretch(&grid)?;
        Ok(grid)
    }
}

impl Generator<HeightField> for ElevationFile {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let mut field = Arc::unwrap_or_clone(context.maps.raster(Path::new(&self.path))?);
        field.set_grid(self.in_metres(field.grid().clone())?)?;
        if self.cell_size.is_none() && self.coarsen > 1 {
            field = blocks(&field, self.coarsen as usize)?;
        } else if let Some(target) = self.target(field.grid())? {
            field = resample(&field, &target, self.interpolation)?;
        }
        self.outlets.apply(&mut field, 0.0, context)?;
        Ok(field)
    }

    fn estimate(&self, context: &Context) -> Result<Estimate> {
        let grid = self.in_metres(context.maps.grid(Path::new(&self.path))?)?;
        let source = grid.len() as u64;
        let nodes = self.target(&grid)?.map_or(source, |target| target.len() as u64);
        let (origin, extent) = (Some(grid.bounds()[0]), grid.extent());
        Ok(Estimate { nodes, bytes: source * 20 + nodes * 12, extent, origin, ..Estimate::default() })
    }
}
