//! The coast.

use landform_core::Result;
use landform_core::analysis::{Coast, coast};
use landform_core::terrain::{NodeSurface, Rasterize};
use landform_core::units::Length;
use landform_core::verb::{Landscape, Measure, Params, Source, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measures the coast at a level: its length, its islands, and its fractal dimension by divider and
/// boxes. Where the divider's steps span less than a decade its dimension is null, and `why` says
/// so.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureCoast {
    /// Path below the output folder.
    pub path: String,
    /// Level of the sea. If not given, it is the environment's, or else 0 m.
    pub level: Option<Length>,
}

impl Default for MeasureCoast {
    fn default() -> Self {
        Self { path: "coast.json".into(), level: None }
    }
}

impl Params for MeasureCoast {
    const NAME: &'static str = "measure_coast";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Mandelbrot (1967)",
        title: "How long is the coast of Britain? Statistical self-similarity and fractional dimension, Science 156",
        doi: "10.1126/science.156.3775.636",
    }];

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["json"])
    }
}

/// The coast's numbers.
pub type CoastMeasured = Coast;

impl<T: Rasterize> Measure<T> for MeasureCoast {
    type Out = CoastMeasured;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, landscape: &Landscape<'_, T>) -> Result<Coast> {
        let terrain = landscape.terrain;
        let raster = terrain.rasterized()?;
        let level = landscape.environment.sea(self.level).unwrap_or(0.0);
        Ok(coast(raster.grid(), raster.elevation(), level).0)
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::HeightField;
    use landform_core::verb::Environment;

    use super::*;

    #[test]
    fn the_sea_is_the_environments_unless_a_level_is_given() {
        let slope = (0..400).map(|i| f64::from(i % 20)).collect();
        let field = HeightField::new(Grid::new(Shape::new(20, 20), [10.0, 10.0]).unwrap(), slope).unwrap();
        let environment: Environment = serde_json::from_str(r#"{ "sea_level": "14.5 m" }"#).unwrap();
        let mut landscape = Landscape::plain(&field);
        landscape.environment = &environment;
        let land = |level: Option<f64>| {
            let measure = MeasureCoast { level: level.map(Length::of), ..MeasureCoast::default() };
            measure.measure(&landscape).unwrap().land_share
        };
        assert!((land(None) - 0.25).abs() < 0.03 && (land(Some(9.5)) - 0.5).abs() < 0.03);
    }
}
