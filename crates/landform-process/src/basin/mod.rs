//! Basins that organise themselves: networks at the threshold of erosion, and networks of least
//! energy.
//!
//! # Sources
//! Rinaldo et al. (1993) and Rodríguez-Iturbe & Rinaldo (1997), Fractal River Basins; each module
//! names its own.

mod optimal;
#[cfg(test)]
mod tests;
mod threshold;

pub use optimal::OptimalNetwork;
pub use threshold::{Depressions, ThresholdErosion};

use landform_core::terrain::HeightField;

landform_core::stages! {
    edit OptimalNetwork where HeightField;
    process ThresholdErosion where HeightField;
}
