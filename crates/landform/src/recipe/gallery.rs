//! The gallery's recipes, inside the program.

/// A recipe of the gallery.
#[derive(Debug)]
pub struct GalleryRecipe {
    /// What it belongs to, for lists.
    pub group: &'static str,
    /// Name, as `landform new` takes it: the file's, without number and extension.
    pub name: &'static str,
    /// File name.
    pub file: &'static str,
    /// The recipe.
    pub text: &'static str,
    /// Files that it reads: path beside it, content.
    pub data: &'static [(&'static str, &'static [u8])],
}

macro_rules! recipe {
    ($group:literal, $name:literal, $file:literal $(, $data:literal)*) => {
        GalleryRecipe {
            group: $group,
            name: $name,
            file: $file,
            text: include_str!(concat!("../../gallery/", $file)),
            data: &[$(($data, include_bytes!(concat!("../../gallery/", $data)))),*],
        }
    };
}

/// All recipes, by group: first the landscapes that most people begin with, last what is nearest to
/// the papers.
pub static GALLERY: &[GalleryRecipe] = &[
    recipe!("Landscapes", "alpine_range", "71_alpine_range.toml"),
    recipe!("Landscapes", "folded_range", "72_folded_range.toml"),
    recipe!("Landscapes", "ravines_and_round_crests", "89_ravines_and_round_crests.toml"),
    recipe!("Landscapes", "hills_and_flood_plains", "78_hills_and_flood_plains.toml"),
    recipe!("Landscapes", "desert_basin", "79_desert_basin.toml"),
    recipe!("Landscapes", "landslides", "83_landslides.toml"),
    recipe!("Landscapes", "painted_island", "05_painted_island.toml", "data/island_uplift.png"),
    recipe!("Landscapes", "first_mountains", "01_first_mountains.toml"),
    recipe!("Landscapes", "barchans", "39_barchans.toml"),
    recipe!("Landscapes", "dunes_and_coast", "52_dunes_and_coast.toml"),
    recipe!("Landscapes", "tableland", "69_tableland.toml"),
    recipe!(
        "Landscapes",
        "continue_a_real_range",
        "02_continue_a_real_range.toml",
        "data/big_tujunga_ca_srtm1_utm11.tif"
    ),
    recipe!("Landscapes", "cuestas", "70_cuestas.toml"),
    recipe!("Landscapes", "folded_and_faulted", "84_folded_and_faulted.toml"),
    recipe!("Landscapes", "volcanic_plateau", "85_volcanic_plateau.toml"),
    recipe!("Landscapes", "a_landscape_for_a_game", "93_a_landscape_for_a_game.toml"),
    recipe!("Landscapes", "coral_island", "90_coral_island.toml"),
    recipe!("Landscapes", "raised_terraces", "91_raised_terraces.toml"),
    recipe!("Landscapes", "guyot", "92_guyot.toml"),
    recipe!("Landscapes", "star_dunes", "42_star_dunes.toml"),
    recipe!("Landscapes", "snow", "45_snow.toml"),
    recipe!("Landscapes", "confluence", "66_confluence.toml"),
    recipe!("Landscapes", "a_lake_breaks_through", "65_a_lake_breaks_through.toml"),
    recipe!("Landscapes", "alluvial_fans", "67_alluvial_fans.toml"),
    recipe!("Landscapes", "delta", "68_delta.toml"),
    recipe!("Paint where the land rises", "painted_uplift", "04_painted_uplift.toml", "data/uplift_strokes.png"),
    recipe!("Paint where the land rises", "painted_streams", "11_painted_streams.toml", "data/river_strokes.png"),
    recipe!("Paint where the land rises", "painted_ridges", "12_painted_ridges.toml", "data/ridge_strokes.png"),
    recipe!(
        "Paint where the land rises",
        "painted_streams_and_ridges",
        "13_painted_streams_and_ridges.toml",
        "data/streams_and_ridges.png"
    ),
    recipe!("Paint where the land rises", "island", "14_island.toml", "data/island_mask.png"),
    recipe!("Paint where the land rises", "layers_and_masks", "35_layers_and_masks.toml"),
    recipe!("Paint where the land rises", "two_stage_rivers", "53_two_stage_rivers.toml", "data/river_strokes.png"),
    recipe!("Uplift, rain, rock and outlets", "noise_and_rivers", "03_noise_and_rivers.toml"),
    recipe!("Uplift, rain, rock and outlets", "constant_uplift", "06_constant_uplift.toml"),
    recipe!("Uplift, rain, rock and outlets", "gradient_uplift", "07_gradient_uplift.toml"),
    recipe!("Uplift, rain, rock and outlets", "stepped_uplift", "08_stepped_uplift.toml"),
    recipe!("Uplift, rain, rock and outlets", "diamond_uplift", "09_diamond_uplift.toml"),
    recipe!("Uplift, rain, rock and outlets", "radial_uplift", "10_radial_uplift.toml"),
    recipe!("Uplift, rain, rock and outlets", "chosen_outlets", "15_chosen_outlets.toml"),
    recipe!("Uplift, rain, rock and outlets", "rainfall_gradient", "16_rainfall_gradient.toml"),
    recipe!("Uplift, rain, rock and outlets", "area_exponent", "17_area_exponent.toml"),
    recipe!("Uplift, rain, rock and outlets", "uplift_rate", "18_uplift_rate.toml"),
    recipe!("Uplift, rain, rock and outlets", "erodibility", "19_erodibility.toml"),
    recipe!("Uplift, rain, rock and outlets", "talus_angle", "20_talus_angle.toml"),
    recipe!("Uplift, rain, rock and outlets", "terrain_size", "21_terrain_size.toml"),
    recipe!("Uplift, rain, rock and outlets", "convergence", "22_convergence.toml"),
    recipe!("Uplift, rain, rock and outlets", "many_nodes", "23_many_nodes.toml"),
    recipe!("Sand and wind", "werner_dunes", "37_werner_dunes.toml"),
    recipe!("Sand and wind", "protection_dunes", "38_protection_dunes.toml"),
    recipe!("Sand and wind", "transverse_dunes", "40_transverse_dunes.toml"),
    recipe!("Sand and wind", "linear_dunes", "41_linear_dunes.toml"),
    recipe!("Sand and wind", "koh_dunes", "43_koh_dunes.toml"),
    recipe!("Sand and wind", "dunes_and_rocks", "44_dunes_and_rocks.toml"),
    recipe!("Sand and wind", "capped_rocks", "88_capped_rocks.toml"),
    recipe!("Coasts", "fractal_coasts", "24_fractal_coasts.toml"),
    recipe!("Coasts", "coasts_global", "46_coasts_global.toml"),
    recipe!("Coasts", "coasts_local", "47_coasts_local.toml"),
    recipe!("Coasts", "coasts_weakened", "48_coasts_weakened.toml"),
    recipe!("Coasts", "coasts_by_look", "73_coasts_by_look.toml"),
    recipe!("Coasts", "mixed_coast", "49_mixed_coast.toml"),
    recipe!("Coasts", "island_interior", "50_island_interior.toml"),
    recipe!("Coasts", "sector_coasts", "51_sector_coasts.toml"),
    recipe!("Coasts", "undercut_coast", "87_undercut_coast.toml"),
    recipe!("Under the ground", "limestone_cave", "75_limestone_cave.toml"),
    recipe!("Under the ground", "linked_inlets", "76_linked_inlets.toml"),
    recipe!("Under the ground", "three_inlets", "80_three_inlets.toml"),
    recipe!("Under the ground", "fractured_cave", "81_fractured_cave.toml"),
    recipe!("Under the ground", "trunk_cave", "82_trunk_cave.toml"),
    recipe!("Under the ground", "karst_network", "77_karst_network.toml"),
    recipe!("Running water", "between_level_sets", "54_between_level_sets.toml"),
    recipe!("Running water", "rain_rills", "86_rain_rills.toml"),
    recipe!("Running water", "drained_folds", "55_drained_folds.toml"),
    recipe!("Running water", "four_transports", "56_four_transports.toml"),
    recipe!("Running water", "around_an_obstacle", "57_around_an_obstacle.toml"),
    recipe!("Running water", "rain_on_fbm", "58_rain_on_fbm.toml"),
    recipe!("Running water", "capture", "59_capture.toml"),
    recipe!("Running water", "modes_of_valleys", "60_modes_of_valleys.toml"),
    recipe!("Running water", "sand_hill", "61_sand_hill.toml"),
    recipe!("Running water", "threshold_basin", "62_threshold_basin.toml"),
    recipe!("Running water", "optimal_network", "63_optimal_network.toml"),
    recipe!("Running water", "koh_streams", "64_koh_streams.toml", "data/softness_face.png"),
    recipe!("Running water", "an_automaton_in_text", "74_an_automaton_in_text.toml"),
    recipe!("Noise and its spectra", "spectral_synthesis", "25_spectral_synthesis.toml"),
    recipe!("Noise and its spectra", "bare_subdivision", "26_bare_subdivision.toml"),
    recipe!("Noise and its spectra", "diamond_square", "27_diamond_square.toml"),
    recipe!("Noise and its spectra", "four_eight", "28_four_eight.toml"),
    recipe!("Noise and its spectra", "octaves_of_noise", "29_octaves_of_noise.toml"),
    recipe!("Noise and its spectra", "creases", "30_creases.toml"),
    recipe!("Noise and its spectra", "faults", "31_faults.toml"),
    recipe!("Noise and its spectra", "kinds_of_noise", "32_kinds_of_noise.toml"),
    recipe!("Noise and its spectra", "bases_of_noise", "33_bases_of_noise.toml"),
    recipe!("Noise and its spectra", "glaciers_and_canyons", "34_glaciers_and_canyons.toml"),
    recipe!(
        "Real ground, measured",
        "a_range_measured",
        "36_a_range_measured.toml",
        "data/big_tujunga_ca_srtm1_utm11.tif"
    ),
];
