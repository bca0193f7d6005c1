//! Depressions by flooding: the reference that the basin graph of [`flow`](super::flow) is checked
//! against, and the level surface for one-off fills.
//!
//! A depression fills up to the lowest pass of its rim:
//!
//! ```
//! use landform_core::algo::depression::flood_levels;
//! use landform_core::grid::{Grid, RasterDomain, Shape};
//!
//! let grid = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
//! let ground = [5.0, 5.0, 5.0, 5.0, 1.0, 3.0, 5.0, 5.0, 5.0];
//! let level = flood_levels(&RasterDomain::new(&grid, &[]), &ground);
//! assert_eq!(level[4], 3.0);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod height;
mod priority_flood;

pub use height::Height;
pub use priority_flood::flood_levels;
