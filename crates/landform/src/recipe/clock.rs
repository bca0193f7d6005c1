//! The clock of an `evolve` stage.

use landform_core::sim::Stop;
use landform_core::units::{Duration, MYR, Quantity};
use landform_core::verb::OwnClock;
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// When a stage with processes starts, steps and stops.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Clock {
    /// Length of a step. It must be given, unless `refine` is given: then it is 1 Gyr.
    #[schemars(extend("x-min" = 0.0))]
    pub dt: Duration,
    /// Time to run. Instead, `until` or `iterations` may be given.
    #[schemars(extend("x-min" = 0.0))]
    pub duration: Option<Duration>,
    /// "steady": the run stops when the greatest change of a step is at most `tolerance` times what
    /// uplift alone would have raised (or times the relief, where uplift in a long step would have
    /// raised more).
    pub until: Option<Until>,
    /// Tolerance of `until`. With 0 the run stops when no bit changes (some runs end in a cycle of
    /// the last bit, which 1e-12 takes as steady).
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub tolerance: f64,
    /// Greatest number of steps. If not given, it is 10,000 for a run until steady.
    #[schemars(extend("x-min" = 1))]
    pub iterations: Option<u64>,
    /// Number of coarser levels, each with a quarter of the nodes, that are made steady first, each
    /// from the one before. The finest level then needs tens of steps rather than hundreds. It
    /// needs `until = "steady"` alone, and a sea level that does not change.
    #[schemars(extend("x-max" = 12))]
    pub refine: u32,
    /// Whether the clock counts rounds that have no length in time.
    #[serde(skip)]
    pub timeless: bool,
}

/// Condition that ends a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Until {
    /// The terrain is steady.
    Steady,
}

impl Default for Clock {
    fn default() -> Self {
        Self {
            dt: Quantity::of(0.0),
            duration: None,
            until: None,
            tolerance: 1e-3,
            iterations: None,
            refine: 0,
            timeless: false,
        }
    }
}

impl Clock {
    /// Keys of earlier recipes.
    pub(super) const RENAMED: &'static [(&'static str, &'static str)] = &[("max_steps", "iterations")];

    /// The clock of a process that counts its own rounds.
    pub(super) fn of_rounds(own: OwnClock) -> Self {
        Self { dt: Quantity::from_si(own.dt), iterations: Some(own.rounds), timeless: !own.is_timed, ..Self::default() }
    }

    /// When to stop.
    pub fn stop(&self) -> Stop {
        Stop {
            time: self.duration.map(Duration::si),
            steady: self.until.map(|Until::Steady| self.tolerance),
            steps: self.iterations,
        }
    }

    /// Length of a step, s.
    pub fn step(&self) -> f64 {
        if self.refine > 0 && self.dt.si() == 0.0 { 1e3 * MYR } else { self.dt.si() }
    }

    pub(super) fn check(&self) -> Result<()> {
        if self.refine > 0 && self.until.is_none() {
            return Err(Error::parameter(
                "refine",
                self.refine,
                "0 without `until = \"steady\"`: the way there is no history",
            ));
        }
        if !(self.step() > 0.0) {
            return Err(Error::parameter("dt", self.dt, "> 0 yr, for example \"1 kyr\""));
        }
        if self.duration.is_none() && self.until.is_none() && self.iterations.is_none() {
            return Err(Error::parameter("clock", "without end", "`duration`, `until = \"steady\"` or `iterations`"));
        }
        Ok(())
    }
}
