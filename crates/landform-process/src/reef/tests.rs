//! Growth on islands: CR4, CR5, CR7, mass, histories of the sea.

use landform_core::field::names::{COAST_LABELS, LABELS};
use landform_core::grid::{Edge, Edges, Grid, Shape};
use landform_core::sim::{Model, Simulation, Stop};
use landform_core::terrain::NodeSurface;
use landform_core::units::{Duration, KYR, Length, Rate, Ratio};
use landform_core::verb::{Changing, Context, Environment, Generator, Outcome};

use super::*;
use crate::mechanism::GridParams;
use crate::uplift::Uplift;

fn island(profile: &[[f64; 2]], cell: f64) -> HeightField {
    let outline = OutlineParams { roughness: Ratio::of(0.0), ..OutlineParams::default() };
    let profile = profile.iter().map(|p| p.map(Length::of)).collect();
    let grid = GridParams::of([3_600.0; 2], cell);
    let params = CoralIsland { grid, outline, profile, valleys: Ratio::of(0.0), ..CoralIsland::default() };
    params.generate(&Context::default()).unwrap()
}

/// A cone of 150 m with a fall of 1 in 4, and 1 in 2 under the sea.
const CONE: &[[f64; 2]] = &[[0.0, 200.0], [400.0, 100.0], [800.0, 0.0], [1200.0, -200.0], [1600.0, -400.0]];

fn run(field: HeightField, mm_a_year: f64, kyr: f64, dt: f64, environment: Environment) -> (HeightField, Outcome) {
    run_with(ReefGrowth::default(), field, mm_a_year, kyr, dt, environment)
}

fn run_with(
    reef: ReefGrowth,
    field: HeightField,
    mm_a_year: f64,
    kyr: f64,
    dt: f64,
    environment: Environment,
) -> (HeightField, Outcome) {
    let mut sim = Simulation::new(field)
        .process(Uplift { rate: Rate::of(-mm_a_year).into() })
        .unwrap()
        .process(reef)
        .unwrap()
        .environment(std::sync::Arc::new(environment))
        .dt(dt * KYR)
        .until(Stop::time(kyr * KYR));
    let outcome = sim.run().unwrap();
    assert!(outcome.budget.imbalance() < 1e-9, "{:e}", outcome.budget.imbalance());
    assert!(outcome.budget.sediment_imbalance() < 1e-9);
    (sim.terrain().clone(), outcome)
}

fn ray(field: &HeightField) -> Vec<(f64, &'static str)> {
    let (grid, labels) = (field.grid(), field.fields().get(&LABELS, "a test").unwrap());
    let at = |c: usize| grid.shape.index(grid.shape.rows / 2, c);
    (grid.shape.cols / 2..grid.shape.cols)
        .map(|c| (field.elevation()[at(c)], COAST_LABELS[usize::from(labels[at(c)])]))
        .collect()
}

#[test]
fn cr4_ground_that_sinks_faster_than_corals_grow_becomes_a_drowned_flat_top() {
    let top = [[0.0, -4.0], [900.0, -6.0], [1000.0, -30.0], [1500.0, -400.0]];
    // Light alone, without shelter: the top is as flat as it was.
    let open = ReefGrowth { restriction: Length::of(1e8), ..ReefGrowth::default() };
    let (drowned, _) = run_with(open, island(&top, 60.0), 15.0, 40.0, 1.0, Environment::default());
    let line = ray(&drowned);
    assert!(line.iter().all(|(z, label)| *z < -100.0 && *label == "ocean"), "{line:?}");
    let flat: Vec<f64> = line.iter().take(14).map(|p| p.0).collect();
    assert!((flat[0] - flat[13]).abs() < 12.0 && flat[13] - line[25].0 > 150.0, "{line:?}");
    // With shelter it drowns all the same; at 2 mm/yr it keeps up.
    let drowned = run(island(&top, 60.0), 15.0, 40.0, 1.0, Environment::default()).0;
    assert!(ray(&drowned).iter().all(|p| p.1 == "ocean"), "{:?}", ray(&drowned));
    let kept = run(island(&top, 60.0), 2.0, 40.0, 1.0, Environment::default()).0;
    assert!(ray(&kept).iter().any(|p| p.1 == "reef crest"), "{:?}", ray(&kept));
}

#[test]
fn cr5_an_island_that_sinks_has_a_crest_a_lagoon_and_a_steep_front() {
    let (field, _) = run(island(CONE, 20.0), 1.0, 100.0, 1.0, Environment::default());
    let line = ray(&field);
    let of = |name: &str| line.iter().filter(|p| p.1 == name).map(|p| -p.0).collect::<Vec<f64>>();
    let (crest, lagoon) = (of("reef crest"), of("lagoon"));
    assert!(!crest.is_empty() && crest.iter().all(|d| (0.0..=2.0).contains(d)), "{line:?}");
    let drowning = Light::new(12.0, 2000.0, 250.0, 0.1).drowning_depth(1.0).unwrap();
    assert!(lagoon.len() > 5 && lagoon.iter().all(|&d| d >= 0.5 && d < drowning), "{lagoon:?}");
    let steepest = line.windows(2).map(|w| (w[0].0 - w[1].0) / 20.0).fold(0.0, f64::max);
    let degrees = landform_core::math::atan(steepest).to_degrees();
    assert!((25.0..45.0).contains(&degrees), "{degrees}");
    // CR7: in order from the middle outwards.
    let order: Vec<usize> = line.iter().map(|p| COAST_LABELS.iter().position(|l| *l == p.1).unwrap()).collect();
    assert!(order.windows(2).all(|w| w[1] >= w[0]), "{line:?}");
    let coral = field.depth("coral").unwrap();
    let thickest = coral.iter().fold(0.0, |a: f64, &b| a.max(b));
    assert!(thickest > 95.0, "{thickest}");
}

#[test]
fn long_steps_agree_with_short_ones() {
    let rise = |dt: f64| run(island(CONE, 60.0), 2.0, 40.0, dt, Environment::default()).0;
    let (long, short) = (rise(2.0), rise(0.25));
    let off = |i: usize| (long.elevation()[i] - short.elevation()[i]).abs();
    let mean = (0..long.grid().len()).map(off).sum::<f64>() / long.grid().len() as f64;
    assert!(mean < 1.0, "{mean}");
    let share = |f: &HeightField| f.elevation().iter().filter(|z| **z > -1.0).count() as f64;
    assert!((share(&long) / share(&short) - 1.0).abs() < 0.1, "{} {}", share(&long), share(&short));
}

#[test]
fn a_reef_that_the_sea_left_stays_as_a_terrace_and_the_sea_comes_back_to_it() {
    let years = [0.0, 20e3, 40e3].map(Duration::of).to_vec();
    let fall = Changing::Linear { times: years, values: [0.0, 0.0, -60.0].map(Length::of).to_vec() };
    let environment = Environment { sea_level: Some(fall), ..Environment::default() };
    let (field, _) = run(island(CONE, 20.0), 0.0, 60.0, 1.0, environment);
    let (z, coral) = (field.elevation(), field.depth("coral").unwrap());
    let terrace = |level: f64| (0..z.len()).filter(|&i| coral[i] > 1.0 && (z[i] - level + 0.5).abs() < 0.01).count();
    assert!(terrace(0.0) > 100 && terrace(-60.0) > 100, "{} {}", terrace(0.0), terrace(-60.0));
    let labels = field.fields().get(&LABELS, "a test").unwrap();
    assert!((0..z.len()).all(|i| !(coral[i] > 1.0 && z[i] > -1.0)
        || ["island", "beach", "mountain"].contains(&COAST_LABELS[usize::from(labels[i])])));
}

#[test]
fn nodata_single_nodes_and_held_borders_are_borne() {
    for shape in [Shape::new(1, 1), Shape::new(1, 7), Shape::new(9, 9)] {
        for edge in [Edge::Open, Edge::Closed] {
            let mut grid = Grid::new(shape, [50.0; 2]).unwrap();
            grid.edges = Edges::all(edge);
            let mut z: Vec<f64> = (0..grid.len()).map(|i| -f64::from(i as u32 % 40)).collect();
            if z.len() > 60 {
                (40..60).for_each(|i| z[i] = f64::NAN);
            }
            let field = HeightField::new(grid, z.clone()).unwrap();
            let mut model = Model::new(field).dt(10.0 * KYR);
            model.add(ReefGrowth::default()).unwrap();
            model.advance_steps(3).unwrap();
            let now = model.terrain().elevation();
            assert!((0..z.len()).all(|i| now[i].is_nan() == z[i].is_nan() && !(now[i] > -0.5 + 1e-9 && now[i] > z[i])));
            if edge == Edge::Open {
                assert_eq!(now[0], z[0], "a base level is held");
            }
        }
    }
}
