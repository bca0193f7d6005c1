//! A regular grid of nodes.

use serde::{Deserialize, Serialize};

use super::{Edge, Edges, Georeference, Jitter, Shape};
use crate::{Error, Result, parallel};

/// Regular grid of nodes (values at vertices). Row 0 is the north edge, column 0 the west edge:
/// x = west + col · spacing.x, y = north − row · spacing.y.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Rows and columns.
    pub shape: Shape,
    /// Distance between nodes along x and y, m.
    pub spacing: [f64; 2],
    /// x of column 0 and y of row 0, m (or degrees, if [`Georeference::geographic`]).
    pub origin: [f64; 2],
    /// What the sides do.
    pub edges: Edges,
    /// Where it lies on the Earth.
    pub georeference: Georeference,
    /// The grid that this is a window of, if it is one.
    #[serde(default)]
    pub frame: Option<Frame>,
    /// How nodes stand off the centres of their cells, while water runs over them; none where they
    /// do not.
    #[serde(default)]
    pub jitter: Option<Jitter>,
}

/// The whole grid of a window. Values that depend on the whole extent, and positions to the last
/// bit, follow from it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// Rows and columns of the whole.
    pub shape: Shape,
    /// x of column 0 and y of row 0 of the whole, m.
    pub origin: [f64; 2],
    /// What the sides of the whole do.
    pub edges: Edges,
    /// Row and column of the whole at which the window begins.
    pub first: [usize; 2],
}

/// More nodes than a 32-bit index can name are refused everywhere.
const MOST_NODES: usize = u32::MAX as usize - 1;

impl Grid {
    /// A grid of local metres with its south-west node at (0, 0) and open sides.
    ///
    /// # Errors
    /// [`Error::Parameter`] for an empty or too large shape, or a spacing that is not positive and
    /// finite.
    pub fn new(shape: Shape, spacing: [f64; 2]) -> Result<Self> {
        if shape.rows == 0 || shape.cols == 0 {
            return Err(Error::parameter("shape", shape, "at least one row and one column"));
        }
        if shape.rows.checked_mul(shape.cols).is_none_or(|n| n > MOST_NODES) {
            return Err(Error::parameter("shape", shape, &format!("at most {MOST_NODES} nodes")));
        }
        if spacing.iter().any(|s| !(s.is_finite() && *s > 0.0)) {
            return Err(Error::parameter("cell_size", format!("{} x {} m", spacing[0], spacing[1]), "> 0 m"));
        }
        Ok(Self {
            shape,
            spacing,
            origin: [0.0, (shape.rows - 1) as f64 * spacing[1]],
            edges: Edges::default(),
            georeference: Georeference::default(),
            frame: None,
            jitter: None,
        })
    }

    /// The grid that covers `size` metres (x, y) with square cells as near to `cell_size` as fits a
    /// whole number of them.
    ///
    /// # Errors
    /// Where [`Grid::new`] fails, or if the size is not positive and finite.
    pub fn covering(size: [f64; 2], cell_size: f64) -> Result<Self> {
        if size.iter().any(|s| !(s.is_finite() && *s > 0.0)) {
            return Err(Error::parameter("size", format!("{} x {} m", size[0], size[1]), "> 0 m"));
        }
        if !(cell_size.is_finite() && cell_size > 0.0) {
            return Err(Error::parameter("cell_size", format!("{cell_size} m"), "> 0 m"));
        }
        let count = |s: f64| (s / cell_size).round().max(1.0);
        let (nx, ny) = (count(size[0]), count(size[1]));
        if (nx + 1.0) * (ny + 1.0) > MOST_NODES as f64 {
            return Err(Error::parameter(
                "cell_size",
                format!("{cell_size} m"),
                &format!("at most {MOST_NODES} nodes in all"),
            ));
        }
        Self::new(Shape::new(ny as usize + 1, nx as usize + 1), [size[0] / nx, size[1] / ny])
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.shape.len()
    }

    /// Whether there are no nodes (never, for a grid that was made by [`Grid::new`]).
    pub fn is_empty(&self) -> bool {
        self.shape.is_empty()
    }

    /// Position of a node, m; with [`Grid::jitter`] off the centre of its cell.
    #[inline]
    pub fn position(&self, index: usize) -> [f64; 2] {
        let cell = self.shape.cell(index);
        match self.jitter {
            None => [self.x(cell.col), self.y(cell.row)],
            Some(jitter) => {
                let [east, south] = self.offset(jitter, cell.row, cell.col);
                [self.x(cell.col) + east * self.spacing[0], self.y(cell.row) - south * self.spacing[1]]
            }
        }
    }

    #[inline]
    fn offset(&self, jitter: Jitter, row: usize, col: usize) -> [f64; 2] {
        let (first, whole) = self.frame.map_or(([0, 0], self.shape), |frame| (frame.first, frame.shape));
        jitter.offset(whole, first[0] + row, first[1] + col)
    }

    /// Columns east and rows south of the centre of its cell at which each node stands.
    pub(super) fn offsets(&self, jitter: Jitter) -> Vec<[f32; 2]> {
        parallel::map(self.len(), |i| {
            let cell = self.shape.cell(i);
            self.offset(jitter, cell.row, cell.col).map(|v| v as f32)
        })
    }

    /// x of a column, m.
    #[inline]
    pub fn x(&self, col: usize) -> f64 {
        let ([west, _], [_, first]) = self.corner();
        west + (first + col) as f64 * self.spacing[0]
    }

    /// y of a row, m.
    #[inline]
    pub fn y(&self, row: usize) -> f64 {
        let ([_, north], [first, _]) = self.corner();
        north - (first + row) as f64 * self.spacing[1]
    }

    /// North-west corner of the whole, and the row and column of it at which this grid begins.
    #[inline]
    fn corner(&self) -> ([f64; 2], [usize; 2]) {
        self.frame.map_or((self.origin, [0, 0]), |frame| (frame.origin, frame.first))
    }

    /// Column and row, as real numbers, of a position.
    #[inline]
    pub fn col_row(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let ([west, north], [row, col]) = self.corner();
        // Less a whole number: not a bit of the fraction is lost.
        [(x - west) / self.spacing[0] - col as f64, (north - y) / self.spacing[1] - row as f64]
    }

    /// The node nearest to a position (m) inside the raster.
    pub fn node_at(&self, position: [f64; 2]) -> Option<usize> {
        let [c, r] = self.col_row(position).map(f64::round);
        let is_in = c >= 0.0 && r >= 0.0 && c < self.shape.cols as f64 && r < self.shape.rows as f64;
        is_in.then(|| self.shape.index(r as usize, c as usize))
    }

    /// Extent between the outer nodes, m: (N − 1) cells.
    pub fn extent(&self) -> [f64; 2] {
        [(self.shape.cols - 1) as f64 * self.spacing[0], (self.shape.rows - 1) as f64 * self.spacing[1]]
    }

    /// The south-west and the north-east corner, m.
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let ([x, y], [dx, dy]) = (self.origin, self.extent());
        [[x, y - dy], [x + dx, y]]
    }

    /// The grid that this is a window of; this one, if it is none.
    pub fn whole(&self) -> Self {
        match self.frame {
            Some(Frame { shape, origin, edges, .. }) => Self { shape, origin, edges, frame: None, ..self.clone() },
            None => self.clone(),
        }
    }

    /// A window: rows and columns from the first to the last, both included. It knows the whole.
    /// Sides that are cut are closed.
    ///
    /// # Errors
    /// [`Error::Parameter`] if it is empty or leaves the grid.
    ///
    /// ```
    /// # use landform_core::grid::{Grid, Shape};
    /// let whole = Grid::new(Shape::new(5, 5), [0.1, 0.1])?;
    /// let window = whole.window([1, 2], [3, 4])?;
    /// assert_eq!(window.shape, Shape::new(3, 3));
    /// assert_eq!(window.position(0), whole.position(7));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn window(&self, first: [usize; 2], last: [usize; 2]) -> Result<Self> {
        let Shape { rows, cols } = self.shape;
        let [north, west] = first;
        if last[0] >= rows || last[1] >= cols || north > last[0] || west > last[1] {
            let value = format!("rows {north} to {}, columns {west} to {}", last[0], last[1]);
            return Err(Error::parameter("window", value, &format!("a part of {}", self.shape)));
        }
        let (shape, origin, edges) = (self.shape, self.origin, self.edges);
        let whole = self.frame.unwrap_or(Frame { shape, origin, edges, first: [0, 0] });
        let frame = Frame { first: [whole.first[0] + north, whole.first[1] + west], ..whole };
        Ok(Self {
            shape: Shape::new(last[0] - north + 1, last[1] - west + 1),
            origin: [self.x(west), self.y(north)],
            edges: edges.cut(self.sides_cut(first, last), Edge::Closed),
            frame: Some(frame),
            ..self.clone()
        })
    }

    /// Which sides (north, south, west, east) rows and columns from the first to the last do not
    /// reach.
    pub fn sides_cut(&self, first: [usize; 2], last: [usize; 2]) -> [bool; 4] {
        let Shape { rows, cols } = self.shape;
        [first[0] > 0, last[0] + 1 < rows, first[1] > 0, last[1] + 1 < cols]
    }

    /// First and last row and column of the nodes within a rectangle (its south-west and north-east
    /// corner, m) and a margin of it, as far as the grid goes; none if the rectangle and the grid
    /// have no node in common.
    pub fn nodes_within(&self, [sw, ne]: [[f64; 2]; 2], margin: f64) -> Option<[[usize; 2]; 2]> {
        let from = self.col_row([sw[0] - margin, ne[1] + margin]);
        let to = self.col_row([ne[0] + margin, sw[1] - margin]);
        // A rounding error beside a node still counts as on it.
        let low = |v: f64| (v - 1e-9).ceil().max(0.0);
        let high = |v: f64, n: usize| (v + 1e-9).floor().min((n - 1) as f64);
        let (west, north) = (low(from[0]), low(from[1]));
        let (east, south) = (high(to[0], self.shape.cols), high(to[1], self.shape.rows));
        let some = west <= east && north <= south;
        some.then_some([[north as usize, west as usize], [south as usize, east as usize]])
    }

    /// The grid as a file of its system has it: local metres that were made from degrees as degrees
    /// again.
    pub fn in_its_system(&self) -> Self {
        let Some(degrees) = self.georeference.degrees else { return self.clone() };
        let georeference = Georeference {
            epsg: degrees.epsg,
            geographic: true,
            registration: self.georeference.registration,
            keys: self.georeference.keys.clone(),
            degrees: None,
        };
        let spacing = [0, 1].map(|k| self.spacing[k] / degrees.metres[k]);
        Self { spacing, origin: degrees.of(self.origin), georeference, frame: None, ..self.clone() }
    }

    /// Area that one node stands for, m².
    pub fn cell_area(&self) -> f64 {
        self.spacing[0] * self.spacing[1]
    }

    /// A grid over the same ground with cells of another size, m.
    ///
    /// # Errors
    /// Where [`Grid::new`] fails.
    pub fn with_cell_size(&self, cell_size: f64) -> Result<Self> {
        let extent = self.extent();
        let size = [extent[0].max(self.spacing[0]), extent[1].max(self.spacing[1])];
        let grid = Self::covering(size, cell_size)?;
        Ok(self.place(grid))
    }

    /// The same rectangle with another number of rows and columns.
    ///
    /// # Errors
    /// Where [`Grid::new`] fails.
    pub fn with_shape(&self, rows: usize, cols: usize) -> Result<Self> {
        let spacing = |k: usize, n: usize| {
            if n > 1 && self.extent()[k] > 0.0 { self.extent()[k] / (n - 1) as f64 } else { self.spacing[k] }
        };
        Ok(self.place(Self::new(Shape::new(rows, cols), [spacing(0, cols), spacing(1, rows)])?))
    }

    /// Another spacing (m) and shape from the same north-west corner.
    ///
    /// # Errors
    /// Where [`Grid::new`] fails.
    pub fn with_spacing(&self, spacing: [f64; 2], shape: Shape) -> Result<Self> {
        Ok(self.place(Self::new(shape, spacing)?))
    }

    fn place(&self, grid: Self) -> Self {
        Self { origin: self.origin, edges: self.edges, georeference: self.georeference.clone(), ..grid }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_run_south_from_the_north_edge() {
        let grid = Grid::new(Shape::new(3, 5), [10.0, 20.0]).unwrap();
        assert_eq!(grid.position(0), [0.0, 40.0]);
        assert_eq!(grid.position(14), [40.0, 0.0]);
        assert_eq!(grid.extent(), [40.0, 40.0]);
        assert_eq!(grid.col_row([10.0, 20.0]), [1.0, 1.0]);
    }

    #[test]
    fn a_window_of_a_window_is_one_of_the_whole() {
        let whole = Grid::new(Shape::new(9, 11), [0.1, 0.3]).unwrap();
        let window = whole.window([1, 2], [7, 9]).unwrap().window([2, 3], [4, 5]).unwrap();
        assert_eq!(window, whole.window([3, 5], [5, 7]).unwrap());
        assert_eq!(window.whole(), whole);
        assert!((0..9).all(|i| window.position(i) == whole.position((3 + i / 3) * 11 + 5 + i % 3)));
        assert!(whole.window([0, 0], [9, 3]).is_err() && whole.window([3, 0], [2, 3]).is_err());
        assert_eq!(whole.nodes_within([[0.2, 0.9], [0.4, 1.5]], 0.0), Some([[3, 2], [5, 4]]));
        assert_eq!(whole.nodes_within([[0.2, 0.9], [0.4, 1.5]], 9.0), Some([[0, 0], [8, 10]]));
        assert_eq!(whole.nodes_within([[20.0, 9.0], [21.0, 9.5]], 0.0), None);
    }

    #[test]
    fn absurd_grids_are_refused() {
        assert!(Grid::new(Shape::new(0, 5), [1.0, 1.0]).is_err());
        assert!(Grid::new(Shape::new(usize::MAX, 2), [1.0, 1.0]).is_err());
        assert!(Grid::new(Shape::new(2, 2), [0.0, 1.0]).is_err());
        assert!(Grid::covering([1e9, 1e9], 0.001).is_err());
        assert!(Grid::covering([f64::NAN, 1.0], 1.0).is_err());
        assert_eq!(Grid::covering([1000.0, 500.0], 10.0).unwrap().shape, Shape::new(51, 101));
    }
}
