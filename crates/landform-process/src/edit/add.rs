//! Adds to the elevation.

use landform_core::terrain::{Layer, NodeSurface};
use landform_core::units::LengthDimension;
use landform_core::verb::{Context, Edit, Params, Reach, Source, Varying};
use landform_core::{Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Adds a height to the ground: a number, a picture, a raster, a formula or a field.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Add {
    /// Height that is added; may vary in space.
    pub elevation: Varying<LengthDimension>,
}

impl Params for Add {
    const NAME: &'static str = "add";
    const SOURCES: &'static [Source] = &[];

    fn reach(&self) -> Reach {
        self.elevation.reach()
    }
}

impl<T: NodeSurface> Edit<T> for Add {
    fn edit(&self, terrain: &mut T, context: &Context) -> Result<()> {
        let rise = self.elevation.resolve("elevation", terrain, context)?;
        terrain.change(Layer::Bedrock, |z| parallel::update(z, |i, z| *z += rise.at(i)));
        Ok(())
    }
}
