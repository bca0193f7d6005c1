//! Ground from a file, for subcommands that measure it.

use std::path::Path;

use landform::core::grid::Edges;
use landform::core::terrain::{HeightField, NodeSurface};
use landform::core::units::Length;
use landform::core::{Error, Result};
use landform::io::format::load_raster;
use landform::io::import::{in_degrees, metres_from_degrees};

/// How elevations without a scale are taken.
#[derive(clap::Args)]
pub(crate) struct Scale {
    /// Distance between samples, such as "30 m", whatever the file says (a picture says nothing).
    #[arg(long)]
    cell_size: Option<String>,
    /// Height from the lowest to the highest sample, such as "1200 m", whatever the file says.
    #[arg(long)]
    relief: Option<String>,
}

/// A file in metres, and what a reader of the numbers should know.
pub(crate) fn load(path: &Path, scale: &Scale) -> Result<(HeightField, Vec<String>)> {
    let mut field = load_raster(path)?;
    let mut notes = Vec::new();
    if let Some(text) = &scale.cell_size {
        let cell = positive("cell_size", text)?;
        field.grid.spacing = [cell, cell];
        field.grid.origin = [0.0, field.grid.extent()[1]];
        field.grid.georeference = Default::default();
    } else if in_degrees(&field) {
        let error = metres_from_degrees(&mut field)?;
        let [dx, dy] = field.grid.spacing;
        notes.push(format!(
            "degrees taken as metres at the middle latitude: cells of {dx:.2} x {dy:.2} m, at most {:.2} % wrong at the sides",
            100.0 * error
        ));
    }
    if let Some(text) = &scale.relief {
        stretch(&mut field, positive("relief", text)?);
    }
    field.grid.edges = Edges::default();
    Ok((field, notes))
}

fn positive(name: &str, text: &str) -> Result<f64> {
    let value = Length::parse(text)?.si();
    if value > 0.0 { Ok(value) } else { Err(Error::parameter(name, text, "> 0 m")) }
}

fn stretch(field: &mut HeightField, relief: f64) {
    let finite = field.elevation().iter().filter(|z| z.is_finite());
    let (lo, hi) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &z| (a.min(z), b.max(z)));
    if hi > lo {
        field.elevation_mut().iter_mut().for_each(|z| *z = (*z - lo) * relief / (hi - lo));
    }
}

/// File name without folders.
pub(crate) fn name(path: &Path) -> String {
    path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}
