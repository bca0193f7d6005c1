//! Read-only measures of a terrain.

mod hypsometry;
mod slope_area;
mod summary;

pub use hypsometry::{Hypsometry, hypsometry};
pub use slope_area::{SlopeArea, slope_area};
pub use summary::{Summary, summary};
