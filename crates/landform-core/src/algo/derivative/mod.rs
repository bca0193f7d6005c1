//! Derivatives of rasters, and nodes against what is around them.

mod horn;
mod neighbourhood;
mod quadratic;

pub use horn::{Gradient, gradient, hillshade, slope};
pub use neighbourhood::{local_relief, position_index};
pub use quadratic::{Quadratic, gradient_of_four, quadratic};
