//! Rivers on recipes: what erosion leaves of a spectrum, how transports gather water, and what
//! least bending takes away.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::path::Path;

use landform::core::algo::flow::{Flow, node_areas};
use landform::core::analysis::spectrum;
use landform::core::field::names;
use landform::core::math;
use landform::core::terrain::{HeightField, NodeSurface};
use landform::core::verb::MemoryOutput;
use landform::recipe::{AnyTerrain, Options, Outputs, Ran, Recipe};

fn run(text: &str) -> HeightField {
    let recipe = Recipe::parse(text, "a test", Path::new("."), &[]).unwrap();
    let quiet = Options { outputs: Outputs::Nothing, ..Options::default() };
    let Ran::ToTheEnd(terrain, _) = recipe.run(&mut MemoryOutput::default(), &quiet).unwrap() else { panic!() };
    let AnyTerrain::HeightField(field) = &*terrain else { panic!("not a raster") };
    field.clone()
}

fn fbm(seed: u64, more: &str) -> HeightField {
    run(&format!(
        "seed = {seed}\n[[stage]]\nuse = \"spectral_fbm\"\nsize = [\"2560 m\", \"2560 m\"]\ncell_size = \"20 m\"\nhurst = 0.9\ndeviation = \"70 m\"\n{more}"
    ))
}

#[test]
fn erosion_of_fractional_ground_keeps_its_long_waves() {
    // FB7, with the weights and rounds of the gallery's recipe: waves longer than a quarter of the
    // map keep their power, and the shortest are smoothed away.
    let channel = "[[stage]]\nuse = \"channel_erosion\"\niterations = 150\n";
    for seed in [1, 2] {
        let of = |field: &HeightField| spectrum(field.grid(), field.elevation()).unwrap();
        let (before, after) = (of(&fbm(seed, "")), of(&fbm(seed, channel)));
        let ratios = |from: f64, to: f64| {
            let pairs = before.bins.iter().zip(&after.bins).filter(|(b, _)| (from..to).contains(&b.wavelength));
            let logs: Vec<f64> = pairs.map(|(b, a)| math::log(a.density / b.density)).collect();
            math::exp(logs.iter().sum::<f64>() / logs.len() as f64)
        };
        let (long, short) = (ratios(640.0, 1e9), ratios(0.0, 100.0));
        assert!((0.75..1.35).contains(&long) && short < 0.9, "seed {seed}: {long} {short}");
    }
}

/// Gini's coefficient of the flow along a row, in the mean of rows.
fn gini(field: &HeightField) -> f64 {
    let flow = field.fields().get(&names::DISCHARGE, "a test").unwrap();
    let cols = field.grid().shape.cols;
    let of_row = |row: &[f64]| {
        let mut q = row.to_vec();
        q.sort_by(f64::total_cmp);
        let total: f64 = q.iter().sum();
        let n = cols as f64;
        q.iter().enumerate().map(|(k, v)| (2.0 * (k as f64 + 1.0) - n - 1.0) * v).sum::<f64>() / (n * total.max(1e-300))
    };
    let rows: Vec<f64> = flow.chunks(cols).skip(8).map(of_row).collect();
    rows.iter().sum::<f64>() / rows.len() as f64
}

#[test]
fn columns_gather_water_where_averages_and_pipes_spread_it() {
    // WC6: rain on a rough slope, no erosion.
    let of = |transport: &str, rounds: u32| {
        gini(&run(&format!(
            "seed = 5\n[[stage]]\nuse = \"surface\"\nsize = [\"640 m\", \"1280 m\"]\ncell_size = \"10 m\"\n\
             elevation = {{ formula = \"0.2*y\", unit = \"m\" }}\n\
             [[stage]]\nuse = \"blend\"\nlayer = {{ use = \"spectral_fbm\", deviation = \"3 m\", hurst = 0.5 }}\n\
             [[stage]]\nuse = \"channel_erosion\"\ntransport = \"{transport}\"\niterations = {rounds}\noutlets = [\"south\"]\n\
             avalanche_weight = 0.0\nflow_weight = 0.0\ndiffusion_weight = 0.0\nadvection_weight = 0.0\nbase_weight = 0.0\n"
        )))
    };
    let columns = of("columns", 1);
    for (transport, rounds) in [("average", 1), ("weighted_average", 1), ("pipes", 30)] {
        let other = of(transport, rounds);
        assert!(columns > other + 0.05, "{transport}: {columns} {other}");
    }
}

#[test]
fn least_bending_bends_less_than_hermite() {
    let of = |interpolation: &str| {
        let field = run(&format!(
            "seed = 5\n[[stage]]\nuse = \"front_terrain\"\nmask = {{ formula = \"r < 0.05\" }}\nsize = [\"1280 m\", \"1280 m\"]\n\
             cell_size = \"10 m\"\ninterpolation = \"{interpolation}\"\n"
        ));
        landform::core::algo::thin_plate::bending_energy(field.grid().shape, field.elevation())
    };
    let (nearest, hermite, variational) = (of("nearest"), of("hermite"), of("variational"));
    assert!(variational < 0.5 * hermite && hermite < nearest, "{nearest} {hermite} {variational}");
}

/// Share of the nodes that lie in valleys. A valley is where contours bend: ground `REACH` nodes to
/// either side of a river rises by a quarter as much as the river itself.
fn in_valleys(field: &HeightField) -> f64 {
    const REACH: isize = 3;
    let (domain, z) = (field.domain(), field.elevation());
    let (rows, cols) = (field.grid().shape.rows as isize, field.grid().shape.cols as isize);
    let mut flow = Flow::new();
    flow.route(&*domain, z, &mut node_areas(&*domain));
    let at = |row: isize, col: isize| {
        ((0..rows).contains(&row) && (0..cols).contains(&col)).then(|| z[(row * cols + col) as usize])
    };
    let is_valley = |i: &usize| {
        let (i, to) = (*i, flow.receivers()[*i] as usize);
        let (row, col) = (i as isize / cols, i as isize % cols);
        let (down, right) = (to as isize / cols - row, to as isize % cols - col);
        let slope = (z[i] - z[to]) / math::hypot(down as f64, right as f64);
        let sides = (at(row - REACH * right, col + REACH * down), at(row + REACH * right, col - REACH * down));
        let (Some(a), Some(b)) = sides else { return false };
        let across = REACH as f64 * math::hypot(down as f64, right as f64);
        to != i && a.min(b) - z[i] > 0.25 * slope * across
    };
    (0..z.len()).filter(is_valley).count() as f64 / z.len() as f64
}

#[test]
fn valleys_are_dense_where_cutting_wins_over_smoothing() {
    // WC9: table 4.7 as in the gallery; (b) is steady long before the gallery's last round.
    let of = |exponent: f64, rounds: u32, [avalanche, flow, diffusion, advection, uplift]: [f64; 5]| {
        in_valleys(&run(&format!(
            "seed = 23\n[[stage]]\nuse = \"surface\"\nsize = [\"1280 m\", \"1280 m\"]\ncell_size = \"10 m\"\n\
             elevation = {{ formula = \"2 + 0*x\", unit = \"m\" }}\n\
             [[stage]]\nuse = \"blend\"\nlayer = {{ use = \"spectral_fbm\", deviation = \"0.5 m\", hurst = 0.5 }}\n\
             [[stage]]\nuse = \"channel_erosion\"\nsmoothing = \"everywhere\"\niterations = {rounds}\noutlets = [\"north\", \"south\"]\n\
             flow_exponent = {exponent}\navalanche_weight = {avalanche}\nflow_weight = {flow}\ndiffusion_weight = {diffusion}\n\
             advection_weight = {advection}\nuplift_weight = {uplift}\nbase_weight = 0.0\n"
        )))
    };
    let smoothed = of(1.0, 600, [30.0, 300.0, 20.0, 3.0, 0.03]);
    let cut = of(0.3, 600, [0.0, 50_000.0, 0.45, 0.75, 0.045]);
    assert!(smoothed > 0.0 && cut > 2.0 * smoothed, "{smoothed} {cut}");
}
