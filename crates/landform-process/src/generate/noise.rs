//! Octaves of gradient noise.

use landform_core::algo::noise::fbm;
use landform_core::terrain::HeightField;
use landform_core::units::Length;
use landform_core::verb::{Context, Estimate, Generator, Params, Source};
use landform_core::{Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{raster, raster_estimate};

/// Rolling ground from octaves of gradient noise. Waves are in metres: a finer cell adds detail and moves nothing.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Noise {
    /// Extent east and north.
    #[schemars(extend("x-above" = 0.0))]
    pub size: [Length; 2],
    /// Distance between nodes; adjusted so that a whole number of cells fits.
    #[schemars(extend("x-above" = 0.0))]
    pub cell_size: Length,
    /// Mean elevation.
    pub elevation: Length,
    /// Half of the relief: elevations lie within about this of the mean.
    #[schemars(extend("x-min" = 0.0))]
    pub amplitude: Length,
    /// Length of the coarsest waves.
    #[schemars(extend("x-above" = 0.0))]
    pub wavelength: Length,
    /// Number of octaves, each half as long; octaves below two cells are left out.
    #[schemars(extend("x-min" = 1, "x-max" = 24))]
    pub octaves: u32,
    /// Hurst exponent: each octave is 2^-H times as high as the one before. 1 is smooth, 0 is rough.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub hurst: f64,
}

impl Default for Noise {
    fn default() -> Self {
        Self {
            size: [Length::of(10_240.0); 2],
            cell_size: Length::of(10.0),
            elevation: Length::of(0.0),
            amplitude: Length::of(300.0),
            wavelength: Length::of(5_000.0),
            octaves: 12,
            hurst: 0.9,
        }
    }
}

impl Params for Noise {
    const NAME: &'static str = "noise";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Perlin (2002)",
        title: "Improving noise, ACM Transactions on Graphics 21(3)",
        doi: "10.1145/566654.566636",
    }];
}

impl Generator<HeightField> for Noise {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let grid = raster(self.size, self.cell_size)?;
        let wave = self.wavelength.si();
        let finest = 2.0 * grid.spacing[0].max(grid.spacing[1]);
        let fitting = math::log2(wave / finest).floor().max(0.0) as u32 + 1;
        let gain = math::pow(2.0, -self.hurst);
        let elevation = parallel::map(grid.len(), |i| {
            let [x, y] = grid.position(i);
            let n = fbm(context.seed, x / wave, y / wave, self.octaves.min(fitting), 2.0, gain);
            self.elevation.si() + self.amplitude.si() * n
        });
        HeightField::new(grid, elevation)
    }

    fn estimate(&self, _: &Context) -> Result<Estimate> {
        raster_estimate(self.size, self.cell_size, 0)
    }
}
