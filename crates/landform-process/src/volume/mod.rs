//! Ground in voxels: made from a raster, hollowed out, and turned into a raster again.
//!
//! A passage through a ridge leaves the raster above it as it is:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::{Ground, HeightField};
//! use landform_core::units::Length;
//! use landform_core::verb::{Context, Convert, Edit};
//! use landform_process::volume::{ToVoxels, Tunnel};
//!
//! let plain = HeightField::new(Grid::new(Shape::new(21, 21), [2.0; 2])?, vec![60.0; 441])?;
//! let mut ground = ToVoxels { depth: Length::of(40.0), ..ToVoxels::default() }.convert(&plain)?;
//! let ends = [[0.0, 20.0, 40.0], [40.0, 20.0, 40.0]];
//! Tunnel { along: ends.map(|end| end.map(Length::of)).to_vec(), radius: Length::of(5.0) }
//!     .edit(&mut ground, &Context::default())?;
//! assert_eq!(ground.height_at([20.0, 20.0]), Some(60.0));
//! assert!(ground.hit([2.0, 20.0, 40.0], [38.0, 20.0, 40.0]).is_none(), "one sees through");
//! # Ok::<(), landform_core::Error>(())
//! ```

mod rock;
mod to_voxels;
mod tunnel;
mod tunnels;
mod uppermost_surface;

use landform_core::terrain::{HeightField, VoxelGrid};

pub use rock::{BlockParams, FractureParams, RockBed, RockVolume, SphereParams};
pub use to_voxels::ToVoxels;
pub use tunnel::Tunnel;
pub use tunnels::{Around, Sections, Tunnels};
pub use uppermost_surface::UppermostSurface;

landform_core::stages! {
    generate RockVolume => VoxelGrid;
    convert ToVoxels where HeightField => VoxelGrid;
    edit Tunnel where VoxelGrid;
    convert Tunnels where HeightField => VoxelGrid;
    convert UppermostSurface where VoxelGrid => HeightField;
}
