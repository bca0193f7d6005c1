//! One-shot changes that are not nature, and changes of representation.

mod add;
mod derive;
mod drainage;
mod fill_depressions;
mod mask;
mod resample;
mod to_height_field;
mod warp;

pub use add::Add;
pub use derive::{Derive, Derived};
pub use drainage::Drainage;
pub use fill_depressions::FillDepressions;
pub use mask::Mask;
pub use resample::Resample;
pub use to_height_field::ToHeightField;
pub use warp::Warp;
