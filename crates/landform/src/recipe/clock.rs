//! The clock of an `evolve` stage.

use landform_core::sim::Stop;
use landform_core::units::{Duration, Quantity};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// When a stage with processes starts, steps and stops.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Clock {
    /// Length of a step; must be given.
    #[schemars(extend("x-above" = 0.0))]
    pub dt: Duration,
    /// Time to run; or give `until` or `max_steps`.
    #[schemars(extend("x-min" = 0.0))]
    pub duration: Option<Duration>,
    /// "steady": stop when the greatest change of a step is below `tolerance` times what uplift alone would have raised.
    pub until: Option<Until>,
    /// See `until`.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1.0))]
    pub tolerance: f64,
    /// Most steps; 10,000 for a run until steady, if not given.
    #[schemars(extend("x-min" = 1))]
    pub max_steps: Option<u64>,
}

/// What to wait for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Until {
    /// Nothing changes any more.
    Steady,
}

impl Default for Clock {
    fn default() -> Self {
        Self { dt: Quantity::of(0.0), duration: None, until: None, tolerance: 1e-3, max_steps: None }
    }
}

impl Clock {
    /// When to stop.
    pub fn stop(&self) -> Stop {
        Stop {
            time: self.duration.map(Duration::si),
            steady: self.until.map(|Until::Steady| self.tolerance),
            steps: self.max_steps,
        }
    }

    pub(super) fn check(&self) -> Result<()> {
        if !(self.dt.si() > 0.0) {
            return Err(Error::parameter("dt", self.dt, "> 0 yr, for example \"1 kyr\""));
        }
        if self.duration.is_none() && self.until.is_none() && self.max_steps.is_none() {
            return Err(Error::parameter("clock", "without end", "`duration`, `until = \"steady\"` or `max_steps`"));
        }
        Ok(())
    }
}
