//! The Fourier transform of a raster of real numbers.
//!
//! # Method
//! Real transforms of the rows, a transpose in blocks, complex transforms of the columns. The
//! result stays transposed: one row per wave number along x, as filters and sums over rings need
//! it. Scalar arithmetic throughout, so that the bits do not depend on the machine.
//!
//! # Sources
//! Cooley & Tukey (1965); Definition 6 of Pytel's thesis (Eq. 2.4, 2.5): forward without a factor,
//! inverse with 1/N.
//!
//! # Example
//! Level ground has a mean and no waves:
//!
//! ```
//! use landform_core::algo::fourier::forward;
//! use landform_core::grid::Shape;
//!
//! let waves = forward(Shape::new(4, 4), vec![2.5; 16]);
//! assert!((waves.values[0].re - 16.0 * 2.5).abs() < 1e-9);
//! assert!(waves.values[1..].iter().all(|w| w.norm_sqr() < 1e-18));
//! ```

use realfft::RealFftPlanner;
pub use realfft::num_complex::Complex;
use rustfft::FftPlanner;

use crate::grid::Shape;
use crate::parallel;

/// Coefficients of a raster: `values[kx * rows + ky]` for kx from 0 to cols/2 and ky from 0 to rows
/// − 1 (see [`signed`]). The other half are their conjugates: F(−kx, −ky) = F(kx, ky)*.
#[derive(Clone, Debug)]
pub struct Coefficients {
    /// Shape of the raster.
    pub shape: Shape,
    /// Coefficients, one row per kx.
    pub values: Vec<Complex<f64>>,
}

impl Coefficients {
    /// All zero.
    pub fn zero(shape: Shape) -> Self {
        Self { shape, values: vec![Complex::default(); (shape.cols / 2 + 1) * shape.rows] }
    }

    /// Number of coefficients of the whole plane that a stored one represents: 2, or 1 where its
    /// conjugate is stored too.
    pub fn weight(&self, kx: usize) -> f64 {
        if kx == 0 || 2 * kx == self.shape.cols { 1.0 } else { 2.0 }
    }
}

/// The wave number of an index: −n/2 to n/2.
pub fn signed(index: usize, n: usize) -> i64 {
    let index = index as i64;
    if 2 * index >= n as i64 { index - n as i64 } else { index }
}

/// Σ f e^(−2πi(kx x/cols + ky y/rows)). **Cost** O(n log n); twice the raster's memory at its peak.
pub fn forward(shape: Shape, mut values: Vec<f64>) -> Coefficients {
    let (rows, cols, half) = (shape.rows, shape.cols, shape.cols / 2 + 1);
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(cols);
    let mut by_row = vec![Complex::default(); rows * half];
    parallel::for_rows_mut2(&mut values, cols, &mut by_row, half, |_, row, out| {
        // Lengths are those of the plan.
        let _ = plan.process(row, out);
    });
    drop(values);
    let mut by_col = transpose(&by_row, rows, half);
    drop(by_row);
    let plan = FftPlanner::new().plan_fft_forward(rows);
    parallel::for_rows_mut(&mut by_col, rows, |_, column| plan.process(column));
    Coefficients { shape, values: by_col }
}

/// Σ over rows of |F|² of each row alone, for kx from 0 to cols/2. **Cost** O(n log n).
pub fn row_power(shape: Shape, mut values: Vec<f64>) -> Vec<f64> {
    let half = shape.cols / 2 + 1;
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(shape.cols);
    let mut by_row = vec![Complex::default(); shape.rows * half];
    parallel::for_rows_mut2(&mut values, shape.cols, &mut by_row, half, |_, row, out| {
        let _ = plan.process(row, out);
    });
    parallel::map(half, |k| (0..shape.rows).map(|row| by_row[row * half + k].norm_sqr()).sum())
}

/// 1/(rows cols) Σ F e^(+2πi…): undoes [`forward`].
pub fn inverse(coefficients: Coefficients) -> Vec<f64> {
    let Coefficients { shape: Shape { rows, cols }, values: mut by_col } = coefficients;
    let half = cols / 2 + 1;
    let plan = FftPlanner::new().plan_fft_inverse(rows);
    parallel::for_rows_mut(&mut by_col, rows, |_, column| plan.process(column));
    let mut by_row = transpose(&by_col, half, rows);
    drop(by_col);
    let plan = RealFftPlanner::<f64>::new().plan_fft_inverse(cols);
    let mut values = vec![0.0; rows * cols];
    let scale = 1.0 / (rows * cols) as f64;
    parallel::for_rows_mut2(&mut by_row, half, &mut values, cols, |_, row, out| {
        // Imaginary parts are zero but for rounding.
        row[0].im = 0.0;
        if cols % 2 == 0 {
            row[half - 1].im = 0.0;
        }
        let _ = plan.process(row, out);
        out.iter_mut().for_each(|v| *v *= scale);
    });
    values
}

/// Rows to columns, in blocks that stay in the cache.
fn transpose(source: &[Complex<f64>], rows: usize, cols: usize) -> Vec<Complex<f64>> {
    const BLOCK: usize = 32;
    let mut target = vec![Complex::default(); rows * cols];
    parallel::for_rows_mut(&mut target, BLOCK * rows, |block, out| {
        let (first, wide) = (block * BLOCK, out.len() / rows);
        for r0 in (0..rows).step_by(BLOCK) {
            for r in r0..(r0 + BLOCK).min(rows) {
                for c in 0..wide {
                    out[c * rows + r] = source[r * cols + first + c];
                }
            }
        }
    });
    target
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;
    use crate::random::Seed;

    fn noise(shape: Shape) -> Vec<f64> {
        (0..shape.len()).map(|i| Seed(4).uniform(i as u64) - 0.5).collect()
    }

    #[test]
    fn a_transform_is_undone_and_keeps_power() {
        for (rows, cols) in [(8, 8), (5, 9), (1, 6), (7, 1), (64, 33), (33, 64), (1, 1)] {
            let shape = Shape::new(rows, cols);
            let f = noise(shape);
            let c = forward(shape, f.clone());
            // Parseval: Σ|F|² = N Σf².
            let power: f64 = (0..c.values.len()).map(|i| c.weight(i / rows) * c.values[i].norm_sqr()).sum();
            let sum: f64 = f.iter().map(|v| v * v).sum();
            assert!((power / (shape.len() as f64 * sum) - 1.0).abs() < 1e-12, "{shape}");
            let back = inverse(c);
            assert!(back.iter().zip(&f).all(|(a, b)| (a - b).abs() < 1e-14), "{shape}");
        }
    }

    #[test]
    fn a_wave_has_one_coefficient() {
        let shape = Shape::new(24, 30);
        let f = (0..shape.len()).map(|i| {
            let cell = shape.cell(i);
            math::cos(std::f64::consts::TAU * (3.0 * cell.col as f64 / 30.0 - 5.0 * cell.row as f64 / 24.0))
        });
        let c = forward(shape, f.collect());
        for (i, v) in c.values.iter().enumerate() {
            let here = (i / 24, signed(i % 24, 24)) == (3, -5);
            let expected = if here { 0.5 * shape.len() as f64 } else { 0.0 };
            assert!((v.norm() - expected).abs() < 1e-9, "{i} {v}");
        }
    }
}
