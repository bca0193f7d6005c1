//! Parameters of dunes.

use landform_core::grid::Grid;
use landform_core::units::{Angle, Diffusivity, Length, LengthDimension};
use landform_core::verb::{Environment, Params, Rose, Source, Varying, Wind};
use landform_core::{Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which rules move the sand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Model {
    /// Slabs that hop downwind and come to rest in the shadow of higher sand (Werner 1995).
    #[default]
    Werner,
    /// As `werner`, but sand protects a cone downwind of it instead of casting a shadow (Pytel 2015).
    Protection,
    /// A wind slowed by rises carries sand to the lowest of three cells downwind (Koh 2002).
    Koh,
}

/// How the sides of the map treat sand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Borders {
    /// Sand that leaves on one side enters on the opposite one.
    #[default]
    Periodic,
    /// Sand that leaves is lost.
    Open,
}

/// Dunes: wind piles up loose sand on hard ground. The amount of sand and the directions of the wind decide whether barchans,
/// transverse, linear or star dunes form. Runs without a clock for `iterations` rounds, whose length in time follows from `flux`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Dunes {
    /// Rules that move the sand.
    pub model: Model,
    /// Depth of sand that is added at the start to the sand on the ground; none is added under water.
    pub sand: Varying<LengthDimension>,
    /// Winds, each with the compass direction that it comes from and the fraction of the time that it blows. If none are given,
    /// they are the environment's, or else a west wind.
    pub wind: Vec<Wind>,
    /// Number of rounds that a wind blows before the next is drawn.
    #[schemars(extend("x-min" = 1))]
    pub spell: u64,
    /// Distance that sand is carried in one hop.
    #[schemars(extend("x-above" = 0.0))]
    pub hop: Length,
    /// Number of rounds, if there is no clock. In each round the wind acts once on average on every site.
    #[schemars(extend("x-max" = 1e7))]
    pub iterations: u64,
    /// Thickness of a slab. If not given, it is half of the greatest step between neighbours (a third of a cell); with `koh` a
    /// sixth of it.
    #[schemars(extend("x-above" = 0.0))]
    pub slab: Option<Length>,
    /// Number k of refinements at the end: 2 more rounds with half slabs, 4 with quarters, up to 2^k with slabs of a 2^k-th.
    #[schemars(extend("x-max" = 6))]
    pub refinements: u32,
    /// Probability that sand which lands on sand stays.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1.0))]
    pub stay_on_sand: f64,
    /// Probability that sand which lands on hard ground stays.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1.0))]
    pub stay_on_ground: f64,
    /// Angle of repose.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub repose: Angle,
    /// Werner: angle of the wind shadow behind a rise: the wind does not reach the ground below it.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub shadow: Angle,
    /// Protection: distance downwind that a site protects.
    #[schemars(extend("x-above" = 0.0))]
    pub reach: Length,
    /// Protection: half-angle of the protected cone, to either side of the wind.
    #[schemars(extend("x-min" = 0.0, "x-max" = 90.0))]
    pub cone: Angle,
    /// Koh: fraction of its strength that the wind loses behind a drop of one in one.
    #[schemars(extend("x-min" = 0.0))]
    pub wind_loss: f64,
    /// Koh: distance over which slowed wind recovers. If not given, it never does.
    #[schemars(extend("x-above" = 0.0))]
    pub wind_recovery: Option<Length>,
    /// Koh: strength below which wind carries nothing.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub threshold: f64,
    /// Koh: steepest rise that sand is blown up.
    #[schemars(extend("x-min" = 0.0, "x-max" = 80.0))]
    pub steepest_climb: Angle,
    /// Distance, in cells, over which diffusion smooths the sand at the end. It removes grooves that follow the lattice.
    #[schemars(extend("x-min" = 0.0, "x-max" = 50.0))]
    pub smoothing: f64,
    /// Sand that the wind could carry in a year across each metre of width, over open sand. It sets the length of a round in
    /// time.
    #[schemars(extend("x-above" = 0.0))]
    pub flux: Diffusivity,
    /// How the sides of the map treat sand.
    pub borders: Borders,
    /// Sea level: sand that falls on ground under it is lost. If not given, it is the environment's, or else 0 m.
    pub sea_level: Option<Length>,
}

impl Default for Dunes {
    fn default() -> Self {
        Self {
            model: Model::Werner,
            sand: Length::of(3.0).into(),
            wind: Vec::new(),
            spell: 1,
            hop: Length::of(10.0),
            iterations: 200,
            slab: None,
            refinements: 3,
            stay_on_sand: 0.6,
            stay_on_ground: 0.4,
            repose: Angle::of(33.0),
            shadow: Angle::of(15.0),
            reach: Length::of(20.0),
            cone: Angle::of(15.0),
            wind_loss: 1.0,
            wind_recovery: Some(Length::of(10.0)),
            threshold: 0.2,
            steepest_climb: Angle::of(25.0),
            smoothing: 1.0,
            flux: Diffusivity::of(30.0),
            borders: Borders::Periodic,
            sea_level: None,
        }
    }
}

impl Params for Dunes {
    const NAME: &'static str = "dunes";
    const RENAMED: &'static [(&'static str, &'static str)] = &[("steps", "iterations")];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Werner (1995)",
            title: "Eolian dunes: computer simulations and attractor interpretation, Geology 23(12)",
            doi: "10.1130/0091-7613(1995)023<1107:EDCSAA>2.3.CO;2",
        },
        Source {
            authors: "Pytel (2015)",
            title: "Erosion, Self-Organization, and Procedural Modeling, thesis, University of Waterloo, section 4.1",
            doi: "",
        },
        Source {
            authors: "Koh (2002)",
            title: "Dramatic Landscapes: Cellular Automata Modeling of Landscape Phenomena, thesis, Monash University, section 5.2",
            doi: "",
        },
    ];

    fn check(&self) -> Result<()> {
        if self.wind.is_empty() { Ok(()) } else { Rose::new("wind", &self.wind).map(drop) }
    }
}

/// Finest parts of a slab that the field of sand counts in.
pub(super) const UNITS_A_SLAB: i32 = 1 << 6;

impl Dunes {
    /// Sea level, m.
    pub(super) fn sea_at(&self, environment: &Environment, time: f64) -> f64 {
        environment.level_or(self.sea_level, time)
    }

    /// The winds.
    pub(super) fn rose(&self, environment: &Environment) -> Result<Rose> {
        environment.rose(&self.wind)
    }

    /// Thickness of a slab on cells of a size, m.
    pub(super) fn slab_on(&self, grid: &Grid) -> f64 {
        let cell = grid.spacing[0].min(grid.spacing[1]);
        let slabs_a_step = if self.model == Model::Koh { 6.0 } else { 2.0 };
        self.slab.map_or(math::tan(self.repose.si()) * cell / slabs_a_step, Length::si)
    }

    /// Length of a round, s: with it, open sand that hops as it should carries `flux`.
    pub(super) fn round(&self, slab: f64) -> f64 {
        slab * self.hop.si() / (self.stay_on_sand * self.flux.si())
    }

    /// Rounds with finer slabs at the end.
    pub(super) fn fine_rounds(&self) -> u64 {
        (1u64 << (self.refinements + 1)) - 2
    }

    /// Units of a slab in a round of a run of `iterations` and finer rounds.
    pub(super) fn slab_units(&self, round: u64) -> i32 {
        let Some(mut later) = round.checked_sub(self.iterations.max(1)) else { return UNITS_A_SLAB };
        for k in 1..=self.refinements {
            if later < 1 << k {
                return UNITS_A_SLAB >> k;
            }
            later -= 1 << k;
        }
        UNITS_A_SLAB >> self.refinements
    }
}
