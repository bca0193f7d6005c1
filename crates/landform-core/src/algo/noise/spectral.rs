//! Surfaces made in the plane of wave numbers.
//!
//! # Method
//! Complex Gaussian coefficients on a half-plane with standard deviation |k|^−(H+1), their
//! conjugates on the other, inverse transform. Draws are keyed by wave number, so that a finer
//! raster adds waves and keeps those that were there. The surface is periodic.
//!
//! # Sources
//! Saupe (1988), SpectralSynthesisFM2D; exponent 2H + 2 in two dimensions (validation notes 1.5;
//! Pytel's thesis writes 2H + 1, that of a profile).

use crate::algo::fourier::{Coefficients, inverse, signed};
use crate::grid::Shape;
use crate::random::Seed;
use crate::{math, parallel};

/// A periodic surface of Hurst exponent `hurst`, row-major, of any size; mean 0, amplitude not
/// normalised.
///
/// `spacing` (m) makes waves alike along both axes where cells are not square. **Cost** O(n log n);
/// 24 bytes a node at its peak.
pub fn spectral_surface(shape: Shape, spacing: [f64; 2], hurst: f64, seed: Seed) -> Vec<f64> {
    let mut coefficients = Coefficients::zero(shape);
    let (rows, cols) = (shape.rows, shape.cols);
    // Wave vectors in waves over the longer side.
    let sides = [cols as f64 * spacing[0], rows as f64 * spacing[1]];
    let longer = sides[0].max(sides[1]);
    let step = sides.map(|s| longer / s);
    let draw = |kx: i64, ky: i64| {
        let key = ((kx + (1 << 24)) as u64) << 32 | (ky + (1 << 24)) as u64;
        let (re, im) = seed.normal_pair(key);
        let (fx, fy) = (kx as f64 * step[0], ky as f64 * step[1]);
        let amplitude = math::pow(fx * fx + fy * fy, -0.5 * (hurst + 1.0));
        [re * amplitude, im * amplitude]
    };
    parallel::for_rows_mut(&mut coefficients.values, rows, |kx, column| {
        if 2 * kx == cols {
            return;
        }
        for (j, value) in column.iter_mut().enumerate() {
            let ky = signed(j, rows);
            if (kx == 0 && ky == 0) || 2 * j == rows {
                continue;
            }
            // Where both halves are stored, the southern one is the conjugate of the northern one.
            let conjugate = kx == 0 && ky < 0;
            let [re, im] = if conjugate { draw(0, -ky) } else { draw(kx as i64, ky) };
            (value.re, value.im) = (re, if conjugate { -im } else { im });
        }
    });
    inverse(coefficients)
}

/// Shape of the periodic surface that [`self_affine`] cuts from: twice the longer side both ways,
/// so that it follows from the extent and not from the cells.
pub fn surroundings(shape: Shape, spacing: [f64; 2]) -> Shape {
    let sides = [(shape.cols - 1) as f64 * spacing[0], (shape.rows - 1) as f64 * spacing[1]];
    let longer = 2.0 * sides[0].max(sides[1]);
    let nodes = |k: usize, least: usize| ((longer / spacing[k]).round() as usize).max(least).max(1);
    Shape::new(nodes(1, shape.rows), nodes(0, shape.cols))
}

/// A self-affine surface on the north-western part of a periodic one of at least twice the size, so
/// that its sides do not match; mean 0 and standard deviation 1 over the part (all 0 for a single
/// node).
pub fn self_affine(shape: Shape, spacing: [f64; 2], hurst: f64, seed: Seed) -> Vec<f64> {
    let whole_shape = surroundings(shape, spacing);
    let whole = spectral_surface(whole_shape, spacing, hurst, seed);
    let part = parallel::map(shape.len(), |i| whole[i / shape.cols * whole_shape.cols + i % shape.cols]);
    drop(whole);
    standardized(part)
}

/// Mean 0, standard deviation 1.
pub(super) fn standardized(mut z: Vec<f64>) -> Vec<f64> {
    let mean = parallel::sum(z.len(), |i| z[i]) / z.len() as f64;
    let variance = parallel::sum(z.len(), |i| (z[i] - mean) * (z[i] - mean)) / z.len() as f64;
    let scale = if variance > 0.0 { 1.0 / variance.sqrt() } else { 0.0 };
    parallel::update(&mut z, |_, v| *v = scale * (*v - mean));
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_size_will_do_and_a_finer_raster_keeps_its_waves() {
        for (rows, cols) in [(1, 1), (1, 9), (30, 17), (45, 64)] {
            let z = spectral_surface(Shape::new(rows, cols), [2.0, 1.0], 0.7, Seed(1));
            assert!(z.iter().all(|v| v.is_finite()) && (z.iter().sum::<f64>() / z.len() as f64).abs() < 1e-12);
        }
        let coarse = spectral_surface(Shape::new(32, 32), [2.0, 2.0], 0.9, Seed(3));
        let fine = spectral_surface(Shape::new(64, 64), [1.0, 1.0], 0.9, Seed(3));
        let pairs = (0..1024).map(|i| (coarse[i], 4.0 * fine[(i / 32) * 128 + (i % 32) * 2]));
        let (slope, _, r2) = math::line_fit(pairs.collect::<Vec<_>>().into_iter());
        assert!(r2 > 0.98 && (slope - 1.0).abs() < 0.03, "{slope} {r2}");
    }

    #[test]
    fn the_land_does_not_depend_on_the_cells() {
        // 6000 m in cells of 20 m and of 12 m: shared nodes are 60 m apart.
        let coarse = self_affine(Shape::new(202, 301), [20.0, 20.0], 0.8, Seed(5));
        let fine = self_affine(Shape::new(336, 501), [12.0, 12.0], 0.8, Seed(5));
        let pairs: Vec<(f64, f64)> = (0..67 * 101)
            .map(|k| (coarse[k / 101 * 3 * 301 + k % 101 * 3], fine[k / 101 * 5 * 501 + k % 101 * 5]))
            .collect();
        let (slope, _, r2) = math::line_fit(pairs.into_iter());
        assert!(r2 > 0.995 && (slope - 1.0).abs() < 0.02, "{slope} {r2}");
    }
}
