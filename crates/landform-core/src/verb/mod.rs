//! The verbs: what can be done to a landscape, and how each says what it needs.
//!
//! *Generate* a start, *edit* it, run a *process* over time, *convert* to another representation, *measure*, *export*.
//! A verb is a struct of parameters; the struct alone defines its words in recipes, defaults, ranges, help, schema and
//! citation. Parameters are immutable (`&self`) and state is a value, so a run is a function of (parameters, terrain, seed,
//! time step).

mod changing;
mod context;
mod environment;
mod features;
mod formula;
mod hints;
mod history;
mod maps;
mod outcome;
mod outlets;
mod output;
mod params;
mod reach;
mod role;
mod varying;
mod wind;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use serde::Serialize;
use serde::de::DeserializeOwned;

pub use changing::Changing;
pub use context::Context;
pub use environment::Environment;
pub use features::FeatureWord;
pub use formula::Formula;
pub use hints::add_hints;
pub use history::{Event, Landscape};
pub use maps::{Image, Maps, NoMaps};
pub use outcome::{Budget, Outcome, Stopped};
pub use outlets::{BorderWhere, Mask, NamedOutlets, Outlets};
pub use output::{MemoryOutput, Output, check_path, file_path, relative_path};
pub use params::{Params, Source, properties, validate_ranges};
pub use reach::{Margin, Reach, Window};
pub use role::{Role, coarser};
pub use varying::{Lookup, Resolved, Varying};
pub use wind::{Rose, Wind};

use crate::Result;
use crate::random::Seed;
use crate::terrain::Terrain;

/// How much a terrain will need, before it exists.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Number of nodes.
    pub nodes: u64,
    /// Bytes at the peak of the stage.
    pub bytes: u64,
    /// Extent east and north, m.
    pub extent: [f64; 2],
}

impl Estimate {
    /// Number of nodes of a raster over this extent.
    pub fn raster_nodes(&self, cell_size: f64) -> u64 {
        let count = |e: f64| (e / cell_size).round().max(1.0) + 1.0;
        (count(self.extent[0]) * count(self.extent[1])) as u64
    }
}

/// Makes a terrain.
pub trait Generator<T: Terrain>: Params {
    /// Makes the terrain.
    ///
    /// # Errors
    /// What the generator's parameters or files are wrong in.
    fn generate(&self, context: &Context) -> Result<T>;

    /// What it will need.
    ///
    /// # Errors
    /// As [`Generator::generate`], as far as can be told without making it.
    fn estimate(&self, context: &Context) -> Result<Estimate>;
}

/// Changes a terrain once, not as nature does.
pub trait Edit<T: Terrain>: Params {
    /// Changes the terrain.
    ///
    /// # Errors
    /// What the parameters are wrong in.
    fn edit(&self, terrain: &mut T, context: &Context) -> Result<()>;

    /// What it will need, given what the terrain is.
    fn estimate(&self, before: Estimate) -> Estimate {
        Estimate { bytes: before.nodes * 110, ..before }
    }
}

/// Changes the representation.
pub trait Convert<S: Terrain, T: Terrain>: Params {
    /// Makes the target from the source.
    ///
    /// # Errors
    /// What the parameters are wrong in.
    fn convert(&self, source: &S) -> Result<T>;

    /// What it will need, given what the source is.
    fn estimate(&self, source: Estimate) -> Estimate;
}

/// Reads a terrain and tells something about it.
pub trait Measure<T: Terrain>: Params {
    /// What it tells.
    type Out: Serialize;

    /// Where it is written, as JSON, below the output folder.
    fn path(&self) -> &str;

    /// Measures the terrain.
    ///
    /// # Errors
    /// What the terrain lacks.
    fn measure(&self, landscape: &Landscape<'_, T>) -> Result<Self::Out>;
}

/// Writes files about a terrain.
pub trait Export<T: Terrain>: Params {
    /// Writes to `out`.
    ///
    /// # Errors
    /// What the terrain lacks, or the output refuses.
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()>;
}

/// Changes a terrain over time.
pub trait Process<T: Terrain>: Params {
    /// Fields that it changes or leaves behind ("elevation" among them).
    const WRITES: &'static [&'static str];

    /// What must survive a checkpoint besides the terrain; scratch is `#[serde(skip)]`.
    type State: Serialize + DeserializeOwned + Send + 'static;

    /// Begins: resolves parameters that vary in space. Called once, and not on resume.
    ///
    /// # Errors
    /// What the terrain or the parameters are wrong in.
    fn start(&self, terrain: &mut T, context: &Context) -> Result<Self::State>;

    /// The clock of a process that counts its own rounds, for recipes that give none.
    fn own_clock(&self) -> Option<OwnClock> {
        None
    }

    /// Whether nothing is left to do; a run ends when all its processes say so.
    fn is_at_rest(&self, _terrain: &T, _state: &Self::State) -> bool {
        false
    }

    /// The longest step that may be taken, s; none if any.
    fn max_step(&self, _terrain: &T, _state: &Self::State) -> Option<f64> {
        None
    }

    /// Looks at the terrain as it is at the start of a step, before any process has changed it: flow of a step runs over
    /// this surface.
    ///
    /// # Errors
    /// What failed numerically.
    fn begin(&self, _terrain: &T, _state: &mut Self::State, _at: &Step) -> Result<()> {
        Ok(())
    }

    /// Looks at a terrain that was changed from outside, or at other parameters, in mid-run: nothing that was known of ground, status or sea
    /// holds any more. By default the process begins anew; what it lays down at the start of a run it must not lay down again
    /// ([`Context::step`] tells).
    ///
    /// # Errors
    /// As [`Process::start`].
    fn reconcile(&self, terrain: &mut T, state: &mut Self::State, context: &Context) -> Result<()> {
        *state = self.start(terrain, context)?;
        Ok(())
    }

    /// Advances by `at.dt`.
    ///
    /// # Errors
    /// What failed numerically.
    fn step(&self, terrain: &mut T, state: &mut Self::State, at: &Step) -> Result<Change>;

    /// Leaves derived fields behind, after the last step.
    ///
    /// # Errors
    /// What failed numerically.
    fn finish(&self, _terrain: &mut T, _state: &mut Self::State, _environment: &Environment) -> Result<()> {
        Ok(())
    }
}

/// The clock of a process that counts its own rounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnClock {
    /// Length of a round, s; a year where the process knows no time.
    pub dt: f64,
    /// Most rounds.
    pub rounds: u64,
    /// Whether `dt` means anything.
    pub is_timed: bool,
}

/// Where in time a step is.
#[derive(Clone, Debug)]
pub struct Step {
    /// Number of the step, from 0.
    pub index: u64,
    /// Most steps of the run, if that and nothing else ends it.
    pub of: Option<u64>,
    /// Time at the start of the step, s.
    pub time: f64,
    /// Length of the step, s.
    pub dt: f64,
    /// Seed of this step of this process.
    pub seed: Seed,
    /// Sea level, rain, winds and materials, where the process says nothing itself.
    pub environment: Arc<Environment>,
    /// To be polled by steps that take more than about a second.
    pub cancel: CancelToken,
}

/// What one step did. Volumes in m³ of solid.
///
/// Two sums must close: Δvolume = supplied + deposited − eroded, and eroded = deposited + exported + Δcarried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, serde::Deserialize)]
pub struct Change {
    /// Brought in from outside: uplift, growth.
    pub supplied: f64,
    /// Taken from the ground.
    pub eroded: f64,
    /// Laid down on the ground.
    pub deposited: f64,
    /// Left the domain.
    pub exported: f64,
    /// In transport at the end of the step less at its start.
    pub carried: f64,
    /// The greatest height by which supply raised the ground, m.
    pub raised: f64,
}

impl Change {
    /// The sum of two changes.
    pub fn plus(self, other: Self) -> Self {
        Self {
            supplied: self.supplied + other.supplied,
            eroded: self.eroded + other.eroded,
            deposited: self.deposited + other.deposited,
            exported: self.exported + other.exported,
            carried: self.carried + other.carried,
            raised: self.raised + other.raised,
        }
    }

    /// Change of the terrain's volume that follows, m³.
    pub fn volume(&self) -> f64 {
        self.supplied + self.deposited - self.eroded
    }
}

/// Asks a run to stop, from another thread or a signal.
#[derive(Clone, Debug, Default)]
pub struct CancelToken(Arc<AtomicBool>);

impl CancelToken {
    /// Asks.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether somebody asked.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
