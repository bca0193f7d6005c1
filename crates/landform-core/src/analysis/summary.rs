//! A summary of a terrain in a few numbers.

use serde::{Deserialize, Serialize};

use crate::algo::flow::{Flow, node_areas};
use crate::grid::{Domain, Status};
use crate::parallel;
use crate::terrain::NodeSurface;

/// Elevations and slopes of a terrain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Valid nodes.
    pub nodes: usize,
    /// Nodes without data.
    pub nodata: usize,
    /// Area of the valid nodes, m².
    pub area: f64,
    /// Lowest elevation, m.
    pub min: f64,
    /// Highest elevation, m.
    pub max: f64,
    /// Mean elevation, weighted by area, m.
    pub mean: f64,
    /// Median of the slope to the receiver over nodes that have one, rise over run.
    pub median_slope: f64,
    /// Greatest slope to a receiver, rise over run.
    pub max_slope: f64,
    /// Local minima that are no outlets.
    pub lakes: usize,
}

/// Summary of a terrain. **Cost** O(n log n).
pub fn summary<T: NodeSurface>(terrain: &T) -> Summary {
    let (domain, z) = (terrain.domain(), terrain.elevation());
    let valid = |i: usize| domain.status()[i] != Status::Masked;
    let nodes = (0..z.len()).filter(|&i| valid(i)).count();
    let mut weights = node_areas(&*domain);
    let area = parallel::sum(z.len(), |i| weights[i]);
    let mean = parallel::sum(z.len(), |i| if valid(i) { z[i] * weights[i] } else { 0.0 }) / area;
    let mut flow = Flow::new();
    flow.route(&*domain, z, &mut weights);
    let mut slopes: Vec<f64> = (0..z.len())
        .filter(|&i| flow.receivers()[i] as usize != i)
        .map(|i| (z[i] - z[flow.receivers()[i] as usize]) / domain.distance(i, flow.slots()[i]))
        .collect();
    slopes.sort_unstable_by(f64::total_cmp);
    Summary {
        nodes,
        nodata: z.len() - nodes,
        area,
        min: -parallel::max(z.len(), |i| -z[i]),
        max: parallel::max(z.len(), |i| z[i]),
        mean,
        median_slope: slopes.get(slopes.len() / 2).copied().unwrap_or(0.0),
        max_slope: slopes.last().copied().unwrap_or(0.0),
        lakes: flow.lakes(),
    }
}
