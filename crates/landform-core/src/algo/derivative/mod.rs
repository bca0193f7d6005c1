//! Derivatives of rasters, and nodes relative to their surroundings.
//!
//! Ground that rises to the east faces west:
//!
//! ```
//! use landform_core::algo::derivative::gradient;
//! use landform_core::grid::{Grid, Shape};
//!
//! let grid = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
//! let middle = gradient(&grid, &[0.0, 5.0, 10.0].repeat(3), 4);
//! assert!((middle.slope() - 0.5).abs() < 1e-12);
//! assert!((middle.aspect().to_degrees() - 270.0).abs() < 1e-9);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod horn;
mod neighbourhood;
mod quadratic;

pub use horn::{Gradient, gradient, hillshade, slope};
pub use neighbourhood::{local_relief, position_index};
pub use quadratic::{Quadratic, gradient_of_four, quadratic};
