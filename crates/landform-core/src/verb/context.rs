//! The context of a stage.

use std::sync::{Arc, LazyLock};

use super::varying::Lookup;
use super::{Environment, Maps, NoMaps, Window};
use crate::Result;
use crate::grid::Grid;
use crate::random::Seed;
use crate::terrain::AnyTerrain;

/// The context of a stage: its seed, maps by path, the environment.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// Seed of the stage.
    pub seed: Seed,
    /// Where maps are read from.
    pub maps: &'a dyn Maps,
    /// Sea level, rain, winds and materials, for a stage that has no values of its own.
    pub environment: &'a Environment,
    /// Other terrains that the recipe gives to the stage, by their labels.
    pub with: &'a [(String, Arc<AnyTerrain>)],
    /// The part of the ground that is wanted, where not all of it is.
    pub window: Option<Window>,
    /// Time of the run at which a process begins, s.
    pub time: f64,
    /// Steps of the run before a process begins; 0 at the start of a run.
    pub step: u64,
}

impl Default for Context<'static> {
    /// Seed 0, no maps, the default environment of recipes, the start of a run.
    fn default() -> Self {
        static PLAIN: LazyLock<Environment> = LazyLock::new(Environment::default);
        Self { seed: Seed::default(), maps: &NoMaps, environment: &PLAIN, with: &[], window: None, time: 0.0, step: 0 }
    }
}

impl Context<'_> {
    /// The part of a generator's grid that is wanted, with the surrounding ground that later stages
    /// need; all of it without a window.
    ///
    /// # Errors
    /// Where [`Window::with_margin`] fails.
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
