//! ESRI ASCII grids: a few header lines, then rows of numbers from the north. Square cells only.

use std::fmt::Write;

use landform_core::grid::{Grid, Registration, Shape};
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};

use super::{RasterFile, Sidecar};

const NAME: &str = "ESRI ASCII grid";
const NODATA: f64 = -9999.0;

pub(super) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<HeightField> {
    let text = std::str::from_utf8(bytes).map_err(|e| Error::format(NAME, e))?;
    let mut words = text.split_ascii_whitespace().peekable();
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
    let (grid, nodata) = header.grid(bytes.len())?;
    let mut values = Vec::with_capacity(grid.len());
    for word in words {
        let value = number(word).ok_or_else(|| Error::format(NAME, format!("`{}` is not a number", shorten(word))))?;
        values.push(if value == nodata || !value.is_finite() { f64::NAN } else { value });
        if values.len() > grid.len() {
            break;
        }
    }
    if values.len() != grid.len() {
        let found = if values.len() > grid.len() { "more".into() } else { values.len().to_string() };
        return Err(Error::format(NAME, format!("it has {found} values where the header says {}", grid.len())));
    }
    HeightField::new(grid, values)
}

fn shorten(word: &str) -> String {
    word.chars().take(20).collect()
}

/// A number with point or comma.
fn number(word: &str) -> Option<f64> {
    word.parse().ok().or_else(|| word.replace(',', ".").parse().ok())
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
    cell: Option<f64>,
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
            "cellsize" => self.cell = Some(value),
            "nodata_value" => self.nodata = Some(value),
            other => return Err(Error::format(NAME, format!("header word `{}` is not known", shorten(other)))),
        }
        Ok(())
    }

    fn grid(&self, length: usize) -> Result<(Grid, f64)> {
        let need = |v: Option<f64>, key: &str| v.ok_or_else(|| Error::format(NAME, format!("`{key}` is missing")));
        let (cols, rows, cell) = (need(self.cols, "ncols")?, need(self.rows, "nrows")?, need(self.cell, "cellsize")?);
        let whole = |v: f64| v >= 1.0 && v.fract() == 0.0;
        // A value takes at least a digit and a separator.
        if !whole(cols) || !whole(rows) || cols * rows > length as f64 {
            return Err(Error::format(
                NAME,
                format!("it claims {cols} x {rows} values, more than {length} bytes can hold"),
            ));
        }
        if !(cell.is_finite() && cell > 0.0) {
            return Err(Error::format(NAME, format!("`cellsize` is {cell}; expected > 0")));
        }
        let mut grid = Grid::new(Shape::new(rows as usize, cols as usize), [cell, cell])?;
        let at = |v: Option<(f64, bool)>| v.map_or(0.0, |(v, corner)| if corner { v + 0.5 * cell } else { v });
        grid.origin = [at(self.x), at(self.y) + (rows - 1.0) * cell];
        let area = self.x.is_some_and(|x| x.1);
        grid.georeference.registration = if area { Registration::Area } else { Registration::Point };
        Ok((grid, self.nodata.unwrap_or(NODATA)))
    }
}

pub(super) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    let grid = file.grid;
    let [dx, dy] = grid.spacing;
    if (dx - dy).abs() > 1e-6 * dx {
        return Err(Error::Format {
            format: NAME,
            what: format!("cells are {dx} x {dy} m; this format has square cells only"),
            hint: Some("write a .tif, or resample first".into()),
        });
    }
    let area = grid.georeference.registration == Registration::Area;
    let half = if area { 0.5 * dx } else { 0.0 };
    let (word, south) = (if area { "corner" } else { "center" }, grid.origin[1] - grid.extent()[1]);
    let mut text = format!(
        "ncols {}\nnrows {}\nxll{word} {}\nyll{word} {}\ncellsize {dx}\nNODATA_value {NODATA}\n",
        grid.shape.cols,
        grid.shape.rows,
        grid.origin[0] - half,
        south - half,
    );
    for row in file.values.chunks(grid.shape.cols) {
        for (k, v) in row.iter().enumerate() {
            let v = if v.is_finite() { *v as f32 } else { NODATA as f32 };
            write!(text, "{}{v}", if k == 0 { "" } else { " " }).ok();
        }
        text.push('\n');
    }
    Ok(text.into_bytes())
}
