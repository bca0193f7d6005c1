//! VTK image data with its numbers appended raw, as `write_volume` and ParaView write it.
//!
//! # Sources
//! VTK file formats, "XML file formats": image data, cell data, appended raw.

use landform_core::{Error, Result};

use super::{VolumeFile, array_from_the_south, count, width};

const NAME: &str = "VTK image";

pub(super) fn read(bytes: &[u8]) -> Result<VolumeFile> {
    let wrong = |what: String| Error::format(NAME, what);
    let mark = b"<AppendedData";
    let at = bytes.windows(mark.len()).position(|w| w == mark);
    let at = at.ok_or_else(|| wrong("it has no appended data".into()))?;
    let head = std::str::from_utf8(&bytes[..at]).map_err(|_| wrong("its head is no text".into()))?;
    let tail = &bytes[at..];
    let start = tail.iter().position(|b| *b == b'_').ok_or_else(|| wrong("it is truncated".into()))?;
    if !String::from_utf8_lossy(&tail[..start]).contains("encoding=\"raw\"") {
        return Err(wrong("its numbers are encoded; expected them appended raw".into()));
    }
    let data = &tail[start + 1..];
    let file = tag(head, "<VTKFile").ok_or_else(|| wrong("it does not begin as one".into()))?;
    for (key, wanted) in [("type", "ImageData"), ("byte_order", "LittleEndian"), ("header_type", "UInt64")] {
        match attribute(file, key) {
            Some(given) if given == wanted => {}
            given => return Err(wrong(format!("its {key} is {}; expected {wanted}", given.unwrap_or("not given")))),
        }
    }
    if attribute(file, "compressor").is_some() {
        return Err(wrong("it is compressed; expected it without compression".into()));
    }
    let image = tag(head, "<ImageData").ok_or_else(|| wrong("it holds no image data".into()))?;
    let three = |key: &str| -> Option<[f64; 3]> {
        let all: Vec<f64> = attribute(image, key)?.split_whitespace().filter_map(|n| n.parse().ok()).collect();
        all.try_into().ok()
    };
    let extent = attribute(image, "WholeExtent").unwrap_or_default();
    let extent: Vec<i64> = extent.split_whitespace().filter_map(|n| n.parse().ok()).collect();
    let extent = <[i64; 6]>::try_from(extent).map_err(|_| wrong("its extent is not six whole numbers".into()))?;
    let sizes = [0, 2, 4].map(|k| extent[k + 1].saturating_sub(extent[k]).max(0) as u64);
    let n = count(NAME, sizes, 1, data.len())?;
    let size = sizes.map(|n| n as usize);
    let cells = head.split_once("<CellData").ok_or_else(|| wrong("it has no values of cells".into()))?.1;
    let cells = cells.split_once("</CellData").map_or(cells, |(inner, _)| inner);
    let mut arrays = Vec::new();
    for text in cells.split("<DataArray").skip(1) {
        let name = attribute(text, "Name").unwrap_or("values");
        let kind = match attribute(text, "type").unwrap_or_default() {
            "UInt8" => "u1",
            "Float32" => "f4",
            "Float64" => "f8",
            other => other,
        };
        let width = width(NAME, kind)?;
        if attribute(text, "NumberOfComponents").is_some_and(|c| c != "1") {
            return Err(wrong(format!("`{name}` has several numbers a voxel; expected one")));
        }
        let offset: Option<usize> = attribute(text, "offset").and_then(|o| o.parse().ok());
        let rest = offset.and_then(|o| data.get(o..)).filter(|rest| rest.len() >= 8);
        let rest = rest.ok_or_else(|| wrong(format!("`{name}` lies beyond its end")))?;
        count(NAME, sizes, width, rest.len() - 8)?;
        arrays.push((Some(name.to_string()), array_from_the_south(kind, &rest[8..8 + n * width], size)));
    }
    let place = three("Origin").zip(three("Spacing"));
    let low =
        |(origin, side): ([f64; 3], [f64; 3])| ([0, 1, 2].map(|k| origin[k] + extent[2 * k] as f64 * side[k]), side);
    Ok(VolumeFile { size, place: place.map(low), arrays })
}

/// What stands in a tag.
fn tag<'a>(text: &'a str, begin: &str) -> Option<&'a str> {
    text.split_once(begin)?.1.split_once('>').map(|(inner, _)| inner)
}

fn attribute<'a>(tag: &'a str, key: &str) -> Option<&'a str> {
    tag.split_once('>')
        .map_or(tag, |(inner, _)| inner)
        .split_once(&format!(" {key}=\""))?
        .1
        .split_once('"')
        .map(|(v, _)| v)
}
