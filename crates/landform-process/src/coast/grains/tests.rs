//! Coasts on grains: the same whatever the cells.

use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::sim::{Simulation, Stop};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Length, Ratio, YEAR};
use landform_core::verb::{Context, Process};

use super::Grains;
use crate::coast::tests::step;
use crate::coast::{CoastErosion, Exposure, Perimeter, Search};

const SIDE: f64 = 1920.0;

fn square(cell: f64) -> HeightField {
    let n = (SIDE / cell) as usize + 1;
    HeightField::new(Grid::new(Shape::new(n, n), [cell; 2]).unwrap(), vec![4.0; n * n]).unwrap()
}

/// Coasts of the thesis' forces: the global one of table 4.3 and the local one of table 4.4.
fn params(grain: Option<f64>, local: bool) -> CoastErosion {
    let (force, damping, perimeter) = if local {
        (0.5, 0.2, Perimeter::Local { local: Length::of(200.0), search: Search::All })
    } else {
        (0.476, 0.15, CoastErosion::default().perimeter)
    };
    CoastErosion {
        force: Some(Ratio::of(force).into()),
        damping: Ratio::of(damping).into(),
        exposure: Exposure::Proportional,
        grain: grain.map(Length::of),
        perimeter,
        ..CoastErosion::default()
    }
}

fn eroded(cell: f64, params: &CoastErosion, seed: u64) -> HeightField {
    let stop = Stop::steps(params.iterations);
    let mut sim = Simulation::new(square(cell)).process(params.clone()).unwrap().dt(YEAR).until(stop).seed(Seed(seed));
    let outcome = sim.run().unwrap();
    assert!(outcome.budget.imbalance() < 1e-9);
    sim.into_terrain()
}

fn share(field: &HeightField) -> f64 {
    field.elevation().iter().filter(|z| **z > 0.0).count() as f64 / field.grid().len() as f64
}

#[test]
fn the_same_coast_forms_whatever_the_cells() {
    for local in [false, true] {
        let fields = [30.0, 15.0, 7.5].map(|cell| eroded(cell, &params(Some(30.0), local), 3));
        let shares = fields.each_ref().map(share);
        assert!(shares.iter().all(|s| (0.55..0.75).contains(s) && (s - shares[2]).abs() < 0.015), "{shares:?}");
        let coarse = &fields[0];
        let side = coarse.grid().shape.cols;
        for (fine, by) in [(&fields[1], 2), (&fields[2], 4)] {
            let cols = fine.grid().shape.cols;
            let alike = |i: &usize| {
                let k = (i / side) * by * cols + (i % side) * by;
                (coarse.elevation()[*i] > 0.0) == (fine.elevation()[k] > 0.0)
            };
            let same = (0..coarse.grid().len()).filter(alike).count() as f64 / coarse.grid().len() as f64;
            assert!(same > 0.995, "{same}");
        }
    }
}

#[test]
fn sides_add_up_and_every_node_has_a_grain() {
    let field = square(15.0);
    let grains = Grains::new(&field, 40.0, Seed(1)).unwrap();
    let mut nodes: Vec<u32> = (0..grains.len()).flat_map(|g| grains.nodes(g).to_vec()).collect();
    nodes.sort_unstable();
    assert!(nodes.iter().enumerate().all(|(k, &i)| k as u32 == i) && nodes.len() == field.grid().len());
    for g in (0..grains.len()).filter(|&g| grains.beyond[g].is_none()) {
        // What a grain shares with another the other shares with it.
        for (to, side) in grains.sides(g) {
            let back = grains.sides(to).find(|s| s.0 == g).map(|s| s.1).unwrap();
            assert!((back - side).abs() < 1e-3, "{side} {back}");
        }
    }
    // Edges of polygons zigzag: more than a straight line, less than a staircase of squares.
    assert!((1.1..1.42).contains(&grains.ragged), "{}", grains.ragged);
}

#[test]
fn grains_that_cannot_be_are_refused() {
    let field = square(30.0);
    for size in [1.0, 1e6, f64::NAN] {
        assert!(Grains::new(&field, size, Seed(1)).is_err());
    }
    let mut grid = field.grid().clone();
    grid.edges = landform_core::grid::Edges::all(landform_core::grid::Edge::Periodic);
    let torus = HeightField::new(grid, field.elevation().to_vec()).unwrap();
    assert!(Grains::new(&torus, 40.0, Seed(1)).is_err());
}

#[test]
fn a_coast_on_grains_is_the_same_after_a_checkpoint_and_on_any_number_of_threads() {
    use landform_core::parallel::with_threads;
    let params = CoastErosion { iterations: 12, ..params(Some(30.0), true) };
    let one = with_threads(1, || eroded(15.0, &params, 3)).unwrap();
    let two = with_threads(2, || eroded(15.0, &params, 3)).unwrap();
    assert!(one.elevation() == two.elevation());
    // As after a checkpoint: nothing hangs on what the state does not hold.
    let stepped = |forgets: bool| {
        let mut field = square(15.0);
        let mut state = params.start(&mut field, &Context { seed: Seed(1), ..Context::default() }).unwrap();
        for index in 0..12 {
            state.front = if forgets { None } else { state.front };
            params.step(&mut field, &mut state, &step(index)).unwrap();
        }
        field
    };
    let whole = stepped(false);
    assert!(whole.elevation() == stepped(true).elevation() && share(&whole) < 0.95);
}

#[test]
fn a_look_leaves_the_share_of_land_that_is_asked_for() {
    use crate::coast::Look;
    let mut coast = Vec::new();
    for look in [Look::Rugged, Look::Skerries, Look::Smooth] {
        let params = CoastErosion {
            look: Some(look),
            land: Some(0.55),
            grain: Some(Length::of(40.0)),
            ..CoastErosion::default()
        };
        let field = eroded(20.0, &params, 2);
        assert!((share(&field) - 0.55).abs() < 0.08, "{look:?} {}", share(&field));
        let cols = field.grid().shape.cols;
        let z = field.elevation();
        coast.push((0..z.len() - cols).filter(|&i| (z[i] > 0.0) != (z[i + cols] > 0.0)).count());
    }
    // The smooth coast is the shortest, that of the skerries the longest.
    assert!(coast[2] * 2 < coast[0] && coast[0] < coast[1], "{coast:?}");
}

#[test]
fn a_share_without_a_look_finds_the_force_and_what_contradicts_is_refused() {
    use landform_core::verb::Params;
    let given = CoastErosion { land: Some(0.8), force: None, ..params(Some(40.0), true) };
    assert!(given.validate().is_ok());
    assert!((share(&eroded(20.0, &given, 2)) - 0.8).abs() < 0.08);
    let number = |v: f64| Ratio::of(v).into();
    for wrong in [
        CoastErosion { force: Some(number(0.5)), ..given.clone() },
        CoastErosion { land: Some(1.0), ..given.clone() },
        CoastErosion { look: Some(crate::coast::Look::Rugged), ..given.clone() },
        CoastErosion { wear: number(0.1), ..given },
    ] {
        assert!(wrong.validate().is_err());
    }
}
