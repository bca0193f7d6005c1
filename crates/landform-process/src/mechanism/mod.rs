//! Mechanisms that several phenomena share.

mod drainage;
mod grid;
mod lattice;
mod plane;
mod radius;
mod sums;
pub mod water;
pub mod wind;

pub use drainage::{write_channel_steepness_fields, write_drainage_fields};
pub use grid::GridParams;
pub use lattice::Lattice;
pub(crate) use plane::plane_normal;
pub use radius::within_map;
pub(crate) use sums::{add_to_incision, add_to_sums, begin_sums};
