//! PNG and PNM: 16-bit grey heights, grey maps, and colour pictures.

use std::io::Cursor;

use landform_core::grid::Shape;
use landform_core::verb::Image;
use landform_core::{Error, Result};

use super::pixels::Pixels;
use super::raw16::quantize;
use super::said::Stored;
use super::{RasterFile, Samples, Sidecar, check_dimensions, pnm};

fn decode_png(bytes: &[u8]) -> Result<Pixels> {
    let fail = |e: png::DecodingError| Error::format("PNG", e);
    let bytes_at_most = usize::try_from(super::most_unpacked(bytes.len()).saturating_mul(8)).unwrap_or(usize::MAX);
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: bytes_at_most });
    // Palettes become colours, and fewer than 8 bits are spread over 8.
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(fail)?;
    let info = reader.info();
    let (shape, bits) = (Shape::new(info.height as usize, info.width as usize), info.bit_depth as u16);
    let is_grey = matches!(info.color_type, png::ColorType::Grayscale | png::ColorType::GrayscaleAlpha);
    check_dimensions("PNG", u64::from(info.height), u64::from(info.width), 1, bytes.len())?;
    let size = reader.output_buffer_size().ok_or_else(|| Error::format("PNG", "it is too large"))?;
    let mut stored = vec![0; size];
    reader.next_frame(&mut stored).map_err(fail)?;
    let (colour, depth) = reader.output_color_type();
    let greatest = if is_grey { u16::MAX >> (16 - bits) } else { u16::MAX >> (16 - depth as u16) };
    let samples = match depth {
        png::BitDepth::Sixteen => stored.chunks_exact(2).map(|b| u16::from_be_bytes([b[0], b[1]])).collect(),
        _ => stored.into_iter().map(|b| u16::from(b) / (255 / greatest)).collect(),
    };
    let has_opacity = matches!(colour, png::ColorType::GrayscaleAlpha | png::ColorType::Rgba);
    Ok(Pixels { shape, colours: colour.samples() - usize::from(has_opacity), has_opacity, samples, greatest })
}

/// Reads a picture as grey, 0 black to 1 white.
///
/// # Errors
/// [`Error::Format`].
pub fn read_grey(bytes: &[u8]) -> Result<Image> {
    let picture = if bytes.starts_with(b"P") { pnm::read(bytes)? } else { decode_png(bytes)? };
    let white = f64::from(picture.greatest);
    let values = picture.grey().into_iter().map(|v| f64::from(v) / white).collect();
    Ok(Image { rows: picture.shape.rows, cols: picture.shape.cols, values })
}

/// Grey numbers as they are stored, masked by opacity.
fn stored(picture: &Pixels, name: &'static str) -> Result<Stored> {
    if picture.is_coloured() {
        return Err(Error::Format {
            format: name,
            what: "it is a colour picture: its colours are no elevations".into(),
            hint: Some(
                "save it as grey of 16 bits; tiles of coded colours (Terrarium, Mapbox) must be decoded first, as by gdal_calc"
                    .into(),
            ),
        });
    }
    let samples = picture.pixels().map(|p| f64::from(p[0])).collect();
    Ok(Stored { valid: picture.visible(), ..Stored::bare(picture.shape, samples) })
}

pub(super) fn read_png(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    stored(&decode_png(bytes)?, "PNG")
}

pub(super) fn read_pnm(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    stored(&pnm::read(bytes)?, "PNM")
}

/// Classes as bytes.
fn classes(file: &RasterFile) -> Option<Vec<u8>> {
    (file.samples == Samples::Classes).then(|| file.values.iter().map(|&v| v as u8).collect())
}

pub(super) fn write_png(file: &RasterFile) -> Result<Vec<u8>> {
    if let Some(bytes) = classes(file) {
        return encode(&bytes, file.grid.shape, png::ColorType::Grayscale, png::BitDepth::Eight);
    }
    encode_grey(&quantize(file), file.grid.shape)
}

/// Grey of 16 bits as PNG.
pub(crate) fn encode_grey(samples: &[u16], shape: Shape) -> Result<Vec<u8>> {
    let bytes: Vec<u8> = samples.iter().flat_map(|v| v.to_be_bytes()).collect();
    encode(&bytes, shape, png::ColorType::Grayscale, png::BitDepth::Sixteen)
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
/// ```
/// use landform_core::grid::Shape;
/// use landform_io::format::{encode_png, read_grey};
///
/// let bytes = encode_png(&[[0; 3], [255; 3]], Shape::new(1, 2))?;
/// assert_eq!(read_grey(&bytes)?.values, [0.0, 1.0]);
/// # Ok::<(), landform_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Format`] if the pixels do not fit the shape.
pub fn encode_png(pixels: &[[u8; 3]], shape: Shape) -> Result<Vec<u8>> {
    encode(pixels.as_flattened(), shape, png::ColorType::Rgb, png::BitDepth::Eight)
}

/// Grey of 8 bits as PNG.
pub(crate) fn encode_bytes(samples: &[u8], shape: Shape) -> Result<Vec<u8>> {
    encode(samples, shape, png::ColorType::Grayscale, png::BitDepth::Eight)
}

/// Red, green, blue and opacity of 8 bits as PNG; colours under no opacity are kept.
pub(crate) fn encode_rgba(pixels: &[[u8; 4]], shape: Shape) -> Result<Vec<u8>> {
    encode(pixels.as_flattened(), shape, png::ColorType::Rgba, png::BitDepth::Eight)
}

fn encode(samples: &[u8], shape: Shape, colour: png::ColorType, depth: png::BitDepth) -> Result<Vec<u8>> {
    let size = |n: usize| u32::try_from(n).map_err(|e| Error::format("PNG", e));
    let fail = |e: png::EncodingError| Error::format("PNG", e);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size(shape.cols)?, size(shape.rows)?);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Adaptive);
    encoder.write_header().and_then(|mut writer| writer.write_image_data(samples)).map_err(fail)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn png(colour: png::ColorType, depth: png::BitDepth, samples: &[u8]) -> Pixels {
        decode_png(&encode(samples, Shape::new(1, 2), colour, depth).unwrap()).unwrap()
    }

    #[test]
    fn numbers_stay_as_stored_whatever_their_bits() {
        let grey = png::ColorType::Grayscale;
        for (depth, samples, greatest, found) in [
            (png::BitDepth::One, &[0b0100_0000][..], 1, [0, 1]),
            (png::BitDepth::Two, &[0b0111_0000], 3, [1, 3]),
            (png::BitDepth::Four, &[0x5f], 15, [5, 15]),
            (png::BitDepth::Eight, &[7, 255], 255, [7, 255]),
            (png::BitDepth::Sixteen, &[1, 2, 0xff, 0xff], 65_535, [258, 65_535]),
        ] {
            let picture = png(grey, depth, samples);
            assert_eq!((picture.samples.as_slice(), picture.greatest), (&found[..], greatest));
        }
    }

    #[test]
    fn colours_become_luminance_and_opacity_a_mask() {
        let colours = png(png::ColorType::Rgb, png::BitDepth::Eight, &[255, 0, 0, 10, 10, 10]);
        assert!(colours.is_coloured() && stored(&colours, "PNG").is_err());
        assert_eq!(colours.grey(), [54, 10]);
        let opaque = png(png::ColorType::GrayscaleAlpha, png::BitDepth::Eight, &[9, 0, 8, 1]);
        assert_eq!(stored(&opaque, "PNG").unwrap().valid, Some(vec![false, true]));
        let clear = png(png::ColorType::Rgba, png::BitDepth::Eight, &[1, 1, 1, 0, 2, 2, 2, 0]);
        assert_eq!(stored(&clear, "PNG").unwrap().valid, None);
    }

    #[test]
    fn a_grey_picture_of_colours_is_read_as_grey() {
        let plain = pnm::read(b"P6 2 1 255\n\x07\x07\x07\x09\x09\x09").unwrap();
        assert_eq!(stored(&plain, "PNM").unwrap().samples, [7.0, 9.0]);
        let image = read_grey(b"P3 1 1 100 50 50 50").unwrap();
        assert_eq!(image.values, [0.5]);
    }
}
