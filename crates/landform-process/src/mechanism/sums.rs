//! What running water took and laid down, summed over steps.

use landform_core::Result;
use landform_core::field::names;
use landform_core::parallel;
use landform_core::terrain::NodeSurface;

/// Begins the sums of deposition and incision where there are none yet; those of an earlier run go
/// on.
///
/// # Errors
/// Where [`landform_core::field::Fields::insert`] fails.
pub(crate) fn begin_sums<T: NodeSurface>(terrain: &mut T) -> Result<()> {
    for key in names::SUMS {
        if terrain.fields().get(key, "").is_err() {
            let z = terrain.elevation();
            let zeros = parallel::map(z.len(), |i| if z[i].is_nan() { f64::NAN } else { 0.0 });
            terrain.fields_mut().insert(key, zeros)?;
        }
    }
    Ok(())
}

/// Adds to them how far each node was lowered in a step, m; negative where it was raised.
pub(crate) fn add_to_sums<T: NodeSurface>(terrain: &mut T, lowered: &[f64]) {
    terrain.fields_mut().add_parts(&names::INCISION, &names::DEPOSITION, lowered);
}

/// As [`add_to_sums`], where no node was raised.
pub(crate) fn add_to_incision<T: NodeSurface>(terrain: &mut T, lowered: &[f64]) {
    terrain.fields_mut().add(&names::INCISION, lowered);
}
