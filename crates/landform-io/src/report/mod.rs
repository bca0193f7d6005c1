//! The report: one HTML file that opens offline, in light and dark, on paper too.

mod card;
mod comparison;
mod history;
mod page;
mod pictures;
mod plot;
mod sections;

use landform_core::Result;
use landform_core::analysis::{CardLine, Drawings, Metrics, Verdict, metrics, report_card, verdict};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::verb::Landscape;
use serde::Serialize;

pub use comparison::{ComparisonReport, compare_reports};
use page::page;
pub(crate) use pictures::{field_pictures, spectrum_picture};

/// Measures of a landscape, with its report card.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::random::Seed;
/// use landform_core::terrain::HeightField;
/// use landform_io::report::Analysis;
///
/// let grid = Grid::new(Shape::new(16, 21), [100.0, 100.0])?;
/// let rough = (0..336).map(|i| 50.0 * Seed(1).uniform(i)).collect();
/// let analysis = Analysis::of(&HeightField::new(grid, rough)?, None)?;
/// assert_eq!(analysis.metrics.elevations.nodes, 336);
/// assert!(analysis.json().contains("\"verdict\""));
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct Analysis {
    /// In a few words and why.
    pub verdict: Verdict,
    /// Line by line.
    pub card: Vec<CardLine>,
    /// All measures.
    pub metrics: Metrics,
    /// The plot of the spectrum.
    #[serde(skip)]
    pub drawings: Option<Drawings>,
}

impl Analysis {
    /// Measures a raster; with a `sea_level` (m), the ground above it.
    ///
    /// # Errors
    /// Where [`metrics`] fails.
    pub fn of(raster: &HeightField, sea_level: Option<f64>) -> Result<Self> {
        let (metrics, drawings) = metrics(raster, sea_level)?;
        let card = report_card(&metrics);
        Ok(Self { verdict: verdict(&metrics, &card), card, metrics, drawings: Some(drawings) })
    }

    /// As JSON with line breaks. Numbers that could not be measured are null.
    pub fn json(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }
}

/// The report of a landscape. `raster` is the terrain itself, or the raster made of it; `analysis`
/// was measured on it.
///
/// # Errors
/// If a picture cannot be drawn.
pub fn report<T: NodeSurface>(
    landscape: &Landscape<'_, T>,
    raster: &HeightField,
    analysis: &Analysis,
) -> Result<String> {
    let small = pictures::shrunk(raster)?;
    let body = [
        pictures::perspective_figure(&small)?,
        card::section(analysis),
        "<h2>Map</h2>".into(),
        pictures::map_figure(&small)?,
        sections::elevations(&analysis.metrics),
        sections::surface(&analysis.metrics),
        sections::drainage(&analysis.metrics),
        sections::roughness(&analysis.metrics, pictures::spectrum_figure(analysis.drawings.as_ref())?),
        sections::coast(&analysis.metrics),
        "<h2>Maps</h2>".into(),
        pictures::field_figures(&small)?,
        history::section(landscape.history, landscape.seed),
        history::sources(landscape.history, sections::SOURCES),
    ]
    .concat();
    Ok(page(landscape.title, &body))
}
