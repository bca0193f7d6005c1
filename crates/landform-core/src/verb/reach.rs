//! How far around a node a stage reads, and the windows that can be built alone where that is not
//! far.

use crate::grid::Grid;
use crate::{Error, Result};

/// How far around a node the ground can affect the result of a stage there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// The node alone.
    Point,
    /// A number of cells around it.
    Cells(u64),
    /// A distance around it, m.
    Distance(f64),
    /// All of the ground.
    Whole,
}

impl Reach {
    /// The farther of two of the same unit; all of the ground where units differ.
    pub fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Point, reach) | (reach, Self::Point) => reach,
            (Self::Cells(a), Self::Cells(b)) => Self::Cells(a.max(b)),
            (Self::Distance(a), Self::Distance(b)) => Self::Distance(a.max(b)),
            // A distance is at least the two cells that every margin has.
            (Self::Cells(1 | 2), Self::Distance(d)) | (Self::Distance(d), Self::Cells(1 | 2)) => Self::Distance(d),
            _ => Self::Whole,
        }
    }
}

impl std::fmt::Display for Reach {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Point => f.write_str("the place alone"),
            Self::Cells(1) => f.write_str("1 cell"),
            Self::Cells(n) => write!(f, "{n} cells"),
            Self::Distance(d) => write!(f, "{d} m"),
            Self::Whole => f.write_str("the whole ground"),
        }
    }
}

/// Ground around a window that must be built as well, so that the window is the same as in the
/// whole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Margin {
    cells: u64,
    distance: f64,
    is_whole: bool,
}

impl Margin {
    /// With the reach of one more stage.
    #[must_use]
    pub fn plus(self, reach: Reach) -> Self {
        match reach {
            Reach::Point => self,
            Reach::Cells(n) => Self { cells: self.cells.saturating_add(n), ..self },
            // Two cells for stages that interpolate between nodes.
            Reach::Distance(d) => Self { distance: self.distance + d, cells: self.cells.saturating_add(2), ..self },
            Reach::Whole => Self { is_whole: true, ..self },
        }
    }

    /// Width on nodes with this distance, m; none if the whole ground is needed.
    pub fn width(self, cell: f64) -> Option<f64> {
        (!self.is_whole).then_some(self.distance + self.cells as f64 * cell)
    }
}

/// A window of the ground, to be built without the rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// South-west and north-east corner, m.
    pub bounds: [[f64; 2]; 2],
    /// Ground around it that later stages read.
    pub margin: Margin,
}

impl Window {
    /// The part of a grid that is the window with its margin.
    ///
    /// # Errors
    /// [`Error::Parameter`] if the window lies outside, or later stages need the whole.
    pub fn with_margin(&self, grid: &Grid) -> Result<Grid> {
        let cell = grid.spacing[0].max(grid.spacing[1]);
        let Some(width) = self.margin.width(cell) else {
            return Err(Error::parameter("region", self, "stages that do not need the whole ground"));
        };
        self.of(grid, width)
    }

    /// The part of a grid that the window with `width` around it covers, as a grid.
    ///
    /// # Errors
    /// [`Error::Parameter`] if the window lies outside.
    pub fn of(&self, grid: &Grid, width: f64) -> Result<Grid> {
        let outside = || {
            let [[w, s], [e, n]] = grid.bounds();
            Error::parameter(
                "region",
                self,
                &format!("a window with nodes of the ground, which lies at {w},{s},{e},{n} m"),
            )
        };
        let [first, last] = grid.nodes_within(self.bounds, width).ok_or_else(outside)?;
        grid.window(first, last)
    }
}

impl std::fmt::Display for Window {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [[w, s], [e, n]] = self.bounds;
        write!(f, "{w},{s},{e},{n} m")
    }
}
