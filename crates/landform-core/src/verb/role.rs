//! Roles of parameters, by which a coarser copy of a recipe changes them.

use serde_json::Value;

use super::params::table_of;

/// Role of a parameter, where a program needs it: `x-role` in the schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Role {
    /// Distance between nodes: grows as the level gets coarser.
    Resolution,
    /// Number of nodes: falls with the square.
    Count,
    /// Number of samples of a file that become one. It grows, unless a resolution is given as well.
    Coarsening,
}

impl Role {
    fn of(property: &Value) -> Option<Self> {
        match property["x-role"].as_str()? {
            "resolution" => Some(Self::Resolution),
            "count" => Some(Self::Count),
            "coarsening" => Some(Self::Coarsening),
            _ => None,
        }
    }
}

/// Parameters as they are where cells are `factor` times as long: by the roles in their schema,
/// tables within tables too.
pub fn coarser(schema: &Value, values: &Value, factor: u32) -> Value {
    let mut values = values.clone();
    coarsen(schema, &schema["$defs"], &mut values, f64::from(factor));
    values
}

fn coarsen(schema: &Value, definitions: &Value, values: &mut Value, factor: f64) {
    let (Some(properties), Some(values)) = (schema["properties"].as_object(), values.as_object_mut()) else { return };
    let given = |name: &String| values.get(name).is_some_and(|v| !v.is_null());
    let sized = properties.iter().any(|(name, p)| Role::of(p) == Some(Role::Resolution) && given(name));
    for (name, property) in properties {
        let Some(value) = values.get_mut(name) else { continue };
        match Role::of(property) {
            Some(Role::Resolution) => scale(value, factor),
            Some(Role::Count) => {
                let least = property["x-min"].as_u64().unwrap_or(1);
                if let Some(count) = value.as_u64() {
                    *value = ((count as f64 / (factor * factor)).round() as u64).max(least).into();
                }
            }
            Some(Role::Coarsening) if !sized => scale(value, factor),
            _ => {}
        }
        if let Some(table) = table_of(property, definitions) {
            match value {
                Value::Array(items) => items.iter_mut().for_each(|item| coarsen(table, definitions, item, factor)),
                one => coarsen(table, definitions, one, factor),
            }
        }
    }
}

/// A number, or the number of a quantity such as "30 m", times a factor.
fn scale(value: &mut Value, factor: f64) {
    let scaled = match value {
        Value::Number(n) if n.is_u64() => n.as_u64().map(|n| ((n as f64 * factor).round() as u64).into()),
        Value::Number(n) => n.as_f64().map(|n| (n * factor).into()),
        Value::String(text) => {
            let (number, unit) = text.split_once(' ').unwrap_or((text, ""));
            number.parse::<f64>().ok().map(|n| format!("{} {unit}", n * factor).trim_end().into())
        }
        _ => None,
    };
    if let Some(scaled) = scaled {
        *value = scaled;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn values_follow_their_roles() {
        let schema = json!({
            "properties": {
                "grid": { "$ref": "#/$defs/grid" }, "nodes": { "x-role": "count", "x-min": 12 },
                "thin": { "x-role": "coarsening" }, "name": {},
            },
            "$defs": { "grid": { "properties": { "cell": { "x-role": "resolution" }, "size": {} } } },
        });
        let values = json!({ "grid": { "cell": "2.5 m", "size": "4 km" }, "nodes": 20_000, "thin": 1, "name": "2 m" });
        let expected = json!({ "grid": { "cell": "10 m", "size": "4 km" }, "nodes": 1250, "thin": 4, "name": "2 m" });
        assert_eq!(coarser(&schema, &values, 4), expected);
        assert_eq!(coarser(&schema, &json!({ "nodes": 40 }), 8), json!({ "nodes": 12 }));
    }
}
