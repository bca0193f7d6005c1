//! NumPy arrays: float32, uint32 or uint8 on writing, by what the values are; any real or integer type on reading.

use landform_core::grid::Shape;
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};
use npyz::{DType, NpyFile, Order, TypeChar, WriterBuilder};

use super::{RasterFile, Samples, Sidecar, check_dimensions};

const NAME: &str = "NumPy array";

pub(super) fn read(bytes: &[u8], sidecar: Option<&Sidecar>) -> Result<HeightField> {
    let fail = |e: std::io::Error| Error::format(NAME, e);
    let npy = NpyFile::new(bytes).map_err(fail)?;
    let &[rows, cols] = npy.shape() else {
        return Err(Error::format(NAME, format!("it has {} dimensions; expected 2", npy.shape().len())));
    };
    check_dimensions(NAME, rows, cols, 1, bytes.len())?;
    if rows * cols > bytes.len() as u64 {
        return Err(Error::format(NAME, "it is truncated"));
    }
    let fortran = npy.order() == Order::Fortran;
    let DType::Plain(kind) = npy.dtype() else {
        return Err(Error::format(NAME, "its type is not a plain number"));
    };
    let values: Vec<f64> = match (kind.type_char(), kind.size_field()) {
        (TypeChar::Float, 4) => npy.into_vec::<f32>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Float, 8) => npy.into_vec::<f64>().map_err(fail)?,
        (TypeChar::Int, 2) => npy.into_vec::<i16>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Int, 4) => npy.into_vec::<i32>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Uint, 1) => npy.into_vec::<u8>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Uint, 4) => npy.into_vec::<u32>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Int, 1) => npy.into_vec::<i8>().map_err(fail)?.into_iter().map(f64::from).collect(),
        (TypeChar::Int, 8) => whole(npy.into_vec::<i64>().map_err(fail)?.into_iter().map(i128::from))?,
        (TypeChar::Uint, 8) => whole(npy.into_vec::<u64>().map_err(fail)?.into_iter().map(i128::from))?,
        (TypeChar::Uint, 2) => npy.into_vec::<u16>().map_err(fail)?.into_iter().map(f64::from).collect(),
        _ => {
            return Err(Error::format(
                NAME,
                format!("its type {kind} is not read; expected f4, f8, i1 to i8 or u1 to u8"),
            ));
        }
    };
    let shape = Shape::new(rows as usize, cols as usize);
    if values.len() != shape.len() {
        return Err(Error::format(NAME, "it is truncated"));
    }
    let values = if fortran {
        (0..shape.len()).map(|i| values[(i % shape.cols) * shape.rows + i / shape.cols]).collect()
    } else {
        values
    };
    HeightField::new(Sidecar::grid(sidecar, shape)?, Sidecar::values(sidecar, values.into_iter()))
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
        Samples::Real => put(&mut bytes, &shape, values().map(|v| v as f32)),
        Samples::Counts => put(&mut bytes, &shape, values().map(|v| v as u32)),
        Samples::Classes => put(&mut bytes, &shape, values().map(|v| v as u8)),
    }
    .map_err(fail)?;
    Ok(bytes)
}
