//! Ground from a file, for subcommands that measure it.

use std::path::Path;

use landform::core::grid::{Edges, Grid};
use landform::core::terrain::{HeightField, Interpolation, Layer, NodeSurface, resample};
use landform::core::units::Length;
use landform::core::{Error, Result};
use landform::io::format::{Reading, UNPLACED, read_raster};
use landform::io::import::{in_degrees, mercator_stretch, metres_from_degrees, stretch_text};

/// Units of web maps that are longer than metres by less than this are metres.
const MOST_STRETCH: f64 = 1.001;

/// How elevations without a scale are taken.
#[derive(clap::Args)]
pub(crate) struct Scale {
    /// Distance between samples, such as "30 m", instead of the file's own (a picture has none).
    #[arg(long)]
    cell_size: Option<String>,
    /// Height from the lowest to the highest sample, such as "1200 m", instead of the file's own.
    #[arg(long)]
    relief: Option<String>,
}

impl Scale {
    /// Whether any scale is given.
    pub(crate) fn is_given(&self) -> bool {
        self.cell_size.is_some() || self.relief.is_some()
    }
}

/// Ground in metres.
pub(crate) struct Ground {
    /// The ground.
    pub(crate) field: HeightField,
    /// Notes to the reader of the numbers.
    pub(crate) notes: Vec<String>,
    /// The raster as the file has it.
    pub(crate) grid: Grid,
}

/// A file in metres.
pub(crate) fn load(path: &Path, scale: &Scale) -> Result<Ground> {
    let Reading { mut field, mut notes } = read_raster(path)?;
    let grid = field.grid().clone();
    if let Some(text) = &scale.cell_size {
        let cell = positive("cell_size", text)?;
        let mut square = Grid { spacing: [cell, cell], georeference: Default::default(), ..field.grid().clone() };
        square.origin = [0.0, square.extent()[1]];
        field.set_grid(square)?;
        notes.retain(|note| note != UNPLACED);
    } else if in_degrees(&grid) {
        let mut in_metres = grid.clone();
        let error = metres_from_degrees(&mut in_metres)?;
        field.set_grid(in_metres)?;
        let [dx, dy] = field.grid().spacing;
        notes.push(format!(
            "degrees taken as metres at the middle latitude: cells of {dx:.2} x {dy:.2} m, at most {:.2} % wrong at the sides",
            100.0 * error
        ));
        if (dx / dy - 1.0).abs() > 0.01 && field.grid().shape.rows > 1 && field.grid().shape.cols > 1 {
            let side = (dx * dy).sqrt();
            field = resample(&field, &field.grid().with_cell_size(side)?, Interpolation::Linear)?;
            notes.push(format!("brought to square cells of {side:.2} m, as those that the natural ranges were measured on (slopes fall by 1 to 4 %)"));
        }
    }
    if let Some(stretch) = mercator_stretch(field.grid()).filter(|s| *s > MOST_STRETCH) {
        notes.push(format!("it is in EPSG:3857, {}; warp it to UTM first", stretch_text(stretch)));
    }
    if let Some(text) = &scale.relief {
        stretch(&mut field, positive("relief", text)?);
    }
    field.set_grid(Grid { edges: Edges::default(), ..field.grid().clone() })?;
    Ok(Ground { field, notes, grid })
}

/// A number of the card, or a dash.
pub(crate) fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:.4}") } else { "–".into() }
}

/// A length above 0 and of this Earth.
pub(crate) fn positive(name: &str, text: &str) -> Result<f64> {
    let value = Length::parse(text)?.si();
    if value > 0.0 && value < 1e9 { Ok(value) } else { Err(Error::parameter(name, text, "> 0 m and less than 1e9 m")) }
}

fn stretch(field: &mut HeightField, relief: f64) {
    let finite = field.elevation().iter().filter(|z| z.is_finite());
    let (lo, hi) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &z| (a.min(z), b.max(z)));
    if hi > lo {
        let scale = relief / (hi - lo);
        field.change(Layer::Bedrock, |z| z.iter_mut().for_each(|z| *z = (*z - lo) * scale));
    }
}

/// File name without folders.
pub(crate) fn name(path: &Path) -> String {
    path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}
