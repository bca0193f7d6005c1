//! Help on stages, for people and for editors: catalogue, schema, citations.

use serde_json::{Value as Json, json};

use landform_core::stage::{Stage, Verb};
use landform_core::terrain::MaterialParams;
use landform_core::verb::Environment;
use schemars::JsonSchema;

use super::entry::EVOLVE;
use super::stages::{stage, stages};
use super::{Clock, Recipe, Watch};

/// A parameter, as help shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// Customary unit; empty for plain numbers and words.
    pub unit: String,
    /// Default, as it would be typed.
    pub default: String,
    /// Range, in words; empty if there is none.
    pub range: String,
    /// Whether it may vary in space.
    pub varying: bool,
    /// Meaning.
    pub meaning: String,
}

/// A source with the stages that rest on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Citation {
    /// Authors and year.
    pub authors: &'static str,
    /// Title and where it appeared.
    pub title: &'static str,
    /// Digital object identifier.
    pub doi: &'static str,
    /// Stages.
    pub stages: Vec<&'static str>,
}

/// Names of the stages with their verb, summary and the kinds that they run on, once each.
pub fn catalogue() -> Vec<(&'static Stage, Vec<&'static str>)> {
    stages().map(|stage| (stage, stage.kinds().map(|k| k.name()).collect())).collect()
}

/// The parameters of a stage of the table, or of a clock for `evolve`.
pub fn parameters(name: &str) -> Option<Vec<Parameter>> {
    if name == EVOLVE {
        let defaults = serde_json::to_value(Clock::default()).unwrap_or_default();
        let mut all = list(landform_core::verb::properties::<Clock>(), &defaults);
        all.iter_mut().for_each(|p| p.name = format!("clock.{}", p.name));
        let defaults = serde_json::to_value(Watch::default()).unwrap_or_default();
        let watch = list(landform_core::verb::properties::<Watch>(), &defaults);
        all.extend(watch.into_iter().map(|p| Parameter { name: format!("watch.{}", p.name), ..p }));
        return Some(all);
    }
    let stage = stage(name)?;
    Some(list((stage.form.properties)(), &(stage.form.defaults)()))
}

fn list(properties: Vec<(String, Json)>, defaults: &Json) -> Vec<Parameter> {
    properties
        .into_iter()
        .map(|(name, property)| {
            let inner = unwrap_option(&property);
            let unit =
                find(inner, "x-unit").and_then(Json::as_str).filter(|u| *u != "1").unwrap_or_default().to_string();
            let varying = find(inner, "x-varying").is_some();
            let meaning = property["description"].as_str().unwrap_or_default().replace('\n', " ");
            let default = match &defaults[&name] {
                Json::Null => "none".into(),
                value => value.to_string(),
            };
            Parameter { range: range(&property, &unit), unit, default, varying, meaning, name }
        })
        .collect()
}

/// The schema behind an optional value or a list.
fn unwrap_option(property: &Json) -> &Json {
    property
        .get("anyOf")
        .and_then(Json::as_array)
        .and_then(|a| a.first())
        .filter(|_| find(property, "x-unit").is_none())
        .unwrap_or(property)
}

fn find<'a>(property: &'a Json, key: &str) -> Option<&'a Json> {
    property.get(key).or_else(|| property.get("items").and_then(|i| i.get(key)))
}

fn range(property: &Json, unit: &str) -> String {
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let bound = |key: &str, word: &str| property[key].as_f64().map(|b| format!("{word} {b}{unit}"));
    let words: Vec<&str> = property["x-choices"].as_array().into_iter().flatten().filter_map(Json::as_str).collect();
    let choices = (!words.is_empty()).then(|| format!("one of {}", words.join(", ")));
    let bounds = [bound("x-above", ">"), bound("x-min", "at least"), bound("x-max", "at most")];
    bounds.into_iter().chain([choices]).flatten().collect::<Vec<_>>().join(", ")
}

/// The purpose of a stage.
pub fn describe(name: &str) -> Option<String> {
    if name == EVOLVE {
        return Some(
            "Runs several processes on one clock, coupled: in each step one after the other, in the order in which `process` \
             lists them. A single process may stand alone, with its own `clock`."
                .into(),
        );
    }
    stage(name).map(Stage::summary)
}

/// The papers behind a recipe.
pub fn cite(recipe: &Recipe) -> Vec<Citation> {
    let mut citations: Vec<Citation> = Vec::new();
    for stage in recipe.entries.iter().flat_map(|e| e.work.parts()).map(|p| p.stage()) {
        for source in stage.sources {
            match citations.iter_mut().find(|c| c.title == source.title) {
                Some(c) if c.stages.contains(&stage.name) => {}
                Some(c) => c.stages.push(stage.name),
                None => citations.push(Citation {
                    authors: source.authors,
                    title: source.title,
                    doi: source.doi,
                    stages: vec![stage.name],
                }),
            }
        }
    }
    citations
}

/// The JSON schema of recipes, for editors.
pub fn schema() -> Json {
    let mut definitions = serde_json::Map::new();
    let mut stage_refs = vec![json!({ "$ref": "#/$defs/evolve" })];
    let mut process_refs = Vec::new();
    for (stage, _) in catalogue() {
        let process = stage.verb == Verb::Process;
        if process {
            definitions.insert(format!("process_{}", stage.name), lift(stage, false, &mut serde_json::Map::new()));
            process_refs.push(json!({ "$ref": format!("#/$defs/process_{}", stage.name) }));
        }
        let mut inner = serde_json::Map::new();
        let schema = lift(stage, true, &mut inner);
        definitions.insert(stage.name.into(), schema);
        definitions.extend(inner);
        stage_refs.push(json!({ "$ref": format!("#/$defs/{}", stage.name) }));
    }
    let tables = [
        ("clock", schema_of::<Clock>()),
        ("watch", schema_of::<Watch>()),
        ("environment", schema_of::<Environment>()),
        ("material", schema_of::<MaterialParams>()),
    ];
    for (name, mut schema) in tables {
        if let Some(Json::Object(inner)) = schema.get_mut("$defs").map(Json::take) {
            definitions.extend(inner);
        }
        strip(&mut schema);
        definitions.insert(name.into(), schema);
    }
    definitions.insert(
        EVOLVE.into(),
        json!({ "type": "object", "additionalProperties": false, "required": ["use", "clock", "process"],
            "description": describe(EVOLVE),
            "properties": { "use": { "const": EVOLVE }, "label": { "type": "string" }, "from": { "type": "string" },
                "clock": { "$ref": "#/$defs/clock" }, "watch": { "$ref": "#/$defs/watch" }, "process": { "type": "array", "minItems": 1, "items": { "oneOf": process_refs } } } }),
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
            "stage": { "type": "array", "minItems": 1, "items": { "oneOf": stage_refs } },
        },
        "$defs": definitions,
    })
}

/// The JSON schema of a type.
fn schema_of<P: JsonSchema>() -> Json {
    schemars::schema_for!(P).to_value()
}

/// A stage's schema with the keys that every stage takes.
fn lift(stage: &'static Stage, own_stage: bool, inner: &mut serde_json::Map<String, Json>) -> Json {
    let mut schema = (stage.form.schema)();
    if let Some(Json::Object(definitions)) = schema.get_mut("$defs").map(Json::take) {
        inner.extend(definitions);
    }
    strip(&mut schema);
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

fn strip(schema: &mut Json) {
    if let Json::Object(map) = schema {
        map.remove("$schema");
        map.remove("$defs");
    }
}
