//! The scheme along characteristics.

use landform_core::verb::Params;

use super::*;

fn sharp(m: f64) -> StreamPower {
    StreamPower { scheme: Scheme::Sharp, ..law(m, 1.0) }
}

fn line(n: usize, cell: f64) -> HeightField {
    let mut grid = Grid::new(Shape::new(1, n), [cell, cell]).unwrap();
    grid.edges = Edges { west: Edge::Open, ..Edges::all(Edge::Closed) };
    HeightField::new(grid, (0..n).map(|i| 0.01 * i as f64).collect()).unwrap()
}

fn evolve<T: NodeSurface>(terrain: T, rate: f64, rivers: StreamPower, dt: f64, time: f64) -> T {
    let stop = Stop::time(time);
    let mut sim = Simulation::new(terrain).process(uplift(rate)).unwrap().process(rivers).unwrap().dt(dt).until(stop);
    let outcome = sim.run().unwrap();
    assert!(outcome.budget.imbalance() < 1e-9, "{outcome:?}");
    sim.into_terrain()
}

const CELL: f64 = 25.0;

/// After 2 Myr of doubled uplift: the cell and the travel time, in Myr, at which the steepness, 1
/// above and 2 below, is 1.9, 1.5 and 1.1; and the cell where the travel time is 2 Myr.
fn knickpoint(rivers: StreamPower, dt: f64) -> ([(usize, f64); 3], usize) {
    let (n, m, time) = (401, 0.45, 2.0 * MYR);
    let settled = steady(line(n, CELL), law(m, 1.0), 10.0 * MYR);
    let terrain = evolve(settled, 2.0, rivers, dt, time);
    let z = terrain.elevation();
    let area = |i: usize| math::pow(CELL * CELL * (n - i) as f64, m);
    let mut tau = vec![0.0; n];
    for i in 1..n {
        tau[i] = tau[i - 1] + CELL / (K / YEAR * area(i)) / MYR;
    }
    let steepness = |i: usize| (z[i] - z[i - 1]) / CELL * area(i) * K / U;
    let below = |k: f64| (1..n).find(|&i| steepness(i) < k).unwrap();
    ([1.9, 1.5, 1.1].map(|k| (below(k), tau[below(k)])), (1..n).find(|&i| tau[i] > 2.0).unwrap())
}

#[test]
fn a_knickpoint_stays_where_it_belongs_and_sharp() {
    for dt in [1.0, 5.0, 20.0] {
        let ([low, middle, high], expected) = knickpoint(sharp(0.45), dt * KYR);
        assert!(middle.0.abs_diff(expected) <= 1, "{dt} kyr: {middle:?} {expected}");
        let width = high.1 - low.1;
        assert!(width <= 0.1 * 2.0, "{dt} kyr: {low:?} {high:?}");
    }
    // What it is to be smeared.
    let ([low, _, high], _) = knickpoint(law(0.45, 1.0), 5.0 * KYR);
    assert!(high.1 - low.1 > 0.2 * 2.0, "{low:?} {high:?}");
}

#[test]
fn a_steady_state_stays_what_it_is() {
    let settled = steady(raster(30, 2), law(0.5, 1.0), 10.0 * MYR);
    let before = settled.elevation().to_vec();
    let highest = before.iter().copied().fold(0.0, f64::max);
    // Waves pass less than a cell in a step, and from the outlet to the divides.
    for dt in [1.0, 3_000.0] {
        let after = evolve(settled.clone(), 1e3 * U, sharp(0.5), dt * KYR, 3.0 * dt * KYR);
        let off = before.iter().zip(after.elevation()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-6 * highest, "{dt} kyr: {off} of {highest} m");
    }
}

#[test]
fn from_any_start_it_comes_to_the_steady_state() {
    let found = evolve(raster(30, 2), 1e3 * U, sharp(0.5), 20.0 * KYR, 6.0 * MYR);
    // Slope and area at every node, where water has one way.
    let rows = profile(&found, 0.5);
    let off = rows.iter().map(|row| (row[1] * row[0].sqrt() * K / U - 1.0).abs());
    let mut off: Vec<f64> = off.collect();
    off.sort_by(f64::total_cmp);
    assert!(off[off.len() / 2] < 0.01, "{}", off[off.len() / 2]);
}

#[test]
fn what_it_does_not_solve_is_refused() {
    let refused = |rivers: StreamPower| rivers.validate().unwrap_err().parameter_name().map(String::from);
    assert_eq!(refused(StreamPower { slope_exponent: 2.0, ..sharp(0.5) }).as_deref(), Some("slope_exponent"));
    assert_eq!(refused(StreamPower { deposition: 1.0, ..sharp(0.5) }).as_deref(), Some("deposition"));
    assert_eq!(refused(StreamPower { threshold: 1.0, ..sharp(0.5) }).as_deref(), Some("threshold"));
    assert_eq!(refused(StreamPower { limiting_slope: Some(0.9), ..sharp(0.5) }).as_deref(), Some("limiting_slope"));
    sharp(0.5).validate().unwrap();
    // Rock that no river wears, and steps without end, do no harm.
    for k in [0.0, 1e3] {
        let rivers = StreamPower { erodibility: Some(Erodibility::of(k).into()), ..sharp(0.5) };
        let worn = evolve(raster(12, 3), 1.0, rivers, 1e3 * MYR, 3e3 * MYR);
        assert!(worn.elevation().iter().all(|z| z.is_finite() && *z >= 0.0));
    }
}
