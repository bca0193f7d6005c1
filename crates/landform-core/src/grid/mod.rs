//! Index space: shapes, borders, places on the Earth, and the graph that flow runs over.

mod domain;
mod edges;
mod georeference;
mod graph;
#[expect(clippy::module_inception, reason = "the grid is what the folder is named for")]
mod grid;
mod lattice;
mod raster;
mod shape;

pub(crate) use domain::is_below;
pub use domain::{BASE_LEVEL, Domain, INTERIOR, Link, MASKED, NO_SLOT, Node, Status};
pub use edges::{Edge, Edges, Side};
pub use georeference::{Georeference, Registration};
pub use graph::Graph;
pub(crate) use graph::Links;
pub use grid::Grid;
pub use lattice::Lattice;
pub use raster::RasterDomain;
pub use shape::{Cell, Shape};
