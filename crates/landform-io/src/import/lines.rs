//! Lines from GeoJSON.

use landform_core::analysis::project;
use landform_core::{Error, Result};
use serde_json::Value as Json;

/// A line, or the ring of a polygon.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its feature's `name`, or its number.
    pub name: String,
    /// Positions, m; the first is repeated at the end of a ring.
    pub points: Vec<[f64; 2]>,
}

/// The lines and rings of a GeoJSON file. Degrees are projected, equal-area, about the middle of each feature.
///
/// # Errors
/// [`Error::Format`] for anything but GeoJSON with at least one line of two points.
pub fn lines(bytes: &[u8]) -> Result<Vec<Line>> {
    let wrong = |what: &str| Error::format("GeoJSON", what);
    let json: Json = serde_json::from_slice(bytes).map_err(|e| Error::format("GeoJSON", e))?;
    let mut found = Vec::new();
    let features = match json["type"].as_str() {
        Some("FeatureCollection") => json["features"].as_array().ok_or_else(|| wrong("it has no list of features"))?,
        Some(_) => std::slice::from_ref(&json),
        None => return Err(wrong("it has no type")),
    };
    for (k, feature) in features.iter().enumerate() {
        let name = feature["properties"]["name"].as_str().map_or_else(|| format!("line {}", k + 1), String::from);
        let geometry = if feature["geometry"].is_object() { &feature["geometry"] } else { feature };
        let mut parts = Vec::new();
        collect(&geometry["coordinates"], &mut parts)?;
        found.extend(parts.into_iter().map(|points| Line { name: name.clone(), points }));
    }
    found.retain(|l| l.points.len() >= 2);
    if found.is_empty() {
        return Err(wrong("it holds no line and no polygon"));
    }
    let metres =
        json["crs"]["properties"]["name"].as_str().is_some_and(|n| !n.contains("CRS84") && !n.ends_with(":4326"));
    let in_range = |l: &Line| l.points.iter().all(|p| p[0].abs() <= 360.0 && p[1].abs() <= 90.0);
    if !metres && found.iter().all(in_range) {
        for line in &mut found {
            let bound = |k: usize| {
                let range = (f64::INFINITY, f64::NEG_INFINITY);
                line.points.iter().fold(range, |r, p| (r.0.min(p[k]), r.1.max(p[k])))
            };
            let centre = [bound(0), bound(1)].map(|(a, b)| 0.5 * (a + b));
            line.points = project(&line.points, centre);
        }
    }
    Ok(found)
}

/// Lists of positions, however deep.
fn collect(value: &Json, parts: &mut Vec<Vec<[f64; 2]>>) -> Result<()> {
    let Some(items) = value.as_array() else { return Ok(()) };
    let position = |p: &Json| Some([p.get(0)?.as_f64()?, p.get(1)?.as_f64()?]);
    if items.first().and_then(position).is_some() {
        let points: Option<Vec<_>> = items.iter().map(position).collect();
        parts.push(points.ok_or_else(|| Error::format("GeoJSON", "a position is not two numbers"))?);
        return Ok(());
    }
    items.iter().try_for_each(|i| collect(i, parts))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_rings_are_found_and_degrees_become_metres() {
        let text = br#"{"type":"FeatureCollection","features":[
            {"type":"Feature","properties":{"name":"a"},"geometry":{"type":"LineString","coordinates":[[10,50],[10,51]]}},
            {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}}]}"#;
        let found = lines(text).unwrap();
        assert_eq!((found[0].name.as_str(), found[1].name.as_str(), found.len()), ("a", "line 2", 2));
        let p = &found[0].points;
        assert!(((p[1][1] - p[0][1]) / 111_195.0 - 1.0).abs() < 1e-3);
        let metres = br#"{"type":"LineString","coordinates":[[5000,0],[6000,10]]}"#;
        assert_eq!(lines(metres).unwrap()[0].points[1], [6000.0, 10.0]);
    }

    #[test]
    fn what_is_no_line_is_refused() {
        for text in [
            "",
            "{}",
            "[1,2]",
            r#"{"type":"Point","coordinates":[1,2]}"#,
            r#"{"type":"LineString","coordinates":[[1,2],["x",3]]}"#,
        ] {
            assert!(lines(text.as_bytes()).is_err(), "{text}");
        }
    }
}
