//! A folder of maps.

use landform_core::algo::derivative::gradient;
use landform_core::algo::flow::{Flow, node_areas};
use landform_core::analysis::density;
use landform_core::terrain::{HeightField, NodeSurface, Rasterize};
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Source, file_path};
use landform_core::{Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{WriteContours, WriteFeatures};
use crate::format::{RasterFile, encode_png, raster_format};
use crate::report::{field_pictures, spectrum_picture};

/// Writes maps derived from the ground into a folder: pictures (shaded relief, slope, drainage
/// area, curvature, position, spectrum), GeoTIFFs (slope, aspect, drainage area) and GeoJSON
/// (contours, rivers, lakes, basins).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteMaps {
    /// Folder below the output folder.
    pub path: String,
    /// Sea level, at which rivers end. If not given, it is the environment's.
    pub sea_level: Option<Length>,
}

/// Files that may be written; the landscape decides which.
const FILES: &[&str] =
    &["contours.geojson", "features.geojson", "slope.tif", "aspect.tif", "drainage_area.tif", "spectrum.png"];

impl Default for WriteMaps {
    fn default() -> Self {
        Self { path: "maps".into(), sea_level: None }
    }
}

impl Params for WriteMaps {
    const NAME: &'static str = "write_maps";
    const SOURCES: &'static [Source] = &[];

    fn outputs(&self) -> Vec<String> {
        FILES.iter().map(|name| format!("{}/{name}", self.path.trim_end_matches('/'))).collect()
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path).map(drop)
    }
}

impl<T: Rasterize> Export<T> for WriteMaps {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let raster = landscape.terrain.rasterized()?;
        let at = |name: &str| format!("{}/{name}", self.path.trim_end_matches('/'));
        for (name, picture) in field_pictures(&raster)? {
            out.put(&at(&format!("{name}.png")), &encode_png(&picture.pixels, picture.shape)?)?;
        }
        if let Some((_, density)) = density(raster.grid(), raster.elevation(), true) {
            let picture = spectrum_picture(&density);
            out.put(&at("spectrum.png"), &encode_png(&picture.pixels, picture.shape)?)?;
        }
        for (field, unit, values) in rasters(&raster) {
            let path = at(&format!("{field}.tif"));
            let file = RasterFile::real(raster.grid(), &values, field, unit, landscape.seed);
            out.put(&path, &(raster_format(path.as_ref())?.write)(&file)?)?;
        }
        WriteContours { path: at("contours.geojson"), ..WriteContours::default() }.export(landscape, out)?;
        let features =
            WriteFeatures { path: at("features.geojson"), sea_level: self.sea_level, ..WriteFeatures::default() };
        features.export(landscape, out)
    }
}

/// Name, unit and values of the rasters.
fn rasters(raster: &HeightField) -> Vec<(&'static str, &'static str, Vec<f64>)> {
    let (grid, z) = (raster.grid(), raster.elevation());
    let domain = raster.domain();
    let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
    flow.route(&*domain, z, &mut area);
    parallel::update(&mut area, |i, a| *a = if z[i].is_nan() { f64::NAN } else { *a });
    vec![
        ("slope", "deg", parallel::map(z.len(), |i| math::atan(gradient(grid, z, i).slope()).to_degrees())),
        ("aspect", "deg", parallel::map(z.len(), |i| gradient(grid, z, i).aspect().to_degrees())),
        ("drainage_area", "m2", area),
    ]
}
