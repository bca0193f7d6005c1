//! The list of formats.

use std::path::{Path, PathBuf};

use landform_core::error::nearest;
use landform_core::grid::Grid;
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};

use super::{GeotiffOptions, MeshFile, Sidecar, ascii_grid, exr, geotiff, glb, npy, obj, picture, ply, raw16, stl};
use crate::files::read_whole;

/// A raster to be written.
#[derive(Clone, Debug)]
pub struct RasterFile<'a> {
    /// The grid.
    pub grid: &'a Grid,
    /// Values, row-major from the north-west; NaN is nodata.
    pub values: &'a [f64],
    /// Name of the field.
    pub field: &'a str,
    /// Its unit.
    pub unit: &'a str,
    /// Seed of the recipe, for the sidecar.
    pub seed: u64,
    /// What GeoTIFF lets one choose.
    pub geotiff: GeotiffOptions,
}

impl RasterFile<'_> {
    /// Least and greatest value; (0, 0) without data.
    pub fn range(&self) -> (f64, f64) {
        let finite = self.values.iter().copied().filter(|v| v.is_finite());
        let range = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        if range.0 <= range.1 { range } else { (0.0, 0.0) }
    }
}

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
}

impl RasterFormat {
    /// The sidecar of a file, where the format needs one.
    pub fn sidecar(&self, file: &RasterFile) -> Option<Sidecar> {
        let steps = ["PNG", "PNM", "RAW16"].contains(&self.name).then_some(raw16::STEPS);
        self.needs_sidecar.then(|| Sidecar::describe(file, steps))
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
    },
    RasterFormat {
        extensions: &["asc"],
        name: "ESRI ASCII grid",
        read: ascii_grid::read,
        write: ascii_grid::write,
        needs_sidecar: false,
    },
    RasterFormat { extensions: &["exr"], name: "OpenEXR", read: exr::read, write: exr::write, needs_sidecar: true },
    RasterFormat { extensions: &["npy"], name: "NumPy array", read: npy::read, write: npy::write, needs_sidecar: true },
    RasterFormat {
        extensions: &["png"],
        name: "PNG",
        read: picture::read_png,
        write: picture::write_png16,
        needs_sidecar: true,
    },
    RasterFormat {
        extensions: &["pgm", "ppm", "pnm"],
        name: "PNM",
        read: picture::read_pnm,
        write: picture::write_pgm16,
        needs_sidecar: true,
    },
    RasterFormat {
        extensions: &["r16", "raw"],
        name: "RAW16",
        read: raw16::read,
        write: raw16::write,
        needs_sidecar: true,
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
        PathBuf::from(format!("{}.landform.json", path.display())),
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
