//! PNG and PNM: 16-bit grey heights, grey maps, and colour pictures.

use std::io::Cursor;

use image::{ColorType, DynamicImage, ImageEncoder, ImageFormat, ImageReader};
use landform_core::grid::Shape;
use landform_core::verb::Image;
use landform_core::{Error, Result};

use super::raw16::quantize;
use super::said::Stored;
use super::{RasterFile, Samples, Sidecar, check_dimensions, pnm};

fn name(format: ImageFormat) -> &'static str {
    if format == ImageFormat::Png { "PNG" } else { "PNM" }
}

fn decode(bytes: &[u8], format: ImageFormat) -> Result<DynamicImage> {
    let name = name(format);
    let fail = |e: image::ImageError| Error::format(name, e);
    let reader = || ImageReader::with_format(Cursor::new(bytes), format);
    let (width, height) = reader().into_dimensions().map_err(fail)?;
    check_dimensions(name, u64::from(height), u64::from(width), 1, bytes.len())?;
    let mut reader = reader();
    let mut limits = image::Limits::default();
    limits.max_alloc = Some(super::most_unpacked(bytes.len()).saturating_mul(8));
    reader.limits(limits);
    reader.decode().map_err(fail)
}

/// Reads a picture as grey, 0 black to 1 white.
///
/// # Errors
/// [`Error::Format`].
pub fn read_grey(bytes: &[u8]) -> Result<Image> {
    let image = |shape: Shape, samples: Vec<u16>, white: f64| Image {
        rows: shape.rows,
        cols: shape.cols,
        values: samples.into_iter().map(|v| f64::from(v) / white).collect(),
    };
    if pnm::is_grey(bytes) {
        let grey = pnm::read(bytes)?;
        return Ok(image(grey.shape, grey.samples, f64::from(grey.greatest)));
    }
    let picture = decode(bytes, if bytes.starts_with(b"P") { ImageFormat::Pnm } else { ImageFormat::Png })?;
    let shape = shape(&picture);
    Ok(if is_deep(&picture) {
        image(shape, picture.into_luma16().into_raw(), 65_535.0)
    } else {
        image(shape, picture.into_luma8().into_raw().into_iter().map(u16::from).collect(), 255.0)
    })
}

fn shape(picture: &DynamicImage) -> Shape {
    Shape::new(picture.height() as usize, picture.width() as usize)
}

fn is_deep(picture: &DynamicImage) -> bool {
    picture.color().bytes_per_pixel() / picture.color().channel_count() > 1
}

/// Grey numbers as they are stored, masked by opacity.
fn read(bytes: &[u8], format: ImageFormat) -> Result<Stored> {
    let picture = decode(bytes, format)?;
    let (shape, color) = (shape(&picture), picture.color());
    let is_deep = is_deep(&picture);
    let pixels = picture.into_rgba16();
    let is_coloured = color.has_color() && pixels.pixels().any(|p| p[0] != p[1] || p[1] != p[2]);
    if is_coloured {
        return Err(Error::Format {
            format: name(format),
            what: "it is a colour picture: its colours are no elevations".into(),
            hint: Some(
                "save it as grey of 16 bits; tiles of coded colours (Terrarium, Mapbox) must be decoded first, as by gdal_calc"
                    .into(),
            ),
        });
    }
    // Fewer bits were spread over 16.
    let step = if is_deep { 1 } else { u16::MAX / greatest(bytes) };
    let samples = pixels.pixels().map(|p| f64::from(p[0] / step)).collect();
    let valid = color.has_alpha().then(|| pixels.pixels().map(|p| p[3] > 0).collect::<Vec<bool>>());
    // A picture that is nowhere opaque says nothing by it.
    let valid = valid.filter(|v| v.contains(&true));
    Ok(Stored { valid, ..Stored::bare(shape, samples) })
}

/// The greatest number of a picture of at most 8 bits: grey PNG files may have fewer.
fn greatest(bytes: &[u8]) -> u16 {
    match bytes.get(24..26) {
        Some(&[bits @ (1 | 2 | 4), 0]) if bytes.starts_with(b"\x89PNG") => (1 << bits) - 1,
        _ => 255,
    }
}

pub(super) fn read_png(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    read(bytes, ImageFormat::Png)
}

pub(super) fn read_pnm(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    if !pnm::is_grey(bytes) {
        return read(bytes, ImageFormat::Pnm);
    }
    let grey = pnm::read(bytes)?;
    Ok(Stored::bare(grey.shape, grey.samples.into_iter().map(f64::from).collect()))
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
