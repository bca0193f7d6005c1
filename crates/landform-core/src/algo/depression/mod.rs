//! Depressions by flooding: the reference that the basin graph of [`flow`](super::flow) is checked against, and the level
//! surface for one-off fills.

mod priority_flood;

pub use priority_flood::flood_levels;
