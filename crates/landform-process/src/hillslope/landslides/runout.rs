//! Where debris comes to rest.
//!
//! Debris runs down the steepest way from the foot of its scar. Where the ground is less steep than
//! the runout angle it comes to rest, up to a tenth more than that slope; what does not fit looks
//! for its way anew from the node above. So a deposit grows backwards and to the sides, and becomes
//! a fan or a lobe of that slope, whatever the size of cells. At a base level debris leaves.
//!
//! HyLands lays down a part 1 − (S/S_c)² of the debris at every cell, each cell of a level floor
//! all of it: deposits are then as thick as cells allow.

use landform_core::grid::{Domain, Link, Status};

/// How much steeper than the runout angle a deposit becomes.
const BUILD_UP: f64 = 1.1;

/// What comes to rest, and how.
pub(super) struct Debris {
    /// Volume, m³.
    pub(super) volume: f64,
    /// Slope on which it comes to rest.
    pub(super) slope: f64,
    /// It comes to rest in this many parts at most, however small cells are.
    pub(super) parts: f64,
}

/// Lays debris down from `foot` on; returns what left the map, m³.
///
/// **Cost** O(way down + parts).
pub(super) fn run_out<D: Domain>(
    domain: &D,
    foot: usize,
    debris: &Debris,
    z: &mut [f64],
    way: &mut Vec<u32>,
    mut laid: impl FnMut(usize, f64),
) -> f64 {
    let status = domain.status();
    way.clear();
    way.push(foot as u32);
    let (mut left, slope) = (debris.volume, debris.slope);
    while left > 0.0 {
        // The foot always stays on the way.
        let Some(&at) = way.last() else { break };
        let at = at as usize;
        if status[at] == Status::BaseLevel {
            return left;
        }
        match steepest(domain, z, at) {
            Some(link) if (z[at] - z[link.to]) / link.distance >= slope => way.push(link.to as u32),
            _ => {
                let fits = |l: Link| z[l.to] + BUILD_UP * slope * l.distance - z[at];
                let fits = domain.neighbours(at).map(fits).fold(f64::INFINITY, f64::min);
                let area = domain.area(at);
                let (least, all) = (debris.volume / (debris.parts * area), left / area);
                let rise = fits.max(least).min(all);
                left = if rise < all { left - rise * area } else { 0.0 };
                z[at] += rise;
                laid(at, rise);
                if way.len() > 1 {
                    way.pop();
                }
            }
        }
    }
    0.0
}

/// The link down the steepest slope.
fn steepest<D: Domain>(domain: &D, z: &[f64], node: usize) -> Option<Link> {
    let mut best = (0.0, None);
    for link in domain.neighbours(node) {
        let slope = (z[node] - z[link.to]) / link.distance;
        if slope > best.0 {
            best = (slope, Some(link));
        }
    }
    best.1
}
