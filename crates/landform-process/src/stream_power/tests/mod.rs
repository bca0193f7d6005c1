//! Steady states against theory, on both representations. Identifiers in brackets are those of the
//! validation notes.

use landform_core::algo::flow::{Flow, node_areas};
use landform_core::field::names;
use landform_core::grid::{Domain, Edge, Edges, Grid, Shape, Side, Status};
use landform_core::math;
use landform_core::random::Seed;
use landform_core::sim::{Model, Simulation, Stop, Stopped};
use landform_core::terrain::{HeightField, Mesh, NodeSurface, Rasterize};
use landform_core::units::{Angle, Erodibility, KYR, Length, MYR, Rate, YEAR};
use landform_core::verb::{Context, Generator, Outlets, Resolved};

use super::braun_willett_2013::sweep;
use super::yuan_2019::Sediment;
use super::*;
use crate::generate::StreamGraph;
use crate::hillslope::LinearDiffusion;
use crate::uplift::Uplift;

mod deposition;
mod refine;
mod sharp;
mod strips;
mod transient;
mod valleys;

const U: f64 = 1e-3;
const K: f64 = 1e-5;

fn raster(n: usize, seed: u64) -> HeightField {
    let mut grid = Grid::new(Shape::new(n, n), [100.0, 100.0]).unwrap();
    grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    let z = (0..grid.len()).map(|i| if i / n == n - 1 { 0.0 } else { Seed(seed).uniform(i as u64) });
    HeightField::new(grid.clone(), z.collect()).unwrap()
}

fn mesh(nodes: usize) -> Mesh {
    let params = StreamGraph { nodes, size: [Length::of(10_000.0); 2], ..StreamGraph::default() };
    params.generate(&Context { seed: Seed(5), ..Context::default() }).unwrap()
}

fn law(m: f64, n: f64) -> StreamPower {
    StreamPower {
        erodibility: Some(Erodibility::of(K).into()),
        area_exponent: m,
        slope_exponent: n,
        limiting_slope: Some(0.0),
        ..StreamPower::default()
    }
}

fn uplift(mm_per_year: f64) -> Uplift {
    Uplift { rate: Rate::of(mm_per_year).into() }
}

fn steady<T: NodeSurface>(terrain: T, rivers: StreamPower, dt: f64) -> T {
    let stop = Stop::steady(1e-12).or_steps(2_000);
    let mut sim =
        Simulation::new(terrain).process(uplift(1e3 * U)).unwrap().process(rivers).unwrap().dt(dt).until(stop);
    let outcome = sim.run().unwrap();
    assert_eq!(outcome.stopped, Stopped::Steady, "{outcome:?}");
    assert!(outcome.budget.imbalance() < 1e-9);
    sim.into_terrain()
}

/// Per inner node: (drainage area, slope, path distance-weighted χ from the outlet, elevation).
fn profile<T: NodeSurface>(terrain: &T, concavity: f64) -> Vec<[f64; 4]> {
    let (domain, z) = (terrain.domain(), terrain.elevation());
    let mut area = node_areas(&*domain);
    let mut flow = Flow::new();
    flow.route(&*domain, z, &mut area);
    let mut chi = vec![0.0; z.len()];
    let mut rows = Vec::new();
    for &i in flow.order().iter().rev() {
        let i = i as usize;
        let r = flow.receivers()[i] as usize;
        if r != i {
            let length = domain.distance(i, flow.slots()[i]);
            chi[i] = chi[r] + math::pow(1e6 / area[i], concavity) * length;
            rows.push([area[i], (z[i] - z[r]) / length, chi[i], z[i]]);
        }
    }
    rows
}

fn check_slope_area<T: NodeSurface>(terrain: &T, m: f64, n: f64) {
    let mut errors: Vec<f64> = profile(terrain, m / n)
        .iter()
        .map(|[area, slope, ..]| (K * math::pow(*area, m) * math::pow(*slope, n) / U - 1.0).abs())
        .collect();
    errors.sort_by(f64::total_cmp);
    let (median, most) = (errors[errors.len() / 2], errors[errors.len() * 99 / 100]);
    assert!(median < 1e-10 && most < 1e-6, "m {m} n {n}: median {median:e}, 99 % {most:e}");
}

#[test]
fn slope_and_area_obey_the_law_at_every_node_of_a_raster() {
    // SP1
    for (m, n) in [(0.5, 1.0), (0.4, 1.0), (0.6, 1.2), (0.45, 0.8)] {
        check_slope_area(&steady(raster(40, 1), law(m, n), 10.0 * MYR), m, n);
    }
}

#[test]
fn steep_valleys_have_their_steady_slopes_at_every_node() {
    // S = S_d/(1 + (K S_d/U) A^m) for n = 1, with A of 5,000 m² at least.
    let params = StreamPower { limiting_slope: Some(0.9), ..law(0.5, 1.0) };
    for (lattice, deposition) in [(false, 0.0), (true, 0.0), (true, 0.5)] {
        let mut field = raster(40, 1);
        if lattice {
            field = field.jittered(Seed(4)).unwrap();
        }
        let terrain = steady(field, StreamPower { deposition, ..params.clone() }, 10.0 * MYR);
        for [area, slope, ..] in profile(&terrain, 0.5) {
            let expected = 0.9 / (1.0 + K * 0.9 / (U * (1.0 + deposition)) * area.max(5000.0).sqrt());
            assert!((slope / expected - 1.0).abs() < 1e-6, "{lattice} {deposition}: {area} {slope} {expected}");
        }
    }
}

#[test]
fn slope_and_area_obey_the_law_at_every_node_of_a_mesh() {
    check_slope_area(&steady(mesh(2_000), law(0.5, 1.0), 10.0 * MYR), 0.5, 1.0);
}

#[test]
fn elevation_is_linear_in_chi() {
    // SP3
    for m in [0.4, 0.5, 0.6] {
        let rows = profile(&steady(raster(40, 2), law(m, 1.0), 10.0 * MYR), m);
        let (slope, _, r2) = math::line_fit(rows.iter().map(|r| (r[2], r[3])));
        let expected = U / (K * math::pow(1e6, m));
        assert!((slope / expected - 1.0).abs() < 1e-6 && r2 > 1.0 - 1e-9, "{slope} {expected} {r2}");
    }
}

#[test]
fn elevation_is_proportional_to_uplift_over_erodibility() {
    // SP6, to the bit: the factor is a power of two, and the starting noise takes part.
    let run = |factor: f64| {
        let mut terrain = raster(30, 3);
        terrain.change(Layer::Bedrock, |z| z.iter_mut().for_each(|z| *z *= factor));
        let mut sim = Simulation::new(terrain)
            .process(Uplift { rate: Rate::from_si(factor * U / YEAR).into() })
            .unwrap()
            .process(law(0.5, 1.0))
            .unwrap()
            .dt(100.0 * KYR)
            .until(Stop::steps(40));
        sim.run().unwrap();
        sim.into_terrain()
    };
    let (one, four) = (run(1.0), run(4.0));
    assert!(one.elevation().iter().zip(four.elevation()).all(|(a, b)| 4.0 * a == *b));
}

#[test]
fn one_endless_step_on_fixed_receivers_is_the_steady_state() {
    // SP8
    let terrain = steady(raster(40, 4), law(0.5, 1.0), 10.0 * MYR);
    let domain = terrain.domain();
    let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
    flow.route(&*domain, terrain.elevation(), &mut area);
    let dt = 1e6 * MYR;
    let mut z: Vec<f64> = (0..area.len())
        .map(|i| terrain.elevation()[i] + if domain.status()[i] == Status::Interior { U / YEAR * dt } else { 0.0 })
        .collect();
    let law = law(0.5, 1.0).law(f64::NEG_INFINITY, dt, false);
    let k = Resolved::Uniform(K / YEAR);
    let rock = Rock { erodibility: &k, layers: None, weakness: None, by_material: false };
    sweep(&*domain, &flow, &law, &rock, &mut area, &mut z);
    for (new, old) in z.iter().zip(terrain.elevation()) {
        assert!((new - old).abs() <= 1e-9 * old.abs(), "{new} {old}");
    }
}

#[test]
fn mass_is_conserved_step_by_step() {
    // SP11, with diffusion
    let before = raster(40, 5);
    let mut sim = Simulation::new(before)
        .process(uplift(1.0))
        .unwrap()
        .process(law(0.5, 1.0))
        .unwrap()
        .process(LinearDiffusion::default())
        .unwrap()
        .dt(50.0 * KYR)
        .until(Stop::steps(60));
    let outcome = sim.run().unwrap();
    assert!(outcome.budget.imbalance() < 1e-10, "{:e}", outcome.budget.imbalance());
    assert!(outcome.budget.sediment_imbalance() < 1e-10, "{:e}", outcome.budget.sediment_imbalance());
}

#[test]
fn no_slope_exceeds_the_talus_angle_and_clamped_nodes_stand_at_it() {
    let mut rivers = law(0.5, 1.0);
    rivers.talus_angle = Some(Angle::of(10.0));
    let terrain = steady(mesh(1_500), rivers, 1.0 * MYR);
    let limit = math::tan(10.0_f64.to_radians());
    let rows = profile(&terrain, 0.5);
    assert!(rows.iter().all(|r| r[1] <= limit * (1.0 + 1e-9)));
    let (mut clamped, mut expected) = (0, 0);
    for [area, slope, ..] in &rows {
        clamped += usize::from(*slope > limit * (1.0 - 1e-6));
        expected += usize::from(*area < math::pow(U / (K * limit), 2.0));
    }
    assert!(expected > 50 && clamped.abs_diff(expected) * 20 <= rows.len(), "{clamped} {expected} of {}", rows.len());
}

#[test]
fn without_the_clamp_the_highest_point_grows_as_uplift() {
    // SP7
    let height = |u: f64| {
        let stop = Stop::steady(1e-6).or_steps(1_000);
        let mut sim = Simulation::new(mesh(2_000))
            .process(uplift(u))
            .unwrap()
            .process(law(0.5, 1.0))
            .unwrap()
            .dt(2.0 * MYR)
            .until(stop);
        sim.run().unwrap();
        sim.terrain().elevation().iter().copied().fold(0.0, f64::max)
    };
    let exponent = math::log(height(1.0) / height(0.01)) / math::log(100.0);
    assert!((exponent - 1.0).abs() < 0.05, "{exponent}");
}

#[test]
fn a_lake_floor_is_left_alone_and_its_depth_is_kept() {
    let mut terrain = raster(21, 6);
    terrain.change(Layer::Bedrock, |z| z.iter_mut().enumerate().for_each(|(i, z)| *z = 100.0 - (i / 21) as f64 * 5.0));
    let pit = 10 * 21 + 10;
    terrain.change(Layer::Bedrock, |z| z[pit] = 10.0);
    let mut sim = Simulation::new(terrain).process(law(0.5, 1.0)).unwrap().dt(KYR).until(Stop::steps(1));
    sim.run().unwrap();
    assert_eq!(sim.terrain().elevation()[pit], 10.0);
    let depth = sim.terrain().fields().get(&names::LAKE_DEPTH, "test").unwrap();
    assert!(depth[pit] > 20.0 && depth[0] == 0.0, "{}", depth[pit]);
}

#[test]
fn a_wetter_land_is_worn_more_and_rain_in_one_place_leaves_the_others_alone() {
    let run = |rainfall: Option<&str>| {
        let mut rivers = law(0.5, 1.0);
        rivers.rainfall = rainfall.map(|f| landform_core::verb::Varying::Formula {
            formula: landform_core::verb::Formula::parse(f).unwrap(),
            unit: "m/yr".into(),
        });
        steady(raster(30, 7), rivers, 10.0 * MYR).elevation().to_vec()
    };
    let mean = |z: &[f64], west: bool| {
        z.iter().enumerate().filter(|(i, _)| (i % 30 < 15) == west).map(|(_, z)| z).sum::<f64>() / 450.0
    };
    let none = run(None);
    assert_eq!(none, run(Some("1")), "1 m/yr is the reference");
    // K A^m with A four times as large: relief is half.
    let wet = run(Some("4"));
    let ratio = (mean(&wet, true) + mean(&wet, false)) / (mean(&none, true) + mean(&none, false));
    assert!((ratio - 0.5).abs() < 0.02, "{ratio}");
    let wet_east = run(Some("if(u < 0.5, 1, 5)"));
    let (west, east) = (mean(&wet_east, true) / mean(&none, true), mean(&wet_east, false) / mean(&none, false));
    // The divide moves; over the mean of rain the west would stand 1.7 times as high.
    assert!((west - 1.0).abs() < 0.2 && east < 0.6, "{west} {east}");
}

#[test]
fn outlets_can_be_chosen() {
    let mut rivers = law(0.5, 1.0);
    rivers.outlets = Some(Outlets::Sides(vec![Side::West]));
    let terrain = steady(raster(30, 8), rivers, 10.0 * MYR);
    assert!((0..30).all(|r| terrain.elevation()[r * 30] < 1.0), "the west is held");
    assert!(terrain.elevation()[29 * 30 + 29] > 100.0, "the south is not");
}

#[test]
fn a_domain_without_outlets_is_refused() {
    let mut terrain = raster(10, 9);
    let grid = Grid { edges: Edges::all(Edge::Closed), ..terrain.grid().clone() };
    terrain.set_grid(grid).unwrap();
    let error =
        Process::<HeightField>::start(&law(0.5, 1.0), &mut terrain, &Context { seed: Seed(1), ..Context::default() });
    assert!(error.unwrap_err().to_string().contains("`outlets`"));
}

#[test]
fn a_raster_and_a_mesh_of_one_long_line_agree_with_the_analytic_profile() {
    // SP4: closed long sides, open at the west end; area grows with distance from the head.
    let n = 401;
    let mut grid = Grid::new(Shape::new(1, n), [25.0, 25.0]).unwrap();
    grid.edges = Edges { west: Edge::Open, ..Edges::all(Edge::Closed) };
    let start = (0..n).map(|i| 0.01 * i as f64).collect();
    let terrain = steady(HeightField::new(grid, start).unwrap(), law(0.45, 1.0), 10.0 * MYR);
    // A(x) = w (L − x) with w the cell width: h = u/(k w^m) [L^e − (L − x)^e]/e with e = 1 − m.
    let (length, e) = (25.0 * n as f64, 0.55);
    let head = U / (K * math::pow(25.0, 0.45)) * (math::pow(length, e) - math::pow(12.5, e)) / e;
    assert!((terrain.elevation()[n - 1] / head - 1.0).abs() < 0.01, "{} {head}", terrain.elevation()[n - 1]);
}

#[test]
fn runs_are_identical_on_any_number_of_threads() {
    let run = |threads| {
        landform_core::parallel::with_threads(threads, || {
            let mut sim = Simulation::new(mesh(20_000))
                .process(uplift(1.0))
                .unwrap()
                .process(law(0.5, 1.0))
                .unwrap()
                .process(LinearDiffusion::default())
                .unwrap()
                .dt(100.0 * KYR)
                .until(Stop::steps(5));
            sim.run().unwrap();
            sim.into_terrain()
        })
        .unwrap()
    };
    assert!(run(1) == run(2));
}
