//! Parameters: one struct from which everything else is derived.

use std::fmt::Debug;

use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

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

/// The parameters of a stage. From this one struct come the words in recipes, defaults, ranges, refusal of unknown words,
/// JSON schema, help and citation.
///
/// Ranges are declared on fields in the customary unit, by `#[schemars(extend("x-min" = 0.0))]`, `x-max`, and `x-above` for
/// a bound that is itself excluded; [`Params::validate`] reads them back from the schema and enforces them.
pub trait Params: Clone + Debug + Default + Serialize + DeserializeOwned + JsonSchema + Send + Sync + 'static {
    /// Name of the stage in recipes.
    const NAME: &'static str;
    /// The papers behind it; what is not from a paper says where it is from.
    const SOURCES: &'static [Source];
    /// Keys whose value is a path to a file that is read.
    const INPUTS: &'static [&'static str] = &[];

    /// What a range cannot say.
    ///
    /// # Errors
    /// The first parameter that is wrong.
    fn check(&self) -> Result<()> {
        Ok(())
    }

    /// Ranges, then [`Params::check`].
    ///
    /// # Errors
    /// The first parameter that is wrong.
    fn validate(&self) -> Result<()> {
        let values = serde_json::to_value(self).map_err(|e| Error::parameter(Self::NAME, "?", &e.to_string()))?;
        validate_ranges(&schema_of::<Self>(), &values)?;
        self.check()
    }
}

/// The JSON schema of a set of parameters.
fn schema_of<P: JsonSchema>() -> Value {
    schemars::schema_for!(P).to_value()
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
                (name, property)
            })
            .collect(),
        _ => Vec::new(),
    }
}

/// The words that a parameter may be, where it is one of a list.
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

/// Checks values against the `x-min`, `x-max` and `x-above` of a schema's properties.
///
/// # Errors
/// [`Error::Parameter`] for the first value outside.
pub fn validate_ranges(schema: &Value, values: &Value) -> Result<()> {
    let (Some(properties), Some(values)) = (schema["properties"].as_object(), values.as_object()) else {
        return Ok(());
    };
    for (name, property) in properties {
        let Some(value) = values.get(name) else { continue };
        for (number, text) in numbers(value) {
            let bound = |key: &str| property[key].as_f64();
            let inside = bound("x-min").is_none_or(|b| number >= b * (1.0 - 1e-9))
                && bound("x-max").is_none_or(|b| number <= b * (1.0 + 1e-9))
                && bound("x-above").is_none_or(|b| number > b);
            if !inside {
                return Err(Error::parameter(name, text, &range_text(property)));
            }
        }
    }
    Ok(())
}

/// A range in words: "> 0 and at most 4 m".
pub(crate) fn range_text(property: &Value) -> String {
    let unit = property["x-unit"].as_str().filter(|u| *u != "1").map(|u| format!(" {u}")).unwrap_or_default();
    let mut parts = Vec::new();
    for (key, word) in [("x-above", ">"), ("x-min", "at least"), ("x-max", "at most")] {
        if let Some(b) = property[key].as_f64() {
            parts.push(format!("{word} {b}{unit}"));
        }
    }
    parts.join(" and ")
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
        Value::Object(map) => ["black", "white"].iter().filter_map(|k| map.get(*k)).flat_map(numbers).collect(),
        _ => Vec::new(),
    }
}
