//! The shore of an island by direction.

use std::f64::consts::TAU;

use landform_core::algo::noise::gradient_noise;
use landform_core::math;
use landform_core::random::Seed;

/// Octaves of the noise on a circle, each twice as fine and half as strong.
const OCTAVES: u32 = 5;
/// Bumps of the coarsest octave on half the circle.
const COARSEST: f64 = 0.9;
/// What brings the noise to about 1.
const SCALE: f64 = 2.0;

/// Factor on the radius of an island by direction: 1 on average.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    seed: Seed,
    roughness: f64,
    /// Factors in even directions, clockwise from north; none for a circle.
    radii: Vec<f64>,
}

impl Outline {
    /// From factors in even directions and the part by which noise may change them.
    pub(super) fn new(seed: Seed, roughness: f64, radii: Vec<f64>) -> Self {
        Self { seed, roughness, radii }
    }

    /// The factor in a compass direction (rad).
    pub(super) fn factor(&self, direction: f64) -> f64 {
        let direction = direction.rem_euclid(TAU);
        let noise = if self.roughness > 0.0 { self.noise(direction) } else { 0.0 };
        self.drawn(direction) * (1.0 + self.roughness * noise)
    }

    /// Noise of period 2 pi, -1 to 1: on a circle in the plane, so that it has no seam.
    fn noise(&self, direction: f64) -> f64 {
        let (x, y) = (math::sin(direction), math::cos(direction));
        let (mut sum, mut strength, mut fine) = (0.0, 1.0, COARSEST);
        for octave in 0..OCTAVES {
            let seed = self.seed.with(u64::from(octave));
            let shift = [seed.uniform(1), seed.uniform(2)];
            sum += strength * gradient_noise(seed, fine * x + shift[0], fine * y + shift[1]);
            strength *= 0.5;
            fine *= 2.0;
        }
        (SCALE * sum / 1.9375).clamp(-1.0, 1.0)
    }

    /// The drawn factor: a periodic curve through the given ones, by Catmull and Rom.
    fn drawn(&self, direction: f64) -> f64 {
        let n = self.radii.len();
        if n == 0 {
            return 1.0;
        }
        let at = direction / TAU * n as f64;
        let (k, t) = (at as usize % n, at.fract());
        let [a, b, c, d] = [n - 1, 0, 1, 2].map(|by| self.radii[(k + by) % n]);
        let bend = 2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a);
        let value = b + 0.5 * t * (c - a + t * bend);
        // Where radii jump, the curve may swing too far.
        value.clamp(b.min(c) * 0.8, b.max(c) * 1.25)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cr6_outlines_have_no_seam_and_meet_their_radii() {
        let rough = Outline::new(Seed(4), 0.2, vec![1.0, 0.7, 1.2, 1.1, 0.9]);
        assert_eq!(rough.factor(0.0), rough.factor(TAU));
        let turns: Vec<f64> = (0..=7200).map(|k| rough.factor(f64::from(k) * TAU / 7200.0)).collect();
        assert!(turns.windows(2).all(|w| (w[1] - w[0]).abs() < 0.01));
        let spread = turns.iter().fold((f64::MAX, 0.0), |(lo, hi): (f64, f64), &r| (lo.min(r), hi.max(r)));
        assert!(spread.0 > 0.5 && spread.1 < 1.5 && spread.1 - spread.0 > 0.3, "{spread:?}");
        let drawn = Outline::new(Seed(4), 0.0, vec![1.0, 0.7, 1.2, 1.1]);
        assert!((drawn.factor(TAU / 4.0) - 0.7).abs() < 1e-12 && (drawn.factor(TAU / 2.0) - 1.2).abs() < 1e-12);
        assert_eq!(Outline::new(Seed(4), 0.0, Vec::new()).factor(1.234), 1.0);
    }
}
