//! Coherent noise, sums of it, and surfaces of known statistics.

mod basis;
mod faults;
mod fractal;
mod gradient;
mod midpoint;
mod spectral;

pub use basis::Basis;
pub use faults::{Faults, faults};
pub use fractal::{Fractal, FractalKind};
pub use gradient::{fbm, gradient_noise};
pub use midpoint::{Midpoint, Subdivision};
pub use spectral::{self_affine, spectral_surface, surroundings};
