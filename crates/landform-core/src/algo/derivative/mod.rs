//! Derivatives of rasters.

mod horn;

pub use horn::{Gradient, gradient, hillshade, slope};
