//! Georeference as GeoKeys.
//!
//! # Sources
//! OGC GeoTIFF 1.1, section 7 and annex B.

use std::sync::Arc;

use landform_core::grid::{GeoKeys, Georeference, Registration};

use crate::format::system::System;
use crate::format::systems::length_unit;

const MODEL_TYPE: u16 = 1024;
const RASTER_TYPE: u16 = 1025;
const CITATION: u16 = 1026;
const GEOGRAPHIC: u16 = 2048;
const ANGULAR_UNIT: u16 = 2054;
const PROJECTED: u16 = 3072;
const PROJECTED_CITATION: u16 = 3073;
const LINEAR_UNIT: u16 = 3076;
const LINEAR_UNIT_SIZE: u16 = 3077;
const VERTICAL: u16 = 4096;
const VERTICAL_UNIT: u16 = 4099;
/// Codes of the degree.
const DEGREES: [u16; 2] = [9102, 9122];
const NUMBERS_TAG: u16 = 34_736;
const TEXT_TAG: u16 = 34_737;
/// The code of what is described by other keys.
const USER_DEFINED: u16 = 32_767;
/// WGS 84, where degrees have no code.
const WGS_84: u16 = 4326;

/// What a key directory states.
pub(super) struct Stated<'a>(&'a GeoKeys);

impl<'a> Stated<'a> {
    pub(super) fn of(keys: &'a GeoKeys) -> Self {
        Self(keys)
    }

    fn entries(&self) -> impl Iterator<Item = &[u16]> {
        self.0.directory.get(4..).unwrap_or_default().chunks_exact(4)
    }

    /// The value of a key that lies in the directory.
    fn short(&self, key: u16) -> Option<u16> {
        self.entries().find(|e| e[0] == key && e[1] == 0).map(|e| e[3])
    }

    fn number(&self, key: u16) -> Option<f64> {
        let at = self.entries().find(|e| e[0] == key && e[1] == NUMBERS_TAG)?[3];
        self.0.numbers.get(usize::from(at)).copied().filter(|v| v.is_finite() && *v > 0.0)
    }

    fn text(&self, key: u16) -> Option<String> {
        let entry = self.entries().find(|e| e[0] == key && e[1] == TEXT_TAG)?;
        let (count, at) = (usize::from(entry[2]), usize::from(entry[3]));
        let text = self.0.text.get(at..)?;
        Some(text.get(..count).unwrap_or(text).trim_end_matches(['|', '\0', ' ']).into())
    }

    fn code(&self, key: u16) -> Option<u16> {
        self.short(key).filter(|&c| c != 0 && c != USER_DEFINED)
    }

    pub(super) fn registration(&self) -> Registration {
        if self.short(RASTER_TYPE) == Some(2) { Registration::Point } else { Registration::Area }
    }

    /// The system; none if no key is about one.
    pub(super) fn system(&self) -> Option<System> {
        let is_about = |e: &[u16]| e[0] == MODEL_TYPE || (GEOGRAPHIC..5_120).contains(&e[0]);
        if !self.entries().any(is_about) {
            return None;
        }
        let geographic = match self.short(MODEL_TYPE) {
            Some(model) => model == 2,
            None => self.short(PROJECTED).is_none() && self.short(GEOGRAPHIC).is_some(),
        };
        let epsg = self.code(if geographic { GEOGRAPHIC } else { PROJECTED });
        let vertical = self.entries().any(|e| (VERTICAL..=VERTICAL_UNIT).contains(&e[0]));
        let unit = if geographic {
            self.code(ANGULAR_UNIT).map(|u| if DEGREES.contains(&u) { 1.0 } else { f64::NAN })
        } else {
            let by_code = self.code(LINEAR_UNIT).map(|u| length_unit(u).unwrap_or(f64::NAN));
            by_code.or_else(|| self.number(LINEAR_UNIT_SIZE))
        };
        let must_be_carried = vertical || epsg.is_none();
        Some(System {
            epsg,
            geographic,
            unit,
            height_unit: self.code(VERTICAL_UNIT).and_then(length_unit),
            vertical: self.code(VERTICAL),
            name: self.text(PROJECTED_CITATION).or_else(|| self.text(CITATION)),
            keys: must_be_carried.then(|| Arc::new(self.0.clone())),
            degrees: None,
        })
    }
}

/// The keys of a georeference; none of local metres, since readers would make a system up.
pub(super) fn of(georeference: &Georeference) -> Option<GeoKeys> {
    let raster_type = if georeference.registration == Registration::Area { 1 } else { 2 };
    if let Some(keys) = &georeference.keys {
        let mut keys = GeoKeys::clone(keys);
        set_raster_type(&mut keys.directory, raster_type);
        return Some(keys);
    }
    let (model, key, code) = match (georeference.geographic, georeference.epsg) {
        (true, code) => (2, GEOGRAPHIC, code.unwrap_or(WGS_84)),
        (false, Some(code)) => (1, PROJECTED, code),
        (false, None) => return None,
    };
    let entries = [[MODEL_TYPE, 0, 1, model], [RASTER_TYPE, 0, 1, raster_type], [key, 0, 1, code]];
    let directory = [1, 1, 0, entries.len() as u16].into_iter().chain(entries.into_iter().flatten()).collect();
    Some(GeoKeys { directory, ..GeoKeys::default() })
}

/// Sets the key of the registration, which comes in order where it is not there.
fn set_raster_type(directory: &mut Vec<u16>, value: u16) {
    let mut keys: Vec<[u16; 4]> = directory.get(4..).unwrap_or_default().as_chunks().0.to_vec();
    keys.retain(|k| k[0] != RASTER_TYPE);
    let at = keys.iter().take_while(|k| k[0] < RASTER_TYPE).count();
    keys.insert(at, [RASTER_TYPE, 0, 1, value]);
    directory.truncate(3);
    directory.resize(3, 1);
    directory.push(keys.len() as u16);
    directory.extend(keys.into_iter().flatten());
}
