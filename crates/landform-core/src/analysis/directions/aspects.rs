//! Which ways slopes face.

use super::is_near_45;
use crate::algo::derivative::gradient;
use crate::grid::Grid;
use crate::{math, parallel};

/// Degrees of the mean that the histogram is compared with.
const AROUND: usize = 45;
/// Fewer slopes have no histogram.
const LEAST: usize = 1_000;

/// Which ways slopes face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aspects {
    /// 99th percentile of the histogram in degrees over its mean within 45 degrees.
    pub(super) peak: f64,
    /// Share within 2 degrees of a multiple of 45, over 4/45.
    pub(super) near_45: f64,
    /// Mean cosine of eight times the aspect.
    pub(super) r8: f64,
}

/// The aspects of some nodes; none of too few.
pub(super) fn aspects(grid: &Grid, z: &[f64], nodes: &[usize]) -> Option<Aspects> {
    if nodes.len() < LEAST {
        return None;
    }
    let degrees = parallel::map(nodes.len(), |k| gradient(grid, z, nodes[k]).aspect().to_degrees());
    let n = degrees.len() as f64;
    let near = parallel::sum(degrees.len(), |k| f64::from(u8::from(is_near_45(degrees[k])))) / n;
    let r8 = parallel::sum(degrees.len(), |k| math::cos((8.0 * degrees[k]).to_radians())) / n;
    Some(Aspects { peak: peak(&degrees), near_45: near / (4.0 / 45.0), r8 })
}

fn peak(degrees: &[f64]) -> f64 {
    let mut bins = [0.0; 360];
    degrees.iter().for_each(|&d| bins[d.rem_euclid(360.0) as usize % 360] += 1.0);
    let mean = |k: usize| (0..AROUND).map(|j| bins[(k + 360 + j - AROUND / 2) % 360]).sum::<f64>() / AROUND as f64;
    let mut ratios: Vec<f64> = (0..360).map(|k| bins[k] / mean(k).max(1e-9)).collect();
    ratios.sort_unstable_by(f64::total_cmp);
    let at = 0.99 * 359.0_f64;
    math::lerp(ratios[at as usize], ratios[at as usize + 1], at.fract())
}
