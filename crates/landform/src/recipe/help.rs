//! Help on stages, for people: catalogue, parameters, citations.

use serde_json::Value as Json;

use landform_core::stage::Stage;

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
    let texts = |key: &str| property[key].as_array().into_iter().flatten().filter_map(Json::as_str);
    let words: Vec<&str> = texts("x-choices").collect();
    let choices = (!words.is_empty()).then(|| format!("one of {}", words.join(", ")));
    let tables: Vec<String> = texts("x-tables").map(|keys| format!("{{ {keys} }}")).collect();
    let or = if words.is_empty() { "" } else { "or " };
    let tables = (!tables.is_empty()).then(|| format!("{or}a table {}", tables.join(" or ")));
    let bounds = [bound("x-above", ">"), bound("x-min", "at least"), bound("x-max", "at most")];
    bounds.into_iter().chain([choices, tables]).flatten().collect::<Vec<_>>().join(", ")
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
