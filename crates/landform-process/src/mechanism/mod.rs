//! What more than one phenomenon uses, and is none of its own.

mod drainage;

pub use drainage::{FIELDS as DRAINAGE_FIELDS, leave_drainage};
