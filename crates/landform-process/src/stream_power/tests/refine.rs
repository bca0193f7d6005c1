//! Steady states from coarse to fine.

use super::*;

fn refined<T: NodeSurface + landform_core::terrain::Refine>(terrain: T, rivers: StreamPower, levels: u32) -> (T, u64) {
    let mut sim = Simulation::new(terrain)
        .process(uplift(1e3 * U))
        .unwrap()
        .process(rivers)
        .unwrap()
        .dt(1e3 * MYR)
        .until(Stop::steady(0.0).or_steps(2_000))
        .refine(levels);
    let outcome = sim.run().unwrap();
    assert_eq!(outcome.stopped, Stopped::Steady, "{outcome:?}");
    assert_eq!(outcome.residual, Some(0.0), "not a bit changes");
    assert!(outcome.budget.imbalance() < 1e-9);
    (sim.into_terrain(), outcome.steps)
}

#[test]
fn a_mesh_becomes_steady_to_the_bit_in_far_fewer_steps() {
    let ((direct, many), (terrain, few)) =
        (refined(mesh(8_000), law(0.5, 1.0), 0), refined(mesh(8_000), law(0.5, 1.0), 3));
    assert!(3 * few < many, "{few} steps after coarse levels, {many} without");
    check_slope_area(&terrain, 0.5, 1.0);
    let highest = |t: &Mesh| t.elevation().iter().copied().fold(0.0, f64::max);
    assert!((highest(&terrain) / highest(&direct) - 1.0).abs() < 0.2, "{} {}", highest(&terrain), highest(&direct));
}

#[test]
fn a_raster_with_chosen_outlets_clamped_slopes_and_deposition_becomes_steady_too() {
    let rivers = StreamPower {
        outlets: Some(Outlets::Sides(vec![Side::West])),
        talus_angle: Some(Angle::of(25.0)),
        deposition: 0.5,
        ..law(0.5, 1.0)
    };
    let (terrain, steps) = refined(raster(60, 4), rivers, 2);
    assert!(steps < 200, "{steps}");
    assert!((0..60).all(|r| terrain.elevation()[r * 60] < 1.0), "base levels are not raised by a coarse level");
}
