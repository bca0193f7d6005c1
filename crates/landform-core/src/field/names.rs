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
/// Ground that running water laid down.
///
/// ```
/// assert_eq!(landform_core::field::names::DEPOSITION.unit, "m");
/// ```
pub const DEPOSITION: Key<f64> = Key::new(
    "deposition",
    "m",
    "height that running water raised the ground by, summed over all steps; what it took again counts as laid down",
);
/// Ground that running water took.
///
/// ```
/// assert_eq!(landform_core::field::names::INCISION.unit, "m");
/// ```
pub const INCISION: Key<f64> = Key::new(
    "incision",
    "m",
    "height that running water and slopes that fall into it lowered the ground by, summed over all steps",
);
/// Fields that are sums over the steps of all runs.
///
/// ```
/// use landform_core::field::names;
///
/// assert!(names::SUMS.iter().all(|key| key.unit == "m"));
/// ```
pub const SUMS: [&Key<f64>; 2] = [&DEPOSITION, &INCISION];
/// Rainfall.
pub const RAINFALL: Key<f64> = Key::new("rainfall", "m/s", "rainfall");
/// Slope of the ground.
pub const SLOPE: Key<f64> = Key::new("slope", "1", "rise over run of the ground (Horn)");
/// Direction that the ground faces.
pub const ASPECT: Key<f64> =
    Key::new("aspect", "deg", "compass direction that the ground faces, clockwise from north; none on level ground");
/// Curvature along the slope.
pub const PROFILE_CURVATURE: Key<f64> =
    Key::new("profile_curvature", "1/m", "curvature along the line of steepest slope, positive on shoulders");
/// Curvature of the contour.
pub const PLAN_CURVATURE: Key<f64> =
    Key::new("plan_curvature", "1/m", "curvature of the contour, positive on spurs, negative in hollows");
/// Elevation against that of the surroundings.
pub const POSITION_INDEX: Key<f64> = Key::new(
    "position_index",
    "m",
    "elevation less the mean of the ground around: above 0 on ridges, below in valleys",
);
/// Relief of the surroundings.
pub const LOCAL_RELIEF: Key<f64> = Key::new("local_relief", "m", "highest less lowest elevation of the ground around");
/// Exposure to the sun or the wind.
pub const EXPOSURE: Key<f64> = Key::new("exposure", "1", "1 where the sun or the wind reaches the ground, 0 in shadow");
/// Drainage area spread by D-infinity.
pub const SPREAD_AREA: Key<f64> =
    Key::new("spread_area", "m2", "upslope area, own cell included, by D-infinity: water spreads over two neighbours");
/// Joints and faults.
///
/// ```
/// assert_eq!(landform_core::field::names::JOINTS.name, "joints");
/// ```
pub const JOINTS: Key<f64> =
    Key::new("joints", "1", "how many times as fast rock wears, 1 away from joints and faults");
/// A mask.
pub const MASK: Key<f64> = Key::new("mask", "1", "how much a place is chosen, 0 to 1");
/// With the name of a material before it: the depth of that loose layer, m, part of the elevation
/// ("sand_depth").
pub const DEPTH_SUFFIX: &str = "_depth";
/// The material at the surface.
pub const SURFACE_MATERIAL: Key<u8> =
    Key::new("surface_material", "1", "number of the material at the surface, as the legend beside the file tells");
/// Parts of a coast with reefs, as classes of [`COAST_LABELS`].
///
/// ```
/// use landform_core::field::names;
///
/// assert_eq!(names::COAST_LABELS.len(), 9);
/// ```
pub const LABELS: Key<u8> =
    Key::new("labels", "1", "part of the coast that the place belongs to, as the legend beside the file tells");
/// Names of the classes of [`LABELS`], by their number; 0 is nodata.
///
/// ```
/// use landform_core::field::names::COAST_LABELS;
///
/// assert_eq!((COAST_LABELS[1], COAST_LABELS[8]), ("mountain", "ocean"));
/// ```
pub const COAST_LABELS: &[&str] =
    &["nodata", "mountain", "island", "beach", "lagoon", "reef flat", "reef crest", "reef front", "ocean"];
/// Strength of the wind.
pub const WIND: Key<f64> =
    Key::new("wind", "1", "strength of the wind over the ground, 1 where nothing stands in its way");
/// Shelter from the winds.
pub const SHELTER: Key<f64> = Key::new(
    "shelter",
    "1",
    "part of the winds, by weight, from which the place is sheltered by the rules that moved the sand",
);
/// Round in which the sea came.
pub const SHORE_AGE: Key<u32> =
    Key::new("shore_age", "1", "round in which the sea took the place; 0 where it did not, or was before");
/// Level set of a coast.
pub const LEVEL_SET: Key<u32> =
    Key::new("level_set", "1", "number of the historic coast that the place lies within; 0 at sea");
/// Depth of water.
pub const WATER_DEPTH: Key<f64> = Key::new("water_depth", "m", "depth of water over the ground, standing and running");
/// Discharge.
pub const DISCHARGE: Key<f64> = Key::new("discharge", "m3/s", "water that runs through a place");
/// Water that comes to a place.
pub const WATER_SUPPLY: Key<f64> = Key::new("water_supply", "m/s", "rain, springs and inflow that come to the place");
/// Units of water that left a cell.
pub const STREAM_VISITS: Key<f64> = Key::new("stream_visits", "1", "units of water that have left the place");
/// Thickness of what landslides laid down.
///
/// ```
/// assert_eq!(landform_core::field::names::LANDSLIDE_DEPOSIT.unit, "m");
/// ```
pub const LANDSLIDE_DEPOSIT: Key<f64> = Key::new(
    "landslide_deposit",
    "m",
    "thickness that landslides of the run laid down, less what later ones took; what rivers took counts as there",
);
/// Area of landslides.
///
/// ```
/// assert_eq!(landform_core::field::names::LANDSLIDE_AREA.unit, "m2");
/// ```
pub const LANDSLIDE_AREA: Key<f64> =
    Key::new("landslide_area", "m2", "area of the landslide of the last step that took the ground; 0 where none did");
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
    (DEPOSITION.name, DEPOSITION.unit, DEPOSITION.meaning),
    (INCISION.name, INCISION.unit, INCISION.meaning),
    (RAINFALL.name, RAINFALL.unit, RAINFALL.meaning),
    (SLOPE.name, SLOPE.unit, SLOPE.meaning),
    (ASPECT.name, ASPECT.unit, ASPECT.meaning),
    (PROFILE_CURVATURE.name, PROFILE_CURVATURE.unit, PROFILE_CURVATURE.meaning),
    (PLAN_CURVATURE.name, PLAN_CURVATURE.unit, PLAN_CURVATURE.meaning),
    (POSITION_INDEX.name, POSITION_INDEX.unit, POSITION_INDEX.meaning),
    (LOCAL_RELIEF.name, LOCAL_RELIEF.unit, LOCAL_RELIEF.meaning),
    (EXPOSURE.name, EXPOSURE.unit, EXPOSURE.meaning),
    (SPREAD_AREA.name, SPREAD_AREA.unit, SPREAD_AREA.meaning),
    (MASK.name, MASK.unit, MASK.meaning),
    (SURFACE_MATERIAL.name, SURFACE_MATERIAL.unit, SURFACE_MATERIAL.meaning),
    (LABELS.name, LABELS.unit, LABELS.meaning),
    (WIND.name, WIND.unit, WIND.meaning),
    (SHELTER.name, SHELTER.unit, SHELTER.meaning),
    (SHORE_AGE.name, SHORE_AGE.unit, SHORE_AGE.meaning),
    (LEVEL_SET.name, LEVEL_SET.unit, LEVEL_SET.meaning),
    (WATER_DEPTH.name, WATER_DEPTH.unit, WATER_DEPTH.meaning),
    (DISCHARGE.name, DISCHARGE.unit, DISCHARGE.meaning),
    (WATER_SUPPLY.name, WATER_SUPPLY.unit, WATER_SUPPLY.meaning),
    (STREAM_VISITS.name, STREAM_VISITS.unit, STREAM_VISITS.meaning),
    (LANDSLIDE_DEPOSIT.name, LANDSLIDE_DEPOSIT.unit, LANDSLIDE_DEPOSIT.meaning),
    (LANDSLIDE_AREA.name, LANDSLIDE_AREA.unit, LANDSLIDE_AREA.meaning),
];

/// Unit of a standard field.
pub fn unit_of(name: &str) -> Option<&'static str> {
    let known = ALL.iter().find(|k| k.0 == name).map(|k| k.1);
    known.or_else(|| name.ends_with(DEPTH_SUFFIX).then_some("m"))
}
