//! Sizes, formats and numbers that each engine needs.
//!
//! # Sources
//! Epic's technical guide to landscapes (sizes, 1/128 unit a step at scale 100), Unity's
//! TerrainData (sizes, 16-bit RAW from the south), Terrain3D's guide to importing (EXR in metres,
//! three channels), as noted in ADR 12.

use landform_core::Result;
use landform_core::terrain::NodeSurface;

use super::{Heights, Preset};
use crate::export::layout::{self, Layout, Sizes, TileName};
use crate::format::{STEPS, Sidecar, mesh_file_from_height_field, mesh_format, quantize, raster_format, write_exr_rgb};

/// An engine.
pub(super) struct Engine {
    /// The preset's word.
    pub(super) word: &'static str,
    /// Name.
    name: &'static str,
    /// Extensions that it reads.
    pub(super) extensions: &'static [&'static str],
    /// Sizes that it takes.
    pub(super) sizes: Sizes,
    /// Names of tiles; none if it takes no tiles.
    pub(super) tile: Option<TileName>,
    /// The file.
    pub(super) write: fn(&Heights) -> Result<Vec<u8>>,
    /// The numbers to type, and where.
    steps: fn(&Heights) -> String,
    /// Whether the first row is the south edge.
    south_first: bool,
}

pub(super) fn engine(preset: Preset) -> &'static Engine {
    match preset {
        Preset::Unreal => &UNREAL,
        Preset::Unity => &UNITY,
        Preset::Godot => &GODOT,
        Preset::Blender => &BLENDER,
        Preset::Gis => &GIS,
    }
}

static UNREAL: Engine = Engine {
    word: "unreal",
    name: "Unreal Engine (Landscape)",
    extensions: &["png", "r16"],
    sizes: layout::UNREAL,
    tile: Some(layout::unreal_tile),
    write: by_extension,
    steps: unreal_steps,
    south_first: false,
};

static UNITY: Engine = Engine {
    word: "unity",
    name: "Unity (Terrain)",
    extensions: &["raw"],
    sizes: layout::UNITY,
    tile: Some(layout::unity_tile),
    write: |heights| {
        // Unity reads the first row as the south edge.
        let samples = quantize(&heights.file());
        let rows = samples.chunks(heights.field.grid().shape.cols).rev();
        Ok(rows.flatten().flat_map(|v| v.to_le_bytes()).collect())
    },
    steps: unity_steps,
    south_first: true,
};

static GODOT: Engine = Engine {
    word: "godot",
    name: "Godot (Terrain3D)",
    extensions: &["exr", "r16"],
    sizes: Sizes::AnySquareCells,
    tile: Some(layout::godot_tile),
    write: |heights| {
        if heights.extension == "exr" { write_exr_rgb(&heights.file()) } else { by_extension(heights) }
    },
    steps: godot_steps,
    south_first: false,
};

static BLENDER: Engine = Engine {
    word: "blender",
    name: "Blender",
    extensions: &["exr", "glb"],
    sizes: Sizes::AnySquareCells,
    tile: None,
    write: |heights| {
        if heights.extension == "glb" {
            let format = mesh_format(std::path::Path::new("x.glb"))?;
            (format.write)(&mesh_file_from_height_field(&heights.field))
        } else {
            by_extension(heights)
        }
    },
    steps: blender_steps,
    south_first: false,
};

static GIS: Engine = Engine {
    word: "gis",
    name: "GIS (QGIS, ArcGIS, GDAL)",
    extensions: &["tif", "tiff"],
    sizes: Sizes::AnySquareCells,
    tile: None,
    write: by_extension,
    steps: gis_steps,
    south_first: false,
};

fn by_extension(heights: &Heights) -> Result<Vec<u8>> {
    (raster_format(std::path::Path::new(heights.file))?.write)(&heights.file())
}

impl Engine {
    /// The meaning of the raw numbers, for programs, where the format does not hold it.
    pub(super) fn sidecar(&self, heights: &Heights) -> Option<Sidecar> {
        let mut sidecar = raster_format(std::path::Path::new(heights.file)).ok()?.sidecar(&heights.file())?;
        if self.south_first {
            sidecar.row_order = Some("south to north".into());
        }
        Some(sidecar)
    }

    /// The import card, in Markdown.
    pub(super) fn card(&self, heights: &Heights) -> String {
        let grid = heights.field.grid();
        let ([cols, rows], [w, h]) = ([grid.shape.cols, grid.shape.rows], grid.extent());
        let [least, greatest] = heights.range;
        let mut card = format!(
            "# {}: import card for {}\n\n`{}`, seed {}, written by landform {}.\n\n| | |\n|---|---|\n\
             | nodes | {cols} x {rows} |\n| extent | {} m x {} m (east, north) |\n| spacing | {} m x {} m |\n\
             | heights | {} m to {} m |\n\n",
            self.name,
            heights.title,
            heights.file,
            heights.seed,
            env!("CARGO_PKG_VERSION"),
            digits(w),
            digits(h),
            digits(grid.spacing[0]),
            digits(grid.spacing[1]),
            digits(least),
            digits(greatest),
        );
        card += &(self.steps)(heights);
        if [cols, rows] != heights.from {
            let [c, r] = heights.from;
            card += &format!(
                "\nThe landscape has {c} x {r} nodes; it was resampled, bilinearly, to a size that fits here.\n"
            );
        }
        if heights.layout.is_tiled() {
            card += &self.tile_table(heights);
        }
        if heights.filled > 0 {
            card += &format!("\n{} nodes without data were given the least height.\n", heights.filled);
        }
        card
    }
}

impl Engine {
    /// Files of tiles, and where their north-west corners lie.
    fn tile_table(&self, heights: &Heights) -> String {
        let Layout { tiles, tile, .. } = heights.layout;
        let shared = match self.sizes {
            Sizes::OneOf(_) => {
                "Tiles that lie beside each other have their common border in both files, with the same numbers."
            }
            Sizes::AnySquareCells => "Regions share no nodes: the next one begins one spacing further on.",
        };
        let mut table = format!(
            "\n## Tiles\n\n{} east x {} north, each of {} x {} nodes, all over the same range of heights. {shared}\n\n\
             | file | north-west corner, m east | m south |\n|---|---|---|\n",
            tiles[0], tiles[1], tile.cols, tile.rows
        );
        let whole = &heights.layout.whole;
        for at in heights.layout.places() {
            let Ok(grid) = heights.layout.tile_grid(at) else { continue };
            let [east, south] = [grid.x(0) - whole.x(0), whole.y(0) - grid.y(0)];
            let name = self.tile.map_or_else(String::new, |name| name(at, tiles));
            table +=
                &format!("| `{}` | {} | {} |\n", layout::tile_path(heights.file, &name), digits(east), digits(south));
        }
        table
    }
}

/// Seven digits at most, without trailing zeros.
fn digits(v: f64) -> String {
    let text = format!("{v:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// Location and scale that bring raw steps back to metres in Unreal: Z location (cm), Z scale, and
/// Z scale by Epic's text.
pub(super) fn unreal_numbers([least, greatest]: [f64; 2]) -> [f64; 3] {
    // One step is 1/128 cm times the scale; step 32768 is the actor's own height.
    let scale = 100.0 * (greatest - least).max(1e-3) / (STEPS / 128.0);
    [100.0 * least + 256.0 * scale, scale, (greatest - least).max(1e-3) * 100.0 * 0.001_953_125]
}

fn unreal_steps(heights: &Heights) -> String {
    let grid = heights.field.grid();
    let [location, scale, epic] = unreal_numbers(heights.range);
    let [sx, sy] = [grid.spacing[0] * 100.0, grid.spacing[1] * 100.0];
    let tiles = if heights.layout.is_tiled() {
        " With tiles choose the one that ends with `_x0_y0`; x counts to the east, y to the south, as the level's axes do: \
         do not flip them."
    } else {
        ""
    };
    format!(
        "1. Landscape mode, Manage, New, *Import from File*; choose `{}`.{tiles}\n\
         2. Type these numbers, then *Import*:\n\n\
         | field | X | Y | Z |\n|---|---|---|---|\n| Location | 0 | 0 | {} |\n| Scale | {} | {} | {} |\n\n\
         Sections and components are set by the size ({} quads a side): accept what the dialog proposes. Sea level (0 m) is then at Z = 0. \
         North is up in the file and lies towards -Y in the level; east is +X. (By Epic's rounded text the Z scale is {}.)\n",
        heights.file,
        digits(location),
        digits(sx),
        digits(sy),
        format_args!("{scale:.6}"),
        grid.shape.cols - 1,
        format_args!("{epic:.6}"),
    )
}

fn unity_steps(heights: &Heights) -> String {
    let ([w, h], [least, greatest]) = (heights.layout.whole.extent(), heights.range);
    let [w, h] = [w / heights.layout.tiles[0] as f64, h / heights.layout.tiles[1] as f64];
    format!(
        "1. {} `{}`.\n\
         2. Type these numbers, then *Import*:\n\n\
         | field | value |\n|---|---|\n| Depth | Bit 16 |\n| Resolution | {} |\n| Byte Order | Windows |\n| Flip Vertically | off |\n\
         | Terrain Size X, Y, Z | {}, {}, {} |\n\n\
         3. Transform, Position Y: {}. Sea level (0 m) is then at Y = 0.\n\n\
         The first row of the file is the south edge, as Unity expects; north is +Z, east +X.\n",
        if heights.layout.is_tiled() {
            "Terrain Toolbox, Create New Terrain, Import Heightmap, *Batch*; the names end with x and z as it expects. Or, \
             for each terrain: Settings, Texture Resolutions, *Import Raw*; choose the tile of"
        } else {
            "Terrain, Settings, Texture Resolutions, *Import Raw*; choose"
        },
        heights.file,
        heights.layout.tile.cols,
        digits(w),
        digits(greatest - least),
        digits(h),
        digits(least),
    )
}

fn godot_steps(heights: &Heights) -> String {
    let grid = heights.field.grid();
    let longer = grid.shape.cols.max(grid.shape.rows);
    let fits = layout::REGIONS.iter().copied().find(|r| r * 32 >= longer).unwrap_or(2048).max(256);
    let region = if heights.layout.is_tiled() { heights.layout.tile.cols } else { fits };
    let range = if heights.extension == "exr" {
        "| Import Scale, Offset | 1, 0 (the file holds metres) |".to_string()
    } else {
        let [least, greatest] = heights.range;
        format!(
            "| R16 Range | {}, {} |\n| R16 Size | {}, {} |",
            digits(least),
            digits(greatest),
            grid.shape.cols,
            grid.shape.rows
        )
    };
    format!(
        "1. Open Terrain3D's importer scene; *Height File Name*: `{}`.\n\
         2. Type these numbers, then *Run Import*:\n\n\
         | field | value |\n|---|---|\n{range}\n| Vertex Spacing | {} |\n| Region Size | {region} (or larger) |\n\n\
         Sea level (0 m) is then at Y = 0. North is up in the file and lies towards -Z; east is +X. A 16-bit PNG would be read with 8 bits: use this file.\n",
        heights.file,
        digits(grid.spacing[0]),
    )
}

fn blender_steps(heights: &Heights) -> String {
    let grid = heights.field.grid();
    let [w, h] = grid.extent();
    if heights.extension == "glb" {
        return "1. File, Import, glTF 2.0; choose the file. Units are metres, Z is up after import, north is +Y.\n"
            .into();
    }
    format!(
        "1. Add a grid (Mesh, Grid) with {} x {} subdivisions, size 1 m, and scale it to {} x {} m.\n\
         2. Add a Displace modifier; new texture, image `{}`, colour space *Non-Color*; direction Z, coordinates UV, \
         **Midlevel 0, Strength 1**. The file holds metres. North is +Y.\n",
        grid.shape.cols - 1,
        grid.shape.rows - 1,
        digits(w),
        digits(h),
        heights.file,
    )
}

fn gis_steps(heights: &Heights) -> String {
    let grid = heights.field.grid();
    let place = match heights.field.epsg() {
        Some(code) => format!("EPSG:{code}"),
        None => "none: local metres, for this land is on no map. Choose any metric system when asked.".into(),
    };
    format!(
        "1. Drag the file into the map. Float32 metres, nodata -9999, deflate with predictor 3, tiles of 512.\n\n\
         | | |\n|---|---|\n| coordinate system | {place} |\n| first node (x, y) | {}, {} |\n| registration | point: the value is at the node |\n",
        digits(grid.origin[0]),
        digits(grid.origin[1]),
    )
}
