//! The only list of stages in the project.

use landform_core::terrain::{HeightField, Mesh};
use landform_io::export::{
    WriteContours, WriteFeatures, WriteHeightmap, WriteMaps, WriteMesh, WritePicture, WriteRaster, WriteReport,
};
use landform_io::import::ElevationFile;
use landform_io::measure::{
    MeasureCoast, MeasureDrainage, MeasureDunes, MeasureHypsometry, MeasureLandscape, MeasureSpectrum, MeasureSummary,
    MeasureSurface,
};
use landform_process::basin::{OptimalNetwork, ThresholdErosion};
use landform_process::channel::ChannelErosion;
use landform_process::coast::{CoastErosion, FrontTerrain, IslandInterior, PruneIslands};
use landform_process::dune::Dunes;
use landform_process::edit::{Add, Derive, Drainage, FillDepressions, Mask, Resample, ToHeightField, Warp};
use landform_process::generate::{
    Blend, Faulting, Flat, MidpointDisplacement, Noise, Shape, SpectralFbm, StreamGraph, Surface,
};
use landform_process::hillslope::{LinearDiffusion, ThermalErosion};
use landform_process::snow::Snow;
use landform_process::stream_power::StreamPower;
use landform_process::streams::StreamAutomaton;
use landform_process::uplift::Uplift;

use super::Stage;

/// Every stage, once per kind of terrain that it runs on.
pub static STAGES: &[Stage] = &[
    Stage::generator::<StreamGraph, Mesh>(),
    Stage::generator::<ElevationFile, HeightField>(),
    Stage::generator::<Faulting, HeightField>(),
    Stage::generator::<Flat, HeightField>(),
    Stage::generator::<FrontTerrain, HeightField>(),
    Stage::generator::<MidpointDisplacement, HeightField>(),
    Stage::generator::<Noise, HeightField>(),
    Stage::generator::<Shape, HeightField>(),
    Stage::generator::<SpectralFbm, HeightField>(),
    Stage::generator::<Surface, HeightField>(),
    Stage::edit::<Add, HeightField>(),
    Stage::edit::<Add, Mesh>(),
    Stage::edit::<Blend, HeightField>(),
    Stage::edit::<Derive, HeightField>(),
    Stage::edit::<Drainage, HeightField>(),
    Stage::edit::<Drainage, Mesh>(),
    Stage::edit::<FillDepressions, HeightField>(),
    Stage::edit::<FillDepressions, Mesh>(),
    Stage::edit::<IslandInterior, HeightField>(),
    Stage::edit::<Mask, HeightField>(),
    Stage::edit::<OptimalNetwork, HeightField>(),
    Stage::edit::<PruneIslands, HeightField>(),
    Stage::edit::<Resample, HeightField>(),
    Stage::edit::<Warp, HeightField>(),
    Stage::convert::<ToHeightField, Mesh, HeightField>(),
    Stage::process::<Uplift, HeightField>(),
    Stage::process::<Uplift, Mesh>(),
    Stage::process::<StreamPower, HeightField>(),
    Stage::process::<StreamPower, Mesh>(),
    Stage::process::<LinearDiffusion, HeightField>(),
    Stage::process::<LinearDiffusion, Mesh>(),
    Stage::process::<ChannelErosion, HeightField>(),
    Stage::process::<CoastErosion, HeightField>(),
    Stage::process::<Dunes, HeightField>(),
    Stage::process::<Snow, HeightField>(),
    Stage::process::<StreamAutomaton, HeightField>(),
    Stage::process::<ThermalErosion, HeightField>(),
    Stage::process::<ThermalErosion, Mesh>(),
    Stage::process::<ThresholdErosion, HeightField>(),
    Stage::measure::<MeasureSummary, HeightField>(),
    Stage::measure::<MeasureSummary, Mesh>(),
    Stage::measure::<MeasureCoast, HeightField>(),
    Stage::measure::<MeasureCoast, Mesh>(),
    Stage::measure::<MeasureDrainage, HeightField>(),
    Stage::measure::<MeasureDrainage, Mesh>(),
    Stage::measure::<MeasureDunes, HeightField>(),
    Stage::measure::<MeasureHypsometry, HeightField>(),
    Stage::measure::<MeasureHypsometry, Mesh>(),
    Stage::measure::<MeasureLandscape, HeightField>(),
    Stage::measure::<MeasureLandscape, Mesh>(),
    Stage::measure::<MeasureSpectrum, HeightField>(),
    Stage::measure::<MeasureSpectrum, Mesh>(),
    Stage::measure::<MeasureSurface, HeightField>(),
    Stage::measure::<MeasureSurface, Mesh>(),
    Stage::export::<WriteRaster, HeightField>(),
    Stage::export::<WriteHeightmap, HeightField>(),
    Stage::export::<WriteContours, HeightField>(),
    Stage::export::<WriteContours, Mesh>(),
    Stage::export::<WriteFeatures, HeightField>(),
    Stage::export::<WriteFeatures, Mesh>(),
    Stage::export::<WriteMaps, HeightField>(),
    Stage::export::<WriteMaps, Mesh>(),
    Stage::export::<WriteMesh, Mesh>(),
    Stage::export::<WriteMesh, HeightField>(),
    Stage::export::<WritePicture, HeightField>(),
    Stage::export::<WritePicture, Mesh>(),
    Stage::export::<WriteReport, HeightField>(),
    Stage::export::<WriteReport, Mesh>(),
];
