//! Parameters of coasts.

use std::borrow::Cow;

use landform_core::units::{Length, Ratio, RatioDimension};
use landform_core::verb::{Params, Source, Varying};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Coast whose length damps the sea.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "expected \"global\", { local = \"1 km\", search = \"contiguous\" } (or \"all\"), or { sectors = 2 }"
)]
pub enum Perimeter {
    /// "global": all coasts together.
    Whole(Whole),
    /// Coasts within a radius of each site.
    Local {
        /// The radius.
        local: Length,
        /// Which of them count.
        #[serde(default)]
        search: Search,
    },
    /// Coasts of the sectors around each site, linear between the centres of sectors: fast, but
    /// traces of the sectors remain.
    Sectors {
        /// The map is cut into 2^k by 2^k sectors.
        sectors: u32,
    },
}

/// All coasts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Whole {
    /// All coasts together.
    Global,
}

/// Which coasts within the radius count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Search {
    /// Those of the same shore.
    #[default]
    Contiguous,
    /// All shores, islands included.
    All,
}

/// How the resistance of sites falls with the number of their sides that the sea reaches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Exposure {
    /// It does not fall.
    None,
    /// In proportion to the sides that still touch land: one side leaves 3/4 of R, two 1/2, three
    /// 1/4, four 0 (Pytel 2015, 4.2.1).
    Proportional,
    /// One side: R; two: R squared; three or four: 0 (Sapoval, Baldassarri & Gabrielli 2004). The
    /// same coasts want a force that is about 0.25 higher.
    #[default]
    Squared,
}

/// What a coast looks like.
///
/// ```
/// use landform_process::coast::{CoastErosion, Look};
///
/// let params: CoastErosion = serde_json::from_str(r#"{ "look": "skerries", "land": 0.5 }"#).unwrap();
/// assert_eq!(params.look, Some(Look::Skerries));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Look {
    /// Bays and capes of any size, with islets before them.
    Rugged,
    /// Shores frayed into necks, inlets and islets.
    Skerries,
    /// A gently wavy line without islands.
    Smooth,
}

/// Weakening of sites near one that falls.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Weakening {
    /// Resistance that a site loses when a square of 0.6 radii beside it falls; less with distance.
    /// Resistances are from 0 to 1; on cells much smaller than the radius more than 1 may be meant,
    /// since each weakens by its part of the square.
    pub amount: f64,
    /// Distance from which on a site loses nothing.
    pub radius: Length,
}

impl Default for Weakening {
    fn default() -> Self {
        Self { amount: 0.05, radius: Length::of(25.0) }
    }
}

/// When the sea stops.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields, expecting = "expected \"stable\" or { land = 0.6 }")]
pub enum Until {
    /// "stable": when no site falls any more.
    Stable(Stable),
    /// When this fraction of the land is left.
    Land {
        /// Fraction of the land at the start, 0 to 1.
        land: f64,
    },
}

/// The end of erosion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Stable {
    /// No site falls any more.
    Stable,
}

/// Coast erosion: a site of the coast falls where the force of the sea exceeds its resistance, and
/// a longer coast damps the sea. The sea lies beyond the open sides of the map. Runs without a
/// clock.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct CoastErosion {
    /// What the coast shall look like: "rugged", "skerries" or "smooth". It stands for damping,
    /// perimeter, exposure and weakening, which then are not given.
    pub look: Option<Look>,
    /// Share of the land that shall be left once the sea rests. The force is then found by trials,
    /// and is not given. With a look it is 0.6 if not given.
    #[schemars(extend("x-above" = 0.0, "x-below" = 1.0))]
    pub land: Option<f64>,
    /// Force f of the sea, against resistances from 0 to 1. If neither it nor `land` or a look is
    /// given, it is 0.5.
    #[schemars(extend("x-min" = 0.0))]
    pub force: Option<Varying<RatioDimension>>,
    /// Damping g of the sea by the length of the coast: F = f / (1 + g L / L0). With 0.1 and more
    /// the coast is rough, with 0.003 and less it is fractal.
    #[schemars(extend("x-min" = 0.0))]
    pub damping: Varying<RatioDimension>,
    /// Coast whose length damps the sea: "global", { local = "1 km", search = "contiguous" } or
    /// "all", or { sectors = 2 }.
    pub perimeter: Perimeter,
    /// Size of the irregular grains in which the coast falls. The same coast then forms whatever
    /// the cells, and its lines do not follow them. If not given, cells fall.
    #[schemars(extend("x-above" = 0.0))]
    pub grain: Option<Length>,
    /// How the resistance of sites falls with the number of their sides that the sea reaches.
    pub exposure: Exposure,
    /// Weakening of sites near one that falls: { amount, radius }. It makes coasts straighter.
    /// `weakening_factor` may vary its amount in space.
    pub weakening: Option<Weakening>,
    /// Factor on the amount of weakening; may vary in space. If not given, it is 1.
    #[schemars(extend("x-min" = 0.0))]
    pub weakening_factor: Option<Varying<RatioDimension>>,
    /// Fraction k of the force that wears a site down in each round. With 0 a site keeps its
    /// resistance until the force exceeds it.
    #[schemars(extend("x-min" = 0.0))]
    pub wear: Varying<RatioDimension>,
    /// Factor on the resistances of the rock, which are random from 0 to 1; may vary in space.
    #[schemars(extend("x-min" = 0.0))]
    pub resistance: Varying<RatioDimension>,
    /// When the sea rests: "stable", or { land = 0.6 }.
    pub until: Until,
    /// Greatest number of rounds.
    #[schemars(extend("x-min" = 1, "x-max" = 1e7))]
    pub iterations: u64,
    /// Sea level. Ground at or under it that is connected to the open border is sea. If not given,
    /// it is the environment's sea level, or else 0 m.
    pub sea_level: Option<Length>,
    /// Depth of the water where land was taken.
    #[schemars(extend("x-above" = 0.0))]
    pub depth: Length,
}

impl Default for CoastErosion {
    fn default() -> Self {
        Self {
            look: None,
            land: None,
            force: None,
            damping: Ratio::of(0.15).into(),
            perimeter: Perimeter::Whole(Whole::Global),
            grain: None,
            exposure: Exposure::Squared,
            weakening: None,
            weakening_factor: None,
            wear: Varying::default(),
            resistance: Ratio::of(1.0).into(),
            until: Until::Stable(Stable::Stable),
            iterations: 5_000,
            sea_level: None,
            depth: Length::of(5.0),
        }
    }
}

impl Params for CoastErosion {
    const NAME: &'static str = "coast_erosion";
    const RENAMED: &'static [(&'static str, &'static str)] = &[("steps", "iterations")];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Sapoval, Baldassarri & Gabrielli (2004)",
            title: "Self-stabilized fractality of seacoasts through damped erosion, Physical Review Letters 93",
            doi: "10.1103/PhysRevLett.93.098501",
        },
        Source {
            authors: "Pytel (2015)",
            title: "Erosion, Self-Organization, and Procedural Modeling, thesis, University of Waterloo, section 4.2 and appendix B.1",
            doi: "",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(if self.grain.is_some() { 90 } else { 25 })
    }

    fn check(&self) -> Result<()> {
        self.check_look()?;
        if self.grain.is_some() && matches!(self.perimeter, Perimeter::Sectors { .. }) {
            return Err(Error::parameter("perimeter", "sectors with `grain`", "\"global\" or { local = \"1 km\" }"));
        }
        match self.perimeter {
            Perimeter::Local { local, .. } if !(local.si() > 0.0 && local.si().is_finite()) => {
                return Err(Error::parameter("perimeter", format!("local = {local}"), "a radius above 0 m"));
            }
            Perimeter::Sectors { sectors } if sectors > 8 => {
                return Err(Error::parameter(
                    "perimeter",
                    format!("sectors = {sectors}"),
                    "at most 8 (256 by 256 sectors)",
                ));
            }
            _ => {}
        }
        if let Some(w) = self.weakening
            && !(w.amount >= 0.0 && w.amount <= 1e6 && w.radius.si() > 0.0 && w.radius.si().is_finite())
        {
            return Err(Error::parameter(
                "weakening",
                format!("{} within {}", w.amount, w.radius),
                "an amount from 0 to 1e6 and a radius above 0 m",
            ));
        }
        if self.weakening_factor.is_some() && self.weakening.is_none() {
            return Err(Error::Incomplete { name: "weakening_factor".into(), needs: "weakening" });
        }
        match self.until {
            Until::Land { land } if !(0.0..1.0).contains(&land) => {
                Err(Error::parameter("until", format!("land = {land}"), "a part from 0 to below 1"))
            }
            Until::Stable(_) if matches!(&self.wear, Varying::Uniform(wear) if wear.si() > 0.0) => Err(never_rests()),
            _ => Ok(()),
        }
    }
}

impl CoastErosion {
    /// Refuses what a look or a share of land stands for beside it.
    fn check_look(&self) -> Result<()> {
        let usual = Self::default();
        let given = [
            ("damping", self.damping != usual.damping),
            ("perimeter", self.perimeter != usual.perimeter),
            ("exposure", self.exposure != usual.exposure),
            ("weakening", self.weakening.is_some()),
            ("wear", self.wear != usual.wear),
        ];
        if let (Some(_), Some((name, _))) = (self.look, given.into_iter().find(|g| g.1)) {
            return Err(Error::parameter(name, "given beside `look`", "one of the two: a look stands for it"));
        }
        if self.land.is_none() && self.look.is_none() {
            return Ok(());
        }
        if self.force.is_some() {
            return Err(Error::parameter(
                "force",
                "given beside `land` or `look`",
                "one of them: it is found by trials",
            ));
        }
        if self.land.is_some_and(|land| !(land > 0.0 && land < 1.0)) {
            return Err(Error::parameter("land", self.land.unwrap_or(0.0), "a part between 0 and 1"));
        }
        if self.wear != usual.wear {
            return Err(Error::parameter(
                "wear",
                "given beside `land`",
                "until = { land = 0.6 }: it ends at a share too",
            ));
        }
        Ok(())
    }

    /// These parameters, with those that the look stands for. Lengths are counted in grains, or in
    /// cells of `cell` metres.
    pub(super) fn with_look(&self, cell: f64) -> Cow<'_, Self> {
        let Some(look) = self.look else { return Cow::Borrowed(self) };
        let grain = self.grain.map_or(cell, Length::si);
        let local = |grains: f64| Perimeter::Local { local: Length::of(grains * grain), search: Search::All };
        let (damping, perimeter) = match look {
            Look::Rugged => (0.05, Perimeter::Whole(Whole::Global)),
            Look::Skerries => (1.0, local(5.0)),
            Look::Smooth => (0.2, local(13.0)),
        };
        let own =
            Self { damping: Ratio::of(damping).into(), perimeter, exposure: Exposure::Proportional, ..self.clone() };
        Cow::Owned(match (look, self.wanted_land()) {
            // A sea that weakens what it leaves does not rest: it wears, and is stopped.
            (Look::Smooth, Some(land)) => Self {
                weakening: Some(Weakening { amount: 1.0, radius: Length::of(4.0 * grain) }),
                wear: Ratio::of(0.05).into(),
                until: Until::Land { land },
                ..own
            },
            _ => own,
        })
    }

    /// The share of land that shall be left.
    pub(super) fn wanted_land(&self) -> Option<f64> {
        self.land.or(self.look.map(|_| 0.6))
    }
}

/// That a coast cannot rest whose sites all fall in time.
pub(super) fn never_rests() -> Error {
    Error::parameter("until", "\"stable\" with `wear`", "{ land = 0.6 }: a coast that wears never rests")
}
