//! A swath across the land as a table.
//!
//! # Method
//! Every node within half the width of the line belongs to the bin that the foot of its
//! perpendicular lies in. Quantiles are linear between nodes in order of height.

use std::fmt::Write;

use landform_core::terrain::{NodeSurface, Rasterize};
use landform_core::units::Length;
use landform_core::verb::{Export, Landscape, Output, Params, Source, check_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Writes a swath profile as a table (CSV): elevation in a band along a line, for each step the
/// number of nodes, least, quarter, mean, median, three quarters and greatest.
///
/// ```
/// use landform_core::verb::Params;
/// use landform_io::export::WriteSwath;
///
/// assert_eq!(WriteSwath::default().outputs(), ["swath.csv"]);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteSwath {
    /// Path below the output folder.
    pub path: String,
    /// Where the line begins and where it ends, east and north. If not given, it leads from the
    /// middle of the west side to that of the east side.
    pub points: Vec<[Length; 2]>,
    /// Width of the band.
    #[schemars(extend("x-above" = 0.0))]
    pub width: Length,
    /// Length of a step along the line. If not given, the larger side of a cell.
    #[schemars(extend("x-above" = 0.0))]
    pub step: Option<Length>,
}

impl Default for WriteSwath {
    fn default() -> Self {
        Self { path: "swath.csv".into(), points: Vec::new(), width: Length::of(1000.0), step: None }
    }
}

impl Params for WriteSwath {
    const NAME: &'static str = "write_swath";
    const SOURCES: &'static [Source] = &[];

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone()]
    }

    fn check(&self) -> Result<()> {
        check_path(&self.path, &["csv"])?;
        if ![0, 2].contains(&self.points.len()) {
            return Err(Error::parameter("points", format!("{} places", self.points.len()), "two places"));
        }
        Ok(())
    }
}

/// The most steps of a table.
const MOST_STEPS: f64 = 1e6;

/// The value a part of the way through sorted numbers.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let at = part * (sorted.len() - 1) as f64;
    let (low, high) = (at.floor() as usize, at.ceil() as usize);
    sorted[low] + (sorted[high] - sorted[low]) * (at - low as f64)
}

impl<T: Rasterize> Export<T> for WriteSwath {
    fn export(&self, landscape: &Landscape<'_, T>, out: &mut dyn Output) -> Result<()> {
        let field = landscape.terrain.rasterized()?;
        let [lo, hi] = field.bounds();
        let middle = 0.5 * (lo[1] + hi[1]);
        let (from, to) = match self.points[..] {
            [from, to] => (from.map(Length::si), to.map(Length::si)),
            _ => ([lo[0], middle], [hi[0], middle]),
        };
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
        if !(length > 0.0 && length.is_finite()) {
            return Err(Error::parameter("points", "one place twice", "two places"));
        }
        let [dx, dy] = field.grid().spacing;
        let step = self.step.map_or(dx.max(dy), Length::si);
        let steps = (length / step).ceil().max(1.0);
        if !(steps <= MOST_STEPS) {
            return Err(Error::parameter("step", format!("{step} m on {length} m"), "at most a million steps"));
        }
        let mut bins: Vec<Vec<f64>> = vec![Vec::new(); steps as usize];
        let along = [way[0] / length, way[1] / length];
        for (i, &z) in field.elevation().iter().enumerate().filter(|(_, z)| !z.is_nan()) {
            let [x, y] = field.grid().position(i);
            let off = [x - from[0], y - from[1]];
            let (t, side) = (off[0] * along[0] + off[1] * along[1], off[0] * along[1] - off[1] * along[0]);
            if side.abs() <= 0.5 * self.width.si() && (0.0..=length).contains(&t) {
                let last = bins.len() - 1;
                bins[((t / step) as usize).min(last)].push(z);
            }
        }
        if bins.iter().all(Vec::is_empty) {
            return Err(Error::parameter("points", "a line that meets no node with data", "a line over the land"));
        }
        let mut text = String::from("distance_m,nodes,least_m,quarter_m,mean_m,median_m,three_quarters_m,greatest_m\n");
        for (k, heights) in bins.iter_mut().enumerate() {
            heights.sort_by(f64::total_cmp);
            let at = (k as f64 + 0.5) * step;
            if heights.is_empty() {
                writeln!(text, "{at},0,,,,,,").ok();
                continue;
            }
            let mean = heights.iter().sum::<f64>() / heights.len() as f64;
            let [least, quarter, median, high, greatest] = [0.0, 0.25, 0.5, 0.75, 1.0].map(|p| quantile(heights, p));
            writeln!(text, "{at},{},{least},{quarter},{mean},{median},{high},{greatest}", heights.len()).ok();
        }
        out.put(&self.path, text.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::HeightField;
    use landform_core::verb::MemoryOutput;

    use super::*;

    fn rows(stage: &WriteSwath, field: &HeightField) -> Result<Vec<Vec<f64>>> {
        stage.validate().unwrap();
        let mut out = MemoryOutput::default();
        stage.export(&Landscape::plain(field), &mut out)?;
        let text = String::from_utf8(out.0["swath.csv"].clone()).unwrap();
        Ok(text.lines().skip(1).map(|l| l.split(',').map(|v| v.parse().unwrap_or(f64::NAN)).collect()).collect())
    }

    #[test]
    fn a_swath_over_a_ridge_is_the_ridge() {
        // Heights rise to the east by a metre a node, and by ten to the north.
        let grid = Grid::new(Shape::new(11, 21), [10.0, 10.0]).unwrap();
        let z = (0..grid.len()).map(|i| (i % 21) as f64 + 10.0 * (10 - i / 21) as f64).collect();
        let field = HeightField::new(grid, z).unwrap();
        let found = rows(&WriteSwath { width: Length::of(45.0), ..WriteSwath::default() }, &field).unwrap();
        assert_eq!(found.len(), 20);
        // Five rows of nodes about the middle, one column a step.
        assert_eq!(found[3], [35.0, 5.0, 33.0, 43.0, 53.0, 53.0, 63.0, 73.0]);
        let places = |a: [f64; 2], b: [f64; 2]| WriteSwath {
            points: vec![a.map(Length::of), b.map(Length::of)],
            width: Length::of(5.0),
            ..WriteSwath::default()
        };
        let north = rows(&places([50.0, 0.0], [50.0, 100.0]), &field).unwrap();
        assert_eq!(north[2], [25.0, 1.0, 25.0, 25.0, 25.0, 25.0, 25.0, 25.0]);
        assert!(rows(&places([50.0, 0.0], [50.0, 0.0]), &field).is_err());
        assert!(rows(&places([1e4, 1e4], [2e4, 1e4]), &field).is_err());
        let one = WriteSwath { points: vec![[Length::of(1.0); 2]], ..WriteSwath::default() };
        assert_eq!(one.validate().unwrap_err().parameter_name(), Some("points"));
        let fine = WriteSwath { step: Some(Length::of(1e-300)), ..WriteSwath::default() };
        assert_eq!(rows(&fine, &field).unwrap_err().parameter_name(), Some("step"));
    }
}
