//! Grows landscapes from natural processes.
//!
//! A **landscape** is a terrain with named fields and a record of how it came to be. **Stages** act on it: *generate* a
//! start, *edit* it, run *processes* over time, *convert*, *measure*, *export*. A **recipe** is a list of stages in TOML.
//!
//! From Rust, without a recipe:
//!
//! ```
//! use landform::core::random::Seed;
//! use landform::core::sim::{Simulation, Stop};
//! use landform::core::terrain::NodeSurface;
//! use landform::core::units::{KYR, Length, MYR, Rate};
//! use landform::core::verb::{Context, Generator, NoMaps};
//! use landform::process::generate::StreamGraph;
//! use landform::process::stream_power::StreamPower;
//! use landform::process::uplift::Uplift;
//!
//! # fn main() -> landform::core::Result<()> {
//! let start = StreamGraph { nodes: 500, size: [Length::of(10_000.0); 2], ..StreamGraph::default() }
//!     .generate(&Context { seed: Seed(7), maps: &NoMaps })?;
//! let mut simulation = Simulation::new(start)
//!     .process(Uplift { rate: Rate::of(0.5).into() })?
//!     .process(StreamPower::default())?
//!     .dt(100.0 * KYR)
//!     .until(Stop::time(2.0 * MYR));
//! let outcome = simulation.run()?;
//! assert!(outcome.budget.imbalance() < 1e-9);
//! assert!(simulation.terrain().elevation().iter().any(|&z| z > 100.0));
//! # Ok(())
//! # }
//! ```
//!
//! And with one: [`recipe::Recipe`].

pub mod recipe;

pub use landform_core as core;
pub use landform_io as io;
pub use landform_process as process;
