//! One-shot changes that are not nature, and changes of representation.

mod add;
mod derive;
mod drainage;
mod fill_depressions;
mod find_features;
mod mask;
mod resample;
mod to_height_field;
mod warp;

pub use add::Add;
pub use derive::{Derive, Derived};
pub use drainage::Drainage;
pub use fill_depressions::FillDepressions;
pub use find_features::FindFeatures;
pub use mask::Mask;
pub use resample::Resample;
pub use to_height_field::ToHeightField;
pub use warp::Warp;

use landform_core::terrain::{HeightField, Mesh};

landform_core::stages! {
    edit Add where HeightField, Mesh;
    edit Derive where HeightField;
    edit Drainage where HeightField, Mesh;
    edit FillDepressions where HeightField, Mesh;
    edit FindFeatures where HeightField, Mesh;
    edit Mask where HeightField;
    edit Resample where HeightField;
    edit Warp where HeightField;
    convert ToHeightField where Mesh => HeightField;
}
