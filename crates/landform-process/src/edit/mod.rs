//! Single changes that no natural process makes, and changes of representation.
//!
//! A depression is filled up to the lowest pass of its rim:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::verb::{Context, Edit};
//! use landform_process::edit::FillDepressions;
//!
//! let grid = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
//! let mut ground = HeightField::new(grid, vec![5.0, 5.0, 5.0, 5.0, 1.0, 3.0, 5.0, 5.0, 5.0])?;
//! FillDepressions::default().edit(&mut ground, &Context::default())?;
//! assert_eq!(ground.elevation()[4], 3.0);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod add;
mod carve_path;
mod crop;
mod derive;
mod drainage;
mod fill_depressions;
mod find_features;
mod mask;
mod resample;
mod scatter;
mod set_outlets;
mod set_relief;
mod to_height_field;
mod warp;

pub use add::Add;
pub use carve_path::{CarvePath, PathRoute};
pub use crop::Crop;
pub use derive::{Derive, Derived};
pub use drainage::Drainage;
pub use fill_depressions::FillDepressions;
pub use find_features::FindFeatures;
pub use mask::Mask;
pub use resample::Resample;
pub use scatter::{DistanceRule, Scatter};
pub use set_outlets::SetOutlets;
pub use set_relief::{ReliefAbove, SetRelief};
pub use to_height_field::ToHeightField;
pub use warp::Warp;

use landform_core::terrain::{HeightField, Mesh};

landform_core::stages! {
    edit Add where HeightField, Mesh;
    edit CarvePath where HeightField;
    edit Crop where HeightField;
    edit Derive where HeightField;
    edit Drainage where HeightField, Mesh;
    edit FillDepressions where HeightField, Mesh;
    edit FindFeatures where HeightField, Mesh;
    edit Mask where HeightField;
    edit Resample where HeightField;
    edit Scatter where HeightField;
    edit SetOutlets where HeightField, Mesh;
    edit SetRelief where HeightField, Mesh;
    edit Warp where HeightField;
    convert ToHeightField where Mesh => HeightField;
}
