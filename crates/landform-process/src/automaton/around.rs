//! The neighbours of cells.

use landform_core::Result;
use landform_core::agents::{Connectivity, RasterSites};
use landform_core::grid::{Domain, Grid, Status};

use super::params::Neighbourhood;

/// A neighbour in a direction, wherever the cell is.
#[derive(Clone, Copy, Debug)]
struct Beside {
    /// Columns east, rows south.
    by: [i64; 2],
    /// Distance, m.
    distance: f64,
}

/// The neighbours of all cells of a raster; nodata is nobody's neighbour.
#[derive(Clone, Debug)]
pub(super) struct Around {
    sites: RasterSites,
    /// East first, then counter-clockwise; rings from the inside outwards.
    beside: Vec<Beside>,
    radius: i64,
    /// Whether opposite sides are joined, east and west, north and south.
    wraps: [bool; 2],
    status: Vec<Status>,
    has_holes: bool,
}

/// East, north-east and on, counter-clockwise: columns east, rows south.
const NEAR: [[i64; 2]; 8] = [[1, 0], [1, -1], [0, -1], [-1, -1], [-1, 0], [-1, 1], [0, 1], [1, 1]];

impl Around {
    /// The neighbours on a grid whose cells have a status.
    ///
    /// # Errors
    /// Where [`RasterSites::new`] fails.
    pub(super) fn new(grid: &Grid, domain: &impl Domain, neighbourhood: Neighbourhood, radius: u32) -> Result<Self> {
        let radius = i64::from(radius);
        let four = neighbourhood == Neighbourhood::Four;
        let square = (-radius..=radius).flat_map(|r| (-radius..=radius).map(move |c| [c, r]));
        let ring = |[c, r]: [i64; 2]| if four { c.abs() + r.abs() } else { c.abs().max(r.abs()) };
        let mut by: Vec<[i64; 2]> = square.filter(|&b| b != [0, 0] && ring(b) <= radius).collect();
        let near = |b: &[i64; 2]| NEAR.iter().position(|n| n == b).unwrap_or(NEAR.len());
        by.sort_by_key(|b| (ring(*b), near(b)));
        let [dx, dy] = grid.spacing;
        let length = |[c, r]: [i64; 2]| match [c, r] {
            [c, 0] => c.abs() as f64 * dx,
            [0, r] => r.abs() as f64 * dy,
            [c, r] => {
                let (east, south) = (c as f64 * dx, r as f64 * dy);
                (east * east + south * south).sqrt()
            }
        };
        let status = domain.status().to_vec();
        Ok(Self {
            sites: RasterSites::new(grid, Connectivity::Eight)?,
            beside: by.into_iter().map(|by| Beside { by, distance: length(by) }).collect(),
            radius,
            wraps: [grid.edges.wraps_cols(), grid.edges.wraps_rows()],
            has_holes: status.contains(&Status::Masked),
            status,
        })
    }

    /// What every cell is for flow.
    pub(super) fn status(&self) -> &[Status] {
        &self.status
    }

    /// Calls `visit` with every neighbour of a cell and its distance, m.
    #[inline]
    pub(super) fn each(&self, cell: usize, mut visit: impl FnMut(usize, f64)) {
        let shape = self.sites.shape();
        let at = shape.cell(cell);
        let (col, row, cols, rows) = (at.col as i64, at.row as i64, shape.cols as i64, shape.rows as i64);
        let inner = |at: i64, n: i64| at >= self.radius && at + self.radius < n;
        let is_inner = inner(col, cols) && inner(row, rows);
        for Beside { by: [east, south], distance } in &self.beside {
            let to = if is_inner {
                (cell as i64 + south * cols + east) as usize
            } else {
                let [wide, tall] = self.wraps;
                let beside = |at: i64, n: i64, wraps: bool| match (0..n).contains(&at) {
                    true => Some(at),
                    false => wraps.then(|| at.rem_euclid(n)),
                };
                let Some((c, r)) = beside(col + east, cols, wide).zip(beside(row + south, rows, tall)) else {
                    continue;
                };
                (r * cols + c) as usize
            };
            if to != cell && !(self.has_holes && self.status[to] == Status::Masked) {
                visit(to, *distance);
            }
        }
    }

    /// The neighbour of least value, if that is less than the cell's own.
    #[inline]
    pub(super) fn lowest(&self, surface: &[f64], cell: usize) -> Option<usize> {
        let (mut least, mut found) = (surface[cell], None);
        self.each(cell, |to, _| {
            if surface[to] < least {
                (least, found) = (surface[to], Some(to));
            }
        });
        found
    }

    /// The neighbour down the steepest slope, and that slope, in the surface's unit over m.
    #[inline]
    pub(super) fn steepest(&self, surface: &[f64], cell: usize) -> Option<(usize, f64)> {
        let mut found = None;
        let mut most = 0.0;
        self.each(cell, |to, distance| {
            let slope = (surface[cell] - surface[to]) / distance;
            if slope > most {
                (most, found) = (slope, Some((to, slope)));
            }
        });
        found
    }

    /// The cell so many cells to the east and to the north; none beyond an open side or in a hole.
    /// Closed sides reflect.
    #[inline]
    pub(super) fn offset(&self, cell: usize, [east, north]: [i64; 2]) -> Option<usize> {
        self.sites.moved(cell, east, -north).filter(|&to| self.status[to] != Status::Masked)
    }
}
