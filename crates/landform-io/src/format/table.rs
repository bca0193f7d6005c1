//! The list of formats.

use std::path::{Path, PathBuf};

use landform_core::error::nearest;
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};

use super::{
    MeshFile, RasterFile, Samples, Sidecar, ascii_grid, exr, geotiff, glb, npy, obj, picture, ply, raw16, stl,
};
use crate::files::read_whole;

/// A format of rasters.
#[derive(Debug)]
pub struct RasterFormat {
    /// File extensions, lower case, without dot.
    pub extensions: &'static [&'static str],
    /// What it is called.
    pub name: &'static str,
    /// Reads a file's bytes, helped by its sidecar if there is one.
    pub read: fn(&[u8], Option<&Sidecar>) -> Result<HeightField>,
    /// Writes a file's bytes.
    pub write: fn(&RasterFile) -> Result<Vec<u8>>,
    /// Whether the numbers need a sidecar to be understood.
    pub needs_sidecar: bool,
    /// Whether real numbers are stored as 16-bit steps over their range.
    pub is_stepped: bool,
}

impl RasterFormat {
    /// The sidecar of a file, where the format needs one.
    pub fn sidecar(&self, file: &RasterFile) -> Option<Sidecar> {
        let stored = self.is_stepped && file.samples != Samples::Classes;
        self.needs_sidecar.then(|| Sidecar::describe(file, stored.then_some(raw16::STEPS)))
    }
}

/// All formats of rasters.
pub static RASTER_FORMATS: &[RasterFormat] = &[
    RasterFormat {
        extensions: &["tif", "tiff"],
        name: "GeoTIFF",
        read: geotiff::read,
        write: geotiff::write,
        needs_sidecar: false,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["asc"],
        name: "ESRI ASCII grid",
        read: ascii_grid::read,
        write: ascii_grid::write,
        needs_sidecar: false,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["exr"],
        name: "OpenEXR",
        read: exr::read,
        write: exr::write,
        needs_sidecar: true,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["npy"],
        name: "NumPy array",
        read: npy::read,
        write: npy::write,
        needs_sidecar: true,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["png"],
        name: "PNG",
        read: picture::read_png,
        write: picture::write_png,
        needs_sidecar: true,
        is_stepped: true,
    },
    RasterFormat {
        extensions: &["pgm", "ppm", "pnm"],
        name: "PNM",
        read: picture::read_pnm,
        write: picture::write_pgm,
        needs_sidecar: true,
        is_stepped: true,
    },
    RasterFormat {
        extensions: &["r16", "raw"],
        name: "RAW16",
        read: raw16::read,
        write: raw16::write,
        needs_sidecar: true,
        is_stepped: true,
    },
];

/// A format of meshes (written only).
#[derive(Debug)]
pub struct MeshFormat {
    /// File extension, lower case, without dot.
    pub extension: &'static str,
    /// What it is called.
    pub name: &'static str,
    /// Writes a file's bytes.
    pub write: fn(&MeshFile) -> Result<Vec<u8>>,
}

/// All formats of meshes.
pub static MESH_FORMATS: &[MeshFormat] = &[
    MeshFormat { extension: "glb", name: "glTF binary", write: glb::write },
    MeshFormat { extension: "obj", name: "Wavefront OBJ", write: obj::write },
    MeshFormat { extension: "ply", name: "PLY", write: ply::write },
    MeshFormat { extension: "stl", name: "STL", write: stl::write },
];

fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

fn unknown(path: &Path, known: &[&str]) -> Error {
    let near = nearest(&extension(path), known.iter().copied()).map(|n| format!(" (.{n}?)")).unwrap_or_default();
    let expected = format!("a name that ends with one of .{}{near}", known.join(", ."));
    Error::parameter("path", format!("\"{}\"", path.display()), &expected)
}

/// The raster format of a path.
///
/// # Errors
/// [`Error::Format`] with the extensions that are known.
pub fn raster_format(path: &Path) -> Result<&'static RasterFormat> {
    let wanted = extension(path);
    RASTER_FORMATS.iter().find(|f| f.extensions.contains(&wanted.as_str())).ok_or_else(|| {
        let known: Vec<_> = RASTER_FORMATS.iter().flat_map(|f| f.extensions).copied().collect();
        unknown(path, &known)
    })
}

/// The mesh format of a path.
///
/// # Errors
/// [`Error::Format`] with the extensions that are known.
pub fn mesh_format(path: &Path) -> Result<&'static MeshFormat> {
    let wanted = extension(path);
    MESH_FORMATS.iter().find(|f| f.extension == wanted).ok_or_else(|| {
        let known: Vec<_> = MESH_FORMATS.iter().map(|f| f.extension).collect();
        unknown(path, &known)
    })
}

/// Where the sidecar of a file is written: beside it, by its full name.
pub fn sidecar_path(path: &str) -> String {
    format!("{path}.landform.json")
}

/// Reads a raster from disk, with its sidecar if there is one (`name.ext.landform.json`, `name.landform.json` or
/// `name.json` beside it).
///
/// # Errors
/// [`Error::Io`] or [`Error::Format`], naming the file.
pub fn load_raster(path: &Path) -> Result<HeightField> {
    let format = raster_format(path)?;
    let bytes = read_whole(path)?;
    let sidecar = sidecar_paths(path).into_iter().find(|p| p.is_file()).map(|p| {
        let text = read_whole(&p)?;
        Sidecar::parse(&text).map_err(|e| named(e, &p))
    });
    (format.read)(&bytes, sidecar.transpose()?.as_ref()).map_err(|e| named(e, path))
}

fn sidecar_paths(path: &Path) -> [PathBuf; 3] {
    [
        PathBuf::from(sidecar_path(&path.display().to_string())),
        path.with_extension("landform.json"),
        path.with_extension("json"),
    ]
}

/// The error with the file's name in it.
fn named(error: Error, path: &Path) -> Error {
    match error {
        Error::Format { format, what, hint } => {
            Error::Format { format, what: format!("{what} ({})", path.display()), hint }
        }
        Error::Empty { .. } => Error::Empty { what: path.display().to_string() },
        other => other,
    }
}
