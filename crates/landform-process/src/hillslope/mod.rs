//! Hillslopes.

mod linear_diffusion;

pub use linear_diffusion::LinearDiffusion;
