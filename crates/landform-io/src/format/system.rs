//! The coordinate reference system that a file states.

use std::sync::Arc;

use landform_core::grid::{Degrees, GeoKeys};
use landform_core::{Error, Result};

use super::systems::{is_geographic, is_in_grads, is_in_metres};

/// A coordinate reference system, as far as it matters here.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct System {
    /// EPSG code.
    pub(super) epsg: Option<u16>,
    /// Whether coordinates are longitude and latitude.
    pub(super) geographic: bool,
    /// Metres in the unit of the coordinates; degrees, if they are longitude and latitude.
    pub(super) unit: Option<f64>,
    /// Metres in the unit of elevations.
    pub(super) height_unit: Option<f64>,
    /// EPSG code of the vertical system.
    pub(super) vertical: Option<u16>,
    /// What it is called.
    pub(super) name: Option<String>,
    /// What must be carried on, since the code does not tell it.
    pub(super) keys: Option<Arc<GeoKeys>>,
    /// The longitude and latitude that its metres were made from.
    pub(super) degrees: Option<Degrees>,
}

impl System {
    /// Local metres.
    pub(super) fn metres() -> Self {
        Self { unit: Some(1.0), ..Self::default() }
    }

    /// The system of an EPSG code.
    pub(super) fn of_code(epsg: u16) -> Self {
        Self { epsg: Some(epsg), geographic: is_geographic(epsg), ..Self::default() }
    }

    /// "EPSG:2263", or its name.
    fn title(&self) -> String {
        match (self.epsg, &self.name) {
            (Some(epsg), _) => format!("EPSG:{epsg}"),
            (None, Some(name)) => format!("\"{name}\""),
            (None, None) => "its system".into(),
        }
    }

    /// Refuses coordinates that are neither metres nor degrees.
    ///
    /// # Errors
    /// [`Error::Format`].
    pub(super) fn check_unit(&self, format: &'static str) -> Result<()> {
        let by_code = self.epsg.is_none_or(|e| if self.geographic { !is_in_grads(e) } else { is_in_metres(e) });
        let known = self.unit.map_or(by_code, |unit| (unit - 1.0).abs() < 1e-4);
        if known {
            return Ok(());
        }
        let wanted = if self.geographic { "degrees" } else { "metres" };
        let unit = match self.unit {
            _ if self.geographic => "another unit".into(),
            Some(unit) if (unit - 0.3048).abs() < 1e-5 => format!("feet of {unit:.9} m"),
            Some(unit) if unit.is_finite() => format!("units of {unit} m"),
            _ => "feet or another unit".into(),
        };
        Err(Error::Format {
            format,
            what: format!("its coordinates are not in {wanted}: {} counts in {unit}", self.title()),
            hint: Some(
                "warp it to a system in metres first, such as UTM: gdalwarp -t_srs EPSG:326NN in.tif out.tif".into(),
            ),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feet_are_refused_by_code_and_by_unit_and_metres_are_not() {
        let text = |system: System| system.check_unit("GeoTIFF").map_err(|e| e.to_string()).err().unwrap_or_default();
        assert!(text(System::of_code(2263)).contains("EPSG:2263 counts in feet"));
        let named = System { unit: Some(0.3048), name: Some("grid".into()), ..System::default() };
        assert!(text(named).contains("\"grid\" counts in feet of 0.304800000 m"));
        assert!(text(System::of_code(4807)).contains("not in degrees"));
        assert!(text(System { unit: Some(f64::NAN), ..System::default() }).contains("another unit"));
        assert!(text(System { unit: Some(0.9), geographic: true, ..System::default() }).contains("not in degrees"));
        for fine in [System::of_code(32_611), System::of_code(4326), System::metres(), System::default()] {
            assert_eq!(text(fine), "");
        }
        // What the file itself says counts for more than the code.
        assert_eq!(text(System { unit: Some(1.0), ..System::of_code(2263) }), "");
    }
}
