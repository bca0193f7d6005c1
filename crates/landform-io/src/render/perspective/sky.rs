//! The sky, a ramp from the horizon to the zenith.

use landform_core::math;

use crate::render::colour::{Rgb, blend, hex, mix};
use crate::render::ground::SKY;

/// Steps of the ramp; more would not show in eight bits.
const STEPS: usize = 512;

/// Colours by height.
pub(super) struct Sky {
    ramp: Vec<Rgb>,
    /// Rise of the direction at which the ramp begins.
    from: f64,
}

impl Sky {
    /// The ramp: mixing in Oklab costs too much to do for each ray.
    pub(super) fn rising_from(from: f64) -> Self {
        Self { ramp: (0..=STEPS).map(|k| mix(hex(SKY[1]), hex(SKY[0]), k as f64 / STEPS as f64)).collect(), from }
    }

    /// Its colour in a direction that rises by `up`.
    pub(super) fn colour(&self, up: f64) -> Rgb {
        let t = math::smoothstep(self.from, 0.45, up) * STEPS as f64;
        let k = (t as usize).min(STEPS - 1);
        blend(self.ramp[k], self.ramp[k + 1], t - k as f64)
    }
}
