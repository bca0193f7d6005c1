//! What the examples show, at small size.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]
#![allow(dead_code, reason = "the examples' main functions")]

#[path = "../examples/continue_a_dem.rs"]
mod continue_a_dem;
#[path = "../examples/corrosion.rs"]
mod corrosion;
#[path = "../examples/game_of_life.rs"]
mod game_of_life;
#[path = "../examples/island.rs"]
mod island;
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

#[test]
fn an_island_stands_in_the_sea() {
    let land = island::island(400.0, 1.0).unwrap();
    let field = land.terrain.get::<HeightField>("an island").unwrap();
    let (shape, z) = (field.grid().shape, field.elevation());
    let on_rim = |i: usize| {
        let cell = shape.cell(i);
        cell.row == 0 || cell.col == 0 || cell.row + 1 == shape.rows || cell.col + 1 == shape.cols
    };
    assert!((0..z.len()).filter(|&i| on_rim(i)).all(|i| z[i] < 0.0));
    let above = z.iter().filter(|&&z| z > 0.0).count() as f64 / z.len() as f64;
    assert!((0.15..0.8).contains(&above), "{above}");
    assert!(z.iter().any(|&z| z > 200.0));
    // A line each, and what is read back is what was saved.
    let dir = tempfile::tempdir().unwrap();
    let file = |name: &str| dir.path().join(name);
    land.save_raster("elevation", file("a.tif")).unwrap();
    land.save_mesh(file("a.glb")).unwrap();
    land.save_picture(file("a.png")).unwrap();
    let back = landform::prelude::Landscape::open(file("a.tif")).unwrap();
    let back = back.terrain.get::<HeightField>("an island").unwrap();
    let off = back.elevation().iter().zip(z).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-3, "{off}");
    assert!(std::fs::read(file("a.glb")).unwrap().starts_with(b"glTF"));
    assert!(std::fs::read(file("a.png")).unwrap().starts_with(b"\x89PNG"));
    assert!(land.save_raster("dew", file("b.tif")).is_err() && land.save_picture(file("b.jpeg")).is_err());
    assert!(!file("b.tif").exists());
}

#[test]
fn real_ground_goes_on_in_its_place() {
    let dem = std::path::Path::new("gallery/data/big_tujunga_ca_srtm1_utm11.tif");
    let [before, after] = continue_a_dem::continued(dem, 300.0, 100.0).unwrap();
    let ground = |land: &landform::prelude::Landscape| land.terrain.get::<HeightField>("a DEM").unwrap().clone();
    let (before, after) = (ground(&before), ground(&after));
    assert_eq!(before.grid(), after.grid());
    assert_eq!(after.epsg(), Some(32_611));
    let mean = |field: &HeightField| {
        let data: Vec<f64> = field.elevation().iter().copied().filter(|z| !z.is_nan()).collect();
        data.iter().sum::<f64>() / data.len() as f64
    };
    // 50 m of uplift, less what was worn.
    let risen = mean(&after) - mean(&before);
    assert!((0.0..50.0).contains(&risen), "{risen}");
}
