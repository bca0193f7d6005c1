//! How a recipe is run, and the signals of a run.

use std::path::PathBuf;

use landform_core::stage::Verb;
use landform_core::verb::{CancelToken, Outcome};

use super::cache::Cache;
use super::look::Looker;

/// A signal of a run while it goes on.
#[derive(Clone, Debug, PartialEq)]
pub enum Signal {
    /// A stage begins.
    Stage {
        /// From 1.
        index: usize,
        /// Number of stages.
        of: usize,
        /// Name.
        name: String,
        /// Whether its terrain was in the cache, so that it is not run.
        cached: bool,
        /// Whether its steps are rounds that have no length in time.
        timeless: bool,
    },
    /// A step of a process was taken.
    Step {
        /// Steps taken.
        steps: u64,
        /// Time, s.
        time: f64,
        /// Part done, 0 to 1, if it is known.
        part: Option<f64>,
        /// Residual, if steadiness is watched.
        residual: Option<f64>,
    },
    /// Processes came to an end.
    Outcome(Outcome),
    /// A note to the user.
    Note(String),
}

/// Takes signals.
pub type Progress<'a> = dyn Fn(Signal) + Sync + 'a;

/// How to run.
pub struct Options<'a> {
    /// Terrains of earlier runs, and where those of this one are kept.
    pub cache: Option<&'a Cache>,
    /// Where the state of an interrupted stage is kept; nowhere if none. What `watch` saw until
    /// then is kept in a folder beside it.
    pub checkpoint: Option<PathBuf>,
    /// Goes on from the checkpoint if it fits.
    pub resume: bool,
    /// Seconds of wall-clock time between checkpoints.
    pub checkpoint_every: f64,
    /// Part of the cache's keys that differs between builds of the program.
    pub salt: String,
    /// Asks the run to stop.
    pub cancel: CancelToken,
    /// Measures and files that the run makes beside the terrain.
    pub outputs: Outputs,
    /// Receives the signals of the run.
    pub progress: &'a Progress<'a>,
    /// Looks at the ground while processes run on it.
    pub look: Option<&'a dyn Looker>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            cache: None,
            checkpoint: None,
            resume: false,
            checkpoint_every: 60.0,
            salt: String::new(),
            cancel: CancelToken::default(),
            outputs: Outputs::All,
            progress: &|_| {},
            look: None,
        }
    }
}

/// What a run measures and writes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outputs {
    /// All that the recipe says.
    #[default]
    All,
    /// Its measures alone.
    Measures,
    /// Nothing: only the terrain is wanted.
    Nothing,
}

impl Outputs {
    pub(super) fn has(self, verb: Verb) -> bool {
        match self {
            Self::All => true,
            Self::Measures => verb == Verb::Measure,
            Self::Nothing => false,
        }
    }
}
