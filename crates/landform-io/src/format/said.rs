//! What a raster file, or what lies beside it, says of its numbers.

use landform_core::grid::Shape;

use super::placement::Placement;
use super::system::System;

/// What one source says; none where it is silent.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Said {
    /// The stored number that stands for nodata.
    pub(super) nodata: Option<f64>,
    /// Value of one step of the stored number.
    pub(super) scale: Option<f64>,
    /// Value of a stored zero.
    pub(super) offset: Option<f64>,
    /// Unit of the value.
    pub(super) unit: Option<String>,
    /// Where the samples lie.
    pub(super) placement: Option<Placement>,
    /// The coordinate reference system.
    pub(super) system: Option<System>,
    /// Whether the first row is the southernmost.
    pub(super) south_first: bool,
}

impl Said {
    /// This, and what another source says besides.
    pub(super) fn or(self, other: Self) -> Self {
        Self {
            nodata: self.nodata.or(other.nodata),
            scale: self.scale.or(other.scale),
            offset: self.offset.or(other.offset),
            unit: self.unit.or(other.unit),
            placement: self.placement.or(other.placement),
            system: self.system.or(other.system),
            south_first: self.south_first || other.south_first,
        }
    }
}

/// A file as its reader found it: numbers as they are stored, and what it says of them. Nothing is
/// applied.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stored {
    /// Rows and columns.
    pub(super) shape: Shape,
    /// Numbers, row by row.
    pub(super) samples: Vec<f64>,
    /// Which of them are data, if the file has a mask.
    pub(super) valid: Option<Vec<bool>>,
    /// What it says.
    pub(super) said: Said,
    /// What a reader of the numbers should know.
    pub(super) notes: Vec<String>,
}

impl Stored {
    /// Numbers of which nothing is said.
    pub(super) fn bare(shape: Shape, samples: Vec<f64>) -> Self {
        Self { shape, samples, ..Self::default() }
    }
}
