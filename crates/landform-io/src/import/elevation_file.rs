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

use super::degrees::{in_degrees, metres_from_degrees};

/// Real ground, or any raster, from a GeoTIFF, ASCII grid, PNG, EXR, NPY or RAW16 file. Nodata stays outside of the landscape.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ElevationFile {
    /// Path of the file, relative to the recipe.
    pub path: String,
    /// Resamples to this distance between nodes; the file's own if not given.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub cell_size: Option<Length>,
    /// Takes the mean of so many by so many samples as one; without `cell_size`.
    #[schemars(extend("x-min" = 1, "x-max" = 4_096, "x-role" = "coarsening"))]
    pub coarsen: u32,
    /// Between the file's samples, where `cell_size` is smaller than theirs.
    pub interpolation: Interpolation,
    /// Takes longitude and latitude as metres at the middle latitude (refused where that is more than 5 % wrong); without it degrees are
    /// refused, since slope and drainage need metres.
    pub degrees_to_metres: bool,
    /// Where water leaves: "valleys" (the low points of the border, since a cut through a hillside is no river mouth),
    /// "border", or a list of sides.
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
        let fewer = |n: usize| (n - 1).div_ceil(self.coarsen as usize) + 1;
        match self.cell_size {
            Some(cell_size) => source.with_cell_size(cell_size.si()).map(Some),
            None if self.coarsen > 1 => source.with_shape(fewer(source.shape.rows), fewer(source.shape.cols)).map(Some),
            None => Ok(None),
        }
    }

    fn read(&self, context: &Context) -> Result<HeightField> {
        let mut field = Arc::unwrap_or_clone(context.maps.raster(Path::new(&self.path))?);
        if in_degrees(&field) {
            if !self.degrees_to_metres {
                let value = format!("\"{}\", which is in degrees of longitude and latitude", self.path);
                return Err(Error::parameter(
                    "path",
                    value,
                    "metres; set degrees_to_metres = true, or warp it to UTM first",
                ));
            }
            metres_from_degrees(&mut field)?;
        }
        Ok(field)
    }
}

impl Generator<HeightField> for ElevationFile {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let mut field = self.read(context)?;
        if let Some(target) = self.target(field.grid())? {
            field = resample(&field, &target, self.interpolation)?;
        }
        self.outlets.apply(&mut field, 0.0, context)?;
        Ok(field)
    }

    fn estimate(&self, context: &Context) -> Result<Estimate> {
        let field = self.read(context)?;
        let source = field.grid().len() as u64;
        let nodes = self.target(field.grid())?.map_or(source, |target| target.len() as u64);
        Ok(Estimate { nodes, bytes: source * 20 + nodes * 12, extent: field.grid().extent() })
    }
}
