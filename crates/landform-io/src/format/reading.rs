//! The one place that decides what the numbers of a raster mean: which unit, which mask, which
//! nodata, which place.
//!
//! # Method
//! What the file says comes first, then what lies beside it. Samples are struck out by the mask, by
//! nodata and where no elevation can be so great; then scale, offset and unit make metres of them.
//! What was supposed, and what was not used, is noted.

use std::sync::Arc;

use landform_core::grid::{GeoKeys, Georeference, Grid, Shape};
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};

use super::placement::Placement;
use super::said::{Said, Stored};
use super::system::System;
use super::systems::{is_depth, length_by_name, vertical_unit};

/// Numbers beyond this are nodata that is not marked as such.
const GREATEST: f64 = 1e30;
/// What programs write where there is no data.
const COMMON_NODATA: [f64; 4] = [-9999.0, -32_768.0, -32_767.0, -99_999.0];

/// The note of a file that says nothing of its place.
pub const UNPLACED: &str = "nothing says how large its cells are: taken as 1 m";

/// A raster in metres, and what should be known of how it was read.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The ground.
    pub field: HeightField,
    /// What was supposed, changed or not used.
    pub notes: Vec<String>,
}

/// What lies beside a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Beside {
    /// What it says, the most trusted first.
    pub(super) said: Vec<Said>,
    /// Which samples are data.
    pub(super) valid: Option<Vec<bool>>,
    /// What was not used.
    pub(super) notes: Vec<String>,
}

/// What the numbers of a file mean.
///
/// # Errors
/// [`Error::Format`] where what is said cannot be followed, [`Error::Empty`] without any data.
pub(super) fn decide(format: &'static str, stored: Stored, beside: Beside) -> Result<Reading> {
    let Stored { shape, mut samples, valid, said, mut notes } = stored;
    notes.extend(beside.notes);
    let said = beside.said.into_iter().fold(said, Said::or);
    let system = said.system.clone().unwrap_or_default();
    system.check_unit(format)?;
    for valid in [valid, beside.valid].into_iter().flatten() {
        strike_masked(format, &mut samples, &valid)?;
    }
    strike_nodata(&mut samples, said.nodata, &mut notes);
    let unit = height_unit(&said, &system, &mut notes);
    to_metres(&mut samples, &said, unit);
    if said.south_first {
        samples = samples.chunks(shape.cols).rev().flatten().copied().collect();
    }
    let mut grid = place(format, &said, shape, &mut notes)?;
    georeference(&mut grid, &system, said.system.is_none(), unit != 1.0, &mut notes);
    Ok(Reading { field: HeightField::new(grid, samples)?, notes })
}

/// The grid of a file, by all that is said of it but its numbers.
///
/// # Errors
/// [`Error::Format`] where what is said cannot be followed.
pub(super) fn decide_grid(format: &'static str, stored: Stored, beside: Beside) -> Result<Grid> {
    let said = beside.said.into_iter().fold(stored.said, Said::or);
    let system = said.system.clone().unwrap_or_default();
    system.check_unit(format)?;
    // Its notes come when its numbers are read.
    let mut notes = Vec::new();
    let unit = height_unit(&said, &system, &mut notes);
    let mut grid = place(format, &said, stored.shape, &mut notes)?;
    georeference(&mut grid, &system, said.system.is_none(), unit != 1.0, &mut notes);
    Ok(grid)
}

fn strike_masked(format: &'static str, samples: &mut [f64], valid: &[bool]) -> Result<()> {
    if valid.len() != samples.len() {
        return Err(Error::format(format, format!("its mask has {} samples for {}", valid.len(), samples.len())));
    }
    for (sample, valid) in samples.iter_mut().zip(valid) {
        *sample = if *valid { *sample } else { f64::NAN };
    }
    Ok(())
}

fn strike_nodata(samples: &mut [f64], nodata: Option<f64>, notes: &mut Vec<String>) {
    // The same number printed with fewer digits, or kept as a 32-bit float.
    let narrow = nodata.map(|n| f64::from(n as f32));
    let is_none = |v: f64| nodata == Some(v) || narrow.is_some_and(|n| n == v || n == f64::from(v as f32));
    let (mut beyond, mut usual) = (0_usize, [0_usize; COMMON_NODATA.len()]);
    for v in samples.iter_mut().filter(|v| !v.is_nan()) {
        if is_none(*v) {
            *v = f64::NAN;
        } else if !(v.abs() <= GREATEST) {
            beyond += 1;
            *v = f64::NAN;
        } else if let Some(k) = COMMON_NODATA.iter().position(|u| u == v) {
            usual[k] += 1;
        }
    }
    if beyond > 0 && !nodata.is_some_and(|n| n.abs() > GREATEST) {
        notes.push(format!("{beyond} {} infinite or beyond 1e30: taken as nodata", numbers(beyond)));
    }
    for (count, value) in usual.into_iter().zip(COMMON_NODATA).filter(|u| u.0 > 0) {
        let nodes = if count == 1 { "node is" } else { "nodes are" };
        notes.push(format!(
            "{count} {nodes} exactly {value}: nodata that is not marked? (gdal_edit.py -a_nodata {value} marks it)"
        ));
    }
}

fn numbers(count: usize) -> &'static str {
    if count == 1 { "number is" } else { "numbers are" }
}

/// Metres in the unit of the values.
fn height_unit(said: &Said, system: &System, notes: &mut Vec<String>) -> f64 {
    let by_code = system.vertical.map(vertical_unit).filter(|u| *u != 1.0);
    let by_system = system.height_unit.or(by_code);
    if system.vertical.is_some_and(is_depth) {
        notes.push("its vertical system counts depths downward: values are taken as elevations, as they are".into());
    }
    let unit = match said.unit.as_deref().map(str::trim) {
        None | Some("" | "1") => by_system.unwrap_or(1.0),
        Some(name) => match length_by_name(name) {
            // Millimetres and kilometres are rather of rain and of distances.
            Some(unit) if !(0.005..=2.0).contains(&unit) => {
                notes.push(format!("its unit is \"{name}\": values are taken as they are"));
                1.0
            }
            Some(unit) => unit,
            None => {
                notes.push(format!("its unit, \"{name}\", is no length: values are taken as they are"));
                1.0
            }
        },
    };
    if (unit - 1.0).abs() < 1e-9 {
        return 1.0;
    }
    notes.push(format!("its elevations are in units of {} m: brought to metres", round(unit)));
    unit
}

fn round(unit: f64) -> f64 {
    (unit * 1e9).round() / 1e9
}

fn to_metres(samples: &mut [f64], said: &Said, unit: f64) {
    let (scale, offset) = (said.scale.unwrap_or(1.0), said.offset.unwrap_or(0.0));
    if scale != 1.0 || offset != 0.0 {
        samples.iter_mut().for_each(|v| *v = *v * scale + offset);
    }
    if unit != 1.0 {
        samples.iter_mut().for_each(|v| *v *= unit);
    }
}

fn place(format: &'static str, said: &Said, shape: Shape, notes: &mut Vec<String>) -> Result<Grid> {
    match &said.placement {
        Some(placement) => placement.grid(shape).map_err(|e| Error::format(format, e)),
        None => {
            notes.push(UNPLACED.into());
            Grid::new(shape, [1.0, 1.0])
        }
    }
}

fn georeference(grid: &mut Grid, system: &System, is_unnamed: bool, is_converted: bool, notes: &mut Vec<String>) {
    let registration = grid.georeference.registration;
    let placement = Placement { spacing: grid.spacing, origin: grid.origin, registration };
    let supposed = is_unnamed && placement.looks_like_degrees(grid.shape);
    if supposed {
        notes.push("no coordinate system is named: coordinates are taken as degrees of longitude and latitude".into());
    }
    let keys = system.keys.clone().filter(|_| !is_converted).or_else(|| without_heights(system));
    if let (None, None, Some(name), false) = (system.epsg, &keys, &system.name, system.geographic) {
        notes.push(format!("its system, \"{name}\", has no EPSG code: it is not carried on"));
    }
    let geographic = system.geographic || supposed;
    grid.georeference = Georeference { epsg: system.epsg, geographic, registration, keys, degrees: system.degrees };
}

/// The keys less those of elevations, which are metres now; none if the code tells all the rest.
fn without_heights(system: &System) -> Option<Arc<GeoKeys>> {
    let keys = system.keys.as_ref().filter(|_| system.epsg.is_none())?;
    let mut entries = keys.directory.chunks_exact(4);
    let head = entries.next()?;
    let kept: Vec<u16> = entries.filter(|e| !(4096..=4099).contains(&e[0])).flatten().copied().collect();
    let count = u16::try_from(kept.len() / 4).ok()?;
    let directory = [&head[..3], &[count], &kept].concat();
    Some(Arc::new(GeoKeys { directory, ..GeoKeys::clone(keys) }))
}

#[cfg(test)]
mod tests {
    use landform_core::grid::Registration;
    use landform_core::terrain::NodeSurface;

    use super::*;

    fn stored(samples: &[f64]) -> Stored {
        Stored::bare(Shape::new(1, samples.len()), samples.to_vec())
    }

    fn read(samples: &[f64], said: Said) -> Reading {
        decide("PNG", Stored { said, ..stored(samples) }, Beside::default()).unwrap()
    }

    fn holes(reading: &Reading) -> Vec<bool> {
        reading.field.elevation().iter().map(|z| z.is_nan()).collect()
    }

    #[test]
    fn nodata_is_struck_however_it_is_printed() {
        let lowest = f64::from(f32::MIN);
        for (nodata, value) in [
            (-9999.0, -9999.0),
            (-3.402_823e38, lowest),
            (0.1, f64::from(0.1_f32)),
            (f64::from(0.1_f32), 0.1),
            (-3.4e38, f64::NEG_INFINITY),
        ] {
            let found = read(&[1.0, value, 3.0], Said { nodata: Some(nodata), ..Said::default() });
            assert_eq!(holes(&found), [false, true, false], "{nodata}");
        }
        let found = read(&[1.0, f64::INFINITY, f64::NEG_INFINITY, 1e31], Said::default());
        assert_eq!(holes(&found), [false, true, true, true]);
        assert!(found.notes.iter().any(|n| n.starts_with("3 numbers are infinite")), "{:?}", found.notes);
    }

    #[test]
    fn nodata_that_is_not_marked_is_told_and_stays() {
        let found = read(&[1.0, -9999.0, -9999.0, -32_768.0], Said::default());
        assert_eq!(found.field.nodata_count(), 0);
        let noted = |text: &str| found.notes.iter().any(|n| n.starts_with(text));
        assert!(noted("2 nodes are exactly -9999") && noted("1 node is exactly -32768"), "{:?}", found.notes);
        assert!(!read(&[1.0, 2.0], Said::default()).notes.iter().any(|n| n.contains("nodata")));
    }

    #[test]
    fn nodata_is_a_stored_number_and_the_unit_comes_last() {
        let said = Said {
            nodata: Some(7.0),
            scale: Some(2.0),
            offset: Some(100.0),
            unit: Some("ft".into()),
            ..Said::default()
        };
        let found = read(&[7.0, 0.0, 50.0], said);
        assert!(found.field.elevation()[0].is_nan());
        assert_eq!(found.field.elevation()[1..], [100.0 * 0.3048, 200.0 * 0.3048]);
        assert!(found.notes.iter().any(|n| n.contains("0.3048 m")));
        // Other quantities pass through the same door.
        let found = read(&[7.0], Said { unit: Some("mm".into()), ..Said::default() });
        assert_eq!(found.field.elevation(), [7.0]);
        assert!(found.notes.iter().any(|n| n.contains("\"mm\"")));
    }

    #[test]
    fn vertical_systems_in_feet_become_metres() {
        for system in [
            System { vertical: Some(8228), ..System::of_code(32_611) },
            System { height_unit: Some(0.3048), ..System::of_code(32_611) },
        ] {
            let found = read(&[100.0], Said { system: Some(system), ..Said::default() });
            assert!((found.field.elevation()[0] - 30.48).abs() < 1e-9);
        }
    }

    #[test]
    fn masks_of_the_file_and_beside_it_both_count() {
        let stored = Stored { valid: Some(vec![false, true, true]), ..stored(&[1.0, 2.0, 3.0]) };
        let beside = Beside { valid: Some(vec![true, true, false]), ..Beside::default() };
        assert_eq!(holes(&decide("GeoTIFF", stored.clone(), beside).unwrap()), [true, false, true]);
        let beside = Beside { valid: Some(vec![true]), ..Beside::default() };
        assert!(decide("GeoTIFF", stored, beside).unwrap_err().to_string().contains("mask"));
    }

    #[test]
    fn the_file_comes_before_what_lies_beside_it() {
        let placed = |cell: f64| {
            let registration = Registration::Point;
            Some(Placement { spacing: [cell, cell], origin: [0.0, 0.0], registration })
        };
        let own = Stored { said: Said { nodata: Some(1.0), ..Said::default() }, ..stored(&[1.0, 2.0, 3.0]) };
        let first = Said { nodata: Some(2.0), placement: placed(30.0), ..Said::default() };
        let second = Said { placement: placed(99.0), scale: Some(2.0), ..Said::default() };
        let found = decide("GeoTIFF", own, Beside { said: vec![first, second], ..Beside::default() }).unwrap();
        assert_eq!(holes(&found), [true, false, false]);
        assert_eq!((found.field.grid().spacing, found.field.elevation()[2]), ([30.0, 30.0], 6.0));
        assert!(found.notes.is_empty(), "{:?}", found.notes);
        assert!(read(&[1.0], Said::default()).notes[0].contains("how large its cells are"));
    }

    #[test]
    fn rows_from_the_south_are_turned() {
        let said = Said { south_first: true, ..Said::default() };
        let stored = Stored { said, ..Stored::bare(Shape::new(2, 2), vec![1.0, 2.0, 3.0, 4.0]) };
        let found = decide("RAW16", stored, Beside::default()).unwrap();
        assert_eq!(found.field.elevation(), [3.0, 4.0, 1.0, 2.0]);
    }
}
