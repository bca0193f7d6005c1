//! Index space: shapes, borders, georeference, and the graph that flow runs over.
//!
//! The first node of a grid lies in the north-west, the last one in the south-east:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//!
//! let grid = Grid::new(Shape::new(3, 5), [10.0, 10.0])?;
//! assert_eq!(grid.extent(), [40.0, 20.0]);
//! assert_eq!(grid.position(0), [0.0, 20.0]);
//! assert_eq!(grid.node_at([40.0, 0.0]), Some(14));
//! # Ok::<(), landform_core::Error>(())
//! ```

mod centres;
mod domain;
mod edges;
mod georeference;
mod graph;
#[expect(clippy::module_inception, reason = "the grid is what the folder is named for")]
mod grid;
mod jitter;
mod lattice;
mod neighbours;
mod raster;
mod shape;

pub use centres::Centres;
pub use domain::{Domain, NO_SLOT, Status};
pub(crate) use domain::{is_below, write_receivers};
pub use edges::{Edge, Edges, Side};
pub use georeference::{Degrees, GeoKeys, Georeference, Registration};
pub use graph::Graph;
pub(crate) use graph::Links;
pub use grid::{Frame, Grid};
pub use jitter::Jitter;
pub use lattice::Lattice;
pub use neighbours::{Link, Neighbours};
pub use raster::RasterDomain;
pub use shape::{Cell, Shape};
