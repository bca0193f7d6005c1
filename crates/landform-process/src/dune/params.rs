//! Parameters of dunes.

use landform_core::grid::Grid;
use landform_core::units::{Angle, Diffusivity, Length, LengthDimension};
use landform_core::verb::{Environment, Params, Rose, Source, Varying, Wind};
use landform_core::{Error, Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which rules move the sand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Model {
    /// Slabs that hop downwind and come to rest in the shadow of higher sand (Werner 1995).
    #[default]
    Werner,
    /// As `werner`, but sand protects a cone downwind of it instead of casting a shadow (Pytel
    /// 2015).
    Protection,
    /// A wind slowed behind rises carries sand to the lowest of three places downwind (Koh 2002).
    Koh,
}

impl Model {
    fn name(self) -> &'static str {
        match self {
            Self::Werner => "werner",
            Self::Protection => "protection",
            Self::Koh => "koh",
        }
    }
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

/// Dunes: wind piles up loose sand on hard ground. The amount of sand and the directions of the
/// wind decide whether barchans, transverse, linear or star dunes form. Runs without a clock for
/// `iterations` rounds, whose length in time follows from `flux`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Dunes {
    /// Rules that move the sand.
    pub model: Model,
    /// Depth of sand that is added at the start to the sand on the ground; none is added under
    /// water.
    pub sand: Varying<LengthDimension>,
    /// Winds, each with the compass direction that it comes from and the fraction of the time that
    /// it blows. If none are given, they are the environment's, or else a west wind.
    pub wind: Vec<Wind>,
    /// Number of rounds that a wind blows before the next is drawn.
    #[schemars(extend("x-min" = 1))]
    pub spell: u64,
    /// Werner and protection: distance that sand is carried in one hop. If not given, it is 10 m.
    #[schemars(extend("x-above" = 0.0))]
    pub hop: Option<Length>,
    /// Number of rounds, if there is no clock. In each round the wind acts once on average on every
    /// site.
    #[schemars(extend("x-max" = 1e7))]
    pub iterations: u64,
    /// Thickness of a slab. If not given, it is half of the greatest step between neighbours (a
    /// third of a cell); with `koh` a sixth of it.
    #[schemars(extend("x-above" = 0.0))]
    pub slab: Option<Length>,
    /// Number k of refinements at the end: 2 more rounds with half slabs, 4 with quarters, up to
    /// 2^k with slabs of a 2^k-th.
    #[schemars(extend("x-max" = 6))]
    pub refinements: u32,
    /// Werner and protection: probability that sand which lands on sand stays. If not given, it is
    /// 0.6.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1.0))]
    pub stay_on_sand: Option<f64>,
    /// Werner and protection: probability that sand which lands on hard ground stays. If not given,
    /// it is 0.4.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1.0))]
    pub stay_on_ground: Option<f64>,
    /// Angle of repose.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub repose: Angle,
    /// Werner: angle of the wind shadow behind a rise: the wind does not reach the ground below it.
    /// If not given, it is 15 degrees.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub shadow: Option<Angle>,
    /// Protection: distance downwind that a site protects, as in the thesis. If not given, it
    /// follows from the height of the sand: as far as its shadow at 15 degrees reaches.
    #[schemars(extend("x-above" = 0.0))]
    pub reach: Option<Length>,
    /// Protection: half-angle of the protected cone, to either side of the wind. If not given, it
    /// is 15 degrees.
    #[schemars(extend("x-min" = 0.0, "x-max" = 90.0))]
    pub cone: Option<Angle>,
    /// Koh: fraction of its strength that the wind loses behind a drop of one in one. If not given,
    /// it is 1.
    #[schemars(extend("x-min" = 0.0))]
    pub wind_loss: Option<f64>,
    /// Koh: distance over which slowed wind recovers. If not given, it is 10 m.
    #[schemars(extend("x-above" = 0.0))]
    pub wind_recovery: Option<Length>,
    /// Koh: strength below which wind carries nothing. If not given, it is 0.2.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub threshold: Option<f64>,
    /// Koh: steepest windward side from which sand is blown. If not given, it is 25 degrees.
    #[schemars(extend("x-min" = 0.0, "x-max" = 80.0))]
    pub steepest_climb: Option<Angle>,
    /// Distance, in cells, over which diffusion smooths the sand at the end. It removes grooves
    /// that follow the lattice.
    #[schemars(extend("x-min" = 0.0, "x-max" = 50.0))]
    pub smoothing: f64,
    /// Sand that the wind could carry in a year across each metre of width, over open sand. It sets
    /// the length of a round in time.
    #[schemars(extend("x-above" = 0.0))]
    pub flux: Diffusivity,
    /// How the sides of the map treat sand.
    pub borders: Borders,
    /// Sea level: sand that falls on ground under it is lost. If not given, it is the
    /// environment's, or else 0 m.
    pub sea_level: Option<Length>,
}

impl Default for Dunes {
    fn default() -> Self {
        Self {
            model: Model::Werner,
            sand: Length::of(3.0).into(),
            wind: Vec::new(),
            spell: 1,
            hop: None,
            iterations: 200,
            slab: None,
            refinements: 3,
            stay_on_sand: None,
            stay_on_ground: None,
            repose: Angle::of(33.0),
            shadow: None,
            reach: None,
            cone: None,
            wind_loss: None,
            wind_recovery: None,
            threshold: None,
            steepest_climb: None,
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
        if !self.wind.is_empty() {
            Rose::new("wind", &self.wind)?;
        }
        self.check_model()
    }
}

/// Finest parts of a slab that the field of sand counts in.
pub(super) const UNITS_A_SLAB: i32 = 1 << 6;

impl Dunes {
    /// Refuses parameters that the model does not have.
    fn check_model(&self) -> Result<()> {
        use Model::{Koh, Protection, Werner};
        let hops: &[Model] = &[Werner, Protection];
        let given: [(&str, bool, &[Model]); 10] = [
            ("hop", self.hop.is_some(), hops),
            ("stay_on_sand", self.stay_on_sand.is_some(), hops),
            ("stay_on_ground", self.stay_on_ground.is_some(), hops),
            ("shadow", self.shadow.is_some(), &[Werner]),
            ("reach", self.reach.is_some(), &[Protection]),
            ("cone", self.cone.is_some(), &[Protection]),
            ("wind_loss", self.wind_loss.is_some(), &[Koh]),
            ("wind_recovery", self.wind_recovery.is_some(), &[Koh]),
            ("threshold", self.threshold.is_some(), &[Koh]),
            ("steepest_climb", self.steepest_climb.is_some(), &[Koh]),
        ];
        let foreign = given.into_iter().find(|(_, is_given, models)| *is_given && !models.contains(&self.model));
        let Some((name, _, models)) = foreign else { return Ok(()) };
        let of: Vec<String> = models.iter().map(|m| format!("\"{}\"", m.name())).collect();
        let value = format!("given with model = \"{}\"", self.model.name());
        Err(Error::parameter(name, value, &format!("model = {}, or no `{name}`", of.join(" or "))))
    }

    /// Distance of a hop, m; with `koh` a cell.
    pub(super) fn hop(&self, grid: &Grid) -> f64 {
        match self.model {
            Model::Koh => grid.spacing[0].min(grid.spacing[1]),
            _ => self.hop.map_or(10.0, Length::si),
        }
    }

    /// Probability that sand stays which lands on sand.
    pub(super) fn stay_on_sand(&self) -> f64 {
        match self.model {
            Model::Koh => 1.0,
            _ => self.stay_on_sand.unwrap_or(0.6),
        }
    }

    /// Probability that sand stays which lands on hard ground.
    pub(super) fn stay_on_ground(&self) -> f64 {
        self.stay_on_ground.unwrap_or(0.4)
    }

    /// Angle of shadows, radians.
    pub(super) fn shadow(&self) -> f64 {
        self.shadow.unwrap_or(Angle::of(15.0)).si()
    }

    /// Half-angle of what a site protects, radians.
    pub(super) fn cone(&self) -> f64 {
        self.cone.unwrap_or(Angle::of(15.0)).si()
    }

    /// Loss of wind behind drops.
    pub(super) fn wind_loss(&self) -> f64 {
        self.wind_loss.unwrap_or(1.0)
    }

    /// Distance over which the wind recovers, m.
    pub(super) fn wind_recovery(&self) -> f64 {
        self.wind_recovery.map_or(10.0, Length::si)
    }

    /// Least strength of wind that carries.
    pub(super) fn threshold(&self) -> f64 {
        self.threshold.unwrap_or(0.2)
    }

    /// Steepest windward side that gives sand, radians.
    pub(super) fn steepest_climb(&self) -> f64 {
        self.steepest_climb.unwrap_or(Angle::of(25.0)).si()
    }

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
    pub(super) fn round(&self, grid: &Grid, slab: f64) -> f64 {
        slab * self.hop(grid) / (self.stay_on_sand() * self.flux.si())
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
