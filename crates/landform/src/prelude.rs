//! Names that most programs need: `use landform::prelude::*;`.

pub use landform_core::grid::{Edge, Edges, Grid, Shape};
pub use landform_core::random::Seed;
pub use landform_core::sim::{Every, Model, Simulation, Stop};
pub use landform_core::terrain::{
    AnyTerrain, Erodible, Ground, HeightField, Layer, Layers, Materials, Mesh, NodeSurface,
};
pub use landform_core::units::{
    Angle, Area, Diffusivity, Discharge, Duration, Erodibility, KM, KYR, Length, MYR, Rate, Ratio, YEAR,
};
pub use landform_core::verb::{Context, Environment, Generator, Params, Varying};
pub use landform_core::{Error, Result};
pub use landform_process::channel::ChannelErosion;
pub use landform_process::coast::CoastErosion;
pub use landform_process::dune::Dunes;
pub use landform_process::edit::{Add, FindFeatures, ToHeightField};
pub use landform_process::generate::{LayeredGround, Noise, SpectralFbm, StreamGraph};
pub use landform_process::hillslope::{LinearDiffusion, ThermalErosion};
pub use landform_process::snow::Snow;
pub use landform_process::stream_power::StreamPower;
pub use landform_process::uplift::Uplift;

pub use crate::landscape::{Evolution, Landscape};
pub use crate::recipe::Recipe;

/// Thousands of years, in s.
pub fn kyr(value: f64) -> f64 {
    value * KYR
}

/// Millions of years, in s.
pub fn myr(value: f64) -> f64 {
    value * MYR
}

/// A rate of `value` mm/yr.
pub fn mm_per_yr(value: f64) -> Rate {
    Rate::of(value)
}

/// A length in metres.
pub fn metres(value: f64) -> Length {
    Length::of(value)
}
