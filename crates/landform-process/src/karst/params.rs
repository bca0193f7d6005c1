//! Parameters of a karst network.

use landform_core::units::{Angle, Length};
use landform_core::verb::{Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Preset;

/// Grows a network of karst conduits from sinkholes to springs, by space colonisation or by
/// shortest paths, along beds and fractures; it leaves conduits, sinkholes and springs as features.
///
/// ```
/// let text = r#"{"sinkholes":12,"radius":["1 m","4 m"]}"#;
/// let given: landform_process::karst::KarstNetwork = serde_json::from_str(text).unwrap();
/// assert_eq!(given.radius.map(|r| r.si()), [1.0, 4.0]);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct KarstNetwork {
    /// How ways are found.
    pub method: Method,
    /// Pattern of the network: how many loops and dead ends it has.
    pub preset: Preset,
    /// How many sinkholes, at random on ground well above the water table; or their places, each x
    /// and y.
    pub sinkholes: Sinkholes,
    /// Springs. If none are given, there is one at the lowest place of the map.
    pub springs: Vec<Spring>,
    /// Families of fractures, along which passages lead.
    pub fractures: Vec<Fracture>,
    /// Bedding planes at which passages begin.
    pub beds: Vec<Bed>,
    /// Places that the network leads through, each x, y and elevation.
    pub waypoints: Vec<[Length; 3]>,
    /// Spheres without passages: rock that does not dissolve.
    pub forbidden: Vec<Forbidden>,
    /// Radius of the thinnest and of the widest conduit.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1_000.0))]
    pub radius: [Length; 2],
    /// Blind side passages. If not given, it follows from the pattern.
    #[schemars(extend("x-min" = 0, "x-max" = 10_000))]
    pub dead_ends: Option<u32>,
    /// Loops that are closed, as far as there are places for them. If not given, it follows from
    /// the pattern.
    #[schemars(extend("x-min" = 0, "x-max" = 10_000))]
    pub cycles: Option<u32>,
    /// Ratio of the length of a passage to the distance that it covers, away from what makes it
    /// turn.
    #[schemars(extend("x-min" = 1.0, "x-max" = 2.0))]
    pub tortuosity: f64,
    /// Length of the bends of passages. If not given, it is a fortieth of the longer side of the
    /// map.
    #[schemars(extend("x-above" = 0.0))]
    pub bend: Option<Length>,
    /// How deep under the water table passages begin.
    #[schemars(extend("x-min" = 0.0, "x-max" = 10_000.0))]
    pub phreatic_depth: Length,
    /// Distance between places that ways are made of. If not given, it is a hundredth of the longer
    /// side of the map.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub step: Option<Length>,
    /// Shortest paths: power of the cost at which a detour is preferred. The greater, the fewer
    /// direct ways remain. If not given, as many remain as the pattern has loops.
    #[schemars(extend("x-min" = 1.0, "x-max" = 10.0))]
    pub gamma: Option<f64>,
}

/// How the ways of a network are found.
///
/// ```
/// use landform_process::karst::{KarstNetwork, Method};
///
/// assert_eq!(KarstNetwork::default().method, Method::SpaceColonisation);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// Passages grow from the springs towards the water.
    #[default]
    SpaceColonisation,
    /// The cheapest ways between sinkholes and springs.
    ShortestPaths,
}

/// Sinkholes: how many, or where.
///
/// ```
/// use landform_process::karst::{KarstNetwork, Sinkholes};
///
/// assert_eq!(KarstNetwork::default().sinkholes, Sinkholes::Count(20));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Sinkholes {
    /// A number of them.
    Count(u32),
    /// Their places, m.
    Places(Vec<[Length; 2]>),
}

/// A spring.
///
/// ```
/// let text = r#"{"at":["1.9 km","300 m"],"water_table":"20 m"}"#;
/// let given: landform_process::karst::Spring = serde_json::from_str(text).unwrap();
/// assert_eq!(given.water_table.map(|level| level.si()), Some(20.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Where it is: x and y.
    pub at: [Length; 2],
    /// Elevation of the water table that drains to it. If not given, that of the ground there.
    #[serde(default)]
    pub water_table: Option<Length>,
}

/// A family of fractures of nearly the same attitude.
///
/// ```
/// assert_eq!(landform_process::karst::Fracture::default().weight, 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Fracture {
    /// Compass direction of their fall.
    pub dip_direction: Angle,
    /// Angle below the horizontal.
    #[schemars(extend("x-min" = 0.0, "x-max" = 90.0))]
    pub dip: Angle,
    /// By how much directions scatter.
    #[schemars(extend("x-min" = 0.0, "x-max" = 45.0))]
    pub tolerance: Angle,
    /// Weight with which passages follow them; 0 not at all.
    #[schemars(extend("x-min" = 0.0, "x-max" = 10.0))]
    pub weight: f64,
}

impl Default for Fracture {
    fn default() -> Self {
        Self { dip_direction: Angle::of(0.0), dip: Angle::of(90.0), tolerance: Angle::of(10.0), weight: 1.0 }
    }
}

/// A bedding plane.
///
/// ```
/// let text = r#"{"elevation":"35 m"}"#;
/// let given: landform_process::karst::Bed = serde_json::from_str(text).unwrap();
/// assert_eq!(given.elevation.si(), 35.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Bed {
    /// Elevation in the middle of the map.
    pub elevation: Length,
    /// Compass direction of its fall.
    pub dip_direction: Angle,
    /// Angle below the horizontal.
    #[schemars(extend("x-min" = 0.0, "x-max" = 60.0))]
    pub dip: Angle,
    /// Weight with which passages keep to it; 0 not at all.
    #[schemars(extend("x-min" = 0.0, "x-max" = 10.0))]
    pub weight: f64,
}

impl Default for Bed {
    fn default() -> Self {
        Self { elevation: Length::of(0.0), dip_direction: Angle::of(0.0), dip: Angle::of(0.0), weight: 1.0 }
    }
}

/// A sphere without passages.
///
/// ```
/// let text = r#"{"at":["100 m","100 m","50 m"],"radius":"30 m"}"#;
/// let given: landform_process::karst::Forbidden = serde_json::from_str(text).unwrap();
/// assert_eq!(given.radius.si(), 30.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Forbidden {
    /// Its middle: x, y and elevation.
    pub at: [Length; 3],
    /// Its radius.
    #[schemars(extend("x-above" = 0.0))]
    pub radius: Length,
}

impl Default for KarstNetwork {
    fn default() -> Self {
        Self {
            method: Method::default(),
            preset: Preset::default(),
            sinkholes: Sinkholes::Count(20),
            springs: Vec::new(),
            fractures: Vec::new(),
            beds: Vec::new(),
            waypoints: Vec::new(),
            forbidden: Vec::new(),
            radius: [Length::of(1.0), Length::of(5.0)],
            dead_ends: None,
            cycles: None,
            tortuosity: 1.3,
            bend: None,
            phreatic_depth: Length::of(20.0),
            step: None,
            gamma: None,
        }
    }
}

/// More sinkholes than this are refused.
const MOST_SINKHOLES: usize = 5_000;

impl Params for KarstNetwork {
    const NAME: &'static str = "karst_network";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Runions, Lane & Prusinkiewicz (2007)",
            title: "Modeling trees with a space colonization algorithm, Eurographics Workshop on Natural Phenomena",
            doi: "10.2312/NPH/NPH07/063-070",
        },
        Source {
            authors: "Paris, Guérin, Peytavie, Collon & Galin (2021)",
            title: "Synthesizing geologically coherent cave networks, Computer Graphics Forum 40(7)",
            doi: "10.1111/cgf.14420",
        },
        Source {
            authors: "Murray (1926)",
            title: "The physiological principle of minimum work, PNAS 12(3)",
            doi: "10.1073/pnas.12.3.207",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(16)
    }

    fn places(&self) -> Vec<(&'static str, [f64; 2])> {
        let of = |name, [x, y]: [Length; 2]| (name, [x.si(), y.si()]);
        let sinkholes: &[[Length; 2]] = match &self.sinkholes {
            Sinkholes::Places(places) => places,
            Sinkholes::Count(_) => &[],
        };
        let springs = self.springs.iter().map(|s| of("springs", s.at));
        let ways = self.waypoints.iter().map(|w| of("waypoints", [w[0], w[1]]));
        springs.chain(sinkholes.iter().map(|p| of("sinkholes", *p))).chain(ways).collect()
    }

    fn check(&self) -> Result<()> {
        let count = match &self.sinkholes {
            Sinkholes::Count(n) => *n as usize,
            Sinkholes::Places(places) => places.len(),
        };
        if count == 0 || count > MOST_SINKHOLES {
            return Err(Error::parameter("sinkholes", count, &format!("1 to {MOST_SINKHOLES}")));
        }
        let [thin, wide] = self.radius.map(Length::si);
        if thin > wide {
            let given = format!("{thin} m and {wide} m");
            return Err(Error::parameter("radius", given, "the thinnest before the widest"));
        }
        Ok(())
    }
}
