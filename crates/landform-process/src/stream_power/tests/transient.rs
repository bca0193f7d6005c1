//! On the way to the steady state, and what must not depend on units or steps.

use landform_core::verb::{Formula, Varying};

use super::*;

fn line(n: usize, cell: f64) -> HeightField {
    let mut grid = Grid::new(Shape::new(1, n), [cell, cell]).unwrap();
    grid.edges = Edges { west: Edge::Open, ..Edges::all(Edge::Closed) };
    HeightField::new(grid, (0..n).map(|i| 0.01 * i as f64).collect()).unwrap()
}

pub(super) fn evolve<T: NodeSurface>(terrain: T, rate: f64, rivers: StreamPower, dt: f64, stop: Stop) -> T {
    let mut sim = Simulation::new(terrain).process(uplift(rate)).unwrap().process(rivers).unwrap().dt(dt).until(stop);
    sim.run().unwrap();
    sim.into_terrain()
}

#[test]
fn slopes_follow_an_uplift_that_varies_in_space() {
    // SP2
    let formula = Formula::parse("0.4 + 1.2*u*v").unwrap();
    let rate = Varying::Formula { formula, unit: "mm/yr".into() };
    let mut sim = Simulation::new(raster(40, 9))
        .process(Uplift { rate: rate.clone() })
        .unwrap()
        .process(law(0.5, 1.0))
        .unwrap()
        .dt(10.0 * MYR)
        .until(Stop::steady(1e-12).or_steps(2_000));
    assert_eq!(sim.run().unwrap().stopped, Stopped::Steady);
    let terrain = sim.into_terrain();
    let local = rate.resolve("rate", &terrain, &Context { seed: Seed(1), ..Context::default() }).unwrap();
    let domain = terrain.domain();
    let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
    flow.route(&*domain, terrain.elevation(), &mut area);
    let mut errors: Vec<f64> = (0..area.len())
        .filter(|&i| flow.receivers()[i] as usize != i)
        .map(|i| {
            let r = flow.receivers()[i] as usize;
            let slope = (terrain.elevation()[i] - terrain.elevation()[r]) / domain.distance(i, flow.slots()[i]);
            (K / YEAR * area[i].sqrt() * slope / local.at(i) - 1.0).abs()
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    assert!(errors[errors.len() / 2] < 1e-10 && errors[errors.len() * 99 / 100] < 1e-6);
}

#[test]
fn a_knickpoint_travels_at_its_celerity() {
    // SP5: uplift doubles; k_sn crosses its middle where the travel time τ(x) = ∫ dx/(K Aᵐ) equals
    // the time.
    let (n, cell, m) = (401, 25.0, 0.45);
    let settled = evolve(line(n, cell), 1.0, law(m, 1.0), 10.0 * MYR, Stop::steady(1e-12).or_steps(500));
    let time = 1.5 * MYR;
    let terrain = evolve(settled, 2.0, law(m, 1.0), KYR, Stop::time(time));
    let area = |i: usize| cell * cell * (n - i) as f64;
    let steepness = |i: usize| {
        let z = terrain.elevation();
        (z[i] - z[i - 1]) / cell * math::pow(area(i), m) * K / U
    };
    let found = (1..n).find(|&i| steepness(i) < 1.5).unwrap();
    let mut tau = 0.0;
    let expected = (1..n).find(|&i| {
        tau += cell / (K / YEAR * math::pow(area(i), m));
        tau > time
    });
    let expected = expected.unwrap();
    assert!(expected > 50 && expected < 350 && found.abs_diff(expected) <= 2, "{found} {expected}");
}

#[test]
fn halving_the_step_halves_the_error() {
    // SP9: on one river, whose receivers stay what they are.
    let run = |dt: f64| evolve(line(101, 100.0), 1.0, law(0.45, 1.0), dt * KYR, Stop::time(400.0 * KYR));
    let exact = run(0.05);
    let error = |dt: f64| {
        let z = run(dt);
        let difference = z.elevation().iter().zip(exact.elevation()).map(|(a, b)| (a - b).abs());
        difference.fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(16.0), error(8.0));
    assert!((1.8..2.2).contains(&(coarse / fine)), "{coarse} {fine}");
}

#[test]
fn rescaled_landscapes_are_the_same() {
    // SP10: lengths in sqrt(D/K), times in 1/K, heights in U/K (m = 0.5); factors are powers of
    // two.
    let run = |length: f64, time: f64, height: f64| {
        let n = 24;
        let mut grid = Grid::new(Shape::new(n, n), [100.0 * length; 2]).unwrap();
        grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
        let z = (0..grid.len()).map(|i| if i / n == n - 1 { 0.0 } else { height * Seed(4).uniform(i as u64) });
        let terrain = HeightField::new(grid, z.collect()).unwrap();
        let rivers = StreamPower { erodibility: Some(Erodibility::of(K / time).into()), ..law(0.5, 1.0) };
        let creep =
            LinearDiffusion { diffusivity: landform_core::units::Diffusivity::of(0.1 * length * length / time).into() };
        let mut sim = Simulation::new(terrain)
            .process(Uplift { rate: Rate::from_si(U / YEAR * height / time).into() })
            .unwrap()
            .process(rivers)
            .unwrap()
            .process(creep)
            .unwrap()
            .dt(20.0 * KYR * time)
            .until(Stop::steps(30));
        sim.run().unwrap();
        sim.into_terrain().elevation().iter().map(|z| z / height).collect::<Vec<_>>()
    };
    let one = run(1.0, 1.0, 1.0);
    for (length, time, height) in [(2.0, 1.0, 1.0), (1.0, 4.0, 0.5), (0.5, 2.0, 8.0)] {
        let other = run(length, time, height);
        let highest = one.iter().copied().fold(0.0, f64::max);
        assert!(one.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-9 * highest));
    }
}

#[test]
fn slopes_above_the_talus_angle_can_relax_slowly() {
    // Eq. 3.7 of the thesis on a cliff without rivers: the excess over the talus slope falls by
    // 1/(1 + c) a step.
    let mut terrain = line(3, 10.0);
    terrain.change(Layer::Bedrock, |z| z.copy_from_slice(&[0.0, 100.0, 100.0]));
    let rivers = StreamPower {
        erodibility: Some(Erodibility::of(0.0).into()),
        talus_angle: Some(Angle::of(45.0)),
        talus_relaxation: Some(Rate::of(1.0)),
        ..law(0.5, 1.0)
    };
    let mut sim = Simulation::new(terrain).process(rivers).unwrap().dt(10.0 * KYR).until(Stop::steps(1));
    sim.run().unwrap();
    // 1 mm/yr for 10 kyr is 10 m per unit of slope; over 10 m of length, c = 1: half of the excess
    // of 90 m is left.
    assert!((sim.terrain().elevation()[1] - 55.0).abs() < 1e-9, "{}", sim.terrain().elevation()[1]);
}

#[test]
fn the_sea_moves_the_shore_and_rivers_end_at_it() {
    let slope = |sea: &str, rate: f64| {
        let mut terrain = raster(40, 3);
        terrain.change(Layer::Bedrock, |z| {
            z.iter_mut().enumerate().for_each(|(i, z)| *z += (20 - i as i64 / 40) as f64 * 10.0)
        });
        let rivers = StreamPower {
            outlets: Some(serde_json::from_str("\"sea\"").unwrap()),
            sea_level: Some(serde_json::from_str(sea).unwrap()),
            ..law(0.5, 1.0)
        };
        evolve(terrain, rate, rivers, 10.0 * KYR, Stop::time(300.0 * KYR))
    };
    let wet = |t: &HeightField, level: f64| t.elevation().iter().filter(|z| **z <= level).count();
    let still = slope("\"0 m\"", 0.0);
    let risen = slope(r#"{"times":["0 yr","300000 yr"],"values":["0 m","60 m"]}"#, 0.0);
    assert!(wet(&risen, 60.0) > wet(&still, 0.0) + 100, "{} {}", wet(&risen, 60.0), wet(&still, 0.0));
    assert_eq!(still.domain().status().iter().filter(|s| **s == Status::BaseLevel).count(), wet(&still, 0.0));
    // Under the sea nothing is worn off; on land nothing is cut below its level.
    let lifted = slope("\"0 m\"", 0.1);
    assert!(wet(&lifted, 0.0) < wet(&still, 0.0));
    let depth = lifted.fields.get(&names::LAKE_DEPTH, "").unwrap();
    assert!(depth.iter().all(|d| *d >= 0.0));
}

#[test]
fn base_levels_fall_with_the_sea() {
    let rivers = StreamPower {
        sea_level: Some(serde_json::from_str(r#"{"times":["0 yr","100000 yr"],"values":["5 m","-45 m"]}"#).unwrap()),
        ..law(0.5, 1.0)
    };
    let terrain = evolve(raster(20, 3), 0.0, rivers, 10.0 * KYR, Stop::time(200.0 * KYR));
    assert!((terrain.elevation()[19 * 20] + 50.0).abs() < 1e-9, "{}", terrain.elevation()[19 * 20]);
}

#[test]
fn creep_and_rivers_share_an_unchannelized_strip() {
    // SP12: D p' + K xᵐ p = U on a strip one cell wide (area = width · x from the divide), p the
    // slope: p(x) = (U/D) ∫₀ˣ exp(−K' (xᵐ⁺¹ − sᵐ⁺¹)/(D (m + 1))) ds, K' = K widthᵐ.
    let (n, cell, m, creep) = (101, 2.0, 0.5, 5.0);
    let k = creep / math::pow(200.0, 1.5) / math::pow(cell, m);
    let rivers = StreamPower { erodibility: Some(Erodibility::of(k).into()), ..law(m, 1.0) };
    let mut sim = Simulation::new(line(n, cell))
        .process(uplift(1.0))
        .unwrap()
        .process(rivers)
        .unwrap()
        .process(LinearDiffusion { diffusivity: landform_core::units::Diffusivity::of(creep).into() })
        .unwrap()
        .dt(4.0 * YEAR)
        .until(Stop::time(30.0 * KYR));
    sim.run().unwrap();
    let z = sim.terrain().elevation();
    let analytic = |x: f64| {
        let parts = 2_000;
        let weight = |s: f64| {
            math::exp(-k * math::pow(cell, m) * (math::pow(x, m + 1.0) - math::pow(s, m + 1.0)) / (creep * (m + 1.0)))
        };
        1e-3 / creep * (0..parts).map(|i| weight((i as f64 + 0.5) * x / parts as f64)).sum::<f64>() * x / parts as f64
    };
    for i in (2..n - 2).step_by(9) {
        // The face below node i has all nodes above it upstream.
        let x = cell * (n - i) as f64;
        let (found, expected) = ((z[i] - z[i - 1]) / cell, analytic(x));
        assert!((found / expected - 1.0).abs() < 0.01, "at {x} m: {found} {expected}");
    }
}

#[test]
fn rain_that_changes_in_time_is_that_of_each_step() {
    let wet = |rainfall: &str, steps: u64| {
        let rivers = StreamPower { rainfall: Some(serde_json::from_str(rainfall).unwrap()), ..law(0.5, 1.0) };
        let mut model = Model::new(raster(24, 3)).dt(50.0 * KYR);
        model.add(uplift(0.5)).unwrap();
        model.add(rivers).unwrap();
        model.advance_steps(steps).unwrap();
        model.finish().unwrap();
        model.into_terrain()
    };
    let (steady, course) = ("\"2 m/yr\"", r#"{ "times": ["0 yr", "1 Myr"], "values": ["2 m/yr", "2 m/yr"] }"#);
    assert_eq!(wet(steady, 6).elevation(), wet(course, 6).elevation());
    let dry = wet(r#"{ "times": ["0 yr", "300 kyr"], "values": ["2 m/yr", "0.5 m/yr"] }"#, 6);
    let mean = |terrain: &HeightField| terrain.elevation().iter().sum::<f64>();
    assert!(mean(&dry) > mean(&wet(steady, 6)) * 1.05);
    let rain = dry.fields.get(&names::RAINFALL, "").unwrap()[0] * YEAR;
    assert!((rain - 0.625).abs() < 1e-9, "{rain}");
}

#[test]
fn weak_rock_is_rock_of_more_erodibility() {
    let run = |erodibility: f64, weakness: Option<f64>, deposition: f64| {
        let rivers = StreamPower {
            erodibility: Some(Erodibility::of(erodibility).into()),
            weakness: weakness.map(|w| landform_core::units::Ratio::of(w).into()),
            deposition,
            ..law(0.5, 1.0)
        };
        let mut model = Model::new(raster(20, 3)).dt(50.0 * KYR);
        model.add(uplift(1.0)).unwrap();
        model.add(rivers).unwrap();
        model.advance_steps(5).unwrap();
        model.into_terrain().elevation().to_vec()
    };
    for deposition in [0.0, 0.5] {
        let weak = run(K, Some(2.0), deposition);
        assert!(weak == run(2.0 * K, None, deposition), "G {deposition}");
        assert!(weak != run(K, None, deposition), "G {deposition}");
    }
}
