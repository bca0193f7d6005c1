//! Joints and faults: zones of weaker rock along wavy lines.
//!
//! # Model
//! Line k of a set crosses the direction `towards` at (k + c) spacings, with c keyed by k within
//! ±0.35, and is bent by noise of four spacings and one. At a distance d from it the rock wears
//! 1 + (w − 1) exp(−d²/b²) times as fast. Between lines k and k + 1 lies a block, which a fault has
//! raised by its throw times a standard normal number keyed by k.

use landform_core::algo::noise::gradient_noise;
use landform_core::math;
use landform_core::random::Seed;
use landform_core::units::{Angle, Length};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How far a line lies off its place, in spacings.
const OFF: f64 = 0.35;
/// How high the finer waves of lines are beside the longer.
const FINER: f64 = 0.35;

/// A set of joints or faults that run one way.
///
/// ```
/// use landform_process::generate::JointParams;
///
/// let joints: JointParams = serde_json::from_str(r#"{ "spacing": "900 m", "throw": "30 m" }"#).unwrap();
/// assert_eq!(joints.weakness, 3.0);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct JointParams {
    /// Mean distance of lines.
    #[schemars(extend("x-above" = 0.0))]
    pub spacing: Length,
    /// Compass direction in which they run.
    pub direction: Angle,
    /// Half width of the weak zone, at which its effect has fallen to a third.
    #[schemars(extend("x-above" = 0.0))]
    pub width: Length,
    /// Factor by which the rock wears faster on the line itself.
    #[schemars(extend("x-min" = 1.0, "x-max" = 100.0))]
    pub weakness: f64,
    /// Number of spacings by which noise bends lines to either side; with 0 they are straight.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub waviness: f64,
    /// Standard deviation of the height by which blocks between lines are raised or sunk. With 0
    /// the lines are joints, else faults.
    #[schemars(extend("x-min" = 0.0))]
    pub throw: Length,
}

impl Default for JointParams {
    fn default() -> Self {
        Self {
            spacing: Length::of(1_500.0),
            direction: Angle::of(40.0),
            width: Length::of(60.0),
            weakness: 3.0,
            waviness: 0.4,
            throw: Length::of(0.0),
        }
    }
}

impl JointParams {
    /// The place across the lines, in spacings.
    fn across(&self, seed: Seed, [x, y]: [f64; 2]) -> f64 {
        let (spacing, direction) = (self.spacing.si(), self.direction.si());
        let bend = if self.waviness > 0.0 {
            let noise = |name: &str, wave: f64| gradient_noise(seed.named(name), x / wave, y / wave);
            self.waviness * (noise("bend", 4.0 * spacing) + FINER * noise("finer", spacing))
        } else {
            0.0
        };
        (x * math::cos(direction) - y * math::sin(direction)) / spacing + bend
    }

    /// Where line `k` crosses, in spacings.
    fn line(seed: Seed, k: i64) -> f64 {
        k as f64 + OFF * (2.0 * seed.named("line").uniform(k as u64) - 1.0)
    }

    /// How many times as fast rock wears at a place.
    pub(super) fn weakness(&self, seed: Seed, place: [f64; 2]) -> f64 {
        let at = self.across(seed, place);
        let near = at.floor() as i64;
        let off = (near - 1..=near + 2).map(|k| (at - Self::line(seed, k)).abs()).fold(f64::INFINITY, f64::min);
        let d = off * self.spacing.si() / self.width.si();
        1.0 + (self.weakness - 1.0) * math::exp(-d * d)
    }

    /// How far the block at a place is raised, m.
    pub(super) fn raised(&self, seed: Seed, place: [f64; 2]) -> f64 {
        if self.throw.si() == 0.0 {
            return 0.0;
        }
        let at = self.across(seed, place);
        let near = at.floor() as i64;
        let block = (near - 1..=near + 1).rev().find(|&k| Self::line(seed, k) <= at).unwrap_or(near - 1);
        self.throw.si() * seed.named("throw").normal_pair(block as u64).0
    }
}
