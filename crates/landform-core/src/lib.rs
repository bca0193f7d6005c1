//! Terrains, and how stages are run. No physics, no files.
//!
//! The layers, each of which may use only those above it:
//!
//! | module | holds |
//! |---|---|
//! | [`error`], [`units`], [`random`], [`math`], [`parallel`] | the basis of everything else |
//! | [`grid`] | index space, borders, georeference, and [`Domain`](grid::Domain): the graph that flow runs over |
//! | [`field`], [`feature`] | named, typed values per node; rivers, lakes, coasts and other features |
//! | [`terrain`] | the representations: [`HeightField`](terrain::HeightField), [`Mesh`](terrain::Mesh) |
//! | [`algo`] | flow routing, depressions, derivatives, noise, sampling |
//! | [`agents`] | groups, searches, avalanches, automata, sand: the self-organised framework |
//! | [`verb`] | parameters, values that vary in space, and the six verbs |
//! | [`analysis`], [`sim`] | read-only measures; models and their runs in time |
//! | [`stage`] | the rows of the table of stages |
//!
//! All quantities inside are SI (metres, seconds); see [`units`] for how people write them.

pub mod agents;
pub mod algo;
pub mod analysis;
pub mod error;
pub mod feature;
pub mod field;
pub mod grid;
pub mod math;
pub mod parallel;
pub mod random;
pub mod recent;
pub mod sim;
pub mod stage;
pub mod terrain;
pub mod units;
pub mod verb;

pub use error::{Error, Result};
