//! A field as a raster file.

use std::path::Path;

use landform_core::field::names;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::{Export, Landscape, Output, Params, Source, relative_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{Compression, DataType, GeotiffOptions, RasterFile, raster_format};

/// Writes a field as a raster file; the extension says which: tif, asc, exr, npy, png (16 bit), pgm, r16. Formats that do
/// not carry their own scale and place get a sidecar, name.landform.json.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteRaster {
    /// Name of the field.
    pub field: String,
    /// Path below the output folder.
    pub path: String,
    /// GeoTIFF only: type of the samples.
    pub data_type: DataType,
    /// GeoTIFF only: how the samples are packed.
    pub compression: Compression,
    /// GeoTIFF only: tiles of 512 x 512 rather than strips.
    pub tiled: bool,
}

impl Default for WriteRaster {
    fn default() -> Self {
        Self {
            field: "elevation".into(),
            path: "elevation.tif".into(),
            data_type: DataType::Float32,
            compression: Compression::Deflate,
            tiled: true,
        }
    }
}

impl Params for WriteRaster {
    const NAME: &'static str = "write_raster";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        relative_path(&self.path)?;
        raster_format(Path::new(&self.path)).map(drop)
    }
}

impl Export<HeightField> for WriteRaster {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        let values = if self.field == names::ELEVATION.name {
            terrain.elevation().to_vec()
        } else {
            terrain.fields.by_name(&self.field, "`write_raster`")?
        };
        let format = raster_format(Path::new(&self.path))?;
        let tile = self.tiled.then_some(512);
        let file = RasterFile {
            grid: &terrain.grid,
            values: &values,
            field: &self.field,
            unit: names::unit_of(&self.field).unwrap_or("1"),
            seed: landscape.seed,
            geotiff: GeotiffOptions { data_type: self.data_type, compression: self.compression, tile },
        };
        if let Some(v) = values.iter().find(|v| !v.is_nan() && !(v.abs() <= f64::from(f32::MAX))) {
            return Err(Error::parameter(
                "field",
                format!("`{}` with a value of {v:e}", self.field),
                "values below 3.4e38",
            ));
        }
        if values.iter().all(|v| v.is_nan()) {
            return Err(Error::Empty { what: format!("field `{}`", self.field) });
        }
        out.put(&self.path, &(format.write)(&file)?)?;
        if let Some(sidecar) = format.sidecar(&file) {
            let path = Path::new(&self.path).with_extension("landform.json");
            out.put(&path.to_string_lossy(), &sidecar.text()?)?;
        }
        Ok(())
    }
}
