//! Cost of an event of the self-organised models: flat in the size of the field, but for what the
//! caches say.

#![allow(missing_docs, reason = "a benchmark")]
#![allow(clippy::unwrap_used, reason = "a benchmark that cannot go on panics")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use landform_core::agents::{Connectivity, Falloff, RasterSites, Sand, Search, avalanche};
use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::sim::{Simulation, Stop};
use landform_core::terrain::HeightField;
use landform_core::units::{Length, YEAR};
use landform_process::coast::{CoastErosion, Perimeter, Search as Which};
use landform_process::dune::Dunes;

const EVENTS: u64 = 100_000;

/// A slab taken somewhere and put somewhere near, on sand at rest.
fn slabs(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("slab moves");
    group.throughput(Throughput::Elements(EVENTS)).sample_size(10);
    for side in [256usize, 1024, 4096] {
        let shape = Shape::new(side, side);
        let mut sand = Sand::new(shape, true, vec![0; shape.len()], [2, 2, 3], 1);
        let mut draws = Seed(1).draws();
        (0..shape.len()).for_each(|site| sand.lay(site, draws.below(8) as i32));
        sand.settle();
        group.bench_function(BenchmarkId::from_parameter(side), |b| {
            let mut stream = Seed(2).stream();
            b.iter(|| {
                for _ in 0..EVENTS {
                    let site = landform_core::random::Stream::index((stream.bits() >> 32) as u32, shape.len());
                    let taken = sand.take(site, 1);
                    sand.put((site + 5) % shape.len(), taken);
                }
            });
        });
    }
    group.finish();
}

/// An avalanche of 5 sites' radius.
fn avalanches(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("avalanches");
    group.throughput(Throughput::Elements(1_000)).sample_size(10);
    for side in [256usize, 1024, 4096] {
        let grid = Grid::new(Shape::new(side, side), [1.0, 1.0]).unwrap();
        let sites = RasterSites::new(&grid, Connectivity::Eight).unwrap();
        let (mut search, mut weak) = (Search::new(side * side), vec![0.0f32; side * side]);
        group.bench_function(BenchmarkId::from_parameter(side), |b| {
            let mut draws = Seed(3).draws();
            b.iter(|| {
                for _ in 0..1_000 {
                    let at = draws.below(side * side);
                    avalanche(&sites, &mut search, at, 5.0, Falloff::Linear, |_, _| true, |i, w| weak[i] += w as f32);
                }
            });
        });
    }
    group.finish();
}

fn flat(side: usize, cell: f64, elevation: f64) -> HeightField {
    let grid = Grid::new(Shape::new(side, side), [cell, cell]).unwrap();
    HeightField::new(grid, vec![elevation; side * side]).unwrap()
}

/// Whole runs of the processes.
fn runs(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("runs");
    group.sample_size(10);
    group.bench_function("Werner 512, 100 rounds", |b| {
        let dunes =
            Dunes { sand: Length::of(3.25).into(), hop: Some(Length::of(5.0)), refinements: 0, ..Dunes::default() };
        b.iter(|| {
            let simulation = Simulation::new(flat(512, 1.0, 0.0)).process(dunes.clone()).unwrap();
            simulation.dt(1e12).until(Stop::steps(100)).run().unwrap()
        });
    });
    for (name, perimeter) in [
        ("coast 256, contiguous, 17 sites", Perimeter::Local { local: Length::of(250.0), search: Which::Contiguous }),
        ("coast 256, all, 17 sites", Perimeter::Local { local: Length::of(250.0), search: Which::All }),
    ] {
        let coast = CoastErosion {
            force: Some(landform_core::units::Ratio::of(0.64).into()),
            perimeter,
            ..CoastErosion::default()
        };
        group.bench_function(name, |b| {
            b.iter(|| {
                let simulation = Simulation::new(flat(256, 15.0, 4.0)).process(coast.clone()).unwrap();
                simulation.dt(YEAR).until(Stop::steps(5000)).run().unwrap()
            });
        });
    }
    group.finish();
}

criterion_group!(benches, slabs, avalanches, runs);
criterion_main!(benches);
