//! Deposition against its analytic steady state, its equation, and its budget.

use super::*;

fn settling(deposition: f64, m: f64, n: f64) -> StreamPower {
    StreamPower { deposition, ..law(m, n) }
}

#[test]
fn steady_slopes_grow_by_one_plus_g() {
    // Validation notes 2.19: S = ((1 + G) U/K)^(1/n) A^(-m/n).
    for (g, m, n) in [(0.5, 0.5, 1.0), (1.0, 0.5, 1.0), (2.0, 0.4, 1.0), (1.0, 0.6, 1.2), (0.7, 0.4, 0.8)] {
        let terrain = steady(raster(32, 6), settling(g, m, n), 10.0 * MYR);
        let mut errors: Vec<f64> = profile(&terrain, m / n)
            .iter()
            .map(|[area, slope, ..]| (K * math::pow(*area, m) * math::pow(*slope, n) / (U * (1.0 + g)) - 1.0).abs())
            .collect();
        errors.sort_by(f64::total_cmp);
        let (median, most) = (errors[errors.len() / 2], errors[errors.len() * 99 / 100]);
        assert!(median < 1e-10 && most < 1e-6, "G {g} m {m} n {n}: median {median:e}, 99 % {most:e}");
    }
}

#[test]
fn every_node_obeys_the_equation_of_the_step_and_sediment_is_conserved() {
    // One step from rough ground with lakes, against the equation itself with fluxes summed anew.
    // Two nodes of a hundred may be off, by a decision about a lake; the others by a hundredth of
    // what is worn off.
    for (n, talus, limiting) in [
        (1.0, None, 0.0),
        (1.0, Some(20.0), 0.0),
        (1.6, None, 0.0),
        (0.7, None, 0.0),
        (1.0, None, 0.2),
        (1.6, None, 0.2),
    ] {
        let mut terrain = mesh(3_000);
        terrain.change(Layer::Bedrock, |z| {
            z.iter_mut().enumerate().for_each(|(i, z)| *z += 60.0 * Seed(2).uniform(i as u64))
        });
        let before = terrain.elevation().to_vec();
        let params =
            StreamPower { talus_angle: talus.map(Angle::of), limiting_slope: Some(limiting), ..settling(0.8, 0.5, n) };
        let (domain, dt) = (terrain.domain(), 50.0 * KYR);
        let (mut flow, mut area) = (Flow::new(), node_areas(&*domain));
        flow.route(&*domain, &before, &mut area);
        assert!(flow.lakes() > 20);
        let law = params.law(f64::NEG_INFINITY, dt, false);
        let k = Resolved::Uniform(K / YEAR);
        let rock = Rock { erodibility: &k, layers: None, weakness: None, by_material: false };
        let change = terrain
            .change(Layer::Bedrock, |z| Sediment::default().sweep(&*domain, &flow, &law, &rock, &mut area.clone(), z));
        assert!(((change.eroded - change.deposited - change.exported) / change.eroded).abs() < 1e-12);
        assert!(change.deposited > 0.01 * change.eroded && change.exported > 0.0);
        let z = terrain.elevation();
        let mut flux: Vec<f64> = (0..z.len()).map(|i| (before[i] - z[i]) * domain.area(i)).collect();
        let level = flow.water_level(z);
        for &i in flow.order() {
            let r = flow.receivers()[i as usize] as usize;
            if r != i as usize {
                flux[r] += flux[i as usize];
            }
        }
        let left: f64 = (0..z.len()).filter(|&i| flow.receivers()[i] as usize == i).map(|i| flux[i]).sum();
        assert!((left / change.exported - 1.0).abs() < 1e-9, "what reaches the outlets is what left");
        let (mut rivers, mut drowned, mut off) = (0, 0, 0);
        for i in 0..z.len() {
            let r = flow.receivers()[i] as usize;
            if r == i {
                continue;
            }
            assert!(flux[i] >= -1e-4 * change.eroded, "no node sends less than nothing");
            let length = domain.distance(i, flow.slots()[i]);
            let drop = z[i] - z[r];
            let limit = law.greatest_slope * length;
            assert!(drop <= limit * (1.0 + 1e-9));
            let laid = law.deposition / area[i] * flux[i];
            if z[i] > level[r] + 1e-9 && drop < 0.999_999 * limit {
                let standing = 1.0 - drop / (law.limiting_slope * length);
                let worn = law.strength(K / YEAR, area[i], length) * math::pow(drop, n) / standing;
                assert!(standing > 0.0);
                off += usize::from((before[i] - z[i] - (worn - laid)).abs() > 0.01 * worn + 2e-3);
                rivers += 1;
            } else if z[i] < level[r] - 1e-9 {
                off += usize::from((z[i] - before[i] - laid).abs() > 2e-3);
                drowned += 1;
            }
        }
        assert!(rivers > 500 && drowned > 5, "{rivers} {drowned}");
        assert!(off * 50 < z.len(), "n {n}, talus {talus:?}, limit {limiting}: {off} of {} nodes", z.len());
    }
}

#[test]
fn a_lake_is_filled_to_its_surface_and_no_higher() {
    let n = 41;
    let grid = Grid::new(Shape::new(n, n), [100.0, 100.0]).unwrap();
    // A slope to the south with a hollow 60 m deep.
    let z = (0..n * n).map(|i| {
        let (row, col) = ((i / n) as f64, (i % n) as f64);
        let hollow = (landform_core::math::powi(row - 25.0, 2) + landform_core::math::powi(col - 20.0, 2)).sqrt();
        (40.0 - row) * 10.0 - 150.0 * (1.0 - hollow / 8.0).max(0.0)
    });
    let field = HeightField::new(grid, z.collect()).unwrap();
    let run = |g: f64| {
        let mut sim = Simulation::new(field.clone())
            .process(StreamPower { deposition: g, ..law(0.5, 1.0) })
            .unwrap()
            .dt(20.0 * KYR)
            .until(Stop::steps(10));
        let outcome = sim.run().unwrap();
        assert!(outcome.budget.imbalance() < 1e-9 && outcome.budget.sediment_imbalance() < 1e-9);
        let depth = sim.terrain().fields.get(&names::LAKE_DEPTH, "").unwrap();
        depth.iter().sum::<f64>()
    };
    let (bare, filled) = (run(0.0), run(2.0));
    assert!(filled < 0.5 * bare, "{filled} of {bare}");
}

#[test]
fn what_was_laid_down_and_cut_is_summed_to_the_budget() {
    use landform_core::field::names;
    let mut terrain = mesh(1_500);
    terrain
        .change(Layer::Bedrock, |z| z.iter_mut().enumerate().for_each(|(i, z)| *z += 60.0 * Seed(2).uniform(i as u64)));
    let domain = terrain.domain();
    for g in [1.0, 0.0] {
        let mut model = Model::new(terrain.clone()).dt(20.0 * KYR);
        model.add(settling(g, 0.5, 1.0)).unwrap();
        model.advance_steps(12).unwrap();
        let sum = |key| {
            let values = model.terrain().fields().get(key, "test").unwrap();
            assert!(values.iter().all(|v| *v >= 0.0));
            (0..values.len()).map(|i| values[i] * domain.area(i)).sum::<f64>()
        };
        let (laid, cut) = (sum(&names::DEPOSITION), sum(&names::INCISION));
        let change = model.budget().change;
        assert!((laid - change.deposited).abs() <= 1e-9 * laid, "{laid} {}", change.deposited);
        assert_eq!(laid > 0.0, g > 0.0);
        assert!((cut / change.eroded - 1.0).abs() < 1e-9, "{cut} {}", change.eroded);
    }
}

#[test]
fn rounds_that_end_early_cost_less_than_the_step() {
    // Rivers meet a rise that is five times as fast as that which made the land.
    for (g, limiting) in [(0.4, 0.9), (2.0, 0.9), (0.4, 0.4)] {
        let params = StreamPower { limiting_slope: Some(limiting), ..settling(g, 0.45, 1.0) };
        let start = transient::evolve(raster(100, 6), 0.2, params.clone(), 20.0 * KYR, Stop::time(3.0 * MYR));
        let domain = start.domain();
        let k = Resolved::Uniform(K / YEAR);
        let rock = Rock { erodibility: &k, layers: None, weakness: None, by_material: false };
        let run = |parts: usize, mut solver: Sediment| {
            let (mut z, dt) = (start.elevation().to_vec(), 20.0 * KYR / parts as f64);
            let mut flow = Flow::new();
            let law = params.law(f64::NEG_INFINITY, dt, false);
            for _ in 0..10 * parts {
                let mut area = node_areas(&*domain);
                flow.route(&*domain, &z, &mut area);
                z.iter_mut()
                    .zip(domain.status())
                    .filter(|(_, s)| **s == Status::Interior)
                    .for_each(|(z, _)| *z += U / YEAR * dt);
                solver.sweep(&*domain, &flow, &law, &rock, &mut area, &mut z);
            }
            z
        };
        let exact = run(1, Sediment::to_the_end());
        let off = |z: &[f64]| {
            (z.iter().zip(&exact).map(|(a, b)| math::powi(a - b, 2)).sum::<f64>() / exact.len() as f64).sqrt()
        };
        let (early, step) = (off(&run(1, Sediment::default())), off(&run(2, Sediment::to_the_end())));
        assert!(early < 0.2 * step, "G {g}, limit {limiting}: {early} m beside {step} m");
    }
}
