//! Measures of a dune field.

use landform_core::Result;
use landform_core::analysis::{Dunes, dunes, shadow_error};
use landform_core::field::names;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::Angle;
use landform_core::verb::{Landscape, Measure, Params, Rose, Source, Wind, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measures dunes: height, spacing, direction of crests, bare ground, share of sand near repose, and the type of the dunes.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureDunes {
    /// Path below the output folder.
    pub path: String,
    /// Winds that made them. If none are given, they are the environment's, or else a west wind.
    pub wind: Vec<Wind>,
    /// Angle of repose of the sand.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub repose: Angle,
    /// Whether the map is periodic: opposite sides meet.
    pub periodic: bool,
}

impl Default for MeasureDunes {
    fn default() -> Self {
        Self { path: "dunes.json".into(), wind: Vec::new(), repose: Angle::of(33.0), periodic: true }
    }
}

impl Params for MeasureDunes {
    const NAME: &'static str = "measure_dunes";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Wasson & Hyde (1983)",
        title: "Factors determining desert dune type, Nature 304",
        doi: "10.1038/304337a0",
    }];

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        if !self.wind.is_empty() {
            Rose::new("wind", &self.wind)?;
        }
        check_path(&self.path, &[".json"])
    }
}

impl Measure<HeightField> for MeasureDunes {
    type Out = Dunes;

    fn path(&self) -> &str {
        &self.path
    }

    fn measure(&self, landscape: &Landscape<'_, HeightField>) -> Result<Dunes> {
        let terrain = landscape.terrain;
        let sand = &terrain.real("sand_depth", Self::NAME)?;
        let rose = landscape.environment.rose(&self.wind)?;
        let (grid, z) = (terrain.grid(), terrain.elevation());
        let mut found = dunes(grid, z, sand, &rose, self.repose.si(), self.periodic);
        if let (Ok(shelter), Some(spacing)) = (terrain.fields().get(&names::SHELTER, Self::NAME), found.spacing) {
            found.shadow = Some(shadow_error(grid, z, shelter, &rose, spacing, self.periodic));
        }
        Ok(found)
    }
}
