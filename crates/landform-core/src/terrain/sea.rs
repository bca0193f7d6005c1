//! The level of a sea that is given by base levels alone.

use crate::grid::Status;

/// The level of the sea, where base levels look like one: all at or under it, all other ground
/// above. 0 m if it may be that, else the highest base level.
pub fn sea_level(status: &[Status], elevation: &[f64]) -> Option<f64> {
    let of = |kind: Status| (0..status.len()).filter(move |&i| status[i] == kind).map(|i| elevation[i]);
    let (sea, land) =
        (of(Status::BaseLevel).fold(f64::NEG_INFINITY, f64::max), of(Status::Interior).fold(f64::INFINITY, f64::min));
    (sea.is_finite() && sea < land).then_some(if sea <= 0.0 && land > 0.0 { 0.0 } else { sea })
}
