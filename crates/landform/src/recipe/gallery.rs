//! The gallery's recipes, inside the program.

/// A recipe of the gallery.
#[derive(Debug)]
pub struct GalleryRecipe {
    /// Short name, as `landform new` takes it.
    pub name: &'static str,
    /// File name.
    pub file: &'static str,
    /// The recipe.
    pub text: &'static str,
    /// Files that it reads: path beside it, content.
    pub data: &'static [(&'static str, &'static [u8])],
}

macro_rules! recipe {
    ($name:literal, $file:literal $(, $data:literal)*) => {
        GalleryRecipe {
            name: $name,
            file: $file,
            text: include_str!(concat!("../../gallery/", $file)),
            data: &[$(($data, include_bytes!(concat!("../../gallery/", $data)))),*],
        }
    };
}

/// All recipes, simplest first.
pub static GALLERY: &[GalleryRecipe] = &[
    recipe!("mountains", "01_first_mountains.toml"),
    recipe!("range", "02_continue_a_real_range.toml", "data/big_tujunga_ca_srtm1_utm11.tif"),
    recipe!("noise", "03_noise_and_rivers.toml"),
    recipe!("ridge", "04_painted_uplift.toml", "data/uplift_strokes.png"),
    recipe!("island", "05_painted_island.toml", "data/island_uplift.png"),
    recipe!("constant", "06_constant_uplift.toml"),
    recipe!("gradient", "07_gradient_uplift.toml"),
    recipe!("stepped", "08_stepped_uplift.toml"),
    recipe!("diamond", "09_diamond_uplift.toml"),
    recipe!("radial", "10_radial_uplift.toml"),
    recipe!("streams", "11_painted_streams.toml", "data/river_strokes.png"),
    recipe!("ridges", "12_painted_ridges.toml", "data/ridge_strokes.png"),
    recipe!("strokes", "13_painted_streams_and_ridges.toml", "data/streams_and_ridges.png"),
    recipe!("mask", "14_island.toml", "data/island_mask.png"),
    recipe!("outlets", "15_chosen_outlets.toml"),
    recipe!("rain", "16_rainfall_gradient.toml"),
    recipe!("area_exponent", "17_area_exponent.toml"),
    recipe!("uplift_rate", "18_uplift_rate.toml"),
    recipe!("erodibility", "19_erodibility.toml"),
    recipe!("talus", "20_talus_angle.toml"),
    recipe!("size", "21_terrain_size.toml"),
    recipe!("convergence", "22_convergence.toml"),
    recipe!("many", "23_many_nodes.toml"),
    recipe!("coasts", "24_fractal_coasts.toml"),
    recipe!("spectral", "25_spectral_synthesis.toml"),
    recipe!("subdivision", "26_bare_subdivision.toml"),
    recipe!("diamond_square", "27_diamond_square.toml"),
    recipe!("four_eight", "28_four_eight.toml"),
    recipe!("octaves", "29_octaves_of_noise.toml"),
    recipe!("creases", "30_creases.toml"),
    recipe!("faults", "31_faults.toml"),
    recipe!("kinds", "32_kinds_of_noise.toml"),
    recipe!("bases", "33_bases_of_noise.toml"),
    recipe!("scaling", "34_glaciers_and_canyons.toml"),
    recipe!("layers", "35_layers_and_masks.toml"),
    recipe!("measured", "36_a_range_measured.toml", "data/big_tujunga_ca_srtm1_utm11.tif"),
    recipe!("werner_dunes", "37_werner_dunes.toml"),
    recipe!("protection_dunes", "38_protection_dunes.toml"),
    recipe!("barchans", "39_barchans.toml"),
    recipe!("transverse_dunes", "40_transverse_dunes.toml"),
    recipe!("linear_dunes", "41_linear_dunes.toml"),
    recipe!("star_dunes", "42_star_dunes.toml"),
    recipe!("koh_dunes", "43_koh_dunes.toml"),
    recipe!("rocks", "44_dunes_and_rocks.toml"),
    recipe!("snow", "45_snow.toml"),
    recipe!("coasts_global", "46_coasts_global.toml"),
    recipe!("coasts_local", "47_coasts_local.toml"),
    recipe!("coasts_weakened", "48_coasts_weakened.toml"),
    recipe!("mixed_coast", "49_mixed_coast.toml"),
    recipe!("interior", "50_island_interior.toml"),
    recipe!("sector_coasts", "51_sector_coasts.toml"),
    recipe!("dunes_and_coast", "52_dunes_and_coast.toml"),
    recipe!("two_stage", "53_two_stage_rivers.toml", "data/river_strokes.png"),
    recipe!("level_sets", "54_between_level_sets.toml"),
    recipe!("folds", "55_drained_folds.toml"),
    recipe!("transports", "56_four_transports.toml"),
    recipe!("obstacle", "57_around_an_obstacle.toml"),
    recipe!("rain_on_fbm", "58_rain_on_fbm.toml"),
    recipe!("capture", "59_capture.toml"),
    recipe!("valleys", "60_modes_of_valleys.toml"),
    recipe!("sand_hill", "61_sand_hill.toml"),
    recipe!("threshold", "62_threshold_basin.toml"),
    recipe!("optimal", "63_optimal_network.toml"),
    recipe!("koh_streams", "64_koh_streams.toml", "data/softness_face.png"),
    recipe!("lake", "65_a_lake_breaks_through.toml"),
    recipe!("confluence", "66_confluence.toml"),
    recipe!("fans", "67_alluvial_fans.toml"),
    recipe!("delta", "68_delta.toml"),
    recipe!("tableland", "69_tableland.toml"),
    recipe!("cuestas", "70_cuestas.toml"),
];
