//! The functions that fractals are summed from.
//!
//! # Sources
//! Perlin (2002), our own kernel; the others by the `noise-functions` crate, in single precision
//! (beyond some ten thousand waves from the origin their steps show): OpenSimplex2 (KdotJPG), value
//! noise on a lattice, distance to the nearest of scattered points (Worley 1996).

use noise_functions::{CellDistance, OpenSimplex2, Sample, ValueCubic};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::gradient::gradient_noise_along;
use crate::random::Seed;

/// A noise function: bumps of about one size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Basis {
    /// Gradient noise: even bumps, fast.
    #[default]
    Perlin,
    /// OpenSimplex: like gradient noise, with fewer traces of a lattice.
    Simplex,
    /// Smooth interpolation between random heights on a lattice: blocky, broad.
    Value,
    /// Distance to the nearest of scattered points: cells with sharp borders.
    Worley,
}

impl Basis {
    /// Values in about [−1, 1] at many points, lattice spacing 1.
    pub(super) fn along(self, seed: Seed, xs: &[f64], ys: &[f64], out: &mut [f64]) {
        let number = seed.bits(0) as i32;
        let all = |out: &mut [f64], f: &dyn Fn([f32; 2]) -> f32| {
            for ((x, y), out) in xs.iter().zip(ys).zip(out) {
                *out = f64::from(f([*x as f32, *y as f32]));
            }
        };
        match self {
            Self::Perlin => gradient_noise_along(seed, xs, ys, out),
            Self::Simplex => all(out, &|p| OpenSimplex2.sample_with_seed(p, number)),
            Self::Value => all(out, &|p| ValueCubic.sample_with_seed(p, number)),
            Self::Worley => all(out, &|p| CellDistance::default().sample_with_seed(p, number)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_basis_is_bounded_and_follows_its_seed() {
        let xs: Vec<f64> = (0..4000).map(|i| f64::from(i % 80) * 0.37 - 9.0).collect();
        let ys: Vec<f64> = (0..4000).map(|i| f64::from(i / 80) * 0.41 - 5.0).collect();
        for basis in [Basis::Perlin, Basis::Simplex, Basis::Value, Basis::Worley] {
            let run = |seed| {
                let mut out = vec![0.0; xs.len()];
                basis.along(Seed(seed), &xs, &ys, &mut out);
                out
            };
            let (a, b) = (run(1), run(2));
            assert!(a.iter().all(|v| v.abs() <= 1.2), "{basis:?}");
            assert!(a != b && a == run(1), "{basis:?}");
            let (lo, hi) = a.iter().fold((1.0_f64, -1.0_f64), |r, &v| (r.0.min(v), r.1.max(v)));
            assert!(lo < -0.5 && hi > 0.3, "{basis:?} {lo} {hi}");
        }
    }
}
