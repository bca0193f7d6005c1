//! The hot paths of rivers: routing at raster sizes, and whole steps at 10⁴ to 10⁶ nodes on meshes
//! and rasters.

#![allow(missing_docs, clippy::unwrap_used, reason = "a bench that cannot go on panics")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use landform_core::algo::flow::{Flow, node_areas};
use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::sim::{Simulation, Stop};
use landform_core::terrain::{HeightField, Mesh, NodeSurface};
use landform_core::units::{KYR, Length};
use landform_core::verb::{Context, Generator};
use landform_process::generate::{GridParams, SpectralFbm, StreamGraph};
use landform_process::stream_power::StreamPower;
use landform_process::uplift::Uplift;

fn context() -> Context<'static> {
    Context { seed: Seed(7), ..Context::default() }
}

fn fractal(n: usize) -> HeightField {
    let side = Length::of((n - 1) as f64 * 30.0);
    let grid = GridParams { size: [side; 2], cell_size: Length::of(30.0) };
    let params = SpectralFbm { grid, ..SpectralFbm::default() };
    params.generate(&context()).unwrap()
}

fn routing(c: &mut Criterion) {
    let mut group = c.benchmark_group("depressions + D8 + area");
    group.sample_size(10);
    for n in [1024, 2048, 4096] {
        let field = fractal(n);
        let domain = field.domain();
        let mut flow = Flow::new();
        let areas = node_areas(&*domain);
        let mut area = areas.clone();
        group.throughput(Throughput::Elements((n * n) as u64));
        group.bench_function(BenchmarkId::from_parameter(n), |b| {
            b.iter(|| {
                area.clone_from(&areas);
                flow.route(&*domain, field.elevation(), &mut area);
            });
        });
    }
}

/// A landscape after some steps, when lakes are few, and one step more.
fn step<T: NodeSurface>(c: &mut Criterion, name: &str, start: T) {
    let nodes = start.elevation().len();
    let ripe = |start: T, steps| {
        let mut sim = Simulation::new(start)
            .process(Uplift::default())
            .unwrap()
            .process(StreamPower::default())
            .unwrap()
            .dt(50.0 * KYR)
            .until(Stop::steps(steps));
        sim.run().unwrap();
        sim.into_terrain()
    };
    let terrain = ripe(start, 20);
    let mut group = c.benchmark_group(name);
    group.sample_size(10);
    group.throughput(Throughput::Elements(10 * nodes as u64));
    group.bench_function(BenchmarkId::new("10 steps", nodes), |b| b.iter(|| ripe(terrain.clone(), 10)));
}

fn steps(c: &mut Criterion) {
    for n in [100, 316, 1000] {
        let grid = Grid::new(Shape::new(n, n), [100.0; 2]).unwrap();
        let z = (0..grid.len()).map(|i| Seed(7).uniform(i as u64)).collect();
        step(c, "raster", HeightField::new(grid, z).unwrap());
    }
    for nodes in [10_000, 100_000, 1_000_000] {
        let mesh: Mesh = StreamGraph { nodes, ..StreamGraph::default() }.generate(&context()).unwrap();
        step(c, "mesh", mesh);
    }
}

criterion_group!(benches, routing, steps);
criterion_main!(benches);
