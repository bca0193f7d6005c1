//! The level of the sea that a recipe's steps are about.

use landform::core::units::Length;
use landform::recipe::Recipe;
use serde_json::Value as Json;

/// The level that its last process with a sea says, m: its `sea_level`, or 0 m where water leaves
/// by the sea.
pub(crate) fn level_of(recipe: &Recipe) -> Option<f64> {
    let listed = recipe.listed();
    let parts = listed.iter().flat_map(|stage| &stage.parts).rev();
    parts.map(|part| &part.parameters).find_map(|parameters| match &parameters["sea_level"] {
        Json::String(text) => Length::parse(text).ok().map(Length::si),
        _ => (parameters["outlets"] == "sea").then_some(0.0),
    })
}
