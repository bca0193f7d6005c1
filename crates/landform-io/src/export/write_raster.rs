//! A field as a raster file.

use std::path::Path;

use landform_core::field::{Values, names};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::{Export, Landscape, Output, Params, Reach, Source, file_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{
    Compression, DataType, GeotiffOptions, RasterFile, SEEN, Samples, blurred, has_float64, raster_format,
    raster_format_to_write, sidecar_path,
};

/// Writes a field as a raster file; the extension sets the format: tif, asc, exr, npy, nc
/// (netCDF), png (16 bit), pgm, r16. Formats that do not hold scale and position get a sidecar,
/// with .landform.json after the file's name. It also says what classes mean.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteRaster {
    /// Name of the field.
    pub field: String,
    /// Path below the output folder.
    pub path: String,
    /// GeoTIFF only: type of the samples. If not given, it is float32 for real numbers (float64
    /// where that would blur them), uint32 for identifiers, uint8 for classes.
    pub data_type: Option<DataType>,
    /// GeoTIFF only: how the samples are packed.
    pub compression: Compression,
    /// GeoTIFF only: whether the file has tiles of 512 x 512 rather than strips.
    pub tiled: bool,
}

impl Default for WriteRaster {
    fn default() -> Self {
        Self {
            field: "elevation".into(),
            path: "elevation.tif".into(),
            data_type: None,
            compression: Compression::Deflate,
            tiled: true,
        }
    }
}

impl Params for WriteRaster {
    const NAME: &'static str = "write_raster";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(22)
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        let sidecar = raster_format(Path::new(&self.path)).is_ok_and(|f| f.needs_sidecar);
        std::iter::once(self.path.clone()).chain(sidecar.then(|| sidecar_path(&self.path))).collect()
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path)?;
        raster_format_to_write(Path::new(&self.path)).map(drop)
    }
}

impl Export<HeightField> for WriteRaster {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        let terrain = landscape.terrain;
        let stored = terrain.named(&self.field, "`write_raster`")?;
        let (samples, data_type) = match &*stored {
            Values::U32(_) => (Samples::Counts, DataType::Uint32),
            Values::U8(_) => (Samples::Classes, DataType::Uint8),
            _ => (Samples::Real, DataType::Float32),
        };
        let values = stored.to_f64();
        let legend = match (terrain.layers(), samples) {
            (Some(layers), Samples::Classes) if self.field == names::SURFACE_MATERIAL.name => {
                let materials = layers.materials().all().iter().enumerate();
                materials.map(|(k, m)| (k as u8, m.name.clone())).collect()
            }
            (_, Samples::Classes) if self.field == names::LABELS.name => {
                names::COAST_LABELS.iter().enumerate().map(|(k, name)| (k as u8, (*name).to_string())).collect()
            }
            _ => Vec::new(),
        };
        let format = raster_format_to_write(Path::new(&self.path))?;
        let tile = self.tiled.then_some(512);
        let mut file = RasterFile {
            grid: terrain.grid(),
            values: &values,
            field: &self.field,
            unit: names::unit_of(&self.field).unwrap_or("1"),
            samples,
            legend,
            seed: landscape.seed,
            geotiff: GeotiffOptions { data_type, compression: self.compression, tile },
            spread: None,
        };
        // What is not asked for as 32-bit floats is not blurred by them.
        let is_fine = samples == Samples::Real && has_float64(&self.path) && file.needs_float64(SEEN);
        let usual = if is_fine { DataType::Float64 } else { data_type };
        file.geotiff.data_type = self.data_type.unwrap_or(usual);
        if let Some(note) = blurred(&self.path, &file) {
            out.note(note);
        }
        let most = if file.geotiff.data_type == DataType::Float64 { f64::MAX } else { f64::from(f32::MAX) };
        if let Some(v) = values.iter().find(|v| !v.is_nan() && !(v.abs() <= most)) {
            return Err(Error::parameter(
                "field",
                format!("`{}` with a value of {v:e}", self.field),
                "values below 3.4e38, or data_type = \"float64\" in a GeoTIFF",
            ));
        }
        if values.iter().all(|v| v.is_nan()) {
            return Err(Error::Empty { what: format!("field `{}`", self.field) });
        }
        out.put(&self.path, &(format.write)(&file)?)?;
        if let Some(sidecar) = format.sidecar(&file) {
            out.put(&sidecar_path(&self.path), &sidecar.text()?)?;
        }
        Ok(())
    }
}
