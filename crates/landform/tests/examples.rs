//! What the examples show, at small size.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]
#![allow(dead_code, reason = "the examples' main functions")]

#[path = "../examples/corrosion.rs"]
mod corrosion;
#[path = "../examples/game_of_life.rs"]
mod game_of_life;
#[path = "../examples/mud_cracks.rs"]
mod mud_cracks;
#[path = "../examples/sandpile.rs"]
mod sandpile;

use landform::core::analysis::spectrum;
use landform::core::terrain::{HeightField, NodeSurface};

/// Exponent of the density of the surface.
fn beta(field: &HeightField) -> f64 {
    spectrum(field.grid(), field.elevation()).unwrap().surface.exponent
}

#[test]
fn sand_turns_white_noise_into_a_self_affine_surface() {
    let [before, after] = sandpile::sandpile(128, 2).unwrap();
    let total = |f: &HeightField| f.elevation().iter().sum::<f64>();
    assert!((total(&before) / total(&after) - 1.0).abs() < 1e-12);
    assert!(beta(&before).abs() < 0.3, "white noise: {}", beta(&before));
    assert!(beta(&after) > 1.5, "{}", beta(&after));
}

#[test]
fn corrosion_gives_a_flat_surface_pits_of_all_sizes() {
    let field = corrosion::corrosion(128, 14, 2).unwrap();
    let z = field.elevation();
    let mean = z.iter().sum::<f64>() / z.len() as f64;
    assert!(mean < -0.2 && z.iter().any(|v| *v < mean - 0.5));
    assert!(beta(&field) > 0.6, "{}", beta(&field));
    assert!(corrosion::corrosion(64, 5, 3).unwrap() == corrosion::corrosion(64, 5, 3).unwrap());
}

#[test]
fn life_goes_on() {
    let mut world = game_of_life::world(64, 1).unwrap();
    let count = |w: &landform::core::agents::Automaton<bool>| w.cells().iter().filter(|c| **c).count();
    let start = count(&world);
    for _ in 0..50 {
        world.step(game_of_life::life);
    }
    assert!(count(&world) > 50 && count(&world) < start);
}

#[test]
fn mud_cracks_cut_plates() {
    let field = mud_cracks::mud_cracks(120, 150, 1).unwrap();
    let cracked = field.elevation().iter().filter(|z| **z == -1.0).count() as f64 / 14_400.0;
    assert!((0.02..0.3).contains(&cracked), "{cracked}");
}
