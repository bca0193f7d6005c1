//! Rivers, lakes, basins and passages as a vector file.

use landform_core::analysis::{FeatureSearch, Width, find_features};
use landform_core::feature::FeatureKind;
use landform_core::terrain::Rasterize;
use landform_core::units::{Area, Length, Rate};
use landform_core::verb::{Export, FeatureWord, Landscape, Output, Params, Source, file_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::geojson::{collection, json_of};

/// Writes rivers, lakes and basins with their properties as GeoJSON, in the landscape's own metres.
/// Rivers are lines that only run downhill (x, y and the water's elevation); lakes and basins are
/// polygons. Conduits are lines in space with the distances to their walls.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteFeatures {
    /// Path below the output folder.
    pub path: String,
    /// Kinds of features that are written. Features that the landscape already has are written as
    /// they are; others are found first.
    pub features: Vec<FeatureWord>,
    /// Key of earlier recipes: false leaves rivers out.
    pub rivers: Option<bool>,
    /// Key of earlier recipes: false leaves lakes out.
    pub lakes: Option<bool>,
    /// Key of earlier recipes: false leaves basins out.
    pub basins: Option<bool>,
    /// Least drainage area of a river and of a basin. If not given, it is a two-thousandth of the
    /// map.
    #[schemars(extend("x-above" = 0.0))]
    pub least_area: Option<Area>,
    /// Least depth of a lake, where it is deepest.
    #[schemars(extend("x-min" = 0.0))]
    pub least_depth: Length,
    /// Sea level, at which rivers end. If not given, it is the environment's; without one, rivers
    /// end at the landscape's own outlets.
    pub sea_level: Option<Length>,
    /// Rainfall from which discharge follows, where the landscape has no field of discharge; all of
    /// it runs off. If not given, it is the environment's, or else 1 m/yr.
    #[schemars(extend("x-min" = 0.0))]
    pub rainfall: Option<Rate>,
    /// Width of a river that carries 1 m3/s, m, where the depth of the water is not known.
    #[schemars(extend("x-above" = 0.0))]
    pub width_coefficient: f64,
    /// Power of the discharge with which width grows.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub width_exponent: f64,
}

impl Default for WriteFeatures {
    fn default() -> Self {
        let width = Width::default();
        Self {
            path: "features.geojson".into(),
            features: vec![FeatureWord::Rivers, FeatureWord::Lakes, FeatureWord::Basins],
            rivers: None,
            lakes: None,
            basins: None,
            least_area: None,
            least_depth: Length::of(1.0),
            sea_level: None,
            rainfall: None,
            width_coefficient: width.coefficient,
            width_exponent: width.exponent,
        }
    }
}

impl Params for WriteFeatures {
    const NAME: &'static str = "write_features";
    const OBSOLETE: &'static [(&'static str, &'static str)] =
        &[("rivers", "features"), ("lakes", "features"), ("basins", "features")];
    const SOURCES: &'static [Source] = FeatureSearch::SOURCES;

    fn bytes_a_node(&self) -> Option<u64> {
        Some(75)
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path)?;
        let known = [".geojson", ".json"].iter().any(|e| self.path.to_lowercase().ends_with(e));
        if known { Ok(()) } else { Err(Error::extension("path", &self.path, &["geojson"])) }
    }
}

impl WriteFeatures {
    /// The kinds that are written.
    fn kinds(&self) -> Vec<FeatureKind> {
        let words =
            [(FeatureWord::Rivers, self.rivers), (FeatureWord::Lakes, self.lakes), (FeatureWord::Basins, self.basins)];
        let is_out = |word: &FeatureWord| words.iter().any(|w| w.0 == *word && w.1 == Some(false));
        self.features.iter().filter(|w| !is_out(w)).map(|w| w.kind()).collect()
    }
}

impl<T: Rasterize> Export<T> for WriteFeatures {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let (terrain, kinds) = (landscape.terrain, self.kinds());
        let known = terrain.features();
        let missing = kinds.iter().copied().filter(|kind| known.of(*kind).next().is_none()).collect::<Vec<_>>();
        missing
            .iter()
            .filter(|kind| !kind.left_by().is_empty())
            .try_for_each(|kind| known.need(*kind, &format!("`{}`", Self::NAME)).map(drop))?;
        let found = find_features(
            terrain,
            &FeatureSearch {
                kinds: missing,
                least_area: self.least_area.map(Area::si),
                least_depth: self.least_depth.si(),
                sea_level: landscape.environment.sea(self.sea_level),
                rainfall: self
                    .rainfall
                    .or(landscape.environment.uniform_rain())
                    .map_or(FeatureSearch::DEFAULT_RAIN, Rate::si),
                width: Width { coefficient: self.width_coefficient, exponent: self.width_exponent },
                levels: Vec::new(),
            },
        )?;
        let of = |kind: &FeatureKind| {
            known.of(*kind).chain(found.of(*kind)).map(|f| json_of(f, terrain)).collect::<Vec<_>>()
        };
        let features = kinds.iter().flat_map(of).collect();
        out.put(&self.path, collection(landscape.title, terrain, features)?.as_bytes())
    }
}
