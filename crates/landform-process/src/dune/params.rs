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
    /// Slabs that hop downwind and rest in the shadow of higher sand (Werner 1995).
    #[default]
    Werner,
    /// As `werner`, but sand protects a cone downwind of it instead of casting a shadow (Pytel 2015).
    Protection,
    /// A wind slowed by rises carries sand to the lowest of three cells downwind (Koh 2002).
    Koh,
}

/// What happens to sand at the sides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Borders {
    /// What leaves on one side enters on the other.
    #[default]
    Periodic,
    /// What leaves is gone.
    Open,
}

/// Dunes: wind piles loose sand on hard ground. Barchans, transverse, linear and star dunes follow from how much sand there is and how the
/// wind turns. Runs without a clock for `iterations` rounds, each as long as `flux` makes it.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Dunes {
    /// Rules that move the sand.
    pub model: Model,
    /// Depth of sand laid on the ground at the start, beside the sand that lies there; none is laid under water.
    pub sand: Varying<LengthDimension>,
    /// Winds and the part of the time that each blows, by the compass direction that it comes from. As the environment
    /// has them, if none are given; else a west wind.
    pub wind: Vec<Wind>,
    /// Rounds that a wind blows before the next is drawn.
    #[schemars(extend("x-min" = 1))]
    pub spell: u64,
    /// Distance that sand is carried at once.
    #[schemars(extend("x-above" = 0.0))]
    pub hop: Length,
    /// Rounds, if there is no clock; in each every place is blown at once on average.
    #[schemars(extend("x-max" = 1e7))]
    pub iterations: u64,
    /// Thickness of a slab; half of the greatest step between neighbours if not given (a third of a cell), with `koh` a sixth of it.
    #[schemars(extend("x-above" = 0.0))]
    pub slab: Option<Length>,
    /// Further rounds with finer slabs: 2 with a half, 4 with a quarter, up to 2^k with a 2^k-th.
    #[schemars(extend("x-max" = 6))]
    pub refinements: u32,
    /// Chance that sand which comes down stays, on sand.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1.0))]
    pub stay_on_sand: f64,
    /// Chance that sand which comes down stays, on hard ground.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1.0))]
    pub stay_on_ground: f64,
    /// Angle of repose.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub repose: Angle,
    /// Werner: angle below which the wind does not reach down behind a rise.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub shadow: Angle,
    /// Protection: how far downwind a place protects.
    #[schemars(extend("x-above" = 0.0))]
    pub reach: Length,
    /// Protection: angle to either side of the wind of the cone that is protected.
    #[schemars(extend("x-min" = 0.0, "x-max" = 90.0))]
    pub cone: Angle,
    /// Koh: part of its strength that the wind loses behind a drop of one in one.
    #[schemars(extend("x-min" = 0.0))]
    pub wind_loss: f64,
    /// Koh: distance over which wind that was slowed comes back; never, if not given.
    #[schemars(extend("x-above" = 0.0))]
    pub wind_recovery: Option<Length>,
    /// Koh: strength below which wind carries nothing.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub threshold: f64,
    /// Koh: steepest rise that sand is blown up.
    #[schemars(extend("x-min" = 0.0, "x-max" = 80.0))]
    pub steepest_climb: Angle,
    /// Distance, in cells, over which diffusion smooths the sand at the end; takes away grooves that the lattice leaves.
    #[schemars(extend("x-min" = 0.0, "x-max" = 50.0))]
    pub smoothing: f64,
    /// Sand that the wind could carry a year across each metre of width, over open sand; says how long a round is.
    #[schemars(extend("x-above" = 0.0))]
    pub flux: Diffusivity,
    /// What happens to sand at the sides.
    pub borders: Borders,
    /// Sea level: sand that falls on ground under it is lost. As the environment has it, if not given; else 0 m.
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
            title: "Self-organized procedural modeling of terrains, University of Waterloo, section 4.1",
            doi: "",
        },
        Source { authors: "Koh (2002)", title: "Dramatic landscapes, Monash University, section 5.2", doi: "" },
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
