//! What lies beside a raster file and speaks of it: sidecars, notes of GDAL and ArcGIS, world
//! files, projections, masks.

use std::path::{Path, PathBuf};

use landform_core::grid::{Registration, Shape};
use landform_core::{Error, Result};

use super::geotiff::read_mask;
use super::placement::Placement;
use super::reading::Beside;
use super::said::Said;
use super::xml::{attribute, element, elements, plain};
use super::{Sidecar, wkt};
use crate::files::read_whole;

/// Texts beside a file that are longer than this speak of something else.
const MOST_BYTES: u64 = 1 << 22;

/// Where the sidecar of a file is written: beside it, by its full name.
pub fn sidecar_path(path: &str) -> String {
    format!("{path}.landform.json")
}

/// A sidecar that was found.
#[derive(Default)]
pub(super) struct Found {
    /// It and where it lies.
    pub(super) sidecar: Option<(PathBuf, Sidecar)>,
    /// What is not certain of it.
    pub(super) notes: Vec<String>,
}

/// The sidecar of a file.
///
/// # Errors
/// [`Error::Format`] for a sidecar of this program's making that cannot be read.
pub(super) fn sidecar(path: &Path) -> Result<Found> {
    let own = [PathBuf::from(sidecar_path(&path.display().to_string())), path.with_extension("landform.json")];
    if let Some(at) = own.into_iter().find(|p| p.is_file()) {
        let sidecar = Sidecar::parse(&read_whole(&at)?).map_err(|e| e.in_file(&at))?;
        return Ok(Found { sidecar: Some((at, sidecar)), notes: Vec::new() });
    }
    let foreign = path.with_extension("json");
    let Some(text) = small(&foreign) else { return Ok(Found::default()) };
    let name = file_name(&foreign);
    let Ok(sidecar) = Sidecar::parse(text.as_bytes()) else {
        let notes = vec![format!("{name} beside it was not used: it is no sidecar")];
        return Ok(Found { sidecar: None, notes });
    };
    // What says nothing of a raster is not one's sidecar.
    let is_blank = Sidecar { program: None, ..sidecar.clone() } == Sidecar::default();
    if is_blank {
        return Ok(Found::default());
    }
    let is_ours = sidecar.program.as_deref().is_some_and(|p| p.starts_with("landform"));
    let notes = if is_ours { Vec::new() } else { vec![format!("{name} beside it was used as its sidecar")] };
    Ok(Found { sidecar: Some((foreign, sidecar)), notes })
}

/// All else that lies beside a file of this shape.
///
/// # Errors
/// [`Error::Format`] where its place is rotated, or its mask cannot be read.
pub(super) fn look(format: &'static str, path: &Path, shape: Shape) -> Result<Beside> {
    let mut beside = Beside::default();
    if let Some(text) = small(&appended(path, "aux.xml")) {
        beside.said.push(notes_of_gdal(format, &text, shape)?);
    }
    for world in world_paths(path) {
        if let Some(text) = small(&world) {
            match world_file(format, &text, shape)? {
                Some(placement) => beside.said.push(Said { placement: Some(placement), ..Said::default() }),
                None => beside.notes.push(format!("{} was not used: it is no world file", file_name(&world))),
            }
        }
    }
    if let Some(text) = small(&path.with_extension("prj")) {
        match wkt::system(&text) {
            Some(system) => beside.said.push(Said { system: Some(system), ..Said::default() }),
            None => beside.notes.push(format!(
                "{} was not used: it is no well-known text of a coordinate system",
                file_name(&path.with_extension("prj"))
            )),
        }
    }
    let mask = appended(path, "msk");
    if mask.is_file() {
        beside.valid = Some(read_mask(&read_whole(&mask)?).map_err(|e| e.in_file(&mask))?);
    }
    Ok(beside)
}

/// A small text file; none if there is none, or it is something else.
fn small(path: &Path) -> Option<String> {
    let size = std::fs::metadata(path).ok().filter(std::fs::Metadata::is_file)?.len();
    if size > MOST_BYTES {
        return None;
    }
    Some(String::from_utf8_lossy(&read_whole(path).ok()?).into_owned())
}

fn file_name(path: &Path) -> String {
    path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}

fn appended(path: &Path, ending: &str) -> PathBuf {
    PathBuf::from(format!("{}.{ending}", path.display()))
}

/// Names of world files: `dem.tfw`, `dem.tifw`, `dem.wld`.
fn world_paths(path: &Path) -> Vec<PathBuf> {
    let extension = path.extension().map(|e| e.to_string_lossy().into_owned()).unwrap_or_default();
    let (first, last) = (extension.chars().next(), extension.chars().next_back());
    let short = first.zip(last).map(|(a, b)| format!("{a}{b}w"));
    short.into_iter().chain([format!("{extension}w"), "wld".into()]).map(|e| path.with_extension(e)).collect()
}

/// Six numbers: cells, shears, and the middle of the first pixel.
fn world_file(format: &'static str, text: &str, shape: Shape) -> Result<Option<Placement>> {
    let numbers: Option<Vec<f64>> = text.split_whitespace().map(|w| w.replace(',', ".").parse().ok()).collect();
    let Some([dx, col_y, row_x, dy, x, y]) = numbers.as_deref() else { return Ok(None) };
    let transform = [*x, *dx, *row_x, *y, *col_y, *dy];
    let mut placement = Placement::of_transform(format, transform, shape, Registration::Point)?;
    placement.registration = Registration::Area;
    Ok(Some(placement))
}

fn notes_of_gdal(format: &'static str, text: &str, shape: Shape) -> Result<Said> {
    let transform: Option<Vec<f64>> = element(text, "GeoTransform")
        .and_then(|(_, numbers)| numbers.split(',').map(|n| n.trim().parse().ok()).collect());
    let transform = transform.and_then(|t| <[f64; 6]>::try_from(t).ok());
    let placement = transform.map(|t| Placement::of_transform(format, t, shape, Registration::Area)).transpose()?;
    let mut bands = elements(text, "PAMRasterBand");
    let band = bands.find(|(a, _)| attribute(a, "band").is_none_or(|b| b == "1")).map_or("", |(_, body)| body);
    let number = |name: &str| element(band, name).and_then(|(_, text)| text.trim().parse::<f64>().ok());
    let finite = |name: &str| number(name).filter(|v| v.is_finite());
    Ok(Said {
        nodata: number("NoDataValue"),
        scale: finite("Scale"),
        offset: finite("Offset"),
        unit: element(band, "UnitType").map(|(_, text)| plain(text)),
        placement,
        system: element(text, "SRS").and_then(|(_, text)| wkt::system(&plain(text))),
        south_first: false,
    })
}

/// An error that names its file.
pub(super) trait InFile {
    fn in_file(self, path: &Path) -> Self;
}

impl InFile for Error {
    fn in_file(self, path: &Path) -> Self {
        match self {
            Self::Format { format, what, hint } => {
                Self::Format { format, what: format!("{what} ({})", path.display()), hint }
            }
            Self::Empty { .. } => Self::Empty { what: path.display().to_string() },
            other => other,
        }
    }
}
