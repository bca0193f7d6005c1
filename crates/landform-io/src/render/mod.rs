//! Pictures, on the CPU: a shaded map and a perspective view. Pixels come back as buffers; `format` makes files of them.

mod colour;
mod cover;
mod drawing;
mod label;
mod light;
mod map;
mod perspective;
mod pyramid;

use landform_core::grid::Shape;

pub use colour::Ramp;
pub use drawing::{Waters, waters};
pub use map::{MapStyle, difference_map, field_map, shaded_map, value_picture};
pub use perspective::{View, perspective};

/// A picture: 8-bit red, green, blue, row-major from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Rows and columns.
    pub shape: Shape,
    /// Pixels.
    pub pixels: Vec<[u8; 3]>,
}
