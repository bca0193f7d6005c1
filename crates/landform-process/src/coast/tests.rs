//! What coasts must keep: see validation targets CO1 to CO11 in `docs/pytel`.

use landform_core::algo::isoline::isolines;
use landform_core::analysis::dimension_by_boxes;
use landform_core::grid::{Edge, Edges, Grid, Shape};
use landform_core::math;
use landform_core::random::Seed;
use landform_core::sim::{Simulation, Stop};
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::{Length, Ratio};
use landform_core::verb::{Context, Edit, Stopped, Varying};

use super::*;

/// Land everywhere; the sea in the north, or all around.
fn ground(rows: usize, cols: usize, cell: f64, strip: bool) -> HeightField {
    let mut grid = Grid::new(Shape::new(rows, cols), [cell, cell]).unwrap();
    if strip {
        grid.edges = Edges { north: Edge::Open, south: Edge::Closed, east: Edge::Periodic, west: Edge::Periodic };
    }
    let n = grid.len();
    HeightField::new(grid, vec![4.0; n]).unwrap()
}

fn number(v: f64) -> Varying<landform_core::units::RatioDimension> {
    Ratio::of(v).into()
}

fn run(params: &CoastErosion, ground: HeightField, seed: u64) -> (HeightField, Stopped) {
    let mut simulation = Simulation::new(ground)
        .process(params.clone())
        .unwrap()
        .dt(YEAR)
        .until(Stop::steps(params.iterations))
        .seed(Seed(seed));
    let outcome = simulation.run().unwrap();
    assert!(outcome.budget.imbalance() < 1e-9);
    (simulation.into_terrain(), outcome.stopped)
}

fn land(field: &HeightField) -> Vec<bool> {
    field.elevation().iter().map(|&z| z > 0.0).collect()
}

/// Land that hangs together with the last row by sides.
fn mainland(field: &HeightField) -> Vec<bool> {
    let land = land(field);
    let Shape { rows, cols } = field.grid().shape;
    let mut main = vec![false; land.len()];
    let mut pending: Vec<usize> = ((rows - 1) * cols..rows * cols).filter(|&i| land[i]).collect();
    while let Some(i) = pending.pop() {
        if std::mem::replace(&mut main[i], true) {
            continue;
        }
        let (r, c) = (i / cols, i % cols);
        for (rr, cc) in [(r.wrapping_sub(1), c), (r + 1, c), (r, (c + 1) % cols), (r, (c + cols - 1) % cols)] {
            if rr < rows && land[rr * cols + cc] && !main[rr * cols + cc] {
                pending.push(rr * cols + cc);
            }
        }
    }
    main
}

/// The force at the end, the standard deviation of the outer coast's position and its dimension by
/// boxes of 2 cells to that.
fn percolation(damping: f64, seed: u64) -> (f64, f64, f64) {
    let force = 0.66;
    let params = CoastErosion {
        force: Some(number(force)),
        damping: number(damping),
        exposure: Exposure::None,
        iterations: 20_000,
        ..CoastErosion::default()
    };
    let (field, stopped) = run(&params, ground(512, 768, 1.0, true), seed);
    assert_eq!(stopped, Stopped::AtRest);
    let land = land(&field);
    let Shape { rows, cols } = field.grid().shape;
    let sea = |r: usize, c: usize| !land[r * cols + c];
    let sides: usize = (0..land.len())
        .filter(|&i| land[i])
        .map(|i| {
            let (r, c) = (i / cols, i % cols);
            usize::from(r == 0 || sea(r - 1, c))
                + usize::from(r + 1 < rows && sea(r + 1, c))
                + usize::from(sea(r, (c + 1) % cols))
                + usize::from(sea(r, (c + cols - 1) % cols))
        })
        .sum();
    let end = force / (1.0 + damping * sides as f64 / cols as f64);
    let main = mainland(&field);
    let rows_of: Vec<f64> = (0..main.len())
        .filter(|&i| main[i] && i / cols > 0)
        .filter(|&i| {
            [i - cols, i + 1, i - 1, (i + cols).min(main.len() - 1)].iter().any(|&j| j < main.len() && !main[j])
        })
        .map(|i| (i / cols) as f64)
        .collect();
    let mean = rows_of.iter().sum::<f64>() / rows_of.len() as f64;
    let width = (rows_of.iter().map(|r| (r - mean) * (r - mean)).sum::<f64>() / rows_of.len() as f64).sqrt();
    let values: Vec<f64> = main.iter().map(|&m| if m { 1.0 } else { -1.0 }).collect();
    let lines = isolines(field.grid(), &values, 0.0);
    let longest = lines.iter().max_by(|a, b| a.length().total_cmp(&b.length())).unwrap();
    let dimension = dimension_by_boxes(&[&longest.points], 2.0, width.max(12.0)).map_or(f64::NAN, |d| d.dimension);
    (end, width, dimension)
}

#[test]
fn weakly_damped_fronts_are_those_of_percolation() {
    // CO2 to CO4: dimension of the outer coast towards 4/3, width as g^-4/7, force towards the
    // threshold 0.5927 from below.
    let dampings = [0.1, 0.03, 0.01, 0.003, 0.001];
    let found: Vec<(f64, f64, f64)> = dampings
        .iter()
        .map(|&g| {
            let three: Vec<_> = (1..=3).map(|s| percolation(g, s)).collect();
            let mean = |f: fn(&(f64, f64, f64)) -> f64| three.iter().map(f).sum::<f64>() / 3.0;
            (mean(|t| t.0), mean(|t| t.1), mean(|t| t.2))
        })
        .collect();
    let line = dampings.iter().zip(&found).map(|(g, f)| (math::log(*g), math::log(f.1)));
    let (slope, ..) = math::line_fit(line);
    assert!((-0.66..=-0.50).contains(&slope), "{slope} {found:?}");
    assert!(found.windows(2).all(|w| w[0].0 < w[1].0) && found[4].0 < 0.5927 && found[4].0 > 0.56, "{found:?}");
    assert!((found[4].2 - 1.33).abs() < 0.07, "{found:?}");
}

#[test]
fn a_radius_over_the_whole_domain_is_the_global_model() {
    let global = CoastErosion { force: Some(number(0.6)), ..CoastErosion::default() };
    let local =
        CoastErosion { perimeter: Perimeter::Local { local: Length::of(1e4), search: Search::All }, ..global.clone() };
    let (a, _) = run(&global, ground(96, 96, 10.0, false), 5);
    let (b, _) = run(&local, ground(96, 96, 10.0, false), 5);
    let eroded = land(&a).iter().filter(|l| !**l).count();
    assert!(eroded > 500 && a.elevation() == b.elevation(), "{eroded}");
    // One sector is the whole map as well, but measures by marching squares.
    let one = CoastErosion { perimeter: Perimeter::Sectors { sectors: 0 }, ..global };
    let (c, _) = run(&one, ground(96, 96, 10.0, false), 5);
    let left = |f: &HeightField| land(f).iter().filter(|l| **l).count() as f64;
    // Lines across corners are shorter than stairs, so the sea is damped less: not the same island,
    // as with the radius above, but a smaller one.
    assert!(left(&c) < 0.85 * left(&a) && left(&c) > 0.72 * left(&a), "{} {}", left(&c), left(&a));
}

#[test]
fn counting_by_rows_agrees_with_counting_one_by_one() {
    for wraps in [[false, false], [true, false], [true, true]] {
        let shape = Shape::new(40, 50);
        let sites: Vec<usize> = (0..2000).filter(|&i| Seed(3).uniform(i as u64) < 0.3).collect();
        let sides: Vec<u8> = sites.iter().map(|&i| (Seed(4).uniform(i as u64) * 4.0) as u8).collect();
        let coast = perimeter::Coast { sites: &sites, sides: &sides, shape, land: &[], wraps };
        let all: Vec<u32> = (0..sites.len() as u32).collect();
        for radius in [3.0, 11.5, 19.0] {
            let (a, b) = perimeter::both_counts(&coast, &all, radius);
            assert!(a == b, "{wraps:?} {radius}");
        }
    }
}

#[test]
fn the_sea_rests_and_is_one() {
    // CO10, CO11.
    let params = CoastErosion { force: Some(number(0.62)), damping: number(0.1), ..CoastErosion::default() };
    let (field, stopped) = run(&params, ground(128, 128, 10.0, false), 2);
    assert_eq!(stopped, Stopped::AtRest);
    let land = land(&field);
    let sea = front::flood(field.grid(), field.elevation(), 0.0).unwrap();
    assert!(land.iter().zip(&sea).all(|(l, s)| l != s), "all water reaches the border");
    let age = field.fields().get(&names::SHORE_AGE, "test").unwrap();
    for i in (0..land.len()).filter(|&i| age[i] > 1) {
        let (r, c) = (i / 128, i % 128);
        let older = [(r.wrapping_sub(1), c), (r + 1, c), (r, c.wrapping_sub(1)), (r, c + 1)]
            .iter()
            .any(|&(r, c)| r >= 128 || c >= 128 || (age[r * 128 + c] > 0 && age[r * 128 + c] < age[i]));
        assert!(older, "what fell was beside the sea");
    }
    let (again, _) = run(&params, field.clone(), 2);
    let fell = again.elevation().iter().zip(field.elevation()).filter(|(a, b)| a != b).count();
    assert!(fell < land.len() / 2);
}

#[test]
fn weakening_straightens_the_coast() {
    // CO8, figure 4.6 with the amounts of table 4.5, each for the fall of one site. The coast
    // wears, and the sea stops at the same share of land.
    let length = |amount: f64| {
        let sum: f64 = (1..=4)
            .map(|seed| {
                let whole = amount * 0.6 * 0.6 * 60.0 * 60.0 / (15.0 * 15.0);
                let params = CoastErosion {
                    damping: number(0.2),
                    perimeter: Perimeter::Local { local: Length::of(150.0), search: Search::Contiguous },
                    exposure: Exposure::Proportional,
                    weakening: Some(Weakening { amount: whole, radius: Length::of(60.0) }),
                    wear: number(0.05),
                    until: Until::Land { land: 0.55 },
                    ..CoastErosion::default()
                };
                let (field, _) = run(&params, ground(256, 256, 15.0, false), seed);
                let values: Vec<f64> = land(&field).iter().map(|&m| if m { 1.0 } else { -1.0 }).collect();
                isolines(field.grid(), &values, 0.0).iter().map(|l| l.length()).sum::<f64>()
            })
            .sum();
        sum / 4.0
    };
    let lengths = [0.0, 0.05, 0.075, 0.1, 0.15, 0.175].map(length);
    // Little weakening first breaks the coast up; more straightens it.
    assert!(lengths[4] <= 0.85 * lengths[0] && lengths[5] <= 0.85 * lengths[0], "{lengths:?}");
    assert!(lengths[1..].windows(2).take(3).all(|w| w[1] < w[0]), "{lengths:?}");
}

/// Share of land and length of coast (sides over those at the start) that a sea leaves of a square
/// of 256 x 256 sites 15 m apart.
fn of_square(params: &CoastErosion, seed: u64) -> (f64, f64) {
    let (field, stopped) = run(params, ground(256, 256, 15.0, false), seed);
    assert_eq!(stopped, Stopped::AtRest);
    let land = land(&field);
    let is_sea = |r: usize, c: usize| r >= 256 || c >= 256 || !land[r * 256 + c];
    let sides = |i: usize| {
        let (r, c) = (i / 256, i % 256);
        let around = [(r.wrapping_sub(1), c), (r + 1, c), (r, c.wrapping_sub(1)), (r, c + 1)];
        around.into_iter().filter(|&(r, c)| is_sea(r, c)).count()
    };
    let length: usize = (0..land.len()).filter(|&i| land[i]).map(sides).sum();
    (land.iter().filter(|l| **l).count() as f64 / 65536.0, length as f64 / 1024.0)
}

#[test]
fn the_forces_of_the_thesis_work_as_printed() {
    // CO1: tables 4.3 and 4.4, with radii in sites of 15 m.
    let of = |force: f64, damping: f64, perimeter: Perimeter| {
        let params = CoastErosion {
            force: Some(number(force)),
            damping: number(damping),
            perimeter,
            exposure: Exposure::Proportional,
            ..CoastErosion::default()
        };
        let found = [1, 2].map(|seed| of_square(&params, seed));
        (0.5 * (found[0].0 + found[1].0), 0.5 * (found[0].1 + found[1].1))
    };
    for (force, damping) in [(0.495, 0.18), (0.476, 0.15), (0.46, 0.13), (0.444, 0.11)] {
        let (land, length) = of(force, damping, Perimeter::Whole(Whole::Global));
        assert!((0.79..0.87).contains(&land) && (2.9..4.0).contains(&length), "{force} {land} {length}");
    }
    for (damping, search) in [(0.2, Search::Contiguous), (0.15, Search::All)] {
        let rows =
            [2250.0, 3000.0, 3750.0].map(|r| of(0.5, damping, Perimeter::Local { local: Length::of(r), search }));
        assert!(rows.iter().all(|r| (0.8..0.95).contains(&r.0) && (1.7..4.0).contains(&r.1)), "{rows:?}");
        assert!(rows[0].0 < rows[2].0 && rows[0].1 > rows[2].1, "a smaller radius erodes more: {rows:?}");
    }
}

#[test]
fn every_parameter_may_be_a_map() {
    let text = "force = { formula = \"if(u < 0.5, 0.45, 0.65)\", unit = \"1\" }\nperimeter = { local = \"100 m\" }";
    let params: CoastErosion = toml_like(text);
    let (field, _) = run(&params, ground(100, 100, 10.0, false), 3);
    let land = land(&field);
    let taken = |east: bool| (0..land.len()).filter(|&i| !land[i] && (i % 100 >= 50) == east).count();
    assert!(taken(true) > 2 * taken(false), "{} {}", taken(true), taken(false));
}

/// Parameters from the little of TOML that this test needs.
fn toml_like(text: &str) -> CoastErosion {
    let mut json = serde_json::Map::new();
    for line in text.lines() {
        let (key, value) = line.split_once(" = ").unwrap();
        let value = value
            .replace(" = ", ": ")
            .replace("formula", "\"formula\"")
            .replace("unit", "\"unit\"")
            .replace("local", "\"local\"");
        json.insert(key.into(), serde_json::from_str(&value).unwrap());
    }
    serde_json::from_value(json.into()).unwrap()
}

#[test]
fn wear_without_an_end_is_refused() {
    let params = CoastErosion { wear: number(1.0), ..CoastErosion::default() };
    assert!(Simulation::new(ground(20, 20, 1.0, false)).process(params).err().unwrap().to_string().contains("until"));
    // How much a map gives is known when it is read.
    let wear = serde_json::from_str(r#"{"formula":"u","unit":"1"}"#).unwrap();
    let params = CoastErosion { wear, ..CoastErosion::default() };
    let mut simulation =
        Simulation::new(ground(20, 20, 1.0, false)).process(params).unwrap().dt(1.0).until(Stop::steps(5));
    assert!(simulation.run().unwrap_err().to_string().contains("until"));
}

#[test]
fn what_has_no_use_is_refused_and_an_end_out_of_reach_is_told() {
    let alone = CoastErosion { weakening_factor: Some(number(2.0)), ..CoastErosion::default() };
    let told = landform_core::verb::Params::validate(&alone).unwrap_err().to_string();
    assert!(told.contains("weakening_factor") && told.contains("together with weakening"), "{told}");
    let weakening = Some(Weakening { amount: 1.6, radius: Length::of(75.0) });
    assert!(landform_core::verb::Params::validate(&CoastErosion { weakening, ..alone }).is_ok());
    let until =
        |land| CoastErosion { force: Some(number(0.4)), until: Until::Land { land }, ..CoastErosion::default() };
    assert_eq!(run(&until(0.1), ground(60, 60, 10.0, false), 1).1, Stopped::AtRestTooSoon);
    assert_eq!(run(&until(0.99), ground(60, 60, 10.0, false), 1).1, Stopped::AtRest);
}

/// A step of a year.
pub(in crate::coast) fn step(index: u64) -> Step {
    Step {
        index,
        of: None,
        time: index as f64 * YEAR,
        dt: YEAR,
        seed: Seed(2),
        environment: Default::default(),
        cancel: Default::default(),
    }
}

/// Steps of a coast whose ground `moves` before each.
fn beside(
    params: &CoastErosion,
    mut field: HeightField,
    steps: u64,
    moves: impl Fn(u64, &mut [f64]),
) -> (HeightField, State) {
    let context = Context { seed: Seed(1), ..Context::default() };
    let mut state = params.start(&mut field, &context).unwrap();
    for index in 0..steps {
        field.change(Layer::Bedrock, |z| moves(index, z));
        let at = step(index);
        // As after a checkpoint: nothing hangs on what it does not hold.
        if index % 3 == 1 {
            state.front = None;
        }
        params.step(&mut field, &mut state, &at).unwrap();
    }
    (field, state)
}

#[test]
fn a_coast_heeds_ground_that_rises_and_sinks_beside_it() {
    let sides = |n: usize, i: usize| [i % n, n - 1 - i % n, i / n, n - 1 - i / n].into_iter().min().unwrap();
    // The floor comes up over the sea after five rounds: it is land again, and the sea starts from
    // the border.
    let strong = CoastErosion { force: Some(number(10.0)), ..CoastErosion::default() };
    let lift = |index: u64, z: &mut [f64]| {
        if index == 5 {
            z.iter_mut().for_each(|z| *z += 6.0);
        }
    };
    let (field, state) = beside(&strong, ground(40, 40, 10.0, false), 5, lift);
    assert!((0..1600).all(|i| (field.elevation()[i] > 0.0) == (sides(40, i) >= 5)) && state.left == 900);
    let (field, state) = beside(&strong, ground(40, 40, 10.0, false), 7, lift);
    assert!((0..1600).all(|i| (field.elevation()[i] > 0.0) == (sides(40, i) >= 2)) && state.left == 36 * 36);
    assert!((0..1600).all(|i| (state.age[i] > 5) == (sides(40, i) < 2)), "what rose is no sea of old");
    // A ramp sinks: its lower part drowns, and the sea goes on from the new shore.
    let ramp = || {
        let mut field = ground(40, 40, 10.0, false);
        field.change(Layer::Bedrock, |z| z.iter_mut().enumerate().for_each(|(i, z)| *z = 0.55 + 0.1 * (i % 40) as f64));
        field
    };
    let weak = CoastErosion { force: Some(number(0.0)), ..CoastErosion::default() };
    let (_, state) = beside(&weak, ramp(), 6, |index, z| {
        if index == 2 {
            z.iter_mut().for_each(|z| *z -= 2.0);
        }
    });
    // In the last column of what drowned the ground lies 0.05 m under the sea.
    assert_eq!(state.left, 40 * 25);
    assert!((0..1600).all(|i| state.age[i] == if i % 40 < 15 { 3 } else { 0 }));
    assert!(state.rests);
}

#[test]
fn a_coast_alone_is_the_same_after_a_checkpoint_and_opens_lows() {
    let params = CoastErosion { force: Some(number(10.0)), ..CoastErosion::default() };
    let mut field = ground(40, 40, 10.0, false);
    // A low inland, which the sea reaches after three rounds, and enters at once.
    field.change(Layer::Bedrock, |z| (3..20).for_each(|c| z[20 * 40 + c] = -1.0));
    let (field, state) = beside(&params, field, 3, |_, _| {});
    assert!((3..20).all(|c| state.age[20 * 40 + c] == 3 && field.elevation()[20 * 40 + c] == -1.0));
}

#[test]
fn small_islands_go_and_large_ones_stay() {
    let mut field = ground(40, 40, 1.0, false);
    field.change(Layer::Bedrock, |z| {
        z.fill(-5.0);
        for r in 5..20 {
            for c in 5..20 {
                z[r * 40 + c] = 4.0;
            }
        }
        (30..34).for_each(|c| z[30 * 40 + c] = 4.0);
    });
    let context = Context { seed: Seed(1), ..Context::default() };
    PruneIslands::default().edit(&mut field, &context).unwrap();
    assert_eq!(land(&field).iter().filter(|l| **l).count(), 225);
}

#[test]
fn the_inside_of_a_cone_is_a_cone() {
    // Level sets at equal distances: heights are linear in the distance, without creases, whatever
    // the interpolation.
    let n = 121;
    let grid = Grid::new(Shape::new(n, n), [1.0, 1.0]).unwrap();
    let lattice = landform_core::grid::Lattice::of(&grid);
    let radius = |i: usize| math::hypot((i % n) as f64 - 60.0, (i / n) as f64 - 60.0);
    let levels: Vec<u32> =
        (0..n * n).map(|i| if radius(i) >= 55.0 { 0 } else { 1 + ((55.0 - radius(i)) / 11.0) as u32 }).collect();
    for (kind, most) in [(LevelInterpolation::Linear, 1.2), (LevelInterpolation::Hermite, 1.2)] {
        let z = heights::heights(&lattice, &levels, 11.0, 1.0, kind, |_| false);
        let worst =
            (0..n * n).filter(|&i| levels[i] > 0).map(|i| (z[i] - (55.0 - radius(i))).abs()).fold(0.0, f64::max);
        assert!(worst < most, "{kind:?} {worst}");
    }
    let terraces = heights::heights(&lattice, &levels, 11.0, 1.0, LevelInterpolation::Nearest, |_| false);
    assert!(terraces.iter().all(|z| z % 5.5 == 0.0));
}

#[test]
fn islands_get_hills_within_their_outline() {
    for interpolation in [LevelInterpolation::Nearest, LevelInterpolation::Hermite] {
        let mut field = ground(90, 90, 10.0, false);
        let params = IslandInterior { interpolation, spacing: Length::of(80.0), ..IslandInterior::default() };
        params.edit(&mut field, &Context { seed: Seed(3), ..Context::default() }).unwrap();
        let levels = field.fields().get(&names::LEVEL_SET, "test").unwrap();
        let most = *levels.iter().max().unwrap();
        assert!(most >= 4 && levels.iter().all(|&l| l > 0), "{most}");
        let top = field.elevation().iter().copied().fold(0.0, f64::max);
        let interval = params.interval.si();
        assert!(top >= f64::from(most - 1) * interval && top <= f64::from(most) * interval + 1e-9);
        assert!(
            field
                .elevation()
                .iter()
                .zip(levels)
                .all(|(z, &l)| { *z >= f64::from(l - 1) * interval - 1e-9 && *z <= f64::from(l) * interval + 1e-9 })
        );
    }
}

#[test]
fn the_weakest_sites_fall_as_in_a_round_over_all() {
    let grid = Grid::new(Shape::new(80, 90), [10.0; 2]).unwrap();
    for (weakening, damping) in [(None, 0.3), (Some(25.0), 0.1)] {
        let material = || (0..grid.len()).map(|i| Seed(4).uniform(i as u64)).collect();
        let kind = (Exposure::Proportional, Perimeter::Whole(Whole::Global));
        let front = || front::Front::new(&grid, vec![true; grid.len()], material(), kind, weakening, None).unwrap();
        let (mut all, mut by_heap, mut force) = (front(), front(), 0.2);
        let mut weakest = weakest::Weakest::new(&mut by_heap);
        for _ in 0..4000 {
            let drive = Drive { force: &|_| force, damping: &|_| damping, wear: &|_| 0.0, weakening: &|_| 0.2 };
            let (a, b) = (all.round(&drive), weakest.round(&mut by_heap, (force, damping), &drive));
            assert_eq!(a.fallen, b.fallen);
            assert!(!a.fallen.is_empty() || a.needed == b.needed, "{} {}", a.needed, b.needed);
            force *= if a.fallen.is_empty() { a.needed.clamp(1.0, 2.0) * (1.0 + 1e-9) } else { 1.0 };
        }
        assert!(all.land == by_heap.land && all.material == by_heap.material);
        assert!(all.land.iter().filter(|l| **l).count() < grid.len() / 2);
    }
}
