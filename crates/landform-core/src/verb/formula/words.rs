//! Words that a stage adds to those of formulas.

use std::collections::BTreeMap;

/// Words that a stage adds to those of formulas. They come before the others of the same name.
///
/// ```
/// use std::collections::BTreeMap;
/// use landform_core::verb::{CellFormula, Words};
///
/// let constants = BTreeMap::from([("rain".to_string(), 0.5)]);
/// let words = Words { variables: &["water".into()], constants: &constants, functions: &[] };
/// assert!(CellFormula::parse("water + rain", words).is_ok());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Words<'a> {
    /// Numbers that differ from cell to cell; known by their places in this list.
    pub variables: &'a [String],
    /// Numbers that have a name.
    pub constants: &'a BTreeMap<String, f64>,
    /// Functions; known by their places in this list.
    pub functions: &'a [CellFunction],
}

impl Words<'_> {
    /// Whether a name is that of a variable.
    pub(super) fn is_variable(&self, name: &str) -> bool {
        self.variables.iter().any(|v| v == name)
    }
}

/// A function of a stage's own. First come expressions, which it reads at other cells than its own
/// too; then numbers.
///
/// ```
/// use std::collections::BTreeMap;
/// use landform_core::verb::{CellFormula, CellFunction, Words};
///
/// let at = CellFunction { name: "at", expressions: [1, 1], numbers: 2 };
/// let words = Words { variables: &[], constants: &BTreeMap::new(), functions: &[at] };
/// assert!(CellFormula::parse("at(x + y, 1, 0)", words).is_ok());
/// assert!(CellFormula::parse("at(x + y)", words).is_err());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CellFunction {
    /// Name.
    pub name: &'static str,
    /// Fewest and most expressions, at most two; where numbers follow, as many as there are.
    pub expressions: [usize; 2],
    /// How many numbers follow.
    pub numbers: usize,
}

impl CellFunction {
    /// Fewest and most values in its brackets.
    pub(super) fn counts(self) -> [usize; 2] {
        self.expressions.map(|n| n + self.numbers)
    }
}
