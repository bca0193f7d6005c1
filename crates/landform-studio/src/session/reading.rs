//! A text as it is understood.

use landform::core::Error;
use landform::recipe::Recipe;

use super::mistake::{Mistake, mistakes};
use crate::root::Root;

/// What a text comes to.
#[derive(Debug, Default)]
pub(crate) struct Reading {
    /// The recipe, if nothing is wrong with it.
    pub(crate) recipe: Option<Recipe>,
    pub(crate) errors: Vec<Mistake>,
    /// By step that is on: nodes after it, and notes.
    pub(crate) planned: Vec<(u64, Vec<String>)>,
    /// Notes on the whole.
    pub(crate) notes: Vec<String>,
    /// Bytes at the peak of a build.
    pub(crate) bytes: u64,
}

impl Reading {
    /// Reads a text, plans it, and refuses what leads out of the root.
    pub(crate) fn of(text: &str, name: &str, folder: &std::path::Path, root: &Root) -> Self {
        let wrong = |error: &Error| Self { errors: mistakes(error, text), ..Self::default() };
        let recipe = match Recipe::parse(text, name, folder, &[]) {
            Ok(recipe) => recipe,
            Err(error) => return wrong(&error),
        };
        // Nothing is looked at outside, not even whether it is there.
        match root.check(&recipe).and_then(|()| recipe.plan(None, "")) {
            Ok(plan) => {
                let planned = plan.stages.into_iter().map(|stage| (stage.nodes, stage.notes)).collect();
                Self {
                    notes: recipe.notes.clone(),
                    recipe: Some(recipe),
                    errors: Vec::new(),
                    planned,
                    bytes: plan.bytes,
                }
            }
            Err(error) => wrong(&error),
        }
    }
}
