//! The history of a landscape.

use serde::{Deserialize, Serialize};

use super::{Environment, Outcome};

/// One stage that acted on the landscape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Name of the stage in the recipe.
    pub stage: String,
    /// Its parameters as they were used, in customary units, as JSON.
    pub parameters: String,
    /// Papers behind it: authors, title, DOI.
    pub sources: Vec<[String; 3]>,
    /// How the run went, for processes.
    pub outcome: Option<Outcome>,
}

/// A terrain with its environment and its history, as measures and exports see it.
#[derive(Debug)]
#[non_exhaustive]
pub struct Landscape<'a, T> {
    /// The terrain.
    pub terrain: &'a T,
    /// Sea level, rain, winds and materials.
    pub environment: &'a Environment,
    /// Stages so far, oldest first.
    pub history: &'a [Event],
    /// Seed of the recipe.
    pub seed: u64,
    /// Title, for pictures and reports.
    pub title: &'a str,
}

impl<'a, T> Landscape<'a, T> {
    /// A terrain by itself: no history, the default environment of recipes.
    pub fn plain(terrain: &'a T) -> Self {
        let environment = super::Context::default().environment;
        Self { terrain, environment, history: &[], seed: 0, title: "" }
    }

    /// The same surroundings with another terrain.
    pub fn with<'b, U>(&'b self, terrain: &'b U) -> Landscape<'b, U> {
        let Self { environment, history, seed, title, .. } = *self;
        Landscape { terrain, environment, history, seed, title }
    }
}
