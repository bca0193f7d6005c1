//! A raster to be written.

use landform_core::grid::Grid;

use super::GeotiffOptions;

/// Kind of the values of a raster.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Samples {
    /// Real numbers.
    #[default]
    Real,
    /// Counts and identifiers, as 32-bit whole numbers.
    Counts,
    /// Classes, as bytes.
    Classes,
}

/// A raster to be written.
#[derive(Clone, Debug)]
pub struct RasterFile<'a> {
    /// The grid.
    pub grid: &'a Grid,
    /// Values, in `unit`, row-major from the north-west; NaN is nodata.
    pub values: &'a [f64],
    /// Name of the field.
    pub field: &'a str,
    /// Its unit.
    pub unit: &'a str,
    /// What the values are, and so how they are stored.
    pub samples: Samples,
    /// Names of classes, where the values are classes.
    pub legend: Vec<(u8, String)>,
    /// Seed of the recipe, for the sidecar.
    pub seed: u64,
    /// Options of GeoTIFF.
    pub geotiff: GeotiffOptions,
    /// Least and greatest value of the whole that this is a part of, over which steps are spread;
    /// if none, they are its own.
    pub spread: Option<[f64; 2]>,
}

impl<'a> RasterFile<'a> {
    /// Real numbers, with the usual options.
    pub fn real(grid: &'a Grid, values: &'a [f64], field: &'a str, unit: &'a str, seed: u64) -> Self {
        let (samples, legend, geotiff) = (Samples::Real, Vec::new(), GeotiffOptions::default());
        Self { grid, values, field, unit, samples, legend, seed, geotiff, spread: None }
    }
}

impl RasterFile<'_> {
    /// Whether some values are missing.
    pub fn has_nodata(&self) -> bool {
        self.values.iter().any(|v| !v.is_finite())
    }

    /// Whether 32-bit floats would blur the values by more than a part of their range.
    pub fn needs_float64(&self, part: f64) -> bool {
        let (lo, hi) = self.range();
        let blur = |v: &f64| (v - f64::from(*v as f32)).abs();
        hi > lo && self.values.iter().filter(|v| v.is_finite()).any(|v| blur(v) > part * (hi - lo))
    }

    /// What is lost where these values become 32-bit floats.
    fn blur_text(&self, path: &str) -> String {
        let (lo, hi) = self.range();
        let most = lo.abs().max(hi.abs()) as f32;
        let step = f64::from(most.next_up()) - f64::from(most);
        format!("{path} holds 32-bit floats: heights from {lo} to {hi} m come out in steps of {step} m")
    }

    /// Least and greatest value, in `unit`, of the whole that it is a part of; (0, 0) without data.
    pub fn range(&self) -> (f64, f64) {
        if let Some([least, greatest]) = self.spread {
            return (least, greatest);
        }
        let finite = self.values.iter().copied().filter(|v| v.is_finite());
        let range = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        if range.0 <= range.1 { range } else { (0.0, 0.0) }
    }
}

/// Part of the range of heights by which a blur is seen.
pub(crate) const SEEN: f64 = 1e-4;

/// What a file of this name loses of a raster's values, if 32-bit floats are all that its format
/// has and they blur them.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_io::format::{RasterFile, blurred};
///
/// let grid = Grid::new(Shape::new(1, 2), [10.0, 10.0])?;
/// let file = RasterFile::real(&grid, &[1e6, 1e6 + 0.01], "elevation", "m", 0);
/// assert!(blurred("a.glb", &file).is_some_and(|note| note.contains("steps of 0.0625 m")));
/// assert_eq!(blurred("a.tif", &file), None);
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn blurred(path: &str, file: &RasterFile) -> Option<String> {
    let is_narrow = ends_with_one_of(path, &[".exr", ".glb", ".stl"]);
    (is_narrow && file.needs_float64(SEEN)).then(|| file.blur_text(path))
}

/// Whether the format of a file of this name has 64-bit floats.
pub(crate) fn has_float64(path: &str) -> bool {
    ends_with_one_of(path, &[".tif", ".tiff", ".asc", ".npy", ".nc"])
}

fn ends_with_one_of(path: &str, ends: &[&str]) -> bool {
    let path = path.to_lowercase();
    ends.iter().any(|end| path.ends_with(end))
}
