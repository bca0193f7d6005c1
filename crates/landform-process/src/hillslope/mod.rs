//! Hillslopes.

mod linear_diffusion;
mod thermal_erosion;

pub use linear_diffusion::LinearDiffusion;
pub use thermal_erosion::ThermalErosion;

use landform_core::terrain::{HeightField, Mesh};

landform_core::stages! {
    process LinearDiffusion where HeightField, Mesh;
    process ThermalErosion where HeightField, Mesh;
}
