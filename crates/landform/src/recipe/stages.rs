//! The only list of stages in the project.

use landform_core::terrain::{HeightField, Mesh};
use landform_io::export::{
    MeasureSummary, WriteFeatures, WriteHeightmap, WriteMesh, WritePicture, WriteRaster, WriteReport,
};
use landform_io::import::ElevationFile;
use landform_process::edit::{Add, Drainage, FillDepressions, Resample, ToHeightField};
use landform_process::generate::{Flat, Noise, SpectralFbm, StreamGraph};
use landform_process::hillslope::LinearDiffusion;
use landform_process::stream_power::StreamPower;
use landform_process::uplift::Uplift;

use super::Stage;

/// Every stage, once per kind of terrain that it runs on.
pub static STAGES: &[Stage] = &[
    Stage::generator::<StreamGraph, Mesh>(),
    Stage::generator::<ElevationFile, HeightField>(),
    Stage::generator::<Flat, HeightField>(),
    Stage::generator::<Noise, HeightField>(),
    Stage::generator::<SpectralFbm, HeightField>(),
    Stage::edit::<Add, HeightField>(),
    Stage::edit::<Add, Mesh>(),
    Stage::edit::<Drainage, HeightField>(),
    Stage::edit::<Drainage, Mesh>(),
    Stage::edit::<FillDepressions, HeightField>(),
    Stage::edit::<FillDepressions, Mesh>(),
    Stage::edit::<Resample, HeightField>(),
    Stage::convert::<ToHeightField, Mesh, HeightField>(),
    Stage::process::<Uplift, HeightField>(),
    Stage::process::<Uplift, Mesh>(),
    Stage::process::<StreamPower, HeightField>(),
    Stage::process::<StreamPower, Mesh>(),
    Stage::process::<LinearDiffusion, HeightField>(),
    Stage::process::<LinearDiffusion, Mesh>(),
    Stage::measure::<MeasureSummary, HeightField>(),
    Stage::measure::<MeasureSummary, Mesh>(),
    Stage::export::<WriteRaster, HeightField>(),
    Stage::export::<WriteHeightmap, HeightField>(),
    Stage::export::<WriteFeatures, HeightField>(),
    Stage::export::<WriteFeatures, Mesh>(),
    Stage::export::<WriteMesh, Mesh>(),
    Stage::export::<WriteMesh, HeightField>(),
    Stage::export::<WritePicture, HeightField>(),
    Stage::export::<WritePicture, Mesh>(),
    Stage::export::<WriteReport, HeightField>(),
    Stage::export::<WriteReport, Mesh>(),
];
