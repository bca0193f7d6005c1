//! What all GeoJSON files have in common.

use landform_core::{Error, Result, math};
use serde_json::{Value as Json, json};

/// Rounds to a thousandth of a node's distance or to the centimetre, whichever is finer; it keeps order, so that no river runs uphill.
#[derive(Clone, Copy)]
pub(super) struct Digits(f64);

impl Digits {
    pub(super) fn of(spacing: f64) -> Self {
        Self(math::pow(10.0, (-math::log10(spacing.max(1e-9))).ceil() + 3.0).max(100.0))
    }

    pub(super) fn round(self, v: f64) -> f64 {
        (v * self.0).round() / self.0
    }

    pub(super) fn all<const N: usize>(self, p: [f64; N]) -> [f64; N] {
        p.map(|v| self.round(v))
    }
}

pub(super) fn feature(geometry: &str, coordinates: Json, properties: Json) -> Json {
    json!({ "geometry": { "type": geometry, "coordinates": coordinates }, "properties": properties, "type": "Feature" })
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
