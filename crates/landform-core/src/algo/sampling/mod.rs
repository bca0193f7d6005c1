//! Sampling: positions of nodes.
//!
//! No two nodes lie nearer to each other than the spacing:
//!
//! ```
//! use landform_core::algo::sampling::poisson_disk;
//! use landform_core::math::hypot;
//! use landform_core::random::Seed;
//!
//! let points = poisson_disk([100.0, 70.0], 10.0, Seed(1))?;
//! for (i, p) in points.iter().enumerate() {
//!     assert!(points[..i].iter().all(|q| hypot(p[0] - q[0], p[1] - q[1]) > 10.0 - 1e-9));
//! }
//! # Ok::<(), landform_core::Error>(())
//! ```

mod poisson_disk;

pub use poisson_disk::{poisson_disk, scattered, spacing_for_count};
