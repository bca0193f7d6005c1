//! The list of formats.

use std::path::Path;

use landform_core::grid::{Grid, Shape};
use landform_core::terrain::HeightField;
use landform_core::{Error, Result};

use super::beside::{Found, InFile};
use super::reading::{Beside, Reading, decide, decide_grid};
use super::said::Stored;
use super::{
    MeshFile, RasterFile, Samples, Sidecar, ascii_grid, beside, exr, geotiff, glb, netcdf, node_table, npy, obj,
    picture, ply, raw16, stl, vtk,
};
use crate::files::read_whole;

/// Finds what a file's bytes say, but for the numbers.
type ReadHeader = fn(&[u8]) -> Result<Stored>;

/// A format of rasters.
#[derive(Debug)]
pub struct RasterFormat {
    /// File extensions, lower case, without dot.
    pub extensions: &'static [&'static str],
    /// What it is called.
    pub name: &'static str,
    /// Finds what a file's bytes say; a sidecar tells the size of those that do not.
    stored: fn(&[u8], Option<&Sidecar>) -> Result<Stored>,
    /// Finds the same but the numbers, where that is faster.
    header: Option<ReadHeader>,
    /// Writes a file's bytes.
    pub write: fn(&RasterFile) -> Result<Vec<u8>>,
    /// Whether the numbers need a sidecar to be understood.
    pub needs_sidecar: bool,
    /// Whether real numbers are stored as 16-bit steps over their range.
    pub is_stepped: bool,
}

impl RasterFormat {
    /// Reads a file's bytes, helped by its sidecar if there is one.
    ///
    /// # Errors
    /// [`Error::Format`], or [`Error::Empty`] without any data.
    pub fn read(&self, bytes: &[u8], sidecar: Option<&Sidecar>) -> Result<HeightField> {
        let stored = (self.stored)(bytes, sidecar)?;
        let said = sidecar.map(|s| s.said(stored.shape)).transpose()?;
        let beside = Beside { said: said.into_iter().collect(), ..Beside::default() };
        decide(self.name, stored, beside).map(|reading| reading.field)
    }

    /// The sidecar beside a file that is read, where the format needs one.
    fn beside(&self, path: &Path) -> Result<Found> {
        if self.needs_sidecar { beside::sidecar(path) } else { Ok(Found::default()) }
    }

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
        stored: geotiff::read,
        header: Some(geotiff::read_header),
        write: geotiff::write,
        needs_sidecar: false,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["asc"],
        name: "ESRI ASCII grid",
        stored: ascii_grid::read,
        header: Some(ascii_grid::read_header),
        write: ascii_grid::write,
        needs_sidecar: false,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["exr"],
        name: "OpenEXR",
        stored: exr::read,
        header: None,
        write: exr::write,
        needs_sidecar: true,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["npy"],
        name: "NumPy array",
        stored: npy::read,
        header: Some(npy::read_header),
        write: npy::write,
        needs_sidecar: true,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["nc"],
        name: "netCDF",
        stored: netcdf::read,
        header: None,
        write: netcdf::write,
        needs_sidecar: false,
        is_stepped: false,
    },
    RasterFormat {
        extensions: &["png"],
        name: "PNG",
        stored: picture::read_png,
        header: None,
        write: picture::write_png,
        needs_sidecar: true,
        is_stepped: true,
    },
    RasterFormat {
        extensions: &["pgm", "ppm", "pnm"],
        name: "PNM",
        stored: picture::read_pnm,
        header: None,
        write: picture::write_pgm,
        needs_sidecar: true,
        is_stepped: true,
    },
    RasterFormat {
        extensions: &["r16", "raw"],
        name: "RAW16",
        stored: raw16::read,
        header: None,
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
    MeshFormat { extension: "vtk", name: "VTK", write: vtk::write },
    MeshFormat { extension: "csv", name: "table of nodes", write: node_table::write },
];

fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

fn unknown(path: &Path, known: &[&'static str]) -> Error {
    Error::extension("path", &path.display().to_string(), known)
}

/// The raster format of a path.
///
/// # Errors
/// [`Error::Extension`] with the extensions that are known.
pub fn raster_format(path: &Path) -> Result<&'static RasterFormat> {
    let wanted = extension(path);
    RASTER_FORMATS.iter().find(|f| f.extensions.contains(&wanted.as_str())).ok_or_else(|| {
        let known: Vec<_> = RASTER_FORMATS.iter().flat_map(|f| f.extensions).copied().collect();
        unknown(path, &known)
    })
}

/// The raster format of a path that is written.
///
/// # Errors
/// As [`raster_format`], and for `.ppm`, which holds colours.
pub fn raster_format_to_write(path: &Path) -> Result<&'static RasterFormat> {
    if extension(path) == "ppm" {
        let value = format!("\"{}\", a file of colours", path.display());
        return Err(Error::parameter("path", value, "a name that ends with .pgm: elevations are grey"));
    }
    raster_format(path)
}

/// The mesh format of a path.
///
/// # Errors
/// [`Error::Extension`] with the extensions that are known.
pub fn mesh_format(path: &Path) -> Result<&'static MeshFormat> {
    let wanted = extension(path);
    MESH_FORMATS.iter().find(|f| f.extension == wanted).ok_or_else(|| {
        let known: Vec<_> = MESH_FORMATS.iter().map(|f| f.extension).collect();
        unknown(path, &known)
    })
}

/// Reads a raster from disk, with what lies beside it: its sidecar where the format needs one
/// (`name.ext.landform.json`, `name.landform.json` or `name.json`), `.aux.xml`, world file, `.prj`
/// and `.msk`.
///
/// # Errors
/// [`Error::Io`], [`Error::Format`] or [`Error::Empty`], naming the file.
pub fn read_raster(path: &Path) -> Result<Reading> {
    let format = raster_format(path)?;
    let bytes = read_whole(path)?;
    let found = format.beside(path)?;
    let read = || {
        let stored = (format.stored)(&bytes, found.sidecar.as_ref().map(|s| &s.1))?;
        let beside = look(format, path, found, stored.shape)?;
        decide(format.name, stored, beside)
    };
    read().map_err(|e| e.in_file(path))
}

/// The grid that [`read_raster`] gives a file, without its samples; none where they must be read to
/// find it.
///
/// ```
/// # let path = std::env::temp_dir().join(format!("landform-grid-{}.asc", std::process::id()));
/// let text = "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 30\n100 120\n";
/// std::fs::write(&path, text).expect("a folder for temporary files");
/// let grid = landform_io::format::read_grid(&path)?.expect("a header");
/// assert_eq!((grid.shape.cols, grid.spacing), (2, [30.0, 30.0]));
/// # std::fs::remove_file(&path).ok();
/// # Ok::<(), landform_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Io`] or [`Error::Format`], naming the file.
pub fn read_grid(path: &Path) -> Result<Option<Grid>> {
    let format = raster_format(path)?;
    let Some(header) = format.header else { return Ok(None) };
    let bytes = read_whole(path)?;
    let found = format.beside(path)?;
    let read = || {
        let stored = header(&bytes)?;
        let beside = look(format, path, found, stored.shape)?;
        decide_grid(format.name, stored, beside)
    };
    read().map(Some).map_err(|e| e.in_file(path))
}

/// What lies beside a file of this shape.
fn look(format: &RasterFormat, path: &Path, found: Found, shape: Shape) -> Result<Beside> {
    let Found { sidecar, mut notes } = found;
    let said = sidecar.map(|(at, s)| s.said(shape).map_err(|e| e.in_file(&at))).transpose()?;
    let mut beside = beside::look(format.name, path, shape)?;
    beside.said.splice(0..0, said);
    notes.append(&mut beside.notes);
    Ok(Beside { notes, ..beside })
}

/// As [`read_raster`], without its notes.
///
/// # Errors
/// As [`read_raster`].
pub fn load_raster(path: &Path) -> Result<HeightField> {
    read_raster(path).map(|reading| reading.field)
}
