//! Words of the automaton's formulas, and which names states may have.

use landform_core::field::names;
use landform_core::verb::{CellFunction, Words};
use landform_core::{Error, Result};

use super::params::Automaton;

/// The ground's state.
pub(super) const HEIGHT: &str = "height";
/// Place of `height` among the states.
pub(super) const GROUND: usize = 0;

/// Variables that are no states, after them in this order.
pub(super) const OTHERS: [&str; 4] = ["z", "step", "cell_size", "inside"];

/// What functions tell, in the order of [`FUNCTIONS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Told {
    Sum,
    Mean,
    Min,
    Max,
    Count,
    AtLowest,
    At,
    Drop,
    Slope,
    Random,
}

impl Told {
    pub(super) const ALL: [Self; 10] = [
        Self::Sum,
        Self::Mean,
        Self::Min,
        Self::Max,
        Self::Count,
        Self::AtLowest,
        Self::At,
        Self::Drop,
        Self::Slope,
        Self::Random,
    ];
}

/// Functions of formulas; surfaces come last and may be left out.
pub(super) const FUNCTIONS: [CellFunction; 10] = [
    CellFunction { name: "sum_around", expressions: [1, 1], numbers: 0 },
    CellFunction { name: "mean_around", expressions: [1, 1], numbers: 0 },
    CellFunction { name: "min_around", expressions: [1, 1], numbers: 0 },
    CellFunction { name: "max_around", expressions: [1, 1], numbers: 0 },
    CellFunction { name: "count_around", expressions: [1, 1], numbers: 0 },
    CellFunction { name: "at_lowest", expressions: [1, 2], numbers: 0 },
    CellFunction { name: "at", expressions: [1, 1], numbers: 2 },
    CellFunction { name: "drop", expressions: [0, 1], numbers: 0 },
    CellFunction { name: "slope", expressions: [0, 1], numbers: 0 },
    CellFunction { name: "random", expressions: [0, 0], numbers: 0 },
];

/// Words that formulas of all stages have.
const TAKEN: [&str; 7] = ["x", "y", "u", "v", "r", "pi", "e"];

/// Names of the variables: `height`, the other states, what else there is.
pub(super) fn variables(automaton: &Automaton) -> Vec<String> {
    let ground = std::iter::once(HEIGHT.to_string());
    ground.chain(automaton.states.keys().cloned()).chain(OTHERS.map(String::from)).collect()
}

/// Words of formulas, with the variables of [`variables`].
pub(super) fn words<'a>(automaton: &'a Automaton, variables: &'a [String]) -> Words<'a> {
    Words { variables, constants: &automaton.constants, functions: &FUNCTIONS }
}

/// Refuses names that would be something else, and constants that are no numbers.
///
/// # Errors
/// [`Error::Parameter`] with the first name.
pub(super) fn check_names(automaton: &Automaton) -> Result<()> {
    let states = automaton.states.keys().map(|name| ("states", name));
    let constants = automaton.constants.keys().map(|name| ("constants", name));
    for (key, name) in states.chain(constants) {
        let refuse = |expected: &str| Err(Error::parameter(&format!("{key}.{name}"), format!("\"{name}\""), expected));
        let first = name.chars().next().unwrap_or('0');
        if !(first.is_ascii_lowercase()
            && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'))
        {
            return refuse("a name of small letters, digits and _, with a letter first");
        }
        if name == HEIGHT || name == names::ELEVATION.name {
            return refuse("a name of its own; the ground is the state `height` and is always there");
        }
        if TAKEN.contains(&name.as_str()) || OTHERS.contains(&name.as_str()) {
            return refuse("a name of its own; formulas have that word already");
        }
        if name.ends_with(names::DEPTH_SUFFIX) || name == names::SURFACE_MATERIAL.name {
            return refuse("a name of its own; layers of the ground have such names");
        }
    }
    if let Some(name) = automaton.constants.keys().find(|name| automaton.states.contains_key(*name)) {
        return Err(Error::parameter(&format!("constants.{name}"), format!("\"{name}\""), "a name that no state has"));
    }
    match automaton.constants.iter().find(|(_, value)| !value.is_finite()) {
        Some((name, value)) => Err(Error::parameter(&format!("constants.{name}"), value, "a finite number")),
        None => Ok(()),
    }
}
