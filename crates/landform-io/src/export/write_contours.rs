//! Contours and coasts as a vector file.

use landform_core::algo::isoline::{Isoline, isolines};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value as Json, json};

use super::Drawable;
use super::geojson::{Digits, collection, feature};
use crate::measure::check_path;

/// Writes contours as lines (closed ones as rings, high ground on their left), in the landscape's own metres: GeoJSON. One level alone
/// is a coast.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteContours {
    /// Path below the output folder.
    pub path: String,
    /// These levels; else levels at every interval.
    pub levels: Vec<Length>,
    /// Difference between levels; a round number that gives about fifteen if not given.
    #[schemars(extend("x-above" = 0.0))]
    pub interval: Option<Length>,
    /// Lines shorter than this are left out.
    #[schemars(extend("x-min" = 0.0))]
    pub least_length: Length,
}

impl Default for WriteContours {
    fn default() -> Self {
        Self { path: "contours.geojson".into(), levels: Vec::new(), interval: None, least_length: Length::of(0.0) }
    }
}

impl Params for WriteContours {
    const NAME: &'static str = "write_contours";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        check_path(&self.path, &[".geojson", ".json"])
    }
}

/// More contours than this are a mistake.
const MOST_LEVELS: f64 = 5_000.0;

impl WriteContours {
    fn levels(&self, raster: &HeightField) -> Result<Vec<f64>> {
        if !self.levels.is_empty() {
            return Ok(self.levels.iter().map(|l| l.si()).collect());
        }
        let finite = raster.elevation().iter().filter(|z| z.is_finite());
        let (lo, hi) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &z| (a.min(z), b.max(z)));
        let step = self.interval.map_or_else(|| round_interval((hi - lo) / 15.0), Length::si);
        if (hi - lo) / step > MOST_LEVELS {
            let value = format!("{step} m for a relief of {:.0} m", hi - lo);
            return Err(Error::parameter("interval", value, &format!("at most {MOST_LEVELS} contours")));
        }
        let first = (lo / step).ceil() as i64;
        Ok((first..).map(|k| k as f64 * step).take_while(|l| *l < hi).collect())
    }
}

/// 1, 2 or 5 times a power of ten, the next one above.
fn round_interval(rough: f64) -> f64 {
    use landform_core::math;
    if !(rough > 0.0) {
        return 1.0;
    }
    let decade = math::pow(10.0, math::log10(rough).floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|k| k * decade).find(|s| *s >= rough * (1.0 - 1e-9)).unwrap_or(10.0 * decade)
}

impl<T: Drawable> Export<T> for WriteContours {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let raster = landscape.terrain.raster()?;
        let digits = Digits::of(raster.grid.spacing[0].min(raster.grid.spacing[1]));
        let mut features = Vec::new();
        for level in self.levels(&raster)? {
            let lines = isolines(&raster.grid, raster.elevation(), level);
            let long = lines.iter().filter(|l| l.length() >= self.least_length.si());
            features.extend(long.map(|l| contour(l, level, digits)));
        }
        out.put(&self.path, collection(landscape.title, raster.epsg(), features)?.as_bytes())
    }
}

fn contour(line: &Isoline, level: f64, digits: Digits) -> Json {
    let points: Vec<_> = line.points.iter().map(|p| digits.all(*p)).collect();
    let properties = json!({
        "kind": "contour",
        "level_m": level,
        "closed": line.closed,
        "length_m": digits.round(line.length()),
        "area_m2": digits.round(line.area()),
    });
    feature("LineString", json!(points), properties)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_are_round() {
        let found: Vec<f64> = [0.0, 0.013, 1.0, 66.0, 666.0].into_iter().map(round_interval).collect();
        assert_eq!(found, [1.0, 0.02, 1.0, 100.0, 1000.0]);
    }
}
