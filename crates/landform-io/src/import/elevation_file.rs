//! Ground from a file.
//!
//! # Sources
//! Metres per degree: series on the WGS 84 ellipsoid (American Practical Navigator, table 7).

use std::path::Path;

use landform_core::terrain::{HeightField, resample};
use landform_core::units::Length;
use landform_core::verb::{Context, Estimate, Generator, NamedOutlets, Outlets, Params, Source};
use landform_core::{Error, Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Real ground, or any raster, from a GeoTIFF, ASCII grid, PNG, EXR, NPY or RAW16 file. Nodata stays outside of the landscape.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ElevationFile {
    /// Path of the file, relative to the recipe.
    pub path: String,
    /// Resamples to this distance between nodes; the file's own if not given.
    #[schemars(extend("x-above" = 0.0))]
    pub cell_size: Option<Length>,
    /// Takes longitude and latitude as metres at the middle latitude; without it degrees are refused, since slope and
    /// drainage need metres.
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
        Ok(())
    }
}

impl ElevationFile {
    fn read(&self, context: &Context) -> Result<HeightField> {
        let mut field = context.maps.raster(Path::new(&self.path))?;
        if in_degrees(&field) {
            if !self.degrees_to_metres {
                let value = format!("\"{}\", which is in degrees of longitude and latitude", self.path);
                return Err(Error::parameter(
                    "path",
                    value,
                    "metres; set degrees_to_metres = true, or warp it to UTM first",
                ));
            }
            to_metres(&mut field);
        }
        Ok(field)
    }
}

impl Generator<HeightField> for ElevationFile {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let mut field = self.read(context)?;
        if let Some(cell_size) = self.cell_size {
            field = resample(&field, &field.grid.with_cell_size(cell_size.si())?)?;
        }
        self.outlets.apply(&mut field, 0.0, context)?;
        Ok(field)
    }

    fn estimate(&self, context: &Context) -> Result<Estimate> {
        let field = self.read(context)?;
        let source = field.grid.len() as u64;
        let nodes = match self.cell_size {
            Some(cell_size) => field.grid.with_cell_size(cell_size.si())?.len() as u64,
            None => source,
        };
        Ok(Estimate { nodes, bytes: source * 20 + nodes * 12, extent: field.grid.extent() })
    }
}

/// Whether coordinates are degrees: said so, or no system is named and they could hardly be metres.
fn in_degrees(field: &HeightField) -> bool {
    let grid = &field.grid;
    let [x, y] = grid.origin;
    let tiny = grid.spacing[0] < 0.1 && x.abs() <= 360.0 && y.abs() <= 90.0;
    grid.georeference.geographic || (grid.georeference.epsg.is_none() && tiny)
}

fn to_metres(field: &mut HeightField) {
    let grid = &mut field.grid;
    let middle = (grid.origin[1] - 0.5 * grid.extent()[1]).to_radians();
    let c = |k: f64| math::cos(k * middle);
    let per_latitude = 111_132.92 - 559.82 * c(2.0) + 1.175 * c(4.0) - 0.0023 * c(6.0);
    let per_longitude = 111_412.84 * c(1.0) - 93.5 * c(3.0) + 0.118 * c(5.0);
    grid.spacing = [grid.spacing[0] * per_longitude, grid.spacing[1] * per_latitude];
    grid.origin = [0.0, grid.extent()[1]];
    grid.georeference = Default::default();
}
