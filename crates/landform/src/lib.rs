//! Grows landscapes from natural processes.
//!
//! A **landscape** is a terrain with named fields and a history. **Stages** act on it: *generate* a
//! start, *edit* it, run *processes* over time, *convert*, *measure*, *export*. A **recipe** is a
//! list of stages in TOML.
//!
//! From Rust, without a recipe:
//!
//! ```
//! use landform::prelude::*;
//!
//! # fn main() -> landform::Result<()> {
//! let start = StreamGraph { nodes: 500, size: [metres(10_000.0); 2], ..StreamGraph::default() };
//! let mut land = Landscape::from(start.generate(&Context::default())?);
//! let outcome = land
//!     .evolve(kyr(100.0), myr(2.0))
//!     .with(Uplift { rate: mm_per_yr(0.5).into() })
//!     .with(StreamPower::default())
//!     .run()?;
//! assert!(outcome.budget.imbalance() < 1e-9);
//! assert!(land.terrain.elevation().iter().any(|&z| z > 100.0));
//! # Ok(())
//! # }
//! ```
//!
//! A [`Model`](landform_core::sim::Model) can be stepped, examined and changed on the way. With a
//! recipe: [`recipe::Recipe`].
//!
//! | crate | holds |
//! |---|---|
//! | [`core`] | terrains, and how stages are run |
//! | [`process`] | processes that change a terrain, a folder a phenomenon |
//! | [`io`] | files, pictures, reports |

mod landscape;
pub mod prelude;
pub mod recipe;

pub use landform_core as core;
pub use landform_core::{Error, Result};
pub use landform_io as io;
pub use landform_process as process;
pub use landscape::{Evolution, Landscape};
