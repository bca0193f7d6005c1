//! Files of rasters and meshes. Every reader accepts hostile bytes: it returns a terrain or an
//! error, and allocates no more memory than a file of that length can fill.
//!
//! ```
//! use std::path::Path;
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::terrain::NodeSurface;
//! use landform_io::format::{RasterFile, raster_format};
//!
//! let grid = Grid::new(Shape::new(2, 3), [10.0, 10.0])?;
//! let values = [0.0, 1.5, 3.0, 4.5, 6.0, f64::NAN];
//! let format = raster_format(Path::new("ground.tif"))?;
//! let bytes = (format.write)(&RasterFile::real(&grid, &values, "elevation", "m", 0))?;
//! let back = format.read(&bytes, None)?;
//! assert_eq!(back.elevation()[..5], values[..5]);
//! assert!(back.elevation()[5].is_nan());
//! # Ok::<(), landform_core::Error>(())
//! ```

mod animation;
mod ascii_grid;
mod beside;
mod exr;
mod geotiff;
mod geotiff_options;
mod glb;
mod mesh;
mod netcdf;
mod node_table;
mod npy;
mod obj;
mod picture;
mod pixels;
mod placement;
mod ply;
mod pnm;
mod raster_file;
mod raw16;
mod reading;
mod said;
mod sidecar;
mod smooth;
mod stl;
mod system;
mod systems;
mod table;
mod volume;
mod vtk;
mod wkt;
mod xml;

pub use animation::{animation_extension, encode_animation};
pub use beside::sidecar_path;
pub(crate) use exr::{write_rgb as write_exr_rgb, write_words as write_exr_words};
pub use geotiff_options::{Compression, DataType, GeotiffOptions};
pub(crate) use mesh::mesh_file_of_cave;
pub use mesh::{
    MeshFile, PointField, Texture, mesh_file_from_height_field, mesh_file_from_mesh, mesh_file_from_voxels,
    mesh_file_of_water,
};
pub(crate) use picture::{encode_bytes, encode_grey, encode_rgba};
pub use picture::{encode_png, read_grey};
pub use raster_file::{RasterFile, Samples, blurred};
pub(crate) use raster_file::{SEEN, has_float64};
pub(crate) use raw16::{STEPS, quantize};
pub use reading::{Reading, UNPLACED};
pub use sidecar::Sidecar;
pub(crate) use systems::{is_geographic, is_in_metres, is_web_mercator};
pub use table::{
    MESH_FORMATS, MeshFormat, RASTER_FORMATS, RasterFormat, load_raster, mesh_format, raster_format,
    raster_format_to_write, read_grid, read_raster,
};
pub(crate) use volume::{Array, VolumeFile, from_the_south, read_volume, write_nrrd};

use landform_core::{Error, Result};

use crate::memory;

/// The most bytes that a file of a given length may unpack to: deflate's best ratio is 1032, and
/// small files may be all alike.
fn most_unpacked(file_length: usize) -> u64 {
    (file_length as u64).saturating_mul(1100).saturating_add(1 << 22)
}

/// Refuses dimensions that a file of this length cannot fill.
fn check_dimensions(
    format: &'static str,
    rows: u64,
    cols: u64,
    bytes_per_sample: u64,
    file_length: usize,
) -> Result<()> {
    if rows == 0 || cols == 0 {
        return Err(Error::format(format, format!("it is {cols} x {rows} samples")));
    }
    let bytes = rows.checked_mul(cols).and_then(|n| n.checked_mul(bytes_per_sample));
    match bytes {
        Some(b) if b <= most_unpacked(file_length) && rows * cols < u64::from(u32::MAX) => {
            // Samples as they are stored, and as numbers of eight bytes.
            memory::require(format, &format!("a raster of {cols} x {rows} samples"), b + 8 * rows * cols)
        }
        _ => Err(Error::format(
            format,
            format!("it claims {cols} x {rows} samples, more than {file_length} bytes can hold"),
        )),
    }
}
