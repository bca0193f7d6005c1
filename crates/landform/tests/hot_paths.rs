//! The paths in which runs spend their time, small: as tests that they run, and for
//! `cargo xtask instructions`, which counts the instructions of each `hot_…` function.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use landform::core::algo::flow::{Flow, node_areas};
use landform::core::grid::{Grid, RasterDomain, Shape};
use landform::core::parallel::with_threads;
use landform::core::random::Seed;
use landform::core::sim::Model;
use landform::core::terrain::{Bed, HeightField, Layers, Materials, Mesh, NodeSurface};
use landform::core::units::{KYR, Length, Rate, YEAR};
use landform::core::verb::{Context, Generator, Process};
use landform::io::export::WritePicture;
use landform::io::format::{RasterFile, raster_format};
use landform::process::channel::{ChannelErosion, Transport};
use landform::process::dune::Dunes;
use landform::process::generate::{GridParams, Noise, SpectralFbm, StreamGraph};
use landform::process::hillslope::{LinearDiffusion, ThermalErosion};
use landform::process::snow::Snow;
use landform::process::stream_power::StreamPower;
use landform::process::uplift::Uplift;

fn context() -> Context<'static> {
    Context { seed: Seed(7), ..Context::default() }
}

/// Fractal ground with many lakes.
fn rough(n: usize) -> HeightField {
    let grid = GridParams::of([(n - 1) as f64 * 30.0; 2], 30.0);
    SpectralFbm { grid, ..SpectralFbm::default() }.generate(&context()).unwrap()
}

fn model<T: NodeSurface, P: Process<T>>(terrain: T, params: P, dt: f64) -> Model<T> {
    let mut model = Model::new(terrain).dt(dt).seed(Seed(7));
    model.add(params).unwrap();
    model.start().unwrap();
    model
}

/// Runs on one thread; what was counted is inside.
fn alone<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    with_threads(1, work).unwrap()
}

#[inline(never)]
fn hot_route(flow: &mut Flow, domain: &RasterDomain, z: &[f64], area: &mut [f64]) {
    flow.route(domain, z, area);
}

#[test]
fn route() {
    alone(|| {
        let field = rough(513);
        let domain = field.domain();
        let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
        hot_route(&mut flow, &domain, field.elevation(), &mut area);
        assert!(flow.lakes() > 1_000);
    });
}

#[inline(never)]
fn hot_steps<T: NodeSurface>(model: &mut Model<T>, steps: u64) {
    model.advance_steps(steps).unwrap();
}

fn rivers() -> StreamPower {
    StreamPower { area_exponent: 0.5, limiting_slope: Some(0.0), ..StreamPower::default() }
}

#[test]
fn stream_power_on_a_raster() {
    alone(|| {
        let mut model = Model::new(rough(257)).dt(10.0 * KYR).seed(Seed(7));
        model.add(rivers()).unwrap();
        model.add(Uplift { rate: Rate::of(1.0).into() }).unwrap();
        model.start().unwrap();
        hot_steps(&mut model, 5);
    });
}

#[test]
fn stream_power_on_a_mesh() {
    alone(|| {
        let mesh: Mesh = StreamGraph { nodes: 20_000, roughness: Length::of(50.0), ..StreamGraph::default() }
            .generate(&context())
            .unwrap();
        hot_steps(&mut model(mesh, rivers(), 100.0 * KYR), 5);
    });
}

#[test]
fn stream_power_with_deposition() {
    alone(|| hot_steps(&mut model(rough(257), StreamPower { deposition: 0.8, ..rivers() }, 10.0 * KYR), 3));
}

#[test]
fn stream_power_through_beds() {
    alone(|| {
        let (mut field, all) = (rough(257), Materials::default());
        let bed = |name: &str| Bed { material: all.find(name).unwrap(), thickness: 40.0 };
        let beds = Layers::bedded(&all, vec![bed("sandstone"), bed("shale")], vec![900.0; 257 * 257]).unwrap();
        field.set_layers(Some(beds));
        hot_steps(&mut model(field, rivers(), 10.0 * KYR), 3);
    });
}

#[test]
fn linear_diffusion() {
    alone(|| hot_steps(&mut model(rough(257), LinearDiffusion::default(), 10.0 * KYR), 2));
}

#[test]
fn thermal_erosion() {
    alone(|| hot_steps(&mut model(rough(257), ThermalErosion::default(), YEAR), 4));
}

#[test]
fn dunes() {
    alone(|| {
        let grid = Grid::new(Shape::new(128, 128), [3.0; 2]).unwrap();
        let field = HeightField::new(grid, vec![10.0; 128 * 128]).unwrap();
        hot_steps(&mut model(field, Dunes { sand: Length::of(3.0).into(), ..Dunes::default() }, 1e12), 10);
    });
}

#[test]
fn snow() {
    alone(|| {
        hot_steps(&mut model(rough(257), Snow { snow_line: Some(Length::of(-500.0)), ..Snow::default() }, 1e6), 2)
    });
}

#[test]
fn channel_columns() {
    alone(|| hot_steps(&mut model(rough(129), ChannelErosion::default(), YEAR), 5));
}

#[test]
fn channel_pipes() {
    let pipes = ChannelErosion { transport: Transport::Pipes, ..ChannelErosion::default() };
    alone(|| hot_steps(&mut model(rough(129), pipes, YEAR), 1));
}

#[inline(never)]
fn hot_generate(params: &impl Generator<HeightField>) -> HeightField {
    params.generate(&context()).unwrap()
}

#[test]
fn noise() {
    alone(|| hot_generate(&Noise { grid: GridParams::of([2560.0; 2], 10.0), ..Noise::default() }));
}

#[test]
fn spectral_fbm() {
    alone(|| hot_generate(&SpectralFbm { grid: GridParams::of([2560.0; 2], 10.0), ..SpectralFbm::default() }));
}

#[inline(never)]
fn hot_draw(picture: &WritePicture, field: &HeightField) {
    picture.draw(field).unwrap();
}

#[test]
fn perspective_picture() {
    alone(|| hot_draw(&WritePicture { size: 320, ..WritePicture::default() }, &rough(129)));
}

#[inline(never)]
fn hot_write(file: &RasterFile) -> Vec<u8> {
    (raster_format("a.tif".as_ref()).unwrap().write)(file).unwrap()
}

#[test]
fn geotiff() {
    let field = rough(257);
    alone(|| hot_write(&RasterFile::real(field.grid(), field.elevation(), "elevation", "m", 0)));
}
