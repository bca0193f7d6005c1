//! Rivers, lakes and other features, found and kept.

use landform_core::analysis::{FeatureSearch, Width, find_features};
use landform_core::terrain::Rasterize;
use landform_core::units::{Area, Length, Rate};
use landform_core::verb::{Context, Edit, FeatureWord, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Finds rivers, lakes, basins, coasts and contours and keeps them with the landscape: later stages
/// may use them, as in { feature = "rivers", buffer = "50 m" }. A feature that is found again keeps
/// its id.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct FindFeatures {
    /// Kinds of features that are found.
    pub features: Vec<FeatureWord>,
    /// Least drainage area of a river and of a basin. If not given, it is a two-thousandth of the
    /// map.
    #[schemars(extend("x-above" = 0.0))]
    pub least_area: Option<Area>,
    /// Least depth of a lake, where it is deepest.
    #[schemars(extend("x-min" = 0.0))]
    pub least_depth: Length,
    /// Sea level, at which rivers end and coasts lie. If not given, it is the environment's.
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
    /// Elevations of contours.
    pub levels: Vec<Length>,
}

impl Default for FindFeatures {
    fn default() -> Self {
        let width = Width::default();
        Self {
            features: vec![FeatureWord::Rivers, FeatureWord::Lakes, FeatureWord::Basins],
            least_area: None,
            least_depth: Length::of(1.0),
            sea_level: None,
            rainfall: None,
            width_coefficient: width.coefficient,
            width_exponent: width.exponent,
            levels: Vec::new(),
        }
    }
}

impl Params for FindFeatures {
    const NAME: &'static str = "find_features";
    const SOURCES: &'static [Source] = FeatureSearch::SOURCES;

    fn check(&self) -> Result<()> {
        if self.features.is_empty() {
            return Err(Error::parameter("features", "[]", "at least one kind, for example [\"rivers\"]"));
        }
        if self.features.contains(&FeatureWord::Contours) && self.levels.is_empty() {
            return Err(Error::parameter("levels", "[]", "at least one elevation for contours"));
        }
        match self.features.iter().find(|word| !word.kind().left_by().is_empty()) {
            Some(word) => {
                let given = format!("\"{}s\"", word.kind().word());
                let expected = format!("kinds that lie on the surface; {}", word.kind().remedy());
                Err(Error::parameter("features", given, &expected))
            }
            None => Ok(()),
        }
    }
}

impl<T: Rasterize> Edit<T> for FindFeatures {
    fn edit(&self, terrain: &mut T, context: &Context) -> Result<()> {
        let rainfall =
            self.rainfall.or(context.environment.uniform_rain()).map_or(FeatureSearch::DEFAULT_RAIN, Rate::si);
        let found = find_features(
            terrain,
            &FeatureSearch {
                kinds: self.features.iter().map(|w| w.kind()).collect(),
                least_area: self.least_area.map(Area::si),
                least_depth: self.least_depth.si(),
                sea_level: context.environment.sea(self.sea_level),
                rainfall,
                width: Width { coefficient: self.width_coefficient, exponent: self.width_exponent },
                levels: self.levels.iter().map(|l| l.si()).collect(),
            },
        )?;
        terrain.features_mut().update(found);
        Ok(())
    }
}
