//! From a mesh to a raster.

use landform_core::Result;
use landform_core::terrain::{HeightField, Mesh, height_field_from_mesh};
use landform_core::units::Length;
use landform_core::verb::{Convert, Estimate, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Turns a mesh into a raster, linear on every triangle; fields come along.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToHeightField {
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0))]
    pub cell_size: Length,
}

impl Default for ToHeightField {
    fn default() -> Self {
        Self { cell_size: Length::of(50.0) }
    }
}

impl Params for ToHeightField {
    const NAME: &'static str = "to_height_field";
    const SOURCES: &'static [Source] = &[];
}

impl Convert<Mesh, HeightField> for ToHeightField {
    fn convert(&self, source: &Mesh) -> Result<HeightField> {
        height_field_from_mesh(source, self.cell_size.si())
    }

    fn estimate(&self, source: Estimate) -> Estimate {
        let nodes = source.raster_nodes(self.cell_size.si());
        Estimate { nodes, bytes: source.nodes * 250 + nodes * 60, ..source }
    }
}
