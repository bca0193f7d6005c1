//! Volumes as files: values of the voxels of a box.

mod nrrd;
mod vti;

use landform_core::{Error, Result};
use serde_json::Value as Json;

use super::npy;

pub(crate) use nrrd::write as write_nrrd;

/// Values of the voxels of a box, level by level from the underside, rows from the north.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct VolumeFile {
    /// Columns, rows and levels.
    pub(crate) size: [usize; 3],
    /// West, south and underside, m; and the sides of a voxel, m. None where the file has no place.
    pub(crate) place: Option<([f64; 3], [f64; 3])>,
    /// Values by name; none where the file has no names.
    pub(crate) arrays: Vec<(Option<String>, Array)>,
}

/// Values of a field.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Array {
    /// Whole numbers from 0 to 255.
    Bytes(Vec<u8>),
    /// Real numbers.
    Real(Vec<f32>),
}

const NUMPY: &str = "NumPy array";
/// Most voxels of a volume.
const MOST: u64 = u32::MAX as u64 - 1;

/// Reads a volume by the ending of its name; `beside` reads the file that describes an array.
///
/// # Errors
/// [`Error::Extension`] for another ending, [`Error::Format`] if the file is damaged.
pub(crate) fn read_volume(path: &str, bytes: &[u8], beside: impl FnOnce() -> Option<Json>) -> Result<VolumeFile> {
    match path.to_lowercase().rsplit_once('.').map_or("", |(_, end)| end) {
        "vti" => vti::read(bytes),
        "nrrd" => nrrd::read(bytes),
        "npy" => {
            let ([levels, rows, cols], kind, data) = npy::volume(bytes)?;
            let kind = kind.trim_start_matches(['<', '|']);
            let width = width(NUMPY, kind)?;
            let n = count(NUMPY, [cols, rows, levels], width, data.len())?;
            let (size, array) = ([cols, rows, levels].map(|n| n as usize), array(kind, &data[..n * width]));
            let said = beside().unwrap_or_default();
            let three = |key: &str| {
                let all: Vec<f64> = said[key].as_array()?.iter().filter_map(Json::as_f64).collect();
                <[f64; 3]>::try_from(all).ok()
            };
            let place = three("low_corner_m").zip(three("voxel_m"));
            Ok(VolumeFile { size, place, arrays: vec![(said["field"].as_str().map(String::from), array)] })
        }
        _ => Err(Error::extension("path", path, &["vti", "npy", "nrrd"])),
    }
}

/// The number of voxels, where a file of so many bytes after its head can hold them.
pub(super) fn count(name: &'static str, size: [u64; 3], width: usize, held: usize) -> Result<usize> {
    let product = size.iter().try_fold(1_u64, |a, b| a.checked_mul(*b)).filter(|n| *n <= MOST && *n > 0);
    let text = || format!("{} x {} x {} voxels", size[0], size[1], size[2]);
    match product {
        None => Err(Error::format(name, format!("it says that it has {}; expected 1 to 4.29e9 in all", text()))),
        Some(n) if n * width as u64 > held as u64 => {
            let needed = n * width as u64;
            Err(Error::format(name, format!("it is truncated: {} need {needed} bytes, and it has {held}", text())))
        }
        Some(n) => Ok(n as usize),
    }
}

/// Bytes of a number of a kind: "u1", "f4" or "f8".
pub(super) fn width(name: &'static str, kind: &str) -> Result<usize> {
    match kind {
        "u1" => Ok(1),
        "f4" => Ok(4),
        "f8" => Ok(8),
        _ => {
            let what = format!("its values are of the kind {kind}; expected bytes, float or double, little-endian");
            Err(Error::format(name, what))
        }
    }
}

/// Numbers as stored.
fn array(kind: &str, data: &[u8]) -> Array {
    let double = |b: &[u8]| b.try_into().map_or(f64::NAN, f64::from_le_bytes) as f32;
    match kind {
        "u1" => Array::Bytes(data.to_vec()),
        "f4" => Array::Real(data.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()),
        _ => Array::Real(data.chunks_exact(8).map(double).collect()),
    }
}

/// Numbers as stored in rows from the south.
pub(super) fn array_from_the_south(kind: &str, data: &[u8], size: [usize; 3]) -> Array {
    match array(kind, data) {
        Array::Bytes(values) => Array::Bytes(from_the_south(size).map(|i| values[i]).collect()),
        Array::Real(values) => Array::Real(from_the_south(size).map(|i| values[i]).collect()),
    }
}

/// Where the voxels of rows from the south lie in rows from the north, and the other way round.
pub(crate) fn from_the_south([nx, ny, nz]: [usize; 3]) -> impl Iterator<Item = usize> {
    let rows = (0..nz).flat_map(move |z| (0..ny).rev().map(move |y| (z * ny + y) * nx));
    rows.flat_map(move |first| first..first + nx)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_checked_before_memory_is_asked_for() {
        assert_eq!(count("x", [2, 3, 4], 4, 96).unwrap(), 24);
        assert!(count("x", [2, 3, 4], 4, 95).unwrap_err().to_string().contains("truncated"));
        for size in [[10_000, 10_000, 10_000], [u64::MAX, 2, 2], [0, 3, 3], [1 << 40, 1, 1]] {
            assert!(count("x", size, 1, usize::MAX).is_err(), "{size:?}");
        }
    }
}
