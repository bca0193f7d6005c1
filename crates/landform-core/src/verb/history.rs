//! How a landscape came to be.

use serde::{Deserialize, Serialize};

use super::Outcome;

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

/// A terrain with the record of how it came to be.
#[derive(Debug)]
pub struct Landscape<'a, T> {
    /// The terrain.
    pub terrain: &'a T,
    /// Stages so far, oldest first.
    pub history: &'a [Event],
    /// Seed of the recipe.
    pub seed: u64,
    /// Title, for pictures and reports.
    pub title: &'a str,
}
