use landform_core::grid::{Edge, Edges, Grid, Shape};
use landform_core::sim::Model;
use landform_core::terrain::{Brush, Ground, Materials, NodeSurface, Terrain};
use landform_core::units::{Angle, Length, Rate};
use landform_core::verb::{Environment, Params};

use super::motion::{State as Motion, hindered, richardson_zaki};
use super::path::End;
use super::wind::WindField;
use super::*;

fn raster(n: usize, cell: f64, z: impl Fn([f64; 2]) -> f64) -> HeightField {
    let mut grid = Grid::new(Shape::new(n, n), [cell; 2]).unwrap();
    grid.edges = Edges::all(Edge::Open);
    let heights = (0..grid.len()).map(|i| z(grid.position(i))).collect();
    HeightField::new(grid, heights).unwrap()
}

/// Voxels under a surface, full in part.
fn voxels(n: usize, cell: f64, levels: usize, z: impl Fn([f64; 2]) -> f64) -> VoxelGrid {
    let plan = Grid::new(Shape::new(n, n), [cell; 2]).unwrap();
    let part = |i: usize| {
        let (level, node) = (i / plan.len(), i % plan.len());
        ((z(plan.position(node)) - level as f64 * cell) / cell).clamp(0.0, 1.0) as f32
    };
    let fill = (0..levels * plan.len()).map(part).collect();
    let mut ground = VoxelGrid::from_fn(plan.clone(), levels, 0.0, cell, &Materials::default(), |_, _| None).unwrap();
    ground.set_fill(fill).unwrap();
    ground
}

fn body(viscosity: f64) -> Body {
    Body { radius: 2.0, density: 1500.0, viscosity }
}

fn still<T: Ground>(ground: &T, level: Option<f64>) -> Fluids {
    let params = ParticleErosion::default();
    Fluids::new(&params, ground, &ground.bounding_box(), level, Seed(1)).unwrap()
}

/// Follows one particle that neither wears nor lays.
fn bare(restitution: f64, friction: f64) -> Law {
    let params = ParticleErosion {
        erosion: Some(0.0),
        restitution: Some(restitution),
        friction: Some(friction),
        ..ParticleErosion::default()
    };
    Law::new(&params, &Phenomenon::Rain.preset(), None, 0.0)
}

/// PE1.
#[test]
fn a_particle_ends_at_the_velocity_of_stokes() {
    let body = body(5e4);
    let expected = 2.0 / 9.0 * (1500.0 - 1000.0) * 9.81 * 4.0 / 5e4;
    let mut state = Motion { at: [0.0; 3], velocity: [3.0, 0.0, 8.0] };
    for _ in 0..2000 {
        state = body.fly(state, 1500.0, 1000.0, [0.0; 3], 0.37);
    }
    assert!((state.velocity[2] / -expected - 1.0).abs() < 1e-9, "{state:?}");
    assert!(state.velocity[0].abs() < 1e-9);
    // Lighter than water it rises, as fast as Stokes says.
    let light = Body { density: 500.0, ..body };
    let mut state = Motion { at: [0.0; 3], velocity: [0.0; 3] };
    (0..2000).for_each(|_| state = light.fly(state, 500.0, 1000.0, [0.0; 3], 0.37));
    assert!((state.velocity[2] / expected - 1.0).abs() < 1e-9);
    // Steps do not show.
    let from = Motion { at: [0.0; 3], velocity: [3.0, 1.0, 8.0] };
    let two = body.fly(body.fly(from, 1500.0, 1.0, [2.0, 0.0, 0.0], 0.4), 1500.0, 1.0, [2.0, 0.0, 0.0], 0.6);
    let one = body.fly(from, 1500.0, 1.0, [2.0, 0.0, 0.0], 1.0);
    assert!((0..3).all(|k| (one.at[k] - two.at[k]).abs() < 1e-9));
}

/// PE2.
#[test]
fn settling_is_hindered_as_richardson_and_zaki_say() {
    assert_eq!([1e-3, 1e4].map(richardson_zaki), [4.65, 2.4]);
    assert!((richardson_zaki(0.5) - 4.4 * math::pow(0.5, -0.03)).abs() < 1e-12);
    let law = Hindrance::RichardsonZaki;
    assert_eq!(hindered(law, 0.0, 0.3, 4.65), 1.0);
    assert!((hindered(law, 0.2, 0.3, 4.65) - math::pow(0.8, 4.65)).abs() < 1e-15);
    assert_eq!(hindered(Hindrance::Legacy, 0.3, 0.3, 4.65), 0.0);
}

/// PE3.
#[test]
fn brushes_move_the_volume_that_they_are_given() {
    let mut plain = raster(41, 5.0, |_| 50.0);
    for (at, radius) in [([100.0, 100.0], 23.0), ([3.0, 1.0], 23.0), ([101.0, 99.0], 0.1)] {
        let before = plain.elevation().to_vec();
        let moved = plain.lay(Brush { at: [at[0], at[1], 50.0], radius }, 400.0, 0);
        let rise: f64 = plain.elevation().iter().zip(&before).map(|(a, b)| (a - b) * 25.0).sum();
        assert!((rise / moved - 1.0).abs() < 1e-12 && moved == 400.0, "{at:?}: {rise}");
    }
    // The half-sphere of Equation 6.9 in the middle: 3 Q / (2 pi R^2).
    let mut fine = raster(201, 0.25, |_| 0.0);
    fine.lay(Brush { at: [25.0, 25.0, 0.0], radius: 20.0 }, 1000.0, 0);
    let middle = fine.elevation_at([25.0, 25.0]);
    assert!((middle / (1.5 * 1000.0 / (std::f64::consts::PI * 400.0)) - 1.0).abs() < 1e-3, "{middle}");
    let mut block = voxels(21, 5.0, 20, |_| 50.0);
    let (before, mut load) = (block.volume(), vec![0.0; block.materials().all().len()]);
    let taken = block.take(Brush { at: [50.0, 50.0, 50.0], radius: 22.0 }, 3000.0, &mut load);
    assert!(((before - block.volume()) / taken - 1.0).abs() < 1e-9);
    assert!((taken / 3000.0 - 1.0).abs() < 1e-5 && (load.iter().sum::<f64>() / taken - 1.0).abs() < 1e-9, "{taken}");
    let laid = block.lay(Brush { at: [30.0, 60.0, 50.0], radius: 22.0 }, 3000.0, 0);
    assert!(((block.volume() - before + taken) / laid - 1.0).abs() < 1e-9 && (laid / 3000.0 - 1.0).abs() < 1e-5);
}

/// PE6.
#[test]
fn a_bounce_comes_back_to_the_square_of_the_restitution() {
    let plain = raster(21, 1.0, |_| 0.0);
    for e in [0.3, 0.5, 0.8, 1.0] {
        let (body, law) = (Body { radius: 0.01, density: 2000.0, viscosity: 0.0 }, bare(e, 0.0));
        let mut state = Motion { at: [10.0, 10.0, 5.0], velocity: [0.0; 3] };
        let (mut highest, mut depth, mut hit) = (0.0_f64, -5.0, false);
        for _ in 0..4000 {
            let next = body.fly(state, 2000.0, 1.0, [0.0; 3], 1e-3);
            let next_depth = plain.depth_at(next.at).unwrap();
            if next_depth > 0.0 && hit {
                break;
            }
            if next_depth > 0.0 {
                let at = body.fly(state, 2000.0, 1.0, [0.0; 3], 1e-3 * depth / (depth - next_depth));
                state = Motion { velocity: law.leave(at.velocity, [0.0, 0.0, 1.0], 1e-3), ..at };
                (depth, hit) = (0.0, true);
                continue;
            }
            (state, depth) = (next, next_depth);
            highest = if hit { highest.max(state.at[2]) } else { 0.0 };
        }
        assert!((highest / (5.0 * e * e) - 1.0).abs() < 0.01, "{e}: {highest}");
    }
    assert!(ParticleErosion { restitution: Some(1.2), ..ParticleErosion::default() }.validate().is_err());
}

fn last_state<T: Erodible>(ground: &T, fluids: &Fluids, law: &Law, particle: Particle) -> Option<Motion> {
    Some(trace(ground, fluids, law, particle).ok()?.last)
}

/// The highest energy over the weight, m, on a way.
fn highest_energy<T: Erodible>(ground: &T, law: &Law, start: Motion) -> f64 {
    let body = Body { radius: 4.0, density: 1000.0, viscosity: 0.0 };
    let energy = |s: &Motion| 0.5 * motion::dot(s.velocity, s.velocity) + GRAVITY * (1.0 - AIR / 1000.0) * s.at[2];
    let (mut state, mut most) = (start, f64::NEG_INFINITY);
    for steps in 1..400 {
        let law = Law { most_steps: steps, ..law.clone() };
        let ended = last_state(ground, &still(ground, None), &law, Particle { body, state: start, load: 0.0 });
        state = ended.unwrap_or(state);
        most = most.max(energy(&state) / energy(&start));
    }
    most
}

#[test]
fn energy_never_grows_where_nothing_rubs() {
    let shapes: [fn([f64; 2]) -> f64; 3] = [
        |[x, _]| 0.4 * x,
        |[x, y]| 60.0 + 20.0 * math::sin(x / 30.0) * math::cos(y / 25.0),
        |[x, y]| 0.002 * ((x - 100.0) * (x - 100.0) + (y - 100.0) * (y - 100.0)),
    ];
    for shape in shapes {
        let ground = raster(51, 4.0, shape);
        for e in [0.0, 0.6, 1.0] {
            for (x, y) in [(150.0, 110.0), (61.0, 133.0)] {
                let start = Motion { at: [x, y, shape([x, y]) + 3.0], velocity: [1.0, -0.5, 0.0] };
                let most = highest_energy(&ground, &bare(e, 0.0), start);
                assert!(most <= 1.0 + 1e-9, "{most}");
            }
        }
    }
}

#[test]
fn a_pile_below_the_angle_of_friction_rests_and_what_is_light_rises() {
    let slope = raster(41, 5.0, |[x, _]| 0.3 * x);
    let heavy = Particle { body: body(1e3), state: Motion { at: [100.0, 100.0, 30.0], velocity: [0.0; 3] }, load: 0.0 };
    let end = |friction: f64| {
        let trace = trace(&slope, &still(&slope, None), &bare(0.0, friction), heavy).unwrap();
        trace.end
    };
    let End::Here(at) = end(0.5) else { panic!("left") };
    assert!((at[0] - 100.0).abs() < 1.0, "{at:?}");
    assert_eq!(end(0.1), End::Left, "less friction than slope");
    let plain = raster(41, 5.0, |_| 0.0);
    let light = Body { density: 400.0, ..body(1e3) };
    let state = Motion { at: [100.0, 100.0, 10.0], velocity: [0.0; 3] };
    let risen =
        last_state(&plain, &still(&plain, Some(80.0)), &bare(0.0, 0.5), Particle { body: light, state, load: 0.0 });
    assert!(risen.unwrap().at[2] > 70.0);
}

fn hill(n: usize, cell: f64) -> impl Fn([f64; 2]) -> f64 {
    let middle = 0.5 * (n - 1) as f64 * cell;
    move |[x, y]| {
        let r = math::hypot(x - middle, y - middle) / middle;
        20.0 + 40.0 * math::exp(-4.0 * r * r)
    }
}

fn run<T: Erodible>(ground: T, params: &ParticleErosion, steps: u64) -> Model<T> {
    let mut model = Model::new(ground).dt(YEAR).seed(Seed(3));
    model.add(params.clone()).unwrap();
    model.advance_steps(steps).unwrap();
    model
}

fn rain() -> ParticleErosion {
    ParticleErosion { particles: Some(400), radius: Some(Length::of(12.0)), ..ParticleErosion::default() }
}

/// PE4, with a load that comes from outside.
#[test]
fn mass_closes_on_every_ground() {
    fn check<T: Erodible>(ground: T, params: &ParticleErosion) {
        let model = run(ground, params, 4);
        let (budget, change) = (model.budget(), model.budget().change);
        assert!(change.eroded > 0.0 && change.deposited + change.supplied > 0.0, "{change:?}");
        assert!(budget.imbalance() < 1e-9, "{:e}", budget.imbalance());
        assert!(budget.sediment_imbalance() < 1e-9, "{:e}", budget.sediment_imbalance());
    }
    let ground = || raster(41, 6.0, hill(41, 6.0));
    let mut layered = ground();
    layered.make_layered(&Materials::default());
    layered.change_depth("sand", &vec![1.5; 41 * 41]).unwrap();
    for phenomenon in [Phenomenon::Rain, Phenomenon::Volcano, Phenomenon::River, Phenomenon::Landslide] {
        let params = ParticleErosion { phenomenon, ..rain() };
        check(ground(), &params);
        check(layered.clone(), &params);
        check(voxels(41, 6.0, 14, hill(41, 6.0)), &params);
    }
}

/// PE5.
#[test]
fn a_load_stays_between_nothing_and_what_finds_room() {
    let ground = raster(61, 6.0, hill(61, 6.0));
    let (params, preset) = (rain(), Phenomenon::Rain.preset());
    for (erosion, deposition) in [(1.0, 0.0), (1.0, 1.0), (0.02, 0.5)] {
        let params = ParticleErosion { erosion: Some(erosion), deposition: Some(deposition), ..params.clone() };
        let law = Law::new(&params, &preset, None, 0.0);
        let (bounds, fluids) = (ground.bounding_box(), still(&ground, None));
        let source = Source { ground: &ground, bounds, fluids: &fluids, emitter: Emitter::Sky, towards: None };
        for k in 0..50 {
            let trace = params.follow(&source, &law, &preset, [12.0, 12.0], Seed(k)).unwrap().unwrap();
            let most = law.capacity * 4.0 / 3.0 * std::f64::consts::PI * 12.0 * 12.0 * 12.0;
            let mut load = 0.0;
            for step in &trace.exchanges {
                load -= step.volume;
                assert!((-1e-9..=most * (1.0 + 1e-12)).contains(&load), "{load} of {most}");
            }
        }
    }
}

/// PE9.
#[test]
fn threads_do_not_show() {
    let with = |threads: usize| {
        parallel::with_threads(threads, || {
            let field = run(raster(41, 6.0, hill(41, 6.0)), &rain(), 3).into_terrain();
            let block = run(voxels(41, 6.0, 14, hill(41, 6.0)), &rain(), 2).into_terrain();
            (field, block)
        })
        .unwrap()
    };
    assert!(with(1) == with(4));
}

/// PE8: the same seeds on the same hill.
/// Strong enough that whole voxels fall.
fn on_a_hill() -> ParticleErosion {
    ParticleErosion {
        particles: Some(2500),
        radius: Some(Length::of(15.0)),
        erosion: Some(2.5e-3),
        max_steps: 300,
        deposits: "rock".into(),
        ..rain()
    }
}

/// Correlation of two changes of height after a blur of `reach` cells.
fn correlation(a: &[f64], b: &[f64], n: usize, reach: usize) -> f64 {
    let blurred = |z: &[f64]| -> Vec<f64> {
        let near = |i: usize| i.saturating_sub(reach)..(i + reach + 1).min(n);
        let mean = |i: usize| {
            let (row, col) = (i / n, i % n);
            let sum: f64 = near(row).flat_map(|r| near(col).map(move |c| z[r * n + c])).sum();
            sum / (near(row).len() * near(col).len()) as f64
        };
        (0..n * n).map(mean).collect()
    };
    let centred = |z: Vec<f64>| {
        let mean = z.iter().sum::<f64>() / z.len() as f64;
        z.into_iter().map(|v| v - mean).collect::<Vec<_>>()
    };
    let (a, b) = (centred(blurred(a)), centred(blurred(b)));
    let with = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    with(&a, &b) / (with(&a, &a) * with(&b, &b)).sqrt()
}

#[test]
fn grounds_agree() {
    let (n, cell) = (49, 5.0);
    let before = raster(n, cell, hill(n, cell));
    let mut layered = before.clone();
    layered.make_layered(&Materials::default());
    let plain = run(before.clone(), &on_a_hill(), 4);
    let change = |after: &[f64]| after.iter().zip(before.elevation()).map(|(a, b)| a - b).collect::<Vec<_>>();
    let of_plain = change(plain.terrain().elevation());
    let layered = run(layered, &on_a_hill(), 4);
    let block = run(voxels(n, cell, 16, hill(n, cell)), &on_a_hill(), 4);
    let heights = |block: &VoxelGrid| -> Vec<f64> {
        let fill = block.fill().unwrap();
        (0..n * n).map(|i| (0..16).map(|level| f64::from(fill[level * n * n + i]) * cell).sum()).collect()
    };
    let binary = {
        let whole = voxels(n, cell, 16, hill(n, cell));
        let solid = |level: usize, i: usize| whole.fill().unwrap()[level * n * n + i] >= 0.5;
        let ground = VoxelGrid::from_fn(before.grid().clone(), 16, 0.0, cell, &Materials::default(), |level, i| {
            solid(level, i).then_some(0)
        });
        run(ground.unwrap(), &ParticleErosion { voxels: Voxels::Binary, ..on_a_hill() }, 4)
    };
    let counted = |block: &VoxelGrid| -> Vec<f64> {
        (0..n * n).map(|i| (0..16).filter(|&l| block.material(l, i).is_some()).count() as f64 * cell).collect()
    };
    let all = [
        (layered.budget().change.eroded, change(layered.terrain().elevation()), 0.05, 0.9),
        (block.budget().change.eroded, change(&heights(block.terrain())), 0.05, 0.9),
        // Steps of whole voxels slow particles down: 0.1 and 0.9 are wanted.
        (binary.budget().change.eroded, change(&counted(binary.terrain())), 0.5, 0.8),
    ];
    for (eroded, there, share, least) in all {
        let (ratio, alike) = (eroded / plain.budget().change.eroded, correlation(&of_plain, &there, n, 6));
        assert!((ratio - 1.0).abs() < share && alike > least, "{ratio} {alike}");
    }
}

#[test]
fn half_the_cell_wears_as_much() {
    let params = ParticleErosion { particles: Some(800), erosion: None, ..on_a_hill() };
    let of = |n: usize, cell: f64| run(raster(n, cell, hill(n, cell)), &params, 4).budget().change.eroded;
    let (coarse, fine) = (of(49, 5.0), of(97, 2.5));
    assert!((fine / coarse - 1.0).abs() < 0.1, "{coarse} {fine}");
}

/// PE10.
#[test]
fn rain_on_an_island_lays_its_load_under_water() {
    let n = 81;
    let island = raster(n, 10.0, hill(n, 10.0));
    let sea = Length::of(30.0);
    let params =
        ParticleErosion { particles: Some(1500), radius: Some(Length::of(12.0)), sea_level: Some(sea), ..rain() };
    let after = run(island.clone(), &params, 4).into_terrain();
    let (mut under, mut all) = (0.0, 0.0);
    for (before, after) in island.elevation().iter().zip(after.elevation()) {
        let rise = (after - before).max(0.0);
        all += rise;
        // On the slope of the shore a brush reaches three metres over the water.
        under += if *before < 33.0 { rise } else { 0.0 };
    }
    assert!(all > 0.0 && under / all > 0.8, "{}", under / all);
    // A particle that enters the water slows to its settling velocity.
    let plain = raster(41, 5.0, |_| 0.0);
    let heavy = Body { radius: 2.0, density: 1500.0, viscosity: 1e4 };
    let state = Motion { at: [100.0, 100.0, 90.0], velocity: [0.0, 0.0, -20.0] };
    let law = Law { most_steps: 60, ..bare(0.0, 0.5) };
    let ended =
        last_state(&plain, &still(&plain, Some(80.0)), &law, Particle { body: heavy, state, load: 0.0 }).unwrap();
    let settling = heavy.terminal(1500.0, 1000.0);
    assert!(ended.at[2] < 80.0 && (ended.velocity[2] / settling - 1.0).abs() < 1e-6, "{ended:?} {settling}");
}

#[test]
fn rain_on_a_cone_does_not_show_the_lattice() {
    let n = 101;
    let cone = raster(n, 10.0, |[x, y]| 0.35 * (700.0 - math::hypot(x - 500.0, y - 500.0)));
    let params = ParticleErosion { particles: Some(20_000), radius: Some(Length::of(25.0)), ..rain() };
    let mut model = Model::new(cone.clone()).dt(YEAR).seed(Seed(5));
    model.add(params).unwrap();
    model.advance_steps(3).unwrap();
    let (mut whole, mut waves) = (0.0, [[0.0; 2]; 2]);
    for i in 0..n * n {
        let [x, y] = cone.grid().position(i);
        let (x, y) = (x - 500.0, y - 500.0);
        if !(100.0..400.0).contains(&math::hypot(x, y)) {
            continue;
        }
        let lost = cone.elevation()[i] - model.terrain().elevation()[i];
        whole += lost;
        for (wave, folds) in waves.iter_mut().zip([4.0, 8.0]) {
            let angle = folds * math::atan2(y, x);
            wave[0] += lost * math::cos(angle);
            wave[1] += lost * math::sin(angle);
        }
    }
    for wave in waves {
        let peak = 2.0 * math::hypot(wave[0], wave[1]) / whole;
        assert!(peak < 0.03, "{peak}");
    }
}

/// SE9.
#[test]
fn a_wind_follows_the_ground() {
    let wind = WindParams { from: Angle::of(270.0), speed: Rate::from_si(10.0) };
    let over = |z: &dyn Fn([f64; 2]) -> f64| {
        let ground = raster(81, 25.0, z);
        WindField::over(&ground, &ground.bounding_box(), &wind)
    };
    let flat = over(&|_| 40.0).at([777.0, 333.0]);
    assert!((flat[0] - 10.0).abs() < 1e-12 && flat[1].abs() < 1e-12);
    let ridge = over(&|[_, y]| 200.0 * math::exp(-(y - 1000.0) * (y - 1000.0) / 9e4));
    let on = ridge.at([1000.0, 800.0]);
    assert!(on[0] > 10.0 && (on[1] / on[0]).abs() < 1e-9, "{on:?}");
    let cone = over(&|[x, y]| (300.0 - 0.5 * math::hypot(x - 1000.0, y - 1000.0)).max(0.0));
    let (north, south) = (cone.at([700.0, 1200.0]), cone.at([700.0, 800.0]));
    assert!(
        north[1] > 0.1 && (north[1] + south[1]).abs() < 1e-9 && (north[0] - south[0]).abs() < 1e-9,
        "{north:?} {south:?}"
    );
}

#[test]
fn odd_grounds_and_words_are_errors_or_run() {
    let params = ParticleErosion::default();
    for (rows, cols) in [(1, 1), (1, 30), (30, 1)] {
        let ground = HeightField::new(Grid::new(Shape::new(rows, cols), [10.0; 2]).unwrap(), vec![5.0; rows * cols]);
        let mut model = Model::new(ground.unwrap()).dt(YEAR);
        model.add(params.clone()).unwrap();
        let ran = model.advance_steps(1);
        assert!(ran.is_ok() || ran.unwrap_err().parameter_name().is_some(), "{rows} x {cols}");
    }
    let told = |params: ParticleErosion| {
        let mut model =
            Model::new(raster(11, 10.0, |_| 5.0)).dt(YEAR).environment(std::sync::Arc::new(Environment::default()));
        model.add(params).and_then(|()| model.advance_steps(1).map(drop)).unwrap_err().to_string()
    };
    assert!(
        told(ParticleErosion { phenomenon: Phenomenon::Coastal, ..ParticleErosion::default() }).contains("sea_level")
    );
    let high = ParticleErosion {
        phenomenon: Phenomenon::Coastal,
        sea_level: Some(Length::of(-50.0)),
        ..ParticleErosion::default()
    };
    assert!(told(high).contains("emitter"));
    let wild = Flow::Formula(["1/(x - x)".into(), "0".into(), "0".into()]);
    assert!(told(ParticleErosion { flow: wild, ..ParticleErosion::default() }).contains("flow.formula"));
    assert!(told(ParticleErosion { radius: Some(Length::of(9e5)), ..ParticleErosion::default() }).contains("radius"));
}
