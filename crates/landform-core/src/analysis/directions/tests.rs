use super::*;
use crate::algo::noise::self_affine;
use crate::grid::Shape;
use crate::random::Seed;

fn value(found: &Directions, name: &str) -> f64 {
    found.gates.iter().find(|g| g.name == name).and_then(|g| g.value).unwrap()
}

#[test]
fn an_eight_sided_cone_shows_its_lattice_and_a_round_one_does_not() {
    let grid = Grid::new(Shape::new(201, 201), [20.0; 2]).unwrap();
    let cone = |sides: bool| {
        let height = |i: usize| {
            let cell = grid.shape.cell(i);
            let (x, y) = ((cell.col as f64 - 100.3).abs(), (cell.row as f64 - 100.8).abs());
            let way = if sides { x.max(y) + 0.414_213_56 * x.min(y) } else { (x * x + y * y).sqrt() };
            3000.0 - 12.0 * way
        };
        directions_of(&HeightField::new(grid.clone(), (0..grid.len()).map(height).collect()).unwrap())
    };
    let (facets, round) = (cone(true), cone(false));
    assert!(value(&facets, "aspect_peak") > 4.0 && value(&facets, "plane_share") > 0.5, "{facets:?}");
    assert!(facets.outside().contains(&"aspect_peak") && facets.outside().contains(&"slope_mode"));
    assert!(value(&round, "aspect_peak") < 1.6, "{round:?}");
    // On eight rays through its top a lattice holds slopes that face along it exactly.
    assert!((value(&round, "aspect_45") - 1.0).abs() < 0.2, "{round:?}");
}

#[test]
fn a_valley_along_the_lattice_is_straight() {
    let grid = Grid::new(Shape::new(101, 101), [20.0; 2]).unwrap();
    let z = (0..grid.len())
        .map(|i| {
            let cell = grid.shape.cell(i);
            8.0 * (cell.col as f64 - 50.0).abs() + 3.0 * cell.row as f64
        })
        .collect();
    let found = directions_of(&HeightField::new(grid, z).unwrap());
    assert!(value(&found, "straight_channels") > 0.9 && value(&found, "reach_45") > 0.9, "{found:?}");
}

#[test]
fn noise_has_hollows_as_sharp_as_its_crests() {
    let grid = Grid::new(Shape::new(256, 256), [30.0; 2]).unwrap();
    let z = self_affine(grid.shape, grid.spacing, 0.8, Seed(2)).iter().map(|v| 300.0 * v).collect();
    let found = directions_of(&HeightField::new(grid, z).unwrap());
    assert!((value(&found, "hollow_sharpness") - 1.0).abs() < 0.1, "{found:?}");
    assert!(value(&found, "aspect_r8").abs() < 0.02);
}
