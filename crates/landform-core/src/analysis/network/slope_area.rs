//! Slope against drainage area: the signature of rivers.
//!
//! # Method
//! Nodes in bins of a tenth of a decade of drainage area. The slope of a bin is the sum of its
//! drops over the sum of its steps, on elevations in which depressions are cut through, so that no
//! step rises.
//!
//! # Sources
//! Flint (1974): S = k_s A^(−θ); θ is the concavity, m/n at the steady state of the stream-power
//! law.

use serde::{Deserialize, Serialize};

use super::carved;
use crate::analysis::Drainage;
use crate::grid::Domain;
use crate::math;
use crate::terrain::NodeSurface;

/// Means in bins of drainage area, and the power law through them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SlopeArea {
    /// Per bin: mean of log₁₀ area (m²), log₁₀ of the slope, nodes.
    pub bins: Vec<(f64, f64, usize)>,
    /// Concavity θ.
    pub concavity: f64,
    /// R² of the power law through the bins.
    pub r2: f64,
}

/// Slope–area relation over nodes with a receiver and at least `least_area` m² of drainage.
pub fn slope_area<T: NodeSurface>(terrain: &T, least_area: f64) -> SlopeArea {
    let drainage = Drainage::with_open_holes(terrain);
    let carved = carved(&drainage, terrain.elevation());
    slope_area_of(&drainage, &carved, least_area, f64::INFINITY)
}

/// As [`slope_area`], of a routed terrain with its `carved` elevations and between two
/// areas. **Cost** O(n).
pub fn slope_area_of<D: Domain>(drainage: &Drainage<D>, carved: &[f64], least: f64, most: f64) -> SlopeArea {
    const PER_DECADE: f64 = 10.0;
    const LEAST_NODES: usize = 10;
    let area = &drainage.area;
    // Sums of log area, of drops and of steps.
    let mut bins: std::collections::BTreeMap<i64, (f64, f64, f64, usize)> = std::collections::BTreeMap::new();
    let first = math::log10(least);
    for i in 0..area.len() {
        let r = drainage.flow.receivers()[i] as usize;
        if r == i || area[i] < least || area[i] > most {
            continue;
        }
        let la = math::log10(area[i]);
        let bin = bins.entry(((la - first) * PER_DECADE + 1e-9).floor() as i64).or_default();
        let step = drainage.domain.distance(i, drainage.flow.slots()[i]);
        *bin = (bin.0 + la, bin.1 + carved[i] - carved[r], bin.2 + step, bin.3 + 1);
    }
    let bins: Vec<_> = bins
        .into_values()
        .filter(|b| b.1 > 0.0)
        .map(|(a, drop, step, n)| (a / n as f64, math::log10(drop / step), n))
        .collect();
    let enough = bins.iter().filter(|b| b.2 >= LEAST_NODES).map(|b| (b.0, b.1));
    let (slope, _, r2) = math::line_fit(enough);
    SlopeArea { bins, concavity: -slope, r2 }
}
