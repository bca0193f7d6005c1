//! One change of a recipe's text that leaves all else as it is.

use landform::core::stage::Verb;
use landform::recipe::stages;
use landform::{Error, Result};
use serde::Deserialize;
use serde_json::{Map, Value as Json};
use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

use super::blocks::{Block, blocks, switched_off, switched_on};
use super::json::to_value;

/// A key, or a place in a list.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum Key {
    Place(usize),
    Name(String),
}

/// Which value of a text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Spot {
    /// The step, those that are off counted too; none for keys of the whole recipe.
    pub(crate) stage: Option<usize>,
    /// The process within the step.
    pub(crate) process: Option<usize>,
    /// Path of keys.
    pub(crate) key: Vec<Key>,
}

/// Deeper values are not found in recipes.
const MOST_KEYS: usize = 16;

/// The text with one value set, or removed where there is none.
pub(crate) fn set(text: &str, spot: &Spot, value: Option<&Json>) -> Result<String> {
    if spot.key.is_empty() || spot.key.len() > MOST_KEYS {
        return Err(wrong("key", format!("{} keys", spot.key.len()), "1 to 16"));
    }
    let value = value.filter(|value| !value.is_null()).map(to_value).transpose()?;
    change(text, |document| {
        let (table, inline) = table_of(document, text, spot)?;
        let (last, path) = spot.key.split_last().unwrap_or((&Key::Place(0), &[]));
        put(table, inline, path, last, value)
    })
}

/// Changes a text by its document; line ends stay as they were.
fn change(text: &str, edit: impl FnOnce(&mut DocumentMut) -> Result<()>) -> Result<String> {
    let dos = text.contains("\r\n");
    let plain = if dos { text.replace("\r\n", "\n") } else { text.to_string() };
    let mut document = plain.parse::<DocumentMut>().map_err(|e| broken(&plain, &e))?;
    edit(&mut document)?;
    let changed = document.to_string();
    Ok(if dos { changed.replace('\n', "\r\n") } else { changed })
}

fn broken(text: &str, error: &toml_edit::TomlError) -> Error {
    let before = &text[..text.floor_char_boundary(error.span().map_or(0, |span| span.start))];
    let line = before.matches('\n').count() + 1;
    Error::Recipe {
        at: Some((line, 1)),
        what: format!("the text is no TOML in line {line}: {}", error.message().trim()),
        hint: Some("mend the text first".into()),
    }
}

/// A table, and whether it stands within a line, `{ ... }`.
type Place<'d> = (&'d mut dyn TableLike, bool);

/// The table that a spot's keys are in.
fn table_of<'d>(document: &'d mut DocumentMut, text: &str, spot: &Spot) -> Result<Place<'d>> {
    let Some(stage) = spot.stage else { return Ok((document.as_table_mut(), false)) };
    let number = number_on(text, stage)?;
    let missing = || wrong("stage", stage.to_string(), "a step of the recipe");
    let stages = document.get_mut("stage").ok_or_else(missing)?;
    let table = nth(stages, number).ok_or_else(missing)?;
    let Some(process) = spot.process else { return Ok(table) };
    let missing = || wrong("process", process.to_string(), "a process of the step");
    table.0.get_mut("process").and_then(|list| nth(list, process)).ok_or_else(missing)
}

/// How many steps before one are on.
fn number_on(text: &str, stage: usize) -> Result<usize> {
    let blocks = blocks(text);
    match blocks.get(stage) {
        Some(block) if block.off => Err(Error::Recipe {
            at: Some((block.line, 1)),
            what: "this step is off".into(),
            hint: Some("turn it on before its values are changed".into()),
        }),
        Some(_) => Ok(blocks[..stage].iter().filter(|block| !block.off).count()),
        // Steps may stand in one list, `stage = [...]`.
        None => Ok(stage),
    }
}

fn nth(item: &mut Item, number: usize) -> Option<Place<'_>> {
    match item {
        Item::ArrayOfTables(tables) => tables.get_mut(number).map(|table| (table as &mut dyn TableLike, false)),
        Item::Value(Value::Array(list)) => {
            list.get_mut(number)?.as_inline_table_mut().map(|table| (table as &mut dyn TableLike, true))
        }
        _ => None,
    }
}

/// Puts a value below a table; tables on the way are made.
fn put(table: &mut dyn TableLike, inline: bool, path: &[Key], last: &Key, value: Option<Value>) -> Result<()> {
    let Some((first, rest)) = path.split_first() else { return put_here(table, inline, last, value) };
    let Key::Name(name) = first else { return Err(no_list()) };
    if table.get(name).is_none_or(Item::is_none) {
        if value.is_none() {
            return Ok(());
        }
        add(table, inline, name, Value::InlineTable(InlineTable::new()));
    }
    let item = table.get_mut(name).ok_or_else(no_list)?;
    put_in(item, name, rest, last, value)
}

fn put_in(item: &mut Item, name: &str, path: &[Key], last: &Key, value: Option<Value>) -> Result<()> {
    let not_a_table = || wrong("key", format!("`{name}`, which is no table"), "keys of tables");
    if item.is_table_like() {
        let inline = item.is_inline_table();
        let table = item.as_table_like_mut().ok_or_else(not_a_table)?;
        return put(table, inline, path, last, value);
    }
    if let Item::Value(Value::Array(list)) = item {
        let (place, path) = match (path.split_first(), last) {
            (Some((Key::Place(place), path)), _) => (*place, Some(path)),
            (None, Key::Place(place)) => (*place, None),
            _ => return Err(no_list()),
        };
        return match path {
            Some(path) => {
                let missing = || wrong("key", format!("place {place} of `{name}`"), "a place of the list");
                let table = list.get_mut(place).and_then(Value::as_inline_table_mut).ok_or_else(missing)?;
                put(table, true, path, last, value)
            }
            None => put_at(list, place, value),
        };
    }
    if value.is_some() && matches!(item, Item::Value(_)) && matches!(last, Key::Name(_)) {
        // A plain value gives way to a table.
        let mut table = InlineTable::new();
        put(&mut table, true, path, last, value)?;
        replace(item, Value::InlineTable(table));
        return Ok(());
    }
    Err(not_a_table())
}

fn put_at(list: &mut toml_edit::Array, place: usize, value: Option<Value>) -> Result<()> {
    match value {
        None if place < list.len() => {
            list.remove(place);
        }
        Some(value) if place < list.len() => {
            let value = with_decor_of(value, list.get(place));
            list.replace_formatted(place, value);
        }
        Some(value) if place == list.len() => list.push(value),
        _ => return Err(wrong("key", place.to_string(), "a place of the list")),
    }
    Ok(())
}

fn put_here(table: &mut dyn TableLike, inline: bool, key: &Key, value: Option<Value>) -> Result<()> {
    let Key::Name(name) = key else { return Err(no_list()) };
    match value {
        None => take_out(table, inline, name),
        Some(value) => match table.get_mut(name) {
            Some(item) if item.is_value() => replace(item, value),
            Some(item) => *item = Item::Value(value),
            None => add(table, inline, name, value),
        },
    }
    Ok(())
}

/// Adds a key at the end; within a line, the space before its end stays there.
fn add(table: &mut dyn TableLike, inline: bool, name: &str, mut value: Value) {
    if inline && let Some(last) = last_of(table) {
        let end = last.decor().suffix().cloned();
        last.decor_mut().set_suffix("");
        if let Some(end) = end {
            value.decor_mut().set_prefix(" ");
            value.decor_mut().set_suffix(end);
        }
    }
    table.insert(name, Item::Value(value));
}

/// Takes a key out; within a line, the space before its end stays.
fn take_out(table: &mut dyn TableLike, inline: bool, name: &str) {
    let is_last = table.iter().last().is_some_and(|(key, _)| key == name);
    let removed = table.remove(name);
    let end = removed.as_ref().and_then(Item::as_value).and_then(|value| value.decor().suffix()).cloned();
    if inline
        && is_last
        && let (Some(end), Some(last)) = (end, last_of(table))
    {
        last.decor_mut().set_suffix(end);
    }
}

fn last_of(table: &mut dyn TableLike) -> Option<&mut Value> {
    let (_, item) = table.iter_mut().last()?;
    item.as_value_mut()
}

/// Replaces a value; spaces and comments around it stay.
fn replace(item: &mut Item, value: Value) {
    let value = with_decor_of(value, item.as_value());
    *item = Item::Value(value);
}

fn with_decor_of(mut value: Value, old: Option<&Value>) -> Value {
    if let Some(old) = old {
        *value.decor_mut() = old.decor().clone();
    }
    value
}

/// The text with a new step before the one at a place, or a new process in an `evolve`.
pub(crate) fn insert(text: &str, at: usize, new: &str, process_of: Option<usize>) -> Result<String> {
    if let Some(stage) = process_of {
        return insert_process(text, at, new, stage);
    }
    let blocks = blocks(text);
    if at > blocks.len() {
        return Err(wrong("at", at.to_string(), &format!("0 to {}", blocks.len())));
    }
    let place = blocks.get(at).map_or(text.len(), |block| block.whole.start);
    Ok(with(text, place, &format!("[[stage]]\n{new}")))
}

fn insert_process(text: &str, at: usize, new: &str, stage: usize) -> Result<String> {
    let table = new.parse::<DocumentMut>().map_err(|e| broken(new, &e))?;
    change(text, |document| {
        let spot = Spot { stage: Some(stage), process: None, key: Vec::new() };
        let (step, inline) = table_of(document, text, &spot)?;
        let is_evolve = step.get("use").and_then(Item::as_str) == Some("evolve");
        if !is_evolve {
            return Err(wrong("process_of", stage.to_string(), "a step `evolve`"));
        }
        if step.get("process").is_none() {
            add(step, inline, "process", Value::Array(toml_edit::Array::new()));
        }
        match step.get_mut("process") {
            Some(Item::ArrayOfTables(tables)) => {
                let mut new = table.as_table().clone();
                new.set_position(None);
                let mut all: Vec<Table> = tables.iter().cloned().collect();
                all.insert(at.min(all.len()), new);
                all.iter_mut().for_each(|table| table.set_position(None));
                *tables = all.into_iter().collect();
            }
            Some(Item::Value(Value::Array(list))) => {
                let mut value = Value::InlineTable(table.as_table().clone().into_inline_table());
                let at = at.min(list.len());
                // As the one before it, or the one after.
                let beside = at.checked_sub(1).and_then(|k| list.get(k)).or(list.get(at));
                if let Some(prefix) = beside.and_then(|value| value.decor().prefix()).cloned() {
                    value.decor_mut().set_prefix(prefix);
                }
                list.insert_formatted(at, value);
            }
            _ => return Err(wrong("process_of", stage.to_string(), "a step with a list `process`")),
        }
        Ok(())
    })
}

/// The text with lines put in at a place, an empty line before and after.
fn with(text: &str, place: usize, new: &str) -> String {
    let (before, after) = text.split_at(place);
    let gap = match before {
        "" => "",
        b if b.ends_with("\n\n") => "",
        b if b.ends_with('\n') => "\n",
        _ => "\n\n",
    };
    let new = new.trim_end_matches('\n');
    let end = if after.is_empty() { "\n" } else { "\n\n" };
    format!("{before}{gap}{new}{end}{after}")
}

/// The text without a step, or without a process of it.
pub(crate) fn remove(text: &str, stage: usize, process: Option<usize>) -> Result<String> {
    let Some(process) = process else {
        let block = block(text, stage)?;
        return Ok(format!("{}{}", &text[..block.whole.start], &text[block.whole.end..]));
    };
    change(text, |document| {
        let spot = Spot { stage: Some(stage), process: None, key: Vec::new() };
        let missing = || wrong("process", process.to_string(), "a process of the step");
        match table_of(document, text, &spot)?.0.get_mut("process") {
            Some(Item::ArrayOfTables(tables)) if process < tables.len() => {
                tables.remove(process);
                Ok(())
            }
            Some(Item::Value(Value::Array(list))) if process < list.len() => {
                list.remove(process);
                Ok(())
            }
            _ => Err(missing()),
        }
    })
}

/// The text with a step at another place in the order.
pub(crate) fn relocate(text: &str, stage: usize, to: usize) -> Result<String> {
    let all = blocks(text);
    let moved = block(text, stage)?;
    if to >= all.len() {
        return Err(wrong("to", to.to_string(), &format!("0 to {}", all.len() - 1)));
    }
    let piece = text[moved.whole.clone()].trim_end_matches('\n').to_string();
    let rest = remove(text, stage, None)?;
    let place = blocks(&rest).get(to).map_or(rest.len(), |block| block.whole.start);
    Ok(with(&rest, place, &piece))
}

/// The text with a step off if it was on, and on if it was off.
pub(crate) fn toggle(text: &str, stage: usize) -> Result<String> {
    let block = block(text, stage)?;
    let body = &text[block.body.clone()];
    let other = if block.off { switched_on(body) } else { switched_off(body) };
    Ok(format!("{}{other}{}", &text[..block.body.start], &text[block.body.end..]))
}

/// The text of a recipe that makes the ground of another, up to a stage, and exports it.
pub(crate) fn only_ground(text: &str, last: usize, name: &str, parameters: &Map<String, Json>) -> Result<String> {
    change(text, |document| {
        let outputs = |table: &Table| {
            let name = table.get("use").and_then(Item::as_str).unwrap_or_default();
            let verb = stages().find(|stage| stage.name == name).map(|stage| stage.verb);
            matches!(verb, Some(Verb::Export | Verb::Measure))
        };
        let mut new = Table::new();
        new.insert("use", Item::Value(name.into()));
        for (key, value) in parameters.iter().filter(|(_, value)| !value.is_null()) {
            new.insert(key, Item::Value(to_value(value)?));
        }
        let Some(Item::ArrayOfTables(steps)) = document.get_mut("stage") else {
            return Err(wrong("stage", "no steps".into(), "steps that are written as [[stage]]"));
        };
        let mut all: Vec<Table> =
            steps.iter().take(last.saturating_add(1)).filter(|step| !outputs(step)).cloned().collect();
        all.push(new);
        for step in &mut all {
            // What is written on the way would be written again.
            step.remove("watch");
        }
        *steps = all.into_iter().collect();
        Ok(())
    })
}

fn block(text: &str, stage: usize) -> Result<Block> {
    let count = blocks(text).len();
    let expected =
        if count == 0 { "steps that are written as [[stage]]".into() } else { format!("0 to {}", count - 1) };
    blocks(text).into_iter().nth(stage).ok_or_else(|| wrong("stage", stage.to_string(), &expected))
}

fn no_list() -> Error {
    wrong("key", "a place where there is no list".into(), "names of keys, and places in lists")
}

fn wrong(name: &str, found: String, expected: &str) -> Error {
    Error::parameter(name, found, expected)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    const TEXT: &str = "# Title\nseed = 3 # lucky\n\n[[stage]]\nuse = \"flat\"\ngrid = { size = [\"1 km\", \"1 km\"], cell_size = \"10 m\" } # small\n\n[[stage]]\nuse = \"evolve\"\nclock = { dt = \"1 kyr\", duration = \"9 kyr\" }\nprocess = [\n  { use = \"uplift\", rate = \"1 mm/yr\" }, # up\n  { use = \"stream_power\" },\n]\n";

    fn spot(stage: Option<usize>, process: Option<usize>, key: &[&str]) -> Spot {
        Spot { stage, process, key: key.iter().map(|k| Key::Name((*k).into())).collect() }
    }

    #[test]
    fn one_value_changes_and_nothing_else() {
        for (spot, value, old, new) in [
            (spot(None, None, &["seed"]), json!(4), "seed = 3 # lucky", "seed = 4 # lucky"),
            (spot(Some(0), None, &["grid", "cell_size"]), json!("5 m"), "cell_size = \"10 m\"", "cell_size = \"5 m\""),
            (spot(Some(1), Some(0), &["rate"]), json!("2 mm/yr"), "\"1 mm/yr\"", "\"2 mm/yr\""),
            (spot(Some(1), None, &["clock", "dt"]), json!("2 kyr"), "dt = \"1 kyr\"", "dt = \"2 kyr\""),
        ] {
            assert_eq!(set(TEXT, &spot, Some(&value)).unwrap(), TEXT.replace(old, new));
        }
        let dos = TEXT.replace('\n', "\r\n");
        let set = set(&dos, &spot(None, None, &["seed"]), Some(&json!(4))).unwrap();
        assert_eq!(set, dos.replace("= 3", "= 4"));
    }

    #[test]
    fn keys_come_and_go() {
        let at = spot(Some(1), Some(1), &["erodibility"]);
        let with = set(TEXT, &at, Some(&json!("1e-6 1/yr"))).unwrap();
        assert!(with.contains("{ use = \"stream_power\", erodibility = \"1e-6 1/yr\" }"), "{with}");
        assert_eq!(set(&with, &at, None).unwrap(), TEXT);
        let sea = set(TEXT, &spot(None, None, &["environment", "sea_level"]), Some(&json!("5 m"))).unwrap();
        assert!(sea.contains("environment = { sea_level = \"5 m\" }"), "{sea}");
        assert_eq!(sea.parse::<DocumentMut>().unwrap()["environment"]["sea_level"].as_str(), Some("5 m"));
        let place = Spot {
            key: vec![Key::Name("grid".into()), Key::Name("size".into()), Key::Place(1)],
            ..spot(Some(0), None, &[])
        };
        assert!(set(TEXT, &place, Some(&json!("2 km"))).unwrap().contains("[\"1 km\", \"2 km\"]"));
    }

    #[test]
    fn what_cannot_be_set_is_refused() {
        for (spot, value) in [
            (spot(Some(7), None, &["a"]), json!(1)),
            (spot(Some(1), Some(9), &["a"]), json!(1)),
            (spot(None, None, &[]), json!(1)),
            (spot(None, None, &["a"]), json!([null])),
            (spot(None, None, &["a"]), json!(u64::MAX)),
            (Spot { key: vec![Key::Place(3)], ..spot(None, None, &[]) }, json!(1)),
        ] {
            assert!(set(TEXT, &spot, Some(&value)).is_err(), "{spot:?}");
        }
        assert!(set("a = = 1", &spot(None, None, &["a"]), Some(&json!(1))).is_err());
    }

    #[test]
    fn steps_come_go_and_move() {
        let with = insert(TEXT, 1, "use = \"add\"\n", None).unwrap();
        assert_eq!(blocks(&with).len(), 3);
        assert_eq!(remove(&with, 1, None).unwrap(), TEXT);
        let swapped = relocate(TEXT, 0, 1).unwrap();
        assert!(swapped.find("evolve") < swapped.find("flat"), "{swapped}");
        assert!(swapped.starts_with("# Title\nseed = 3 # lucky\n\n[[stage]]\nuse = \"evolve\""));
        let more = insert(TEXT, 1, "use = \"linear_diffusion\"\n", Some(1)).unwrap();
        assert!(more.contains("\n  { use = \"linear_diffusion\" },"), "{more}");
        assert_eq!(more.parse::<DocumentMut>().unwrap()["stage"][1]["process"].as_array().unwrap().len(), 3);
        let fewer = remove(&more, 1, Some(1)).unwrap();
        assert_eq!(fewer.parse::<DocumentMut>().unwrap()["stage"][1]["process"].as_array().unwrap().len(), 2);
        assert!(insert(TEXT, 9, "use = \"add\"", None).is_err() && insert(TEXT, 0, "use = \"x\"", Some(0)).is_err());
        assert!(remove(TEXT, 5, None).is_err() && relocate(TEXT, 0, 2).is_err());
    }

    #[test]
    fn a_step_is_turned_off_and_on() {
        let off = toggle(TEXT, 0).unwrap();
        assert!(off.contains("#off [[stage]]\n#off use = \"flat\"\n"), "{off}");
        assert!(set(&off, &spot(Some(0), None, &["a"]), Some(&json!(1))).is_err());
        // Steps that are off are counted, and passed over.
        let changed = set(&off, &spot(Some(1), Some(0), &["rate"]), Some(&json!("3 mm/yr"))).unwrap();
        assert_eq!(changed, off.replace("1 mm/yr", "3 mm/yr"));
        assert_eq!(toggle(&off, 0).unwrap(), TEXT);
    }
}
