//! Elementary functions that give the same bits on every platform.
//!
//! The standard library's `sin`, `exp`, `powf` call the platform's mathematics; these call the
//! `libm` crate. `sqrt` is exact everywhere and needs no replacement. `clippy.toml` catches calls
//! of the platform's functions by mistake.
//!
//! ```
//! use landform_core::math;
//!
//! let points = [(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)];
//! let (slope, intercept, r2) = math::line_fit(points.into_iter());
//! assert_eq!((slope, intercept, r2), (2.0, 1.0, 1.0));
//! assert_eq!(math::lerp(10.0, 30.0, 0.25), 15.0);
//! ```

pub use libm::{acos, asin, atan, atan2, atanh, cbrt, ceil, cos, exp, floor, hypot, log, log2, log10, sin, tan, tanh};

/// `x` to the power `p`, by the exact path for the exponents that landscapes use most (0, ½, 1, 2).
#[inline]
pub fn pow(x: f64, p: f64) -> f64 {
    if p == 0.5 {
        x.sqrt()
    } else if p == 1.0 {
        x
    } else if p == 2.0 {
        x * x
    } else if p == 0.0 {
        1.0
    } else {
        libm::pow(x, p)
    }
}

/// `x` to a whole power, by multiplication: the same bits on every platform.
#[inline]
pub fn powi(x: f64, n: u32) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

/// Linear interpolation: `a` at 0, `b` at 1.
#[inline]
pub fn lerp(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

/// Bits in the order of the numbers, those of a pure number: a key for heaps.
///
/// ```
/// use landform_core::math::ordered_bits;
///
/// assert!(ordered_bits(-2.0) < ordered_bits(-1.0) && ordered_bits(-1.0) < ordered_bits(3.0));
/// ```
#[inline]
pub fn ordered_bits(x: f64) -> u64 {
    let bits = x.to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}

/// Smooth step from 0 at `edge0` to 1 at `edge1`; a hard step where both are equal.
#[inline]
pub fn smoothstep(edge0: f64, edge1: f64, x: f64) -> f64 {
    if edge0 == edge1 {
        return if x < edge0 { 0.0 } else { 1.0 };
    }
    let t = ((x - edge0) / (edge1 - edge0)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Distance between two places, in their unit.
///
/// ```
/// assert_eq!(landform_core::math::distance([0.0, 0.0, 1.0], [3.0, 4.0, 1.0]), 5.0);
/// ```
#[inline]
pub fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt()
}

/// Least-squares line through points: (slope, intercept, R²). NaN with fewer than two different
/// abscissae.
pub fn line_fit(points: impl Iterator<Item = (f64, f64)> + Clone) -> (f64, f64, f64) {
    let (mut n, mut sx, mut sy) = (0.0, 0.0, 0.0);
    for (x, y) in points.clone() {
        n += 1.0;
        sx += x;
        sy += y;
    }
    let (mx, my) = (sx / n, sy / n);
    let (mut sxx, mut sxy, mut syy) = (0.0, 0.0, 0.0);
    for (x, y) in points {
        sxx += (x - mx) * (x - mx);
        sxy += (x - mx) * (y - my);
        syy += (y - my) * (y - my);
    }
    let slope = sxy / sxx;
    (slope, my - slope * mx, sxy * sxy / (sxx * syy))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pow_takes_the_exact_paths() {
        assert_eq!(pow(2.0, 0.5), 2.0_f64.sqrt());
        assert_eq!(pow(3.0, 2.0), 9.0);
        assert_eq!(pow(-3.0, 0.0), 1.0);
        assert!((pow(10.0, 0.45) - 2.8183829312644537).abs() < 1e-14);
    }

    #[test]
    fn line_fit_finds_a_line() {
        let points = (0..10).map(|i| (i as f64, 3.0 * i as f64 - 1.0));
        let (slope, intercept, r2) = line_fit(points);
        assert!((slope - 3.0).abs() < 1e-12 && (intercept + 1.0).abs() < 1e-12 && (r2 - 1.0).abs() < 1e-12);
    }
}
