//! Parameters of an automaton.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::value::Value;

/// Which cells around a cell are its neighbours.
///
/// ```
/// use landform_process::automaton::{Automaton, Neighbourhood};
///
/// assert_eq!(Automaton::default().neighbourhood, Neighbourhood::Eight);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Neighbourhood {
    /// Those along rows and columns; with a radius all that are as many steps away.
    Four,
    /// The diagonal ones too; with a radius the square of them.
    #[default]
    Eight,
}

/// When an effect ends.
///
/// ```
/// use landform_process::automaton::{Effect, Until};
///
/// assert_eq!(Effect::default().until, Until::Steps);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Until {
    /// After its steps.
    #[default]
    Steps,
    /// After a step that has changed nothing; after its steps at the latest.
    Still,
}

/// Rules that belong together, and how often they are applied.
///
/// ```
/// use landform_process::automaton::{Effect, Rule};
///
/// let rules = vec![Rule { set: Some("height".into()), ..Rule::default() }];
/// assert_eq!(Effect { rules, ..Effect::default() }.steps, 100);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Effect {
    /// Number of steps; the greatest, where the effect ends by itself.
    #[schemars(extend("x-min" = 1, "x-max" = 10_000_000))]
    pub steps: u64,
    /// Whether the effect ends after a step that has changed nothing.
    pub until: Until,
    /// Whether all rules read the states as they were at the start of the step; otherwise each
    /// reads what the one before has left.
    pub together: bool,
    /// Rules, applied one after the other in each step.
    pub rules: Vec<Rule>,
}

impl Default for Effect {
    fn default() -> Self {
        Self { steps: 100, until: Until::Steps, together: false, rules: Vec::new() }
    }
}

/// A rule: `set` a state `to` a formula, or `move` an `amount` of it `to` other cells.
///
/// ```
/// use landform_process::automaton::{Rule, Value};
///
/// let to = Some(Value::Text("0.5*water".into()));
/// let rule = Rule { set: Some("water".into()), to, ..Rule::default() };
/// assert!(rule.moved.is_none());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Rule {
    /// State that is set, at all cells at once.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub set: Option<String>,
    /// State of which an amount moves; none of it is lost but over open sides.
    #[serde(rename = "move", skip_serializing_if = "Option::is_none")]
    pub moved: Option<String>,
    /// Amount that leaves the cell, in the unit of the state.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub amount: Option<Value>,
    /// The new value; for `move` one of "lowest", "steepest", "lower", or cells to the east and to
    /// the north.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to: Option<Value>,
    /// Surface on which `move` looks for what is lower; the ground, if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub over: Option<Value>,
}

/// A cellular automaton written in a recipe: states of cells, and effects whose rules are formulas,
/// run in sequence. `height` is the ground (m); other states become fields of their names. A rule
/// `{ set = "state", to = "formula" }` is applied to all cells at once; `{ move = "state", amount =
/// "formula", to = "lowest" }` carries an amount to the lowest neighbour, "steepest" down the
/// steepest slope, "lower" to all lower ones by slope, [1, 0] a cell to the east. Besides the words
/// of every formula there are the states, `step` (from 0 in each effect), `cell_size` (m), `inside`
/// (0 where the ground is held), `random()` (0 to 1), and of neighbours `sum_around(…)`,
/// `mean_around(…)`, `min_around(…)`, `max_around(…)`, `count_around(…)` of those for which
/// something holds, `at_lowest(…)`, `at(…, east, north)`, `drop()` and `slope()` to lower ones.
/// Runs without a clock; a round is a step of an effect.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Automaton {
    /// States of a cell besides `height`, each with its value at the start: a number, a formula
    /// (which may use other states), or { field = "…" }.
    pub states: BTreeMap<String, Value>,
    /// Numbers with names, for formulas.
    pub constants: BTreeMap<String, f64>,
    /// Which cells are neighbours.
    pub neighbourhood: Neighbourhood,
    /// How many cells away the farthest neighbours are.
    #[schemars(extend("x-min" = 1, "x-max" = 16))]
    pub radius: u32,
    /// Effects, run one after the other.
    pub effects: Vec<Effect>,
    /// How often the sequence of effects is run.
    #[schemars(extend("x-min" = 1, "x-max" = 1_000_000))]
    pub iterations: u64,
}

impl Default for Automaton {
    /// A tenth of the drop moves to the lowest neighbour.
    fn default() -> Self {
        let text = |text: &str| Some(Value::Text(text.into()));
        let rule =
            Rule { moved: Some("height".into()), amount: text("0.1*drop()"), to: text("lowest"), ..Rule::default() };
        Self {
            states: BTreeMap::new(),
            constants: BTreeMap::new(),
            neighbourhood: Neighbourhood::default(),
            radius: 1,
            effects: vec![Effect { rules: vec![rule], ..Effect::default() }],
            iterations: 1,
        }
    }
}
