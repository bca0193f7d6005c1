//! Coherent noise.

mod gradient;

pub use gradient::{fbm, gradient_noise};
