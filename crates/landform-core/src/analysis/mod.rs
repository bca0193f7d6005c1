//! Read-only measures of a terrain.

mod hypsometry;
mod scaling;
mod slope_area;
mod summary;
mod waters;

pub use hypsometry::{Hypsometry, hypsometry};
pub use scaling::{NetworkScaling, network_scaling, scaling};
pub use slope_area::{SlopeArea, slope_area};
pub use summary::{Summary, summary};
pub use waters::{Basin, Drainage, Lake, Polygon, RiverReach, Width, basins, lakes, rivers};
