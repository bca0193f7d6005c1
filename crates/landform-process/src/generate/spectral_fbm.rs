//! Fractional Brownian ground by spectral synthesis.
//!
//! # Sources
//! Saupe (1988), algorithm SpectralSynthesisFM2D; see [`spectral_surface`] for the exponent.

use landform_core::algo::noise::{self_affine, spectral_surface, surroundings};
use landform_core::grid::{Grid, Shape};
use landform_core::units::Length;
use landform_core::verb::{Context, Params, Source};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, OnGrid};

/// Fractional Brownian ground: rough at every scale, without rivers.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SpectralFbm {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Mean elevation.
    pub elevation: Length,
    /// Standard deviation of the elevation.
    #[schemars(extend("x-min" = 0.0))]
    pub deviation: Length,
    /// Hurst exponent: 1 is smooth, 0 is rough; the spectrum falls as k^-(2H+2).
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub hurst: f64,
    /// Whether opposite sides are equal, so that copies tile without a seam.
    pub periodic: bool,
}

impl Default for SpectralFbm {
    fn default() -> Self {
        Self {
            grid: GridParams::default(),
            elevation: Length::of(0.0),
            deviation: Length::of(200.0),
            hurst: 0.8,
            periodic: false,
        }
    }
}

impl Params for SpectralFbm {
    const NAME: &'static str = "spectral_fbm";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[Source {
        authors: "Saupe (1988)",
        title: "Algorithms for random fractals, in: The Science of Fractal Images, Springer",
        doi: "10.1007/978-1-4612-3784-6_2",
    }];
}

/// Side of the largest transform: 64 GiB of coefficients.
const MOST_TRANSFORM: usize = 1 << 16;

impl SpectralFbm {
    /// Shape of the transform.
    fn transform(&self, grid: &Grid) -> Result<Shape> {
        let shape = if self.periodic { grid.shape } else { surroundings(grid.shape, grid.spacing) };
        if shape.rows.max(shape.cols) > MOST_TRANSFORM {
            let expected = format!("at most {} cells along a side", MOST_TRANSFORM / 2);
            return Err(Error::parameter("grid.cell_size", self.grid.cell_size, &expected));
        }
        Ok(shape)
    }
}

impl OnGrid for SpectralFbm {
    fn grid(&self) -> &GridParams {
        &self.grid
    }

    fn elevations(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>> {
        self.transform(grid)?;
        let mut z = if self.periodic {
            periodic(grid, self.hurst, context)
        } else {
            self_affine(grid.shape, grid.spacing, self.hurst, context.seed)
        };
        let (mean, deviation) = (self.elevation.si(), self.deviation.si());
        parallel::update(&mut z, |_, v| *v = mean + deviation * *v);
        Ok(z)
    }

    fn scratch(&self, nodes: u64) -> u64 {
        let transform = self.grid.grid().and_then(|g| self.transform(&g));
        if self.periodic { 24 * nodes } else { 24 * transform.map_or(0, |t| t.len() as u64) }
    }
}

/// A periodic surface whose last row and column repeat the first; standard deviation 1.
fn periodic(grid: &Grid, hurst: f64, context: &Context) -> Vec<f64> {
    let cells = Shape::new((grid.shape.rows - 1).max(1), (grid.shape.cols - 1).max(1));
    let z = spectral_surface(cells, grid.spacing, hurst, context.seed);
    let variance = parallel::sum(z.len(), |i| z[i] * z[i]) / z.len() as f64;
    let scale = if variance > 0.0 { 1.0 / variance.sqrt() } else { 0.0 };
    parallel::map(grid.len(), |i| {
        let cell = grid.shape.cell(i);
        scale * z[cells.index(cell.row % cells.rows, cell.col % cells.cols)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::random::Seed;
    use landform_core::verb::Generator;

    #[test]
    fn a_periodic_surface_tiles() {
        use landform_core::terrain::NodeSurface;
        let params =
            SpectralFbm { grid: GridParams::of([700.0, 300.0], 10.0), periodic: true, ..SpectralFbm::default() };
        let field = params.generate(&Context { seed: Seed(2), ..Context::default() }).unwrap();
        let (z, shape) = (field.elevation(), field.grid().shape);
        assert_eq!((shape.rows, shape.cols), (31, 71));
        assert!((0..31).all(|r| z[shape.index(r, 0)] == z[shape.index(r, 70)]));
        assert!((0..71).all(|c| z[c] == z[shape.index(30, c)]));
    }

    #[test]
    fn deviation_and_mean_are_those_asked_for() {
        use landform_core::terrain::NodeSurface;
        let params = SpectralFbm {
            grid: GridParams::of([900.0, 500.0], 10.0),
            elevation: Length::of(40.0),
            ..SpectralFbm::default()
        };
        let field = params.generate(&Context { seed: Seed(2), ..Context::default() }).unwrap();
        let z = field.elevation();
        let mean = z.iter().sum::<f64>() / z.len() as f64;
        let variance = z.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / z.len() as f64;
        assert!((mean - 40.0).abs() < 1e-9 && (variance.sqrt() - 200.0).abs() < 1e-9);
    }
}
