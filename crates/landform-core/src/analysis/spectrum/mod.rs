//! The spectrum: the relief at every wavelength.
//!
//! # Method
//! The largest square without nodata; its best plane removed; a periodic Hann window along both
//! axes (no mirror: a mirrored surface has a crease at the seam and half of the independent
//! coefficients); the squared transform, scaled so that its integral over all wave numbers is the
//! variance; means over rings of one wave number. The exponent is a straight line through log mean
//! power over log wave number.
//!
//! The slope is the test, never the goodness of the fit alone: see [`ThesisFit`].
//!
//! # Sources
//! Voss (1988); Saupe (1988): a surface of Hurst exponent H has radially averaged density k^−(2H+2)
//! and profiles of density k^−(2H+1). Pytel's thesis (Theorem 2.1.1, Eq. 2.6, 2.7) states 2H + 1,
//! which is that of a profile. Perron, Kirchner & Dietrich (2008) for windows, bins and peaks above
//! the background.
//!
//! # Checked by
//! `tests`: Parseval, a sine at its wavelength, H of synthetic surfaces within 0.05, turning by 90
//! degrees.

mod rings;
mod thesis_fit;
mod transects;
mod window;

use serde::{Deserialize, Serialize};

pub use rings::{LogBin, Ring};
pub use thesis_fit::{ThesisFit, thesis_fit};
pub use transects::{Transects, transects};
pub use window::{Window, largest_square};

use crate::algo::fourier::forward;
use crate::grid::{Grid, Shape};
use crate::math;

/// The least side of a window that is measured, nodes.
pub const LEAST_WINDOW: usize = 32;

/// A power law fitted to densities.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PowerLaw {
    /// Exponent β of density ~ k^−β.
    pub exponent: f64,
    /// R² of the straight line through the logarithms.
    pub r2: f64,
}

impl PowerLaw {
    fn of(points: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
        let (slope, _, r2) = math::line_fit(points);
        Self { exponent: -slope, r2 }
    }
}

/// The spectral density of a surface and what follows from it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spectrum {
    /// The part of the raster that was transformed.
    pub window: Window,
    /// Mean density of each ring, the longest wave first.
    pub rings: Vec<Ring>,
    /// Mean density in tenths of a decade of wave number.
    pub bins: Vec<LogBin>,
    /// β of the surface by rings 4 to N/4, each ring one point: 2H + 2 for fractional Brownian
    /// ground. High wave numbers weigh most.
    pub surface: PowerLaw,
    /// The same by bins of a tenth of a decade: each scale weighs the same.
    pub surface_by_bins: PowerLaw,
    /// The longer half of those bins.
    pub long_waves: PowerLaw,
    /// The shorter half of those bins: where sampling, smoothing and hillslopes show.
    pub short_waves: PowerLaw,
    /// β of single rows and columns: 2H + 1 for fractional Brownian ground.
    pub profiles: PowerLaw,
    /// (β − 2)/2 by rings.
    pub hurst: f64,
    /// Power along the axes over that along the diagonals, each ring weighing the same; 1 if the
    /// grid left no trace.
    pub axes_over_diagonals: f64,
    /// Wavelength that stands out most above the power law, m, and by what factor.
    pub peak: (f64, f64),
    /// The thesis' procedure.
    pub thesis_fit: ThesisFit,
}

/// Densities of a window, for pictures and sums.
#[derive(Clone, Debug)]
pub struct Density {
    /// Side of the window, nodes.
    pub side: usize,
    /// Wave numbers of a step along x and y, 1/m.
    pub step: [f64; 2],
    /// Density at (kx, ky), m² per (1/m)²: `values[kx * side + ky]`, kx from 0 to N/2.
    pub values: Vec<f64>,
}

impl Density {
    /// Density at any signed wave number.
    pub fn at(&self, kx: i64, ky: i64) -> f64 {
        let (kx, ky) = if kx < 0 { (-kx, -ky) } else { (kx, ky) };
        let ky = ky.rem_euclid(self.side as i64) as usize;
        self.values[kx as usize * self.side + ky]
    }

    /// The plane of wave numbers with its radius on a logarithmic scale, the longest waves in the
    /// middle, north up: `size`² means of log₁₀ density, row-major. A self-affine surface is an
    /// even cone (Pytel's thesis draws the same over logarithmic x and y). NaN beyond the shortest
    /// waves. **Cost** O(n).
    pub fn log_plot(&self, size: usize) -> Vec<f64> {
        let half = (size / 2) as f64;
        let most = 0.5 * self.side as f64;
        let stretch = half / math::log(1.0 + most);
        let to_cycles = |k: f64, axis: usize| k * self.step[axis] / self.unit();
        let mut sums = vec![(0.0, 0.0); size * size];
        rings::for_each(self, |kx, ky, radius, _| {
            let v = self.at(kx as i64, ky);
            if v > 0.0 && radius <= most {
                let out = stretch * math::log(1.0 + radius) / radius;
                let (x, y) = (to_cycles(kx as f64, 0) * out, to_cycles(ky as f64, 1) * out);
                for sign in [1.0, -1.0] {
                    // Rows of the raster run south, so ky does too.
                    let at = (half + sign * y).round() as usize * size + (half + sign * x).round() as usize;
                    if let Some(sum) = sums.get_mut(at) {
                        *sum = (sum.0 + math::log10(v), sum.1 + 1.0);
                    }
                }
            }
        });
        let nearest = |i: usize| {
            let (x, y) = ((i % size) as f64 - half, (i / size) as f64 - half);
            let rho = math::hypot(x, y);
            if rho > half {
                return f64::NAN;
            }
            let radius = math::exp(rho / stretch) - 1.0;
            let part = |v: f64, axis: usize| {
                let k = if rho > 0.0 { v / rho * radius * self.unit() / self.step[axis] } else { 0.0 };
                (k.round() as i64).clamp(-(self.side as i64) / 2, self.side as i64 / 2)
            };
            let (kx, ky) = (part(x, 0), part(y, 1));
            // The mean is no wave: its place takes the longest one.
            let v = if (kx, ky) == (0, 0) { self.at(1, 0) } else { self.at(kx, ky) };
            math::log10(v.max(f64::MIN_POSITIVE))
        };
        (0..size * size).map(|i| if sums[i].1 > 0.0 { sums[i].0 / sums[i].1 } else { nearest(i) }).collect()
    }

    /// Least ring number's unit: the larger of the two steps, 1/m.
    fn unit(&self) -> f64 {
        self.step[0].max(self.step[1])
    }

    /// Length of a wave vector in units of the ring, and whether it counts once or twice in the
    /// whole plane.
    fn radius(&self, kx: usize, ky: i64) -> f64 {
        math::hypot(kx as f64 * self.step[0], ky as f64 * self.step[1]) / self.unit()
    }
}

/// The density of a raster's largest square, with its best plane removed and tapered if `taper`
/// (else as it is, for periodic surfaces).
///
/// None if the square has fewer than [`LEAST_WINDOW`] nodes a side. **Cost** O(n log n).
pub fn density(grid: &Grid, z: &[f64], taper: bool) -> Option<(Window, Density)> {
    let window = largest_square(grid.shape, z).filter(|w| w.side >= LEAST_WINDOW)?;
    let (values, power_of_window) = window.cut(grid, z, taper);
    let n = window.side;
    let coefficients = forward(Shape::new(n, n), values);
    let step = [0, 1].map(|k| 1.0 / (n as f64 * grid.spacing[k]));
    // Σ P · step² = variance.
    let scale = 1.0 / (crate::math::powi(n as f64, 4) * power_of_window * step[0] * step[1]);
    let values = coefficients.values.iter().map(|c| c.norm_sqr() * scale).collect();
    Some((window, Density { side: n, step, values }))
}

/// The spectrum of a raster's largest square without nodata; none if it has fewer than
/// [`LEAST_WINDOW`] nodes a side. **Cost** O(n log n).
pub fn spectrum(grid: &Grid, z: &[f64]) -> Option<Spectrum> {
    let (window, density) = density(grid, z, true)?;
    Some(of_density(grid, z, window, &density))
}

/// As [`spectrum`], from a density (m² a cycle squared) that is there already.
pub fn of_density(grid: &Grid, z: &[f64], window: Window, density: &Density) -> Spectrum {
    let rings = rings::rings(density);
    let bins = rings::log_bins(density);
    let surface = rings::fit(&rings, density.side);
    let by_bins = rings::fitted(&bins, density.side);
    let of = |bins: &[LogBin]| PowerLaw::of(bins.iter().map(|b| (math::log10(b.ring), math::log10(b.density))));
    let half = by_bins.len() / 2;
    Spectrum {
        surface,
        surface_by_bins: of(by_bins),
        long_waves: of(&by_bins[..half]),
        short_waves: of(&by_bins[half..]),
        profiles: transects(grid, z, window).map_or(PowerLaw { exponent: f64::NAN, r2: f64::NAN }, |t| t.both),
        hurst: (surface.exponent - 2.0) / 2.0,
        axes_over_diagonals: rings::axes_over_diagonals(density, &rings),
        peak: rings::peak(&rings, density.side),
        thesis_fit: thesis_fit(density, z, window, grid.shape),
        window,
        rings,
        bins,
    }
}

#[cfg(test)]
mod tests;
