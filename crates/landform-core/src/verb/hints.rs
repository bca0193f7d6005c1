//! Hints for a form that shows a parameter: the usual range, its scale, its purpose, its group.
//!
//! `x-soft-min` and `x-soft-max` are the ends of a slider in the customary unit, never outside of
//! `x-min` and `x-max`; `x-scale` is "linear" or "log"; `x-role` is "resolution", "count",
//! "coarsening", "input" or "output"; `x-group` is "grid", "files", "surroundings", "options" or
//! "main". Hints that a parameter's schema has already are kept.

use serde_json::{Map, Value, json};

use crate::units::soft_range;

/// Adds hints to every parameter of a schema, tables within it too; `defaults` in customary units,
/// `inputs` the keys of files that are read.
pub fn add_hints(schema: &mut Value, defaults: &Value, inputs: &[&str]) {
    let mut tables = Vec::new();
    if let Some(properties) = schema["properties"].as_object_mut() {
        hint_all(properties, defaults, inputs, &mut tables);
    }
    while let Some((name, defaults)) = tables.pop() {
        if let Some(properties) = schema["$defs"][&name]["properties"].as_object_mut() {
            hint_all(properties, &defaults, &[], &mut tables);
        }
    }
}

type Tables = Vec<(String, Value)>;

fn hint_all(properties: &mut Map<String, Value>, defaults: &Value, inputs: &[&str], tables: &mut Tables) {
    for (name, property) in properties {
        let default = &defaults[name];
        // Tables that contain themselves have no default there, so this ends.
        if let Some(table) = property["$ref"].as_str().and_then(|r| r.strip_prefix("#/$defs/"))
            && default.is_object()
        {
            tables.push((table.into(), default.clone()));
        }
        let Some(property) = property.as_object_mut() else { continue };
        let role = match name.as_str() {
            name if inputs.contains(&name) => Some("input"),
            "path" | "report" => Some("output"),
            _ => None,
        };
        if let Some(role) = role {
            property.entry("x-role").or_insert(role.into());
        }
        let group = group(name, property);
        property.entry("x-group").or_insert(group.into());
        if property.get("x-dimension").is_none()
            && property.get("type").is_some_and(|t| t == "integer" || t == "number")
        {
            for (from, to) in [("x-min", "minimum"), ("x-max", "maximum"), ("x-above", "exclusiveMinimum")] {
                if let Some(bound) = property.get(from).cloned() {
                    property.insert(to.into(), bound);
                }
            }
        }
        for (key, value) in slider(property, default) {
            property.entry(key).or_insert(value);
        }
    }
}

fn group(name: &str, property: &Map<String, Value>) -> &'static str {
    let is = |key: &str| property.get(key).is_some();
    match property.get("x-role").and_then(Value::as_str) {
        Some("resolution" | "count" | "coarsening") => "grid",
        Some("input" | "output") => "files",
        _ if ["grid", "size"].contains(&name) => "grid",
        _ if ["sea_level", "rainfall", "outlets", "wind", "temperature", "currents"].contains(&name) => "surroundings",
        _ if is("x-unit") || is("x-min") || is("x-above") => "main",
        _ => "options",
    }
}

/// The ends and the scale of a slider for a number; nothing for what is none.
fn slider(property: &Map<String, Value>, default: &Value) -> Vec<(&'static str, Value)> {
    let bound = |key: &str| property.get(key).and_then(Value::as_f64);
    let dimension = property.get("x-dimension").and_then(Value::as_str).unwrap_or_default();
    let is_number = default.is_number() || !dimension.is_empty();
    if !is_number {
        return Vec::new();
    }
    let (least, most) = (bound("x-min").or(bound("x-above")), bound("x-max"));
    let usual = number(default).filter(|d| *d != 0.0);
    let [low, high, log] = match (soft_range(dimension), usual) {
        (Some([low, high]), usual) => [usual.map_or(low, |d| low.min(d)), usual.map_or(high, |d| high.max(d)), 1.0],
        (None, Some(d)) if least == Some(0.0) && most.is_none() && default.is_string() => [d / 30.0, d * 30.0, 1.0],
        (None, Some(d)) if d > 0.0 => [least.unwrap_or(0.0), 10.0 * d, 0.0],
        (None, Some(d)) => [10.0 * d, least.unwrap_or(0.0).max(-10.0 * d), 0.0],
        (None, None) => match (least, most) {
            (Some(least), Some(most)) => [least, most, 0.0],
            _ => return Vec::new(),
        },
    };
    let low = least.map_or(low, |b| low.max(b));
    // A bound that is itself excluded is no end of a slider.
    let is_excluded = bound("x-above") == Some(low);
    let low = if is_excluded { low + 0.01 * (usual.unwrap_or(high).abs().min(high - low)) } else { low };
    let high = most.map_or(high, |b| high.min(b));
    if !(low < high) {
        return Vec::new();
    }
    let scale = if log > 0.0 && low > 0.0 { "log" } else { "linear" };
    vec![("x-soft-min", json!(low)), ("x-soft-max", json!(high)), ("x-scale", scale.into())]
}

/// The number of a value such as "0.4 mm/yr".
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::String(text) => text.split(' ').next()?.parse().ok(),
        other => other.as_f64(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sliders_stay_within_bounds_and_keep_what_was_said() {
        let mut schema = json!({
            "properties": {
                "erodibility": { "x-dimension": "erodibility", "x-unit": "1/yr", "x-min": 0.0, "x-max": 1000.0 },
                "hurst": { "x-min": 0.0, "x-max": 1.0, "x-soft-min": 0.3 },
                "path": {},
                "grid": { "$ref": "#/$defs/grid" },
            },
            "$defs": { "grid": { "properties": { "cell_size": { "x-dimension": "length", "x-above": 0.0, "x-role": "resolution" } } } },
        });
        let defaults =
            json!({ "erodibility": "2e-6 1/yr", "hurst": 0.8, "path": "a.png", "grid": { "cell_size": "10 m" } });
        add_hints(&mut schema, &defaults, &[]);
        let p = &schema["properties"];
        assert_eq!((&p["erodibility"]["x-soft-min"], &p["erodibility"]["x-scale"]), (&json!(1e-8), &json!("log")));
        assert_eq!((&p["hurst"]["x-soft-min"], &p["hurst"]["x-soft-max"]), (&json!(0.3), &json!(1.0)));
        assert_eq!((&p["path"]["x-role"], &p["path"]["x-group"]), (&json!("output"), &json!("files")));
        let cell = &schema["$defs"]["grid"]["properties"]["cell_size"];
        assert_eq!((&cell["x-soft-max"], &cell["x-group"]), (&json!(300.0), &json!("grid")));
    }
}
