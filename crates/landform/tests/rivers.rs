//! Rivers on recipes: what erosion leaves of a spectrum, how transports gather water, and what
//! least bending takes away.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use std::path::Path;

use landform::core::algo::flow::{Flow, node_areas};
use landform::core::analysis::{Spectrum, spectrum};
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
    // FB7: the slope of the spectrum stays within 0.15 for waves longer than four times the widest
    // river, here 2 x 20 m.
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
        let of = |field: &HeightField| spectrum(field.grid(), field.elevation()).unwrap();
        let (before, after) = (fbm(seed, ""), fbm(seed, channel));
        let (a, b) = (long(&of(&before)), long(&of(&after)));
        assert!((a - b).abs() < 0.15, "seed {seed}: {a} {b}");
        assert!(before.elevation() != after.elevation());
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

/// Valleys at least half as long as the slope, and valleys that join them. A valley is where
/// contours bend: ground `REACH` nodes to either side of a river rises by a quarter as much as the
/// river itself. Valleys are followed along the longer branch; primary ones are a quarter of the
/// map long, secondary ones five nodes.
fn valleys(field: &HeightField) -> (usize, usize) {
    const REACH: isize = 3;
    let (domain, z) = (field.domain(), field.elevation());
    let (rows, cols) = (field.grid().shape.rows as isize, field.grid().shape.cols as isize);
    let mut flow = Flow::new();
    flow.route(&*domain, z, &mut node_areas(&*domain));
    let at = |row: isize, col: isize| {
        ((0..rows).contains(&row) && (0..cols).contains(&col)).then(|| z[(row * cols + col) as usize])
    };
    let is_valley = |i: usize| {
        let to = flow.receivers()[i] as usize;
        let (row, col) = (i as isize / cols, i as isize % cols);
        let (down, right) = (to as isize / cols - row, to as isize % cols - col);
        let slope = (z[i] - z[to]) / math::hypot(down as f64, right as f64);
        let sides = (at(row - REACH * right, col + REACH * down), at(row + REACH * right, col - REACH * down));
        let (Some(a), Some(b)) = sides else { return false };
        let across = REACH as f64 * math::hypot(down as f64, right as f64);
        to != i && a.min(b) - z[i] > 0.25 * slope * across
    };
    let mut length = vec![0usize; z.len()];
    let mut ends = Vec::new();
    // From the springs downwards: the longer branch goes on, the shorter ends.
    for &i in flow.order() {
        let i = i as usize;
        if !is_valley(i) {
            continue;
        }
        length[i] += 1;
        let to = flow.receivers()[i] as usize;
        if is_valley(to) {
            ends.push((length[i].min(length[to]), true));
            length[to] = length[to].max(length[i]);
        } else {
            ends.push((length[i], false));
        }
    }
    let of = |joins: bool, least: usize| ends.iter().filter(|e| e.1 == joins && e.0 >= least).count();
    (of(false, rows as usize / 4), of(true, 5))
}

#[test]
fn secondary_valleys_grow_where_cutting_wins_over_smoothing() {
    // WC9: table 4.7 as in the gallery; (b) is steady long before the gallery's last round.
    let of = |exponent: f64, rounds: u32, [avalanche, flow, diffusion, advection, uplift]: [f64; 5]| {
        valleys(&run(&format!(
            "seed = 23\n[[stage]]\nuse = \"surface\"\nsize = [\"1280 m\", \"1280 m\"]\ncell_size = \"10 m\"\n\
             elevation = {{ formula = \"2 + 0*x\", unit = \"m\" }}\n\
             [[stage]]\nuse = \"blend\"\nlayer = {{ use = \"spectral_fbm\", deviation = \"0.5 m\", hurst = 0.5 }}\n\
             [[stage]]\nuse = \"channel_erosion\"\nsmoothing = \"everywhere\"\niterations = {rounds}\noutlets = [\"north\", \"south\"]\n\
             flow_exponent = {exponent}\navalanche_weight = {avalanche}\nflow_weight = {flow}\ndiffusion_weight = {diffusion}\n\
             advection_weight = {advection}\nuplift_weight = {uplift}\nbase_weight = 0.0\n"
        )))
    };
    let (primary, secondary) = of(1.0, 600, [30.0, 300.0, 20.0, 3.0, 0.03]);
    assert!(primary >= 2 && 2 * secondary < primary, "{primary} {secondary}");
    let (primary, secondary) = of(0.3, 600, [0.0, 50_000.0, 0.45, 0.75, 0.045]);
    assert!(primary >= 2 && secondary > 2 * primary, "{primary} {secondary}");
}
