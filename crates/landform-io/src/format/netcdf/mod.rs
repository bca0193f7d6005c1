//! netCDF, the classic format (1, and 2 for large files), with the names of the climate and
//! forecast conventions: coordinates x and y in metres, rows from the north, a field with its unit.
//!
//! # Sources
//! The NetCDF classic format specification (Unidata): a header of lists, big-endian, padded to four
//! bytes. CF conventions 1.8: coordinate variables, `units`, `standard_name`, `_FillValue`,
//! `grid_mapping`, `flag_values`.
//!
//! # Limits
//! On reading: one variable over two coordinates; netCDF-4 files are HDF5 and are not read.

mod header;

use landform_core::grid::{Registration, Shape};
use landform_core::{Error, Result};

use super::placement::Placement;
use super::said::{Said, Stored};
use super::system::System;
use super::{DataType, RasterFile, Samples, Sidecar, check_dimensions};
use header::{Attribute, Header, Kind, Variable, Writer};

const NAME: &str = "netCDF";

pub(super) fn read(bytes: &[u8], _: Option<&Sidecar>) -> Result<Stored> {
    let header = Header::read(bytes)?;
    let variable = header.raster()?;
    let [rows, cols] = [0, 1].map(|k| header.dimensions[variable.dimensions[k]].1);
    check_dimensions(NAME, rows, cols, 1, bytes.len())?;
    let shape = Shape::new(rows as usize, cols as usize);
    let samples = variable.numbers(bytes, shape.len())?;
    let number = |name: &str| variable.attribute(name).and_then(Attribute::number);
    let mut said = Said {
        nodata: number("_FillValue").or_else(|| number("missing_value")).filter(|v| !v.is_nan()),
        scale: number("scale_factor"),
        offset: number("add_offset"),
        unit: variable.attribute("units").and_then(Attribute::text).filter(|unit| unit != "1"),
        ..Said::default()
    };
    let axes = [1, 0].map(|k| header.named(&header.dimensions[variable.dimensions[k]].0));
    if let [Some(x), Some(y)] = axes {
        let (x_at, dx) = axis(x, bytes, shape.cols)?;
        let (y_at, dy) = axis(y, bytes, shape.rows)?;
        if !(dx > 0.0) {
            return Err(Error::format(NAME, "its columns run to the west"));
        }
        // The placement is that of the northernmost row.
        said.south_first = dy > 0.0;
        let north = if dy > 0.0 { y_at + dy * (shape.rows - 1) as f64 } else { y_at };
        let spacing = [dx, dy.abs()];
        said.placement = Some(Placement { spacing, origin: [x_at, north], registration: Registration::Point });
        said.system = system(&header, variable, x);
    }
    Ok(Stored { said, ..Stored::bare(shape, samples) })
}

/// First coordinate of an axis and its step.
fn axis(axis: &Variable, bytes: &[u8], count: usize) -> Result<(f64, f64)> {
    let places = axis.numbers(bytes, count)?;
    let first = places[0];
    let told = axis.attribute("spacing").and_then(Attribute::number);
    let step = match told.filter(|step| step.is_finite() && *step != 0.0) {
        Some(step) => step,
        None if count > 1 => (places[count - 1] - first) / (count - 1) as f64,
        None => 1.0,
    };
    let even = |(k, v): (usize, &f64)| (v - first - step * k as f64).abs() <= 1e-3 * step.abs();
    if !(step.is_finite() && step != 0.0 && places.iter().enumerate().all(even)) {
        return Err(Error::format(NAME, format!("coordinate `{}` is not evenly spaced", axis.name)));
    }
    Ok((first, step))
}

/// What is said of the system of coordinates.
fn system(header: &Header, variable: &Variable, x: &Variable) -> Option<System> {
    let mapping = variable.attribute("grid_mapping").and_then(Attribute::text).and_then(|name| header.named(&name));
    let code = mapping.and_then(|m| m.attribute("epsg_code")).and_then(Attribute::text);
    if let Some(epsg) = code.and_then(|c| c.strip_prefix("EPSG:").and_then(|c| c.parse().ok())) {
        return Some(System::of_code(epsg));
    }
    match x.attribute("units").and_then(Attribute::text)?.as_str() {
        "m" | "metre" | "meter" | "metres" | "meters" => Some(System::metres()),
        "degrees_east" | "degree_east" | "degrees" => Some(System { geographic: true, ..System::default() }),
        _ => None,
    }
}

pub(super) fn write(file: &RasterFile) -> Result<Vec<u8>> {
    let grid = file.grid;
    let Shape { rows, cols } = grid.shape;
    let geographic = grid.georeference.geographic;
    let (x, y) = if geographic { ("lon", "lat") } else { ("x", "y") };
    let mut out = Writer::new(&[(y, rows), (x, cols)]);
    out.global("Conventions", Attribute::of_text("CF-1.8"));
    out.global("source", Attribute::of_text(concat!("landform ", env!("CARGO_PKG_VERSION"))));
    let axis = |name: &'static str, meaning: [&str; 3], spacing: f64| {
        let [standard, long, unit] = meaning.map(Attribute::of_text);
        let step = Attribute::Numbers(Kind::Double, vec![spacing]);
        let list = vec![
            ("standard_name", standard),
            ("long_name", long),
            ("units", unit),
            ("axis", letter(name)),
            ("spacing", step),
        ];
        (name, list)
    };
    let [east, north] = match geographic {
        true => [["longitude", "longitude", "degrees_east"], ["latitude", "latitude", "degrees_north"]],
        false => [["projection_x_coordinate", "x, east", "m"], ["projection_y_coordinate", "y, north", "m"]],
    };
    let (name, attributes) = axis(y, north, -grid.spacing[1]);
    out.variable(name, &[0], attributes, Kind::Double, (0..rows).map(|row| grid.y(row)).collect());
    let (name, attributes) = axis(x, east, grid.spacing[0]);
    out.variable(name, &[1], attributes, Kind::Double, (0..cols).map(|col| grid.x(col)).collect());
    if let Some(epsg) = grid.georeference.epsg {
        let code = Attribute::of_text(&format!("EPSG:{epsg}"));
        let attributes = vec![("epsg_code", code.clone()), ("spatial_ref", code)];
        out.variable("crs", &[], attributes, Kind::Int, vec![f64::from(epsg)]);
    }
    let (kind, attributes) = field(file);
    out.variable(file.field, &[0, 1], attributes, kind, file.values.to_vec());
    out.bytes()
}

fn letter(axis: &str) -> Attribute {
    Attribute::of_text(if axis == "x" || axis == "lon" { "X" } else { "Y" })
}

/// Kind and attributes of the field's numbers.
fn field(file: &RasterFile) -> (Kind, Vec<(&'static str, Attribute)>) {
    let mut attributes = vec![
        ("long_name", Attribute::of_text(&file.field.replace('_', " "))),
        ("units", Attribute::of_text(file.unit)),
    ];
    if file.field == "elevation" {
        attributes.push(("standard_name", Attribute::of_text("surface_altitude")));
    }
    let kind = match file.samples {
        Samples::Real if file.geotiff.data_type == DataType::Float64 => Kind::Double,
        Samples::Real => Kind::Float,
        Samples::Counts if file.values.iter().all(|v| *v <= f64::from(i32::MAX)) => Kind::Int,
        Samples::Counts => Kind::Double,
        Samples::Classes => Kind::Short,
    };
    if file.samples == Samples::Real {
        attributes.push(("_FillValue", Attribute::Numbers(kind, vec![f64::NAN])));
    }
    if !file.legend.is_empty() {
        let numbers = file.legend.iter().map(|(k, _)| f64::from(*k)).collect();
        let words: Vec<String> = file.legend.iter().map(|(_, name)| name.replace(' ', "_")).collect();
        attributes.push(("flag_values", Attribute::Numbers(kind, numbers)));
        attributes.push(("flag_meanings", Attribute::of_text(&words.join(" "))));
    }
    if file.grid.georeference.epsg.is_some() {
        attributes.push(("grid_mapping", Attribute::of_text("crs")));
    }
    (kind, attributes)
}

#[cfg(test)]
mod tests;
