//! One-shot changes that are not nature, and changes of representation.

mod add;
mod drainage;
mod fill_depressions;
mod resample;
mod to_height_field;

pub use add::Add;
pub use drainage::Drainage;
pub use fill_depressions::FillDepressions;
pub use resample::Resample;
pub use to_height_field::ToHeightField;
