//! Measures of a network of passages.

use landform_core::Result;
use landform_core::analysis::{NetworkStatistics, network_statistics};
use landform_core::feature::{ConduitNetwork, FeatureKind, Features};
use landform_core::terrain::{HeightField, Mesh, NodeSurface, VoxelGrid};
use landform_core::verb::{Landscape, Measure, Params, Source, check_path};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measures the network of conduits: lengths, tortuosity, orientation, cycles, degrees, shortest
/// ways, and whether they are as in natural karst.
///
/// ```
/// assert_eq!(landform_io::measure::MeasureNetwork::default().path, "network.json");
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MeasureNetwork {
    /// Path below the output folder.
    pub path: String,
}

impl Default for MeasureNetwork {
    fn default() -> Self {
        Self { path: "network.json".into() }
    }
}

impl Params for MeasureNetwork {
    const NAME: &'static str = "measure_network";
    const NEEDS: &'static [FeatureKind] = &[FeatureKind::Conduit];
    const SOURCES: &'static [Source] = &[Source {
        authors: "Collon, Bernasconi, Vuilleumier & Renard (2017)",
        title: "Statistical metrics for the characterization of karst network geometry and topology, Geomorphology 283",
        doi: "10.1016/j.geomorph.2017.01.034",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(0)
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["json"])
    }
}

fn measured(features: &Features) -> Result<NetworkStatistics> {
    features.need(FeatureKind::Conduit, &format!("`{}`", MeasureNetwork::NAME))?;
    let network = ConduitNetwork::of(features);
    Ok(network_statistics(&network.nodes, &network.edges()))
}

macro_rules! measure {
    ($($terrain:ty),*) => {$(
        impl Measure<$terrain> for MeasureNetwork {
            type Out = NetworkStatistics;

            fn path(&self) -> &str {
                &self.path
            }

            fn measure(&self, landscape: &Landscape<'_, $terrain>) -> Result<NetworkStatistics> {
                measured(landscape.terrain.features())
            }
        }
    )*};
}

measure!(HeightField, Mesh, VoxelGrid);
