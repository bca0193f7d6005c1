//! What all GeoJSON files have in common.

use landform_core::feature::{Feature, FeatureKind, Geometry, Property};
use landform_core::{Error, Result};
use serde_json::{Value as Json, json};

/// A feature as GeoJSON.
pub(super) fn json_of(feature: &Feature) -> Json {
    let (geometry, coordinates) = match &feature.geometry {
        Geometry::Point(p) => ("Point", json!(p)),
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

fn value(property: &Property) -> Json {
    match property {
        Property::Flag(v) => json!(v),
        Property::Whole(v) => json!(v),
        Property::Number(v) => json!(v),
        Property::Text(v) | Property::Id(v) => json!(v),
        Property::Place(v) => json!(v),
        _ => Json::Null,
    }
}

/// A collection as text, one feature a line: small differences stay small.
pub(super) fn collection(title: &str, epsg: Option<u16>, features: Vec<Json>) -> Result<String> {
    let mut collection = json!({ "type": "FeatureCollection", "name": title });
    if let Some(epsg) = epsg {
        let name = format!("urn:ogc:def:crs:EPSG::{epsg}");
        collection["crs"] = json!({ "type": "name", "properties": { "name": name } });
    }
    collection["features"] = features.into();
    let text = serde_json::to_string(&collection).map_err(|e| Error::format("GeoJSON", e))?;
    Ok(text.replace("{\"geometry\"", "\n{\"geometry\""))
}
