//! The stages of a recipe as programs show them, and a recipe cut short.

use landform_core::stage::Verb;
use landform_core::terrain::Kind;
use serde_json::Value as Json;

use super::Recipe;
use super::entry::{EVOLVE, Work};

/// A stage of a recipe, as it was read.
///
/// ```
/// use landform::recipe::Recipe;
///
/// let text = "[[stage]]\nuse = \"flat\"\nlabel = \"plain\"";
/// let listed = Recipe::parse(text, "x", "".as_ref(), &[])?.listed();
/// assert_eq!(listed[0].label.as_deref(), Some("plain"));
/// # Ok::<(), landform::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Listed {
    /// Name of the stage.
    pub name: String,
    /// Label, if it has one.
    pub label: Option<String>,
    /// What it does.
    pub verb: Verb,
    /// Line of the recipe, from 1.
    pub line: Option<usize>,
    /// Kind of the ground after it.
    pub kind: Option<Kind>,
    /// Its clock, if it has one, with defaults.
    pub clock: Option<Json>,
    /// Its processes, or itself alone.
    pub parts: Vec<Part>,
}

/// A stage of the table with its parameters.
///
/// ```
/// use landform::recipe::{Part, Recipe};
///
/// let listed = Recipe::parse("[[stage]]\nuse = \"flat\"", "x", "".as_ref(), &[])?.listed();
/// let Part { name, parameters } = &listed[0].parts[0];
/// assert!(*name == "flat" && parameters["grid"].is_object());
/// # Ok::<(), landform::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Part {
    /// Name.
    pub name: &'static str,
    /// All parameters in customary units, defaults included.
    pub parameters: Json,
}

impl Listed {
    /// Whether it holds processes of their own names.
    ///
    /// ```
    /// # use landform::recipe::Recipe;
    /// let listed = Recipe::parse("[[stage]]\nuse = \"flat\"", "x", "".as_ref(), &[])?.listed();
    /// assert!(!listed[0].is_evolve());
    /// # Ok::<(), landform::Error>(())
    /// ```
    pub fn is_evolve(&self) -> bool {
        self.name == EVOLVE
    }
}

impl Recipe {
    /// The stages in order.
    ///
    /// ```
    /// use landform::recipe::Recipe;
    ///
    /// let text = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"4 km\", \"4 km\"] }";
    /// let stages = Recipe::parse(text, "plain", "".as_ref(), &[])?.listed();
    /// assert_eq!((stages[0].name.as_str(), stages[0].line), ("flat", Some(1)));
    /// assert_eq!(stages[0].parts[0].parameters["elevation"], "0 m");
    /// # Ok::<(), landform::Error>(())
    /// ```
    pub fn listed(&self) -> Vec<Listed> {
        let part = |part: &landform_core::stage::ReadStage| Part {
            name: part.stage().name,
            parameters: part.parameters().clone(),
        };
        let listed = |entry: &super::entry::Entry| Listed {
            name: entry.name.clone(),
            label: entry.label.clone(),
            verb: entry.work.verb(),
            line: entry.lines.iter().find(|line| line.0.is_empty()).map(|line| line.1),
            kind: entry.kind,
            clock: match &entry.work {
                Work::Evolve(evolve) => serde_json::to_value(&evolve.clock).ok(),
                Work::Once(_) => None,
            },
            parts: entry.work.parts().iter().map(part).collect(),
        };
        self.entries.iter().map(listed).collect()
    }

    /// The recipe up to one of its stages (from 0) and no further.
    ///
    /// ```
    /// use landform::recipe::Recipe;
    ///
    /// let text = "[[stage]]\nuse = \"flat\"\n[[stage]]\nuse = \"add\"\nelevation = \"1 m\"";
    /// let recipe = Recipe::parse(text, "plain", "".as_ref(), &[])?;
    /// assert_eq!(recipe.up_to(0).listed().len(), 1);
    /// # Ok::<(), landform::Error>(())
    /// ```
    #[must_use]
    pub fn up_to(&self, stage: usize) -> Self {
        let mut cut = self.clone();
        cut.entries.truncate(stage.saturating_add(1));
        cut
    }
}
