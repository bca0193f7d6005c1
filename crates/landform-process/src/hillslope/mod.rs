//! Hillslopes.

mod linear_diffusion;
mod thermal_erosion;

pub use linear_diffusion::LinearDiffusion;
pub use thermal_erosion::ThermalErosion;
