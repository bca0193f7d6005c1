//! Height maps for engines, with a card that says which numbers to type.

mod engines;

use std::path::Path;

use landform_core::grid::{Grid, Shape};
use landform_core::terrain::{HeightField, Interpolation, NodeSurface, resample};
use landform_core::verb::{Export, Landscape, Output, Params, Reach, Source, file_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{RasterFile, sidecar_path};
use engines::{Engine, Sizes};

/// Writes elevation as a height map for an engine, with an import card (name.ext.md) that says
/// which numbers to type: unreal (png, r16), unity (raw), godot (exr, r16), blender (exr, glb), gis
/// (tif).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteHeightmap {
    /// Path below the output folder.
    pub path: String,
    /// Program that reads it.
    pub preset: Preset,
    /// Number of nodes along a side. If not given, it is the engine's smallest size with at least
    /// as many nodes as the landscape.
    #[schemars(extend("x-min" = 2, "x-max" = 16_385))]
    pub size: Option<usize>,
}

/// Program that reads a height map.
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
    /// QGIS and other GIS.
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

    fn bytes_a_node(&self) -> Option<u64> {
        Some(56)
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        vec![self.path.clone(), sidecar_path(&self.path), format!("{}.md", self.path)]
    }

    fn check(&self) -> Result<()> {
        file_path(&self.path)?;
        let engine = self.engine();
        if !engine.extensions.contains(&self.extension().as_str()) {
            let expected =
                format!("a name that ends with .{} for preset \"{}\"", engine.extensions.join(" or ."), engine.word);
            return Err(Error::parameter("path", format!("\"{}\"", self.path), &expected));
        }
        if self.preset == Preset::Unreal && names_a_tile(&self.path) {
            let expected = "a name without 1009x1009 or _x0_y0 in it: Unreal takes it for one tile of many";
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

/// Whether a file's name holds a size (1009x1009) or a place (_x0_y1), by which Unreal knows tiles.
fn names_a_tile(path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap_or(path).to_lowercase();
    let bytes = name.as_bytes();
    let digit = |i: usize| bytes.get(i).is_some_and(u8::is_ascii_digit);
    let size = (1..bytes.len()).any(|i| bytes[i] == b'x' && digit(i - 1) && digit(i + 1));
    let place = |axis: &str| name.match_indices(axis).any(|(i, _)| digit(i + axis.len()));
    size || (place("_x") && place("_y"))
}

/// Heights on the engine's grid, and the contents of their card.
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
        RasterFile::real(self.field.grid(), self.field.elevation(), "elevation", "m", self.seed)
    }
}

/// Relief below this counts as level ground, m.
const FLAT: f64 = 1e-3;

impl WriteHeightmap {
    fn engine(&self) -> &'static Engine {
        engines::engine(self.preset)
    }

    fn extension(&self) -> String {
        Path::new(&self.path).extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
    }

    /// The engine's grid over the landscape's rectangle; square cells may leave out less than a
    /// cell in the south and east.
    fn grid(&self, own: &Grid) -> Result<Grid> {
        let engine = self.engine();
        match (self.size, engine.sizes) {
            (Some(size), Sizes::OneOf(_)) => own.with_shape(size, size),
            (None, Sizes::OneOf(sizes)) => {
                let most = own.shape.cols.max(own.shape.rows);
                let fits = sizes.iter().copied().find(|&s| s >= most).ok_or_else(|| {
                    let value = format!("not given for {} x {} nodes", own.shape.cols, own.shape.rows);
                    let greatest = sizes[sizes.len() - 1];
                    let expected =
                        format!("at most {greatest} for preset \"{}\"; give `size` to go coarser", engine.word);
                    Error::parameter("size", value, &expected)
                })?;
                own.with_shape(fits, fits)
            }
            (None, Sizes::AnySquareCells) if own.spacing[0] == own.spacing[1] => Ok(own.clone()),
            (size, Sizes::AnySquareCells) => {
                let [w, h] = own.extent();
                let cell = match size {
                    Some(size) => w.max(h) / (size - 1) as f64,
                    None => own.spacing[0].min(own.spacing[1]),
                };
                if !(cell > 0.0) {
                    return Ok(own.clone());
                }
                let count = |e: f64| (e / cell * (1.0 + 1e-12)).floor() as usize + 1;
                own.with_spacing([cell; 2], Shape::new(count(h), count(w)))
            }
        }
    }

    fn heights<'a>(&'a self, landscape: &Landscape<'a, HeightField>) -> Result<Heights<'a>> {
        let source = landscape.terrain;
        let grid = self.grid(source.grid())?;
        let from = [source.grid().shape.cols, source.grid().shape.rows];
        let mut field =
            if grid == *source.grid() { source.clone() } else { resample(source, &grid, Interpolation::Linear)? };
        let finite = field.elevation().iter().copied().filter(|z| z.is_finite());
        let (least, mut greatest) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
        if greatest - least < FLAT {
            // Level ground: noise of the last bit is not stretched over 16 bits, and the range is
            // one that an engine takes.
            let z = field.elevation().iter().map(|z| if z.is_nan() { *z } else { least }).collect();
            field = HeightField::new(field.grid().clone(), z)?;
            greatest = least + 1.0;
        }
        let keep_holes = self.preset == Preset::Gis;
        let filled = field.elevation().iter().filter(|z| z.is_nan()).count();
        if !keep_holes && filled > 0 {
            let z = field.elevation().iter().map(|&z| if z.is_nan() { least } else { z }).collect();
            field = HeightField::new(field.grid().clone(), z)?;
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
        if let Some(sidecar) = engine.sidecar(&heights) {
            out.put(&sidecar_path(&self.path), &sidecar.text()?)?;
        }
        out.put(&format!("{}.md", self.path), &card)
    }
}
