//! Pictures, on the CPU: a shaded map and a perspective view. Pixels come back as buffers; `format`
//! makes files of them.
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::HeightField;
//! use landform_io::format::encode_png;
//! use landform_io::render::{MapStyle, shaded_map};
//!
//! let slope = (0..64).map(f64::from).collect();
//! let ground = HeightField::new(Grid::new(Shape::new(8, 8), [100.0, 100.0])?, slope)?;
//! let map = shaded_map(&ground, &MapStyle { size: 32, ..MapStyle::default() })?;
//! assert_eq!(map.shape, Shape::new(32, 32));
//! assert!(encode_png(&map.pixels, map.shape)?.starts_with(b"\x89PNG"));
//! # Ok::<(), landform_core::Error>(())
//! ```

mod colour;
mod cover;
mod cutaway;
mod drawing;
pub(crate) mod ground;
mod label;
mod light;
mod map;
mod perspective;
mod pyramid;
mod solid;

use landform_core::grid::Shape;
use serde::{Deserialize, Serialize};

pub use colour::Ramp;
pub(crate) use cutaway::{CutawayView, cutaway};
pub use drawing::{Waters, waters};
pub use map::{MapStyle, difference_map, field_map, shaded_map, value_picture};
pub(crate) use map::{colour_map, field_map_with_legend};
pub(crate) use perspective::BlockView;
pub use perspective::{Standpoint, View, perspective};
pub(crate) use solid::solid;

/// A picture: 8-bit red, green, blue, row-major from the top.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// Rows and columns.
    pub shape: Shape,
    /// Pixels.
    pub pixels: Vec<[u8; 3]>,
}
