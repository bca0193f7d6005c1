//! Georeference as GeoKeys.

use landform_core::grid::{Georeference, Registration};

const MODEL_TYPE: u16 = 1024;
const RASTER_TYPE: u16 = 1025;
const GEOGRAPHIC: u16 = 2048;
const PROJECTED: u16 = 3072;
const LINEAR_UNIT: u16 = 3076;
const METRE: u16 = 9001;

/// Code of the linear unit, if it is not the metre.
pub(super) fn foreign_unit(directory: &[u16]) -> Option<u16> {
    let entries = directory.get(4..).unwrap_or_default().chunks_exact(4);
    entries.filter(|e| e[0] == LINEAR_UNIT && e[1] == 0).map(|e| e[3]).find(|&u| u != METRE)
}

/// The georeference that a key directory states.
pub(super) fn parse(directory: &[u16]) -> Georeference {
    let mut georeference = Georeference { registration: Registration::Area, ..Georeference::default() };
    let (mut geographic, mut projected) = (None, None);
    for entry in directory.get(4..).unwrap_or_default().chunks_exact(4) {
        // A location other than 0 points into another tag; the keys wanted here never do.
        if entry[1] != 0 {
            continue;
        }
        match (entry[0], entry[3]) {
            (MODEL_TYPE, 2) => georeference.geographic = true,
            (RASTER_TYPE, 2) => georeference.registration = Registration::Point,
            (GEOGRAPHIC, code) => geographic = Some(code),
            (PROJECTED, code) => projected = Some(code),
            _ => {}
        }
    }
    let code = if georeference.geographic { geographic } else { projected };
    georeference.epsg = code.filter(|&c| c != 0 && c != 32_767);
    georeference
}

/// The key directory of a georeference.
pub(super) fn directory(georeference: &Georeference) -> Vec<u16> {
    let raster_type = if georeference.registration == Registration::Area { 1 } else { 2 };
    let mut keys = Vec::new();
    match (georeference.epsg, georeference.geographic) {
        (Some(_), true) => keys.push([MODEL_TYPE, 0, 1, 2]),
        (Some(_), false) => keys.push([MODEL_TYPE, 0, 1, 1]),
        (None, _) => {}
    }
    keys.push([RASTER_TYPE, 0, 1, raster_type]);
    if let Some(code) = georeference.epsg {
        keys.push([if georeference.geographic { GEOGRAPHIC } else { PROJECTED }, 0, 1, code]);
    }
    let mut directory = vec![1, 1, 0, keys.len() as u16];
    directory.extend(keys.into_iter().flatten());
    directory
}
