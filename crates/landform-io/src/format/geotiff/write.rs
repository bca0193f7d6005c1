//! Writing.

use std::io::{Cursor, Write};

use flate2::write::ZlibEncoder;
use landform_core::grid::{Grid, Registration};
use landform_core::{Error, Result, parallel};
use tiff::encoder::{DirectoryEncoder, TiffEncoder, TiffKind};
use tiff::tags::Tag;

use super::{Compression, DataType, GeotiffOptions, NAME, fail, keys};
use crate::format::RasterFile;

/// Files from this size on are written as BigTIFF.
const CLASSIC_LIMIT: usize = 3_900_000_000;
const STRIP_ROWS: usize = 64;

pub(in crate::format) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    check_range(file)?;
    let blocks = blocks(file)?;
    let mut bytes = Cursor::new(Vec::new());
    if blocks.iter().map(Vec::len).sum::<usize>() < CLASSIC_LIMIT {
        let mut tiff = TiffEncoder::new(&mut bytes).map_err(fail)?;
        fill(tiff.image_directory().map_err(fail)?, file, &blocks).map_err(fail)?;
    } else {
        let mut tiff = TiffEncoder::new_big(&mut bytes).map_err(fail)?;
        fill(tiff.image_directory().map_err(fail)?, file, &blocks).map_err(fail)?;
    }
    Ok(bytes.into_inner())
}

/// Refuses values that the type of the samples cannot hold.
fn check_range(file: &RasterFile) -> Result<()> {
    let (lo, hi) = file.range();
    let (word, least, most) = match file.geotiff.data_type {
        DataType::Float32 | DataType::Float64 => return Ok(()),
        DataType::Int16 => ("int16", -32_767.0, 32_767.0),
        DataType::Uint32 => ("uint32", 0.0, f64::from(u32::MAX)),
        DataType::Uint8 => ("uint8", 0.0, 255.0),
    };
    if lo < least || hi > most {
        let expected = format!("values within {least} and {most}, or data_type = \"float64\"");
        return Err(Error::parameter("data_type", format!("{word} for values from {lo} to {hi}"), &expected));
    }
    if word.starts_with('u') && file.values.iter().any(|v| v.is_nan()) {
        let expected = "values everywhere, or data_type = \"float32\"";
        return Err(Error::parameter("data_type", format!("{word} for a raster with nodata"), expected));
    }
    Ok(())
}

/// Rows and columns of a block.
fn block_size(file: &RasterFile) -> (usize, usize) {
    match file.geotiff.tile {
        Some(side) => (side, side),
        None => (STRIP_ROWS.min(file.grid.shape.rows), file.grid.shape.cols),
    }
}

/// Packed tiles or strips, in order.
fn blocks(file: &RasterFile) -> Result<Vec<Vec<u8>>> {
    let shape = file.grid.shape;
    let (rows, cols) = block_size(file);
    if file.geotiff.tile.is_some_and(|t| t == 0 || t % 16 != 0) {
        return Err(Error::parameter("tile", file.geotiff.tile.unwrap_or(0), "a multiple of 16"));
    }
    let across = shape.cols.div_ceil(cols);
    let count = across * shape.rows.div_ceil(rows);
    parallel::run_all((0..count).collect(), |k| {
        let (top, left) = (k / across * rows, k % across * cols);
        // Strips end with the image, tiles are always whole.
        let height = if file.geotiff.tile.is_some() { rows } else { rows.min(shape.rows - top) };
        let at = |r: usize, c: usize| {
            let (r, c) = ((top + r).min(shape.rows - 1), (left + c).min(shape.cols - 1));
            file.values[shape.index(r, c)]
        };
        let mut bytes = Vec::with_capacity(height * cols * 8);
        for r in 0..height {
            encode_row((0..cols).map(|c| at(r, c)), file.geotiff, &mut bytes);
        }
        pack(&bytes, file.geotiff.compression)
    })
    .into_iter()
    .collect()
}

fn nodata(data_type: DataType) -> Option<f64> {
    match data_type {
        DataType::Float32 | DataType::Float64 => Some(-9999.0),
        DataType::Int16 => Some(-32_768.0),
        DataType::Uint32 | DataType::Uint8 => None,
    }
}

/// Appends one row's samples, little-endian, differenced by the predictor.
fn encode_row(values: impl Iterator<Item = f64>, options: GeotiffOptions, bytes: &mut Vec<u8>) {
    let none = nodata(options.data_type).unwrap_or(0.0);
    let predict = options.compression != Compression::None;
    match options.data_type {
        DataType::Int16 => {
            let mut last = 0i16;
            for v in values {
                let v = if v.is_finite() { v.round().clamp(-32_767.0, 32_767.0) as i16 } else { none as i16 };
                bytes.extend(if predict { v.wrapping_sub(last) } else { v }.to_le_bytes());
                last = v;
            }
        }
        DataType::Uint32 => {
            let mut last = 0u32;
            for v in values.map(|v| v as u32) {
                bytes.extend(if predict { v.wrapping_sub(last) } else { v }.to_le_bytes());
                last = v;
            }
        }
        DataType::Uint8 => {
            let mut last = 0u8;
            for v in values.map(|v| v as u8) {
                bytes.push(if predict { v.wrapping_sub(last) } else { v });
                last = v;
            }
        }
        DataType::Float32 => {
            let samples = values.map(|v| if v.is_finite() { v as f32 } else { none as f32 });
            let samples: Vec<[u8; 4]> = samples.map(f32::to_be_bytes).collect();
            encode_floats(&samples, predict, bytes);
        }
        DataType::Float64 => {
            let samples = values.map(|v| if v.is_finite() { v } else { none });
            let samples: Vec<[u8; 8]> = samples.map(f64::to_be_bytes).collect();
            encode_floats(&samples, predict, bytes);
        }
    }
}

/// Floats, most significant byte first, as a row of little-endian samples or of differences from
/// byte to byte: all most significant bytes first, and so on.
fn encode_floats<const N: usize>(samples: &[[u8; N]], predict: bool, bytes: &mut Vec<u8>) {
    let start = bytes.len();
    if !predict {
        bytes.extend(samples.iter().flat_map(|v| v.iter().rev()));
        return;
    }
    for byte in 0..N {
        bytes.extend(samples.iter().map(|v| v[byte]));
    }
    for k in (start + 1..bytes.len()).rev() {
        bytes[k] = bytes[k].wrapping_sub(bytes[k - 1]);
    }
}

fn pack(bytes: &[u8], compression: Compression) -> Result<Vec<u8>> {
    match compression {
        Compression::None => Ok(bytes.to_vec()),
        Compression::Deflate => {
            let mut encoder = ZlibEncoder::new(Vec::new(), flate2::Compression::default());
            encoder.write_all(bytes).and_then(|()| encoder.finish()).map_err(|e| Error::format(NAME, e))
        }
        Compression::Lzw => weezl::encode::Encoder::with_tiff_size_switch(weezl::BitOrder::Msb, 8)
            .encode(bytes)
            .map_err(|e| Error::format(NAME, e)),
    }
}

fn fill<K: TiffKind>(
    mut directory: DirectoryEncoder<'_, &mut Cursor<Vec<u8>>, K>,
    file: &RasterFile,
    blocks: &[Vec<u8>],
) -> tiff::TiffResult<()> {
    let (grid, options) = (file.grid, file.geotiff);
    let (rows, cols) = block_size(file);
    let mut offsets = Vec::with_capacity(blocks.len());
    for block in blocks {
        offsets.push(directory.write_data(block.as_slice())?);
    }
    let lengths: Vec<u64> = blocks.iter().map(|b| b.len() as u64).collect();
    let (bits, format, predictor) = match options.data_type {
        DataType::Float32 => (32u16, 3u16, 3u16),
        DataType::Float64 => (64, 3, 3),
        DataType::Int16 => (16, 2, 2),
        DataType::Uint32 => (32, 1, 2),
        DataType::Uint8 => (8, 1, 2),
    };
    directory.write_tag(Tag::ImageWidth, grid.shape.cols as u32)?;
    directory.write_tag(Tag::ImageLength, grid.shape.rows as u32)?;
    directory.write_tag(Tag::BitsPerSample, bits)?;
    directory.write_tag(Tag::SampleFormat, format)?;
    directory.write_tag(Tag::SamplesPerPixel, 1u16)?;
    directory.write_tag(Tag::PhotometricInterpretation, 1u16)?;
    directory.write_tag(Tag::PlanarConfiguration, 1u16)?;
    directory.write_tag(
        Tag::Compression,
        match options.compression {
            Compression::None => 1u16,
            Compression::Lzw => 5,
            Compression::Deflate => 8,
        },
    )?;
    if options.compression != Compression::None {
        directory.write_tag(Tag::Predictor, predictor)?;
    }
    let (offset_tag, length_tag) = if options.tile.is_some() {
        directory.write_tag(Tag::TileWidth, cols as u32)?;
        directory.write_tag(Tag::TileLength, rows as u32)?;
        (Tag::TileOffsets, Tag::TileByteCounts)
    } else {
        directory.write_tag(Tag::RowsPerStrip, rows as u32)?;
        (Tag::StripOffsets, Tag::StripByteCounts)
    };
    let small = |v: &[u64]| v.iter().map(|&x| x as u32).collect::<Vec<_>>();
    if offsets.last().is_none_or(|&o| o < CLASSIC_LIMIT as u64) {
        directory.write_tag(offset_tag, small(&offsets).as_slice())?;
        directory.write_tag(length_tag, small(&lengths).as_slice())?;
    } else {
        directory.write_tag(offset_tag, offsets.as_slice())?;
        directory.write_tag(length_tag, lengths.as_slice())?;
    }
    write_place(&mut directory, &grid.in_its_system())?;
    if let Some(nodata) = nodata(options.data_type) {
        directory.write_tag(Tag::GdalNodata, nodata.to_string().as_str())?;
    }
    directory.write_tag(Tag::Software, concat!("landform ", env!("CARGO_PKG_VERSION")))?;
    directory.finish()
}

fn write_place<K: TiffKind>(
    directory: &mut DirectoryEncoder<'_, &mut Cursor<Vec<u8>>, K>,
    grid: &Grid,
) -> tiff::TiffResult<()> {
    let [dx, dy] = grid.spacing;
    let keys = keys::of(&grid.georeference);
    // Without keys pixels are areas.
    let area = grid.georeference.registration == Registration::Area || keys.is_none();
    let half = if area { 0.5 } else { 0.0 };
    let corner = [grid.origin[0] - half * dx, grid.origin[1] + half * dy];
    directory.write_tag(Tag::ModelPixelScaleTag, [dx, dy, 0.0].as_slice())?;
    directory.write_tag(Tag::ModelTiepointTag, [0.0, 0.0, 0.0, corner[0], corner[1], 0.0].as_slice())?;
    let Some(keys) = keys else { return Ok(()) };
    directory.write_tag(Tag::GeoKeyDirectoryTag, keys.directory.as_slice())?;
    if !keys.numbers.is_empty() {
        directory.write_tag(Tag::GeoDoubleParamsTag, keys.numbers.as_slice())?;
    }
    if !keys.text.is_empty() {
        directory.write_tag(Tag::GeoAsciiParamsTag, keys.text.as_str())?;
    }
    Ok(())
}
