//! Coherent noise, sums of it, and surfaces of known statistics.
//!
//! ```
//! use landform_core::algo::noise::self_affine;
//! use landform_core::grid::Shape;
//! use landform_core::random::Seed;
//!
//! let z = self_affine(Shape::new(33, 33), [10.0, 10.0], 0.8, Seed(1));
//! let mean = z.iter().sum::<f64>() / z.len() as f64;
//! let variance = z.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / z.len() as f64;
//! assert!(mean.abs() < 1e-9 && (variance - 1.0).abs() < 1e-9);
//! ```

mod basis;
mod faults;
mod fractal;
mod gradient;
mod midpoint;
mod spectral;

pub use basis::Basis;
pub use faults::{Faults, faults};
pub use fractal::{Fractal, FractalKind};
pub use gradient::{fbm, gradient_noise, gradient_noise_and_rise};
pub use midpoint::{Midpoint, Subdivision};
pub use spectral::{self_affine, spectral_surface, surroundings};
