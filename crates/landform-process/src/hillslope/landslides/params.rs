//! Parameters of landslides.

use landform_core::units::{Angle, AngleDimension, Area, Duration, KYR};
use landform_core::verb::{Params, Source, Varying};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Deep landslides: rock that stands higher than its strength allows breaks off along a rupture
/// surface, runs down and comes to rest below, as a deposit that rivers can carry away.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Landslides {
    /// Cohesion of the rock mass, Pa. Fractured rock has 1e3 to 1e6, far less than a piece of it.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e8))]
    pub cohesion: f64,
    /// Angle of internal friction; may vary in space. Ground that is less steep never fails. If not
    /// given, it is the angle of repose of the uppermost material on layered ground, and 35 deg on
    /// other ground.
    #[schemars(extend("x-above" = 0.0, "x-max" = 85.0))]
    pub friction_angle: Option<Varying<AngleDimension>>,
    /// Density of the rock, kg/m³.
    #[schemars(extend("x-above" = 0.0, "x-max" = 30_000.0))]
    pub density: f64,
    /// Time in which ground that stands just at its critical height fails once on average: in a
    /// step of dt it fails with the probability (height/critical height) dt/return time, or surely
    /// where that is above 1.
    #[schemars(extend("x-above" = 0.0))]
    pub return_time: Duration,
    /// Slope of the ground on which debris comes to rest; deposits build up to a tenth more.
    #[schemars(extend("x-above" = 0.0, "x-max" = 60.0))]
    pub runout_angle: Angle,
    /// Part of the debris that leaves the map as fine material in suspension.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub fines: f64,
    /// Greatest area of one slide. If not given, a slide takes all the ground that stands above its
    /// rupture surface.
    #[schemars(extend("x-above" = 0.0))]
    pub greatest_area: Option<Area>,
    /// Whether ground without layers is given them, so that deposits lie on it as loose gravel that
    /// rivers carry away more easily than rock. On layered ground they always do; on other ground
    /// they are as rock if this is false.
    pub loose: bool,
}

impl Default for Landslides {
    fn default() -> Self {
        Self {
            cohesion: 1e4,
            friction_angle: None,
            density: 2700.0,
            return_time: Duration::from_si(100.0 * KYR),
            runout_angle: Angle::of(20.0),
            fines: 0.0,
            greatest_area: None,
            loose: false,
        }
    }
}

impl Params for Landslides {
    const NAME: &'static str = "landslides";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Campforts et al. (2020)",
            title: "HyLands 1.0: a hybrid landscape evolution model to simulate the impact of landslides and landslide-derived sediment on landscape evolution, Geoscientific Model Development 13",
            doi: "10.5194/gmd-13-3863-2020",
        },
        Source {
            authors: "Densmore, Ellis & Anderson (1998)",
            title: "Landsliding and the evolution of normal-fault-bounded mountains, JGR Solid Earth 103(B7)",
            doi: "10.1029/98JB00510",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(52)
    }
}
