//! Rules, read once.

use landform_core::error::nearest;
use landform_core::verb::{CellFormula, Words};
use landform_core::{Error, Result};

use super::params::{Automaton, Rule, Until};
use super::value::Value;
use super::words::{GROUND, HEIGHT, OTHERS, check_names, variables, words};

/// Most cells that a move or `at` goes in one direction.
pub(super) const FARTHEST: i64 = 10_000;

/// An automaton whose formulas have been read.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// Names of the states, `height` first.
    pub(super) states: Vec<String>,
    /// What each state but `height` is at the start, with its place, in an order in which each uses
    /// only what comes before it.
    pub(super) starts: Vec<(usize, Start)>,
    /// Effects in sequence.
    pub(super) effects: Vec<PlannedEffect>,
}

/// What a state is at the start.
#[derive(Clone, Debug)]
pub(super) enum Start {
    Formula(CellFormula),
    Field(String),
}

/// An effect whose rules have been read.
#[derive(Clone, Debug)]
pub(super) struct PlannedEffect {
    pub(super) is_until_still: bool,
    pub(super) together: bool,
    pub(super) rules: Vec<PlannedRule>,
}

/// A rule that has been read.
#[derive(Clone, Debug)]
pub(super) struct PlannedRule {
    /// Place of the state that it changes.
    pub(super) state: usize,
    /// The new value, or the amount that moves.
    pub(super) formula: CellFormula,
    /// Where the amount goes; none for `set`.
    pub(super) way: Option<Way>,
    /// Surface on which lower cells are looked for; the ground, if none.
    pub(super) over: Option<CellFormula>,
}

/// Where an amount goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// To the neighbour of least height, if that is lower.
    Lowest,
    /// Down the steepest slope.
    Steepest,
    /// To all lower neighbours, by slope.
    Lower,
    /// Cells to the east and to the north.
    Offset([i64; 2]),
}

/// Words of [`Way`].
const WAYS: [(&str, Way); 3] = [("lowest", Way::Lowest), ("steepest", Way::Steepest), ("lower", Way::Lower)];

impl Plan {
    /// Reads all formulas.
    ///
    /// # Errors
    /// [`Error::Parameter`] for the first rule or state that is wrong, with its place.
    pub(super) fn new(automaton: &Automaton) -> Result<Self> {
        check_names(automaton)?;
        let names = variables(automaton);
        let states = names[..names.len() - OTHERS.len()].to_vec();
        let reader = Reader { states: &states, words: words(automaton, &names) };
        let starts = reader.starts(automaton)?;
        if automaton.effects.is_empty() {
            return Err(Error::parameter("effects", "empty", "at least one effect"));
        }
        let mut effects = Vec::new();
        for (k, effect) in automaton.effects.iter().enumerate() {
            let place = format!("effects[{k}]");
            if effect.rules.is_empty() {
                return Err(Error::parameter(&format!("{place}.rules"), "empty", "at least one rule"));
            }
            let rules = effect.rules.iter().enumerate();
            let rules = rules.map(|(j, rule)| reader.rule(rule, &format!("{place}.rules[{j}]")));
            effects.push(PlannedEffect {
                is_until_still: effect.until == Until::Still,
                together: effect.together,
                rules: rules.collect::<Result<_>>()?,
            });
        }
        let plan = Self { states, starts, effects };
        match (1..plan.states.len()).find(|&k| !plan.is_used(k)) {
            Some(k) => {
                let name = &plan.states[k];
                Err(Error::parameter(&format!("states.{name}"), format!("`{name}`"), "a state that a rule uses"))
            }
            None => Ok(plan),
        }
    }

    /// Steps of all effects, run once.
    pub(super) fn steps(automaton: &Automaton) -> u64 {
        automaton.effects.iter().fold(0, |all, effect| all.saturating_add(effect.steps))
    }

    fn is_used(&self, state: usize) -> bool {
        let by_start = self.starts.iter().any(|(_, s)| matches!(s, Start::Formula(f) if f.uses(state)));
        by_start
            || self.effects.iter().flat_map(|e| &e.rules).any(|rule| {
                rule.state == state
                    || rule.formula.uses(state)
                    || rule.over.as_ref().is_some_and(|over| over.uses(state))
            })
    }
}

struct Reader<'a> {
    states: &'a [String],
    words: Words<'a>,
}

impl Reader<'_> {
    fn formula(&self, place: &str, value: &Value) -> Result<CellFormula> {
        let text = match value {
            Value::Number(number) if number.is_finite() => format!("{number:?}"),
            Value::Text(text) => text.clone(),
            other => return Err(Error::parameter(place, other.text(), "a finite number or a formula")),
        };
        let refused = |expected: String| Error::parameter(place, value.text(), &expected);
        let formula = CellFormula::parse(&text, self.words).map_err(|error| match error {
            Error::Formula { at, why, .. } => refused(format!("a formula: character {at}: {why}")),
            other => other,
        })?;
        match formula.constant() {
            Some(number) if !number.is_finite() => Err(refused("a formula whose value is finite".into())),
            _ => Ok(formula),
        }
    }

    /// Values at the start, each after those that it uses.
    fn starts(&self, automaton: &Automaton) -> Result<Vec<(usize, Start)>> {
        let mut left = Vec::new();
        for (k, (name, value)) in automaton.states.iter().enumerate() {
            let start = match value {
                Value::Field(field) => Start::Field(field.clone()),
                value => Start::Formula(self.formula(&format!("states.{name}"), value)?),
            };
            left.push((k + 1, start));
        }
        let mut ordered: Vec<(usize, Start)> = Vec::new();
        while !left.is_empty() {
            let waits = |start: &Start| match start {
                Start::Formula(f) => left.iter().any(|(other, _)| f.uses(*other)),
                Start::Field(_) => false,
            };
            let Some(ready) = left.iter().position(|(_, start)| !waits(start)) else {
                let circle: Vec<&str> = left.iter().map(|(k, _)| self.states[*k].as_str()).collect();
                let (name, value) = (circle[0], &automaton.states[circle[0]]);
                let expected =
                    format!("a value that does not follow from itself: {} wait for each other", circle.join(", "));
                return Err(Error::parameter(&format!("states.{name}"), value.text(), &expected));
            };
            ordered.push(left.remove(ready));
        }
        Ok(ordered)
    }

    /// The place of a state.
    fn state(&self, place: &str, name: &str) -> Result<usize> {
        self.states.iter().position(|s| s == name).ok_or_else(|| {
            let near = nearest(name, self.states.iter().map(String::as_str));
            let near = near.map(|n| format!(" (did you mean `{n}`?)")).unwrap_or_default();
            let expected = format!("one of the states {}{near}", self.states.join(", "));
            Error::parameter(place, format!("\"{name}\""), &expected)
        })
    }

    fn rule(&self, rule: &Rule, place: &str) -> Result<PlannedRule> {
        let key = |key: &str| format!("{place}.{key}");
        let missing = |name: &str| Error::parameter(&key(name), "not given", "a value");
        let to = rule.to.as_ref().ok_or_else(|| missing("to"))?;
        match (&rule.set, &rule.moved) {
            (Some(set), None) => {
                for (name, given) in [("amount", &rule.amount), ("over", &rule.over)] {
                    if let Some(value) = given {
                        return Err(Error::parameter(&key(name), value.text(), "none: it goes with `move`"));
                    }
                }
                let state = self.state(&key("set"), set)?;
                Ok(PlannedRule { state, formula: self.formula(&key("to"), to)?, way: None, over: None })
            }
            (None, Some(moved)) => {
                let state = self.state(&key("move"), moved)?;
                let amount = rule.amount.as_ref().ok_or_else(|| missing("amount"))?;
                let over = rule.over.as_ref().map(|over| self.formula(&key("over"), over)).transpose()?;
                let way = way(&key("to"), to)?;
                if let (Way::Offset(_), Some(value)) = (way, &rule.over) {
                    return Err(Error::parameter(&key("over"), value.text(), "none: `to` says which cell it is"));
                }
                Ok(PlannedRule { state, formula: self.formula(&key("amount"), amount)?, way: Some(way), over })
            }
            (set, _) => {
                let value = if set.is_some() { "with both `set` and `move`" } else { "without `set` or `move`" };
                Err(Error::parameter(place, value, &format!("one of them, such as set = \"{HEIGHT}\"")))
            }
        }
    }
}

fn way(place: &str, to: &Value) -> Result<Way> {
    let near = match to {
        Value::Text(word) => match WAYS.iter().find(|w| w.0 == word) {
            Some((_, way)) => return Ok(*way),
            None => nearest(word, WAYS.iter().map(|w| w.0)),
        },
        Value::Offset(cells) if cells.iter().all(|c| (-FARTHEST..=FARTHEST).contains(c)) && *cells != [0, 0] => {
            return Ok(Way::Offset(*cells));
        }
        _ => None,
    };
    let near = near.map(|n| format!(" (did you mean \"{n}\"?)")).unwrap_or_default();
    let expected =
        format!("\"lowest\", \"steepest\", \"lower\", or cells to the east and to the north, such as [1, 0]{near}");
    Err(Error::parameter(place, to.text(), &expected))
}

impl PlannedRule {
    /// Whether it changes the ground.
    pub(super) fn is_of_ground(&self) -> bool {
        self.state == GROUND
    }
}
