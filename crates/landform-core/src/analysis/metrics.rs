//! All measures of a raster at once, as the report shows them.

use serde::{Deserialize, Serialize};

use super::{
    Coast, Directions, Drainage, Form, Hypsometry, Network, Spectrum, Surface, Variogram, coast, density, directions,
    form, network, of_density, of_sorted, share_in_sinks, surface, variogram,
};
use crate::terrain::{HeightField, NodeSurface};
use crate::{Error, Result, parallel};

/// Elevations in plain numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Elevations {
    /// Rows and columns.
    pub shape: [usize; 2],
    /// Distance between nodes along x and y, m.
    pub spacing: [f64; 2],
    /// Nodes with data (land, where a sea was cut off).
    pub nodes: usize,
    /// Share of nodes without data (and under the sea).
    pub nodata_share: f64,
    /// Area of the nodes with data, m².
    pub area: f64,
    /// Lowest, m.
    pub min: f64,
    /// Highest, m.
    pub max: f64,
    /// Highest less lowest, m.
    pub relief: f64,
    /// Mean, m.
    pub mean: f64,
    /// Median, m.
    pub median: f64,
    /// Standard deviation, m.
    pub deviation: f64,
}

/// All measures of a raster.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Metrics {
    /// Elevations.
    pub elevations: Elevations,
    /// Hypsometry.
    pub hypsometry: Hypsometry,
    /// Slopes and shapes; none if no node has eight neighbours with data.
    pub surface: Option<Surface>,
    /// Pits, peaks, sinks.
    pub form: Form,
    /// Directions of slopes and channels, facets.
    pub directions: Directions,
    /// Drainage.
    pub network: Network,
    /// Spectrum; none if no square of 32 nodes a side has data.
    pub spectrum: Option<Spectrum>,
    /// Variogram.
    pub variogram: Variogram,
    /// The coast at the level of the sea; if there is none, the contour at the median elevation.
    pub coast: Coast,
    /// Level of the sea that was cut off, m.
    pub sea_level: Option<f64>,
}

/// Measures that are drawn as pictures.
#[derive(Clone, Debug)]
pub struct Drawings {
    /// The spectrum on logarithmic axes, [`SPECTRUM_PLOT`]² values; see
    /// [`Density::log_plot`](super::Density::log_plot).
    pub spectrum: Option<Vec<f64>>,
}

/// Side of the plot of the spectrum.
pub const SPECTRUM_PLOT: usize = 321;

/// Measures a raster. With a `sea_level` (m), ground at or under it is left out of everything but
/// the coast.
///
/// Flow leaves where the terrain says (for ground from a file: at the border), and into nodata.
///
/// **Cost** O(n log n), about 90 bytes a node at its peak.
///
/// # Errors
/// [`Error::Empty`] if no ground lies above the sea.
pub fn metrics(field: &HeightField, sea_level: Option<f64>) -> Result<(Metrics, Drawings)> {
    let level_of = |sorted: &[f64]| {
        let below = sorted.last().is_some_and(|&z| z < 0.0) && sorted.first().is_some_and(|&z| z > 0.0);
        sea_level.unwrap_or(if below { 0.0 } else { sorted[sorted.len() / 2] })
    };
    let greatest = parallel::max(field.elevation().len(), |i| field.elevation()[i].abs());
    if greatest > MOST_ELEVATION {
        let value = format!("{greatest:e} m");
        return Err(Error::parameter(
            "elevation",
            value,
            &format!("elevations within {MOST_ELEVATION:e} m; is nodata marked as such?"),
        ));
    }
    let land = sea_level.map(|level| cut_off(field, level)).transpose()?;
    let land = land.as_ref().unwrap_or(field);
    let (grid, z) = (land.grid(), land.elevation());
    let mut sorted: Vec<f64> = z.iter().copied().filter(|z| !z.is_nan()).collect();
    parallel::sort_by(&mut sorted, |a, b| b.total_cmp(a));
    let (coast, _) = coast(field.grid(), field.elevation(), level_of(&sorted));
    let elevations = elevations(land, &sorted);
    let hypsometry = of_sorted(&sorted);
    drop(sorted);
    let (network, directions, form) = {
        let drainage = Drainage::with_open_holes(land);
        let sinks = share_in_sinks(&drainage.flow, z);
        let network = network(&drainage, z);
        let directions = directions(grid, z, &drainage, &network);
        let domain = drainage.domain.clone();
        drop(drainage);
        (network, directions, form(grid, &domain, z, sinks))
    };
    let (spectrum, plot) = match density(grid, z, true) {
        Some((window, density)) => (Some(of_density(grid, z, window, &density)), Some(density.log_plot(SPECTRUM_PLOT))),
        None => (None, None),
    };
    let metrics = Metrics {
        elevations,
        hypsometry,
        surface: surface(grid, z),
        form,
        directions,
        network,
        spectrum,
        variogram: variogram(grid, z),
        coast,
        sea_level,
    };
    Ok((metrics, Drawings { spectrum: plot }))
}

/// Beyond this, squares of squares lose their meaning.
const MOST_ELEVATION: f64 = 1e9;

/// The ground above a level; what is at or under it is nodata.
fn cut_off(field: &HeightField, level: f64) -> Result<HeightField> {
    let z = field.elevation();
    let above = parallel::map(z.len(), |i| if z[i] > level { z[i] } else { f64::NAN });
    HeightField::new(field.grid().clone(), above)
        .map_err(|_| Error::Empty { what: format!("the ground above {level} m").trim_end().into() })
}

fn elevations(field: &HeightField, sorted: &[f64]) -> Elevations {
    let n = sorted.len();
    let mean = parallel::sum(n, |i| sorted[i]) / n as f64;
    let variance = parallel::sum(n, |i| (sorted[i] - mean) * (sorted[i] - mean)) / n as f64;
    let grid = field.grid();
    Elevations {
        shape: [grid.shape.rows, grid.shape.cols],
        spacing: grid.spacing,
        nodes: n,
        nodata_share: 1.0 - n as f64 / grid.len() as f64,
        area: n as f64 * grid.cell_area(),
        min: sorted[n - 1],
        max: sorted[0],
        relief: sorted[0] - sorted[n - 1],
        mean,
        median: if n % 2 == 1 { sorted[n / 2] } else { 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]) },
        deviation: variance.sqrt(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};

    #[test]
    fn what_drains_into_a_hole_is_in_no_sink() {
        let grid = Grid::new(Shape::new(41, 41), [10.0, 10.0]).unwrap();
        let bowl = |at: usize| {
            let (r, c) = ((at / 41) as f64 - 20.0, (at % 41) as f64 - 20.0);
            if at == 20 * 41 + 20 { f64::NAN } else { r * r + c * c }
        };
        let with_hole = HeightField::new(grid.clone(), (0..grid.len()).map(bowl).collect()).unwrap();
        let (m, _) = metrics(&with_hole, None).unwrap();
        assert_eq!(m.form.sinks, 0.0);
        let filled = (0..grid.len()).map(|at| if bowl(at).is_nan() { 0.0 } else { bowl(at) }).collect();
        let (m, _) = metrics(&HeightField::new(grid, filled).unwrap(), None).unwrap();
        assert!(m.form.sinks > 0.7, "{}", m.form.sinks);
    }
}
