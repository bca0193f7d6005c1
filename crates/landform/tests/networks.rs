//! Networks of rivers at the steady state: what they share with nature, and what does not depend on
//! the number of nodes.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that cannot go on panics, and shows what it measured"
)]

use std::path::Path;

use landform::core::analysis::{Drainage, NetworkScaling, Width, hypsometry, network_scaling, rivers};
use landform::core::terrain::{HeightField, Mesh, NodeSurface, height_field_from_mesh};
use landform::core::verb::MemoryOutput;
use landform::recipe::{AnyTerrain, Options, Ran, Recipe};

fn run(text: &str) -> AnyTerrain {
    let recipe = Recipe::parse(text, "test", Path::new("."), &[]).unwrap_or_else(|e| panic!("{e}\n{text}"));
    match recipe.run(&mut MemoryOutput::default(), &Options::default()).unwrap() {
        Ran::ToTheEnd(terrain, _) => (*terrain).clone(),
        Ran::Interrupted(_) => panic!("interrupted"),
    }
}

fn mesh(text: &str) -> Mesh {
    match run(text) {
        AnyTerrain::Mesh(mesh) => mesh,
        _ => panic!("not a mesh"),
    }
}

fn steady(seed: u64, nodes: usize, open: &str, rate: &str) -> Mesh {
    mesh(&format!(
        "seed = {seed}\n[[stage]]\nuse = \"stream_graph\"\nnodes = {nodes}\nopen = {open}\n\
         [[stage]]\nuse = \"evolve\"\nclock = {{ until = \"steady\", tolerance = 1e-9, refine = 4, max_steps = 400 }}\n\
         process = [ {{ use = \"uplift\", rate = {rate} }}, {{ use = \"stream_power\", erodibility = \"5.6e-7\" }} ]\n"
    ))
}

/// Mean exponents and hypsometric integral over three seeds.
fn means(open: &str) -> ([f64; 3], f64) {
    let (mut sum, mut integral) = ([0.0; 3], 0.0);
    for seed in 1..=3 {
        let mesh = steady(seed, 20_000, open, "\"0.4 mm/yr\"");
        let NetworkScaling { area_exponent, hack_exponent, length_exponent, .. } =
            network_scaling(&Drainage::of(&mesh, None, 0.0));
        for (s, v) in sum.iter_mut().zip([area_exponent, hack_exponent, length_exponent]) {
            *s += v / 3.0;
        }
        integral += hypsometry(height_field_from_mesh(&mesh, 250.0).unwrap().elevation()).integral / 3.0;
    }
    (sum, integral)
}

fn inside(name: &str, value: f64, [lo, hi]: [f64; 2]) {
    println!("{name}: {value:.3} in {lo} to {hi}");
    assert!((lo..=hi).contains(&value), "{name}: {value} is not in {lo} to {hi}");
}

#[test]
fn networks_scale_as_rivers_do() {
    // DN1 to DN4 and SP13, with the bands of the validation notes.
    let ([beta, h, psi], integral) = means("[\"south\"]");
    inside("DN1, one side", beta, [0.40, 0.49]);
    inside("DN2, one side", h, [0.52, 0.64]);
    inside("DN3, one side", beta + h, [0.95, 1.10]);
    inside("DN4, one side", psi * h / beta, [0.90, 1.10]);
    inside("SP13, one side", integral, [0.30, 0.55]);
    let ([beta, h, psi], integral) = means("[\"north\", \"east\", \"south\", \"west\"]");
    inside("DN1, all open", beta, [0.48, 0.58]);
    inside("DN2, all open", h, [0.52, 0.64]);
    inside("DN4, all open", psi * h / beta, [0.90, 1.10]);
    inside("SP13, all open", integral, [0.30, 0.55]);
}

/// Rivers as a blurred map: how much of the drainage is near each cell.
fn river_map(mesh: &Mesh, cells: usize) -> Vec<f64> {
    let drainage = Drainage::of(mesh, None, 0.0);
    let [lo, hi] = mesh.bounds();
    let mut map = vec![0.0; cells * cells];
    for reach in rivers(mesh, &drainage, 1e7, Width::default()) {
        for pair in reach.points.windows(2) {
            let length = (landform::core::math::powi(pair[0][0] - pair[1][0], 2)
                + landform::core::math::powi(pair[0][1] - pair[1][1], 2))
            .sqrt();
            let at = |k: usize| {
                let part = (0.5 * (pair[0][k] + pair[1][k]) - lo[k]) / (hi[k] - lo[k]);
                ((part * cells as f64) as usize).min(cells - 1)
            };
            map[at(1) * cells + at(0)] += length * reach.area.sqrt();
        }
    }
    map
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len() as f64;
    let (ma, mb) = (a.iter().sum::<f64>() / n, b.iter().sum::<f64>() / n);
    let covariance =
        |x: &[f64], mx: f64, y: &[f64], my: f64| x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum::<f64>();
    covariance(a, ma, b, mb) / (covariance(a, ma, a, ma) * covariance(b, mb, b, mb)).sqrt()
}

fn raster(mesh: &Mesh) -> HeightField {
    height_field_from_mesh(mesh, 500.0).unwrap()
}

#[test]
fn the_preview_is_the_build() {
    // Painted uplift (two ridges and a valley) at a quarter of the nodes and at all of them. With
    // even uplift the random start decides where divides run, and no preview can know that.
    let painted = "{ formula = \"0.05 + 0.4*smoothstep(0.3, 0, abs(u - 0.3)) + 0.3*smoothstep(0.25, 0, abs(v - 0.75))\", unit = \"mm/yr\" }";
    let all = "[\"north\", \"east\", \"south\", \"west\"]";
    let (preview, build) = (steady(3, 5_000, all, painted), steady(3, 20_000, all, painted));
    let (a, b) = (raster(&preview), raster(&build));
    let curves = correlation(&hypsometry(a.elevation()).curve, &hypsometry(b.elevation()).curve);
    inside("hypsometric curve", curves, [0.995, 1.0]);
    inside("elevation", correlation(a.elevation(), b.elevation()), [0.85, 1.0]);
    inside("drainage network, cells of 4 km", correlation(&river_map(&preview, 8), &river_map(&build, 8)), [0.8, 1.0]);
    let highest = |f: &HeightField| f.elevation().iter().copied().fold(0.0, f64::max);
    inside("highest point", highest(&a) / highest(&b), [0.85, 1.15]);
}
