//! Where particles start, and what flows around them.

use landform_core::units::{Angle, Length, Rate};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Faster flows are refused, m/s.
pub(super) const FASTEST: f64 = 1000.0;

/// Where particles start.
///
/// ```
/// use landform_core::units::Length;
/// use landform_process::particles::{Emitter, PointParams};
/// let [at, radius] = [[600.0, 1000.0, 560.0].map(Length::of), [20.0; 3].map(Length::of)];
/// assert_ne!(Emitter::Sky, Emitter::Point(PointParams { at, radius: radius[0] }));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Emitter {
    /// Over all of the ground, two radii above it.
    Sky,
    /// Over the sides of the map where the flow comes in, up to the highest ground.
    Upwind,
    /// In the water, within two radii under its surface.
    Water,
    /// Within a distance of a place: { point = { at = ["x", "y", "elevation"], radius = "20 m" } }.
    Point(PointParams),
    /// In a box: { box = { low = [..], high = [..] } }.
    Box(BoxParams),
}

/// A ball in which particles start.
///
/// ```
/// use landform_core::units::Length;
/// use landform_process::particles::PointParams;
/// let vent = PointParams { at: [600.0, 1000.0, 560.0].map(Length::of), radius: Length::of(20.0) };
/// assert_eq!(vent.radius.si(), 20.0);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointParams {
    /// East, north and elevation of its middle.
    pub at: [Length; 3],
    /// Its radius.
    #[schemars(extend("x-min" = 0.0))]
    pub radius: Length,
}

/// A box in which particles start.
///
/// ```
/// use landform_core::units::Length;
/// use landform_process::particles::BoxParams;
/// let [low, high] = [[0.0; 3], [50.0, 50.0, 10.0]].map(|corner| corner.map(Length::of));
/// assert!(BoxParams { low, high }.high[2].si() > 0.0);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxParams {
    /// Least east, north and elevation.
    pub low: [Length; 3],
    /// Greatest east, north and elevation.
    pub high: [Length; 3],
}

/// Velocity of air or water.
///
/// ```
/// use landform_process::particles::Flow;
/// assert_eq!(Flow::default(), Flow::None);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase", deny_unknown_fields)]
pub enum Flow {
    /// At rest.
    #[default]
    None,
    /// The same everywhere: { uniform = ["1 m/s", "0 m/s", "0 m/s"] }, east, north and up.
    Uniform([Rate; 3]),
    /// Three formulas of the position, m/s: { formula = ["1", "sin(x/50)", "0"] }.
    Formula([String; 3]),
    /// A wind that the ground turns and quickens: { wind = { from = "270 deg", speed = "10 m/s" }
    /// }.
    Wind(WindParams),
}

/// A wind over terrain.
///
/// ```
/// use landform_core::units::{Angle, Rate};
/// use landform_process::particles::{Flow, WindParams};
/// let west = WindParams { from: Angle::of(270.0), speed: Rate::from_si(10.0) };
/// assert_ne!(Flow::Wind(west), Flow::None);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WindParams {
    /// Compass direction that it comes from.
    pub from: Angle,
    /// Its speed over ground at 0 m.
    #[schemars(extend("x-min" = 0.0))]
    pub speed: Rate,
}

/// Medium in which the flow is.
///
/// ```
/// use landform_process::particles::FlowIn;
/// assert_ne!(FlowIn::Water, FlowIn::Air);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FlowIn {
    /// Water, under its level.
    Water,
    /// Air, over the level of the water.
    Air,
    /// Both.
    Everywhere,
}
