//! The JSON file beside a raster that says what its numbers mean.

use std::collections::BTreeMap;

use landform_core::grid::{Georeference, Grid, Registration, Shape};
use landform_core::{Error, Result};
use serde::{Deserialize, Serialize};

use super::RasterFile;

/// What a sidecar says. Unknown keys are passed over, so that other programs' sidecars can be read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Sidecar {
    /// What wrote it.
    pub program: Option<String>,
    /// Name of the field.
    pub field: Option<String>,
    /// Unit of the value.
    pub unit: Option<String>,
    /// "value = raw * scale + offset".
    pub value: Option<String>,
    /// Value of one step of the raw number.
    pub scale: Option<f64>,
    /// Value of raw 0.
    pub offset: Option<f64>,
    /// Least value in the file.
    pub min: Option<f64>,
    /// Greatest value in the file.
    pub max: Option<f64>,
    /// Columns.
    pub width: Option<usize>,
    /// Rows.
    pub height: Option<usize>,
    /// Distance between columns, m.
    pub dx_m: Option<f64>,
    /// Distance between rows, m.
    pub dy_m: Option<f64>,
    /// Distance between rows and columns, degrees.
    pub cell_deg: Option<f64>,
    /// x of the first column's samples, m.
    pub west: Option<f64>,
    /// y of the first row's samples, m.
    pub north: Option<f64>,
    /// "EPSG:32611", or null.
    pub crs: Option<String>,
    /// Raw value that stands for nodata.
    pub nodata: Option<f64>,
    /// "north to south".
    pub row_order: Option<String>,
    /// "little" for RAW16.
    pub byte_order: Option<String>,
    /// "point" or "area".
    pub registration: Option<String>,
    /// Seed of the recipe.
    pub seed: Option<u64>,
    /// Names of classes by their number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub legend: Option<BTreeMap<String, String>>,
}

impl Sidecar {
    /// Reads a sidecar.
    ///
    /// # Errors
    /// [`Error::Format`].
    pub fn parse(bytes: &[u8]) -> Result<Self> {
        let sidecar: Self = serde_json::from_slice(bytes).map_err(|e| Error::format("sidecar", e))?;
        let positive = |v: Option<f64>| v.is_none_or(|v| v.is_finite() && v > 0.0);
        let finite = |v: Option<f64>| v.is_none_or(f64::is_finite);
        if !positive(sidecar.dx_m)
            || !positive(sidecar.dy_m)
            || !positive(sidecar.cell_deg)
            || !finite(sidecar.scale)
            || !finite(sidecar.offset)
        {
            return Err(Error::format(
                "sidecar",
                "`dx_m`, `dy_m` and `cell_deg` must be > 0, `scale` and `offset` finite",
            ));
        }
        Ok(sidecar)
    }

    /// For a raster whose samples are real numbers, or 16-bit steps over the range that is used.
    pub fn describe(file: &RasterFile, steps: Option<f64>) -> Self {
        let (min, max) = file.range();
        let grid = file.grid;
        Self {
            program: Some(concat!("landform ", env!("CARGO_PKG_VERSION")).into()),
            field: Some(file.field.into()),
            unit: Some(file.unit.into()),
            value: Some("raw * scale + offset".into()),
            scale: Some(steps.map_or(1.0, |n| (max - min) / n)),
            offset: Some(if steps.is_some() { min } else { 0.0 }),
            min: Some(min),
            max: Some(max),
            width: Some(grid.shape.cols),
            height: Some(grid.shape.rows),
            dx_m: Some(grid.spacing[0]),
            dy_m: Some(grid.spacing[1]),
            cell_deg: None,
            west: Some(grid.origin[0]),
            north: Some(grid.origin[1]),
            crs: grid.georeference.epsg.map(|e| format!("EPSG:{e}")),
            nodata: None,
            row_order: Some("north to south".into()),
            byte_order: Some("little".into()),
            registration: Some("point".into()),
            seed: Some(file.seed),
            legend: (!file.legend.is_empty())
                .then(|| file.legend.iter().map(|(k, name)| (k.to_string(), name.clone())).collect()),
        }
    }

    /// As text.
    ///
    /// # Errors
    /// [`Error::Format`] if it cannot be encoded.
    pub fn text(&self) -> Result<Vec<u8>> {
        serde_json::to_vec_pretty(self).map_err(|e| Error::format("sidecar", e))
    }

    /// The grid for a raster of this shape; one metre a cell without a sidecar.
    ///
    /// # Errors
    /// As [`Grid::new`].
    pub fn grid(sidecar: Option<&Self>, shape: Shape) -> Result<Grid> {
        let s = sidecar.cloned().unwrap_or_default();
        let dx = s.dx_m.or(s.cell_deg).unwrap_or(1.0);
        let mut grid = Grid::new(shape, [dx, s.dy_m.unwrap_or(dx)])?;
        grid.origin = [s.west.unwrap_or(0.0), s.north.unwrap_or(grid.origin[1])];
        let epsg = s.crs.as_deref().and_then(|c| c.strip_prefix("EPSG:")).and_then(|c| c.parse().ok());
        let geographic = s.dx_m.is_none() && (s.cell_deg.is_some() || epsg == Some(4326));
        grid.georeference = Georeference { epsg, geographic, registration: Registration::Point };
        Ok(grid)
    }

    /// The values of raw numbers; NaN for nodata.
    pub fn values(sidecar: Option<&Self>, raw: impl Iterator<Item = f64>) -> Vec<f64> {
        let (scale, offset, nodata) =
            sidecar.map_or((1.0, 0.0, None), |s| (s.scale.unwrap_or(1.0), s.offset.unwrap_or(0.0), s.nodata));
        raw.map(|r| if Some(r) == nodata { f64::NAN } else { r * scale + offset }).collect()
    }
}
