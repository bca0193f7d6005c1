//! Results of a sweep as a table.

use std::fmt::Write;

use landform_core::stage::Verb;
use landform_core::units::YEAR;
use landform_core::verb::{MemoryOutput, Stopped};
use serde_json::Value as Json;

use super::{Recipe, Row, Sweep};

impl Sweep {
    /// The rows as CSV.
    pub fn table(&self, rows: &[Row]) -> String {
        table(self.over.iter().map(|over| over.key.as_str()), rows)
    }
}

/// Column of how a run stopped, a word.
const STOPPED: &str = "stopped";
/// Columns that every table has after the keys.
const NAMES: [&str; 12] = [
    "min_m",
    "mean_m",
    "max_m",
    "median_slope",
    "max_slope",
    "hypsometric_integral",
    "concavity",
    "lakes",
    "steps",
    "time_yr",
    STOPPED,
    "residual",
];

impl Row {
    /// Columns of the table that hold a number, and those numbers; none where there is none.
    pub(super) fn numbers(&self) -> Vec<(&str, Option<f64>)> {
        let (s, outcome) = (&self.summary, self.outcome.as_ref());
        let own = [
            Some(s.min),
            Some(s.mean),
            Some(s.max),
            Some(s.median_slope),
            Some(s.max_slope),
            Some(self.hypsometry.integral),
            Some(self.slope_area.concavity),
            Some(s.lakes as f64),
            outcome.map(|o| o.steps as f64),
            outcome.map(|o| o.time / YEAR),
            // A word, how it stopped.
            None,
            outcome.and_then(|o| o.residual),
        ];
        let own = NAMES.into_iter().zip(own).filter(|n| n.0 != STOPPED);
        let measured = self.measures.iter().map(|(name, v)| (name.as_str(), Some(*v)));
        own.chain(measured).map(|(name, v)| (name, v.filter(|v| v.is_finite()))).collect()
    }
}

/// Rows as CSV: seed, values of the keys, and numbers of the run's end.
pub(super) fn table<'a>(keys: impl Iterator<Item = &'a str>, rows: &[Row]) -> String {
    let quote = |text: &str| {
        if text.contains([',', '"', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.into() }
    };
    let keys: Vec<String> = keys.map(quote).collect();
    let mut table = ["seed".to_string()].into_iter().chain(keys).collect::<Vec<_>>().join(",");
    NAMES.iter().for_each(|name| table += &format!(",{name}"));
    let columns = columns(rows);
    columns.iter().for_each(|c| table += &format!(",{}", quote(c)));
    table.push('\n');
    for row in rows {
        let values: Vec<String> = row.values.iter().map(|v| quote(v)).collect();
        let head = [row.seed.to_string()].into_iter().chain(values).collect::<Vec<_>>().join(",");
        let s = &row.summary;
        let number = |v: f64| if v.is_finite() { format!("{v:.6}") } else { String::new() };
        // Text in memory cannot fail to be written.
        let _ = write!(
            table,
            "{head},{:.4},{:.4},{:.4},{:.6},{:.6},{},{},{}",
            s.min,
            s.mean,
            s.max,
            s.median_slope,
            s.max_slope,
            number(row.hypsometry.integral),
            number(row.slope_area.concavity),
            s.lakes
        );
        let _ = match &row.outcome {
            Some(o) => {
                let residual = o.residual.map_or(String::new(), |r| format!("{r:.3e}"));
                write!(table, ",{},{:.6e},{},{residual}", o.steps, o.time / YEAR, word(o.stopped))
            }
            None => write!(table, ",,,,"),
        };
        for column in &columns {
            let value = row.measures.iter().find(|m| m.0 == *column).map(|m| m.1).filter(|v| v.is_finite());
            table += &value.map_or(",".into(), |v| format!(",{v}"));
        }
        table.push('\n');
    }
    table
}

/// Names of the measured numbers of all rows, in the order in which they appear.
fn columns(rows: &[Row]) -> Vec<String> {
    let mut columns: Vec<String> = Vec::new();
    for (name, value) in rows.iter().flat_map(|row| &row.measures) {
        if value.is_finite() && !columns.contains(name) {
            columns.push(name.clone());
        }
    }
    columns
}

impl Recipe {
    /// The numbers of its measures: names such as "measure_coast.dimension.box", and values.
    pub(super) fn numbers(&self, told: &MemoryOutput) -> Vec<(String, f64)> {
        let mut numbers = Vec::new();
        let mut seen: Vec<&str> = Vec::new();
        for entry in self.entries.iter().filter(|e| e.work.verb() == Verb::Measure) {
            let name = entry.label.as_ref().unwrap_or(&entry.name);
            seen.push(name);
            // A second stage of a name has columns of its own.
            let count = seen.iter().filter(|s| *s == name).count();
            let name = &if count > 1 { format!("{name}#{count}") } else { name.clone() };
            for path in entry.work.outputs() {
                let json = told.0.get(&path).and_then(|bytes| serde_json::from_slice::<Json>(bytes).ok());
                if let Some(json) = json {
                    numbers_in(&json, name, &mut numbers);
                }
            }
        }
        numbers
    }
}

/// The numbers of a value, tables within it too, NaN for null; lists are no columns.
fn numbers_in(json: &Json, name: &str, numbers: &mut Vec<(String, f64)>) {
    match json {
        Json::Number(n) => numbers.extend(n.as_f64().map(|v| (name.to_string(), v))),
        Json::Null => numbers.push((name.into(), f64::NAN)),
        Json::Bool(b) => numbers.push((name.into(), f64::from(u8::from(*b)))),
        Json::Object(map) => map.iter().for_each(|(key, value)| numbers_in(value, &format!("{name}.{key}"), numbers)),
        _ => {}
    }
}

/// Why a run stopped, in a word.
fn word(stopped: Stopped) -> &'static str {
    match stopped {
        Stopped::EndTime => "end of time",
        Stopped::MaxSteps => "most steps",
        Stopped::Steady => "steady",
        Stopped::Cancelled => "interrupted",
        Stopped::ByObserver => "by observer",
        Stopped::AtRest => "at rest",
        Stopped::AtRestTooSoon => "at rest too soon",
    }
}
