//! Public items of the libraries whose documentation has no example: their number only falls.
//!
//! Lines are read, not parsed: an item is a line that begins with `pub`, outside of tests, and its documentation the comment above
//! it. What stands in a private module counts too.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::layers::sources;

const KEPT: &str = "xtask/examples.json";
const CRATES: [&str; 4] = ["landform-core", "landform-process", "landform-io", "landform"];
const ITEMS: [&str; 6] = ["pub fn ", "pub struct ", "pub enum ", "pub trait ", "pub const ", "pub type "];

pub(crate) fn run(accept: bool) -> bool {
    let found: BTreeMap<&str, usize> = CRATES.iter().map(|name| (*name, of_crate(name))).collect();
    let text = format!("{}\n", serde_json::to_string_pretty(&found).unwrap_or_default());
    if accept {
        return fs::write(KEPT, text).inspect_err(|e| println!("examples: {KEPT}: {e}")).is_ok();
    }
    let kept: BTreeMap<String, usize> =
        fs::read_to_string(KEPT).ok().and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
    let mut is_fine = true;
    for (name, now) in &found {
        let before = kept.get(*name).copied().unwrap_or(0);
        println!("examples: {name}: {now} public items without one, {before} kept");
        if *now > before {
            println!("examples: give one to what is new, or take others' `pub` away");
            is_fine = false;
        }
    }
    is_fine
}

fn of_crate(name: &str) -> usize {
    sources(&Path::new("crates").join(name).join("src"))
        .iter()
        .filter(|path| !path.ends_with("tests.rs"))
        .filter_map(|path| fs::read_to_string(path).ok())
        .map(|text| without_example(&text))
        .sum()
}

fn without_example(text: &str) -> usize {
    let (mut count, mut has_example) = (0, false);
    for line in text.lines().take_while(|line| !line.starts_with("#[cfg(test)]")).map(str::trim) {
        if line.starts_with("///") {
            has_example |= line.contains("```");
        } else if !line.starts_with("#[") {
            count += usize::from(!has_example && ITEMS.iter().any(|item| line.starts_with(item)));
            has_example = false;
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_without_an_example_are_counted() {
        let text = "/// A.\n/// ```\n/// ```\n#[must_use]\npub fn a() {}\n/// B.\npub struct B;\npub(crate) fn c() {}\n\
                    #[cfg(test)]\nmod tests { pub fn d() {} }\n";
        assert_eq!(without_example(text), 1);
    }
}
