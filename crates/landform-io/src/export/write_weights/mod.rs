//! Weights of the layers that an engine paints its ground with.
//!
//! # Model
//! Layers lie on each other like paint, the first uppermost: with a_k the share of the ground where
//! the rules of layer k hold, w_1 = a_1, w_2 = (1 − a_1) a_2 and so on; the last layer has no rule
//! and takes the rest. In a pixel weights are whole numbers that sum to 255: each gets what is
//! whole of 255 w, and what is left goes to the largest remainders, of equals to the layer named
//! first.
//!
//! # Limits
//! Terrain3D blends two textures in a pixel: its control map has the two of greatest weight there.
//!
//! # Sources
//! Largest remainders: Hamilton's method of apportionment. Terrain3D's documentation, "Control map
//! format", for the bits of its words. Epic's technical guide (one 8-bit picture a layer), Unity's
//! TerrainData (alpha maps of 2^n texels over cells, four layers a picture).
//!
//! # Checked by
//! `tests`: sums, the letter F, bits of the words, tiles, rules.

mod engines;
mod rules;
#[cfg(test)]
mod tests;

use landform_core::terrain::{HeightField, Interpolation, NodeSurface, resample};
use landform_core::units::{Angle, Length};
use landform_core::verb::{Export, Landscape, LengthSpan, Output, Params, Reach, SlopeSpan, Source, file_path};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::layout::Layout;
use engines::Engine;
use rules::{Painted, share_out};

/// Writes the weights of the layers that an engine paints its ground with (rock, sediment, grass),
/// as rasters of the size that `write_heightmap` gives its heights for the same engine. Layers lie
/// on each other like paint, the first uppermost; weights sum to exactly 255 in every pixel. A card
/// (weights.md) says what goes where.
///
/// Rock where it is steep, grass elsewhere:
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
/// use landform_core::units::Angle;
/// use landform_core::verb::{Export, Landscape, MemoryOutput, SlopeSpan};
/// use landform_io::export::{WeightLayer, WriteWeights};
///
/// let hills = (0..127 * 127).map(|i| f64::from(i * 7 % 40)).collect();
/// let ground = HeightField::new(Grid::new(Shape::new(127, 127), [10.0, 10.0])?, hills)?;
/// let steep = SlopeSpan { above: Some(Angle::of(35.0)), below: None };
/// let rock = WeightLayer { name: "rock".into(), slope: Some(steep), ..WeightLayer::default() };
/// let grass = WeightLayer { name: "grass".into(), ..WeightLayer::default() };
/// let write = WriteWeights { layers: vec![rock, grass], ..WriteWeights::default() };
/// let mut out = MemoryOutput::default();
/// write.export(&Landscape::plain(&ground), &mut out)?;
/// let files: Vec<&String> = out.0.keys().collect();
/// assert_eq!(files, ["weights/grass.png", "weights/rock.png", "weights/weights.md"]);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WriteWeights {
    /// Folder below the output folder.
    pub path: String,
    /// Program that reads them: "unreal": an 8-bit picture for each layer; "unity", "godot": RGBA,
    /// four layers a picture; "terrain3d": a control map of 32-bit words (EXR).
    pub preset: WeightPreset,
    /// Layers, the uppermost first. The last has no rule and takes the rest.
    pub layers: Vec<WeightLayer>,
    /// Number of nodes along a side of the heights that they lie on, as in `write_heightmap`.
    #[schemars(extend("x-min" = 2, "x-max" = 16_385))]
    pub size: Option<usize>,
    /// Tiles east and north, as in `write_heightmap`.
    #[schemars(extend("x-min" = 1, "x-max" = 64))]
    pub tiles: [usize; 2],
    /// Angle over which a layer comes in or goes out at an end of its slopes.
    #[schemars(extend("x-min" = 0.0, "x-max" = 90.0))]
    pub slope_softness: Angle,
    /// Height over which a layer comes in or goes out at an end of its heights. If not given, it is
    /// a twentieth of the relief.
    #[schemars(extend("x-min" = 0.0))]
    pub height_softness: Option<Length>,
}

/// A layer of an engine's ground. All its rules hold together.
///
/// ```
/// use landform_io::export::WeightLayer;
///
/// assert!(WeightLayer::default().field.is_none());
/// ```
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct WeightLayer {
    /// Name, and that of its file for Unreal.
    pub name: String,
    /// Slopes on which it lies: { above = "35 deg" }.
    pub slope: Option<SlopeSpan>,
    /// Heights at which it lies: { below = "200 m" }.
    pub height: Option<LengthSpan>,
    /// Field that it follows, such as "deposition", "incision", "sand_depth" or "mask".
    pub field: Option<String>,
    /// Values of the field at which it begins and at which it is whole, in the field's unit: ["0
    /// m", "20 m"]. The second may be the lower one. If not given, they are 0 and 1.
    pub range: Option<[Bound; 2]>,
}

/// A value of a field: a number, or a text with a unit.
///
/// ```
/// use landform_io::export::WriteWeights;
///
/// let json = r#"{"layers":[{"name":"sand","field":"sand_depth","range":["0 m",2]},{"name":"rock"}]}"#;
/// assert!(serde_json::from_str::<WriteWeights>(json).is_ok());
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Bound {
    /// In the field's unit.
    Number(f64),
    /// With a unit.
    Text(String),
}

/// Program that reads weights.
///
/// ```
/// use landform_io::export::{WeightPreset, WriteWeights};
///
/// assert_eq!(WriteWeights::default().preset, WeightPreset::Unreal);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum WeightPreset {
    /// Unreal Engine: a picture of 8 bits for each layer.
    #[default]
    Unreal,
    /// Unity: alpha maps, four layers a picture.
    Unity,
    /// Godot, HTerrain and others: splat maps, four layers a picture.
    Godot,
    /// Godot, Terrain3D: a control map.
    Terrain3d,
}

impl Default for WriteWeights {
    fn default() -> Self {
        let rock = WeightLayer {
            name: "rock".into(),
            slope: Some(SlopeSpan { above: Some(Angle::of(35.0)), below: None }),
            ..WeightLayer::default()
        };
        Self {
            path: "weights".into(),
            preset: WeightPreset::Unreal,
            layers: vec![rock, WeightLayer { name: "ground".into(), ..WeightLayer::default() }],
            size: None,
            tiles: [1, 1],
            slope_softness: Angle::of(6.0),
            height_softness: None,
        }
    }
}

/// The most layers: Terrain3D's words have five bits for a texture.
const MOST_LAYERS: usize = 32;

impl Params for WriteWeights {
    const NAME: &'static str = "write_weights";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(120 + 16 * self.layers.len() as u64)
    }

    fn reach(&self) -> Reach {
        Reach::Cells(1)
    }

    fn outputs(&self) -> Vec<String> {
        let engine = self.engine();
        let tiles = self.tiles.map(|n| n.clamp(1, super::layout::MOST_TILES));
        let places = (0..tiles[1]).flat_map(|y| (0..tiles[0]).map(move |x| [x, y]));
        let suffixes = places.map(|at| if tiles == [1, 1] { String::new() } else { (engine.tile)(at, tiles) });
        let files = suffixes.flat_map(|suffix| (engine.files)(&self.layers, &suffix));
        files.chain(["weights.md".to_string()]).map(|name| self.at(&name)).collect()
    }

    fn check(&self) -> Result<()> {
        file_path(self.folder())?;
        let count = self.layers.len();
        if !(1..=MOST_LAYERS).contains(&count) {
            return Err(Error::parameter("layers", format!("{count} layers"), &format!("1 to {MOST_LAYERS} layers")));
        }
        for (k, layer) in self.layers.iter().enumerate() {
            layer.check(k + 1 == count)?;
            if self.layers[..k].iter().any(|l| l.name.eq_ignore_ascii_case(&layer.name)) {
                return Err(Error::parameter(
                    "layers",
                    format!("with \"{}\" twice", layer.name),
                    "one layer of a name",
                ));
            }
        }
        let engine = self.engine();
        engine.sizes.check(engine.word, self.size, self.tiles)
    }
}

impl WriteWeights {
    fn engine(&self) -> &'static Engine {
        engines::engine(self.preset)
    }

    fn folder(&self) -> &str {
        self.path.trim_end_matches('/')
    }

    fn at(&self, name: &str) -> String {
        format!("{}/{name}", self.folder())
    }

    /// Weights of each layer on a raster.
    fn weights(&self, ground: &HeightField) -> Result<Vec<Vec<u8>>> {
        let painted = Painted::of(self, ground)?;
        let (nodes, count) = (ground.elevation().len(), self.layers.len());
        let mut weights = vec![vec![0; nodes]; count];
        let pixels = parallel::map(nodes, |i| share_out(&painted.shares(i)));
        for (i, pixel) in pixels.into_iter().enumerate() {
            weights.iter_mut().zip(pixel).for_each(|(layer, weight)| layer[i] = weight);
        }
        Ok(weights)
    }
}

impl Export<HeightField> for WriteWeights {
    fn export(&self, landscape: &Landscape<'_, HeightField>, out: &mut dyn Output) -> Result<()> {
        let (engine, source) = (self.engine(), landscape.terrain);
        let bytes = self.bytes_a_node().unwrap_or_default();
        let layout = engine.sizes.layout(engine.word, source.grid(), self.size, self.tiles, bytes)?;
        let layout = if engine.over_cells { over_cells(&layout)? } else { layout };
        let ground = if layout.whole == *source.grid() {
            std::borrow::Cow::Borrowed(source)
        } else {
            std::borrow::Cow::Owned(resample(source, &layout.whole, Interpolation::Linear)?)
        };
        let weights = self.weights(&ground)?;
        let holes = parallel::map(ground.elevation().len(), |i| ground.elevation()[i].is_nan());
        if let Some(note) = layout.note(&self.path, source.grid()) {
            out.note(note);
        }
        for at in layout.places() {
            let suffix = if layout.is_tiled() { (engine.tile)(at, layout.tiles) } else { String::new() };
            let nodes = layout.nodes(at);
            let part = |values: &[u8]| nodes.iter().map(|&i| values[i]).collect::<Vec<_>>();
            let of_tile: Vec<Vec<u8>> = weights.iter().map(|w| part(w)).collect();
            let holes: Vec<bool> = nodes.iter().map(|&i| holes[i]).collect();
            let files = (engine.files)(&self.layers, &suffix);
            for (name, bytes) in files.iter().zip((engine.write)(&of_tile, &holes, layout.tile)?) {
                out.put(&self.at(name), &bytes)?;
            }
        }
        let card = engine.card(self, &layout, landscape.title, landscape.seed);
        out.put(&self.at("weights.md"), card.as_bytes())
    }
}

/// Texels over the cells between nodes, one fewer along each side of a tile.
fn over_cells(layout: &Layout) -> Result<Layout> {
    let side = layout.tile.rows - 1;
    let grid = &layout.whole;
    let shape = landform_core::grid::Shape::new(layout.tiles[1] * side, layout.tiles[0] * side);
    let mut whole = grid.with_spacing(grid.spacing, shape)?;
    whole.origin = [grid.origin[0] + 0.5 * grid.spacing[0], grid.origin[1] - 0.5 * grid.spacing[1]];
    Ok(Layout::of_parts(whole, layout.tiles))
}
