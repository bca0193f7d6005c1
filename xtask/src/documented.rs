//! What the documentation of public items lacks: examples, and units of real numbers. The counts
//! only fall. Prose wider than [`COLUMNS`] is refused.
//!
//! Lines are read, not parsed: an item is a line that begins with `pub`, outside of tests, and its
//! documentation the comment above it. What stands in a private module counts too. A real number is
//! a field or a function of `f64`; its unit is a word of [`UNITS`], or one that says that it is a
//! pure number.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::layers::sources;

const KEPT: &str = "xtask/documented.json";
const CRATES: [&str; 4] = ["landform-core", "landform-process", "landform-io", "landform"];
const ITEMS: [&str; 6] = ["pub fn ", "pub struct ", "pub enum ", "pub trait ", "pub const ", "pub type "];
/// Columns of a line of documentation, at most.
const COLUMNS: usize = 100;
/// Units, and words of pure numbers.
const UNITS: &str = "m m² m³ km mm cm rad radians deg degrees ° s yr years m/s m²/s m³/s m/yr mm/yr m²/yr 1/m 1/s 1/yr 1/K kg kg/m³ \
                     Pa N W K Celsius °C % – SI metres seconds pixels cells nodes steps byte bytes units voxels samples fraction part \
                     share ratio factor number numbers count weight weights exponent coefficient slope tangent cosine sine \
                     probability between quantile power skew run dimension hurst relative residual imbalance skewness correlation R² dimensionless";

/// How many items lack something.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Lacks {
    examples: usize,
    units: usize,
}

pub(crate) fn run(accept: bool) -> bool {
    let found: BTreeMap<&str, Lacks> = CRATES.iter().map(|name| (*name, of_crate(name))).collect();
    let text = format!("{}\n", serde_json::to_string_pretty(&found).unwrap_or_default());
    if accept {
        return fs::write(KEPT, text).inspect_err(|e| println!("documented: {KEPT}: {e}")).is_ok();
    }
    let kept: BTreeMap<String, Lacks> =
        fs::read_to_string(KEPT).ok().and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
    let mut is_fine = no_wide_prose();
    for (name, now) in &found {
        let before = kept.get(*name).copied().unwrap_or_default();
        for (what, now, before) in [("an example", now.examples, before.examples), ("a unit", now.units, before.units)]
        {
            println!("documented: {name}: {now} public items without {what}, {before} kept");
            if now > before {
                println!("documented: give one to what is new, or take others' `pub` away");
                is_fine = false;
            }
        }
    }
    is_fine
}

/// Whether no line of documentation is too wide; says which are. Examples are as wide as code.
fn no_wide_prose() -> bool {
    let all: Vec<_> = ["crates", "xtask"].iter().flat_map(|folder| sources(Path::new(folder))).collect();
    let mut is_fine = true;
    for path in all {
        let (text, mut is_code) = (fs::read_to_string(&path).unwrap_or_default(), false);
        for (k, line) in text.lines().enumerate() {
            let doc = line.trim_start();
            if !doc.starts_with("///") && !doc.starts_with("//!") {
                is_code = false;
                continue;
            }
            is_code ^= doc.contains("```");
            if !is_code && line.chars().count() > COLUMNS && !doc.contains('|') {
                println!("documented: {}:{}: wider than {COLUMNS} columns", path.display(), k + 1);
                is_fine = false;
            }
        }
    }
    is_fine
}

fn of_crate(name: &str) -> Lacks {
    let mut all = Lacks::default();
    for path in sources(&Path::new("crates").join(name).join("src")) {
        if !path.ends_with("tests.rs") {
            let of = lacks(&fs::read_to_string(path).unwrap_or_default());
            all.examples += of.examples;
            all.units += of.units;
        }
    }
    all
}

fn lacks(text: &str) -> Lacks {
    let (mut lacks, mut doc) = (Lacks::default(), String::new());
    let mut lines = text.lines().take_while(|line| !line.starts_with("#[cfg(test)]")).map(str::trim);
    while let Some(line) = lines.next() {
        if line.starts_with("///") {
            doc.push_str(line);
            doc.push('\n');
            continue;
        }
        if line.starts_with("#[") {
            continue;
        }
        let mut whole = line.to_string();
        if line.starts_with("pub fn ") {
            while !whole.contains('{') && !whole.ends_with(';') {
                let Some(more) = lines.next() else { break };
                whole.push_str(more);
            }
        }
        lacks.examples += usize::from(ITEMS.iter().any(|item| line.starts_with(item)) && !doc.contains("```"));
        lacks.units += usize::from(is_real(&whole) && !has_unit(&doc));
        doc.clear();
    }
    lacks
}

/// Whether an item is a field or a function of real numbers.
fn is_real(item: &str) -> bool {
    let is_field = item.starts_with("pub ") && item.ends_with(',') && item.contains(": ");
    (is_field || item.starts_with("pub fn ")) && item.contains("f64")
}

fn has_unit(doc: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || "/²³°%–^".contains(c);
    let same = |word: &str, unit: &str| word == unit || unit.len() > 3 && word.eq_ignore_ascii_case(unit);
    doc.split(|c| !is_part(c)).any(|word| UNITS.split_whitespace().any(|unit| same(word, unit)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_without_an_example_or_a_unit_are_counted() {
        let text = "/// A.\n/// ```\n/// ```\n#[must_use]\npub fn a() {}\n/// B.\npub struct B {\n/// Height, m.\npub c: f64,\n\
                    /// Height.\npub d: f64,\n/// A name.\npub e: String,\n}\n\
                    pub(crate) fn f() -> f64 {}\n\
                    /// Speed (m/s).\n/// ```\npub fn g(\nx: f64,\n) -> f64 {\n\
                    #[cfg(test)]\nmod tests { pub fn d() {} }\n";
        assert_eq!(lacks(text), Lacks { examples: 1, units: 1 });
    }
}
