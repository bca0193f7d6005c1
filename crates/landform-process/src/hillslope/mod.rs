//! Hillslopes.
//!
//! Creep lowers a bump and keeps its volume where nothing leaves:
//!
//! ```
//! use landform_core::grid::{Edge, Edges, Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::units::KYR;
//! use landform_process::hillslope::LinearDiffusion;
//!
//! let mut grid = Grid::new(Shape::new(5, 5), [10.0, 10.0])?;
//! grid.edges = Edges::all(Edge::Closed);
//! let bump = (0..25).map(|i| if i == 12 { 10.0 } else { 0.0 }).collect();
//! let mut model = Model::new(HeightField::new(grid, bump)?).dt(KYR);
//! model.add(LinearDiffusion::default())?;
//! model.advance_steps(3)?;
//! let z = model.terrain().elevation();
//! assert!(z[12] < 10.0 && z[13] > 0.0 && (z.iter().sum::<f64>() - 10.0).abs() < 1e-6);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod implicit;
mod landslides;
mod linear_diffusion;
mod nonlinear_diffusion;
mod thermal_erosion;

pub use landslides::Landslides;
pub use linear_diffusion::LinearDiffusion;
pub use nonlinear_diffusion::NonlinearDiffusion;
pub use thermal_erosion::ThermalErosion;

use landform_core::terrain::{HeightField, Mesh};

landform_core::stages! {
    process Landslides where HeightField, Mesh;
    process LinearDiffusion where HeightField, Mesh;
    process NonlinearDiffusion where HeightField;
    process ThermalErosion where HeightField, Mesh;
}
