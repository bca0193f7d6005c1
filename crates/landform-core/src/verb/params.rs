//! Parameters: one struct from which everything else is derived.

use std::fmt::Debug;

use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::{Estimate, Reach};
use crate::error::Range;
use crate::feature::FeatureKind;
use crate::{Error, Result};

/// A published source of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Source {
    /// "Braun & Willett (2013)".
    pub authors: &'static str,
    /// Title and where it appeared.
    pub title: &'static str,
    /// Digital object identifier, or empty.
    pub doi: &'static str,
}

/// The parameters of a stage. From this one struct follow the keys in recipes, defaults, ranges,
/// refusal of unknown keys, JSON schema, help and citation.
///
/// Ranges are declared on fields in the customary unit, by `#[schemars(extend("x-min" = 0.0))]`,
/// `x-max`, and `x-above` for a bound that is itself excluded; [`Params::validate`] reads them back
/// from the schema and enforces them.
pub trait Params: Clone + Debug + Default + Serialize + DeserializeOwned + JsonSchema + Send + Sync + 'static {
    /// Name of the stage in recipes.
    const NAME: &'static str;
    /// The papers behind it; a method that is not from a paper names its origin.
    const SOURCES: &'static [Source];
    /// Keys whose value is a path to a file that is read.
    const INPUTS: &'static [&'static str] = &[];
    /// Whether it takes other landscapes (`with = ["label"]`).
    const WITH: bool = false;
    /// Kinds of features that the landscape must have, left by a stage before it.
    const NEEDS: &'static [FeatureKind] = &[];
    /// Parameters that vary in space and may change in time as well.
    const IN_TIME: &'static [&'static str] = &[];
    /// Keys of earlier recipes, and their names now ("steps" → "iterations", "size" → "grid.size").
    const RENAMED: &'static [(&'static str, &'static str)] = &[];
    /// Keys of earlier recipes that are still read, and the key that says the same now ("rivers" →
    /// "features").
    const OBSOLETE: &'static [(&'static str, &'static str)] = &[];

    /// Files that the stage writes, below the output folder.
    fn outputs(&self) -> Vec<String> {
        Vec::new()
    }

    /// Bytes a node of a raster that it takes at its peak beside the elevations, as measured; none
    /// if that was not measured.
    fn bytes_a_node(&self) -> Option<u64> {
        None
    }

    /// Places east and north (m) that must lie on the map, each with the parameter that names it.
    fn places(&self) -> Vec<(&'static str, [f64; 2])> {
        Vec::new()
    }

    /// Fields that a stage leaves that is no process (those have `WRITES`).
    fn leaves(&self) -> Vec<String> {
        Vec::new()
    }

    /// How far around a node the ground can affect the result there.
    fn reach(&self) -> Reach {
        Reach::Whole
    }

    /// Whether water follows slopes from node to node of a raster, so that nodes should stand off
    /// the centres of their cells.
    fn jitters(&self) -> bool {
        false
    }

    /// Checks that a range cannot express.
    ///
    /// # Errors
    /// If a parameter is wrong; the error names the first.
    fn check(&self) -> Result<()> {
        Ok(())
    }

    /// Checks lengths against the extent of the map east and north, m. It is called before a run
    /// where the extent is known then.
    ///
    /// # Errors
    /// If a parameter does not fit the map; the error names the first.
    fn check_on(&self, _extent: [f64; 2]) -> Result<()> {
        Ok(())
    }

    /// The fastest that the stage raises ground by itself, m/s, where that is known before a run.
    fn raises(&self) -> Option<f64> {
        None
    }

    /// What a user should know before a run of ground like `before`, which is raised at up to
    /// `raised` (m/s) on the same clock: not wrong, but seldom wanted.
    fn warning(&self, _before: &Estimate, _raised: f64) -> Option<String> {
        None
    }

    /// Ranges, then [`Params::check`].
    ///
    /// # Errors
    /// If a parameter is wrong; the error names the first.
    fn validate(&self) -> Result<()> {
        let values = serde_json::to_value(self).map_err(|e| Error::parameter(Self::NAME, "?", &e.to_string()))?;
        let schema = schema_of::<Self>();
        validate_ranges(&schema, &values)?;
        refuse_courses(&schema, &values, Self::IN_TIME)?;
        self.check()
    }
}

/// The JSON schema of a type, with its documentation as descriptions, but for examples in Rust.
///
/// ```
/// use landform_core::verb::{Wind, schema_of};
///
/// assert_eq!(schema_of::<Wind>()["description"], "A wind of a rose.");
/// ```
pub fn schema_of<P: JsonSchema>() -> Value {
    let mut schema = schemars::schema_for!(P).to_value();
    without_examples(&mut schema);
    schema
}

fn without_examples(schema: &mut Value) {
    match schema {
        Value::Object(object) => {
            for (key, value) in object {
                match value {
                    Value::String(text) if key == "description" => {
                        let prose = text.find("\n\n```").unwrap_or(text.len());
                        text.truncate(prose);
                    }
                    _ => without_examples(value),
                }
            }
        }
        Value::Array(all) => all.iter_mut().for_each(without_examples),
        _ => {}
    }
}

/// Name and schema of each parameter, in order of declaration.
pub fn properties<P: JsonSchema>() -> Vec<(String, Value)> {
    let mut schema = schema_of::<P>();
    let definitions = schema["$defs"].take();
    match schema.get_mut("properties").map(Value::take) {
        Some(Value::Object(map)) => map
            .into_iter()
            .map(|(name, mut property)| {
                let choices = choices(&property, &definitions);
                if !choices.is_empty() {
                    property["x-choices"] = choices.into();
                }
                // Those of what varies are the same everywhere, and told apart.
                let varies = property.to_string().contains("x-varying");
                let tables = if varies { Vec::new() } else { tables(&property, &definitions) };
                if !tables.is_empty() {
                    property["x-tables"] = tables.into();
                }
                (name, property)
            })
            .collect(),
        _ => Vec::new(),
    }
}

/// The values of a parameter, where they are words of a list.
fn choices(property: &Value, definitions: &Value) -> Vec<String> {
    if let Some(name) = property["$ref"].as_str().and_then(|r| r.strip_prefix("#/$defs/")) {
        return choices(&definitions[name], definitions);
    }
    let listed = |key: &str| property[key].as_array().into_iter().flatten();
    let words = listed("enum").filter_map(|v| v.as_str().map(String::from));
    let constants = listed("oneOf").filter_map(|v| v["const"].as_str().map(String::from));
    let nested = listed("anyOf").flat_map(|v| choices(v, definitions));
    let mut found: Vec<String> = words.chain(constants).chain(nested).collect();
    if found.is_empty() && property["items"].is_object() {
        found = choices(&property["items"], definitions);
    }
    found
}

/// The keys of each table that a parameter may be, or be a list of: "local, search".
fn tables(property: &Value, definitions: &Value) -> Vec<String> {
    if let Some(name) = property["$ref"].as_str().and_then(|r| r.strip_prefix("#/$defs/")) {
        return tables(&definitions[name], definitions);
    }
    let keys = property["properties"].as_object().map(|keys| keys.keys().cloned().collect::<Vec<_>>().join(", "));
    let forms = ["anyOf", "oneOf", "allOf"].iter().filter_map(|k| property[*k].as_array()).flatten();
    let of_forms = forms.chain(property.get("items")).flat_map(|form| tables(form, definitions));
    keys.into_iter().chain(of_forms).collect()
}

/// Checks values against the `x-min`, `x-max` and `x-above` of a schema's properties, tables within
/// tables and lists of tables too.
///
/// # Errors
/// [`Error::OutOfRange`] for the first value outside, with its name as a path: "grid.cell_size".
pub fn validate_ranges(schema: &Value, values: &Value) -> Result<()> {
    within(schema, &schema["$defs"], values, "")
}

fn within(schema: &Value, definitions: &Value, values: &Value, prefix: &str) -> Result<()> {
    let (Some(properties), Some(values)) = (schema["properties"].as_object(), values.as_object()) else {
        return Ok(());
    };
    for (name, property) in properties {
        let Some(value) = values.get(name) else { continue };
        let path = format!("{prefix}{name}");
        let range = range_of(property);
        if let Some((value, text)) = numbers(value).into_iter().find(|(number, _)| !range.contains(*number)) {
            return Err(Error::OutOfRange { name: path, value, text, range: Box::new(range) });
        }
        if let Some(table) = table_of(property, definitions) {
            let tables = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
            tables.iter().try_for_each(|t| within(table, definitions, t, &format!("{path}.")))?;
        }
    }
    Ok(())
}

/// The schema of the table that a property is, may be, or is a list of.
pub(super) fn table_of<'a>(property: &'a Value, definitions: &'a Value) -> Option<&'a Value> {
    if let Some(name) = property["$ref"].as_str().and_then(|r| r.strip_prefix("#/$defs/")) {
        return Some(&definitions[name]).filter(|d| d["properties"].is_object());
    }
    let listed = ["anyOf", "allOf"].iter().filter_map(|k| property[*k].as_array()).flatten();
    listed.chain(property.get("items")).find_map(|p| table_of(p, definitions))
}

/// Refuses a course in time for a parameter that is read once.
fn refuse_courses(schema: &Value, values: &Value, allowed: &[&str]) -> Result<()> {
    for (name, value) in values.as_object().into_iter().flatten() {
        let course = value.get("times").is_some() || value.get("period").is_some();
        let property = &schema["properties"][name];
        if course && !allowed.contains(&name.as_str()) && property.to_string().contains("x-varying") {
            return Err(Error::parameter(name, "a course in time", "a value that does not change in time"));
        }
    }
    Ok(())
}

/// The range that a property of a schema is declared with.
fn range_of(property: &Value) -> Range {
    let bound = |key: &str| property[key].as_f64();
    let unit = property["x-unit"].as_str().filter(|u| *u != "1").unwrap_or_default().to_string();
    Range { above: bound("x-above"), least: bound("x-min"), most: bound("x-max"), unit }
}

/// The numbers in a parameter's value, in its customary unit, each with its text.
fn numbers(value: &Value) -> Vec<(f64, String)> {
    match value {
        Value::Number(n) => n.as_f64().map(|v| (v, n.to_string())).into_iter().collect(),
        Value::String(s) => {
            let number = s.split(' ').next().and_then(|n| n.parse().ok());
            number.map(|v| (v, s.clone())).into_iter().collect()
        }
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        Value::Object(map) => ["black", "white", "values", "mean", "inside", "outside"]
            .iter()
            .filter_map(|k| map.get(*k))
            .flat_map(numbers)
            .collect(),
        _ => Vec::new(),
    }
}
