//! Algorithms on grids and graphs, free of physics.

pub mod decimate;
pub mod depression;
pub mod derivative;
mod disjoint_sets;
pub mod fast_marching;
pub mod flow;
pub mod fourier;
pub mod horizon;
pub mod isoline;
pub mod lattice;
pub mod network;
pub mod noise;
pub mod outlets;
pub mod outline;
pub mod polygonise;
pub mod sampling;
pub mod thin_plate;

pub use disjoint_sets::DisjointSets;
