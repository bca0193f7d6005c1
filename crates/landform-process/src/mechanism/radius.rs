//! Limit of radii by the size of a map.

use landform_core::grid::Grid;
use landform_core::units::Length;
use landform_core::{Error, Result, math};

/// Refuses a radius beyond the diagonal of a map: the nodes that an event reaches are listed once,
/// and the list would not fit in memory.
///
/// # Errors
/// [`Error::Parameter`], which names the diagonal, if the radius is longer than it.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::units::Length;
/// use landform_process::mechanism::within_map;
///
/// let grid = Grid::new(Shape::new(3, 4), [10.0; 2])?;
/// assert!(within_map("radius", Length::of(50.0), &grid).is_ok());
/// assert!(within_map("radius", Length::of(51.0), &grid).is_err());
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn within_map(name: &str, radius: Length, grid: &Grid) -> Result<()> {
    let most = math::hypot(grid.shape.cols as f64 * grid.spacing[0], grid.shape.rows as f64 * grid.spacing[1]);
    if radius.si() > most {
        return Err(Error::parameter(name, radius, &format!("at most {most:.0} m, the diagonal of the map")));
    }
    Ok(())
}
