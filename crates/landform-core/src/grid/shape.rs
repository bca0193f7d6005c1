//! Rows and columns.

use serde::{Deserialize, Serialize};

/// Rows and columns of a raster; row-major, row 0 is the north edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shape {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub cols: usize,
}

/// A place in a raster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Row from the north, from 0.
    pub row: usize,
    /// Column from the west, from 0.
    pub col: usize,
}

impl Shape {
    /// From rows and columns.
    pub const fn new(rows: usize, cols: usize) -> Self {
        Self { rows, cols }
    }

    /// Number of cells.
    pub const fn len(self) -> usize {
        self.rows * self.cols
    }

    /// Whether there are no cells.
    pub const fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// Flat index of a cell.
    #[inline]
    pub const fn index(self, row: usize, col: usize) -> usize {
        row * self.cols + col
    }

    /// Cell of a flat index.
    #[inline]
    pub const fn cell(self, index: usize) -> Cell {
        Cell { row: index / self.cols, col: index % self.cols }
    }
}

impl std::fmt::Display for Shape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} rows x {} columns", self.rows, self.cols)
    }
}
