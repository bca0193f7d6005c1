//! How a landscape is laid on the rasters that an engine takes, in one file or in tiles.
//!
//! # Sources
//! Epic's technical guide to landscapes (sizes; tiles share their border, `_x0_y0`), Unity's
//! TerrainData (sizes) and Terrain Tools (`_0_0`: x, then z from the south), Terrain3D (regions of
//! 64 to 2048 nodes, which share nothing).

use landform_core::grid::{Grid, Shape};
use landform_core::{Error, Result, math};

use crate::memory;

/// Sizes that an engine takes.
#[derive(Clone, Copy, Debug)]
pub(super) enum Sizes {
    /// Squares with one of these numbers of nodes a side; tiles share their border.
    OneOf(&'static [usize]),
    /// Any, with one spacing for both axes; tiles are regions, which share no nodes.
    AnySquareCells,
}

pub(super) const UNREAL: Sizes = Sizes::OneOf(&[127, 253, 505, 1009, 2017, 4033, 8129]);
pub(super) const UNITY: Sizes = Sizes::OneOf(&[33, 65, 129, 257, 513, 1025, 2049, 4097]);
/// Sides of a power of two and a node more.
pub(super) const GAZEBO: Sizes = UNITY;
/// Nodes along a side of Terrain3D's regions.
pub(super) const REGIONS: &[usize] = &[64, 128, 256, 512, 1024, 2048];
/// The most tiles along an axis.
pub(super) const MOST_TILES: usize = 64;
/// How many times as dense as the largest raster ground may be before it is refused.
const TOO_DENSE: f64 = 1.1;

/// Names a tile by its column and row from the north-west, and the numbers of columns and rows.
pub(super) type TileName = fn([usize; 2], [usize; 2]) -> String;

/// Ground on an engine's raster.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    /// The raster of all tiles.
    pub(super) whole: Grid,
    /// Tiles east and north.
    pub(super) tiles: [usize; 2],
    /// Nodes from the first of a tile to the first of the next, east and south.
    step: [usize; 2],
    /// Nodes of a tile.
    pub(super) tile: Shape,
}

impl Sizes {
    /// Refuses a size that the engine does not take.
    ///
    /// # Errors
    /// [`Error::Parameter`] with those that it takes.
    pub(super) fn check(self, word: &str, size: Option<usize>, tiles: [usize; 2]) -> Result<()> {
        if tiles.iter().any(|n| !(1..=MOST_TILES).contains(n)) {
            let expected = format!("from 1 to {MOST_TILES} tiles east and north");
            return Err(Error::parameter("tiles", format!("{tiles:?}"), &expected));
        }
        let listed = match self {
            Self::OneOf(sizes) => sizes,
            Self::AnySquareCells if tiles != [1, 1] => REGIONS,
            Self::AnySquareCells => return Ok(()),
        };
        match size {
            Some(size) if !listed.contains(&size) => {
                let all = listed.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
                Err(Error::parameter("size", size, &format!("one of {all} for preset \"{word}\"")))
            }
            _ => Ok(()),
        }
    }

    /// The engine's raster over a landscape's rectangle: of the size that is asked for, or of the
    /// one nearest to the landscape's own. Square cells may leave out less than a cell in the south
    /// and east.
    ///
    /// # Errors
    /// [`Error::Parameter`] for ground that is much denser than the engine's largest raster;
    /// [`Error::Memory`] if the raster, at `bytes` a node, takes more than there is.
    pub(super) fn layout(
        self,
        word: &str,
        own: &Grid,
        size: Option<usize>,
        tiles: [usize; 2],
        bytes: u64,
    ) -> Result<Layout> {
        let layout = self.layout_of(word, own, size, tiles)?;
        let Shape { rows, cols } = layout.whole.shape;
        let needed = (rows as u64).saturating_mul(cols as u64).saturating_mul(bytes);
        match memory::available() {
            Some(available) if needed > available => {
                Err(Error::Memory { what: format!("a raster of {cols} x {rows} nodes"), needed, available })
            }
            _ => Ok(layout),
        }
    }

    fn layout_of(self, word: &str, own: &Grid, size: Option<usize>, tiles: [usize; 2]) -> Result<Layout> {
        let nodes = [own.shape.cols, own.shape.rows];
        if let (Self::AnySquareCells, [1, 1]) = (self, tiles) {
            let whole = square_cells(own, size)?;
            let tile = whole.shape;
            return Ok(Layout { whole, tiles, step: [0, 0], tile });
        }
        // Of regions every node is a step, of tiles with common borders all but the last.
        let (listed, last) = match self {
            Self::OneOf(sizes) => (sizes, 1),
            Self::AnySquareCells => (REGIONS, 0),
        };
        let wanted = (0..2).map(|k| (nodes[k] - 1) as f64 / tiles[k] as f64).fold(1.0, f64::max);
        let side = match size {
            Some(size) => size,
            None => nearest(listed, last, wanted).ok_or_else(|| {
                let value = format!("not given for {} x {} nodes", nodes[0], nodes[1]);
                let greatest = listed[listed.len() - 1];
                let expected = format!(
                    "at most {greatest} a tile for preset \"{word}\"; give `size` to go coarser, or more `tiles`"
                );
                Error::parameter("size", value, &expected)
            })?,
        };
        let step = side - last;
        let shape = Shape::new(tiles[1] * step + last, tiles[0] * step + last);
        let whole = match self {
            Self::OneOf(_) => own.with_shape(shape.rows, shape.cols)?,
            Self::AnySquareCells => {
                let [w, h] = own.extent();
                let cell = (w / (shape.cols - 1) as f64).max(h / (shape.rows - 1) as f64);
                own.with_spacing([if cell > 0.0 { cell } else { own.spacing[0] }; 2], shape)?
            }
        };
        Ok(Layout { whole, tiles, step: [step; 2], tile: Shape::new(side, side) })
    }
}

/// The size whose nodes stand most nearly as dense as `wanted` steps along a side; none if even the
/// largest is much coarser.
fn nearest(listed: &[usize], last: usize, wanted: f64) -> Option<usize> {
    let steps = |n: usize| (n - last) as f64;
    let greatest = steps(*listed.last()?);
    let off = |n: usize| math::log(steps(n) / wanted).abs();
    let best = listed.iter().copied().min_by(|&a, &b| off(a).total_cmp(&off(b)));
    best.filter(|_| wanted <= TOO_DENSE * greatest)
}

fn square_cells(own: &Grid, size: Option<usize>) -> Result<Grid> {
    if size.is_none() && own.spacing[0] == own.spacing[1] {
        return Ok(own.clone());
    }
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

impl Layout {
    /// Columns east and rows south of every tile, from the north-west.
    pub(super) fn places(&self) -> impl Iterator<Item = [usize; 2]> {
        let [east, south] = self.tiles;
        (0..south).flat_map(move |y| (0..east).map(move |x| [x, y]))
    }

    /// The raster of a tile.
    ///
    /// # Errors
    /// Where [`Grid::window`] fails.
    pub(super) fn tile_grid(&self, [x, y]: [usize; 2]) -> Result<Grid> {
        let (row, col) = (y * self.step[1], x * self.step[0]);
        self.whole.window([row, col], [row + self.tile.rows - 1, col + self.tile.cols - 1])
    }

    /// Tiles that share nothing, of a raster of all of them.
    pub(super) fn of_parts(whole: Grid, tiles: [usize; 2]) -> Self {
        let tile = Shape::new(whole.shape.rows / tiles[1], whole.shape.cols / tiles[0]);
        Self { whole, tiles, step: [tile.cols, tile.rows], tile }
    }

    /// Nodes of the whole that a tile has, row by row.
    pub(super) fn nodes(&self, [x, y]: [usize; 2]) -> Vec<usize> {
        let (row, col) = (y * self.step[1], x * self.step[0]);
        let of = |k: usize| {
            let cell = self.tile.cell(k);
            self.whole.shape.index(row + cell.row, col + cell.col)
        };
        (0..self.tile.len()).map(of).collect()
    }

    /// Whether there is more than one tile.
    pub(super) fn is_tiled(&self) -> bool {
        self.tiles != [1, 1]
    }

    /// What is told of ground that was resampled to one of an engine's sizes.
    pub(super) fn note(&self, path: &str, own: &Grid) -> Option<String> {
        let size = |shape: Shape| format!("{} x {}", shape.cols, shape.rows);
        (self.whole.shape != own.shape).then(|| {
            let tiles = if self.is_tiled() {
                format!(", in {} x {} tiles of {}", self.tiles[0], self.tiles[1], size(self.tile))
            } else {
                String::new()
            };
            format!("{path}: {} nodes were resampled to {}{tiles}", size(own.shape), size(self.whole.shape))
        })
    }
}

/// A path with a tile's name before its extension.
pub(super) fn tile_path(path: &str, suffix: &str) -> String {
    let name = path.rfind('/').map_or(0, |slash| slash + 1);
    match path[name..].rfind('.') {
        Some(dot) => format!("{}{suffix}{}", &path[..name + dot], &path[name + dot..]),
        None => format!("{path}{suffix}"),
    }
}

/// The name of a tile as Unreal knows it: columns east, rows south.
pub(super) fn unreal_tile([x, y]: [usize; 2], _: [usize; 2]) -> String {
    format!("_x{x}_y{y}")
}

/// As Unity's Terrain Tools know it: columns east, rows from the south.
pub(super) fn unity_tile([x, y]: [usize; 2], tiles: [usize; 2]) -> String {
    format!("_{x}_{}", tiles[1] - 1 - y)
}

/// As Terrain3D names its regions: columns east, rows south.
pub(super) fn godot_tile([x, y]: [usize; 2], _: [usize; 2]) -> String {
    format!("_{x:02}_{y:02}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(n: usize) -> Grid {
        Grid::new(Shape::new(n, n), [10.0; 2]).unwrap()
    }

    #[test]
    fn the_nearest_size_is_taken() {
        for (own, tiles, side) in [
            (4097, [1, 1], 4033),
            (1001, [1, 1], 1009),
            (1001, [2, 2], 505),
            (100, [1, 1], 127),
            (8193, [1, 1], 8129),
            (8193, [2, 2], 4033),
        ] {
            let layout = UNREAL.layout("unreal", &grid(own), None, tiles, 80).unwrap();
            assert_eq!(layout.tile.rows, side, "{own} {tiles:?}");
            assert_eq!(layout.whole.shape.rows, tiles[1] * (side - 1) + 1);
            let [a, b] = [layout.whole.extent()[0], grid(own).extent()[0]];
            assert!((a / b - 1.0).abs() < 1e-12);
        }
        assert!(UNREAL.layout("unreal", &grid(12_000), None, [1, 1], 80).is_err());
        // 56,897 nodes a side take terabytes at a kilobyte a node.
        let vast = UNREAL.layout("unreal", &grid(65), Some(8129), [7, 7], 1 << 10);
        assert!(matches!(vast, Err(Error::Memory { .. })), "{vast:?}");
        let regions = Sizes::AnySquareCells.layout("godot", &grid(1001), None, [2, 2], 80).unwrap();
        assert_eq!((regions.tile.rows, regions.whole.shape.rows), (512, 1024));
    }

    #[test]
    fn tiles_cover_the_whole_and_share_what_the_engine_shares() {
        let layout = UNITY.layout("unity", &grid(65), None, [2, 2], 80).unwrap();
        let tiles: Vec<Grid> = layout.places().map(|at| layout.tile_grid(at).unwrap()).collect();
        assert_eq!(tiles[0].x(32), tiles[1].x(0));
        assert_eq!(tiles[0].y(32), tiles[2].y(0));
        assert_eq!(tiles[3].position(33 * 33 - 1), layout.whole.position(65 * 65 - 1));
        let names: Vec<String> = layout.places().map(|at| unity_tile(at, layout.tiles)).collect();
        assert_eq!(names, ["_0_1", "_1_1", "_0_0", "_1_0"]);
        assert_eq!(tile_path("a.b/height.png", "_x0_y1"), "a.b/height_x0_y1.png");
        assert!(UNITY.check("unity", None, [0, 1]).is_err() && UNITY.check("unity", None, [1, 65]).is_err());
    }
}
