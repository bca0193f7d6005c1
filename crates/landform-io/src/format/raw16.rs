//! Headless 16-bit numbers, little-endian, row-major from the north. Size and range are in the
//! sidecar alone.

use landform_core::grid::Shape;
use landform_core::{Error, Result};

use super::said::Stored;
use super::{RasterFile, Sidecar};

const NAME: &str = "RAW16";
/// Steps between the least and the greatest value.
pub(crate) const STEPS: f64 = 65_535.0;

pub(super) fn read(bytes: &[u8], sidecar: Option<&Sidecar>) -> Result<Stored> {
    let count = bytes.len() / 2;
    let side = (count as f64).sqrt().round() as usize;
    let (rows, cols) = match sidecar.and_then(|s| s.height.zip(s.width)) {
        Some(size) => size,
        None if side * side * 2 == bytes.len() => (side, side),
        None => {
            return Err(Error::Format {
                format: NAME,
                what: format!("{} bytes are not a square of 16-bit numbers", bytes.len()),
                hint: Some("put a sidecar with `width` and `height` beside it".into()),
            });
        }
    };
    if rows.checked_mul(cols).and_then(|n| n.checked_mul(2)) != Some(bytes.len()) || bytes.is_empty() {
        return Err(Error::format(NAME, format!("{} bytes are not {cols} x {rows} 16-bit numbers", bytes.len())));
    }
    let is_big = sidecar.and_then(|s| s.byte_order.as_deref()).is_some_and(|o| o.starts_with("big"));
    let number = |b: &[u8]| if is_big { u16::from_be_bytes([b[0], b[1]]) } else { u16::from_le_bytes([b[0], b[1]]) };
    Ok(Stored::bare(Shape::new(rows, cols), bytes.chunks_exact(2).map(|b| f64::from(number(b))).collect()))
}

/// The values as 16-bit steps over their range; 0 is kept for nodata, where there is any.
pub(crate) fn quantize(file: &RasterFile) -> Vec<u16> {
    let (min, max) = file.range();
    let least = if file.has_nodata() { 1.0 } else { 0.0 };
    let scale = if max > min { (STEPS - least) / (max - min) } else { 0.0 };
    let step = |v: f64| (least + (v - min) * scale).round().clamp(least, STEPS) as u16;
    file.values.iter().map(|&v| if v.is_finite() { step(v) } else { 0 }).collect()
}

pub(super) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    Ok(quantize(file).into_iter().flat_map(u16::to_le_bytes).collect())
}
