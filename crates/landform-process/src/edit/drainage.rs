//! Where water goes, as fields.

use landform_core::Result;
use landform_core::algo::flow::Flow;
use landform_core::field::names;
use landform_core::terrain::NodeSurface;
use landform_core::verb::{Context, Edit, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanism::write_drainage_fields;

/// Routes water over the ground as it is, through lakes over their lowest pass, and adds the fields
/// drainage_area, lake_depth, receiver and basin. The elevation does not change.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Drainage {}

impl Params for Drainage {
    const NAME: &'static str = "drainage";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Cordonnier, Bovy & Braun (2019)",
        title: "A versatile, linear complexity algorithm for flow routing in topographies with depressions, Earth Surface Dynamics 7",
        doi: "10.5194/esurf-7-549-2019",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(48)
    }

    fn leaves(&self) -> Vec<String> {
        let keys = [names::DRAINAGE_AREA.name, names::LAKE_DEPTH.name, names::RECEIVER.name, names::BASIN.name];
        keys.map(String::from).to_vec()
    }
}

impl<T: NodeSurface> Edit<T> for Drainage {
    fn edit(&self, terrain: &mut T, _: &Context) -> Result<()> {
        let domain = terrain.domain();
        write_drainage_fields(terrain, &domain, &mut Flow::new(), None)
    }
}
