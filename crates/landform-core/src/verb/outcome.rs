//! How a run ended.

use serde::{Deserialize, Serialize};

use super::Change;

/// Why a run stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Stopped {
    /// The time asked for was reached.
    EndTime,
    /// The number of steps allowed was used up.
    MaxSteps,
    /// The terrain changes no more.
    Steady,
    /// The run was cancelled; its state can be saved and resumed.
    Cancelled,
    /// An observer asked for it.
    ByObserver,
    /// No process had anything left to do.
    AtRest,
    /// No process had anything left to do, but one had not reached the end that its parameters ask
    /// for.
    AtRestTooSoon,
}

/// Volumes moved in a run, m³.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Budget {
    /// Sums over all steps and processes.
    pub change: Change,
    /// Volume of the terrain at the start, m³.
    pub volume_start: f64,
    /// Volume of the terrain at the end, m³.
    pub volume_end: f64,
}

impl Budget {
    /// The part of the volume moved that is unaccounted for: 0 up to rounding.
    pub fn imbalance(&self) -> f64 {
        let c = &self.change;
        let moved = c.supplied.abs() + c.eroded.abs() + c.deposited.abs();
        if moved == 0.0 { 0.0 } else { ((self.volume_end - self.volume_start - c.volume()) / moved).abs() }
    }

    /// The part of what was eroded that is neither deposited, exported nor carried: 0 up to
    /// rounding.
    pub fn sediment_imbalance(&self) -> f64 {
        let c = &self.change;
        if c.eroded == 0.0 { 0.0 } else { ((c.eroded - c.deposited - c.exported - c.carried) / c.eroded).abs() }
    }
}

/// How a run went.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// Why it stopped.
    pub stopped: Stopped,
    /// Steps taken.
    pub steps: u64,
    /// Time at the end, s.
    pub time: f64,
    /// The greatest change of the last step over what supply alone would have raised in it (over 1
    /// m, without supply); none if steadiness was not watched for.
    pub residual: Option<f64>,
    /// Volumes moved.
    pub budget: Budget,
}
