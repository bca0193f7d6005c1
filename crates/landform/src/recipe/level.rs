//! The same recipe on coarser cells.

use std::fmt;
use std::str::FromStr;

use landform_core::stage::Refusal;
use landform_core::{Error, Result};

use super::clock::MOST_HALVINGS;
use super::entry::Work;
use super::{Recipe, Verb};

/// A share of a recipe's resolution: 1, 1/2, 1/4, ... 1/64.
///
/// ```
/// use landform::recipe::Level;
/// assert_eq!("1/4".parse::<Level>()?.factor(), 4);
/// assert!("1/3".parse::<Level>().is_err());
/// # Ok::<(), landform::core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Level {
    halvings: u32,
}

const LEVELS: &str = "one of 1, 1/2, 1/4, 1/8, 1/16, 1/32, 1/64";

impl Level {
    /// Factor by which cells are longer.
    pub fn factor(self) -> u32 {
        1 << self.halvings
    }
}

impl Level {
    /// The level whose cells are twice as long, this many times over.
    ///
    /// # Errors
    /// [`Error::Parameter`] beyond 1/64.
    pub(super) fn halved(halvings: usize) -> Result<Self> {
        let halvings = u32::try_from(halvings).ok().filter(|&halvings| halvings <= MOST_HALVINGS);
        halvings.map(|halvings| Self { halvings }).ok_or_else(|| Error::parameter("level", "beyond 1/64", LEVELS))
    }
}

impl FromStr for Level {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let levels = (0..=MOST_HALVINGS).map(|halvings| Self { halvings });
        let mut named = levels.filter(|level| level.to_string() == text.trim());
        named.next().ok_or_else(|| Error::parameter("level", text, LEVELS))
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.halvings == 0 { f.write_str("1") } else { write!(f, "1/{}", self.factor()) }
    }
}

impl Recipe {
    /// The same recipe on cells that are twice, four times, ... as long: a preview in a fraction of
    /// the time. Extents, rates and times do not change.
    ///
    /// # Errors
    /// [`Error::Stage`] if a stage cannot work with so few cells.
    ///
    /// ```
    /// use landform::recipe::Recipe;
    /// let text = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"4 km\", \"4 km\"], cell_size = \"10 m\" }";
    /// let recipe = Recipe::parse(text, "plain", "".as_ref(), &[])?;
    /// let coarse = recipe.at("1/4".parse()?)?;
    /// assert_eq!(coarse.plan(None, "")?.stages[0].nodes, 101 * 101);
    /// # Ok::<(), landform::core::Error>(())
    /// ```
    pub fn at(&self, level: Level) -> Result<Self> {
        let mut recipe = self.clone();
        if level == Level::default() {
            return Ok(recipe);
        }
        for (index, entry) in recipe.entries.iter_mut().enumerate() {
            let parts = match &mut entry.work {
                Work::Once(part) => std::slice::from_mut(part),
                Work::Evolve(evolve) => {
                    evolve.clock.coarsen(level.halvings as usize);
                    evolve.parts.as_mut_slice()
                }
            };
            for part in parts {
                let stage = part.stage();
                *part = part
                    .coarser(level.factor())
                    .map_err(|refusal| self.entries[index].failed(index, as_error(refusal)))?;
                if stage.verb == Verb::Process && part.own_clock().is_some() {
                    let what = format!(
                        "`{}` counts rounds of cells: what it leaves at level {level} cannot be compared with the whole",
                        stage.name
                    );
                    recipe.notes.push(what);
                }
            }
        }
        Ok(recipe)
    }
}

fn as_error(refusal: Refusal) -> Error {
    match refusal {
        Refusal::Value(error) => error,
        Refusal::Shape(error) => Error::format("parameters", error),
    }
}
