//! NumPy arrays: float32 (float64 on request), uint32 or uint8 on writing, by what the values are;
//! any real or integer type on reading.

mod header;

use landform_core::grid::Shape;
use landform_core::{Error, Result};

use super::geotiff::half;
use super::said::Stored;
use super::{DataType, RasterFile, Samples, Sidecar, check_dimensions};
use header::Header;

const NAME: &str = "NumPy array";

pub(super) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    let header = Header::read(bytes)?;
    let shape = shape(&header, bytes)?;
    let Some(kind) = &header.kind else {
        return Err(Error::Format {
            format: NAME,
            what: "its type is not a plain number".into(),
            hint: Some("save one field of it: numpy.save(path, array[\"name\"])".into()),
        });
    };
    let values = numbers(kind, shape.len(), bytes.get(header.start..).unwrap_or_default())?;
    let values = if header.is_fortran {
        (0..shape.len()).map(|i| values[(i % shape.cols) * shape.rows + i / shape.cols]).collect()
    } else {
        values
    };
    Ok(Stored::bare(shape, values))
}

/// As [`read`], without the numbers.
pub(super) fn read_header(bytes: &[u8]) -> Result<Stored> {
    let header = Header::read(bytes)?;
    let shape = shape(&header, bytes)?;
    let width = header.kind.as_ref().and_then(|kind| kind.get(kind.len().checked_sub(1)?..)?.parse().ok());
    if bytes.len().saturating_sub(header.start) < shape.len().saturating_mul(width.unwrap_or(1)) {
        return Err(Error::format(NAME, "it is truncated"));
    }
    Ok(Stored::bare(shape, Vec::new()))
}

/// Levels, rows and columns of an array of three indices, the kind of its numbers as NumPy writes
/// it, and the numbers as stored.
pub(super) fn volume(bytes: &[u8]) -> Result<([u64; 3], String, &[u8])> {
    let header = Header::read(bytes)?;
    let shape = <[u64; 3]>::try_from(header.shape);
    let shape = shape.map_err(|s| Error::format(NAME, format!("it has {} indices; expected three", s.len())))?;
    if header.is_fortran {
        return Err(Error::format(NAME, "its first index runs fastest; numpy.ascontiguousarray turns it"));
    }
    Ok((shape, header.kind.unwrap_or_default(), bytes.get(header.start..).unwrap_or_default()))
}

/// Rows and columns that a file of this length may have.
fn shape(header: &Header, bytes: &[u8]) -> Result<Shape> {
    let [rows, cols] = size(&header.shape)?;
    check_dimensions(NAME, rows, cols, 1, bytes.len())?;
    if rows * cols > bytes.len() as u64 {
        return Err(Error::format(NAME, "it is truncated"));
    }
    Ok(Shape::new(rows as usize, cols as usize))
}

/// The first `count` numbers of a plain type.
fn numbers(kind: &str, count: usize, data: &[u8]) -> Result<Vec<f64>> {
    let (is_big, name) = match kind.strip_prefix('>') {
        Some(name) => (true, name),
        None => (false, kind.trim_start_matches(['<', '|', '='])),
    };
    match name {
        "f2" => each(count, data, is_big, |b| half(u16::from_le_bytes(b))),
        "f4" => each(count, data, is_big, |b| f64::from(f32::from_le_bytes(b))),
        "f8" => each(count, data, is_big, f64::from_le_bytes),
        "b1" => each(count, data, is_big, |[b]: [u8; 1]| f64::from(u8::from(b != 0))),
        "i1" => each(count, data, is_big, |b| f64::from(i8::from_le_bytes(b))),
        "i2" => each(count, data, is_big, |b| f64::from(i16::from_le_bytes(b))),
        "i4" => each(count, data, is_big, |b| f64::from(i32::from_le_bytes(b))),
        "i8" => whole(each(count, data, is_big, |b| i128::from(i64::from_le_bytes(b)))?),
        "u1" => each(count, data, is_big, |b| f64::from(u8::from_le_bytes(b))),
        "u2" => each(count, data, is_big, |b| f64::from(u16::from_le_bytes(b))),
        "u4" => each(count, data, is_big, |b| f64::from(u32::from_le_bytes(b))),
        "u8" => whole(each(count, data, is_big, |b| i128::from(u64::from_le_bytes(b)))?),
        _ => Err(Error::Format {
            format: NAME,
            what: format!("its type {kind} is not read; expected f2 to f8, i1 to i8 or u1 to u8"),
            hint: Some("save it as one of these: numpy.save(path, array.astype(\"float32\"))".into()),
        }),
    }
}

/// `number` of the bytes of each number, least first.
fn each<const N: usize, T>(count: usize, data: &[u8], is_big: bool, number: impl Fn([u8; N]) -> T) -> Result<Vec<T>> {
    let (stored, _) = data.as_chunks::<N>();
    let stored = stored.get(..count).ok_or_else(|| Error::format(NAME, "it is truncated"))?;
    let least_first = |mut bytes: [u8; N]| {
        if is_big {
            bytes.reverse();
        }
        bytes
    };
    Ok(stored.iter().map(|bytes| number(least_first(*bytes))).collect())
}

/// Rows and columns; a further dimension before or after them, such as that of bands, may have one
/// entry.
fn size(shape: &[u64]) -> Result<[u64; 2]> {
    match shape {
        &[rows, cols] => Ok([rows, cols]),
        [1, rest @ ..] | [rest @ .., 1] if rest.len() > 1 => size(rest),
        _ => Err(Error::Format {
            format: NAME,
            what: format!("it has {} dimensions of {shape:?}; expected 2", shape.len()),
            hint: Some("save one band of it: numpy.save(path, array[0])".into()),
        }),
    }
}

/// 64-bit whole numbers, refused where a real number of double precision cannot hold them.
fn whole(values: Vec<i128>) -> Result<Vec<f64>> {
    let fail = |v: i128| Error::format(NAME, format!("{v} is too large to be read exactly"));
    values.into_iter().map(|v| if (v as f64) as i128 == v { Ok(v as f64) } else { Err(fail(v)) }).collect()
}

pub(super) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    let shape = file.grid.shape;
    let array = |kind: &str, numbers: Vec<u8>| [Header::write(kind, shape.rows, shape.cols), numbers].concat();
    let values = || file.values.iter();
    Ok(match file.samples {
        Samples::Real if file.geotiff.data_type == DataType::Float64 => {
            array("<f8", values().flat_map(|v| v.to_le_bytes()).collect())
        }
        Samples::Real => array("<f4", values().flat_map(|v| (*v as f32).to_le_bytes()).collect()),
        Samples::Counts => array("<u4", values().flat_map(|v| (*v as u32).to_le_bytes()).collect()),
        Samples::Classes => array("|u1", values().map(|v| *v as u8).collect()),
    })
}
