//! Octaves of noise.

use landform_core::algo::noise::{Basis, Fractal, FractalKind};
use landform_core::grid::Grid;
use landform_core::units::Length;
use landform_core::verb::{Context, Params, Reach, Source};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, OnGrid};

/// Ground from octaves of noise. Wavelengths are in metres: finer cells add detail and do not move
/// the ground.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Noise {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Elevation at noise of 0: the mean of plain sums.
    pub elevation: Length,
    /// Height of noise of 1 above that elevation. Plain sums rarely reach half of it; billows lie
    /// below, ridges above, multifractals may exceed it.
    #[schemars(extend("x-min" = 0.0))]
    pub amplitude: Length,
    /// Length of the coarsest waves.
    #[schemars(extend("x-above" = 0.0))]
    pub wavelength: Length,
    /// Number of octaves, each finer than the one before by the lacunarity; octaves below two cells
    /// are left out.
    #[schemars(extend("x-min" = 1, "x-max" = 24))]
    pub octaves: u32,
    /// Hurst exponent: each octave is lacunarity^-H times as high as the one before. 1 is smooth, 0
    /// is rough.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub hurst: f64,
    /// Factor by which the waves of each octave are shorter than those of the one before.
    #[schemars(extend("x-min" = 1.1, "x-max" = 10.0))]
    pub lacunarity: f64,
    /// Noise function that is summed.
    pub basis: Basis,
    /// How octaves are put together.
    pub fractal: FractalKind,
    /// Distance by which the ground is displaced sideways by noise of the same waves, which winds
    /// ridges and valleys.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e7))]
    pub warp: Length,
}

impl Default for Noise {
    fn default() -> Self {
        Self {
            grid: GridParams::default(),
            elevation: Length::of(0.0),
            amplitude: Length::of(300.0),
            wavelength: Length::of(5_000.0),
            octaves: 12,
            hurst: 0.9,
            lacunarity: 2.0,
            basis: Basis::Perlin,
            fractal: FractalKind::Fbm,
            warp: Length::of(0.0),
        }
    }
}

impl Params for Noise {
    const NAME: &'static str = "noise";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Perlin (2002)",
            title: "Improving noise, ACM Transactions on Graphics 21(3)",
            doi: "10.1145/566654.566636",
        },
        Source {
            authors: "Ebert, Musgrave, Peachey, Perlin & Worley (2003)",
            title: "Texturing and Modeling: A Procedural Approach, third edition, Morgan Kaufmann",
            doi: "",
        },
    ];

    fn reach(&self) -> Reach {
        Reach::Point
    }
}

impl OnGrid for Noise {
    fn grid(&self) -> &GridParams {
        &self.grid
    }

    fn elevations(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>> {
        let wave = self.wavelength.si();
        let cell = grid.spacing[0].max(grid.spacing[1]);
        if wave < 2.0 * cell {
            return Err(Error::parameter(
                "wavelength",
                self.wavelength,
                &format!("at least two cells, {} m", 2.0 * cell),
            ));
        }
        let finest = 2.0 * grid.spacing[0].max(grid.spacing[1]);
        let fitting = (math::log(wave / finest) / math::log(self.lacunarity) + 1e-9).floor().max(0.0) as u32 + 1;
        let fractal = Fractal {
            basis: self.basis,
            kind: self.fractal,
            octaves: self.octaves.min(fitting),
            lacunarity: self.lacunarity,
            gain: math::pow(self.lacunarity, -self.hurst),
        };
        let bend = Fractal {
            basis: Basis::Perlin,
            kind: FractalKind::Fbm,
            octaves: 3.min(fitting),
            lacunarity: 2.0,
            gain: 0.5,
        };
        let (mean, amplitude, warp) = (self.elevation.si(), self.amplitude.si(), self.warp.si() / wave);
        let cols = grid.shape.cols;
        let mut elevations = vec![0.0; grid.len()];
        parallel::for_rows_mut(&mut elevations, cols, |row, out| {
            let mut xs: Vec<f64> = (0..cols).map(|col| grid.x(col) / wave).collect();
            let mut ys = vec![grid.y(row) / wave; cols];
            if warp > 0.0 {
                let mut shift = [vec![0.0; cols], vec![0.0; cols]];
                for (k, shift) in shift.iter_mut().enumerate() {
                    bend.along(context.seed.named("warp").with(k as u64), &xs, &ys, shift);
                }
                xs.iter_mut().zip(&shift[0]).for_each(|(x, s)| *x += warp * s);
                ys.iter_mut().zip(&shift[1]).for_each(|(y, s)| *y += warp * s);
            }
            fractal.along(context.seed, &xs, &ys, out);
            out.iter_mut().for_each(|v| *v = mean + amplitude * *v);
        });
        Ok(elevations)
    }
}
