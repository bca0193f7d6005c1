//! The procedure of Pytel's thesis for judging a spectrum, to the letter.
//!
//! # Method
//! 1. The log plot's points (r, z): r the logarithm of the length of each wave vector, z the
//!    logarithm of the density of Eq. 2.6 for heights scaled to 0..1 and Δs = 1 cell. One
//!    half-plane only (32,770 points of 256 × 256); without the 3 × 3 points in the middle and
//!    without densities below ε = 0.001.
//! 2. Least-squares line L through them.
//! 3. T, linear in r and in z, maps L to z = 1 − r: r runs from 0 to 1 over the points, L from 1
//!    to 0.
//! 4. Residuals of T(points) from z = 1 − r: their root mean square, and R².
//!
//! T removes the slope, so that the two numbers cannot distinguish H = 0.2 from H = 0.9: any cloud
//! around any falling line passes. R² of pure fractional Brownian ground is β² V/(β² V + π²/6) with
//! V = Var(ln r), since the logarithm of a periodogram's noise has variance π²/6: it measures noise
//! and steepness, not likeness. Therefore the slope is given beside it.
//!
//! # Sources
//! Pytel's thesis, 2.1.6. Its base line (33 surfaces, H from 0.5 to 0.98): RMS 0.199–0.223, R²
//! 0.331–0.526. The text leaves T's scale of r open; ours gives the same R² (T does not change it)
//! but not the same RMS. Validation notes 1.5 for the formula of R².

use serde::{Deserialize, Serialize};

use super::rings::for_each;
use super::{Density, Window};
use crate::grid::Shape;
use crate::math;

/// Results of the procedure.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ThesisFit {
    /// Root mean square of the residuals after T.
    pub rms: f64,
    /// Coefficient of determination.
    pub r2: f64,
    /// Exponent of the line before T removes it: β of single coefficients.
    pub exponent: f64,
    /// Points that were used.
    pub points: usize,
    /// Points that ε removed.
    pub removed: usize,
}

const EPSILON: f64 = 1e-3;

/// The procedure on a density; `z` (m) gives the range that heights are scaled by.
pub fn thesis_fit(density: &Density, z: &[f64], window: Window, shape: Shape) -> ThesisFit {
    let n = density.side;
    let heights = (0..n * n).map(|i| z[window.node(shape, i / n, i % n)]);
    let (lo, hi) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    // Back to |F|² of heights in 0..1.
    let scale = crate::math::powi(n as f64, 4) * density.step[0] * density.step[1] / ((hi - lo) * (hi - lo));
    let mut sums = [0.0; 6];
    let (mut removed, mut range) = (0, (f64::INFINITY, f64::NEG_INFINITY));
    for_each(density, |kx, ky, radius, _| {
        // One half-plane; the middle 3 × 3.
        let other_half = (kx == 0 || 2 * kx == n) && ky < 0 && 2 * ky != -(n as i64);
        if other_half || (kx <= 1 && ky.abs() <= 1) {
            return;
        }
        let s = density.at(kx as i64, ky) * scale;
        if s < EPSILON {
            removed += 1;
            return;
        }
        let (r, z) = (math::log(radius), math::log(s));
        range = (range.0.min(r), range.1.max(r));
        for (sum, v) in sums.iter_mut().zip([1.0, r, z, r * r, r * z, z * z]) {
            *sum += v;
        }
    });
    let [count, r, z, rr, rz, zz] = sums;
    let (mr, mz) = (r / count, z / count);
    let (vr, crz, vz) = (rr / count - mr * mr, rz / count - mr * mz, zz / count - mz * mz);
    let slope = crz / vr;
    let residual = (vz - crz * crz / vr).max(0.0).sqrt();
    ThesisFit {
        rms: residual / (slope.abs() * (range.1 - range.0)),
        r2: crz * crz / (vr * vz),
        exponent: -slope,
        points: count as usize,
        removed,
    }
}
