//! Drainage networks as numbers.
//!
//! Definitions are those of the reference measurements (docs/real_ground): every estimator was
//! first tested on objects of known exponents, and its bias is documented with it.

mod chi;
mod horton;
mod profiles;
mod scaling;
mod slope_area;

use serde::{Deserialize, Serialize};

pub use chi::{Chi, chi_profile};
pub use horton::{Horton, horton};
pub use profiles::{ProfileNode, ProfileSearch, RiverProfile, river_profiles};
pub use scaling::{NetworkScaling, NetworkSizes, network_scaling, scaling};
pub use slope_area::{SlopeArea, slope_area, slope_area_of};

use super::Drainage;
use crate::grid::{Domain, Status};

/// Measures of a network.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Network {
    /// Greatest drainage area, m².
    pub greatest_area: f64,
    /// Exponents of areas and lengths; none if there are too few nodes.
    pub scaling: NetworkScaling,
    /// Slope against drainage area.
    pub slope_area: SlopeArea,
    /// Elevation against χ in the largest basin.
    pub chi: Option<Chi>,
    /// Orders and Horton's ratios.
    pub horton: Horton,
    /// Length of channels that drain 1 km² or more over the area, 1/km; none where 1 km² is less
    /// than 20 nodes or the ground less than 10 km².
    pub drainage_density: Option<f64>,
}

/// Least drainage area of what is called a channel for slopes and χ, m²: 1 km², but at least 20
/// nodes; a hundredth of the greatest area if there would be less than a factor of 20 above.
pub fn channel_area(greatest: f64, node: f64) -> f64 {
    let usual = 1e6_f64.max(20.0 * node);
    if greatest < 20.0 * usual { (greatest / 100.0).max(20.0 * node) } else { usual }
}

/// The network of a routed terrain of elevations (m). **Cost** O(n log n).
pub fn network<D: Domain>(drainage: &Drainage<D>, z: &[f64]) -> Network {
    let area = &drainage.area;
    let status = drainage.domain.status();
    let valid: Vec<u32> = (0..area.len() as u32).filter(|&i| status[i as usize] != Status::Masked).collect();
    let ground: f64 = valid.iter().map(|&i| drainage.domain.area(i as usize)).sum();
    let node = ground / valid.len().max(1) as f64;
    drop(valid);
    let greatest_area = area.iter().copied().fold(0.0, f64::max);
    let least = channel_area(greatest_area, node);
    let carved = carved(drainage, z);
    Network {
        greatest_area,
        scaling: network_scaling(drainage),
        slope_area: slope_area_of(drainage, &carved, least, greatest_area / 2.0),
        chi: chi_profile(drainage, &carved, least),
        horton: horton(drainage, 100.0 * node),
        drainage_density: (node * 20.0 <= 1e6 && ground >= 1e7).then(|| channel_length(drainage, 1e6) / ground * 1e3),
    }
}

/// Elevation (m) with every depression cut through: the least elevation met upstream of or at each
/// node, so that nothing rises downstream.
pub fn carved<D: Domain>(drainage: &Drainage<D>, z: &[f64]) -> Vec<f64> {
    let mut carved = z.to_vec();
    for &i in drainage.flow.order() {
        let (i, r) = (i as usize, drainage.flow.receivers()[i as usize] as usize);
        if carved[i] < carved[r] {
            carved[r] = carved[i];
        }
    }
    carved
}

/// Length of the steps out of all nodes that drain at least a given area, m.
fn channel_length<D: Domain>(drainage: &Drainage<D>, least: f64) -> f64 {
    (0..drainage.area.len())
        .filter(|&i| drainage.area[i] >= least && drainage.flow.receivers()[i] as usize != i)
        .map(|i| drainage.domain.distance(i, drainage.flow.slots()[i]))
        .sum()
}
