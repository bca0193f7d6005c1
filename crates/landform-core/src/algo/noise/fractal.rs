//! Octaves of noise, summed in several ways.
//!
//! # Sources
//! Musgrave, in Ebert et al. (2003), *Texturing & Modeling*, chapter 16: fBm, multifractal, hybrid
//! and ridged multifractal; Pytel (2015), 2.1.5, for noise summing and for ridges as 1 − |noise|; Bell,
//! appendix, listings `billowNoise` and `ridgeNoise`, for the folded sums.
//! Octaves are shifted against each other, because gradient noise is zero at every lattice point.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Basis;
use crate::random::Seed;

/// How octaves are put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FractalKind {
    /// Plain sum: alike everywhere.
    #[default]
    Fbm,
    /// Sum of |noise|: rounded hills with sharp valleys.
    Billow,
    /// Sum of 1 - |noise|: sharp ridges with rounded valleys.
    Ridged,
    /// |Sum of noise|: the valleys of the sum, folded up, with sharp lines along its zeros.
    FoldedFbm,
    /// 1 - |sum of noise|: the same upside down, with crests along the zeros.
    CrestedFbm,
    /// Ridges whose detail grows where they are high already.
    RidgedMultifractal,
    /// Smooth lowlands, rough heights.
    HybridMultifractal,
    /// Product of octaves: smooth and rough parts side by side.
    Multifractal,
}

/// A sum of octaves of noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fractal {
    /// Noise function that is summed.
    pub basis: Basis,
    /// How.
    pub kind: FractalKind,
    /// Number of octaves.
    pub octaves: u32,
    /// Factor by which each octave is finer than the one before.
    pub lacunarity: f64,
    /// Factor of the height of each octave on that of the one before.
    pub gain: f64,
}

/// Musgrave's offset for the hybrid multifractal.
const OFFSET: f64 = 0.7;

impl Fractal {
    /// Values in about [−1, 1] at many points, in units of the first octave's waves.
    ///
    /// **Shape** `xs`, `ys` and `out` are of one length. **Cost** octaves × points; least where
    /// points lie in line.
    pub fn along(&self, seed: Seed, xs: &[f64], ys: &[f64], out: &mut [f64]) {
        let n = xs.len();
        let (mut fx, mut fy, mut noise, mut weight) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![1.0; n]);
        let (mut total, mut amplitude, mut frequency) = (0.0, 1.0, 1.0);
        out.fill(if self.kind == FractalKind::Multifractal { 1.0 } else { 0.0 });
        for octave in 0..self.octaves {
            let seed = seed.with(u64::from(octave));
            let shift = [seed.uniform(1), seed.uniform(2)];
            for k in 0..n {
                fx[k] = xs[k] * frequency + shift[0];
                fy[k] = ys[k] * frequency + shift[1];
            }
            self.basis.along(seed, &fx, &fy, &mut noise);
            self.add(octave, amplitude, &noise, &mut weight, out);
            total += amplitude;
            amplitude *= self.gain;
            frequency *= self.lacunarity;
        }
        self.normalize(total, out);
    }

    fn add(&self, octave: u32, amplitude: f64, noise: &[f64], weight: &mut [f64], out: &mut [f64]) {
        let each = out.iter_mut().zip(noise).zip(weight);
        match self.kind {
            FractalKind::Fbm | FractalKind::FoldedFbm | FractalKind::CrestedFbm => {
                each.for_each(|((o, n), _)| *o += amplitude * n);
            }
            FractalKind::Billow => each.for_each(|((o, n), _)| *o += amplitude * n.abs()),
            FractalKind::Ridged => each.for_each(|((o, n), _)| *o += amplitude * (1.0 - n.abs())),
            FractalKind::RidgedMultifractal => each.for_each(|((o, n), w)| {
                let ridge = 1.0 - n.abs();
                let signal = ridge * ridge * *w;
                *o += amplitude * signal;
                *w = (2.0 * signal).clamp(0.0, 1.0);
            }),
            FractalKind::HybridMultifractal => each.for_each(|((o, n), w)| {
                let signal = amplitude * (n + OFFSET);
                *o += *w * signal;
                *w = if octave == 0 { signal.min(1.0) } else { (*w * signal).min(1.0) };
            }),
            FractalKind::Multifractal => each.for_each(|((o, n), _)| *o *= 1.0 + amplitude * n),
        }
    }

    /// From what the sums span to about [−1, 1].
    fn normalize(&self, total: f64, out: &mut [f64]) {
        if total <= 0.0 {
            return out.fill(0.0);
        }
        match self.kind {
            FractalKind::Fbm => out.iter_mut().for_each(|o| *o /= total),
            FractalKind::FoldedFbm => out.iter_mut().for_each(|o| *o = 2.0 * (*o / total).abs() - 1.0),
            FractalKind::CrestedFbm => out.iter_mut().for_each(|o| *o = 1.0 - 2.0 * (*o / total).abs()),
            FractalKind::Billow | FractalKind::Ridged | FractalKind::RidgedMultifractal => {
                out.iter_mut().for_each(|o| *o = 2.0 * *o / total - 1.0);
            }
            FractalKind::HybridMultifractal => out.iter_mut().for_each(|o| *o = *o / total - OFFSET),
            FractalKind::Multifractal => out.iter_mut().for_each(|o| *o -= 1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algo::noise::fbm;

    fn points() -> (Vec<f64>, Vec<f64>) {
        ((0..9000).map(|i| f64::from(i % 300) * 0.03).collect(), (0..9000).map(|i| f64::from(i / 300) * 0.07).collect())
    }

    #[test]
    fn rows_have_the_bits_of_single_points() {
        let (xs, ys) = points();
        let fractal = Fractal { basis: Basis::Perlin, kind: FractalKind::Fbm, octaves: 6, lacunarity: 2.0, gain: 0.5 };
        let mut out = vec![0.0; xs.len()];
        fractal.along(Seed(3), &xs, &ys, &mut out);
        for k in 0..xs.len() {
            assert_eq!(out[k].to_bits(), fbm(Seed(3), xs[k], ys[k], 6, 2.0, 0.5).to_bits());
        }
    }

    #[test]
    fn kinds_differ_as_their_names_say() {
        let (xs, ys) = points();
        let run = |kind| {
            let mut out = vec![0.0; xs.len()];
            let fractal = Fractal { basis: Basis::Perlin, kind, octaves: 7, lacunarity: 2.0, gain: 0.5 };
            fractal.along(Seed(4), &xs, &ys, &mut out);
            out
        };
        use FractalKind::{
            Billow, CrestedFbm, Fbm, FoldedFbm, HybridMultifractal, Multifractal, Ridged, RidgedMultifractal,
        };
        for kind in [Fbm, FoldedFbm, CrestedFbm, Billow, Ridged, RidgedMultifractal, HybridMultifractal, Multifractal] {
            let values = run(kind);
            let span = values.iter().fold((9.0_f64, -9.0_f64), |r, &v| (r.0.min(v), r.1.max(v)));
            assert!(span.0 > -1.6 && span.1 < 2.5 && span.1 - span.0 > 0.4, "{kind:?} {span:?}");
        }
        let (billow, ridged) = (run(Billow), run(Ridged));
        assert!(billow.iter().zip(&ridged).all(|(b, r)| (b + r).abs() < 1e-12), "one is the other upside down");
        // Folded along the zeros of the plain sum.
        let (plain, folded, crested) = (run(Fbm), run(FoldedFbm), run(CrestedFbm));
        assert!(plain.iter().zip(&folded).all(|(p, f)| (2.0 * p.abs() - 1.0 - f).abs() < 1e-12));
        assert!(folded.iter().zip(&crested).all(|(f, c)| (f + c).abs() < 1e-12));
        // Rough heights and smooth lowlands: steps grow with elevation.
        let hybrid = run(HybridMultifractal);
        let step = |k: usize| (hybrid[k + 1] - hybrid[k]).abs();
        let mut order: Vec<usize> = (0..hybrid.len() - 1).filter(|k| k % 300 != 299).collect();
        order.sort_by(|&a, &b| hybrid[a].total_cmp(&hybrid[b]));
        let third = order.len() / 3;
        let mean = |part: &[usize]| part.iter().map(|&k| step(k)).sum::<f64>() / part.len() as f64;
        let (rough, smooth) = (mean(&order[2 * third..]), mean(&order[..third]));
        assert!(rough > 1.1 * smooth, "{rough} {smooth}");
    }
}
