//! How nodes are cut into strips changes no bit of a run.

use landform_core::terrain::Layer;
use landform_core::verb::CancelToken;

use super::*;

fn stepped(params: &StreamPower, strips: usize) -> Vec<f64> {
    let mut terrain = raster(61, 3);
    terrain
        .change(Layer::Bedrock, |z| z.iter_mut().enumerate().for_each(|(i, z)| *z += 90.0 * Seed(5).uniform(i as u64)));
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
    for (slope_exponent, deposition) in [(1.0, 0.0), (2.0, 0.0), (1.0, 0.8)] {
        let params = StreamPower { deposition, ..law(0.5, slope_exponent) };
        let whole = stepped(&params, 1);
        for strips in [2, 3, 5, 8] {
            let same = stepped(&params, strips).iter().zip(&whole).all(|(a, b)| a.to_bits() == b.to_bits());
            assert!(same, "n {slope_exponent}, G {deposition}, {strips} strips");
        }
    }
}
