//! Values between TOML and JSON.

use landform::{Error, Result};
use serde_json::{Map, Value as Json};
use toml_edit::{Array, InlineTable, Item, TableLike, Value};

/// A value of a text as JSON. Numbers that JSON does not have are null.
pub(crate) fn of_item(item: &Item) -> Json {
    match item {
        Item::None => Json::Null,
        Item::Value(value) => of_value(value),
        Item::Table(table) => of_table(table),
        Item::ArrayOfTables(tables) => tables.iter().map(|table| of_table(table)).collect(),
    }
}

fn of_table(table: &dyn TableLike) -> Json {
    Json::Object(table.iter().map(|(key, item)| (key.to_string(), of_item(item))).collect::<Map<_, _>>())
}

fn of_value(value: &Value) -> Json {
    match value {
        Value::String(text) => text.value().as_str().into(),
        Value::Integer(number) => (*number.value()).into(),
        Value::Float(number) => serde_json::Number::from_f64(*number.value()).map_or(Json::Null, Json::Number),
        Value::Boolean(truth) => (*truth.value()).into(),
        Value::Datetime(date) => date.value().to_string().into(),
        Value::Array(list) => list.iter().map(of_value).collect(),
        Value::InlineTable(table) => of_table(table),
    }
}

/// A value to put into a text.
pub(crate) fn to_value(json: &Json) -> Result<Value> {
    Ok(match json {
        Json::Null => return Err(refused("`null` within a value")),
        Json::Bool(truth) => (*truth).into(),
        Json::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(whole), _) => whole.into(),
            (None, Some(real)) if real.is_finite() && !number.is_u64() => real.into(),
            _ => return Err(refused(&format!("{number}, which TOML cannot hold"))),
        },
        Json::String(text) => text.as_str().into(),
        Json::Array(list) => Value::Array(list.iter().map(to_value).collect::<Result<Array>>()?),
        Json::Object(map) => {
            let mut table = InlineTable::new();
            for (key, value) in map {
                table.insert(key, to_value(value)?);
            }
            Value::InlineTable(table)
        }
    })
}

fn refused(found: &str) -> Error {
    Error::parameter("value", found, "a text, a number, true or false, a list or a table of such")
}
