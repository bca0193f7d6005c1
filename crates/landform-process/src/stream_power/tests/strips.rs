//! How nodes are cut into strips changes no bit of a run.

use landform_core::terrain::Layer;
use landform_core::verb::CancelToken;

use super::*;

const SIDE: usize = 61;

/// Rough ground, plateaus of whole metres, one flat map, and a lake over the seams.
fn ground(name: &str) -> impl Fn(usize) -> f64 {
    let rough = |i: usize| 90.0 * Seed(5).uniform(i as u64);
    move |i| {
        let (row, col) = ((i / SIDE) as f64 - 30.0, (i % SIDE) as f64 - 30.0);
        match name {
            "rough" => rough(i),
            "plateaus" => (rough(i) / 15.0).floor(),
            "flat" => 0.0,
            _ => 3.0 * row.abs().max(col.abs()).min(25.0),
        }
    }
}

fn stepped(params: &StreamPower, name: &str, strips: usize) -> Vec<f64> {
    let mut terrain = raster(SIDE, 3);
    let start = ground(name);
    terrain.change(Layer::Bedrock, |z| {
        let noise = if name == "rough" { 1.0 } else { 0.0 };
        z.iter_mut().enumerate().for_each(|(i, z)| *z = noise * *z + start(i));
    });
    let context = Context { seed: Seed(1), ..Context::default() };
    let mut state = Process::<HeightField>::start(params, &mut terrain, &context).unwrap();
    state.prepare(params, &terrain);
    state.scratch.flow = Flow::by(params.descent).in_strips(strips);
    for index in 0..20 {
        let dt = 20.0 * KYR;
        let at = Step {
            index,
            of: None,
            time: index as f64 * dt,
            dt,
            seed: Seed(1),
            environment: Default::default(),
            cancel: CancelToken::default(),
        };
        let status = terrain.domain().status().to_vec();
        terrain.change(Layer::Bedrock, |z| {
            z.iter_mut()
                .zip(&status)
                .filter(|(_, s)| **s == Status::Interior)
                .for_each(|(z, _)| *z += 1e-3 * dt / YEAR);
        });
        params.begin(&terrain, &mut state, &at).unwrap();
        params.step(&mut terrain, &mut state, &at).unwrap();
    }
    terrain.elevation().to_vec()
}

#[test]
fn steps_in_strips_equal_steps_in_one() {
    for name in ["rough", "plateaus", "flat", "lake"] {
        for (slope_exponent, deposition) in [(1.0, 0.0), (2.0, 0.0), (1.0, 0.8), (2.0, 0.8)] {
            let params = StreamPower { deposition, ..law(0.5, slope_exponent) };
            let whole = stepped(&params, name, 1);
            for strips in [2, 3, 5, 8] {
                let same = stepped(&params, name, strips).iter().zip(&whole).all(|(a, b)| a.to_bits() == b.to_bits());
                assert!(same, "{name}, n {slope_exponent}, G {deposition}, {strips} strips");
            }
        }
    }
}
