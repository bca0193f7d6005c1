//! Snow targets SN1 to SN5.

use landform_core::algo::derivative::gradient;
use landform_core::grid::{Edge, Edges, Grid, Shape};
use landform_core::sim::{Simulation, Stop};

use super::*;

fn snowed(field: HeightField, params: &Snow) -> (HeightField, landform_core::verb::Outcome) {
    let mut simulation = Simulation::new(field)
        .process(params.clone())
        .unwrap()
        .dt(1.0)
        .until(Stop::steps(params.iterations))
        .seed(Seed(1));
    let outcome = simulation.run().unwrap();
    (simulation.into_terrain(), outcome)
}

fn depth(field: &HeightField) -> Vec<f64> {
    field.depth("snow").unwrap().to_vec()
}

/// Hills of many sizes, with slopes up to about 60 degrees.
fn hills() -> HeightField {
    let grid = Grid::new(Shape::new(161, 161), [10.0, 10.0]).unwrap();
    let z = (0..grid.len())
        .map(|i| {
            let [x, y] = grid.position(i);
            let noise = landform_core::algo::noise::fbm(Seed(9), x / 500.0, y / 500.0, 5, 2.0, 0.5);
            2_000.0 + 220.0 * noise
        })
        .collect();
    HeightField::new(grid, z).unwrap()
}

#[test]
fn what_falls_lies_melts_or_is_blown_away() {
    let params = Snow { snow_line: Some(Length::of(2_100.0)), melt: Length::of(1.0), ..Snow::default() };
    let ground = hills();
    let (field, outcome) = snowed(ground.clone(), &params);
    let area = ground.grid().cell_area();
    let lies: f64 = depth(&field).iter().sum::<f64>() * area;
    let change = outcome.budget.change;
    assert!(((lies + change.exported) / change.supplied - 1.0).abs() < 1e-9, "{lies} {change:?}");
    assert!(outcome.budget.imbalance() < 1e-9 && outcome.budget.sediment_imbalance() < 1e-9);
    assert!(depth(&field).iter().all(|d| *d >= 0.0) && lies > 0.0);
}

#[test]
fn a_level_plain_stays_level() {
    let mut grid = Grid::new(Shape::new(60, 80), [10.0, 10.0]).unwrap();
    grid.edges = Edges::all(Edge::Closed);
    let n = grid.len();
    for from in [270.0, 0.0, 225.0, 200.0] {
        let params = Snow { wind: vec![Wind::from(from, 1.0)], ..Snow::default() };
        let (field, _) = snowed(HeightField::new(grid.clone(), vec![100.0; n]).unwrap(), &params);
        let d = depth(&field);
        assert!(d.iter().all(|v| (v - d[0]).abs() < 1e-12 * d[0].max(1.0)), "{from}");
    }
}

#[test]
fn steep_ground_keeps_little_and_depths_spread_as_on_real_hills() {
    let (field, _) = snowed(hills(), &Snow { snow_line: Some(Length::of(1_000.0)), ..Snow::default() });
    let bare = hills();
    let d = depth(&field);
    let slope = |i: usize| math::atan(gradient(bare.grid(), bare.elevation(), i).slope()).to_degrees();
    let mean = |from: f64, to: f64| {
        let within: Vec<f64> = (0..d.len()).filter(|&i| (from..to).contains(&slope(i))).map(|i| d[i]).collect();
        assert!(within.len() > 20, "{from} {}", within.len());
        within.iter().sum::<f64>() / within.len() as f64
    };
    // SN2: from 35 degrees on, less and less; beyond 55 hardly any.
    let bins: Vec<f64> = [35.0, 40.0, 45.0, 50.0, 55.0].windows(2).map(|w| mean(w[0], w[1])).collect();
    assert!(bins.windows(2).all(|w| w[1] < w[0]), "{bins:?}");
    // SN4.
    let all = d.iter().sum::<f64>() / d.len() as f64;
    let cv = (d.iter().map(|v| (v - all) * (v - all)).sum::<f64>() / d.len() as f64).sqrt() / all;
    assert!((0.2..0.8).contains(&cv), "{cv} {bins:?}");
    assert!(bins[3] < 0.5 * all, "{bins:?} {all}");
}

#[test]
fn more_lies_in_the_lee_of_a_ridge() {
    // SN3, for winds along rows, columns and aslant.
    for from in [270.0, 180.0, 225.0] {
        let grid = Grid::new(Shape::new(121, 121), [5.0, 5.0]).unwrap();
        let towards = Wind::from(from, 1.0).towards();
        let along = |i: usize| {
            let [x, y] = grid.position(i);
            (x - 300.0) * towards[0] + (y - 300.0) * towards[1]
        };
        let z = (0..grid.len()).map(|i| 40.0 * math::exp(-along(i) * along(i) / (2.0 * 45.0 * 45.0))).collect();
        let params = Snow { wind: vec![Wind::from(from, 1.0)], snow_line: Some(Length::of(-100.0)), ..Snow::default() };
        let (field, _) = snowed(HeightField::new(grid.clone(), z).unwrap(), &params);
        let d = depth(&field);
        let side = |from: f64, to: f64| {
            let near: Vec<f64> = (0..d.len())
                .filter(|&i| {
                    let [x, y] = grid.position(i);
                    (from..to).contains(&along(i)) && (100.0..500.0).contains(&x) && (100.0..500.0).contains(&y)
                })
                .map(|i| d[i])
                .collect();
            near.iter().sum::<f64>() / near.len() as f64
        };
        let ratio = side(20.0, 90.0) / side(-90.0, -20.0);
        assert!(ratio > 1.3, "{from}: {ratio}");
    }
}
