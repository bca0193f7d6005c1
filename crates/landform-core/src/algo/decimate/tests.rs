use std::collections::BTreeMap;

use super::*;
use crate::grid::{Edge, Edges, Grid, Shape};
use crate::random::Seed;
use crate::terrain::{HeightField, Layer, Mesh, NodeSurface, mesh_parts_from_height_field};

type Parts = (Vec<[f64; 3]>, Vec<[u32; 3]>);

fn raster(rows: usize, cols: usize, height: impl Fn([f64; 2]) -> f64) -> Parts {
    let grid = Grid::new(Shape::new(rows, cols), [2.0, 3.0]).unwrap();
    let z = (0..grid.len()).map(|i| height(grid.position(i))).collect();
    mesh_parts_from_height_field(&HeightField::new(grid, z).unwrap())
}

fn rough(at: [f64; 2]) -> f64 {
    let [x, y] = at;
    20.0 * crate::math::sin(0.05 * x) * crate::math::cos(0.08 * y)
        + 2.0 * Seed(3).uniform((x * 1000.0 + y).abs() as u64)
}

fn area(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> f64 {
    triangles.iter().map(|t| plan_area(t.map(|i| points[i as usize]))).sum()
}

/// The result as a surface of its own; checks what every result has.
fn checked((points, triangles): &Parts, tolerance: f64) -> (Decimated, f64) {
    let thin = decimate(points, triangles, tolerance);
    let left: Vec<[f64; 3]> = thin.kept.iter().map(|&i| points[i as usize]).collect();
    // Nothing turned over, the plan is covered, no edge is used twice.
    assert!(thin.triangles.iter().all(|t| plan_area(t.map(|i| left[i as usize])) > 0.0));
    let (before, after) = (area(points, triangles), area(&left, &thin.triangles));
    assert!((after / before - 1.0).abs() < 1e-9, "{before} {after}");
    let mut edges = BTreeMap::new();
    for &[a, b, c] in &thin.triangles {
        for edge in [(a, b), (b, c), (c, a)] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    assert!(edges.values().all(|&n| n == 1));
    // Every node, by a search of its own, is as near as it is said to be.
    let mut greatest = 0.0_f64;
    let used: std::collections::BTreeSet<u32> = triangles.iter().flatten().copied().collect();
    for &i in &used {
        let p = points[i as usize];
        let above = thin.triangles.iter().map(|t| t.map(|i| left[i as usize])).filter_map(|corners| {
            let weights = error::weights(corners, p);
            let inside = weights.iter().all(|&w| w >= -1e-9);
            inside.then(|| (error::height(corners, weights) - p[2]).abs())
        });
        let off = above.fold(f64::INFINITY, f64::min);
        assert!(off <= tolerance + 1e-9, "node {i}: {off} m off, {tolerance} m allowed");
        greatest = greatest.max(off);
    }
    (thin, greatest)
}

#[test]
fn every_node_lies_within_the_error() {
    let ground = raster(41, 37, rough);
    let mut last = usize::MAX;
    for tolerance in [0.3, 1.0, 3.0, 10.0] {
        let (thin, greatest) = checked(&ground, tolerance);
        assert!((thin.error - greatest).abs() < 1e-9, "{} {greatest}", thin.error);
        assert!(thin.kept.len() < last);
        last = thin.kept.len();
    }
    // Waves of 20 m within 10 m, with noise of 2 m on them.
    assert!(last < 41 * 37 / 20, "{last}");
}

#[test]
fn a_plane_needs_its_corners_alone() {
    let (thin, _) = checked(&raster(33, 65, |[x, y]| 0.5 * x - 0.25 * y), 1e-6);
    assert!(thin.kept.len() <= 8, "{}", thin.kept.len());
    assert!(checked(&raster(2, 2, |_| 1.0), 1.0).0.triangles.len() == 2);
}

#[test]
fn nothing_is_lost_where_nothing_may_be() {
    let ground = raster(20, 20, rough);
    let same = decimate(&ground.0, &ground.1, 0.0);
    assert_eq!((same.kept.len(), same.triangles, same.error), (400, ground.1.clone(), 0.0));
    for tolerance in [f64::NAN, -1.0] {
        assert_eq!(decimate(&ground.0, &ground.1, tolerance).kept.len(), 400);
    }
    assert!(decimate(&[], &[], 1.0).kept.is_empty());
    let lone = decimate(&[[0.0; 3]], &[], 1.0);
    assert_eq!(lone.kept, [0]);
    // However much is allowed, a rectangle remains.
    assert!(checked(&ground, 1e12).0.kept.len() >= 4);
}

#[test]
fn holes_keep_their_outline() {
    let seed = Seed(7);
    // Every eighth node is missing at random, and a round lake.
    let holes = raster(40, 50, |[x, y]| {
        let lake = (x - 70.0).abs() + (y - 40.0).abs() < 15.0;
        let missing = seed.uniform((x * 512.0 + y).abs() as u64) < 0.03;
        if lake || missing { f64::NAN } else { rough([x, y]) }
    });
    for tolerance in [1.0, 100.0] {
        checked(&holes, tolerance);
    }
}

#[test]
fn an_irregular_mesh_is_thinned_too() {
    let seed = Seed(5);
    let mut sites = Vec::new();
    for k in 0..900_u64 {
        sites.push([seed.uniform(2 * k) * 300.0, seed.uniform(2 * k + 1) * 200.0]);
    }
    let mut mesh = Mesh::delaunay(&sites, Edges::all(Edge::Open)).unwrap();
    let z: Vec<f64> = mesh.positions().iter().map(|p| 30.0 * crate::math::sin(p[0] / 40.0)).collect();
    mesh.change(Layer::Bedrock, |elevation| elevation.copy_from_slice(&z));
    let points = mesh.positions().iter().zip(mesh.elevation()).map(|(p, z)| [p[0], p[1], *z]).collect();
    let (thin, _) = checked(&(points, mesh.triangles().to_vec()), 2.0);
    assert!(thin.kept.len() < 450, "{}", thin.kept.len());
}
