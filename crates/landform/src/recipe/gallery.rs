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
            text: include_str!(concat!("../../../../gallery/", $file)),
            data: &[$(($data, include_bytes!(concat!("../../../../gallery/", $data)))),*],
        }
    };
}

/// All recipes, simplest first.
pub static GALLERY: &[GalleryRecipe] = &[
    recipe!("mountains", "01_first_mountains.toml"),
    recipe!("range", "02_continue_a_real_range.toml", "data/big_tujunga_ca_srtm1_utm11.tif"),
    recipe!("noise", "03_noise_and_rivers.toml"),
    recipe!("ridge", "04_painted_uplift.toml", "data/uplift_strokes.png"),
];
