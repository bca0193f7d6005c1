//! The recipe as pages show it.

use landform::recipe::{Listed, stages};
use serde_json::{Map, Value as Json, json};

use super::Session;
use super::mistake::on;
use crate::text::{Block, blocks, of_item};

/// The tell `recipe`.
pub(crate) fn recipe(session: &Session) -> Json {
    let text = &**session.history.now();
    let blocks = blocks(text);
    let listed = session.reading.recipe.as_ref().map(landform::recipe::Recipe::listed).unwrap_or_default();
    let numbers: Vec<usize> = on(&blocks).collect();
    let steps: Vec<Json> = blocks
        .iter()
        .enumerate()
        .map(|(k, block)| step(session, k, block, text, numbers.iter().position(|&n| n == k), &listed))
        .collect();
    let recipe = session.reading.recipe.as_ref();
    let title = recipe.map_or(session.name.as_str(), |recipe| recipe.title.as_str());
    json!({
        "tell": "recipe", "revision": session.revision, "title": title,
        "path": session.path.as_ref().map(|path| path.display().to_string()),
        "text": text, "saved": session.is_saved(), "seed": recipe.map(|recipe| recipe.seed),
        "can_undo": session.history.can_undo(), "can_redo": session.history.can_redo(),
        "command": session.command(), "given": own_keys(text), "errors": session.reading.errors, "notes": session.reading.notes,
        "bytes": session.reading.bytes, "stages": steps,
    })
}

fn step(session: &Session, index: usize, block: &Block, text: &str, number: Option<usize>, listed: &[Listed]) -> Json {
    let mut given = given(block, text);
    let name = given.remove("use").and_then(|name| name.as_str().map(String::from)).unwrap_or_default();
    let processes = match given.remove("process") {
        Some(Json::Array(list)) if name == "evolve" => list,
        _ => Vec::new(),
    };
    let known = number.and_then(|number| listed.get(number)).filter(|listed| listed.name == name);
    let (nodes, notes) = number.and_then(|number| session.reading.planned.get(number)).cloned().unzip();
    let processes: Vec<Json> = processes
        .iter()
        .enumerate()
        .map(|(k, process)| {
            let mut given = process.as_object().cloned().unwrap_or_default();
            let name = given.remove("use").and_then(|name| name.as_str().map(String::from)).unwrap_or_default();
            let part = known.and_then(|listed| listed.parts.get(k)).filter(|part| part.name == name);
            let values = part.map_or_else(|| on_defaults(&name, &given), |part| part.parameters.clone());
            json!({ "use": name, "given": given, "values": values })
        })
        .collect();
    let mut values = match known {
        Some(listed) if listed.is_evolve() => json!({}),
        Some(listed) => listed.parts.first().map_or(json!({}), |part| part.parameters.clone()),
        None => on_defaults(&name, &given),
    };
    if let (Some(clock), Json::Object(map)) = (known.and_then(|listed| listed.clock.clone()), &mut values) {
        map.insert("clock".into(), clock);
    }
    json!({
        "index": index, "use": name, "label": given.get("label"), "verb": verb(&name), "on": !block.off,
        "line": block.line, "given": given, "values": values, "processes": processes,
        "seconds": number.and_then(|number| session.seconds.get(number).copied().flatten()),
        "nodes": nodes, "notes": notes.unwrap_or_default(),
    })
}

/// The keys of the whole recipe as its text has them.
fn own_keys(text: &str) -> Json {
    let document = text.parse::<toml_edit::DocumentMut>();
    let mut keys = document.map_or(json!({}), |document| of_item(document.as_item()));
    if let Json::Object(map) = &mut keys {
        map.shift_remove("stage");
    }
    keys
}

/// The keys of a step as its text has them.
fn given(block: &Block, text: &str) -> Map<String, Json> {
    let document = block.toml(text).parse::<toml_edit::DocumentMut>();
    let step = document.ok().and_then(|document| match of_item(document.get("stage")?) {
        Json::Array(mut list) if !list.is_empty() => Some(list.remove(0)),
        _ => None,
    });
    match step {
        Some(Json::Object(map)) => map,
        _ => Map::new(),
    }
}

/// What is given on top of a stage's defaults.
fn on_defaults(name: &str, given: &Map<String, Json>) -> Json {
    let mut values = stages().find(|stage| stage.name == name).map_or(json!({}), |stage| (stage.form.defaults)());
    if let Json::Object(map) = &mut values {
        map.extend(given.clone());
    }
    values
}

/// The verb of a stage as a word.
pub(crate) fn verb(name: &str) -> Option<String> {
    let stage = stages().find(|stage| stage.name == name);
    let found = stage.map(|stage| format!("{:?}", stage.verb).to_lowercase());
    found.or_else(|| (name == "evolve").then(|| "process".into()))
}
