//! How much ground lies how high.
//!
//! # Sources
//! Strahler (1952): the hypsometric integral; (mean − min)/(max − min) is the exact integral of the curve (Pike & Wilson
//! 1971).

use serde::{Deserialize, Serialize};

/// The hypsometric curve.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hypsometry {
    /// (mean − min)/(max − min); NaN for flat ground.
    pub integral: f64,
    /// Relative elevation (0 to 1) above which each of 0, 1/100, …, 1 of the area lies.
    pub curve: Vec<f64>,
}

/// Hypsometry of elevations that stand for equal areas; NaN is passed over.
pub fn hypsometry(elevation: &[f64]) -> Hypsometry {
    let mut z: Vec<f64> = elevation.iter().copied().filter(|z| z.is_finite()).collect();
    z.sort_unstable_by(|a, b| b.total_cmp(a));
    let (Some(&max), Some(&min)) = (z.first(), z.last()) else {
        return Hypsometry { integral: f64::NAN, curve: Vec::new() };
    };
    let relative = |z: f64| (z - min) / (max - min);
    let mean = z.iter().sum::<f64>() / z.len() as f64;
    let curve = (0..=100).map(|k| relative(z[(k * (z.len() - 1) + 50) / 100])).collect();
    Hypsometry { integral: relative(mean), curve }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_has_integral_one_half_and_a_straight_curve() {
        let z: Vec<f64> = (0..1001).map(f64::from).collect();
        let h = hypsometry(&z);
        assert!((h.integral - 0.5).abs() < 1e-12);
        assert!(h.curve.iter().enumerate().all(|(k, c)| (c - (1.0 - k as f64 / 100.0)).abs() < 1e-12));
        assert!(hypsometry(&[f64::NAN]).integral.is_nan());
    }
}
