//! What stands behind a key of a rule.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, MapAccess, SeqAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A number, a formula or a word, cells to the east and to the north, or a field of the landscape.
///
/// ```
/// use landform_process::automaton::Value;
///
/// assert_eq!(serde_json::from_str::<Value>("[1, 0]")?, Value::Offset([1, 0]));
/// assert_eq!(serde_json::from_str::<Value>("3")?, Value::Number(3.0));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number, in the unit of the state that it is for.
    Number(f64),
    /// A formula or a word.
    Text(String),
    /// Cells to the east and to the north.
    Offset([i64; 2]),
    /// `{ field = "…" }`.
    Field(String),
}

impl Value {
    /// As it is written in a recipe.
    pub(super) fn text(&self) -> String {
        match self {
            Self::Number(number) => number.to_string(),
            Self::Text(text) => format!("\"{text}\""),
            Self::Offset([east, north]) => format!("[{east}, {north}]"),
            Self::Field(name) => format!("{{ field = \"{name}\" }}"),
        }
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(number) => serializer.serialize_f64(*number),
            Self::Text(text) => serializer.serialize_str(text),
            Self::Offset(cells) => cells.serialize(serializer),
            Self::Field(name) => {
                let mut map = serializer.serialize_map(Some(1))?;
                map.serialize_entry("field", name)?;
                map.end()
            }
        }
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

struct ValueVisitor;

impl<'de> Visitor<'de> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, a formula such as \"0.5*height\", cells such as [1, 0], or { field = \"…\" }")
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<Value, E> {
        Ok(Value::Number(number))
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<Value, E> {
        Ok(Value::Number(number as f64))
    }

    fn visit_u64<E: de::Error>(self, number: u64) -> Result<Value, E> {
        Ok(Value::Number(number as f64))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Value, E> {
        Ok(Value::Text(text.into()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Value, A::Error> {
        <[i64; 2]>::deserialize(de::value::SeqAccessDeserializer::new(seq)).map(Value::Offset)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Value, A::Error> {
        let mut field = None;
        while let Some(key) = map.next_key::<String>()? {
            if key != "field" {
                return Err(de::Error::unknown_field(&key, &["field"]));
            }
            field = Some(map.next_value()?);
        }
        field.map(Value::Field).ok_or_else(|| de::Error::missing_field("field"))
    }
}

impl JsonSchema for Value {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "value of an automaton".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "anyOf": [
                { "type": "number" },
                { "type": "string" },
                { "type": "array", "items": { "type": "integer" }, "minItems": 2, "maxItems": 2 },
                { "type": "object", "additionalProperties": false, "required": ["field"],
                  "properties": { "field": { "type": "string" } } },
            ]
        })
    }
}
