//! Every standard field, once: name, type, unit, meaning.

use super::Key;

/// Elevation of the ground (a member of every terrain rather than one of its optional fields).
pub const ELEVATION: Key<f64> = Key::new("elevation", "m", "elevation of the ground above sea level");
/// Drainage area.
pub const DRAINAGE_AREA: Key<f64> = Key::new("drainage_area", "m2", "upslope area, own cell included");
/// Depth of standing water.
pub const LAKE_DEPTH: Key<f64> =
    Key::new("lake_depth", "m", "depth of the lake over the ground, filled to its outlet; 0 on land");
/// Index of the node that water goes to next.
pub const RECEIVER: Key<u32> = Key::new("receiver", "1", "index of the node that receives this node's water");
/// Index of the outlet that a node drains to.
pub const BASIN: Key<u32> =
    Key::new("basin", "1", "number of the drainage basin, in order of its outlet's index, from 1");
/// Slope to the node that receives the water.
pub const CHANNEL_SLOPE: Key<f64> =
    Key::new("channel_slope", "1", "drop over distance to the node that receives this node's water; 0 at outlets");
/// Transformed distance from the outlet.
pub const CHI: Key<f64> = Key::new(
    "chi",
    "m",
    "distance to the outlet, each part times (1 km2 / drainage area)^(m/n); elevation is linear in it at a steady state",
);
/// Rate of lowering by rivers.
pub const EROSION_RATE: Key<f64> = Key::new(
    "erosion_rate",
    "m/s",
    "rate at which rivers and slopes lowered the ground in the last step; negative where they laid down",
);
/// Rainfall.
pub const RAINFALL: Key<f64> = Key::new("rainfall", "m/s", "rainfall");
/// Name, unit and meaning of every standard field.
pub const ALL: &[(&str, &str, &str)] = &[
    (ELEVATION.name, ELEVATION.unit, ELEVATION.meaning),
    (DRAINAGE_AREA.name, DRAINAGE_AREA.unit, DRAINAGE_AREA.meaning),
    (LAKE_DEPTH.name, LAKE_DEPTH.unit, LAKE_DEPTH.meaning),
    (RECEIVER.name, RECEIVER.unit, RECEIVER.meaning),
    (BASIN.name, BASIN.unit, BASIN.meaning),
    (CHANNEL_SLOPE.name, CHANNEL_SLOPE.unit, CHANNEL_SLOPE.meaning),
    (CHI.name, CHI.unit, CHI.meaning),
    (EROSION_RATE.name, EROSION_RATE.unit, EROSION_RATE.meaning),
    (RAINFALL.name, RAINFALL.unit, RAINFALL.meaning),
];

/// Unit of a standard field.
pub fn unit_of(name: &str) -> Option<&'static str> {
    ALL.iter().find(|k| k.0 == name).map(|k| k.1)
}
