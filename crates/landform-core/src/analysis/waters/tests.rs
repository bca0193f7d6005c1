use super::*;
use crate::grid::{Edges, Shape};
use crate::math;
use crate::random::Seed;
use crate::terrain::HeightField;

fn field() -> HeightField {
    let shape = Shape::new(60, 70);
    let grid = Grid { edges: Edges::default(), ..Grid::new(shape, [50.0, 50.0]).unwrap() };
    let z = (0..shape.len()).map(|i| {
        let cell = shape.cell(i);
        let tilt = 3.0 * (cell.row as f64 - 20.0).abs();
        tilt + 20.0 * Seed(6).uniform(i as u64) + 12.0 * math::sin(cell.col as f64 * 0.4) - 10.0
    });
    HeightField::new(grid, z.collect()).unwrap()
}

#[test]
fn rivers_only_run_downhill_and_end_at_the_sea() {
    let field = field();
    let drainage = Drainage::of(&field, Some(0.0), 1.0 / crate::units::YEAR);
    let list = rivers(&field, &drainage, 15.0 * 2500.0, Width::default());
    assert!(list.len() > 10 && list.iter().any(|r| r.order > 1), "{}", list.len());
    for r in &list {
        assert!(r.points.windows(2).all(|p| p[1][2] <= p[0][2]), "{r:?}");
        assert!(r.width >= r.width_above && r.length > 0.0);
        let expected = r.area / crate::units::YEAR;
        assert!((r.discharge / expected - 1.0).abs() < 1e-9);
        if let Some(to) = r.to {
            let below = list.iter().find(|b| (b.river, b.reach) == to).unwrap();
            assert_eq!(below.points[0], r.points[r.points.len() - 1]);
        } else {
            assert!(r.leaves && (r.points[r.points.len() - 1][2] == 0.0 || r.points[0][2] < 0.0));
        }
    }
}

#[test]
fn a_river_crosses_a_lake_and_does_not_follow_its_floor() {
    let shape = Shape::new(41, 81);
    let z = (0..shape.len()).map(|i| {
        let (r, c) = (shape.cell(i).row as f64 - 20.0, shape.cell(i).col as f64);
        let thread = 9.0 * math::sin(c / 3.0);
        match c {
            _ if c < 10.0 => 90.0 + (10.0 - c) + 3.0 * r.abs(),
            _ if c > 70.0 => 80.0 - (c - 70.0) + 3.0 * r.abs(),
            _ if r.abs() > 12.0 => 100.0,
            _ if (r - thread).abs() < 1.5 => 40.0,
            _ => 50.0 + Seed(3).uniform(i as u64),
        }
    });
    let field = HeightField::new(Grid::new(shape, [1.0, 1.0]).unwrap(), z.collect()).unwrap();
    let drainage = Drainage::of(&field, None, 0.0);
    let (mut node, mut length) = (shape.index(20, 5), 0.0);
    while drainage.flow.receivers()[node] as usize != node {
        length += drainage.domain.distance(node, drainage.flow.slots()[node]);
        node = drainage.flow.receivers()[node] as usize;
    }
    assert_eq!(shape.cell(node).col, 80);
    assert!(length < 1.2 * 75.0, "{length}");
}

#[test]
fn lakes_are_flat_and_their_volumes_sum() {
    let field = field();
    let drainage = Drainage::of(&field, None, 0.0);
    let list = lakes(&field, &drainage, 0.0, 0.0);
    let volume: f64 = (0..field.grid().len()).map(|i| (drainage.level[i] - field.elevation()[i]) * 2500.0).sum();
    let total: f64 = list.iter().map(|l| l.volume).sum();
    assert!(list.len() > 5 && (total / volume - 1.0).abs() < 1e-9);
    assert!(list.windows(2).all(|l| l[0].area >= l[1].area) && list.iter().all(|l| l.depth > 0.0));
    let some = lakes(&field, &drainage, 2.0, 4.0 * 2500.0);
    assert!(!some.is_empty() && some.len() < list.len());
}

#[test]
fn basins_cover_the_ground() {
    let field = field();
    let drainage = Drainage::of(&field, None, 0.0);
    let list = basins(&field, &drainage, 0.0);
    let inner = 58 * 68;
    let total: f64 = list.iter().map(|b| b.area).sum();
    assert!((total - inner as f64 * 2500.0).abs() < 1e-3);
    assert!(list.iter().all(|b| !b.outline.is_empty() && (0.0..=1.0).contains(&b.hypsometric_integral)));
}
