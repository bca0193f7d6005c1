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
}

macro_rules! recipe {
    ($name:literal, $file:literal) => {
        GalleryRecipe { name: $name, file: $file, text: include_str!(concat!("../../../../gallery/", $file)) }
    };
}

/// All recipes, simplest first.
pub static GALLERY: &[GalleryRecipe] = &[
    recipe!("mountains", "01_first_mountains.toml"),
    recipe!("range", "02_continue_a_real_range.toml"),
    recipe!("noise", "03_noise_and_rivers.toml"),
    recipe!("ridge", "04_painted_uplift.toml"),
];
