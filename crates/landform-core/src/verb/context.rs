//! What a stage may ask of the world.

use std::sync::{Arc, LazyLock};

use super::varying::Lookup;
use super::{Environment, Maps, NoMaps, Window};
use crate::Result;
use crate::grid::Grid;
use crate::random::Seed;
use crate::terrain::AnyTerrain;

/// What a stage may ask of the world: its seed, and maps by path.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// Seed of the stage.
    pub seed: Seed,
    /// Where maps are read from.
    pub maps: &'a dyn Maps,
    /// Sea level, rain, winds and materials, where a stage says nothing itself.
    pub environment: &'a Environment,
    /// Other terrains that the stage was given, by their labels.
    pub with: &'a [(String, Arc<AnyTerrain>)],
    /// The part of the ground that is wanted, where not all of it is.
    pub window: Option<Window>,
    /// Time of the run at which a process begins, s.
    pub time: f64,
    /// Steps of the run before a process begins; 0 at the start of a run.
    pub step: u64,
}

impl Default for Context<'static> {
    /// Seed 0, no maps, the environment that recipes have if they say nothing, the start of a run.
    fn default() -> Self {
        static PLAIN: LazyLock<Environment> = LazyLock::new(Environment::default);
        Self { seed: Seed::default(), maps: &NoMaps, environment: &PLAIN, with: &[], window: None, time: 0.0, step: 0 }
    }
}

impl Context<'_> {
    /// The part of a generator's grid that is wanted, with what later stages look at; all of it, where no window is.
    ///
    /// # Errors
    /// As [`Window::with_margin`].
    pub fn wanted(&self, grid: Grid) -> Result<Grid> {
        self.window.map_or(Ok(grid.clone()), |window| window.with_margin(&grid))
    }
}

impl Lookup for Context<'_> {
    fn seed(&self) -> Seed {
        self.seed
    }

    fn maps(&self) -> &dyn Maps {
        self.maps
    }

    fn time(&self) -> f64 {
        self.time
    }
}
