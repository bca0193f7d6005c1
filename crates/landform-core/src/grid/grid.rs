//! A regular grid of nodes.

use serde::{Deserialize, Serialize};

use super::{Edges, Georeference, Shape};
use crate::{Error, Result};

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
}

/// More nodes than a 32-bit index can name are refused everywhere.
const MOST_NODES: usize = u32::MAX as usize - 1;

impl Grid {
    /// A grid of local metres with its south-west node at (0, 0) and open sides.
    ///
    /// # Errors
    /// [`Error::Parameter`] for an empty or too large shape, or a spacing that is not positive and finite.
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
        })
    }

    /// The grid that covers `size` metres (x, y) with square cells as near to `cell_size` as fits a whole number of them.
    ///
    /// # Errors
    /// As [`Grid::new`]; also a size that is not positive and finite.
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

    /// Position of a node, m.
    #[inline]
    pub fn position(&self, index: usize) -> [f64; 2] {
        let cell = self.shape.cell(index);
        [self.origin[0] + cell.col as f64 * self.spacing[0], self.origin[1] - cell.row as f64 * self.spacing[1]]
    }

    /// Column and row, as real numbers, of a position.
    #[inline]
    pub fn col_row(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [(x - self.origin[0]) / self.spacing[0], (self.origin[1] - y) / self.spacing[1]]
    }

    /// The node nearest to a position inside the raster.
    pub fn node_at(&self, position: [f64; 2]) -> Option<usize> {
        let [c, r] = self.col_row(position).map(f64::round);
        let is_in = c >= 0.0 && r >= 0.0 && c < self.shape.cols as f64 && r < self.shape.rows as f64;
        is_in.then(|| self.shape.index(r as usize, c as usize))
    }

    /// Extent between the outer nodes, m: (N − 1) cells.
    pub fn extent(&self) -> [f64; 2] {
        [(self.shape.cols - 1) as f64 * self.spacing[0], (self.shape.rows - 1) as f64 * self.spacing[1]]
    }

    /// Area that one node stands for, m².
    pub fn cell_area(&self) -> f64 {
        self.spacing[0] * self.spacing[1]
    }

    /// A grid over the same ground with another shape.
    ///
    /// # Errors
    /// As [`Grid::new`].
    pub fn with_cell_size(&self, cell_size: f64) -> Result<Self> {
        let extent = self.extent();
        let size = [extent[0].max(self.spacing[0]), extent[1].max(self.spacing[1])];
        let grid = Self::covering(size, cell_size)?;
        Ok(self.place(grid))
    }

    /// The same rectangle with another number of rows and columns.
    ///
    /// # Errors
    /// As [`Grid::new`].
    pub fn with_shape(&self, rows: usize, cols: usize) -> Result<Self> {
        let spacing = |k: usize, n: usize| {
            if n > 1 && self.extent()[k] > 0.0 { self.extent()[k] / (n - 1) as f64 } else { self.spacing[k] }
        };
        Ok(self.place(Self::new(Shape::new(rows, cols), [spacing(0, cols), spacing(1, rows)])?))
    }

    /// Another spacing and shape from the same north-west corner.
    ///
    /// # Errors
    /// As [`Grid::new`].
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
    fn absurd_grids_are_refused() {
        assert!(Grid::new(Shape::new(0, 5), [1.0, 1.0]).is_err());
        assert!(Grid::new(Shape::new(usize::MAX, 2), [1.0, 1.0]).is_err());
        assert!(Grid::new(Shape::new(2, 2), [0.0, 1.0]).is_err());
        assert!(Grid::covering([1e9, 1e9], 0.001).is_err());
        assert!(Grid::covering([f64::NAN, 1.0], 1.0).is_err());
        assert_eq!(Grid::covering([1000.0, 500.0], 10.0).unwrap().shape, Shape::new(51, 101));
    }
}
