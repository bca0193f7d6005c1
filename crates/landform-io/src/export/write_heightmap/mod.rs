//! Heights as an engine wants them, with a card that says which numbers to type.

mod engines;

use std::path::Path;

use landform_core::grid::Grid;
use landform_core::terrain::{HeightField, NodeSurface, resample};
use landform_core::verb::{Export, Landscape, Output, Params, Source, relative_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{GeotiffOptions, RasterFile};
use engines::{Engine, Sizes};

/// Writes elevation as an engine imports it right first time, with an import card (name.ext.md) that says which numbers to
/// type: unreal (png, r16), unity (raw), godot (exr, r16), blender (exr, glb), gis (tif).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteHeightmap {
    /// Path below the output folder.
    pub path: String,
    /// Who reads it.
    pub preset: Preset,
    /// Nodes along a side; the engine's smallest size that loses nothing, if not given.
    #[schemars(extend("x-min" = 2, "x-max" = 16_385))]
    pub size: Option<usize>,
}

/// Who reads a height map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Preset {
    /// Unreal Engine: Landscape.
    Unreal,
    /// Unity: Terrain.
    Unity,
    /// Godot: Terrain3D.
    Godot,
    /// Blender: displacement, or a mesh.
    Blender,
    /// QGIS and its relatives.
    Gis,
}

impl Default for WriteHeightmap {
    fn default() -> Self {
        Self { path: "heightmap.tif".into(), preset: Preset::Gis, size: None }
    }
}

impl Params for WriteHeightmap {
    const NAME: &'static str = "write_heightmap";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        relative_path(&self.path)?;
        let engine = self.engine();
        if !engine.extensions.contains(&self.extension().as_str()) {
            let expected =
                format!("a name that ends with .{} for preset \"{}\"", engine.extensions.join(" or ."), engine.word);
            return Err(Error::parameter("path", format!("\"{}\"", self.path), &expected));
        }
        if self.preset == Preset::Unreal && names_a_tile(&self.path) {
            let expected = "a name without a size such as 1009x1009: Unreal takes it for one tile of many";
            return Err(Error::parameter("path", format!("\"{}\"", self.path), expected));
        }
        match (self.size, engine.sizes) {
            (Some(size), Sizes::OneOf(sizes)) if !sizes.contains(&size) => {
                let all = sizes.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
                Err(Error::parameter("size", size, &format!("one of {all} for preset \"{}\"", engine.word)))
            }
            _ => Ok(()),
        }
    }
}

/// Whether a name holds digits, an x, and digits.
fn names_a_tile(path: &str) -> bool {
    let bytes = path.as_bytes();
    (1..bytes.len().saturating_sub(1))
        .any(|i| bytes[i] == b'x' && bytes[i - 1].is_ascii_digit() && bytes[i + 1].is_ascii_digit())
}

/// Heights on the engine's grid, and what a card tells of them.
pub(super) struct Heights<'a> {
    /// The grid.
    pub(super) field: HeightField,
    /// Least and greatest height, m.
    pub(super) range: [f64; 2],
    /// Name of the file.
    pub(super) file: &'a str,
    /// Extension, lower case.
    pub(super) extension: String,
    /// Title of the recipe.
    pub(super) title: &'a str,
    /// Seed of the recipe.
    pub(super) seed: u64,
    /// Nodes without data, which were given the least height.
    pub(super) filled: usize,
    /// Nodes of the landscape itself.
    pub(super) from: [usize; 2],
}

impl Heights<'_> {
    /// As a file of rasters.
    pub(super) fn file(&self) -> RasterFile<'_> {
        RasterFile {
            grid: &self.field.grid,
            values: self.field.elevation(),
            field: "elevation",
            unit: "m",
            seed: self.seed,
            geotiff: GeotiffOptions::default(),
        }
    }
}

impl WriteHeightmap {
    fn engine(&self) -> &'static Engine {
        engines::engine(self.preset)
    }

    fn extension(&self) -> String {
        Path::new(&self.path).extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
    }

    /// Nodes along x and y.
    fn nodes(&self, grid: &Grid) -> Result<[usize; 2]> {
        let own = [grid.shape.cols, grid.shape.rows];
        match (self.size, self.engine().sizes) {
            (Some(size), Sizes::OneOf(_)) => Ok([size; 2]),
            (None, Sizes::OneOf(sizes)) => {
                let most = own[0].max(own[1]);
                let fits = sizes.iter().copied().find(|&s| s >= most);
                fits.map(|s| [s; 2]).ok_or_else(|| {
                    let (value, greatest) =
                        (format!("not given for {} x {} nodes", own[0], own[1]), sizes[sizes.len() - 1]);
                    Error::parameter(
                        "size",
                        value,
                        &format!("at most {greatest} for preset \"{}\"; give `size` to go coarser", self.engine().word),
                    )
                })
            }
            // One spacing for both axes.
            (size, Sizes::AnySquareCells) => {
                let [w, h] = grid.extent();
                let longer = w.max(h);
                let cell = match size {
                    Some(size) => longer / (size - 1) as f64,
                    None => grid.spacing[0].min(grid.spacing[1]),
                };
                let count = |e: f64| (e / cell).round().max(1.0) as usize + 1;
                Ok([count(w), count(h)])
            }
        }
    }

    fn heights<'a>(&'a self, landscape: &Landscape<'a, HeightField>) -> Result<Heights<'a>> {
        let source = landscape.terrain;
        let [cols, rows] = self.nodes(&source.grid)?;
        let from = [source.grid.shape.cols, source.grid.shape.rows];
        let mut field =
            if [cols, rows] == from { source.clone() } else { resample(source, &source.grid.with_shape(rows, cols)?)? };
        let finite = field.elevation().iter().copied().filter(|z| z.is_finite());
        let (least, greatest) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
        let keep_holes = self.preset == Preset::Gis;
        let filled = field.elevation().iter().filter(|z| z.is_nan()).count();
        if !keep_holes && filled > 0 {
            let z = field.elevation().iter().map(|&z| if z.is_nan() { least } else { z }).collect();
            field = HeightField::new(field.grid.clone(), z)?;
        }
        Ok(Heights {
            field,
            range: [least, greatest],
            file: &self.path,
            extension: self.extension(),
            title: landscape.title,
            seed: landscape.seed,
            filled: if keep_holes { 0 } else { filled },
            from,
        })
    }
}

impl Export<HeightField> for WriteHeightmap {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        let heights = self.heights(landscape)?;
        let engine = self.engine();
        let [bytes, card] = [(engine.write)(&heights)?, engine.card(&heights).into_bytes()];
        out.put(&self.path, &bytes)?;
        if let Some(sidecar) = (engine.sidecar)(&heights) {
            out.put(&format!("{}.landform.json", self.path), &sidecar.text()?)?;
        }
        out.put(&format!("{}.md", self.path), &card)
    }
}
