//! Slope against drainage area: the signature of rivers.
//!
//! # Sources
//! Flint (1974): S = k_s A^(−θ); θ is the concavity, m/n at the steady state of the stream-power law.

use serde::{Deserialize, Serialize};

use crate::algo::flow::{Flow, node_areas};
use crate::grid::Domain;
use crate::math;
use crate::terrain::NodeSurface;

/// Means in bins of drainage area, and the power law through them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SlopeArea {
    /// Per bin: mean of log₁₀ area (m²), mean of log₁₀ slope, nodes.
    pub bins: Vec<(f64, f64, usize)>,
    /// Concavity θ.
    pub concavity: f64,
    /// R² of the power law through the bins.
    pub r2: f64,
}

/// Slope–area relation over nodes with a lower receiver and at least `least_area` m² of drainage, in eighths of a decade.
pub fn slope_area<T: NodeSurface>(terrain: &T, least_area: f64) -> SlopeArea {
    const PER_DECADE: f64 = 8.0;
    let (domain, z) = (terrain.domain(), terrain.elevation());
    let mut area = node_areas(&*domain);
    let mut flow = Flow::new();
    flow.route(&*domain, z, &mut area);
    let mut bins: std::collections::BTreeMap<i64, (f64, f64, usize)> = std::collections::BTreeMap::new();
    for i in 0..z.len() {
        let r = flow.receivers()[i] as usize;
        if r == i || area[i] < least_area || z[i] <= z[r] {
            continue;
        }
        let la = math::log10(area[i]);
        let ls = math::log10((z[i] - z[r]) / domain.distance(i, flow.slots()[i]));
        let bin = bins.entry((la * PER_DECADE).floor() as i64).or_default();
        *bin = (bin.0 + la, bin.1 + ls, bin.2 + 1);
    }
    let bins: Vec<_> = bins.into_values().map(|(a, s, n)| (a / n as f64, s / n as f64, n)).collect();
    let (slope, _, r2) = math::line_fit(bins.iter().filter(|b| b.2 >= 3).map(|b| (b.0, b.1)));
    SlopeArea { bins, concavity: -slope, r2 }
}
