//! The force that leaves a share of the land.

use landform_core::verb::Resolved;
use landform_core::{Error, Result};

use super::State;
use super::params::CoastErosion;

/// Trials between a force that leaves more and one that leaves less.
const TRIALS: usize = 16;
/// A share this near is taken, and one this far is refused.
const NEAR: f64 = 0.005;
const FAR: f64 = 0.1;
/// A force beyond which no resistance counts.
const STRONGEST: f64 = 64.0;

impl CoastErosion {
    /// The force that leaves about this share of the land, by halving. **Cost** some twenty runs of
    /// the coast, those that take too much land cut short.
    pub(super) fn force_that_leaves(&self, land: f64, state: &State) -> Result<f64> {
        let (mut low, mut high) = ((0.0, 1.0), (0.25, self.share_left(0.25, land, state)));
        while high.1 >= land && high.0 < STRONGEST {
            low = high;
            high = (2.0 * high.0, self.share_left(2.0 * high.0, land, state));
        }
        for _ in 0..TRIALS {
            if low.1 - land < NEAR {
                break;
            }
            let force = 0.5 * (low.0 + high.0);
            let share = self.share_left(force, land, state);
            if share >= land {
                low = (force, share);
            } else {
                high = (force, share);
            }
        }
        if low.1 - land > FAR {
            let allowed =
                format!("{:.2} or more: a sea that takes more does not rest before it has taken nearly all", low.1);
            return Err(Error::parameter("land", land, &allowed));
        }
        Ok(low.0)
    }

    /// The share of land that is left once the sea rests, or less than `enough` once it is.
    fn share_left(&self, force: f64, enough: f64, state: &State) -> f64 {
        let Some(mut front) = state.front.clone() else { return 0.0 };
        let (land, material) = front.parts();
        land.clone_from(&state.land);
        material.clone_from(&state.material);
        let force = Resolved::Uniform(force);
        let mut left = state.start_land;
        for _ in 0..self.iterations {
            let fallen = self.round(state, &force, &mut front);
            left = left.saturating_sub(fallen.len());
            if fallen.is_empty() || (left as f64) < enough * state.start_land as f64 {
                break;
            }
        }
        left as f64 / state.start_land as f64
    }
}
