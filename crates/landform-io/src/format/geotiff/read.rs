//! Reading.

use std::io::Cursor;

use landform_core::grid::{GeoKeys, Registration, Shape};
use landform_core::{Error, Result};
use tiff::decoder::{Decoder, Limits};
use tiff::tags::Tag;

use super::blocks::Blocks;
use super::keys::Stated;
use super::{NAME, Reader, fail, metadata};
use crate::format::placement::Placement;
use crate::format::said::{Said, Stored};
use crate::format::system::System;
use crate::format::{Sidecar, check_dimensions, most_unpacked};

const TRANSFORM: Tag = Tag::Unknown(34_264);
const NUMBERS: Tag = Tag::Unknown(34_736);
const TEXT: Tag = Tag::Unknown(34_737);
const METADATA: Tag = Tag::Unknown(42_112);
/// Images of a file that are looked through for a mask.
const MOST_IMAGES: usize = 64;

pub(in crate::format) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    let mut tiff = open(bytes)?;
    let (shape, said) = header(&mut tiff, bytes)?;
    let blocks = Blocks::of(&mut tiff, bytes, shape)?;
    let absent = if said.nodata.is_some() { f64::NAN } else { 0.0 };
    let (samples, missing) = blocks.band(&mut tiff, 0, absent)?;
    let mut notes = Vec::new();
    if missing > 0 && said.nodata.is_none() {
        notes.push(format!("{missing} strips or tiles are absent and no nodata is named: taken as 0"));
    }
    let alpha = alpha_band(&mut tiff, blocks.bands);
    let others = blocks.bands - 1 - usize::from(alpha.is_some());
    if others > 0 {
        notes.push(format!("the first of {} bands is taken", others + 1));
    }
    let mut valid = match alpha {
        Some(band) => Some(blocks.band(&mut tiff, band, 0.0)?.0.into_iter().map(|a| a > 0.0).collect()),
        None => None,
    };
    if let Some(mask) = mask(&mut tiff, bytes, shape)? {
        valid = Some(mask);
    }
    Ok(Stored { shape, samples, valid, said, notes })
}

/// As [`read`], without the numbers; how they are packed is looked at.
pub(in crate::format) fn read_header(bytes: &[u8]) -> Result<Stored> {
    let mut tiff = open(bytes)?;
    let (shape, said) = header(&mut tiff, bytes)?;
    Blocks::of(&mut tiff, bytes, shape)?.check_whole()?;
    Ok(Stored { said, ..Stored::bare(shape, Vec::new()) })
}

/// Size, and what is said.
fn header(tiff: &mut Reader, bytes: &[u8]) -> Result<(Shape, Said)> {
    let shape = shape(tiff, bytes)?;
    let mut said = said(tiff, shape)?;
    if said.placement.is_none() && is_tied(tiff) {
        return Err(Error::Format {
            format: NAME,
            what: "its place is given by control points".into(),
            hint: Some("warp it by them first: gdalwarp in.tif out.tif".into()),
        });
    }
    if said.system.is_none() && is_ours(tiff) {
        said.system = Some(System::metres());
    }
    Ok((shape, said))
}

/// The mask that a file is: which of its samples are above 0.
pub(in crate::format) fn read_mask(bytes: &[u8]) -> Result<Vec<bool>> {
    let mut tiff = open(bytes)?;
    let shape = shape(&mut tiff, bytes)?;
    band_above_zero(&mut tiff, bytes, shape)
}

fn open(bytes: &[u8]) -> Result<Reader<'_>> {
    let most = usize::try_from(most_unpacked(bytes.len())).unwrap_or(usize::MAX);
    let mut limits = Limits::default();
    limits.decoding_buffer_size = most;
    limits.intermediate_buffer_size = most;
    limits.ifd_value_size = bytes.len().max(1 << 16);
    Ok(Decoder::new(Cursor::new(bytes)).map_err(fail)?.with_limits(limits))
}

fn shape(tiff: &mut Reader, bytes: &[u8]) -> Result<Shape> {
    let (cols, rows) = tiff.dimensions().map_err(fail)?;
    check_dimensions(NAME, u64::from(rows), u64::from(cols), 1, bytes.len())?;
    Ok(Shape::new(rows as usize, cols as usize))
}

fn said(tiff: &mut Reader, shape: Shape) -> Result<Said> {
    let keys = geo_keys(tiff);
    let stated = keys.as_ref().map(Stated::of);
    let registration = stated.as_ref().map_or(Registration::Area, Stated::registration);
    let nodata = tiff.get_tag_ascii_string(Tag::GdalNodata).ok();
    let bands = metadata::of_first_band(&tiff.get_tag_ascii_string(METADATA).unwrap_or_default());
    Ok(Said {
        nodata: nodata.and_then(|t| t.trim_matches(['\0', ' ']).replace(',', ".").parse().ok()),
        placement: placement(tiff, shape, registration)?,
        system: stated.as_ref().and_then(Stated::system),
        ..bands
    })
}

fn geo_keys(tiff: &mut Reader) -> Option<GeoKeys> {
    Some(GeoKeys {
        directory: tiff.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).ok()?,
        numbers: tiff.get_tag_f64_vec(NUMBERS).unwrap_or_default(),
        text: tiff.get_tag_ascii_string(TEXT).unwrap_or_default(),
    })
}

/// By cell size and one tie point, or by a matrix.
fn placement(tiff: &mut Reader, shape: Shape, registration: Registration) -> Result<Option<Placement>> {
    let mut numbers = |tag| tiff.get_tag_f64_vec(tag).ok();
    let transform = if let (Some([dx, dy, ..]), Some([i, j, _, x, y, ..])) =
        (numbers(Tag::ModelPixelScaleTag).as_deref(), numbers(Tag::ModelTiepointTag).as_deref())
    {
        [x - i * dx, *dx, 0.0, y + j * dy.abs(), 0.0, -dy.abs()]
    } else if let Some([dx, row_x, _, x, col_y, dy, _, y, ..]) = numbers(TRANSFORM).as_deref() {
        [*x, *dx, *row_x, *y, *col_y, *dy]
    } else {
        return Ok(None);
    };
    Placement::of_transform(NAME, transform, shape, registration).map(Some)
}

/// Whether several tie points say where the image lies.
fn is_tied(tiff: &mut Reader) -> bool {
    tiff.get_tag_f64_vec(Tag::ModelTiepointTag).is_ok_and(|points| points.len() > 6)
}

/// The band of opacity: the first of the extra samples that is said to be one.
fn alpha_band(tiff: &mut Reader, bands: usize) -> Option<usize> {
    let extra = tiff.find_tag_unsigned_vec::<u16>(Tag::ExtraSamples).ok()??;
    let at = extra.iter().position(|e| [1, 2].contains(e))?;
    let band = bands.checked_sub(extra.len())? + at;
    (band > 0).then_some(band)
}

/// Whether this program wrote it.
fn is_ours(tiff: &mut Reader) -> bool {
    tiff.get_tag_ascii_string(Tag::Software).is_ok_and(|text| text.starts_with("landform "))
}

/// The mask of the first image, if another image of the file is one.
fn mask<'a>(tiff: &mut Reader<'a>, bytes: &'a [u8], wanted: Shape) -> Result<Option<Vec<bool>>> {
    for _ in 0..MOST_IMAGES {
        if !tiff.more_images() || tiff.next_image().is_err() {
            break;
        }
        let subfile = tiff.find_tag_unsigned::<u32>(Tag::NewSubfileType).ok().flatten().unwrap_or(0);
        let size = tiff.dimensions().map_err(fail)?;
        // A mask of the whole image, not of a smaller copy.
        if subfile & 5 == 4 && (size.1 as usize, size.0 as usize) == (wanted.rows, wanted.cols) {
            return band_above_zero(tiff, bytes, wanted).map(Some);
        }
    }
    Ok(None)
}

fn band_above_zero<'a>(tiff: &mut Reader<'a>, bytes: &'a [u8], shape: Shape) -> Result<Vec<bool>> {
    let blocks = Blocks::of(tiff, bytes, shape)?;
    Ok(blocks.band(tiff, 0, 0.0)?.0.into_iter().map(|v| v > 0.0).collect())
}
