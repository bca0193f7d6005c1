//! Valleys that run down an island on all sides.

use landform_core::algo::noise::{fbm, gradient_noise};
use landform_core::math;
use landform_core::random::Seed;

/// Valleys by noise on a circle: its zeros are the valleys' lines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Valleys {
    /// Seed of the noise.
    pub seed: Seed,
    /// Radius of the island, m.
    pub radius: f64,
}

/// Main valleys and their branches: bumps of the noise on half the circle, strength, and the parts
/// of the radius between which they begin.
const SETS: [(f64, f64, [f64; 2]); 3] = [(2.3, 0.55, [0.03, 0.3]), (5.1, 0.3, [0.12, 0.5]), (11.0, 0.15, [0.3, 0.7])];
/// How far valleys leave a straight line, and over which part of the radius.
const BEND: [f64; 2] = [0.32, 0.45];

impl Valleys {
    /// How much of the height is cut at a place (m from the middle, and its compass direction), 0
    /// on ridges to 1 on the floor of a great valley.
    pub(super) fn cut(&self, [x, y]: [f64; 2], direction: f64) -> f64 {
        let far = math::hypot(x, y) / self.radius;
        let scale = BEND[1] * self.radius;
        let bend = |k: u64| BEND[0] * fbm(self.seed.with(k), x / scale, y / scale, 4, 2.0, 0.5);
        let (u, v) = (math::sin(direction) + bend(1), math::cos(direction) + bend(2));
        let set = |k: usize| {
            let (fine, strength, [begins, whole]) = SETS[k];
            let seed = self.seed.with(10 + k as u64);
            let noise = gradient_noise(seed, fine * u + seed.uniform(1), fine * v + seed.uniform(2));
            let floor = 1.0 - (2.4 * noise.abs()).min(1.0);
            strength * math::smoothstep(begins, whole, far) * floor
        };
        set(0) + set(1) + set(2)
    }
}
