use landform_core::algo::sampling::poisson_disk;
use landform_core::grid::{Domain, Edge, Edges, Grid, Shape, Status};
use landform_core::random::Seed;
use landform_core::sim::Model;
use landform_core::terrain::Rasterize;
use landform_core::units::{Area, Erodibility, KYR, Rate};
use landform_core::verb::Budget;

use super::*;
use crate::stream_power::StreamPower;
use crate::uplift::Uplift;

const C: f64 = 4.0 * 1e4 / (2700.0 * GRAVITY);

fn strength(cohesion_height: f64) -> Strength {
    Strength { cohesion_height, chance: 1.0 }
}

/// Ground of `rows` by `cols` nodes, 10 m apart.
fn ground(rows: usize, cols: usize, edge: Edge, z: impl Fn(f64, f64) -> f64) -> HeightField {
    let mut grid = Grid::new(Shape::new(rows, cols), [10.0; 2]).unwrap();
    grid.edges = Edges::all(edge);
    let z = (0..grid.len()).map(|i| z(grid.position(i)[0], grid.position(i)[1])).collect();
    HeightField::new(grid, z).unwrap()
}

/// Steep ridges and valleys that end in open sides, with a hole.
fn rough(n: usize) -> HeightField {
    let side = (n - 1) as f64 * 10.0;
    ground(n, n, Edge::Open, |x, y| {
        let hole = (side / 3.0 - x).abs().max((side / 3.0 - y).abs()) < 15.0;
        let edge = x.min(side - x).min(y).min(side - y);
        let z = edge * (0.8 + 0.6 * math::sin(x / 37.0) * math::cos(y / 51.0));
        if hole { f64::NAN } else { z.max(0.0) }
    })
}

fn slid<T: Periodic>(ground: T, params: Landslides, dt: f64, steps: u64) -> (T, Budget) {
    let mut model = Model::new(ground).dt(dt).seed(Seed(7));
    model.add(params).unwrap();
    model.advance_steps(steps).unwrap();
    model.finish().unwrap();
    let budget = model.budget();
    (model.into_terrain(), budget)
}

#[test]
fn slopes_stand_to_culmanns_height() {
    let friction = 30.0_f64.to_radians();
    // A vertical cut: 4 C/(ρ g) · cos φ/(1 − sin φ).
    let cut = strength(C).critical_height(f64::INFINITY, math::tan(friction));
    assert!((cut / (C * math::cos(friction) / (1.0 - math::sin(friction))) - 1.0).abs() < 1e-12, "{cut}");
    // 60 degrees: sin 60 cos 30/(1 − cos 30) = 5.598.
    let slope = strength(C).critical_height(3.0_f64.sqrt(), math::tan(friction));
    assert!((slope / C - 5.598_076).abs() < 1e-5, "{slope}");
    for gentle in [0.0, math::tan(friction), -1.0] {
        assert_eq!(strength(C).critical_height(gentle, math::tan(friction)), f64::INFINITY);
    }
    assert_eq!(strength(0.0).critical_height(2.0, 1.0), 0.0);
}

#[test]
fn a_wedge_and_a_bowl_have_their_volumes() {
    // A face of slope s up to a plateau at h; what stands above a surface of slope t from its foot.
    let (s, t, h, foot) = (2.0, 1.0, 200.0, 500.0);
    let face = |y: f64| ((y - foot) * s).clamp(0.0, h);
    let dig = |field: &HeightField, foot: usize| {
        let rupture = Rupture { foot, slope: t, floor: f64::NEG_INFINITY, greatest_area: f64::INFINITY };
        let places = Places { position: &|i| field.position(i), periods: field.periods() };
        Search::default().dig(&*field.domain(), &places, &rupture, &mut field.elevation().to_vec())
    };
    let strip = ground(101, 1, Edge::Closed, |_, y| face(y));
    let node = (0..101).find(|&i| strip.grid().position(i)[1] == foot).unwrap();
    let wedge = 10.0 * 0.5 * h * h * (1.0 / t - 1.0 / s);
    let found = dig(&strip, node);
    assert!((found.volume / wedge - 1.0).abs() < 0.01, "{found:?} {wedge}");
    assert!((found.area - 1900.0).abs() < 1.0, "{found:?}");
    let wide = ground(101, 101, Edge::Closed, |_, y| face(y));
    let found = dig(&wide, node * 101 + 50);
    let n = 20_000;
    let bowl = (0..n).map(|k| {
        let angle = (f64::from(k) + 0.5) / f64::from(n) * std::f64::consts::PI;
        let rise = s * math::sin(angle);
        if rise <= t {
            return 0.0;
        }
        let (top, end) = (h / rise, h / t);
        let upper = |r: f64| 0.5 * h * r * r - t * r * r * r / 3.0;
        (rise - t) * top * top * top / 3.0 + upper(end) - upper(top)
    });
    let bowl = bowl.sum::<f64>() * std::f64::consts::PI / f64::from(n);
    assert!((found.volume / bowl - 1.0).abs() < 0.01, "{found:?} {bowl}");
}

#[test]
fn volumes_close_and_base_levels_stay() {
    let start = rough(60);
    for (fines, greatest, loose) in [(0.0, None, false), (0.3, Some(Area::of(3_000.0)), true)] {
        let params = Landslides { fines, greatest_area: greatest, loose, ..Landslides::default() };
        let (after, budget) = slid(start.clone(), params, 20.0 * KYR, 30);
        assert!(budget.change.eroded > 1e5, "{budget:?}");
        assert!(budget.imbalance() < 1e-9 && budget.sediment_imbalance() < 1e-9, "{budget:?}");
        assert!(budget.change.exported >= fines * budget.change.eroded);
        let (z, domain) = (after.elevation(), start.domain());
        for (i, status) in domain.status().iter().enumerate() {
            match status {
                Status::Interior => assert!(z[i].is_finite() && z[i] >= 0.0),
                Status::BaseLevel => assert_eq!(z[i], start.elevation()[i]),
                Status::Masked => assert!(z[i].is_nan()),
            }
        }
        let deposit = after.fields.get(&names::LANDSLIDE_DEPOSIT, "test").unwrap();
        let gravel = after.depth("gravel").map(|d| d.iter().sum::<f64>());
        let laid = deposit.iter().filter(|d| d.is_finite()).sum::<f64>();
        assert!(laid > 0.0 && gravel.is_none_or(|gravel| (gravel / laid - 1.0).abs() < 0.5), "{laid} {gravel:?}");
        assert_eq!(gravel.is_some(), loose);
        let area = after.fields.get(&names::LANDSLIDE_AREA, "test").unwrap();
        let most = area.iter().copied().fold(0.0, f64::max);
        assert!(greatest.is_none_or(|g| most <= g.si()), "{most}");
    }
}

#[test]
fn a_long_step_lets_all_steep_ground_fail_once() {
    let cliff = || ground(1, 60, Edge::Closed, |x, _| if x < 300.0 { 200.0 } else { 0.0 });
    let (after, budget) = slid(cliff(), Landslides::default(), 1e9 * KYR, 1);
    assert!(budget.change.eroded > 1e4 && budget.imbalance() < 1e-9, "{budget:?}");
    // Many steps end with ground that friction holds: every failure halves what its angle is above.
    let (after, _) = slid(after, Landslides::default(), 1e9 * KYR, 40);
    let steepest = after.elevation().windows(2).map(|z| (z[0] - z[1]).abs() / 10.0).fold(0.0, f64::max);
    assert!(steepest <= math::tan(35.0_f64.to_radians()) + 1e-3, "{steepest}");
}

#[test]
fn a_deposit_has_the_runout_angle_however_large_cells_are() {
    for cell in [5.0, 20.0] {
        let mut grid = Grid::new(Shape::new(81, 81), [cell; 2]).unwrap();
        grid.edges = Edges::all(Edge::Closed);
        let field = HeightField::new(grid, vec![0.0; 81 * 81]).unwrap();
        let (mut z, volume, slope) = (field.elevation().to_vec(), 1e3 * cell * cell * cell, 0.36);
        let (mut laid, domain) = (0.0, field.domain());
        let debris = Debris { volume, slope, parts: 1e6 };
        let area = cell * cell;
        let left = run_out(&*domain, 40 * 81 + 40, &debris, &mut z, &mut Vec::new(), |_, rise| laid += rise * area);
        assert!(left == 0.0 && (laid / volume - 1.0).abs() < 1e-9);
        // A cone of height h and volume π h³/(3 S²).
        let height = z.iter().copied().fold(0.0, f64::max);
        let cone = math::cbrt(3.0 * volume * slope * slope / std::f64::consts::PI);
        assert!((0.9..1.25).contains(&(height / cone)), "{height} {cone}");
    }
}

#[test]
fn threads_resuming_and_the_lattice_do_not_matter() {
    let make = |jittered: bool| {
        let start = if jittered { rough(50).jittered(Seed(3)).unwrap() } else { rough(50) };
        let mut model = Model::new(start).dt(10.0 * KYR).seed(Seed(2));
        model.add(Uplift { rate: Rate::of(1.0).into() }).unwrap();
        model.add(Landslides { loose: true, ..Landslides::default() }).unwrap();
        model.add(StreamPower { erodibility: Some(Erodibility::of(1e-5).into()), ..StreamPower::default() }).unwrap();
        model
    };
    for jittered in [false, true] {
        let whole = parallel::with_threads(1, || {
            let mut model = make(jittered);
            model.advance_steps(8).unwrap();
            assert!(model.budget().imbalance() < 1e-9, "{:?}", model.budget());
            model.finish().unwrap();
            model.save("test").unwrap()
        })
        .unwrap();
        let cut = parallel::with_threads(3, || {
            let mut first = make(jittered);
            first.advance_steps(5).unwrap();
            let saved = first.save("test").unwrap();
            let mut second = make(jittered);
            second.restore("test", &saved).unwrap();
            second.advance_steps(3).unwrap();
            second.finish().unwrap();
            second.save("test").unwrap()
        })
        .unwrap();
        assert!(whole == cut, "jittered {jittered}");
    }
}

#[test]
fn ground_may_be_a_mesh_a_torus_or_one_node() {
    let sites = poisson_disk([600.0, 600.0], 15.0, Seed(1)).unwrap();
    let mut mesh = Mesh::delaunay(&sites, Edges::default()).unwrap();
    let hill: Vec<f64> =
        mesh.positions().iter().map(|p| (300.0 - math::hypot(p[0] - 300.0, p[1] - 300.0)).max(0.0)).collect();
    mesh.change(Layer::Bedrock, |z| z.copy_from_slice(&hill));
    let (_, budget) = slid(mesh, Landslides::default(), 100.0 * KYR, 10);
    assert!(
        budget.change.eroded > 1e4 && budget.imbalance() < 1e-9 && budget.sediment_imbalance() < 1e-9,
        "{budget:?}"
    );
    let torus = ground(40, 40, Edge::Periodic, |x, y| 200.0 * (math::sin(x / 63.66) + math::sin(y / 63.66)));
    let (_, budget) = slid(torus, Landslides::default(), 100.0 * KYR, 10);
    assert!(budget.change.eroded > 1e4 && budget.change.exported == 0.0 && budget.imbalance() < 1e-9, "{budget:?}");
    let (_, budget) = slid(ground(1, 1, Edge::Closed, |_, _| 5.0), Landslides::default(), KYR, 3);
    assert_eq!(budget.change.eroded, 0.0);
}
