//! The JSON schema of recipes, for editors.
//!
//! A stage is checked against the schema of the one that it names: with a choice among all of them
//! an editor could only say that none fits. Types of one name and different content, such as the
//! `until` of a clock and that of a coast, get names of their own.

use std::collections::BTreeMap;

use landform_core::stage::{Stage, Verb};
use landform_core::terrain::MaterialParams;
use landform_core::verb::{Environment, schema_of};
use serde_json::{Map, Value as Json, json};

use super::entry::EVOLVE;
use super::help::{catalogue, describe};
use super::{Clock, Watch};

/// The JSON schema of recipes, for editors.
pub fn schema() -> Json {
    let mut definitions = Map::new();
    let clock = adopt("clock", schema_of::<Clock>(), &mut definitions);
    definitions.insert("clock".into(), clock);
    for (name, schema) in [
        ("watch", schema_of::<Watch>()),
        ("environment", schema_of::<Environment>()),
        ("material", schema_of::<MaterialParams>()),
    ] {
        let schema = adopt(name, schema, &mut definitions);
        definitions.insert(name.into(), schema);
    }
    let (mut names, mut processes) = (vec![EVOLVE], Vec::new());
    for (stage, _) in catalogue() {
        let parameters = adopt(stage.name, (stage.form.schema)(), &mut definitions);
        if stage.verb == Verb::Process {
            processes.push(stage.name);
            definitions.insert(format!("process_{}", stage.name), lift(stage, false, parameters.clone()));
        }
        names.push(stage.name);
        definitions.insert(stage.name.into(), lift(stage, true, parameters));
    }
    definitions.insert(
        EVOLVE.into(),
        json!({ "type": "object", "additionalProperties": false, "required": ["use", "clock", "process"],
            "description": describe(EVOLVE),
            "properties": { "use": { "const": EVOLVE }, "label": { "type": "string" }, "from": { "type": "string" },
                "clock": { "$ref": "#/$defs/clock" }, "watch": { "$ref": "#/$defs/watch" },
                "process": { "type": "array", "minItems": 1, "items": named_by_use(&processes, "process_") } } }),
    );
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "landform recipe",
        "type": "object",
        "additionalProperties": false,
        "required": ["stage"],
        "properties": {
            "seed": { "type": "integer", "minimum": 0, "default": 0, "description": "Seed of everything that is random." },
            "title": { "type": "string", "description": "Title, for pictures and reports." },
            "environment": { "$ref": "#/$defs/environment" },
            "materials": { "type": "object", "additionalProperties": { "$ref": "#/$defs/material" },
                "description": "Changes to the table of materials, and new ones." },
            "stage": { "type": "array", "minItems": 1, "items": named_by_use(&names, "") },
        },
        "$defs": definitions,
    })
}

/// A table whose `use` is one of some names, checked against the definition of that name.
fn named_by_use(names: &[&str], prefix: &str) -> Json {
    let rule = |name: &&str| {
        json!({ "if": { "properties": { "use": { "const": name } }, "required": ["use"] },
            "then": { "$ref": format!("#/$defs/{prefix}{name}") } })
    };
    json!({ "type": "object", "required": ["use"], "properties": { "use": { "enum": names } },
        "allOf": names.iter().map(rule).collect::<Vec<_>>() })
}

/// Moves the types that a schema defines to those of the recipe; one whose name is taken by another
/// is named after its `owner`.
fn adopt(owner: &str, mut schema: Json, definitions: &mut Map<String, Json>) -> Json {
    let mut inner = match schema.get_mut("$defs").map(Json::take) {
        Some(Json::Object(inner)) => inner,
        _ => Map::new(),
    };
    if let Json::Object(map) = &mut schema {
        map.remove("$schema");
        map.remove("$defs");
    }
    let is_taken = |name: &String, it: &Json| definitions.get(name).is_some_and(|other| other != it);
    let renamed: BTreeMap<String, String> = inner
        .iter()
        .filter(|(name, it)| is_taken(name, it))
        .map(|(name, _)| (name.clone(), format!("{owner}_{name}")))
        .collect();
    if !renamed.is_empty() {
        redirect(&mut schema, &renamed);
        inner.values_mut().for_each(|it| redirect(it, &renamed));
    }
    definitions.extend(inner.into_iter().map(|(name, it)| (renamed.get(&name).cloned().unwrap_or(name), it)));
    schema
}

/// Lets references follow new names.
fn redirect(schema: &mut Json, renamed: &BTreeMap<String, String>) {
    match schema {
        Json::Object(map) => {
            if let Some(Json::String(reference)) = map.get_mut("$ref")
                && let Some(new) = reference.strip_prefix("#/$defs/").and_then(|name| renamed.get(name))
            {
                *reference = format!("#/$defs/{new}");
            }
            map.values_mut().for_each(|value| redirect(value, renamed));
        }
        Json::Array(list) => list.iter_mut().for_each(|value| redirect(value, renamed)),
        _ => {}
    }
}

/// A stage's schema with the keys that every stage takes.
fn lift(stage: &'static Stage, own_stage: bool, mut schema: Json) -> Json {
    schema["properties"]["use"] = json!({ "const": stage.name });
    schema["x-reach"] = (stage.form.reach)().to_string().into();
    if own_stage {
        schema["properties"]["label"] = json!({ "type": "string" });
        schema["properties"]["from"] = json!({ "type": "string" });
        schema["properties"]["with"] = json!({ "type": "array", "items": { "type": "string" } });
        if stage.verb == Verb::Process {
            schema["properties"]["clock"] = json!({ "$ref": "#/$defs/clock" });
            schema["properties"]["watch"] = json!({ "$ref": "#/$defs/watch" });
        }
    }
    let has_clock = stage.read(&(stage.form.defaults)()).is_ok_and(|read| read.own_clock().is_some());
    schema["required"] =
        if own_stage && stage.verb == Verb::Process && !has_clock { json!(["use", "clock"]) } else { json!(["use"]) };
    schema
}
