//! An irregular mesh for rivers: Poisson-disk nodes, Delaunay links, Voronoi areas.
//!
//! # Sources
//! Bell (thesis), chapter 3. We differ in the start: independent uniform jitter instead of the
//! absolute value of gradient noise, which is zero on its lattice and so makes a regular array of
//! pits (validation notes 3.3).

use landform_core::algo::sampling::{poisson_disk, spacing_for_count};
use landform_core::grid::{Edge, Edges, Side};
use landform_core::terrain::{Layer, Mesh, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Context, Estimate, Generator, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An almost flat irregular mesh for rivers. Unlike a raster it prefers no direction.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct StreamGraph {
    /// Extent east and north.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1e9))]
    pub size: [Length; 2],
    /// Number of nodes, to about 2 %. It is not used if `spacing` is given.
    #[schemars(extend("x-min" = 12, "x-max" = 20_000_000, "x-role" = "count"))]
    pub nodes: usize,
    /// Least distance between nodes, instead of `nodes`.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub spacing: Option<Length>,
    /// Elevation of the ground at the start, which is also the base level of open sides.
    pub elevation: Length,
    /// Height of the random jitter of inner nodes, which decides the courses of the first rivers.
    #[schemars(extend("x-min" = 0.0))]
    pub roughness: Length,
    /// Sides over which water leaves; the others are divides.
    pub open: Vec<Side>,
}

impl Default for StreamGraph {
    fn default() -> Self {
        Self {
            size: [Length::of(32_768.0); 2],
            nodes: 20_000,
            spacing: None,
            elevation: Length::of(0.0),
            roughness: Length::of(0.01),
            open: vec![Side::North, Side::East, Side::South, Side::West],
        }
    }
}

impl Params for StreamGraph {
    const NAME: &'static str = "stream_graph";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Bridson (2007)",
            title: "Fast Poisson disk sampling in arbitrary dimensions, SIGGRAPH sketches",
            doi: "10.1145/1278780.1278807",
        },
        Source {
            authors: "Braun & Sambridge (1997)",
            title: "Modelling landscape evolution on geological time scales: a new method based on irregular spatial discretization, Basin Research 9",
            doi: "10.1046/j.1365-2117.1997.00030.x",
        },
        Source {
            authors: "Bell (2024)",
            title: "Generating Terrain Models using the Stream Power Law, dissertation, University of Bath",
            doi: "",
        },
    ];

    fn check(&self) -> Result<()> {
        if self.open.is_empty() {
            return Err(Error::parameter("open", "[]", "at least one of \"north\", \"east\", \"south\", \"west\""));
        }
        Ok(())
    }
}

impl Generator<Mesh> for StreamGraph {
    fn generate(&self, context: &Context) -> Result<Mesh> {
        let size = self.size.map(Length::si);
        let spacing = self.spacing.map_or_else(|| spacing_for_count(size, self.nodes), Length::si);
        let sites = poisson_disk(size, spacing, context.seed.named("sites"))?;
        let edge = |side| if self.open.contains(&side) { Edge::Open } else { Edge::Closed };
        let edges = Edges {
            north: edge(Side::North),
            east: edge(Side::East),
            south: edge(Side::South),
            west: edge(Side::West),
        };
        let mut mesh = Mesh::delaunay(&sites, edges)?;
        let domain = mesh.domain();
        let status = landform_core::grid::Domain::status(&*domain);
        let jitter = context.seed.named("roughness");
        mesh.change(Layer::Bedrock, |z| {
            for (i, z) in z.iter_mut().enumerate() {
                let inner = status[i] == landform_core::grid::Status::Interior;
                *z = self.elevation.si() + if inner { self.roughness.si() * jitter.uniform(i as u64) } else { 0.0 };
            }
        });
        Ok(mesh)
    }

    fn estimate(&self, _: &Context) -> Result<Estimate> {
        let [w, h] = self.size.map(Length::si);
        let nodes = self.spacing.map_or(self.nodes as f64, |s| 0.7 * w * h / (s.si() * s.si()));
        // Measured: graph 150, triangulation 260 bytes a node at the peak.
        if !(nodes <= 2.2e7) {
            return Err(Error::parameter("spacing", format!("{nodes:.1e} nodes"), "at most 20 million nodes"));
        }
        Ok(Estimate {
            nodes: nodes as u64,
            bytes: nodes as u64 * 420,
            extent: [w, h],
            origin: Some([0.0; 2]),
            ..Estimate::default()
        })
    }
}
