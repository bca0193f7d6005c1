//! What more than one phenomenon uses, and is none of its own.

mod drainage;
pub mod wind;

pub use drainage::{leave_drainage, leave_steepness};
