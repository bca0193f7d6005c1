//! Parts that all GeoJSON files share.

use landform_core::feature::{Feature, FeatureKind, Geometry, Property};
use landform_core::grid::Degrees;
use landform_core::terrain::NodeSurface;
use landform_core::{Error, Result};
use serde_json::{Value as Json, json};

const WGS_84: u16 = 4326;

/// A feature as GeoJSON, in the coordinates of the place that it lies on.
pub(super) fn json_of(feature: &Feature, place: &impl NodeSurface) -> Json {
    let mut json = in_metres(feature);
    // Metres that were made from degrees are written as degrees; lists of numbers are no places.
    if let Some(degrees) = place.degrees() {
        to_degrees(&mut json["geometry"]["coordinates"], &degrees);
        for (name, property) in &feature.properties {
            if let Property::Place(_) = property {
                to_degrees(&mut json["properties"][name], &degrees);
            }
        }
    }
    json
}

fn in_metres(feature: &Feature) -> Json {
    let (geometry, coordinates) = match &feature.geometry {
        Geometry::Point(p) => ("Point", json!(p)),
        Geometry::Points(points) => ("MultiPoint", json!(points)),
        Geometry::Line(line) => ("LineString", json!(line)),
        Geometry::FlatLine(line) => ("LineString", json!(line)),
        Geometry::Area(parts) if parts.len() == 1 && feature.kind == FeatureKind::Lake => ("Polygon", json!(parts[0])),
        Geometry::Area(parts) => ("MultiPolygon", json!(parts)),
        Geometry::Network { nodes, edges } => {
            let line = |[a, b]: [u32; 2]| json!([nodes[a as usize], nodes[b as usize]]);
            ("MultiLineString", edges.iter().map(|e| line(*e)).collect())
        }
        _ => ("GeometryCollection", json!([])),
    };
    let mut properties = serde_json::Map::new();
    properties.insert("kind".into(), feature.kind.word().into());
    properties.insert("id".into(), feature.id.clone().into());
    for (name, property) in &feature.properties {
        properties.insert(name.clone(), value(property));
    }
    json!({ "geometry": { "type": geometry, "coordinates": coordinates }, "properties": properties, "type": "Feature" })
}

/// A property as JSON.
pub(super) fn value(property: &Property) -> Json {
    match property {
        Property::Flag(v) => json!(v),
        Property::Whole(v) => json!(v),
        Property::Number(v) => json!(v),
        Property::Text(v) | Property::Id(v) => json!(v),
        Property::Place(v) => json!(v),
        Property::Numbers(v) => json!(v),
        _ => Json::Null,
    }
}

/// A collection as text, one feature a line: small differences stay small.
pub(super) fn collection(title: &str, place: &impl NodeSurface, features: Vec<Json>) -> Result<String> {
    let mut collection = json!({ "type": "FeatureCollection", "name": title });
    let mut epsg = place.epsg();
    if let Some(degrees) = place.degrees() {
        // Without a name they are of WGS 84 by the standard.
        epsg = degrees.epsg.filter(|e| *e != WGS_84);
    }
    if let Some(epsg) = epsg {
        let name = format!("urn:ogc:def:crs:EPSG::{epsg}");
        collection["crs"] = json!({ "type": "name", "properties": { "name": name } });
    }
    collection["features"] = features.into();
    let text = serde_json::to_string(&collection).map_err(|e| Error::format("GeoJSON", e))?;
    Ok(text.replace("{\"geometry\"", "\n{\"geometry\""))
}

/// Positions, however deep, as longitude and latitude.
fn to_degrees(value: &mut Json, degrees: &Degrees) {
    let Some(items) = value.as_array_mut() else { return };
    if let [Json::Number(x), Json::Number(y), ..] = items.as_slice() {
        let place = degrees.of([x, y].map(|v| v.as_f64().unwrap_or_default()));
        items.iter_mut().zip(place).for_each(|(item, v)| *item = json!(v));
        return;
    }
    items.iter_mut().for_each(|item| to_degrees(item, degrees));
}
