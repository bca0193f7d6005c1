//! Parameters of a karst network.

use std::fmt;

use landform_core::math::{self, distance};
use landform_core::units::{Angle, Length, place_text};
use landform_core::verb::{Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{self, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

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
    /// Blind side passages, as far as there is room for them. If not given, it follows from the
    /// pattern.
    #[schemars(extend("x-min" = 0, "x-max" = 10_000))]
    pub dead_ends: Option<u32>,
    /// Loops that are closed, as far as there are places for them. If not given, it follows from
    /// the pattern. Mazes have loops of their own.
    #[schemars(extend("x-min" = 0, "x-max" = 10_000))]
    pub cycles: Option<u32>,
    /// Ratio of the length of a passage to the distance that it covers, away from what makes it
    /// turn.
    #[schemars(extend("x-min" = 1.0, "x-max" = 2.0))]
    pub tortuosity: f64,
    /// Length of the bends of passages, a thousandth to a quarter of the longer side of the map. If
    /// not given, it is a fortieth.
    #[schemars(extend("x-above" = 0.0))]
    pub bend: Option<Length>,
    /// How deep under the water table passages begin, and how far their bends lead up and down; no
    /// more than the longer side of the map.
    #[schemars(extend("x-min" = 0.0, "x-max" = 10_000.0))]
    pub phreatic_depth: Length,
    /// Distance between places that ways are made of, a two-thousandth of the longer side of the
    /// map at least. If not given, it is a hundredth.
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
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Sinkholes {
    /// A number of them.
    Count(u32),
    /// Their places, m.
    Places(Vec<[Length; 2]>),
}

impl<'de> Deserialize<'de> for Sinkholes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        struct CountOrPlaces;
        impl<'de> Visitor<'de> for CountOrPlaces {
            type Value = Sinkholes;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "a number from 1 to {MOST_SINKHOLES}, or places such as [[\"100 m\", \"250 m\"]]")
            }

            fn visit_u64<E: de::Error>(self, count: u64) -> std::result::Result<Sinkholes, E> {
                let wrong = |_| E::invalid_value(Unexpected::Unsigned(count), &self);
                u32::try_from(count).map(Sinkholes::Count).map_err(wrong)
            }

            fn visit_i64<E: de::Error>(self, count: i64) -> std::result::Result<Sinkholes, E> {
                let wrong = |_| E::invalid_value(Unexpected::Signed(count), &self);
                u32::try_from(count).map(Sinkholes::Count).map_err(wrong)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, places: A) -> std::result::Result<Sinkholes, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(places)).map(Sinkholes::Places)
            }
        }
        deserializer.deserialize_any(CountOrPlaces)
    }
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
    #[schemars(extend("x-min" = -100_000.0, "x-max" = 100_000.0))]
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
    #[schemars(extend("x-min" = -100_000.0, "x-max" = 100_000.0))]
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

/// More sinkholes than this are refused, and more waypoints.
const MOST_SINKHOLES: usize = 5_000;
/// More springs, spheres, beds or families of fractures than this are refused.
const MOST_OTHERS: usize = 1_000;
/// More keys than this are refused with shortest paths: all pairs are compared over all others.
const MOST_KEYS: usize = 400;

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
        self.check_counts()?;
        self.check_keys_of_methods()?;
        self.check_places_apart()?;
        let [thin, wide] = self.radius.map(Length::si);
        if thin > wide {
            let given = format!("{} and {}", self.radius[0], self.radius[1]);
            return Err(Error::parameter("radius", given, "the thinnest before the widest"));
        }
        Ok(())
    }

    fn check_on(&self, extent: [f64; 2]) -> Result<()> {
        let side = extent[0].max(extent[1]);
        let within = |name: &str, given: Option<Length>, least: f64, most: f64| {
            let [low, high] = [least * side, most * side];
            match given.filter(|v| !(low * (1.0 - 1e-9)..=high * (1.0 + 1e-9)).contains(&v.si())) {
                Some(v) => Err(Error::parameter(name, v, &format!("{low} m to {high} m on this map"))),
                None => Ok(()),
            }
        };
        within("bend", self.bend, BENDS[0], BENDS[1])?;
        within("step", self.step, STEPS[0], STEPS[1])?;
        within("phreatic_depth", Some(self.phreatic_depth), 0.0, 1.0)?;
        self.radius.into_iter().try_for_each(|r| within("radius", Some(r), 0.0, 0.25))
    }
}

/// Least and greatest bend over the longer side of the map.
const BENDS: [f64; 2] = [1e-3, 0.25];
/// Least and greatest step over the longer side of the map.
const STEPS: [f64; 2] = [5e-4, 1.0];

impl KarstNetwork {
    fn check_counts(&self) -> Result<()> {
        let sinkholes = match &self.sinkholes {
            Sinkholes::Count(n) => *n as usize,
            Sinkholes::Places(places) => places.len(),
        };
        if sinkholes == 0 || sinkholes > MOST_SINKHOLES {
            return Err(Error::parameter("sinkholes", sinkholes, &format!("1 to {MOST_SINKHOLES}")));
        }
        let lists = [
            ("waypoints", self.waypoints.len(), MOST_SINKHOLES),
            ("springs", self.springs.len(), MOST_OTHERS),
            ("forbidden", self.forbidden.len(), MOST_OTHERS),
            ("beds", self.beds.len(), MOST_OTHERS),
            ("fractures", self.fractures.len(), MOST_OTHERS),
        ];
        if let Some((name, count, most)) = lists.into_iter().find(|l| l.1 > l.2) {
            return Err(Error::parameter(name, format!("a list of {count}"), &format!("at most {most}")));
        }
        let keys = sinkholes + self.springs.len().max(1) + self.waypoints.len();
        if self.method == Method::ShortestPaths && keys > MOST_KEYS {
            let given = format!("{sinkholes}, and {} springs and waypoints", keys - sinkholes);
            let expected =
                format!("at most {MOST_KEYS} in all with shortest paths; space_colonisation takes {MOST_SINKHOLES}");
            return Err(Error::parameter("sinkholes", given, &expected));
        }
        Ok(())
    }

    /// Refuses keys that the method or the pattern does not read.
    fn check_keys_of_methods(&self) -> Result<()> {
        if self.preset.is_maze() && self.method == Method::ShortestPaths {
            let expected =
                "\"space_colonisation\" with a maze, or `preset` \"branchwork\", \"mixed\" or \"anastomotic\"";
            return Err(Error::parameter("method", "\"shortest_paths\"", expected));
        }
        if let Some(gamma) = self.gamma.filter(|_| self.method != Method::ShortestPaths) {
            return Err(Error::parameter("gamma", gamma, "none, or `method` \"shortest_paths\", which alone reads it"));
        }
        if let Some(cycles) = self.cycles.filter(|_| self.preset.is_maze()) {
            return Err(Error::parameter("cycles", cycles, "none with a maze: it has loops of its own"));
        }
        Ok(())
    }

    /// Refuses two keys at one place, and waypoints in rock that does not dissolve.
    fn check_places_apart(&self) -> Result<()> {
        let mut named = self.places();
        named.retain(|(name, _)| *name != "waypoints");
        named.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]).then(a.1[1].total_cmp(&b.1[1])));
        let close = named.windows(2).find(|w| math::hypot(w[0].1[0] - w[1].1[0], w[0].1[1] - w[1].1[1]) < NEAREST);
        if let Some([a, b]) = close.map(|w| [w[0], w[1]]) {
            let name = if a.0 == "sinkholes" { a.0 } else { b.0 };
            let given = format!("{} twice", place_text(a.1));
            return Err(Error::parameter(name, given, "a place of its own for each sinkhole and spring"));
        }
        let in_sphere = |w: &&[Length; 3]| {
            self.forbidden.iter().any(|f| distance(w.map(Length::si), f.at.map(Length::si)) <= f.radius.si())
        };
        match self.waypoints.iter().find(in_sphere) {
            Some([x, y, z]) => {
                Err(Error::parameter("waypoints", format!("{x}, {y}, {z}"), "places outside `forbidden` spheres"))
            }
            None => Ok(()),
        }
    }
}

/// Sinkholes and springs that lie nearer than this (m) are at one place.
const NEAREST: f64 = 0.01;
