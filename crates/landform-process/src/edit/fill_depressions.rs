//! Fills depressions to the level at which they spill.

use landform_core::Result;
use landform_core::algo::flow::Flow;
use landform_core::terrain::{Layer, NodeSurface};
use landform_core::verb::{Context, Edit, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Fills every depression to the level at which its water would spill. Filled ground is level.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct FillDepressions {}

impl Params for FillDepressions {
    const NAME: &'static str = "fill_depressions";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Barnes, Lehman & Mulla (2014)",
        title: "Priority-flood: an optimal depression-filling and watershed-labeling algorithm for digital elevation models, Computers & Geosciences 62",
        doi: "10.1016/j.cageo.2013.04.024",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(30)
    }
}

impl<T: NodeSurface> Edit<T> for FillDepressions {
    fn edit(&self, terrain: &mut T, _: &Context) -> Result<()> {
        let mut flow = Flow::new();
        let mut amount = vec![0.0; terrain.elevation().len()];
        flow.route(&*terrain.domain(), terrain.elevation(), &mut amount);
        let level = flow.water_level(terrain.elevation());
        terrain.change(Layer::Surface("sediment"), |z| z.copy_from_slice(&level));
        Ok(())
    }
}
