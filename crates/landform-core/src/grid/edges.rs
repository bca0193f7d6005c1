//! Boundary conditions at the four sides of a raster.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Cell, Shape};

/// A side of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// Row 0.
    North,
    /// The last column.
    East,
    /// The last row.
    South,
    /// Column 0.
    West,
}

/// Boundary condition of a side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Edge {
    /// Water and sediment leave; the elevation is a fixed base level.
    #[default]
    Open,
    /// Nothing crosses.
    Closed,
    /// Water and sediment that leave enter at the opposite side.
    Periodic,
}

/// Boundary conditions of the four sides. Periodic sides come in opposite pairs.
///
/// Water leaves over open sides alone:
///
/// ```
/// use landform_core::grid::{Domain, Edge, Edges, Grid, RasterDomain, Shape, Status};
///
/// let mut grid = Grid::new(Shape::new(4, 4), [10.0, 10.0])?;
/// grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
/// let domain = RasterDomain::new(&grid, &[]);
/// let outlets = domain.status().iter().filter(|&&s| s == Status::BaseLevel).count();
/// assert_eq!(outlets, 4);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Edges {
    /// Row 0.
    pub north: Edge,
    /// The last column.
    pub east: Edge,
    /// The last row.
    pub south: Edge,
    /// Column 0.
    pub west: Edge,
}

impl Edges {
    /// All four sides alike.
    pub const fn all(edge: Edge) -> Self {
        Self { north: edge, east: edge, south: edge, west: edge }
    }

    /// The edge of a side.
    pub const fn get(self, side: Side) -> Edge {
        match side {
            Side::North => self.north,
            Side::East => self.east,
            Side::South => self.south,
            Side::West => self.west,
        }
    }

    /// Number of open sides of the raster that a cell lies at.
    pub fn open_sides_at(self, shape: Shape, index: usize) -> usize {
        let Cell { row, col } = shape.cell(index);
        let at = [row == 0, col + 1 == shape.cols, row + 1 == shape.rows, col == 0];
        let edges = [self.north, self.east, self.south, self.west];
        at.iter().zip(edges).filter(|(at, edge)| **at && *edge == Edge::Open).count()
    }

    /// What the sides do where a raster is cut (north, south, west, east): those that are cut
    /// become `to`, and a periodic side with the opposite one.
    pub fn cut(self, [north, south, west, east]: [bool; 4], to: Edge) -> Self {
        let after = |edge: Edge, here: bool, opposite: bool| {
            if here || (opposite && edge == Edge::Periodic) { to } else { edge }
        };
        Self {
            north: after(self.north, north, south),
            south: after(self.south, south, north),
            west: after(self.west, west, east),
            east: after(self.east, east, west),
        }
    }

    /// Whether columns wrap around (west meets east).
    pub fn wraps_cols(self) -> bool {
        self.west == Edge::Periodic && self.east == Edge::Periodic
    }

    /// Whether rows wrap around (north meets south).
    pub fn wraps_rows(self) -> bool {
        self.north == Edge::Periodic && self.south == Edge::Periodic
    }
}
