//! Lines from GeoJSON.

use landform_core::analysis::project;
use landform_core::{Error, Result, math};
use serde_json::Value as Json;

use super::degrees::EQUATORIAL_RADIUS;
use crate::format::{is_geographic, is_in_metres, is_web_mercator};

/// A line, or the ring of a polygon.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its feature's `name`, or its number.
    pub name: String,
    /// Positions, m; the first is repeated at the end of a ring.
    pub points: Vec<[f64; 2]>,
}

/// The lines and rings of a GeoJSON file. Degrees, of whichever datum, are projected, equal-area,
/// about the middle of each feature.
///
/// # Errors
/// [`Error::Format`] if the bytes are not GeoJSON with at least one line of two points.
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
    let name = json["crs"]["properties"]["name"].as_str().unwrap_or_default();
    if in_degrees(name, &mut found)? {
        for line in &mut found {
            unwrap_longitudes(&mut line.points);
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

/// Whether positions are longitude and latitude. Those of web maps become so.
fn in_degrees(system: &str, lines: &mut [Line]) -> Result<bool> {
    let epsg: Option<u16> =
        system.to_uppercase().split_once("EPSG").and_then(|(_, rest)| rest.rsplit(':').next()?.parse().ok());
    if epsg.is_some_and(is_web_mercator) {
        lines.iter_mut().flat_map(|l| &mut l.points).for_each(|p| *p = from_web_mercator(*p));
        return Ok(true);
    }
    if let Some(code) = epsg.filter(|e| !is_in_metres(*e)) {
        return Err(Error::Format {
            format: "GeoJSON",
            what: format!("its coordinates are not in metres: EPSG:{code} counts in feet or another unit"),
            hint: Some(
                "bring it to longitude and latitude first: ogr2ogr -t_srs EPSG:4326 out.geojson in.geojson".into(),
            ),
        });
    }
    let in_range = |l: &Line| l.points.iter().all(|p| p[0].abs() <= 540.0 && p[1].abs() <= 90.0);
    let fits = lines.iter().all(in_range);
    // Without a code the numbers decide: by the standard they are degrees, but many files are not.
    let geographic = epsg.map_or(fits, is_geographic);
    if geographic && !fits {
        let what = format!("its system, \"{system}\", is in degrees, but positions are beyond 90 degrees of latitude");
        return Err(Error::format("GeoJSON", what));
    }
    Ok(geographic)
}

fn from_web_mercator([x, y]: [f64; 2]) -> [f64; 2] {
    let latitude = 2.0 * math::atan(math::exp(y / EQUATORIAL_RADIUS)) - std::f64::consts::FRAC_PI_2;
    [(x / EQUATORIAL_RADIUS).to_degrees(), latitude.to_degrees()]
}

/// Takes out the jumps where a line crosses the meridian of 180 degrees.
fn unwrap_longitudes(points: &mut [[f64; 2]]) {
    let mut turns = 0.0;
    for k in 1..points.len() {
        let step = points[k][0] + turns - points[k - 1][0];
        turns -= 360.0 * (step / 360.0).round();
        points[k][0] += turns;
    }
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

    fn length(system: &str, coordinates: &str) -> f64 {
        let text = format!(
            r#"{{"type":"FeatureCollection","crs":{{"type":"name","properties":{{"name":"{system}"}}}},"features":[
            {{"type":"Feature","properties":{{}},"geometry":{{"type":"LineString","coordinates":{coordinates}}}}}]}}"#
        );
        let points = &lines(text.as_bytes()).unwrap()[0].points;
        points.windows(2).map(|p| math::hypot(p[1][0] - p[0][0], p[1][1] - p[0][1])).sum()
    }

    #[test]
    fn degrees_of_every_datum_are_degrees() {
        let line = "[[10,45],[10.1,45]]";
        let expected = length("urn:ogc:def:crs:OGC:1.3:CRS84", line);
        assert!((expected - 7_863.0).abs() < 30.0, "{expected}");
        for datum in ["EPSG::4326", "EPSG::4269", "EPSG::4258", "EPSG::4283", "EPSG::7844", "EPSG::6318"] {
            assert_eq!(length(&format!("urn:ogc:def:crs:{datum}"), line), expected, "{datum}");
        }
        assert_eq!(length("EPSG:4269", line), expected);
        assert_eq!(length("urn:ogc:def:crs:OGC::CRS83", line), expected);
        assert!((length("EPSG:32632", line) - 0.1).abs() < 1e-9);
        let web = "[[1113194.907932736,5621521.486192066],[1124326.857012063,5621521.486192066]]";
        assert!((length("EPSG:3857", web) / expected - 1.0).abs() < 1e-6);
        let feet = br#"{"type":"LineString","crs":{"properties":{"name":"EPSG:2263"}},"coordinates":[[1,2],[3,4]]}"#;
        assert!(lines(feet).unwrap_err().to_string().contains("EPSG:2263"));
    }

    #[test]
    fn lines_go_on_over_the_meridian_of_180_degrees() {
        let expected = length("EPSG:4326", "[[179,10],[180,10.5],[181,10],[179,10]]");
        for jump in ["[[179,10],[180,10.5],[-179,10],[179,10]]", "[[-181,10],[-180,10.5],[181,10],[179,10]]"] {
            assert!((length("EPSG:4326", jump) / expected - 1.0).abs() < 1e-9, "{jump}");
        }
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
