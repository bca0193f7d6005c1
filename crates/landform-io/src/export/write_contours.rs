//! Contours and coasts as a vector file.

use landform_core::analysis::{FeatureSearch, find_features};
use landform_core::feature::{Feature, FeatureKind, Geometry};
use landform_core::terrain::{HeightField, NodeSurface, Rasterize};
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Reach, Source, check_path};
use landform_core::{Error, Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::geojson::{collection, json_of};

/// Writes contours as GeoJSON lines in the landscape's own metres. Closed contours are rings with
/// high ground on their left. The contour of one level alone is a coast.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteContours {
    /// Path below the output folder.
    pub path: String,
    /// Elevations of the contours. If none are given, they lie at every interval.
    pub levels: Vec<Length>,
    /// Difference between levels. If not given, it is a round number that gives about fifteen
    /// levels.
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

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["geojson", "json"])
    }
}

/// More contours than this are refused.
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
    if !(rough > 0.0) {
        return 1.0;
    }
    let decade = math::pow(10.0, math::log10(rough).floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|k| k * decade).find(|s| *s >= rough * (1.0 - 1e-9)).unwrap_or(10.0 * decade)
}

impl<T: Rasterize> Export<T> for WriteContours {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let raster = landscape.terrain.rasterized()?;
        let search = FeatureSearch { levels: self.levels(&raster)?, ..FeatureSearch::of(FeatureKind::Contour) };
        let found = find_features(&*raster, &search)?;
        let is_long = |f: &&Feature| match &f.geometry {
            Geometry::FlatLine(line) => length(line) >= self.least_length.si(),
            _ => true,
        };
        let features = found.iter().filter(is_long).map(|f| json_of(f, &*raster)).collect();
        out.put(&self.path, collection(landscape.title, &*raster, features)?.as_bytes())
    }
}

fn length(line: &[[f64; 2]]) -> f64 {
    line.windows(2).map(|w| math::hypot(w[1][0] - w[0][0], w[1][1] - w[0][1])).sum()
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
