//! Radii that a map can hold.

use landform_core::grid::Grid;
use landform_core::units::Length;
use landform_core::{Error, Result, math};

/// Refuses a radius beyond the diagonal of a map: what an event reaches is listed once for all, and would not fit in memory.
///
/// # Errors
/// [`Error::Parameter`] with the diagonal.
pub fn within_map(name: &str, radius: Length, grid: &Grid) -> Result<()> {
    let most = math::hypot(grid.shape.cols as f64 * grid.spacing[0], grid.shape.rows as f64 * grid.spacing[1]);
    if radius.si() > most {
        return Err(Error::parameter(name, radius, &format!("at most {most:.0} m, the diagonal of the map")));
    }
    Ok(())
}
