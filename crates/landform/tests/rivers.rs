//! Rivers on recipes: what erosion leaves of a spectrum, how transports gather water, and what least bending takes away.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::path::Path;

use landform::core::analysis::{Spectrum, spectrum};
use landform::core::field::names;
use landform::core::math;
use landform::core::terrain::{HeightField, NodeSurface};
use landform::core::verb::MemoryOutput;
use landform::recipe::{AnyTerrain, Options, Ran, Recipe};

fn run(text: &str) -> HeightField {
    let recipe = Recipe::parse(text, "a test", Path::new("."), &[]).unwrap();
    let quiet = Options { quiet: true, ..Options::default() };
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
    // FB7: the slope of the spectrum stays within 0.15 for waves longer than four times the widest river, here 2 x 20 m.
    let (channel, widest) =
        ("[[stage]]\nuse = \"channel_erosion\"\nchannel_radius = \"20 m\"\niterations = 40\n", 40.0);
    let long = |s: &Spectrum| {
        let points: Vec<(f64, f64)> = s
            .bins
            .iter()
            .filter(|b| b.wavelength > 4.0 * widest)
            .map(|b| (math::log(b.ring), math::log(b.density)))
            .collect();
        let n = points.len() as f64;
        let (mx, my) = points.iter().fold((0.0, 0.0), |(a, b), p| (a + p.0 / n, b + p.1 / n));
        let (sxy, sxx) =
            points.iter().fold((0.0, 0.0), |(a, b), p| (a + (p.0 - mx) * (p.1 - my), b + (p.0 - mx) * (p.0 - mx)));
        sxy / sxx
    };
    for seed in [1, 2] {
        let of = |field: &HeightField| spectrum(&field.grid, field.elevation()).unwrap();
        let (before, after) = (fbm(seed, ""), fbm(seed, channel));
        let (a, b) = (long(&of(&before)), long(&of(&after)));
        assert!((a - b).abs() < 0.15, "seed {seed}: {a} {b}");
        assert!(before.elevation() != after.elevation());
    }
}

/// Gini's coefficient of the flow along a row, in the mean of rows.
fn gini(field: &HeightField) -> f64 {
    let flow = field.fields().get(&names::DISCHARGE, "a test").unwrap();
    let cols = field.grid.shape.cols;
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
        landform::core::algo::thin_plate::bending_energy(field.grid.shape, field.elevation())
    };
    let (nearest, hermite, variational) = (of("nearest"), of("hermite"), of("variational"));
    assert!(variational < 0.5 * hermite && hermite < nearest, "{nearest} {hermite} {variational}");
}
