//! Self-organised landscapes: agents on the sites of a graph, and the avalanches that they trigger.
//!
//! Free of physics. Agents of one kind form a [`Group`]: at most one a site, with a state of its
//! own and globals that all share. They join and leave sites, do not act in the visit in which they
//! were born, find sites around them with a [`Search`], and trigger avalanches: one event that
//! makes similar events around it more likely ([`avalanche()`], or a [`Stencil`] where the sites
//! are a raster), or that triggers others until nothing moves ([`cascade`]). Sites are plain
//! indices of anything that is [`Sites`]: a raster, a mesh, a box of voxels. [`Automaton`] is the
//! other style: a rule (cell, eight neighbours) → cell for all cells at once. [`Sand`] serves both:
//! slabs that slip at the angle of repose.
//!
//! # Sources
//! Pytel (2015), chapter 3, whose framework this is; Koh (2002) for automata. Differences from it:
//! sites are indices rather than linked nodes, searches and avalanches allocate nothing, and every
//! order of visits is defined.

mod automaton;
mod avalanche;
mod group;
mod sand;
mod search;
mod sites;

pub use automaton::{Automaton, Neighbourhood};
pub use avalanche::{Falloff, Stencil, avalanche, cascade};
pub use group::{Group, Order};
pub use sand::{Sand, Shelter};
pub use search::Search;
pub use sites::{Connectivity, MeshSites, RasterSites, Sites, VoxelSites, Voxels};
