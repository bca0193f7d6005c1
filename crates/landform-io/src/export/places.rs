//! Places in the coordinates of engines.
//!
//! # Sources
//! Unreal: centimetres, X, Y, Z left-handed, Z up, yaw from X to Y. Unity: metres, left-handed, Y
//! up, rotation about Y clockwise from above. Godot: metres, right-handed, Y up. Each as its card
//! of the height map lays the land: Unreal and Terrain3D from the north-west corner, Unity from
//! the south-west one.

use landform_core::feature::Property;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value as Json;

use super::geojson;

/// Coordinates of places that are written.
///
/// ```
/// use landform_io::export::{PlacePreset, WritePoints};
///
/// assert_eq!(WritePoints::default().preset, PlacePreset::Landscape);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PlacePreset {
    /// The landscape's own metres: x east, y north, z up.
    #[default]
    Landscape,
    /// Unreal: centimetres from the north-west corner: X east, Y south, Z up.
    Unreal,
    /// Unity: metres from the south-west corner: X east, Y up, Z north.
    Unity,
    /// Godot: metres from the north-west corner: X east, Y up, Z south.
    Godot,
}

impl PlacePreset {
    /// A place of the landscape with these bounds (south-west, north-east), m.
    pub(super) fn place(self, [sw, ne]: [[f64; 2]; 2], [x, y, z]: [f64; 3]) -> [f64; 3] {
        let (east, north, south) = (x - sw[0], y - sw[1], ne[1] - y);
        match self {
            Self::Landscape => [x, y, z],
            Self::Unreal => [100.0 * east, 100.0 * south, 100.0 * z],
            Self::Unity => [east, z, north],
            Self::Godot => [east, z, south],
        }
    }

    /// A length, m, in its unit.
    pub(super) fn length(self, metres: f64) -> f64 {
        if self == Self::Unreal { 100.0 * metres } else { metres }
    }

    /// A direction counted from east counter-clockwise, in degrees, as the engine turns things.
    pub(super) fn yaw(self, degrees: f64) -> f64 {
        match self {
            Self::Landscape | Self::Godot => degrees,
            Self::Unreal | Self::Unity => (360.0 - degrees) % 360.0,
        }
    }

    pub(super) fn unit(self) -> &'static str {
        if self == Self::Unreal { "cm" } else { "m" }
    }

    /// What a card says of them.
    pub(super) fn meaning(self) -> &'static str {
        match self {
            Self::Landscape => {
                "x east, y north, z up, in metres, as the landscape's own; directions from east counter-clockwise"
            }
            Self::Unreal => {
                "X east, Y south, Z up, in centimetres from the north-west corner: of a Landscape at X 0, Y 0, imported by the \
                 card of the height map; yaw from X to Y"
            }
            Self::Unity => {
                "X east, Y up, Z north, in metres from the south-west corner: of a Terrain whose Transform has X 0, Z 0; \
                 rotation about Y clockwise from above"
            }
            Self::Godot => {
                "X east, Y up, Z south, in metres from the north-west corner, where Terrain3D's region 0, 0 begins; rotation \
                 about Y counter-clockwise from above"
            }
        }
    }
}

/// A number with so many decimals, and no more.
pub(super) fn rounded(v: f64, decimals: u32) -> f64 {
    let scale = f64::from(10_u32.pow(decimals));
    let near = (v * scale).round() / scale;
    if near == 0.0 { 0.0 } else { near }
}

/// A property as JSON; none for lists.
pub(super) fn single(property: &Property) -> Option<Json> {
    match property {
        Property::Place(_) | Property::Numbers(_) => None,
        one => Some(geojson::value(one)),
    }
}
