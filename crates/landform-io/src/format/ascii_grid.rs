//! ESRI ASCII grids: a few header lines, then rows of numbers from the north. Cells that are not
//! square are written as GDAL does.

use std::borrow::Cow;
use std::fmt::Write;
use std::iter::Peekable;

use landform_core::grid::{Registration, Shape};
use landform_core::{Error, Result};

use super::placement::Placement;
use super::said::{Said, Stored};
use super::{DataType, RasterFile, Sidecar};

const NAME: &str = "ESRI ASCII grid";
const NODATA: f64 = -9999.0;

pub(super) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    let text = text(bytes)?;
    let mut words = text.split_ascii_whitespace().peekable();
    let stored = header(&mut words, bytes.len())?;
    let shape = stored.shape;
    let mut samples = Vec::with_capacity(shape.len());
    for word in words {
        let value = number(word).ok_or_else(|| Error::format(NAME, format!("`{}` is not a number", shorten(word))))?;
        samples.push(value);
        if samples.len() > shape.len() {
            break;
        }
    }
    if samples.len() != shape.len() {
        let found = if samples.len() > shape.len() { "more".into() } else { samples.len().to_string() };
        return Err(Error::format(NAME, format!("it has {found} values where the header says {}", shape.len())));
    }
    Ok(Stored { samples, ..stored })
}

/// As [`read`], without the numbers.
pub(super) fn read_header(bytes: &[u8]) -> Result<Stored> {
    header(&mut text(bytes)?.split_ascii_whitespace().peekable(), bytes.len())
}

/// What the words before the numbers say.
fn header<'a>(words: &mut Peekable<impl Iterator<Item = &'a str>>, length: usize) -> Result<Stored> {
    let mut header = Header::default();
    while let Some(word) = words.peek() {
        if !word.starts_with(|c: char| c.is_ascii_alphabetic()) || is_number(word) {
            break;
        }
        let key = word.to_ascii_lowercase();
        words.next();
        let value =
            words.next().and_then(number).ok_or_else(|| Error::format(NAME, format!("`{key}` has no number")))?;
        header.set(&key, value)?;
    }
    let shape = header.shape(length)?;
    let said = Said {
        nodata: Some(header.nodata.unwrap_or(NODATA)),
        placement: Some(header.placement(shape)?),
        ..Said::default()
    };
    Ok(Stored { said, ..Stored::bare(shape, Vec::new()) })
}

/// The text, with or without a byte-order mark.
fn text(bytes: &[u8]) -> Result<Cow<'_, str>> {
    let wide = |order: fn([u8; 2]) -> u16| {
        let units: Vec<u16> = bytes[2..].chunks_exact(2).map(|b| order([b[0], b[1]])).collect();
        String::from_utf16(&units).map(Cow::Owned).map_err(|e| Error::format(NAME, e))
    };
    match bytes {
        [0xFF, 0xFE, ..] => wide(u16::from_le_bytes),
        [0xFE, 0xFF, ..] => wide(u16::from_be_bytes),
        [0xEF, 0xBB, 0xBF, rest @ ..] => plain(rest),
        _ => plain(bytes),
    }
}

fn plain(bytes: &[u8]) -> Result<Cow<'_, str>> {
    std::str::from_utf8(bytes).map(Cow::Borrowed).map_err(|e| Error::format(NAME, e))
}

fn shorten(word: &str) -> String {
    word.chars().take(20).collect()
}

/// A number with point or comma, and with Fortran's exponent.
fn number(word: &str) -> Option<f64> {
    word.parse().ok().or_else(|| word.replace(',', ".").replace(['D', 'd'], "e").parse().ok())
}

fn is_number(word: &str) -> bool {
    number(word).is_some()
}

#[derive(Default)]
struct Header {
    cols: Option<f64>,
    rows: Option<f64>,
    x: Option<(f64, bool)>,
    y: Option<(f64, bool)>,
    cell: [Option<f64>; 2],
    nodata: Option<f64>,
}

impl Header {
    fn set(&mut self, key: &str, value: f64) -> Result<()> {
        match key {
            "ncols" => self.cols = Some(value),
            "nrows" => self.rows = Some(value),
            "xllcorner" => self.x = Some((value, true)),
            "yllcorner" => self.y = Some((value, true)),
            "xllcenter" => self.x = Some((value, false)),
            "yllcenter" => self.y = Some((value, false)),
            "cellsize" => self.cell = [Some(value); 2],
            "dx" | "xdim" => self.cell[0] = Some(value),
            "dy" | "ydim" => self.cell[1] = Some(value),
            "nodata_value" | "nodata" => self.nodata = Some(value),
            other => return Err(Error::format(NAME, format!("header word `{}` is not known", shorten(other)))),
        }
        Ok(())
    }

    fn shape(&self, length: usize) -> Result<Shape> {
        let need = |v: Option<f64>, key: &str| v.ok_or_else(|| Error::format(NAME, format!("`{key}` is missing")));
        let (cols, rows) = (need(self.cols, "ncols")?, need(self.rows, "nrows")?);
        need(self.cell[0].and(self.cell[1]), "cellsize")?;
        let whole = |v: f64| v >= 1.0 && v.fract() == 0.0;
        // A value takes at least a digit and a separator.
        if !whole(cols) || !whole(rows) || cols * rows > length as f64 {
            return Err(Error::format(
                NAME,
                format!("it claims {cols} x {rows} values, more than {length} bytes can hold"),
            ));
        }
        Ok(Shape::new(rows as usize, cols as usize))
    }

    fn placement(&self, shape: Shape) -> Result<Placement> {
        let [dx, dy] = self.cell.map(|c| c.unwrap_or(1.0));
        for cell in [dx, dy] {
            if !(cell.is_finite() && cell > 0.0) {
                return Err(Error::format(NAME, format!("`cellsize` is {cell}; expected > 0")));
            }
        }
        let at =
            |v: Option<(f64, bool)>, cell: f64| v.map_or(0.0, |(v, corner)| if corner { v + 0.5 * cell } else { v });
        let origin = [at(self.x, dx), at(self.y, dy) + (shape.rows - 1) as f64 * dy];
        if !origin.iter().all(|v| v.is_finite()) {
            return Err(Error::format(NAME, "its corner is not at finite coordinates"));
        }
        let area = self.x.is_some_and(|x| x.1);
        let registration = if area { Registration::Area } else { Registration::Point };
        Ok(Placement { spacing: [dx, dy], origin, registration })
    }
}

pub(super) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    let grid = file.grid.in_its_system();
    let [dx, dy] = grid.spacing;
    let area = grid.georeference.registration == Registration::Area;
    let half = if area { 0.5 } else { 0.0 };
    let (word, south) = (if area { "corner" } else { "center" }, grid.origin[1] - grid.extent()[1]);
    let cell = if (dx - dy).abs() > 1e-6 * dx { format!("dx {dx}\ndy {dy}") } else { format!("cellsize {dx}") };
    let mut text = format!(
        "ncols {}\nnrows {}\nxll{word} {}\nyll{word} {}\n{cell}\nNODATA_value {NODATA}\n",
        grid.shape.cols,
        grid.shape.rows,
        grid.origin[0] - half * dx,
        south - half * dy,
    );
    let digits = file.geotiff.data_type == DataType::Float64;
    for row in file.values.chunks(grid.shape.cols) {
        for (k, v) in row.iter().enumerate() {
            let v = if v.is_finite() { *v } else { NODATA };
            let gap = if k == 0 { "" } else { " " };
            if digits { write!(text, "{gap}{v}") } else { write!(text, "{gap}{}", v as f32) }.ok();
        }
        text.push('\n');
    }
    Ok(text.into_bytes())
}
