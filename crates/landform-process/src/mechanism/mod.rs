//! What more than one phenomenon uses, and is none of its own.

mod drainage;
mod radius;
pub mod water;
pub mod wind;

pub use drainage::{leave_drainage, leave_steepness};
pub use radius::within_map;
