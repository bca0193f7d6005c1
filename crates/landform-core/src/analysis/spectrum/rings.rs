//! Means over rings of the plane of wave numbers.

use serde::{Deserialize, Serialize};

use super::{Density, PowerLaw};
use crate::algo::fourier::signed;
use crate::math;

/// All wave vectors of about one length.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ring {
    /// Wavelength, m.
    pub wavelength: f64,
    /// Mean density, m² per (1/m)².
    pub density: f64,
    /// Wave vectors in the whole plane.
    pub count: usize,
}

/// Wave vectors within a tenth of a decade of length.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LogBin {
    /// Waves per window: geometric mean of the bin's wave vectors.
    pub ring: f64,
    /// Wavelength, m.
    pub wavelength: f64,
    /// Mean density, m² per (1/m)².
    pub density: f64,
}

/// Calls `f(kx, ky, radius in rings, weight)` for every stored wave vector but the mean.
pub(super) fn for_each(density: &Density, mut f: impl FnMut(usize, i64, f64, f64)) {
    let n = density.side;
    for kx in 0..=n / 2 {
        let weight = if kx == 0 || 2 * kx == n { 1.0 } else { 2.0 };
        for j in 0..n {
            let ky = signed(j, n);
            if kx > 0 || ky != 0 {
                f(kx, ky, density.radius(kx, ky), weight);
            }
        }
    }
}

/// Rings 1 to N/2.
pub(super) fn rings(density: &Density) -> Vec<Ring> {
    let mut sums = vec![(0.0, 0usize); density.side / 2 + 1];
    for_each(density, |kx, ky, radius, weight| {
        if let Some(ring) = sums.get_mut(radius.round() as usize) {
            ring.0 += weight * density.at(kx as i64, ky);
            ring.1 += weight as usize;
        }
    });
    let unit = density.unit();
    let ring = |(k, &(sum, count)): (usize, &(f64, usize))| Ring {
        wavelength: 1.0 / (k as f64 * unit),
        density: sum / count as f64,
        count,
    };
    sums.iter().enumerate().skip(1).filter(|(_, s)| s.1 > 0).map(ring).collect()
}

/// The bins' edges are 4 waves per window times powers of 10^0.1; so many bins lie below.
const BINS_BELOW_FOUR: f64 = 7.0;

/// Bins of a tenth of a decade of wave number up to N/2, edges at ring 4 · 10^(k/10).
pub(super) fn log_bins(density: &Density) -> Vec<LogBin> {
    let mut sums: Vec<(f64, f64, f64)> = Vec::new();
    for_each(density, |kx, ky, radius, weight| {
        if radius > density.side as f64 / 2.0 {
            return;
        }
        let log = math::log10(radius);
        let bin = (10.0 * math::log10(radius / 4.0) + BINS_BELOW_FOUR + 1e-9).floor().max(0.0) as usize;
        if bin >= sums.len() {
            sums.resize(bin + 1, (0.0, 0.0, 0.0));
        }
        let s = &mut sums[bin];
        *s = (s.0 + weight * log, s.1 + weight * density.at(kx as i64, ky), s.2 + weight);
    });
    let unit = density.unit();
    sums.iter()
        .filter(|s| s.2 > 0.0)
        .map(|&(log, sum, count)| {
            let ring = math::pow(10.0, log / count);
            LogBin { ring, wavelength: 1.0 / (ring * unit), density: sum / count }
        })
        .collect()
}

/// The bins that lie wholly between rings 4 and N/4.
pub(super) fn fitted(bins: &[LogBin], side: usize) -> &[LogBin] {
    let first = bins.iter().position(|b| b.ring >= 4.0).unwrap_or(bins.len());
    let whole = (10.0 * math::log10(side as f64 / 16.0) + 1e-9).floor().max(0.0) as usize;
    &bins[first..(first + whole).min(bins.len())]
}

/// A straight line through rings 4 to N/4.
pub(super) fn fit(rings: &[Ring], side: usize) -> PowerLaw {
    PowerLaw::of(logs(rings, side).into_iter())
}

fn logs(rings: &[Ring], side: usize) -> Vec<(f64, f64)> {
    let far = (side / 4).min(rings.len());
    rings
        .iter()
        .take(far)
        .enumerate()
        .skip(3)
        .map(|(k, r)| (math::log10((k + 1) as f64), math::log10(r.density)))
        .filter(|p| p.1.is_finite())
        .collect()
}

/// The ring that stands highest above the power law: wavelength and factor.
pub(super) fn peak(rings: &[Ring], side: usize) -> (f64, f64) {
    let points = logs(rings, side);
    let (slope, at_one, _) = math::line_fit(points.iter().copied());
    let above = points.iter().enumerate().map(|(k, p)| (k + 3, p.1 - (at_one + slope * p.0)));
    let best = above.fold((0, f64::NEG_INFINITY), |a, b| if b.1 > a.1 { b } else { a });
    rings.get(best.0).map_or((f64::NAN, f64::NAN), |r| (r.wavelength, math::pow(10.0, best.1)))
}

/// Mean of power over its ring's mean within 11.25 degrees of the axes, over the same along the
/// diagonals; rings 4 to N/4.
pub(super) fn axes_over_diagonals(density: &Density, rings: &[Ring]) -> f64 {
    let (mut axes, mut diagonals) = ((0.0, 0.0), (0.0, 0.0));
    let eighth = std::f64::consts::FRAC_PI_8;
    for_each(density, |kx, ky, radius, weight| {
        let ring = radius.round() as usize;
        if ring < 4 || ring > density.side / 4 || rings[ring - 1].density <= 0.0 {
            return;
        }
        let turn = math::atan2(ky as f64 * density.step[1], kx as f64 * density.step[0]);
        // Angle to the nearest axis, in quarters of a right angle.
        let from_axis = (turn / (4.0 * eighth) - (turn / (4.0 * eighth)).round()).abs() * 4.0;
        let value = weight * density.at(kx as i64, ky) / rings[ring - 1].density;
        if from_axis <= 0.5 {
            axes = (axes.0 + value, axes.1 + weight);
        } else if from_axis >= 1.5 {
            diagonals = (diagonals.0 + value, diagonals.1 + weight);
        }
    });
    (axes.0 / axes.1) / (diagonals.0 / diagonals.1)
}
