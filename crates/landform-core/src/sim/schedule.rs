//! When observers are called, and when a run stops.

use serde::{Deserialize, Serialize};

/// How often an observer is called.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Every {
    /// After every such number of steps.
    Steps(u64),
    /// At every multiple of a time, s; steps are shortened to end there.
    Time(f64),
    /// After this many seconds of wall-clock time.
    Wall(f64),
}

/// When a run stops: at the first of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Stop {
    /// Time to reach, s.
    pub time: Option<f64>,
    /// Greatest residual that counts as steady.
    pub steady: Option<f64>,
    /// Greatest number of steps.
    pub steps: Option<u64>,
}

impl Stop {
    /// Stop at a time, s.
    pub fn time(seconds: f64) -> Self {
        Self { time: Some(seconds), ..Self::default() }
    }

    /// Stop after a number of steps.
    pub fn steps(steps: u64) -> Self {
        Self { steps: Some(steps), ..Self::default() }
    }

    /// Stop when steady: a part of what uplift alone would have raised.
    pub fn steady(tolerance: f64) -> Self {
        Self { steady: Some(tolerance), ..Self::default() }
    }

    /// Also stop when steady: a part of what uplift alone would have raised.
    pub fn or_steady(self, tolerance: f64) -> Self {
        Self { steady: Some(tolerance), ..self }
    }

    /// Also stop after a number of steps.
    pub fn or_steps(self, steps: u64) -> Self {
        Self { steps: Some(steps), ..self }
    }
}

/// The first multiple of `interval` after `time`.
pub(super) fn next_multiple(time: f64, interval: f64) -> f64 {
    let k = (time / interval * (1.0 + 1e-12)).floor() + 1.0;
    k * interval
}
