//! Reading.

use std::io::Cursor;

use landform_core::grid::{Georeference, Grid, Registration, Shape};
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

use super::{NAME, keys};
use crate::format::{Sidecar, check_dimensions, most_unpacked};

type Reader<'a> = Decoder<Cursor<&'a [u8]>>;

pub(in crate::format) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<HeightField> {
    let fail = |e: tiff::TiffError| match e {
        tiff::TiffError::IoError(e) if e.kind() == std::io::ErrorKind::UnexpectedEof => {
            Error::format(NAME, "it ends before its data does: truncated")
        }
        e => Error::format(NAME, e),
    };
    let most = usize::try_from(most_unpacked(bytes.len())).unwrap_or(usize::MAX);
    let mut limits = Limits::default();
    limits.decoding_buffer_size = most;
    limits.intermediate_buffer_size = most;
    limits.ifd_value_size = bytes.len().max(1 << 16);
    let mut tiff = Decoder::new(Cursor::new(bytes)).map_err(fail)?.with_limits(limits);
    let (cols, rows) = tiff.dimensions().map_err(fail)?;
    check_dimensions(NAME, u64::from(rows), u64::from(cols), 1, bytes.len())?;
    let shape = Shape::new(rows as usize, cols as usize);
    let grid = grid(&mut tiff, shape)?;
    let nodata =
        tiff.get_tag_ascii_string(Tag::GdalNodata).ok().and_then(|t| t.trim_matches(['\0', ' ']).parse::<f64>().ok());
    let (scale, offset) = scale_and_offset(&mut tiff);
    let samples = to_f64(tiff.read_image().map_err(fail)?)?;
    let bands = samples.len() / shape.len();
    if bands == 0 || samples.len() % shape.len() != 0 {
        return Err(Error::format(NAME, format!("it has {} samples for {shape}", samples.len())));
    }
    // Of several bands the first; bands lie sample by sample.
    let value = |v: f64| if Some(v) == nodata || !v.is_finite() || v.abs() > 1e30 { f64::NAN } else { v };
    let narrow = |v: f64| if nodata.is_some_and(|n| f64::from(n as f32) == v) { f64::NAN } else { value(v) };
    HeightField::new(grid, samples.iter().step_by(bands).map(|&v| narrow(v) * scale + offset).collect())
}

/// GDAL's scale and offset of the first band; 1 and 0 if there are none.
fn scale_and_offset(tiff: &mut Reader) -> (f64, f64) {
    let text = tiff.get_tag_ascii_string(Tag::Unknown(42_112)).unwrap_or_default();
    let item = |role: &str| -> Option<f64> {
        let item = text.split("<Item ").find(|i| i.contains(&format!("role=\"{role}\"")))?;
        item.split('>').nth(1)?.split('<').next()?.trim().parse().ok().filter(|v: &f64| v.is_finite())
    };
    (item("scale").unwrap_or(1.0), item("offset").unwrap_or(0.0))
}

fn to_f64(samples: DecodingResult) -> Result<Vec<f64>> {
    fn all<T: Into<f64>>(values: Vec<T>) -> Vec<f64> {
        values.into_iter().map(Into::into).collect()
    }
    Ok(match samples {
        DecodingResult::U8(v) => all(v),
        DecodingResult::I8(v) => all(v),
        DecodingResult::U16(v) => all(v),
        DecodingResult::I16(v) => all(v),
        DecodingResult::U32(v) => all(v),
        DecodingResult::I32(v) => all(v),
        DecodingResult::F32(v) => all(v),
        DecodingResult::F64(v) => v,
        _ => {
            return Err(Error::format(
                NAME,
                "its sample type is not read; expected 8, 16 or 32-bit integers or 32 or 64-bit floats",
            ));
        }
    })
}

fn grid(tiff: &mut Reader, shape: Shape) -> Result<Grid> {
    let keys = tiff.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).ok();
    let georeference = keys.as_deref().map(keys::parse);
    if let Some(unit) = keys.as_deref().and_then(keys::foreign_unit) {
        return Err(Error::Format {
            format: NAME,
            what: format!("its coordinates are not in metres (unit EPSG:{unit}; 9002 and 9003 are feet)"),
            hint: Some("warp it to a system in metres first".into()),
        });
    }
    let Some((spacing, corner)) = placement(tiff)? else {
        let mut grid = Grid::new(shape, [1.0, 1.0])?;
        grid.georeference = georeference.unwrap_or_default();
        return Ok(grid);
    };
    let georeference =
        georeference.unwrap_or(Georeference { registration: Registration::Area, ..Georeference::default() });
    let mut grid = Grid::new(shape, spacing).map_err(|e| Error::format(NAME, e))?;
    let half = if georeference.registration == Registration::Area { 0.5 } else { 0.0 };
    grid.origin = [corner[0] + half * spacing[0], corner[1] - half * spacing[1]];
    grid.georeference = georeference;
    Ok(grid)
}

/// Cell size, and the position of raster coordinate (0, 0).
fn placement(tiff: &mut Reader) -> Result<Option<([f64; 2], [f64; 2])>> {
    let tag = |tiff: &mut Reader, tag| tiff.get_tag_f64_vec(tag).ok().filter(|v| v.iter().all(|x| x.is_finite()));
    let scale = tag(tiff, Tag::ModelPixelScaleTag);
    let tie = tag(tiff, Tag::ModelTiepointTag);
    if let (Some([dx, dy, ..]), Some([i, j, _, x, y, ..])) = (scale.as_deref(), tie.as_deref()) {
        return Ok(Some(([*dx, dy.abs()], [x - i * dx, y + j * dy])));
    }
    if let Some([dx, r0, _, x, r1, dy, _, y, ..]) = tag(tiff, Tag::Unknown(34_264)).as_deref() {
        if *r0 != 0.0 || *r1 != 0.0 || *dy >= 0.0 || *dx <= 0.0 {
            return Err(Error::Format {
                format: NAME,
                what: "it is rotated or flipped".into(),
                hint: Some("warp it north-up first".into()),
            });
        }
        return Ok(Some(([*dx, -dy], [*x, *y])));
    }
    Ok(None)
}
