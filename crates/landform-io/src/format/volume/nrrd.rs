//! Nearly raw raster data: a text head, a blank line, the numbers of one field.
//!
//! # Sources
//! Kindlmann, *Definition of NRRD File Format*, versions 1 to 5.

use landform_core::{Error, Result};

use super::{VolumeFile, array_from_the_south, count, width};

const NAME: &str = "NRRD";

/// A file with numbers of a kind ("uint8", "float") in rows from the south, x east, y north, z up.
pub(crate) fn write(kind: &str, field: &str, size: [usize; 3], [low, side]: [[f64; 3]; 2], data: &[u8]) -> Vec<u8> {
    let [nx, ny, nz] = size;
    let [dx, dy, dz] = side;
    // The origin is the middle of the first voxel.
    let [x, y, z] = [0, 1, 2].map(|k| low[k] + 0.5 * side[k]);
    let head = format!(
        "NRRD0005\ntype: {kind}\ndimension: 3\nspace: right-anterior-superior\nsizes: {nx} {ny} {nz}\n\
         space directions: ({dx:?},0,0) (0,{dy:?},0) (0,0,{dz:?})\ncenterings: cell cell cell\nkinds: domain domain domain\n\
         endian: little\nencoding: raw\nspace units: \"m\" \"m\" \"m\"\nspace origin: ({x:?},{y:?},{z:?})\nfield:={field}\n\n"
    );
    [head.as_bytes(), data].concat()
}

pub(super) fn read(bytes: &[u8]) -> Result<VolumeFile> {
    let wrong = |what: String| Error::format(NAME, what);
    if !bytes.starts_with(b"NRRD000") {
        return Err(wrong("it does not begin as one".into()));
    }
    let end = bytes.windows(2).position(|w| w == b"\n\n").ok_or_else(|| wrong("its head is truncated".into()))?;
    let head = std::str::from_utf8(&bytes[..end]).map_err(|_| wrong("its head is no text".into()))?;
    let value = |key: &str| head.lines().find_map(|l| l.strip_prefix(key)?.strip_prefix(": ").map(str::trim));
    let need = |key: &str| value(key).ok_or_else(|| wrong(format!("its head lacks {key}")));
    let is = |key: &str, wanted: &str| match need(key)? {
        given if given.eq_ignore_ascii_case(wanted) => Ok(()),
        given => Err(wrong(format!("its {key} is {given}; expected {wanted}"))),
    };
    is("dimension", "3")?;
    is("encoding", "raw")?;
    if value("data file").is_some() {
        return Err(wrong("its numbers are in another file; expected them in this one".into()));
    }
    let sizes: Vec<u64> = need("sizes")?.split_whitespace().filter_map(|n| n.parse().ok()).collect();
    let sizes = <[u64; 3]>::try_from(sizes).map_err(|_| wrong("its sizes are not three whole numbers".into()))?;
    let kind = match need("type")? {
        "uint8" | "uchar" | "unsigned char" | "uint8_t" => "u1",
        "float" => "f4",
        "double" => "f8",
        other => other,
    };
    let width = width(NAME, kind)?;
    if width > 1 {
        is("endian", "little")?;
    }
    let data = &bytes[end + 2..];
    let n = count(NAME, sizes, width, data.len())?;
    let size = sizes.map(|n| n as usize);
    let name = head.lines().find_map(|l| l.strip_prefix("field:=")).map(String::from);
    let arrays = vec![(name, array_from_the_south(kind, &data[..n * width], size))];
    Ok(VolumeFile { size, place: place(value("space directions"), value("space origin"))?, arrays })
}

/// The low corner and the sides of a voxel; none where the file has no directions.
fn place(directions: Option<&str>, origin: Option<&str>) -> Result<Option<([f64; 3], [f64; 3])>> {
    let (Some(directions), Some(origin)) = (directions, origin) else { return Ok(None) };
    let numbers = |text: &str| -> Vec<f64> {
        text.split(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c))).filter_map(|n| n.parse().ok()).collect()
    };
    let (axes, origin) = (numbers(directions), numbers(origin));
    let is_straight = axes.len() == 9 && (0..9).all(|k| if k % 4 == 0 { axes[k] > 0.0 } else { axes[k] == 0.0 });
    if !is_straight || origin.len() != 3 {
        let what = "its axes are not east, north and up, each with a positive step";
        return Err(Error::format(NAME, what));
    }
    let side = [axes[0], axes[4], axes[8]];
    Ok(Some(([0, 1, 2].map(|k| origin[k] - 0.5 * side[k]), side)))
}
