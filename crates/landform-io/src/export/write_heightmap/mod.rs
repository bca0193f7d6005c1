//! Height maps for engines, with a card that says which numbers to type.

mod engines;

use std::path::Path;

use landform_core::terrain::{HeightField, Interpolation, NodeSurface, resample};
use landform_core::verb::{Export, Landscape, Output, Params, Reach, Source, file_path};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{RasterFile, sidecar_path};
use engines::Engine;

use super::layout::{Layout, MOST_TILES, tile_path};

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
    /// Number of nodes along a side, of each tile where there are several. If not given, it is the
    /// engine's size that is nearest to the landscape's own; what it becomes is told.
    #[schemars(extend("x-min" = 2, "x-max" = 16_385))]
    pub size: Option<usize>,
    /// Tiles east and north (unreal, unity, godot). Each has one of the engine's sizes and a name
    /// by which the engine knows its place; all have one range of heights. Unreal's (_x0_y0) and
    /// Unity's (_0_0) have common borders with the same numbers, Terrain3D's regions (_00_00) share
    /// no nodes.
    #[schemars(extend("x-min" = 1, "x-max" = 64))]
    pub tiles: [usize; 2],
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
        Self { path: "heightmap.tif".into(), preset: Preset::Gis, size: None, tiles: [1, 1] }
    }
}

impl Params for WriteHeightmap {
    const NAME: &'static str = "write_heightmap";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(BYTES_A_NODE)
    }

    fn reach(&self) -> Reach {
        Reach::Point
    }

    fn outputs(&self) -> Vec<String> {
        let card = format!("{}.md", self.path);
        let file = |path: String| [sidecar_path(&path), path];
        let [east, north] = self.tiles.map(|n| n.min(MOST_TILES));
        let name = self.engine().tile.filter(|_| self.tiles != [1, 1]);
        let Some(name) = name else { return file(self.path.clone()).into_iter().chain([card]).collect() };
        let places = (0..north).flat_map(|y| (0..east).map(move |x| [x, y]));
        places.flat_map(|at| file(tile_path(&self.path, &name(at, self.tiles)))).chain([card]).collect()
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
        if self.tiles != [1, 1] && engine.tile.is_none() {
            let expected = format!("[1, 1] for preset \"{}\", which takes one file", engine.word);
            return Err(Error::parameter("tiles", format!("{:?}", self.tiles), &expected));
        }
        engine.sizes.check(engine.word, self.size, self.tiles)
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
    /// The tiles.
    pub(super) layout: Layout,
}

impl Heights<'_> {
    /// As a file of rasters.
    pub(super) fn file(&self) -> RasterFile<'_> {
        let file = RasterFile::real(self.field.grid(), self.field.elevation(), "elevation", "m", self.seed);
        RasterFile { spread: self.layout.is_tiled().then_some(self.range), ..file }
    }
}

/// Bytes a node of the engine's raster, as measured.
const BYTES_A_NODE: u64 = 56;
/// Relief below this counts as level ground, m.
const FLAT: f64 = 1e-3;

impl WriteHeightmap {
    fn engine(&self) -> &'static Engine {
        engines::engine(self.preset)
    }

    fn extension(&self) -> String {
        Path::new(&self.path).extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
    }

    fn heights<'a>(&'a self, landscape: &Landscape<'a, HeightField>) -> Result<Heights<'a>> {
        let source = landscape.terrain;
        let engine = self.engine();
        let layout = engine.sizes.layout(engine.word, source.grid(), self.size, self.tiles, BYTES_A_NODE)?;
        let grid = layout.whole.clone();
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
            layout,
        })
    }
}

impl Export<HeightField> for WriteHeightmap {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        let heights = self.heights(landscape)?;
        let engine = self.engine();
        if let Some(note) = heights.layout.note(&self.path, landscape.terrain.grid()) {
            out.note(note);
        }
        match engine.tile.filter(|_| heights.layout.is_tiled()) {
            None => write(engine, &heights, out)?,
            Some(name) => {
                for at in heights.layout.places() {
                    let field = heights.field.window(&heights.layout.tile_grid(at)?)?;
                    let file = tile_path(&self.path, &name(at, self.tiles));
                    let layout = heights.layout.clone();
                    let extension = heights.extension.clone();
                    write(engine, &Heights { field, file: &file, layout, extension, ..heights }, out)?;
                }
            }
        }
        out.put(&format!("{}.md", self.path), engine.card(&heights).as_bytes())
    }
}

/// A file, and its sidecar where the format does not say what its numbers mean.
fn write(engine: &Engine, heights: &Heights, out: &mut dyn Output) -> Result<()> {
    out.put(heights.file, &(engine.write)(heights)?)?;
    match engine.sidecar(heights) {
        Some(sidecar) => out.put(&sidecar_path(heights.file), &sidecar.text()?),
        None => Ok(()),
    }
}
