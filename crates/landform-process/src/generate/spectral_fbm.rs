//! Fractional Brownian ground by spectral synthesis.
//!
//! # Method
//! A half-plane of complex Gaussian coefficients with standard deviation |k|^−(H+1), inverse FFT. Draws are keyed by wave
//! number, so a finer cell adds waves and keeps those that were there. The transform is computed on a square of twice the
//! longer side and cropped, because synthesis is periodic.
//!
//! # Sources
//! Saupe (1988), algorithm SpectralSynthesisFM2D. In two dimensions amplitude k^−(H+1) gives a radially averaged power
//! spectrum of slope −(2H+2); Pytel's thesis states the one-dimensional −(2H+1) (validation notes 1.5).

use landform_core::random::Seed;
use landform_core::terrain::HeightField;
use landform_core::units::Length;
use landform_core::verb::{Context, Estimate, Generator, Params, Source};
use landform_core::{Error, Result, math, parallel};
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::raster;

/// Fractional Brownian ground: rough at every scale, without rivers.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SpectralFbm {
    /// Extent east and north.
    #[schemars(extend("x-above" = 0.0))]
    pub size: [Length; 2],
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0))]
    pub cell_size: Length,
    /// Mean elevation.
    pub elevation: Length,
    /// Standard deviation of the elevation.
    #[schemars(extend("x-min" = 0.0))]
    pub deviation: Length,
    /// Hurst exponent: 1 is smooth, 0 is rough; the spectrum falls as k^-(2H+2).
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub hurst: f64,
}

impl Default for SpectralFbm {
    fn default() -> Self {
        Self {
            size: [Length::of(10_240.0); 2],
            cell_size: Length::of(10.0),
            elevation: Length::of(0.0),
            deviation: Length::of(200.0),
            hurst: 0.8,
        }
    }
}

impl Params for SpectralFbm {
    const NAME: &'static str = "spectral_fbm";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Saupe (1988)",
        title: "Algorithms for random fractals, in: The Science of Fractal Images, Springer",
        doi: "10.1007/978-1-4612-3784-6_2",
    }];
}

/// Side of the largest transform: 64 GiB of coefficients.
const MOST_TRANSFORM: usize = 1 << 16;

impl SpectralFbm {
    /// Side of the square transform: a power of two, at least twice the longer side.
    fn transform_size(&self) -> Result<usize> {
        let shape = raster(self.size, self.cell_size)?.shape;
        let n = (2 * shape.rows.max(shape.cols)).next_power_of_two();
        if n > MOST_TRANSFORM {
            let expected = format!("at most {} cells along a side", MOST_TRANSFORM / 2);
            return Err(Error::parameter("cell_size", self.cell_size, &expected));
        }
        Ok(n)
    }
}

impl Generator<HeightField> for SpectralFbm {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let grid = raster(self.size, self.cell_size)?;
        let n = self.transform_size()?;
        let surface = synthesize(n, self.hurst, context.seed);
        let shape = grid.shape;
        let mut z: Vec<f64> = parallel::map(grid.len(), |i| surface[shape.cell(i).row * n + shape.cell(i).col]);
        let mean = parallel::sum(z.len(), |i| z[i]) / z.len() as f64;
        let variance = parallel::sum(z.len(), |i| (z[i] - mean) * (z[i] - mean)) / z.len() as f64;
        let scale = if variance > 0.0 { self.deviation.si() / variance.sqrt() } else { 0.0 };
        parallel::update(&mut z, |_, v| *v = self.elevation.si() + scale * (*v - mean));
        HeightField::new(grid, z)
    }

    fn estimate(&self, _: &Context) -> Result<Estimate> {
        let nodes = raster(self.size, self.cell_size)?.len() as u64;
        let n = self.transform_size()? as u64;
        Ok(Estimate { nodes, bytes: n * n * 32 + nodes * 16, extent: self.size.map(Length::si) })
    }
}

/// A periodic n × n surface of unnormalised amplitude, row-major.
fn synthesize(n: usize, hurst: f64, seed: Seed) -> Vec<f64> {
    let half = (n / 2) as i64;
    let mut spectrum = vec![Complex::new(0.0, 0.0); n * n];
    parallel::for_rows_mut(&mut spectrum, n, |row, values| {
        let ky = signed(row, n);
        for (col, value) in values.iter_mut().enumerate() {
            let kx = signed(col, n);
            if (kx == 0 && ky == 0) || kx == -half || ky == -half {
                continue;
            }
            // The real part of the transform of these is what the Hermitian half would give, with twice the variance.
            let key = ((kx + (1 << 24)) as u64) << 32 | (ky + (1 << 24)) as u64;
            let (re, im) = seed.normal_pair(key);
            let amplitude = math::pow((kx * kx + ky * ky) as f64, -0.5 * (hurst + 1.0));
            *value = Complex::new(re * amplitude, im * amplitude);
        }
    });
    inverse_transform(&mut spectrum, n);
    parallel::map(n * n, |i| spectrum[i].re)
}

fn signed(index: usize, n: usize) -> i64 {
    let index = index as i64;
    if index >= (n / 2) as i64 { index - n as i64 } else { index }
}

/// Rows, transpose, rows. The result is transposed, which a stationary random field does not mind.
fn inverse_transform(values: &mut Vec<Complex<f64>>, n: usize) {
    let fft = FftPlanner::new().plan_fft_inverse(n);
    parallel::for_rows_mut(values, n, |_, row| fft.process(row));
    let source = std::mem::take(values);
    *values = parallel::map(n * n, |i| source[i % n * n + i / n]);
    parallel::for_rows_mut(values, n, |_, row| fft.process(row));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Slope of the radially averaged periodogram of a periodic surface.
    fn spectral_slope(surface: &[f64], n: usize) -> f64 {
        let mut values: Vec<Complex<f64>> = surface.iter().map(|&z| Complex::new(z, 0.0)).collect();
        inverse_transform(&mut values, n);
        let mut rings = vec![(0.0, 0usize); n / 2];
        for (i, v) in values.iter().enumerate() {
            let (kx, ky) = (signed(i % n, n) as f64, signed(i / n, n) as f64);
            let ring = math::hypot(kx, ky).round() as usize;
            if ring > 0 && ring < n / 2 {
                rings[ring].0 += v.norm_sqr();
                rings[ring].1 += 1;
            }
        }
        let points = (4..n / 4).map(|k| (math::log(k as f64), math::log(rings[k].0 / rings[k].1 as f64)));
        math::line_fit(points.collect::<Vec<_>>().into_iter()).0
    }

    #[test]
    fn the_spectrum_falls_as_it_should() {
        for hurst in [0.5, 0.8] {
            let slopes: Vec<f64> = (1..4).map(|s| spectral_slope(&synthesize(256, hurst, Seed(s)), 256)).collect();
            let mean = slopes.iter().sum::<f64>() / 3.0;
            assert!((mean + 2.0 * hurst + 2.0).abs() < 0.05, "H = {hurst}: {mean}");
        }
    }

    #[test]
    fn deviation_and_mean_are_those_asked_for() {
        use landform_core::terrain::NodeSurface;
        use landform_core::verb::NoMaps;
        let params = SpectralFbm {
            size: [Length::of(900.0), Length::of(500.0)],
            elevation: Length::of(40.0),
            ..SpectralFbm::default()
        };
        let field = params.generate(&Context { seed: Seed(2), maps: &NoMaps }).unwrap();
        let z = field.elevation();
        let mean = z.iter().sum::<f64>() / z.len() as f64;
        let variance = z.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / z.len() as f64;
        assert!((mean - 40.0).abs() < 1e-9 && (variance.sqrt() - 200.0).abs() < 1e-9);
    }
}
