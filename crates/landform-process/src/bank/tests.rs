use landform_core::grid::{Edge, Edges, Grid, Shape};
use landform_core::sim::Model;
use landform_core::terrain::NodeSurface;
use landform_core::units::KYR;

use super::*;

const CELL: f64 = 20.0;
const COLS: usize = 30;

/// A river down the middle row to the east, which falls 1 in 100, between walls.
fn valley(wall: impl Fn(usize) -> f64) -> HeightField {
    let mut grid = Grid::new(Shape::new(11, COLS), [CELL; 2]).unwrap();
    grid.edges = Edges { east: Edge::Open, ..Edges::all(Edge::Closed) };
    let height = |i: usize| {
        let (row, col) = (i / COLS, i % COLS);
        0.01 * CELL * (COLS - 1 - col) as f64 + if row == 5 { 0.0 } else { wall(row) + 0.5 * row.abs_diff(5) as f64 }
    };
    HeightField::new(grid, (0..11 * COLS).map(height).collect()).unwrap()
}

fn worn(ratio: f64) -> LateralErosion {
    LateralErosion { erodibility: Erodibility::of(1e-4).into(), ratio, least_area: Area::of(2e4), ..Default::default() }
}

/// Bank that the river's node in a column of the middle row wears off in a second, m³/s.
fn rate(col: usize) -> f64 {
    let area = 11.0 * CELL * CELL * (col + 1) as f64;
    let width = 7.2 * (area / YEAR).sqrt();
    1e-4 / YEAR * area.sqrt() * 0.01 * width * CELL
}

#[test]
fn a_wall_stands_until_its_volume_is_worn() {
    // The last before the base level: it has most water, and its banks fall first.
    let col = COLS - 2;
    // Half of the wear of a straight river goes to each side.
    let volume = |height: f64| (height + 0.5 + 0.1) * CELL * CELL;
    for height in [2.0, 6.0] {
        let falls_after = volume(height) / (0.5 * rate(col));
        let mut model = Model::new(valley(|_| height)).dt(falls_after / 40.5);
        model.add(worn(1.0)).unwrap();
        let node = 4 * COLS + col;
        let before = model.terrain().elevation()[node];
        let mut steps = 0;
        while model.terrain().elevation()[node] == before && steps < 60 {
            model.advance_steps(1).unwrap();
            steps += 1;
        }
        assert_eq!(steps, 41, "{height} m");
        let budget = model.budget();
        assert!(budget.imbalance() < 1e-12 && budget.change.eroded > 0.0 && budget.sediment_imbalance() < 1e-12);
    }
}

#[test]
fn low_walls_give_way_and_high_walls_stand() {
    // The wall is low in the north.
    let mut model = Model::new(valley(|row| if row < 5 { 1.0 } else { 50.0 })).dt(20.0 * KYR);
    model.add(worn(2.0)).unwrap();
    let before = model.terrain().elevation().to_vec();
    model.advance_steps(40).unwrap();
    let z = model.terrain().elevation();
    let fell = |row: usize| (5..25).filter(|col| z[row * COLS + col] < before[row * COLS + col] - 0.5).count();
    assert!(fell(4) > 15 && fell(6) == 0, "{} {}", fell(4), fell(6));
}

#[test]
fn the_outer_bank_takes_the_wear_of_a_bend() {
    let mut grid = Grid::new(Shape::new(30, 30), [CELL; 2]).unwrap();
    grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
    // East along row 10 to column 15, then south: the river turns right, and its outer bank is in
    // the north and the east.
    let on = |row: usize, col: usize| (row == 10 && col <= 15) || (col == 15 && row > 10);
    let height = |i: usize| {
        let (row, col) = (i / 30, i % 30);
        let left = if row <= 10 { (15 - col.min(15)) + 19 } else { 29 - row };
        if on(row, col) { 0.3 * left as f64 } else { 30.0 + 0.01 * (row + col) as f64 }
    };
    let ground = HeightField::new(grid, (0..900).map(height).collect()).unwrap();
    let domain = ground.domain();
    let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
    flow.route(&*domain, ground.elevation(), &mut area);
    let course = Course::new(&ground, &*domain, flow.receivers(), &area, 10.0 * CELL * CELL);
    // Water cuts the corner, so that it turns at the node before, by arctan 2.
    let bend = 10 * 30 + 14;
    assert!(course.rivers().contains(&bend));
    let outer = 0.5 * (1.0 + 2.0 / 5.0_f64.sqrt());
    assert!((course.share(bend, Side::Left) - outer).abs() < 1e-9);
    assert!((course.share(bend, Side::Left) + course.share(bend, Side::Right) - 1.0).abs() < 1e-12);
    // North-east of it.
    assert_eq!(course.bank(bend, Side::Left), Some(9 * 30 + 15));
    // Far from it the sides are alike.
    assert!((course.share(10 * 30 + 10, Side::Left) - 0.5).abs() < 1e-9);
}

#[test]
fn a_run_that_is_cut_goes_on_with_the_same_bits() {
    let model = || {
        let mut model = Model::new(valley(|_| 3.0)).dt(5.0 * KYR);
        model.add(worn(2.0)).unwrap();
        model
    };
    let mut whole = model();
    whole.advance_steps(30).unwrap();
    let mut first = model();
    first.advance_steps(11).unwrap();
    let mut second = model();
    second.restore("k", &first.save("k").unwrap()).unwrap();
    second.advance_steps(19).unwrap();
    assert!(whole.terrain().elevation() == second.terrain().elevation());
}
