//! Values of keys with which a number of a run's end comes to a target.

mod search;
mod span;

use std::collections::BTreeMap;

use landform_core::error::nearest;
use landform_core::verb::CancelToken;
use landform_core::{Error, Result};

pub use span::Span;

use super::runs::Runs;
use super::table::table;
use super::{Override, Recipe, Row};

/// What a column of the table is to come to.
///
/// ```
/// use landform::recipe::Aim;
///
/// assert_ne!(Aim::Target(0.5), Aim::Most);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim {
    /// This value, in the unit of the column.
    Target(f64),
    /// As little as possible.
    Least,
    /// As much as possible.
    Most,
}

/// A search for values of keys.
///
/// ```
/// use std::path::Path;
/// use landform::core::verb::CancelToken;
/// use landform::recipe::{Aim, Fit, Recipe, Span};
///
/// let text = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"400 m\", \"400 m\"] }";
/// let load = |set: &[_]| Recipe::parse(text, "plain", Path::new("."), set);
/// let over = vec![Span::parse("flat.elevation=0 m..100 m")?];
/// let fit = Fit { over, column: "mean_m".into(), aim: Aim::Target(37.5), runs: 20, seed: None };
/// let found = fit.run(load, None, &CancelToken::default(), |_, _, _| {})?;
/// assert_eq!(found.set.as_deref(), Some("--set \"flat.elevation=37.5 m\""));
/// # Ok::<(), landform::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Keys and their ranges, one to four.
    pub over: Vec<Span>,
    /// Column of the table, as [`Sweep::table`](super::Sweep::table) names it.
    pub column: String,
    /// What it is to come to.
    pub aim: Aim,
    /// Number of runs, at most.
    pub runs: usize,
    /// Seed of all runs; the recipe's own if there is none.
    pub seed: Option<u64>,
}

/// What a search found.
///
/// ```
/// use landform::recipe::Fitted;
///
/// // Before any run.
/// let found = Fitted::default();
/// assert!(found.rows.is_empty() && found.best.is_none() && !found.is_reached);
/// ```
#[derive(Debug, Default)]
pub struct Fitted {
    /// All runs, in the order in which they were made.
    pub rows: Vec<Row>,
    /// The runs as CSV, as [`Sweep::table`](super::Sweep::table) has them.
    pub table: String,
    /// The row that is nearest to the aim.
    pub best: Option<usize>,
    /// Number of the best row in the column, in the unit of the column.
    pub value: Option<f64>,
    /// Values of the best row as arguments of `landform run`.
    pub set: Option<String>,
    /// Whether a target was reached: to a thousandth of it, or if it is 0, of the greatest value
    /// that was met.
    pub is_reached: bool,
    /// What ended the search early, or that no run reached the target or had a number.
    pub failure: Option<Error>,
}

/// Greatest number of keys.
const MOST_KEYS: usize = 4;
/// Greatest number of runs.
const MOST_RUNS: usize = 10_000;
/// Part of a target within which it is reached.
const NEAR: f64 = 1e-3;

impl Fit {
    /// Searches with runs of a recipe, which `load` reads with given overrides, in so much memory
    /// (bytes). Nothing is exported. `done` gets each run's number, its row and the row's number in
    /// the column.
    ///
    /// ```
    /// use std::path::Path;
    /// use landform::core::verb::CancelToken;
    /// use landform::recipe::{Aim, Fit, Recipe, Span};
    ///
    /// let text = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"400 m\", \"400 m\"] }";
    /// let load = |set: &[_]| Recipe::parse(text, "plain", Path::new("."), set);
    /// let over = vec![Span::parse("flat.elevation=0 m..100 m")?];
    /// let fit = Fit { over, column: "mean".into(), aim: Aim::Most, runs: 9, seed: None };
    /// let unknown = fit.run(load, None, &CancelToken::default(), |_, _, _| {}).unwrap_err();
    /// assert_eq!(unknown.parameter_name(), Some("column"));
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Parameter`] for no keys or more than four, a key that is given twice, a target that
    /// is not finite, no runs, or a column that the table has not; [`Error::Recipe`] if a recipe
    /// cannot be read with the ends of the ranges. What a run fails with is kept in the result.
    pub fn run(
        &self,
        load: impl Fn(&[Override]) -> Result<Recipe> + Sync,
        memory: Option<u64>,
        cancel: &CancelToken,
        done: impl Fn(usize, &Row, Option<f64>) + Sync,
    ) -> Result<Fitted> {
        self.check()?;
        let own = load(&[])?;
        let seed = self.seed.unwrap_or(own.seed);
        let keys = self.over.iter().map(|span| span.key.clone()).collect();
        let runs = Runs::new(keys, &own, load, memory, cancel)?;
        let values = |part: &dyn Fn(usize) -> String| (0..self.over.len()).map(part).collect::<Vec<_>>();
        runs.recipe(seed, &values(&|k| self.over[k].text(self.over[k].low)))?;
        runs.recipe(seed, &values(&|k| self.over[k].text(self.over[k].high)))?;
        // A key that takes whole numbers refuses others.
        let whole = |k: usize| {
            let Span { low, .. } = self.over[k];
            let moved = values(&|j| self.over[j].text(self.over[j].low + if j == k { 0.5 } else { 0.0 }));
            low.fract() == 0.0 && self.over[k].may_be_whole() && runs.recipe(seed, &moved).is_err()
        };
        let whole: Vec<bool> = (0..self.over.len()).map(whole).collect();
        let (mut found, mut known, mut wrong) = (Fitted::default(), BTreeMap::new(), None);
        let mut probe = |at: &[f64]| {
            let values = values(&|k| self.over[k].at(at[k], whole[k]));
            if let Some(value) = known.get(&values) {
                return Some(*value);
            }
            if found.is_reached || found.rows.len() == self.runs {
                return None;
            }
            let number = found.rows.len();
            match runs.rows(&[(seed, values.clone())], |_, row| done(number, row, self.value(row))) {
                Ok((rows, failure)) => {
                    found.failure = failure;
                    found.rows.extend(rows);
                }
                Err(e) => found.failure = Some(e),
            }
            let row = found.rows.get(number)?;
            self.check_column(row).map_err(|e| wrong = Some(e)).ok()?;
            let value = self.value(row).unwrap_or(f64::NAN);
            known.insert(values, value);
            self.judge(&mut found);
            Some(value)
        };
        search::search(self.over.len(), self.aim, &mut probe);
        if let Some(wrong) = wrong {
            return Err(wrong);
        }
        found.table = table(self.over.iter().map(|span| span.key.as_str()), &found.rows);
        if let Some(best) = found.best.map(|k| &found.rows[k]) {
            let set = |(span, value): (&Span, &String)| format!("--set \"{}={value}\"", span.key);
            let keys = self.over.iter().zip(&best.values).map(set);
            // Another seed's runs are found again with it alone.
            found.set = Some(keys.chain(self.seed.map(|seed| format!("--seed {seed}"))).collect::<Vec<_>>().join(" "));
            found.value = self.value(best);
        }
        found.failure = found.failure.take().or_else(|| self.verdict(&found));
        Ok(found)
    }

    fn check(&self) -> Result<()> {
        if !(1..=MOST_KEYS).contains(&self.over.len()) {
            let given = format!("given for {} keys", self.over.len());
            return Err(Error::parameter("over", given, &format!("1 to {MOST_KEYS} keys")));
        }
        for (k, span) in self.over.iter().enumerate() {
            if self.over[..k].iter().any(|o| o.key == span.key) {
                return Err(Error::parameter("over", format!("`{}` twice", span.key), "each key once"));
            }
        }
        if !(1..=MOST_RUNS).contains(&self.runs) {
            return Err(Error::parameter("runs", self.runs, &format!("1 to {MOST_RUNS}")));
        }
        match self.aim {
            Aim::Target(target) if !target.is_finite() => Err(Error::parameter("target", target, "a finite number")),
            _ => Ok(()),
        }
    }

    /// The number of a row in the column.
    fn value(&self, row: &Row) -> Option<f64> {
        row.numbers().into_iter().find(|n| n.0 == self.column)?.1
    }

    fn check_column(&self, row: &Row) -> Result<()> {
        let numbers = row.numbers();
        // Of a table that is null its numbers are not known.
        let is_within = |table: &str| self.column.strip_prefix(table).is_some_and(|rest| rest.starts_with('.'));
        if numbers.iter().any(|n| n.0 == self.column || n.1.is_none() && is_within(n.0)) {
            return Ok(());
        }
        let names = || numbers.iter().map(|n| n.0);
        let expected = match nearest(&self.column, names()) {
            Some(near) => format!("a column of the table (`{near}`?)"),
            None => format!("one of {}", names().collect::<Vec<_>>().join(", ")),
        };
        Err(Error::parameter("column", format!("`{}`", self.column), &expected))
    }

    /// Finds the best row, and whether it reaches the target.
    fn judge(&self, found: &mut Fitted) {
        let values: Vec<f64> = found.rows.iter().map(|row| self.value(row).unwrap_or(f64::NAN)).collect();
        let misfit = |k: usize| self.aim.misfit(values[k]);
        let known = (0..values.len()).filter(|&k| values[k].is_finite());
        found.best = known.min_by(|&a, &b| misfit(a).total_cmp(&misfit(b)));
        if let (Aim::Target(target), Some(best)) = (self.aim, found.best) {
            let greatest = values.iter().filter(|v| v.is_finite()).fold(0.0, |m: f64, v| m.max(v.abs()));
            let scale = if target == 0.0 { greatest } else { target.abs() };
            found.is_reached = misfit(best) <= NEAR * scale;
        }
    }

    /// Says that no run met the aim, if so, and which value is nearest.
    fn verdict(&self, found: &Fitted) -> Option<Error> {
        let (column, count) = (&self.column, found.rows.len());
        let fail = |what: String, hint: &str| Some(Error::Recipe { at: None, what, hint: Some(hint.into()) });
        match (found.value, self.aim) {
            (None, _) => {
                let hint = "does the recipe come to what it measures? `landform vary` shows the table";
                fail(format!("column `{column}` has no number in {count} runs"), hint)
            }
            (Some(nearest), Aim::Target(target)) if !found.is_reached => {
                let what = format!("column `{column}` does not come to {target} in {count} runs; nearest is {nearest}");
                fail(what, "widen the ranges, or allow more --runs")
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests;
