//! The JSON file beside a raster that says what its numbers mean.

use std::collections::BTreeMap;
use std::sync::Arc;

use landform_core::grid::{Degrees, GeoKeys, Registration, Shape};
use landform_core::{Error, Result};
use serde::{Deserialize, Serialize};

use super::RasterFile;
use super::placement::Placement;
use super::said::Said;
use super::system::System;

/// Content of a sidecar. Unknown keys are ignored, so that other programs' sidecars can be read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Sidecar {
    /// Program that wrote it.
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
    /// Distance between columns, degrees.
    pub cell_deg: Option<f64>,
    /// Distance between rows, degrees, where it is another.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cell_deg_north: Option<f64>,
    /// x of the first column's samples, m (or degrees, where cells are in degrees).
    pub west: Option<f64>,
    /// y of the first row's samples, m (or degrees).
    pub north: Option<f64>,
    /// "EPSG:32611", or null.
    pub crs: Option<String>,
    /// The longitude and latitude that metres were made from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<Degrees>,
    /// The system as GeoTIFF states it, where a code does not tell it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub geo_keys: Option<GeoKeys>,
    /// Raw value that stands for nodata.
    pub nodata: Option<f64>,
    /// "north to south", or the other way.
    pub row_order: Option<String>,
    /// "little", or "big", for RAW16.
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
            || !positive(sidecar.cell_deg_north)
            || !finite(sidecar.west)
            || !finite(sidecar.north)
            || !sidecar
                .degrees
                .is_none_or(|d| d.origin.into_iter().all(f64::is_finite) && d.metres.into_iter().all(|m| m > 0.0))
            || !finite(sidecar.scale)
            || !finite(sidecar.offset)
        {
            return Err(Error::format(
                "sidecar",
                "`dx_m`, `dy_m` and `cell_deg` must be > 0, `scale`, `offset`, `west` and `north` finite, `degrees` sound",
            ));
        }
        Ok(sidecar)
    }

    /// For a raster whose samples are real numbers, or 16-bit steps over the range that is used.
    pub fn describe(file: &RasterFile, steps: Option<f64>) -> Self {
        let (min, max) = file.range();
        let grid = file.grid;
        let [dx, dy] = grid.spacing;
        let in_metres = !grid.georeference.geographic;
        // The lowest step is kept for nodata, where there is any.
        let nodata = (steps.is_some() && file.has_nodata()).then_some(0.0);
        let scale = steps.map_or(1.0, |n| (max - min) / if nodata.is_some() { n - 1.0 } else { n });
        let offset = steps.map_or(0.0, |_| if nodata.is_some() { min - scale } else { min });
        Self {
            program: Some(concat!("landform ", env!("CARGO_PKG_VERSION")).into()),
            field: Some(file.field.into()),
            unit: Some(file.unit.into()),
            value: Some("raw * scale + offset".into()),
            scale: Some(scale),
            offset: Some(offset),
            min: Some(min),
            max: Some(max),
            width: Some(grid.shape.cols),
            height: Some(grid.shape.rows),
            dx_m: in_metres.then_some(dx),
            dy_m: in_metres.then_some(dy),
            cell_deg: (!in_metres).then_some(dx),
            cell_deg_north: (!in_metres && dx != dy).then_some(dy),
            west: Some(grid.origin[0]),
            north: Some(grid.origin[1]),
            crs: grid.georeference.epsg.map(|e| format!("EPSG:{e}")),
            degrees: grid.georeference.degrees,
            geo_keys: grid.georeference.keys.as_deref().cloned(),
            nodata,
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

    /// What it says of a raster of this shape.
    ///
    /// # Errors
    /// [`Error::Format`] where it tells of another size.
    pub(super) fn said(&self, shape: Shape) -> Result<Said> {
        let (width, height) = (self.width.unwrap_or(shape.cols), self.height.unwrap_or(shape.rows));
        if (height, width) != (shape.rows, shape.cols) {
            return Err(Error::Format {
                format: "sidecar",
                what: format!(
                    "it tells of {width} x {height} samples, the file beside it has {} x {}",
                    shape.cols, shape.rows
                ),
                hint: Some("if it belongs to another file, move it away".into()),
            });
        }
        Ok(Said {
            nodata: self.nodata,
            scale: self.scale,
            offset: self.offset,
            unit: self.unit.clone(),
            placement: self.placement(shape),
            system: self.system(),
            south_first: self.row_order.as_deref().is_some_and(|o| o.starts_with("south")),
        })
    }

    fn placement(&self, shape: Shape) -> Option<Placement> {
        let dx = self.dx_m.or(self.cell_deg)?;
        let dy = if self.dx_m.is_some() { self.dy_m } else { self.cell_deg_north }.unwrap_or(dx);
        let north = self.north.unwrap_or((shape.rows - 1) as f64 * dy);
        let registration = Registration::Point;
        Some(Placement { spacing: [dx, dy], origin: [self.west.unwrap_or(0.0), north], registration })
    }

    fn system(&self) -> Option<System> {
        let epsg: Option<u16> = self.crs.as_deref().and_then(|c| c.strip_prefix("EPSG:")).and_then(|c| c.parse().ok());
        if self.dx_m.is_none() && self.cell_deg.is_none() && epsg.is_none() {
            return None;
        }
        let named = epsg.map(System::of_code).unwrap_or_default();
        Some(System {
            geographic: named.geographic || self.dx_m.is_none() && self.cell_deg.is_some(),
            unit: self.dx_m.or(self.cell_deg).map(|_| 1.0),
            keys: self.geo_keys.clone().map(Arc::new),
            degrees: self.degrees,
            ..named
        })
    }
}
