//! Strokes that become part of a value of the text.

use landform::recipe::parameters;
use landform::{Error, Result};
use serde_json::{Value as Json, json};

use super::{Session, view_of};
use crate::text::{self, Key, Spot};

/// Longer strokes of one value are refused, bytes of text.
const MOST_BYTES: usize = 64 << 10;

/// A stroke as the text holds it. A bare radius is in metres; a bare strength in the parameter's
/// unit.
///
/// # Errors
/// [`Error::Parameter`] if there are no points.
pub(super) fn of(tool: Option<&str>, radius: &Json, strength: &Json, points: &[Vec<f64>]) -> Result<Json> {
    if points.is_empty() {
        return Err(Error::parameter("points", "none", "at least one point"));
    }
    // A decimetre, a hundredth of the pressure and of a second are more than a hand can do.
    let rounded = |(k, x): (usize, &f64)| {
        let steps = if k < 2 { 10.0 } else { 100.0 };
        (x * steps).round() / steps
    };
    let points: Vec<Vec<f64>> = points.iter().map(|point| point.iter().enumerate().map(rounded).collect()).collect();
    let radius = if radius.is_number() { json!(format!("{radius} m")) } else { radius.clone() };
    Ok(json!({ "tool": tool.unwrap_or("raise"), "radius": radius, "strength": strength, "points": points }))
}

/// The text with a stroke more in a value. What the value was is the strokes' base.
///
/// # Errors
/// If there is no such value, or its strokes become too long.
pub(super) fn add(session: &Session, spot: &Spot, mut stroke: Json) -> Result<String> {
    let text = session.history.now();
    let view = view_of(session);
    let step = &view["stages"][spot.stage.unwrap_or(0)];
    let part = spot.process.map_or(step, |process| &step["processes"][process]);
    let find = |from: &Json| {
        spot.key.iter().try_fold(from.clone(), |json, key| match key {
            Key::Name(name) => json.get(name).cloned(),
            Key::Place(place) => json.get(*place).cloned(),
        })
    };
    let named = match (spot.key.as_slice(), part["use"].as_str()) {
        ([Key::Name(key)], Some(stage)) => parameters(stage).into_iter().flatten().find(|p| p.name == *key),
        _ => None,
    };
    let Some(named) = named.filter(|named| named.varying) else {
        return Err(Error::parameter("key", format!("{:?}", spot.key), "a parameter that may vary in space"));
    };
    if stroke["strength"].is_number() {
        stroke["strength"] = match named.unit.as_str() {
            "" => stroke["strength"].clone(),
            unit => json!(format!("{} {unit}", stroke["strength"])),
        };
    }
    let given = find(&part["given"]).filter(|value| !value.is_null());
    let strokes = given.as_ref().and_then(|value| value["strokes"].as_array()).map(Vec::len);
    let before = strokes.and(given.as_ref()).map_or(0, |value| value.to_string().len());
    let bytes = before + stroke.to_string().len();
    if bytes > MOST_BYTES {
        let hint = Some("take some strokes back, or paint a picture and name it by `image`".into());
        let what = format!("the strokes of this value would be {bytes} bytes of text; at most {MOST_BYTES} fit");
        return Err(Error::Recipe { at: None, what, hint });
    }
    if let Some(strokes) = strokes {
        let key = [spot.key.clone(), vec![Key::Name("strokes".into()), Key::Place(strokes)]].concat();
        return text::set(text, &Spot { key, ..spot.clone() }, Some(&stroke));
    }
    let base = given.or_else(|| find(&part["values"])).filter(|value| !value.is_null());
    let mut value = json!({ "strokes": [stroke] });
    if let Some(base) = base {
        value["base"] = base;
    }
    text::set(text, spot, Some(&value))
}
