//! The gallery at small size: hash first, summary second.
//!
//! `cargo xtask gallery --accept` writes what comes out now as the new truth; say why in the
//! changelog.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use landform::core::terrain::VoxelGrid;
use landform::core::verb::MemoryOutput;
use landform::recipe::{AnyTerrain, GALLERY, Options, Override, Ran, Recipe};
use serde::{Deserialize, Serialize};

/// What makes each recipe small.
const SMALL: &[(&str, &[&str])] = &[
    (
        "first_mountains",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=400 m",
            "evolve.clock.max_steps=120",
            "write_picture.size=160",
        ],
    ),
    ("continue_a_real_range", &["today.cell_size=360 m", "write_picture.size=160"]),
    ("noise_and_rivers", &["spectral_fbm.cell_size=250 m", "write_picture.size=160"]),
    ("painted_uplift", &["stream_graph.nodes=1200", "to_height_field.cell_size=500 m", "write_picture.size=160"]),
    (
        "painted_island",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.duration=3 Myr",
            "write_heightmap.size=127",
        ],
    ),
    (
        "constant_uplift",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "gradient_uplift",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "stepped_uplift",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "diamond_uplift",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "radial_uplift",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "painted_streams",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "painted_ridges",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "painted_streams_and_ridges",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "island",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "chosen_outlets",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    (
        "rainfall_gradient",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    ("area_exponent", &["stream_graph.nodes=1200", "write_picture.size=160", "evolve.clock.max_steps=60"]),
    ("uplift_rate", &["stream_graph.nodes=1200", "write_picture.size=160", "evolve.clock.max_steps=60"]),
    ("erodibility", &["stream_graph.nodes=1200", "write_picture.size=160", "evolve.clock.max_steps=60"]),
    (
        "talus_angle",
        &[
            "stream_graph.nodes=1200",
            "to_height_field.cell_size=500 m",
            "write_picture.size=160",
            "evolve.clock.max_steps=60",
        ],
    ),
    ("terrain_size", &["stream_graph.nodes=1200", "write_picture.size=160", "evolve.clock.max_steps=60"]),
    ("convergence", &["stream_graph.nodes=1200", "evolve.clock.max_steps=20", "evolve.watch.size=64"]),
    ("many_nodes", &["stream_graph.nodes=1200", "write_picture.size=160", "evolve.clock.max_steps=60"]),
    (
        "fractal_coasts",
        &[
            "rough.cell_size=320 m",
            "brownian.cell_size=320 m",
            "middling.cell_size=320 m",
            "smooth.cell_size=320 m",
            "write_picture.size=160",
        ],
    ),
    ("spectral_synthesis", &["land.cell_size=160 m", "write_picture.size=160"]),
    (
        "bare_subdivision",
        &[
            "diamond_square.cell_size=80 m",
            "four_eight_held.cell_size=80 m",
            "four_eight.cell_size=80 m",
            "write_picture.size=160",
        ],
    ),
    ("diamond_square", &["land.cell_size=160 m", "write_picture.size=160"]),
    ("four_eight", &["land.cell_size=160 m", "write_picture.size=160"]),
    (
        "octaves_of_noise",
        &[
            "octaves_1.cell_size=160 m",
            "octaves_2.cell_size=160 m",
            "octaves_4.cell_size=160 m",
            "octaves_8.cell_size=160 m",
            "write_picture.size=160",
        ],
    ),
    ("creases", &["land.cell_size=160 m", "write_picture.size=160"]),
    ("faults", &["few.cell_size=160 m", "many.cell_size=160 m", "write_picture.size=160"]),
    (
        "kinds_of_noise",
        &[
            "fbm.cell_size=160 m",
            "billow.cell_size=160 m",
            "ridged.cell_size=160 m",
            "ridged_multifractal.cell_size=160 m",
            "hybrid_multifractal.cell_size=160 m",
            "multifractal.cell_size=160 m",
            "write_picture.size=160",
        ],
    ),
    (
        "bases_of_noise",
        &[
            "perlin.cell_size=160 m",
            "simplex.cell_size=160 m",
            "value.cell_size=160 m",
            "worley.cell_size=160 m",
            "write_picture.size=160",
        ],
    ),
    ("glaciers_and_canyons", &["plain.cell_size=160 m", "write_picture.size=160"]),
    ("layers_and_masks", &["shape.cell_size=320 m", "write_picture.size=160"]),
    ("a_range_measured", &["elevation_file.cell_size=360 m", "write_picture.size=160"]),
    ("werner_dunes", &["plain.cell_size=30 m", "deep.steps=6", "thin.steps=6", "write_picture.size=160"]),
    ("protection_dunes", &["plain.cell_size=30 m", "deep.steps=4", "thin.steps=4", "write_picture.size=160"]),
    ("barchans", &["flat.cell_size=4 m", "dunes.steps=40", "dunes.watch.size=64", "write_picture.size=160"]),
    ("transverse_dunes", &["flat.cell_size=4 m", "dunes.steps=40", "write_picture.size=160"]),
    ("linear_dunes", &["flat.cell_size=4 m", "dunes.steps=40", "write_picture.size=160"]),
    ("star_dunes", &["flat.cell_size=4 m", "dunes.steps=60", "write_picture.size=160"]),
    ("koh_dunes", &["flat.cell_size=4 m", "dunes.steps=40", "write_picture.size=160"]),
    ("dunes_and_rocks", &["flat.cell_size=4 m", "dunes.steps=40", "write_picture.size=160"]),
    ("snow", &["noise.cell_size=120 m", "write_picture.size=160"]),
    ("coasts_global", &["square.cell_size=60 m", "write_picture.size=160"]),
    ("coasts_local", &["square.cell_size=60 m", "write_picture.size=160"]),
    ("coasts_weakened", &["square.cell_size=60 m", "write_picture.size=160"]),
    ("coasts_by_look", &["hills.cell_size=40 m", "write_picture.size=160"]),
    ("mixed_coast", &["square.cell_size=60 m", "write_picture.size=160"]),
    ("island_interior", &["square.cell_size=60 m", "write_picture.size=160"]),
    ("sector_coasts", &["square.cell_size=80 m", "write_picture.size=160"]),
    ("dunes_and_coast", &["flat.cell_size=8 m", "dunes.steps=40", "write_picture.size=160"]),
    ("two_stage_rivers", &["front_terrain.cell_size=40 m", "channel_erosion.iterations=20", "write_picture.size=160"]),
    ("between_level_sets", &["front_terrain.cell_size=40 m", "write_picture.size=160"]),
    ("drained_folds", &["surface.cell_size=40 m", "channel_erosion.iterations=30", "write_picture.size=160"]),
    ("four_transports", &["surface.cell_size=40 m", "channel_erosion.iterations=10", "write_picture.size=160"]),
    ("around_an_obstacle", &["surface.cell_size=40 m", "channel_erosion.iterations=30", "write_picture.size=160"]),
    ("rain_on_fbm", &["spectral_fbm.cell_size=40 m", "channel_erosion.iterations=30", "write_picture.size=160"]),
    (
        "capture",
        &[
            "surface.cell_size=20 m",
            "channel_erosion.iterations=20",
            "channel_erosion.watch.size=64",
            "write_picture.size=160",
        ],
    ),
    ("modes_of_valleys", &["surface.cell_size=40 m", "channel_erosion.iterations=30", "write_picture.size=160"]),
    ("sand_hill", &["surface.cell_size=1 m", "channel_erosion.iterations=20", "write_picture.size=160"]),
    ("threshold_basin", &["spectral_fbm.cell_size=40 m", "write_picture.size=160"]),
    ("optimal_network", &["noise.cell_size=200 m", "write_picture.size=160"]),
    ("an_automaton_in_text", &["spectral_fbm.cell_size=40 m", "write_picture.size=160"]),
    ("koh_streams", &["midpoint_displacement.cell_size=40 m", "flat.cell_size=40 m", "write_picture.size=160"]),
    (
        "a_lake_breaks_through",
        &[
            "surface.cell_size=40 m",
            "channel_erosion.iterations=40",
            "channel_erosion.watch.size=64",
            "write_picture.size=160",
        ],
    ),
    ("confluence", &["surface.cell_size=30 m", "channel_erosion.iterations=30", "write_picture.size=160"]),
    ("alluvial_fans", &["surface.cell_size=40 m", "channel_erosion.iterations=30", "write_picture.size=160"]),
    ("delta", &["surface.cell_size=40 m", "channel_erosion.iterations=30", "write_picture.size=160"]),
    ("hills_and_flood_plains", &["spectral_fbm.grid.cell_size=250 m", "write_picture.size=160"]),
    ("desert_basin", &["spectral_fbm.grid.cell_size=250 m", "write_picture.size=160"]),
    ("folded_range", &["layered_ground.grid.cell_size=250 m", "write_picture.size=160"]),
    ("landslides", &["surface.grid.cell_size=100 m", "write_picture.size=160"]),
    ("alpine_range", &["spectral_fbm.grid.cell_size=250 m", "write_picture.size=160"]),
    ("tableland", &["layered_ground.grid.cell_size=200 m", "write_picture.size=160"]),
    ("limestone_cave", &["rock_volume.grid.cell_size=2 m", "write_picture.size=160"]),
    ("karst_network", &["surface.cell_size=20 m", "tunnels.cell_size=16 m", "write_picture.size=160"]),
    ("linked_inlets", &["rock_volume.grid.cell_size=2 m", "write_picture.size=160"]),
    ("three_inlets", &["rock_volume.grid.cell_size=2 m", "write_picture.size=160"]),
    ("fractured_cave", &["rock_volume.grid.cell_size=2 m", "write_picture.size=160"]),
    ("trunk_cave", &["rock_volume.grid.cell_size=2 m", "write_picture.size=160"]),
    ("cuestas", &["layered_ground.grid.cell_size=200 m", "write_picture.size=160"]),
    ("folded_and_faulted", &["layered_ground.grid.cell_size=250 m", "write_picture.size=160"]),
    ("rain_rills", &["layered_ground.grid.cell_size=10 m", "particle_erosion.particles=50", "write_picture.size=160"]),
    ("undercut_coast", &["surface.grid.cell_size=8 m", "particle_erosion.particles=10", "write_picture.size=160"]),
    ("capped_rocks", &["layered_ground.grid.cell_size=2 m", "particle_erosion.particles=20", "write_picture.size=160"]),
    ("ravines_and_round_crests", &["layered_ground.grid.cell_size=250 m", "write_picture.size=160"]),
    ("volcanic_plateau", &["layered_ground.grid.cell_size=220 m", "write_picture.size=160"]),
    (
        "a_landscape_for_a_game",
        &[
            "stream_graph.spacing=160 m",
            "to_height_field.cell_size=40 m",
            "scatter.spacing=60 m",
            "write_picture.size=160",
        ],
    ),
    ("coral_island", &["coral_island.grid.cell_size=140 m", "evolve.clock.dt=10 kyr", "write_picture.size=160"]),
    ("raised_terraces", &["coral_island.grid.cell_size=120 m", "evolve.clock.dt=5 kyr", "write_picture.size=160"]),
    ("guyot", &["coral_island.grid.cell_size=140 m", "evolve.clock.dt=10 kyr", "write_picture.size=160"]),
];

#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Golden {
    hash: String,
    nodes: usize,
    min: f64,
    max: f64,
    mean: f64,
}

fn golden(terrain: &AnyTerrain) -> Golden {
    // Of voxels, which have no elevation, how far each is dissolved, or else which are empty.
    let voxels = |ground: &VoxelGrid| match ground.field(VoxelGrid::POROSITY) {
        Some(porosity) => porosity.iter().map(|v| f64::from(*v)).collect::<Vec<_>>(),
        None => {
            let nodes = 0..ground.plan().len();
            let level =
                |level| nodes.clone().map(move |node| f64::from(u8::from(ground.material(level, node).is_none())));
            (0..ground.levels()).flat_map(level).collect()
        }
    };
    let body = terrain.get::<VoxelGrid>("a golden").ok().map(voxels);
    let z = body.as_deref().unwrap_or(terrain.elevation());
    // FNV-1a over the bits.
    let hash = z
        .iter()
        .flat_map(|v| v.to_bits().to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3));
    let valid: Vec<f64> = z.iter().copied().filter(|v| v.is_finite()).collect();
    Golden {
        hash: format!("{hash:016x}"),
        nodes: valid.len(),
        min: valid.iter().copied().fold(f64::INFINITY, f64::min),
        max: valid.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        mean: valid.iter().sum::<f64>() / valid.len() as f64,
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("gallery")
}

#[test]
fn every_recipe_of_the_gallery_runs_to_the_same_land() {
    let path = root().join("goldens.json");
    let accept = std::env::var_os("LANDFORM_ACCEPT_GOLDENS").is_some();
    let text = std::fs::read_to_string(&path).unwrap_or_else(|_| "{}".into());
    let known: BTreeMap<String, Golden> = serde_json::from_str(&text).unwrap();
    let mut found = BTreeMap::new();
    for recipe in GALLERY {
        let small = SMALL.iter().find(|s| s.0 == recipe.name).expect("a small size for every recipe").1;
        let overrides: Vec<Override> = small.iter().map(|s| Override::parse(s).unwrap()).collect();
        let parsed = Recipe::parse(recipe.text, recipe.name, &root(), &overrides)
            .unwrap_or_else(|e| panic!("{}: {e}", recipe.file));
        let mut out = MemoryOutput::default();
        let Ran::ToTheEnd(terrain, _) = parsed.run(&mut out, &Options::default()).unwrap() else {
            panic!("interrupted")
        };
        assert!(out.0.values().all(|bytes| !bytes.is_empty()), "{}", recipe.file);
        // What stages say that they leave is what they leave.
        let planned = parsed.plan(None, "").unwrap().fields;
        let of_layers = |name: &String| name.ends_with("_depth") || name == "surface_material";
        let unplanned: Vec<_> = terrain.names().into_iter().filter(|n| !planned.contains(n) && !of_layers(n)).collect();
        assert!(unplanned.is_empty(), "{}: {unplanned:?} is left, and no stage says so", recipe.file);
        found.insert(recipe.name.to_string(), golden(&terrain));
    }
    if accept {
        std::fs::write(&path, serde_json::to_string_pretty(&found).unwrap() + "\n").unwrap();
        return;
    }
    for (name, new) in &found {
        let old = known.get(name).unwrap_or_else(|| panic!("{name} has no golden; run cargo xtask gallery --accept"));
        let near = |a: f64, b: f64| (a - b).abs() <= 0.01 * old.max.abs().max(1.0);
        let tolerable =
            old.nodes == new.nodes && near(old.min, new.min) && near(old.max, new.max) && near(old.mean, new.mean);
        let how = if tolerable { "moved within tolerance" } else { "CHANGED" };
        assert!(
            old.hash == new.hash,
            "{name} {how}:\nwas {old:?}\nis  {new:?}\nif this is meant: cargo xtask gallery --accept, and say why in the changelog"
        );
    }
}

#[test]
fn every_recipe_opens_with_what_to_look_at() {
    let page = std::fs::read_to_string(root().join("README.md")).unwrap();
    for recipe in GALLERY {
        let opening: Vec<&str> = recipe.text.lines().take_while(|l| l.starts_with('#')).collect();
        assert!(opening.len() >= 3 && opening[1].starts_with("# Look at:"), "{}", recipe.file);
        assert!(!opening[0].starts_with("# After"), "{} opens with a figure's number", recipe.file);
        assert_eq!(&recipe.file[3..recipe.file.len() - 5], recipe.name, "a recipe is called as its file");
        let row = format!("[`{}`]({}) | {} |", recipe.name, recipe.file, opening[0].trim_start_matches("# "));
        assert!(page.contains(&row), "gallery/README.md has not the row {row}");
        assert!(std::fs::read_to_string(root().join(recipe.file)).unwrap() == recipe.text);
    }
    let files = std::fs::read_dir(root())
        .unwrap()
        .flatten()
        .filter(|f| f.path().extension().is_some_and(|e| e == "toml"))
        .count();
    assert_eq!(files, GALLERY.len(), "a recipe in the folder is not in the list");
}
