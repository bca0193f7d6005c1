//! Parameters of an island.

use landform_core::units::{Angle, Length, Ratio, number_text, place_text};
use landform_core::verb::{Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::profile::Curve;
use crate::mechanism::GridParams;

/// A volcanic island in a deep sea: an outline from above and a profile from its middle outwards.
/// It may have sunk, with a reef that kept up where its shore was. For a reef that grows, let
/// `reef_growth` follow. Nothing is held at the sides of the map, so that the sea floor sinks with
/// the island.
///
/// ```
/// use landform_core::verb::Params;
/// use landform_process::reef::CoralIsland;
///
/// assert!(CoralIsland::default().validate().is_ok());
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct CoralIsland {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// The shore from above.
    pub outline: OutlineParams,
    /// Points [distance from the middle, height over the sea] from the middle outwards, joined by a
    /// smooth curve. Beyond the last the sea floor is level.
    pub profile: Vec<[Length; 2]>,
    /// Places of the middles, [x, y] from the south-west corner, for one island each. If none is
    /// given, there is one island in the middle of the map.
    pub at: Vec<[Length; 2]>,
    /// How deeply valleys cut the land, as a part of its height: 0 for smooth slopes.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub valleys: Ratio,
    /// Wind that has drawn the island out to leeward; none if not given.
    pub wind: Option<WarpParams>,
    /// By how much the island has sunk since it had its profile.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e5))]
    pub subsidence: Length,
    /// Reef that has kept up with the sea while the island sank; none if not given.
    pub reef: Option<BandParams>,
    /// Level of the sea, from which the profile's heights count. If not given, it is the
    /// environment's at the start, or else 0 m.
    pub sea_level: Option<Length>,
}

/// An island's shore from above.
///
/// ```
/// use landform_core::units::Ratio;
/// use landform_process::reef::OutlineParams;
///
/// let circle = OutlineParams { roughness: Ratio::of(0.0), ..OutlineParams::default() };
/// assert!(circle.radii.is_empty());
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct OutlineParams {
    /// Distance from the middle to the shore; the profile is stretched to it. If not given, it is
    /// the profile's own.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1e7))]
    pub radius: Option<Length>,
    /// Greatest part by which noise changes the distance to the shore: 0 for a circle.
    #[schemars(extend("x-min" = 0.0, "x-max" = 0.5))]
    pub roughness: Ratio,
    /// Distances to the shore in even directions, clockwise from north, in place of a circle.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1e7))]
    pub radii: Vec<Length>,
}

/// A wind that shapes an island.
///
/// ```
/// use landform_core::units::{Angle, Ratio};
/// use landform_process::reef::WarpParams;
///
/// let trade_wind = WarpParams { from: Angle::of(70.0), strength: Ratio::of(0.3) };
/// assert_eq!(trade_wind.strength, Ratio::of(0.3));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WarpParams {
    /// Compass direction that the wind comes from.
    pub from: Angle,
    /// How far the middle is drawn to leeward, as a part of the radius.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub strength: Ratio,
}

/// A reef that keeps up with the sea whatever happens, on ground that lay within a band of heights.
///
/// ```
/// use landform_process::reef::BandParams;
///
/// let band = BandParams::default();
/// assert!(band.low.si() < band.high.si());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct BandParams {
    /// Least height over the sea on which it began, before the island sank.
    #[schemars(extend("x-min" = -1e5, "x-max" = 1e5))]
    pub low: Length,
    /// Greatest height over the sea on which it began.
    #[schemars(extend("x-min" = -1e5, "x-max" = 1e5))]
    pub high: Length,
    /// Depth of its top under the sea.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e5))]
    pub low_water: Length,
    /// Slope of the rubble before it.
    #[schemars(extend("x-above" = 0.0, "x-max" = 85.0))]
    pub talus_angle: Angle,
}

/// Points of the profile where none are given, m.
const PROFILE: [[f64; 2]; 5] = [[0.0, 600.0], [800.0, 240.0], [1600.0, 0.0], [2400.0, -500.0], [3600.0, -900.0]];
/// Most points of an outline, and most islands.
const MOST: usize = 1000;
/// Greatest distance and height of a profile, m.
const FURTHEST: [f64; 2] = [1e7, 1e5];

impl Default for CoralIsland {
    fn default() -> Self {
        Self {
            grid: GridParams::of([8_000.0; 2], 20.0),
            outline: OutlineParams::default(),
            profile: PROFILE.map(|p| p.map(Length::of)).to_vec(),
            at: Vec::new(),
            valleys: Ratio::of(0.5),
            wind: None,
            subsidence: Length::of(0.0),
            reef: None,
            sea_level: None,
        }
    }
}

impl Default for OutlineParams {
    fn default() -> Self {
        Self { radius: None, roughness: Ratio::of(0.15), radii: Vec::new() }
    }
}

impl Default for WarpParams {
    fn default() -> Self {
        Self { from: Angle::of(90.0), strength: Ratio::of(0.5) }
    }
}

impl Default for BandParams {
    fn default() -> Self {
        Self { low: Length::of(-40.0), high: Length::of(0.0), low_water: Length::of(0.5), talus_angle: Angle::of(38.0) }
    }
}

impl CoralIsland {
    /// The profile as a curve, m.
    pub(super) fn curve(&self) -> Result<Curve> {
        let points: Vec<[f64; 2]> = self.profile.iter().map(|p| p.map(Length::si)).collect();
        let is_off = |p: &&[f64; 2]| !(p[0] >= 0.0 && p[0] <= FURTHEST[0] && p[1].abs() <= FURTHEST[1]);
        if let Some([distance, height]) = points.iter().find(is_off) {
            let found = format!("a point [{} m, {} m]", number_text(*distance), number_text(*height));
            return Err(Error::parameter("profile", found, "distances from 0 to 1e7 m and heights up to 1e5 m"));
        }
        Curve::through("profile", &points)
    }
}

impl Params for CoralIsland {
    const NAME: &'static str = "coral_island";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Hartley (2025)",
            title: "Automatic generation of coral islands, draft chapter of a thesis: outline, profile, keep-up band, wind",
            doi: "",
        },
        Source {
            authors: "Darwin (1842)",
            title: "The structure and distribution of coral reefs, Smith, Elder & Co., London",
            doi: "",
        },
        Source {
            authors: "Fritsch & Butland (1984)",
            title: "A method for constructing local monotone piecewise cubic interpolants, SIAM Journal on Scientific and Statistical Computing 5",
            doi: "10.1137/0905021",
        },
    ];

    fn leaves(&self) -> Vec<String> {
        vec![landform_core::field::names::LABELS.name.into()]
    }

    fn check(&self) -> Result<()> {
        self.grid.check()?;
        self.curve()?;
        for (name, count) in [("outline.radii", self.outline.radii.len()), ("at", self.at.len())] {
            if count > MOST {
                return Err(Error::parameter(name, format!("{count} entries"), &format!("at most {MOST}")));
            }
        }
        let [east, north] = self.grid.size.map(Length::si);
        let is_off = |p: &&[Length; 2]| !((0.0..=east).contains(&p[0].si()) && (0.0..=north).contains(&p[1].si()));
        if let Some(place) = self.at.iter().find(is_off) {
            let expected = format!("places on the map, up to {}", place_text([east, north]));
            return Err(Error::parameter("at", place_text(place.map(Length::si)), &expected));
        }
        let band = self.reef.unwrap_or_default();
        if !(band.low.si() < band.high.si()) {
            return Err(Error::parameter("reef.low", band.low, &format!("less than reef.high, {}", band.high)));
        }
        Ok(())
    }
}
