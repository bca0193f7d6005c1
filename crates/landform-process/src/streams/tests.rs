use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::sim::{Simulation, Stop};

use super::*;

fn ground(n: usize) -> HeightField {
    let grid = Grid::new(Shape::new(n, n), [10.0; 2]).unwrap();
    let z = (0..n * n).map(|i| 4.0 * (i / n) as f64 + 12.0 * Seed(6).uniform(i as u64)).collect();
    HeightField::new(grid, z).unwrap()
}

fn run(params: StreamAutomaton) -> (HeightField, f64) {
    let rounds = params.iterations;
    let mut sim = Simulation::new(ground(48)).process(params).unwrap().dt(YEAR).until(Stop::steps(rounds));
    let outcome = sim.run().unwrap();
    // With the smallest units the volumes' own rounding is what is left.
    assert!(outcome.budget.imbalance() < 1e-6);
    (sim.into_terrain(), outcome.budget.change.eroded / 100.0)
}

#[test]
fn what_is_removed_is_units_times_moves() {
    // WC10: with a unit so small that no half drop limits it.
    for counted in [false, true] {
        let (t, removed) = run(StreamAutomaton { unit: Length::of(1e-7), counted, ..StreamAutomaton::default() });
        let moves: f64 = t.fields().get(&names::STREAM_VISITS, "").unwrap().iter().sum();
        assert!((removed / (moves * 1e-7) - 1.0).abs() < 1e-3, "{removed} {moves}");
        let (_, softer) = run(StreamAutomaton {
            unit: Length::of(1e-7),
            counted,
            softness: Ratio::of(0.5).into(),
            ..StreamAutomaton::default()
        });
        assert!((softer / removed - 0.5).abs() < 1e-3);
    }
}

#[test]
fn passes_end_and_nothing_is_drilled() {
    let before = ground(48);
    let lowest = before.elevation().iter().copied().fold(f64::INFINITY, f64::min);
    let (after, _) = run(StreamAutomaton { iterations: 20, unit: Length::of(5.0), ..StreamAutomaton::default() });
    assert!(after.elevation().iter().all(|&z| z >= lowest));
    assert!((0..48 * 48).all(|i| after.elevation()[i] <= before.elevation()[i]));
}

#[test]
fn springs_cut_where_they_run_only() {
    let springs = vec![[Length::of(240.0), Length::of(100.0)]];
    let (after, removed) = run(StreamAutomaton { flood: false, springs, ..StreamAutomaton::default() });
    let before = ground(48);
    let cut = (0..48 * 48).filter(|&i| after.elevation()[i] < before.elevation()[i]).count();
    assert!(removed > 0.0 && cut < 200, "{cut}");
}
