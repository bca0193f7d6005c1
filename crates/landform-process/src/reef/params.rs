//! Parameters of the growth of reefs.

use landform_core::units::{Angle, Attenuation, Length, Rate, RateDimension, Ratio};
use landform_core::verb::{Params, Source, Varying};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Growth of coral reefs on ground under the sea, by the light that reaches it: they keep up with a
/// rising sea, catch up with it, or drown. A reef grows best beside open water, so that a rim rises
/// and a lagoon stays behind it. Its depth is a layer of coral on the ground.
///
/// ```
/// use landform_core::verb::Params;
/// use landform_process::reef::ReefGrowth;
///
/// assert!(ReefGrowth { light: -1.0, ..ReefGrowth::default() }.validate().is_err());
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ReefGrowth {
    /// Greatest rate of upward growth, 10 to 15 mm/yr as measured; may vary in space or change in
    /// time.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1000.0))]
    pub max_rate: Varying<RateDimension>,
    /// Light at the surface, uE m-2 s-1: 2000 to 2250 in the tropics.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e5))]
    pub light: f64,
    /// Light at which growth saturates, uE m-2 s-1: 50 to 450.
    #[schemars(extend("x-min" = 1e-3, "x-max" = 1e5))]
    pub saturation: f64,
    /// Extinction of light in the water: 0.04 1/m in clear, 0.16 1/m in turbid water.
    #[schemars(extend("x-min" = 1e-4, "x-max" = 100.0))]
    pub extinction: Attenuation,
    /// Depth of low water under the level of the sea: reefs grow no higher.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1000.0))]
    pub low_water: Length,
    /// Distance from open water over which growth falls to 1/e. The shorter, the narrower a reef
    /// and the wider its lagoon.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1e9))]
    pub restriction: Length,
    /// Least depth of open water.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e5))]
    pub open_depth: Length,
    /// Steepest slope of coral under water; what stands steeper slips.
    #[schemars(extend("x-above" = 0.0, "x-max" = 85.0))]
    pub talus_angle: Angle,
    /// Part of the growth that finds no room below low water and is shed into lagoons as sediment.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub shed: Ratio,
    /// Depth up to which sediment fills lagoons; at least `open_depth`.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e5))]
    pub lagoon_depth: Length,
    /// Level of the sea. If not given, it is the environment's, with its history, or else 0 m.
    pub sea_level: Option<Length>,
}

impl Default for ReefGrowth {
    fn default() -> Self {
        Self {
            max_rate: Rate::of(12.0).into(),
            light: 2000.0,
            saturation: 250.0,
            extinction: Attenuation::of(0.1),
            low_water: Length::of(0.5),
            restriction: Length::of(100.0),
            open_depth: Length::of(20.0),
            talus_angle: Angle::of(38.0),
            shed: Ratio::of(0.2),
            lagoon_depth: Length::of(30.0),
            sea_level: None,
        }
    }
}

impl Params for ReefGrowth {
    const NAME: &'static str = "reef_growth";
    const IN_TIME: &'static [&'static str] = &["max_rate"];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Bosscher & Schlager (1992)",
            title: "Computer simulation of reef growth, Sedimentology 39",
            doi: "10.1111/j.1365-3091.1992.tb02130.x",
        },
        Source {
            authors: "Nakamura & Nakamori (2007)",
            title: "A geochemical model for coral reef formation, Coral Reefs 26",
            doi: "10.1007/s00338-007-0262-6",
        },
        Source {
            authors: "Schlager, Reijmer & Droxler (1994)",
            title: "Highstand shedding of carbonate platforms, Journal of Sedimentary Research B64",
            doi: "",
        },
        Source {
            authors: "Neumann & Macintyre (1985)",
            title: "Reef response to sea level rise: keep-up, catch-up or give-up, Proceedings of the 5th International Coral Reef Congress 3",
            doi: "",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(130)
    }

    fn check(&self) -> Result<()> {
        if self.lagoon_depth.si() < self.open_depth.si() {
            let expected = format!("at least open_depth, {}", self.open_depth);
            return Err(Error::parameter("lagoon_depth", self.lagoon_depth, &expected));
        }
        Ok(())
    }
}
