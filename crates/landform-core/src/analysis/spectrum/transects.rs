//! Spectra of single rows and columns, and the spacing that stands out in them.
//!
//! # Sources
//! Perron, Dietrich & Kirchner (2008): valleys that are evenly spaced show as a peak of a
//! transect's spectrum across them.

use serde::{Deserialize, Serialize};

use super::{PowerLaw, Window};
use crate::grid::{Grid, Shape};
use crate::{math, parallel};

/// Mean spectra of profiles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Transects {
    /// (wavelength in m, density in m² per 1/m) of the mean profile eastwards, the longest wave
    /// first.
    pub rows: Vec<(f64, f64)>,
    /// The same northwards.
    pub columns: Vec<(f64, f64)>,
    /// β of rows and columns together, waves 4 to N/4: 2H + 1 for fractional Brownian ground.
    pub both: PowerLaw,
    /// Spacing of valleys that rows cross, m: the wavelength with the most variance per octave.
    pub spacing_eastwards: f64,
    /// Spacing of valleys that columns cross, m.
    pub spacing_northwards: f64,
}

/// Mean spectra (wavenumber in 1/m, density in m³) of the rows and of the columns of a window, each
/// profile without its straight line and tapered. **Cost** O(n log n).
pub fn transects(grid: &Grid, z: &[f64], window: Window) -> Option<Transects> {
    let n = window.side;
    if n < super::LEAST_WINDOW {
        return None;
    }
    let along = |spacing: f64, node: &(dyn Fn(usize, usize) -> usize + Sync)| -> Vec<(f64, f64)> {
        let hann: Vec<f64> =
            (0..n).map(|k| 0.5 - 0.5 * math::cos(std::f64::consts::TAU * k as f64 / n as f64)).collect();
        let weight: f64 = hann.iter().map(|h| h * h).sum();
        let mut values = vec![0.0; n * n];
        parallel::for_rows_mut(&mut values, n, |line, out| {
            let profile = (0..n).map(|k| (k as f64, z[node(line, k)]));
            let (slope, at_zero, _) = math::line_fit(profile.clone());
            for (k, v) in profile {
                out[k as usize] = (v - at_zero - slope * k) * hann[k as usize];
            }
        });
        // Rows alone: a transform over one axis.
        let power = crate::algo::fourier::row_power(Shape::new(n, n), values);
        (1..=n / 2).map(|k| (n as f64 * spacing / k as f64, power[k] / (n as f64 * weight) * 2.0 * spacing)).collect()
    };
    let rows = along(grid.spacing[0], &|line, k| window.node(grid.shape, line, k));
    let columns = along(grid.spacing[1], &|line, k| window.node(grid.shape, k, line));
    let logs = |list: &[(f64, f64)]| -> Vec<(f64, f64)> {
        list.iter().take(n / 4).skip(3).map(|p| (-math::log10(p.0), math::log10(p.1))).collect()
    };
    let both = PowerLaw::of(logs(&rows).into_iter().chain(logs(&columns)).filter(|p| p.1.is_finite()));
    let spacing = |list: &[(f64, f64)]| {
        // Variance per octave is density over wavelength; the two longest waves are the window's.
        let best = list.iter().skip(2).fold((f64::NAN, f64::NEG_INFINITY), |a, p| {
            let v = p.1 / p.0;
            if v > a.1 { (p.0, v) } else { a }
        });
        best.0
    };
    Some(Transects { both, spacing_eastwards: spacing(&rows), spacing_northwards: spacing(&columns), rows, columns })
}
