//! PNG and PNM: 16-bit grey heights, grey maps, and colour pictures.

use std::io::Cursor;

use image::{ColorType, ImageEncoder, ImageFormat, ImageReader};
use landform_core::grid::Shape;
use landform_core::terrain::HeightField;
use landform_core::verb::Image;
use landform_core::{Error, Result};

use super::raw16::quantize;
use super::{RasterFile, Samples, Sidecar, check_dimensions};

fn name(format: ImageFormat) -> &'static str {
    if format == ImageFormat::Png { "PNG" } else { "PNM" }
}

/// Grey samples as stored (0..=255 or 0..=65535), and the greatest possible one.
fn decode(bytes: &[u8], format: ImageFormat) -> Result<(Shape, Vec<u16>, f64)> {
    let name = name(format);
    let fail = |e: image::ImageError| Error::format(name, e);
    let reader = || ImageReader::with_format(Cursor::new(bytes), format);
    let (width, height) = reader().into_dimensions().map_err(fail)?;
    check_dimensions(name, u64::from(height), u64::from(width), 1, bytes.len())?;
    let mut reader = reader();
    let mut limits = image::Limits::default();
    limits.max_alloc = Some(super::most_unpacked(bytes.len()).saturating_mul(8));
    reader.limits(limits);
    let picture = reader.decode().map_err(fail)?;
    let deep = picture.color().bytes_per_pixel() / picture.color().channel_count() > 1;
    let shape = Shape::new(height as usize, width as usize);
    if deep {
        Ok((shape, picture.into_luma16().into_raw(), 65_535.0))
    } else {
        Ok((shape, picture.into_luma8().into_raw().into_iter().map(u16::from).collect(), 255.0))
    }
}

/// Reads a picture as grey, 0 black to 1 white.
///
/// # Errors
/// [`Error::Format`].
pub fn read_grey(bytes: &[u8]) -> Result<Image> {
    let format = if bytes.starts_with(b"P") { ImageFormat::Pnm } else { ImageFormat::Png };
    let (shape, samples, white) = decode(bytes, format)?;
    Ok(Image {
        rows: shape.rows,
        cols: shape.cols,
        values: samples.into_iter().map(|v| f64::from(v) / white).collect(),
    })
}

fn read(bytes: &[u8], sidecar: Option<&Sidecar>, format: ImageFormat) -> Result<HeightField> {
    let (shape, samples, _) = decode(bytes, format)?;
    let values = Sidecar::values(sidecar, samples.into_iter().map(f64::from));
    HeightField::new(Sidecar::grid(sidecar, shape)?, values)
}

pub(super) fn read_png(bytes: &[u8], sidecar: Option<&Sidecar>) -> Result<HeightField> {
    read(bytes, sidecar, ImageFormat::Png)
}

pub(super) fn read_pnm(bytes: &[u8], sidecar: Option<&Sidecar>) -> Result<HeightField> {
    read(bytes, sidecar, ImageFormat::Pnm)
}

/// Classes as bytes.
fn classes(file: &RasterFile) -> Option<Vec<u8>> {
    (file.samples == Samples::Classes).then(|| file.values.iter().map(|&v| v as u8).collect())
}

pub(super) fn write_png(file: &RasterFile) -> Result<Vec<u8>> {
    if let Some(bytes) = classes(file) {
        return encode(&bytes, file.grid.shape, ColorType::L8);
    }
    let samples: Vec<u8> = quantize(file).into_iter().flat_map(u16::to_ne_bytes).collect();
    encode(&samples, file.grid.shape, ColorType::L16)
}

pub(super) fn write_pgm(file: &RasterFile) -> Result<Vec<u8>> {
    let shape = file.grid.shape;
    if let Some(classes) = classes(file) {
        return Ok([format!("P5\n{} {}\n255\n", shape.cols, shape.rows).as_bytes(), &classes].concat());
    }
    let mut bytes = format!("P5\n{} {}\n65535\n", shape.cols, shape.rows).into_bytes();
    bytes.extend(quantize(file).into_iter().flat_map(u16::to_be_bytes));
    Ok(bytes)
}

/// A picture of 8-bit red, green, blue as PNG.
///
/// # Errors
/// [`Error::Format`] if the pixels do not fit the shape.
pub fn encode_png(pixels: &[[u8; 3]], shape: Shape) -> Result<Vec<u8>> {
    encode(pixels.as_flattened(), shape, ColorType::Rgb8)
}

fn encode(samples: &[u8], shape: Shape, color: ColorType) -> Result<Vec<u8>> {
    let size = |n: usize| u32::try_from(n).map_err(|e| Error::format("PNG", e));
    let mut bytes = Vec::new();
    image::codecs::png::PngEncoder::new(&mut bytes)
        .write_image(samples, size(shape.cols)?, size(shape.rows)?, color.into())
        .map_err(|e| Error::format("PNG", e))?;
    Ok(bytes)
}
