//! NumPy arrays: float32 (float64 on request), uint32 or uint8 on writing, by what the values are; any real or integer type on reading.

use landform_core::grid::Shape;
use landform_core::{Error, Result};
use npyz::{DType, Endianness, NpyFile, Order, TypeChar, WriterBuilder};

use super::geotiff::half;
use super::said::Stored;
use super::{DataType, RasterFile, Samples, Sidecar, check_dimensions};

const NAME: &str = "NumPy array";

pub(super) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    let fail = |e: std::io::Error| Error::format(NAME, e);
    let npy = NpyFile::new(bytes).map_err(fail)?;
    let [rows, cols] = size(npy.shape())?;
    check_dimensions(NAME, rows, cols, 1, bytes.len())?;
    if rows * cols > bytes.len() as u64 {
        return Err(Error::format(NAME, "it is truncated"));
    }
    let shape = Shape::new(rows as usize, cols as usize);
    let fortran = npy.order() == Order::Fortran;
    let DType::Plain(kind) = npy.dtype() else {
        return Err(Error::Format {
            format: NAME,
            what: "its type is not a plain number".into(),
            hint: Some("save one field of it: numpy.save(path, array[\"name\"])".into()),
        });
    };
    let values: Vec<f64> = match (kind.type_char(), kind.size_field()) {
        (TypeChar::Float, 2) => halves(bytes, shape, kind.endianness() == Endianness::Big)?,
        (TypeChar::Float, 4) => npy.into_vec::<f32>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Float, 8) => npy.into_vec::<f64>().map_err(fail)?,
        (TypeChar::Bool, 1) => npy.into_vec::<bool>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Int, 1) => npy.into_vec::<i8>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Int, 2) => npy.into_vec::<i16>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Int, 4) => npy.into_vec::<i32>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Int, 8) => whole(npy.into_vec::<i64>().map_err(fail)?.into_iter().map(i128::from))?,
        (TypeChar::Uint, 1) => npy.into_vec::<u8>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Uint, 2) => npy.into_vec::<u16>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Uint, 4) => npy.into_vec::<u32>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Uint, 8) => whole(npy.into_vec::<u64>().map_err(fail)?.into_iter().map(i128::from))?,
        _ => {
            return Err(Error::Format {
                format: NAME,
                what: format!("its type {kind} is not read; expected f2 to f8, i1 to i8 or u1 to u8"),
                hint: Some("save it as one of these: numpy.save(path, array.astype(\"float32\"))".into()),
            });
        }
    };
    if values.len() != shape.len() {
        return Err(Error::format(NAME, "it is truncated"));
    }
    let values = if fortran {
        (0..shape.len()).map(|i| values[(i % shape.cols) * shape.rows + i / shape.cols]).collect()
    } else {
        values
    };
    Ok(Stored::bare(shape, values))
}

/// Rows and columns; a further dimension before or after them, such as that of bands, may have one entry.
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

/// Numbers of 16 bits, which begin where the header ends.
fn halves(bytes: &[u8], shape: Shape, is_big: bool) -> Result<Vec<f64>> {
    let start = match *bytes {
        [_, _, _, _, _, _, 1, _, a, b, ..] => 10 + usize::from(u16::from_le_bytes([a, b])),
        [_, _, _, _, _, _, _, _, a, b, c, d, ..] => 12 + u32::from_le_bytes([a, b, c, d]) as usize,
        _ => bytes.len(),
    };
    let data = bytes.get(start..).and_then(|rest| rest.get(..shape.len().checked_mul(2)?));
    let data = data.ok_or_else(|| Error::format(NAME, "it is truncated"))?;
    let number = |b: &[u8]| if is_big { u16::from_be_bytes([b[0], b[1]]) } else { u16::from_le_bytes([b[0], b[1]]) };
    Ok(data.chunks_exact(2).map(|b| half(number(b))).collect())
}

/// 64-bit whole numbers, refused where a real number of double precision cannot hold them.
fn whole(values: impl Iterator<Item = i128>) -> Result<Vec<f64>> {
    let fail = |v: i128| Error::format(NAME, format!("{v} is too large to be read exactly"));
    values.map(|v| if (v as f64) as i128 == v { Ok(v as f64) } else { Err(fail(v)) }).collect()
}

pub(super) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let shape = [file.grid.shape.rows as u64, file.grid.shape.cols as u64];
    let fail = |e: std::io::Error| Error::format(NAME, e);
    fn put<T: npyz::AutoSerialize>(
        bytes: &mut Vec<u8>,
        shape: &[u64],
        values: impl Iterator<Item = T>,
    ) -> std::io::Result<()> {
        let mut writer = npyz::WriteOptions::new().default_dtype().shape(shape).writer(bytes).begin_nd()?;
        writer.extend(values)?;
        writer.finish()
    }
    let values = || file.values.iter().copied();
    match file.samples {
        Samples::Real if file.geotiff.data_type == DataType::Float64 => put(&mut bytes, &shape, values()),
        Samples::Real => put(&mut bytes, &shape, values().map(|v| v as f32)),
        Samples::Counts => put(&mut bytes, &shape, values().map(|v| v as u32)),
        Samples::Classes => put(&mut bytes, &shape, values().map(|v| v as u8)),
    }
    .map_err(fail)?;
    Ok(bytes)
}
