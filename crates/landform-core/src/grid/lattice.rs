//! A box of sites in two or three dimensions.

use crate::{Error, Result};

/// A box of sites, x first: index = x + nx (y + ny z). A raster is a box with one layer, y running
/// south.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// Number of sites along x, y and z.
    pub size: [usize; 3],
    /// Distance between sites along each, m.
    pub spacing: [f64; 3],
    /// Whether the last site along an axis is a neighbour of the first.
    pub periodic: [bool; 3],
}

impl Lattice {
    /// A box of sites, `spacing` metres apart, that ends at its sides.
    ///
    /// # Errors
    /// [`Error::Parameter`] for an axis without sites, more sites than a 32-bit index can name, or
    /// a spacing that is not positive.
    pub fn new(size: [usize; 3], spacing: [f64; 3]) -> Result<Self> {
        let count = size[0].checked_mul(size[1]).and_then(|n| n.checked_mul(size[2]));
        if count.is_none_or(|n| n == 0 || n >= u32::MAX as usize) {
            return Err(Error::parameter(
                "size",
                format!("{size:?}"),
                "at least one site along each axis, fewer than 4e9 in all",
            ));
        }
        if spacing.iter().any(|s| !(s.is_finite() && *s > 0.0)) {
            return Err(Error::parameter("spacing", format!("{spacing:?} m"), "> 0 m"));
        }
        Ok(Self { size, spacing, periodic: [false; 3] })
    }

    /// The lattice of a raster.
    pub fn of(grid: &super::Grid) -> Self {
        Self {
            size: [grid.shape.cols, grid.shape.rows, 1],
            spacing: [grid.spacing[0], grid.spacing[1], 1.0],
            periodic: [grid.edges.wraps_cols(), grid.edges.wraps_rows(), false],
        }
    }

    /// Number of sites.
    pub fn len(&self) -> usize {
        self.size[0] * self.size[1] * self.size[2]
    }

    /// Whether there are none (never, for a lattice that was made by [`Lattice::new`]).
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Coordinates of a site, in sites.
    #[inline]
    pub fn place(&self, site: usize) -> [usize; 3] {
        [site % self.size[0], site / self.size[0] % self.size[1], site / (self.size[0] * self.size[1])]
    }

    /// The site at coordinates.
    #[inline]
    pub fn site(&self, [x, y, z]: [usize; 3]) -> usize {
        x + self.size[0] * (y + self.size[1] * z)
    }

    /// The site `by` sites away; none beyond a side that does not wrap.
    #[inline]
    pub fn moved(&self, place: [usize; 3], by: [i64; 3]) -> Option<usize> {
        let mut to = place;
        for axis in 0..3 {
            let n = self.size[axis] as i64;
            let moved = place[axis] as i64 + by[axis];
            to[axis] = match (0..n).contains(&moved) {
                true => moved as usize,
                false if self.periodic[axis] => moved.rem_euclid(n) as usize,
                false => return None,
            };
        }
        Some(self.site(to))
    }

    /// The shortest vector from one site to another, m, around periodic sides where that is nearer.
    pub fn offset(&self, from: usize, to: usize) -> [f64; 3] {
        let (a, b) = (self.place(from), self.place(to));
        std::array::from_fn(|axis| {
            let n = self.size[axis] as i64;
            let mut d = b[axis] as i64 - a[axis] as i64;
            if self.periodic[axis] {
                d = (d + n / 2).rem_euclid(n) - n / 2;
            }
            d as f64 * self.spacing[axis]
        })
    }
}
