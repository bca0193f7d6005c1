//! Files of weights that each engine reads, and what to type there.

use std::fmt::Write;

use landform_core::Result;
use landform_core::grid::Shape;

use super::{WeightLayer, WeightPreset, WriteWeights};
use crate::export::layout::{self, Layout, Sizes, TileName};
use crate::format::{encode_bytes, encode_rgba, write_exr_words};

/// Weights of each layer, nodes without data, and the shape of a tile; the bytes of each file.
type WriteFiles = fn(&[Vec<u8>], &[bool], Shape) -> Result<Vec<Vec<u8>>>;

/// An engine.
pub(super) struct Engine {
    pub(super) word: &'static str,
    name: &'static str,
    pub(super) sizes: Sizes,
    /// Whether a texel stands over a cell between nodes, rather than at a node.
    pub(super) over_cells: bool,
    pub(super) tile: TileName,
    /// Names of the files of a tile.
    pub(super) files: fn(&[WeightLayer], &str) -> Vec<String>,
    pub(super) write: WriteFiles,
    steps: &'static str,
}

pub(super) fn engine(preset: WeightPreset) -> &'static Engine {
    match preset {
        WeightPreset::Unreal => &UNREAL,
        WeightPreset::Unity => &UNITY,
        WeightPreset::Godot => &GODOT,
        WeightPreset::Terrain3d => &TERRAIN3D,
    }
}

static UNREAL: Engine = Engine {
    word: "unreal",
    name: "Unreal Engine (Landscape)",
    sizes: layout::UNREAL,
    over_cells: false,
    tile: layout::unreal_tile,
    files: |layers, suffix| layers.iter().map(|l| format!("{}{suffix}.png", l.name)).collect(),
    write: |weights, _, shape| weights.iter().map(|w| encode_bytes(w, shape)).collect(),
    steps: "1. Give the landscape a material with a Landscape Layer Blend whose layers have the names below.\n\
            2. Landscape mode, Manage, Import: the heightmap, and for each layer its file; create a layer info \
            (*Weight-Blended Layer (normal)*).\n\n\
            The pictures have as many pixels as the heightmap of the preset \"unreal\" has nodes. Row 0 is the north, as in \
            the heightmap.\n",
};

static UNITY: Engine = Engine {
    word: "unity",
    name: "Unity (Terrain)",
    sizes: layout::UNITY,
    over_cells: true,
    tile: layout::unity_tile,
    files: by_fours,
    write: write_by_fours,
    steps: "1. Terrain, Settings, Texture Resolutions, *Control Texture Resolution*: the number of pixels below.\n\
            2. Add the Terrain Layers in the order below.\n\
            3. Import the pictures with sRGB off, compression *None* and Read/Write on; then Terrain Toolbox, Terrain \
            Utilities, *Import Splatmaps* (or `TerrainData.SetAlphamaps` with `GetPixels`, whose first row is the south).\n\n\
            A pixel stands over a cell between four nodes of the heightmap. The picture has the north at its top, so that \
            Unity's first row, the lowest, is the south: do not flip it.\n",
};

static GODOT: Engine = Engine {
    word: "godot",
    name: "Godot (splat maps of four layers)",
    sizes: Sizes::AnySquareCells,
    over_cells: false,
    tile: layout::godot_tile,
    files: by_fours,
    write: write_by_fours,
    steps: "1. Import the pictures with *Mode* Lossless and without mipmaps; they are data, not colours.\n\
            2. In the shader of the terrain sample them with the coordinates of the heightmap: red, green, blue, opacity are \
            the weights of the layers in the order below. HTerrain takes the first picture as *splat* (Classic4), if the \
            ground has 2^n + 1 nodes a side.\n\n\
            Colours stay where opacity is 0. Row 0 is the north.\n",
};

static TERRAIN3D: Engine = Engine {
    word: "terrain3d",
    name: "Godot (Terrain3D)",
    sizes: Sizes::AnySquareCells,
    over_cells: false,
    tile: layout::godot_tile,
    files: |_, suffix| vec![format!("control{suffix}.exr")],
    write: |weights, holes, shape| {
        let word = |i: usize| control_word(&weights.iter().map(|w| w[i]).collect::<Vec<_>>(), holes[i]);
        let words: Vec<u32> = (0..shape.len()).map(word).collect();
        Ok(vec![write_exr_words(&words, shape)?])
    },
    steps: "1. Put the textures into Terrain3D's list in the order below: the first has id 0.\n\
            2. Open Terrain3D's importer scene; *Height File Name*: the heightmap of the preset \"godot\"; *Control File \
            Name*: `control.exr`; *Run Import*.\n\n\
            Every pixel is a word of 32 bits in a float: base texture, overlay, and how much of the overlay shows. A word \
            has two textures: where more than two layers lie, it has the two of greatest weight. Nodes without data are \
            holes. The autoshader is off, navigation too. Do not open and save the file in a paint program: as numbers its \
            floats mean nothing.\n",
};

fn by_fours(layers: &[WeightLayer], suffix: &str) -> Vec<String> {
    (0..layers.len().div_ceil(4)).map(|k| format!("splat{k}{suffix}.png")).collect()
}

fn write_by_fours(weights: &[Vec<u8>], _: &[bool], shape: Shape) -> Result<Vec<Vec<u8>>> {
    let pixel = |four: &[Vec<u8>], i: usize| std::array::from_fn(|k| four.get(k).map_or(0, |w| w[i]));
    weights
        .chunks(4)
        .map(|four| encode_rgba(&(0..shape.len()).map(|i| pixel(four, i)).collect::<Vec<_>>(), shape))
        .collect()
}

/// Terrain3D's word: base texture in bits 32 to 28, overlay in 27 to 23, blend in 22 to 15, hole in
/// bit 3 (counted from 1). The base has the greater weight; blend is the overlay's part of the two.
pub(super) fn control_word(weights: &[u8], hole: bool) -> u32 {
    let greatest = |without: Option<usize>| {
        let others = (0..weights.len()).filter(|k| Some(*k) != without);
        others.min_by_key(|&k| (255 - weights[k], k))
    };
    let base = greatest(None).unwrap_or(0);
    let overlay = greatest(Some(base)).filter(|&k| weights[k] > 0).unwrap_or(base);
    let (most, next) = (u32::from(weights[base]), u32::from(weights[overlay]));
    // To the nearest of 255 parts.
    let blend = if overlay == base { 0 } else { (510 * next + most + next) / (2 * (most + next)) };
    (base as u32 & 0x1f) << 27 | (overlay as u32 & 0x1f) << 22 | (blend & 0xff) << 14 | u32::from(hole) << 2
}

impl Engine {
    /// The card, in Markdown.
    pub(super) fn card(&self, params: &WriteWeights, layout: &Layout, title: &str, seed: u64) -> String {
        let Shape { rows, cols } = layout.tile;
        let mut card = format!(
            "# {}: weights of {title}\n\nSeed {seed}, written by landform {}. {cols} x {rows} pixels{}. In every pixel the \
             weights sum to 255.\n\n{}\n| layer | file | channel | lies |\n|---|---|---|---|\n",
            self.name,
            env!("CARGO_PKG_VERSION"),
            if layout.is_tiled() {
                format!(" a tile, {} x {} tiles", layout.tiles[0], layout.tiles[1])
            } else {
                String::new()
            },
            self.steps,
        );
        let files = (self.files)(&params.layers, "");
        for (k, layer) in params.layers.iter().enumerate() {
            let (file, channel) = match files.len() {
                n if n == params.layers.len() && params.preset == WeightPreset::Unreal => (k, "grey".to_string()),
                _ if params.preset == WeightPreset::Terrain3d => (0, format!("texture id {k}")),
                _ => (k / 4, ["red", "green", "blue", "opacity"][k % 4].to_string()),
            };
            writeln!(card, "| {} | `{}` | {channel} | {} |", layer.name, files[file], layer.rule_text()).ok();
        }
        card
    }
}

impl WeightLayer {
    /// Where it lies, in words.
    fn rule_text(&self) -> String {
        let span = |what: &str, above: Option<String>, below: Option<String>| match (above, below) {
            (Some(a), Some(b)) => format!("{what} from {a} to {b}"),
            (Some(a), None) => format!("{what} above {a}"),
            (None, Some(b)) => format!("{what} below {b}"),
            (None, None) => format!("any {what}"),
        };
        let slope = self.slope.map(|s| span("slope", s.above.map(|v| v.to_string()), s.below.map(|v| v.to_string())));
        let height =
            self.height.map(|s| span("height", s.above.map(|v| v.to_string()), s.below.map(|v| v.to_string())));
        let bound = |b: &super::Bound| match b {
            super::Bound::Number(v) => v.to_string(),
            super::Bound::Text(text) => text.clone(),
        };
        let field = self.field.as_ref().map(|name| match &self.range {
            Some([from, to]) => format!("{name} from {} (none) to {} (all)", bound(from), bound(to)),
            None => format!("{name} from 0 (none) to 1 (all)"),
        });
        let all: Vec<String> = [slope, height, field].into_iter().flatten().collect();
        if all.is_empty() { "the rest".into() } else { all.join(", ") }
    }
}
