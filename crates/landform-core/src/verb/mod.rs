//! The verbs: the kinds of stages, and the traits that they implement.
//!
//! *Generate* a start, *edit* it, run a *process* over time, *convert* to another
//! representation, *measure*, *export*. A verb is a struct of parameters; the struct alone defines
//! its words in recipes, defaults, ranges, help, schema and citation. Parameters are immutable
//! (`&self`) and state is a value, so a run is a function of (parameters, terrain, seed, time
//! step).

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
mod spans;
mod strokes;
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
pub use formula::{CellCall, CellFormula, CellFunction, Cells, Formula, Words};
pub use hints::add_hints;
pub use history::{Event, Landscape};
pub use maps::{Image, Maps, NoMaps};
pub use outcome::{Budget, Outcome, Stopped};
pub use outlets::{BorderWhere, Mask, NamedOutlets, Outlets};
pub use output::{MemoryOutput, Output, check_path, file_path, is_plain_name, relative_path};
pub use params::{Params, Source, properties, schema_of, validate_ranges};
pub use reach::{Margin, Reach, Window};
pub use role::{Role, coarser};
pub use spans::{LengthSpan, SlopeSpan};
pub use strokes::{Stroke, Tool, covered};
pub use varying::{Lookup, Resolved, Varying};
pub use wind::{Rose, Wind};

use crate::Result;
use crate::random::Seed;
use crate::terrain::Terrain;

/// Size and memory of a terrain, before it exists.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Number of nodes, or of voxels.
    pub nodes: u64,
    /// Number of columns that voxels stand in; 0 for surfaces.
    pub columns: u64,
    /// Bytes at the peak of the stage.
    pub bytes: u64,
    /// Extent east and north, m.
    pub extent: [f64; 2],
    /// The south-west corner, m; none if it is not known before a run.
    pub origin: Option<[f64; 2]>,
}

impl Estimate {
    /// Mean distance of nodes, m; none where extent or nodes are not known.
    ///
    /// ```
    /// use landform_core::verb::Estimate;
    ///
    /// let map = Estimate { extent: [1000.0, 500.0], nodes: 20_000, ..Estimate::default() };
    /// assert_eq!(map.spacing(), Some(5.0));
    /// assert_eq!(Estimate::default().spacing(), None);
    /// ```
    pub fn spacing(&self) -> Option<f64> {
        let spacing = (self.extent[0] * self.extent[1] / self.nodes as f64).sqrt();
        (spacing > 0.0 && spacing.is_finite()).then_some(spacing)
    }

    /// Number of nodes of a raster over this extent, with cells of so many metres.
    ///
    /// ```
    /// use landform_core::verb::Estimate;
    ///
    /// let map = Estimate { extent: [1000.0, 500.0], ..Estimate::default() };
    /// assert_eq!(map.raster_nodes(10.0), 101 * 51);
    /// ```
    pub fn raster_nodes(&self, cell_size: f64) -> u64 {
        let count = |e: f64| (e / cell_size).round().max(1.0) + 1.0;
        // More than any memory holds, and few enough for sums of bytes.
        (count(self.extent[0]) * count(self.extent[1])).min(1e15) as u64
    }
}

/// Bytes a node of elevations and what a raster always holds beside them.
///
/// ```
/// // A thousand by a thousand nodes.
/// assert_eq!(landform_core::verb::ELEVATIONS * 1_000_000 >> 20, 15);
/// ```
pub const ELEVATIONS: u64 = 16;

/// Makes a terrain.
pub trait Generator<T: Terrain>: Params {
    /// Makes the terrain.
    ///
    /// # Errors
    /// If a parameter or a file is wrong.
    fn generate(&self, context: &Context) -> Result<T>;

    /// What it will need.
    ///
    /// # Errors
    /// Where [`Generator::generate`] would fail, as far as this is known without making the
    /// terrain.
    fn estimate(&self, context: &Context) -> Result<Estimate>;
}

/// Changes a terrain once, by no natural process.
pub trait Edit<T: Terrain>: Params {
    /// Changes the terrain.
    ///
    /// # Errors
    /// If a parameter is wrong.
    fn edit(&self, terrain: &mut T, context: &Context) -> Result<()>;

    /// Size and memory after the edit, from those before it.
    fn estimate(&self, before: Estimate) -> Estimate {
        Estimate { bytes: before.nodes * (ELEVATIONS + self.bytes_a_node().unwrap_or(94)), ..before }
    }
}

/// Changes the representation.
pub trait Convert<S: Terrain, T: Terrain>: Params {
    /// Makes the target from the source.
    ///
    /// # Errors
    /// If a parameter is wrong.
    fn convert(&self, source: &S) -> Result<T>;

    /// Size and memory of the target, from those of the source.
    fn estimate(&self, source: Estimate) -> Estimate;
}

/// Measures a terrain.
pub trait Measure<T: Terrain>: Params {
    /// Result of the measure.
    type Out: Serialize;

    /// Where it is written, as JSON, below the output folder.
    fn path(&self) -> &str;

    /// Measures the terrain.
    ///
    /// # Errors
    /// If the terrain lacks data that the measure needs.
    fn measure(&self, landscape: &Landscape<'_, T>) -> Result<Self::Out>;
}

/// Writes files about a terrain.
pub trait Export<T: Terrain>: Params {
    /// Writes to `out`.
    ///
    /// # Errors
    /// If the terrain lacks data that the export needs, or the output refuses a file.
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()>;
}

/// Changes a terrain over time.
pub trait Process<T: Terrain>: Params {
    /// Fields that it changes or adds ("elevation" among them).
    const WRITES: &'static [&'static str];

    /// State that a checkpoint must hold besides the terrain; scratch is `#[serde(skip)]`.
    type State: Serialize + DeserializeOwned + Send + 'static;

    /// Begins: resolves parameters that vary in space. Called once, and not on resume.
    ///
    /// # Errors
    /// If the process cannot start on this terrain with these parameters.
    fn start(&self, terrain: &mut T, context: &Context) -> Result<Self::State>;

    /// The clock of a process that counts its own rounds, for recipes that give none.
    fn own_clock(&self) -> Option<OwnClock> {
        None
    }

    /// Whether nothing is left to do; a run ends when all its processes say so.
    fn is_at_rest(&self, _terrain: &T, _state: &Self::State) -> bool {
        false
    }

    /// Whether the end that its parameters ask for is not reached: told of a process that came to
    /// rest before it.
    fn is_short_of_its_end(&self, _terrain: &T, _state: &Self::State) -> bool {
        false
    }

    /// The longest step that may be taken, s; none if any.
    fn max_step(&self, _terrain: &T, _state: &Self::State) -> Option<f64> {
        None
    }

    /// Reads the terrain at the start of a step, before any process has changed it: the flow of a
    /// step runs over this surface.
    ///
    /// # Errors
    /// If a numerical method fails.
    fn begin(&self, _terrain: &T, _state: &mut Self::State, _at: &Step) -> Result<()> {
        Ok(())
    }

    /// Adapts the state in mid-run to a terrain that was changed from outside, or to other
    /// parameters: ground, status and sea may all differ. By default the process begins anew. It
    /// must not add again the material that it adds at the start of a run ([`Context::step`] is 0
    /// only there).
    ///
    /// # Errors
    /// Where [`Process::start`] fails.
    fn reconcile(&self, terrain: &mut T, state: &mut Self::State, context: &Context) -> Result<()> {
        *state = self.start(terrain, context)?;
        Ok(())
    }

    /// Advances by `at.dt`.
    ///
    /// # Errors
    /// If a numerical method fails.
    fn step(&self, terrain: &mut T, state: &mut Self::State, at: &Step) -> Result<Change>;

    /// What a user should know of the ground after the last step and [`Process::finish`].
    fn note(&self, _terrain: &T, _state: &Self::State) -> Option<String> {
        None
    }

    /// Adds derived fields after the last step.
    ///
    /// # Errors
    /// If a numerical method fails.
    fn finish(&self, _terrain: &mut T, _state: &mut Self::State, _environment: &Environment) -> Result<()> {
        Ok(())
    }
}

/// The clock of a process that counts its own rounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnClock {
    /// Length of a round, s; a year where the process has no time of its own.
    pub dt: f64,
    /// Greatest number of rounds.
    pub rounds: u64,
    /// Whether `dt` is a length in time.
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
    /// Sea level, rain, winds and materials, for a process that has no values of its own.
    pub environment: Arc<Environment>,
    /// To be polled by steps that take more than about a second.
    pub cancel: CancelToken,
}

/// Volumes that one step moved, in m³ of solid.
///
/// Two sums must close: Δvolume = supplied + deposited − eroded, and eroded = deposited +
/// exported + Δcarried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, serde::Deserialize)]
pub struct Change {
    /// Brought in from outside, m³: uplift, growth.
    pub supplied: f64,
    /// Removed from the ground, m³.
    pub eroded: f64,
    /// Deposited on the ground, m³.
    pub deposited: f64,
    /// Left the domain, m³.
    pub exported: f64,
    /// In transport, m³: at the end of the step less at its start.
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

    /// Whether a stop was asked for.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
