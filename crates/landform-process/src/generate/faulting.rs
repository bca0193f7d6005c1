//! Ground broken by faults.

use landform_core::algo::noise::{Faults, faults};
use landform_core::grid::Grid;
use landform_core::units::Length;
use landform_core::verb::{Context, Params, Source};
use landform_core::{Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, OnGrid};

/// Ground broken by straight faults, each of which lifts one side. Many faults make Brownian ground
/// (H = 1/2), few make blocks.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Faulting {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Mean elevation.
    pub elevation: Length,
    /// Standard deviation of the elevation.
    #[schemars(extend("x-min" = 0.0))]
    pub deviation: Length,
    /// Number of faults.
    #[schemars(extend("x-min" = 1, "x-max" = 100_000))]
    pub faults: u32,
    /// Width of the slope at a fault. With 0 it is a cliff.
    #[schemars(extend("x-min" = 0.0))]
    pub width: Length,
}

impl Default for Faulting {
    fn default() -> Self {
        Self {
            grid: GridParams::default(),
            elevation: Length::of(0.0),
            deviation: Length::of(200.0),
            faults: 1_000,
            width: Length::of(0.0),
        }
    }
}

impl Params for Faulting {
    const NAME: &'static str = "faulting";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[Source {
        authors: "Mandelbrot (1975)",
        title: "Stochastic models for the Earth's relief, the shape and the fractal dimension of the coastlines, and the number-area rule for islands, PNAS 72(10)",
        doi: "10.1073/pnas.72.10.3825",
    }];
}

impl OnGrid for Faulting {
    fn grid(&self) -> &GridParams {
        &self.grid
    }

    fn elevations(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>> {
        let what = Faults { count: self.faults as usize, width: self.width.si() };
        let mut z = faults(grid, what, context.seed);
        let (mean, deviation) = (self.elevation.si(), self.deviation.si());
        parallel::update(&mut z, |_, v| *v = mean + deviation * *v);
        Ok(z)
    }
}
