//! The clock of an `evolve` stage.

use landform_core::sim::Stop;
use landform_core::units::{Duration, MYR, Quantity};
use landform_core::verb::OwnClock;
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How often cells can be halved in a timed run: the levels that `--level` has.
pub(super) const MOST_HALVINGS: u32 = 6;

/// When a stage with processes starts, steps and stops.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Clock {
    /// Length of a step. It must be given, unless a steady state is refined: then it is 1 Gyr.
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
    /// Number of coarser levels, each with cells of twice the length. With `duration` the run
    /// begins on the coarsest and its cells are halved on the way (see `refine_at`): rivers are
    /// then those of the recipe at that level. With `until = "steady"` each level is made steady,
    /// and starts the next; that needs a sea level that does not change.
    #[schemars(extend("x-max" = 12))]
    pub refine: u32,
    /// Times at which cells are halved, with `duration`, in order: `refine` of them. If not given,
    /// the finest cells run for the last quarter of the time, and each coarser level until two
    /// thirds of the time at which the next ends.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub refine_at: Vec<Duration>,
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
            refine_at: Vec::new(),
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
        if self.refine > 0 && self.until.is_some() && self.dt.si() == 0.0 { 1e3 * MYR } else { self.dt.si() }
    }

    pub(super) fn check(&self) -> Result<()> {
        if !(self.step() > 0.0) {
            return Err(Error::parameter("dt", self.dt, "> 0 yr, for example \"1 kyr\""));
        }
        self.check_levels()?;
        if self.duration.is_none() && self.until.is_none() && self.iterations.is_none() {
            return Err(Error::parameter("clock", "without end", "`duration`, `until = \"steady\"` or `iterations`"));
        }
        Ok(())
    }

    /// Times at which cells are halved in a run of a duration, s; none in any other.
    pub(super) fn halvings(&self) -> Vec<f64> {
        let Some(duration) = self.duration.filter(|_| self.until.is_none()) else { return Vec::new() };
        if !self.refine_at.is_empty() {
            return self.refine_at.iter().map(|t| t.si()).collect();
        }
        let whole_steps = |t: f64| (t / self.dt.si()).round() * self.dt.si();
        let ends = std::iter::successors(Some(0.75 * duration.si()), |end| Some(end / 1.5));
        let mut times: Vec<f64> = ends.take(self.refine as usize).map(whole_steps).collect();
        times.reverse();
        times
    }

    /// The clock on cells that are twice as long, this many times over: a run goes as it did until
    /// cells would become finer.
    pub(super) fn coarsen(&mut self, halvings: usize) {
        let times = self.halvings();
        if !times.is_empty() {
            let left = &times[..times.len().saturating_sub(halvings)];
            self.refine_at = left.iter().map(|&t| Quantity::from_si(t)).collect();
            self.refine = left.len() as u32;
        }
    }

    fn check_levels(&self) -> Result<()> {
        let timed = self.until.is_none();
        if !self.refine_at.is_empty() {
            if !timed {
                return Err(Error::parameter("refine_at", "given beside `until`", "`duration` without `until`"));
            }
            let n = self.refine_at.len();
            if self.refine as usize != n {
                return Err(Error::parameter("refine", self.refine, &format!("{n}, as many as times in `refine_at`")));
            }
        }
        if timed && (self.refine > 0 || !self.refine_at.is_empty()) {
            let Some(duration) = self.duration.filter(|_| self.iterations.is_none()) else {
                let hint = "0 unless the clock has `duration` alone, or `until = \"steady\"`";
                return Err(Error::parameter("refine", self.refine, hint));
            };
            let times = self.halvings();
            if times.len() > MOST_HALVINGS as usize {
                let most = format!("at most {MOST_HALVINGS} with `duration`");
                return Err(Error::parameter("refine", times.len(), &most));
            }
            let rises = times.windows(2).all(|t| t[0] < t[1]);
            if !(rises && times.iter().all(|&t| t > 0.0 && t < duration.si())) {
                if self.refine_at.is_empty() {
                    let short = format!("shorter steps: cells are to be halved {} times in {duration}", times.len());
                    return Err(Error::parameter("dt", self.dt, &short));
                }
                let listed: Vec<String> = self.refine_at.iter().map(ToString::to_string).collect();
                let wanted = format!("times that rise, between 0 yr and {duration}");
                return Err(Error::parameter("refine_at", listed.join(", "), &wanted));
            }
        }
        Ok(())
    }
}
