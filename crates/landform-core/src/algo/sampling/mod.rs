//! Where to put nodes.

mod poisson_disk;

pub use poisson_disk::{poisson_disk, spacing_for_count};
