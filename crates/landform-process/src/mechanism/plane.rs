//! Planes in the rock: beds and fractures.

use landform_core::math;

/// The direction across planes that dip by an angle below the horizontal towards a compass
/// direction (rad), upwards; of length 1.
#[inline]
pub(crate) fn plane_normal(dip: f64, dip_direction: f64) -> [f64; 3] {
    let level = math::sin(dip);
    [level * math::sin(dip_direction), level * math::cos(dip_direction), math::cos(dip)]
}
