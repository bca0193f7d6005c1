//! A raster as a graph: eight neighbours, direction codes counter-clockwise from east.
//!
//! Slots: 0 east, 1 north-east, 2 north, 3 north-west, 4 west, 5 south-west, 6 south, 7 south-east.
//! Opposite slots differ by 4. Masked nodes hold NaN in every elevation that is passed in, so that
//! no comparison ever chooses them.

use super::domain::steepest_link;
use super::jitter::Jittered;
use super::{Centres, Domain, Edge, Grid, Link, NO_SLOT, Neighbours, Shape, Side, Status, is_below};
use crate::parallel;
use std::sync::Arc;

const ROW_STEP: [isize; 8] = [0, -1, -1, -1, 0, 1, 1, 1];
const COL_STEP: [isize; 8] = [1, 1, 0, -1, -1, -1, 0, 1];

/// `ADJACENT[a]` has bit b set if the cells in directions a and b touch (side or corner).
const ADJACENT: [u8; 8] = adjacency();

const fn adjacency() -> [u8; 8] {
    let mut table = [0u8; 8];
    let mut a = 0;
    while a < 8 {
        let mut b = 0;
        while b < 8 {
            let (dr, dc) = (ROW_STEP[a] - ROW_STEP[b], COL_STEP[a] - COL_STEP[b]);
            if a != b && dr * dr <= 1 && dc * dc <= 1 {
                table[a] |= 1 << b;
            }
            b += 1;
        }
        a += 1;
    }
    table
}

/// The directions of a mask that are joined to its first.
const fn first_arc(mask: u8) -> u8 {
    let mut arc = mask & mask.wrapping_neg();
    loop {
        let (mut grown, mut k) = (arc, 0);
        while k < 8 {
            if arc >> k & 1 == 1 {
                grown |= ADJACENT[k] & mask;
            }
            k += 1;
        }
        if grown == arc {
            return arc;
        }
        arc = grown;
    }
}

/// Whether the neighbour in a slot has a lower index.
const BEFORE: [bool; 8] = [false, true, true, true, true, false, false, false];

/// Weights of the slopes to sides and to corners where nodes stand off the centres. The eight
/// neighbours hide what stands behind the sides, not what stands behind the corners: unweighted,
/// water turns up to 5 degrees towards the corners; with this, less than 1.
const DIAGONAL: [f64; 2] = [1.0, 0.92];

/// The first arc of each mask.
const FIRST_ARC: [u8; 256] = {
    let mut table = [0; 256];
    let mut mask = 1;
    while mask < 256 {
        table[mask] = first_arc(mask as u8);
        mask += 1;
    }
    table
};

/// 1 for masks whose directions form more than one arc.
const IS_SADDLE: [u8; 256] = {
    let mut table = [0; 256];
    let mut mask = 1;
    while mask < 256 {
        table[mask] = (FIRST_ARC[mask] != mask as u8) as u8;
        mask += 1;
    }
    table
};

/// A grid's nodes as a graph of eight neighbours.
#[derive(Clone, Debug)]
pub struct RasterDomain {
    shape: Shape,
    offset: [isize; 8],
    distance: [f64; 8],
    inverse: [f64; 8],
    conductance: [f64; 8],
    area: f64,
    wraps_cols: bool,
    wraps_rows: bool,
    status: Vec<Status>,
    has_mask: bool,
    jittered: Option<Arc<Jittered>>,
}

impl RasterDomain {
    /// The slots of a node's neighbours, those of lower index first: row by row.
    ///
    /// ```
    /// // North-west, the first of the window around a node.
    /// assert_eq!(landform_core::grid::RasterDomain::SLOTS_BY_INDEX[0], 3);
    /// ```
    pub const SLOTS_BY_INDEX: [usize; 8] = [3, 2, 1, 4, 0, 5, 6, 7];

    /// From a grid, its validity mask (empty: all valid) and its edges.
    ///
    /// Nodes on open sides are base level; so is the rim of nodata that reaches an open side.
    /// Nodata inside is a hole that water does not cross.
    pub fn new(grid: &Grid, valid: &[bool]) -> Self {
        let cols = grid.shape.cols as isize;
        let [dx, dy] = grid.spacing;
        let diagonal = (dx * dx + dy * dy).sqrt();
        let distance = [dx, diagonal, dy, diagonal, dx, diagonal, dy, diagonal];
        let mut domain = Self {
            shape: grid.shape,
            offset: std::array::from_fn(|k| ROW_STEP[k] * cols + COL_STEP[k]),
            distance,
            inverse: distance.map(|d| 1.0 / d),
            conductance: [dy / dx, 0.0, dx / dy, 0.0, dy / dx, 0.0, dx / dy, 0.0],
            area: dx * dy,
            wraps_cols: grid.edges.wraps_cols() && grid.shape.cols > 2,
            wraps_rows: grid.edges.wraps_rows() && grid.shape.rows > 2,
            status: vec![Status::Interior; grid.len()],
            has_mask: false,
            jittered: None,
        };
        if let Some(jitter) = grid.jitter {
            let moves = std::array::from_fn(|k| [COL_STEP[k] as f64, ROW_STEP[k] as f64]);
            domain.jittered =
                Some(Arc::new(Jittered::new(grid.offsets(jitter), grid.spacing, moves, |i, k| domain.step(i, k))));
        }
        for side in [Side::North, Side::East, Side::South, Side::West] {
            if grid.edges.get(side) == Edge::Open {
                for i in side_nodes(grid.shape, side) {
                    domain.status[i] = Status::BaseLevel;
                }
            }
        }
        domain.mask(valid);
        domain
    }

    /// Number of rows and columns.
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// The shorter side of a cell, m.
    ///
    /// ```
    /// use landform_core::grid::{Grid, RasterDomain, Shape};
    ///
    /// let grid = Grid::new(Shape::new(3, 3), [10.0, 12.0])?;
    /// assert_eq!(RasterDomain::new(&grid, &[]).cell(), 10.0);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    #[inline]
    pub fn cell(&self) -> f64 {
        self.distance[0].min(self.distance[2])
    }

    /// [`Domain::steepness`] (1/m) of the links of columns 1 to `cols` − 2 of a row that is neither
    /// the first nor the last, by slot and column less one; none if it is the same at every node.
    /// The raster has at least three columns.
    ///
    /// ```
    /// use landform_core::grid::{Domain, Grid, Jitter, RasterDomain, Shape};
    /// use landform_core::random::Seed;
    ///
    /// let mut grid = Grid::new(Shape::new(5, 5), [10.0, 10.0])?;
    /// assert!(RasterDomain::new(&grid, &[]).steepness_around(2).is_none());
    /// grid.jitter = Some(Jitter { seed: Seed(1) });
    /// let domain = RasterDomain::new(&grid, &[]);
    /// assert_eq!(domain.steepness_around(2).unwrap()(7, 1), domain.steepness(12, 7));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    #[inline]
    pub fn steepness_around(&self, row: usize) -> Option<impl Fn(usize, usize) -> f64 + '_> {
        let inverse = self.jittered.as_ref()?.around_row(row, self.shape.cols);
        Some(move |slot: usize, col: usize| f64::from(inverse[slot][col]) * DIAGONAL[slot & 1])
    }

    fn mask(&mut self, valid: &[bool]) {
        if valid.iter().all(|&v| v) {
            return;
        }
        self.has_mask = true;
        let outside = self.outside(valid);
        for i in 0..valid.len() {
            if !valid[i] {
                self.status[i] = Status::Masked;
            } else if self.status[i] == Status::Interior && (0..8).any(|k| self.step(i, k).is_some_and(|j| outside[j]))
            {
                self.status[i] = Status::BaseLevel;
            }
        }
    }

    /// Nodata that is connected to an open side.
    fn outside(&self, valid: &[bool]) -> Vec<bool> {
        let mut outside = vec![false; valid.len()];
        let mut stack: Vec<usize> =
            (0..valid.len()).filter(|&i| !valid[i] && self.status[i] == Status::BaseLevel).collect();
        while let Some(i) = stack.pop() {
            if std::mem::replace(&mut outside[i], true) {
                continue;
            }
            stack.extend((0..8).filter_map(|k| self.step(i, k)).filter(|&j| !valid[j] && !outside[j]));
        }
        outside
    }

    /// The node one step away in direction `k`, if it is in the raster.
    #[inline]
    fn step(&self, node: usize, k: usize) -> Option<usize> {
        let cell = self.shape.cell(node);
        let row = wrap(cell.row, ROW_STEP[k], self.shape.rows, self.wraps_rows)?;
        let col = wrap(cell.col, COL_STEP[k], self.shape.cols, self.wraps_cols)?;
        Some(self.shape.index(row, col))
    }

    /// Distance from a node to its neighbour `to` in direction `k`, m.
    #[inline]
    fn length(&self, node: usize, to: usize, k: usize) -> f64 {
        match &self.jittered {
            None => self.distance[k],
            Some(jittered) => 1.0 / jittered.per_length(k, node, || to),
        }
    }

    #[inline]
    fn is_rim(&self, node: usize) -> bool {
        // Divisions of 32 bits take half the time.
        let (node, rows, cols) = (node as u32, self.shape.rows as u32, self.shape.cols as u32);
        let (row, col) = (node / cols, node % cols);
        row == 0 || col == 0 || row + 1 == rows || col + 1 == cols
    }

    /// The values around a node that is not on the rim, by slot.
    #[inline]
    fn around<T: Copy>(&self, values: &[T], node: usize) -> [T; 8] {
        let row = |from: usize| -> &[T] { &values[from - 1..from + 2] };
        let (north, middle, south) = (row(node - self.shape.cols), row(node), row(node + self.shape.cols));
        [middle[2], north[2], north[1], north[0], middle[0], south[0], south[1], south[2]]
    }

    /// Steepest descent for one row; nodes with all eight neighbours take the branch-free kernel.
    fn steepest_row(&self, elevation: &[f64], row: usize, slots: &mut [u8]) {
        let cols = self.shape.cols;
        let inner = row > 0 && row + 1 < self.shape.rows && cols > 2;
        if inner {
            let rows = &elevation[(row - 1) * cols..(row + 2) * cols];
            match self.steepness_around(row) {
                None => {
                    let inverse = self.inverse;
                    steepest_kernel(rows, cols, |k, _| inverse[k], slots);
                }
                Some(steepness) => steepest_kernel(rows, cols, steepness, slots),
            }
        }
        let status = &self.status[row * cols..(row + 1) * cols];
        // The kernel leaves out the first and the last column.
        let by_link = |col: usize| steepest_link(self, elevation, row * cols + col).map_or(NO_SLOT, |l| l.slot);
        if inner {
            (slots[0], slots[cols - 1]) = (by_link(0), by_link(cols - 1));
        } else {
            slots.iter_mut().enumerate().for_each(|(col, slot)| *slot = by_link(col));
        }
        for (slot, &s) in slots.iter_mut().zip(status) {
            *slot = if s == Status::Interior { *slot } else { NO_SLOT };
        }
    }
}

/// Columns 1..cols−1 of a row with a row above and below: the row's values, and those around them,
/// by slot.
#[inline]
fn surrounded(rows: &[f64], cols: usize) -> (&[f64], [&[f64]; 8]) {
    let (up, rest) = rows.split_at(cols);
    let (here, down) = rest.split_at(cols);
    let n = cols - 2;
    let (uw, uc, ue) = (&up[..n], &up[1..=n], &up[2..][..n]);
    let (hw, hc, he) = (&here[..n], &here[1..=n], &here[2..][..n]);
    let (dw, dc, de) = (&down[..n], &down[1..=n], &down[2..][..n]);
    (hc, [he, ue, uc, uw, hw, dw, dc, de])
}

/// Steepest descent of [`surrounded`] values. Slopes are compared as drop times inverse distance,
/// by slot and column.
#[inline]
fn steepest_kernel(rows: &[f64], cols: usize, inverse: impl Fn(usize, usize) -> f64, slots: &mut [u8]) {
    let (here, around) = surrounded(rows, cols);
    let out = &mut slots[1..cols - 1];
    for j in 0..cols - 2 {
        let z = here[j];
        let (mut best, mut slot) = (0.0, NO_SLOT);
        for k in 0..8 {
            let s = (z - around[k][j]) * inverse(k, j);
            let steeper = s > best;
            best = if steeper { s } else { best };
            slot = if steeper { k as u8 } else { slot };
        }
        out[j] = slot;
    }
}

/// Whether lower neighbours of [`surrounded`] values form several arcs.
fn saddle_kernel(rows: &[f64], cols: usize, saddles: &mut [u8]) {
    let (here, [e, ne, n, nw, w, sw, s, se]) = surrounded(rows, cols);
    let out = &mut saddles[1..cols - 1];
    for j in 0..cols - 2 {
        let z = here[j];
        // Of equals the one with the lower index is lower: north-east, north, north-west and west
        // come before.
        let lower = [e[j] < z, ne[j] <= z, n[j] <= z, nw[j] <= z, w[j] <= z, sw[j] < z, s[j] < z, se[j] < z];
        out[j] = lower.iter().enumerate().fold(0, |mask, (k, &l)| mask | u8::from(l) << k);
    }
    for mask in out {
        *mask = IS_SADDLE[*mask as usize];
    }
}

fn wrap(at: usize, step: isize, n: usize, wraps: bool) -> Option<usize> {
    match at.checked_add_signed(step) {
        Some(i) if i < n => Some(i),
        Some(_) if wraps => Some(0),
        None if wraps => Some(n - 1),
        _ => None,
    }
}

/// The nodes of a side, west to east or north to south.
pub(super) fn side_nodes(shape: Shape, side: Side) -> Box<dyn Iterator<Item = usize>> {
    let Shape { rows, cols } = shape;
    match side {
        Side::North => Box::new(0..cols),
        Side::South => Box::new((rows - 1) * cols..rows * cols),
        Side::West => Box::new((0..rows).map(move |r| r * cols)),
        Side::East => Box::new((0..rows).map(move |r| r * cols + cols - 1)),
    }
}

impl Neighbours for RasterDomain {
    fn len(&self) -> usize {
        self.status.len()
    }

    #[inline]
    fn neighbours(&self, node: usize) -> impl Iterator<Item = Link> {
        let plain = !self.has_mask && !self.is_rim(node);
        (0..8).filter_map(move |k| {
            let to = if plain {
                (node as isize + self.offset[k]) as usize
            } else {
                self.step(node, k).filter(|&j| self.status[j] != Status::Masked)?
            };
            Some(Link { to, distance: self.length(node, to, k), slot: k as u8 })
        })
    }
}

impl Domain for RasterDomain {
    #[inline]
    fn area(&self, _: usize) -> f64 {
        self.area
    }

    #[inline]
    fn status(&self) -> &[Status] {
        &self.status
    }

    #[inline]
    fn each_donor(&self, node: usize, receiver: &[u32], mut visit: impl FnMut(usize)) {
        if self.is_rim(node) {
            // Masked nodes are their own receivers, here and below.
            let donors = (0..8).filter_map(|k| self.step(node, k)).filter(|&j| receiver[j] as usize == node);
            return donors.for_each(visit);
        }
        let around = self.around(receiver, node);
        let mut donors = (0..8).fold(0_u32, |bits, k| bits | u32::from(around[k] == node as u32) << k);
        while donors != 0 {
            visit((node as isize + self.offset[donors.trailing_zeros() as usize & 7]) as usize);
            donors &= donors - 1;
        }
    }

    #[inline]
    fn neighbour(&self, node: usize, slot: u8) -> usize {
        if (self.wraps_cols || self.wraps_rows) && self.is_rim(node) {
            return self.step(node, slot as usize).unwrap_or(node);
        }
        (node as isize + self.offset[slot as usize & 7]) as usize
    }

    #[inline]
    fn distance(&self, node: usize, slot: u8) -> f64 {
        let k = slot as usize & 7;
        if self.jittered.is_none() || slot == NO_SLOT {
            return self.distance[k];
        }
        self.length(node, self.neighbour(node, slot), k)
    }

    #[inline]
    fn inverse_distance(&self, node: usize, slot: u8) -> f64 {
        match &self.jittered {
            None => self.inverse[slot as usize & 7],
            Some(jittered) => jittered.per_length(slot as usize & 7, node, || self.neighbour(node, slot)),
        }
    }

    #[inline]
    fn steepness(&self, node: usize, slot: u8) -> f64 {
        match &self.jittered {
            None => self.inverse[slot as usize & 7],
            Some(_) => self.inverse_distance(node, slot) * DIAGONAL[slot as usize & 1],
        }
    }

    #[inline]
    fn conductance(&self, _: usize, slot: u8) -> f64 {
        self.conductance[slot as usize & 7]
    }

    #[inline]
    fn slot_back(&self, _: usize, slot: u8) -> u8 {
        (slot + 4) & 7
    }

    fn five_point(&self) -> Option<Shape> {
        (!self.wraps_cols && !self.wraps_rows).then_some(self.shape)
    }

    fn centres(&self) -> Option<Centres> {
        let jittered = self.jittered.as_ref()?;
        let (status, offset) = (&self.status, &jittered.offset);
        let held = |i: usize| status[i] != Status::Interior;
        Some(Centres::new(self.shape, offset, held, |i| status[i] == Status::Masked))
    }

    fn steepest_descent(&self, elevation: &[f64], receiver: &mut [u32], slot: &mut [u8]) {
        let cols = self.shape.cols;
        let wraps = self.wraps_cols || self.wraps_rows;
        // By slot, so that no branch has to be guessed; 0 for none.
        let mut step = [0_u32; 256];
        (0..8).for_each(|k| step[k] = self.offset[k] as u32);
        let band = cols * (parallel::PIECE / cols).max(1);
        parallel::for_pieces_mut2(receiver, slot, band, |first, receivers, slots| {
            for (k, (receivers, slots)) in receivers.chunks_mut(cols).zip(slots.chunks_mut(cols)).enumerate() {
                let row = first / cols + k;
                self.steepest_row(elevation, row, slots);
                let start = row * cols;
                if !wraps {
                    for (col, (r, &s)) in receivers.iter_mut().zip(slots.iter()).enumerate() {
                        *r = ((start + col) as u32).wrapping_add(step[s as usize]);
                    }
                    continue;
                }
                for (col, (r, &s)) in receivers.iter_mut().zip(slots.iter()).enumerate() {
                    let node = start + col;
                    *r = if s == NO_SLOT { node } else { self.neighbour(node, s) } as u32;
                }
            }
        });
    }

    fn saddles(&self, elevation: &[f64], saddle: &mut [u8]) {
        let cols = self.shape.cols;
        parallel::for_rows_mut(saddle, cols, |row, saddles| {
            let inner = row > 0 && row + 1 < self.shape.rows && cols > 2;
            if inner {
                saddle_kernel(&elevation[(row - 1) * cols..(row + 2) * cols], cols, saddles);
            }
            for (col, saddle) in saddles.iter_mut().enumerate() {
                let node = row * cols + col;
                if !inner || col == 0 || col + 1 == cols {
                    let mut arcs = 0;
                    self.lower_arcs(elevation, node, NO_SLOT, |_| arcs += 1);
                    *saddle = u8::from(arcs > 1);
                }
                let s = self.status[node];
                *saddle = if s == Status::Interior { *saddle } else { u8::from(s == Status::BaseLevel) };
            }
        });
    }

    fn lowest(&self, elevation: &[f64], node: usize) -> Option<(usize, u8)> {
        if self.is_rim(node) {
            let lower = |a: Link, b: Link| if is_below(elevation, b.to, a.to) { b } else { a };
            return self.neighbours(node).reduce(lower).map(|l| (l.to, l.slot));
        }
        let around = self.around(elevation, node);
        let (mut least, mut slot) = (f64::INFINITY, NO_SLOT);
        for k in Self::SLOTS_BY_INDEX {
            let lower = around[k] < least;
            least = if lower { around[k] } else { least };
            slot = if lower { k as u8 } else { slot };
        }
        (slot != NO_SLOT).then(|| ((node as isize + self.offset[slot as usize & 7]) as usize, slot))
    }

    #[inline]
    fn touches_other(&self, label: &[u32], node: usize) -> bool {
        if self.is_rim(node) {
            return self.neighbours(node).any(|l| label[l.to] != label[node]);
        }
        self.around(label, node).into_iter().fold(false, |other, l| other | (l != label[node]))
    }

    #[inline]
    fn lower_arcs(&self, elevation: &[f64], node: usize, own: u8, mut visit: impl FnMut(u8)) {
        let mut lower = 0u8;
        if self.is_rim(node) {
            for link in self.neighbours(node) {
                lower |= u8::from(is_below(elevation, link.to, node)) << link.slot;
            }
        } else {
            let (around, z) = (self.around(elevation, node), elevation[node]);
            for (k, &at) in around.iter().enumerate() {
                lower |= u8::from(at < z || (at == z && BEFORE[k])) << k;
            }
        }
        while lower != 0 {
            let arc = FIRST_ARC[lower as usize];
            lower &= !arc;
            if own > 7 || arc >> own & 1 == 0 {
                visit(arc.trailing_zeros() as u8);
            }
        }
    }

    fn set_status(&mut self, status: Vec<Status>) {
        self.has_mask = status.contains(&Status::Masked);
        self.status = status;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::random::Seed;

    fn noise(n: usize) -> Vec<f64> {
        (0..n).map(|i| Seed(5).uniform(i as u64)).collect()
    }

    #[test]
    fn the_row_kernel_agrees_with_the_definition() {
        let jitter = Some(crate::grid::Jitter { seed: Seed(1) });
        let all = [Edges::default(), Edges::all(Edge::Closed), Edges::all(Edge::Periodic)];
        for (edges, jitter) in all.into_iter().flat_map(|edges| [(edges, None), (edges, jitter)]) {
            let mut grid = Grid::new(Shape::new(13, 17), [10.0, 7.0]).unwrap();
            (grid.edges, grid.jitter) = (edges, jitter);
            let domain = RasterDomain::new(&grid, &[]);
            let z = noise(grid.len());
            let (mut receiver, mut slot, mut saddle) = (vec![0; z.len()], vec![0; z.len()], vec![0; z.len()]);
            domain.steepest_descent(&z, &mut receiver, &mut slot);
            domain.saddles(&z, &mut saddle);
            for i in 0..z.len() {
                let expected = if domain.status[i] == Status::Interior { steepest_link(&domain, &z, i) } else { None };
                assert_eq!(slot[i], expected.map_or(NO_SLOT, |l| l.slot));
                assert_eq!(receiver[i] as usize, expected.map_or(i, |l| l.to));
                let mut arcs = 0;
                domain.lower_arcs(&z, i, NO_SLOT, |_| arcs += 1);
                let least = |a: usize, b: usize| if is_below(&z, b, a) { b } else { a };
                let lowest = domain.neighbours(i).map(|l| l.to).reduce(least);
                assert_eq!(domain.lowest(&z, i).map(|(to, _)| to), lowest);
                let label: Vec<u32> = z.iter().map(|z| (z * 4.0) as u32).collect();
                let differs = domain.neighbours(i).any(|l| label[l.to] != label[i]);
                assert_eq!(domain.touches_other(&label, i), differs);
                assert_eq!(saddle[i] == 1, arcs > 1 || domain.status[i] == Status::BaseLevel);
            }
        }
    }

    #[test]
    fn arcs_of_directions_are_told_apart() {
        // East and north touch at a corner; east and west do not.
        assert_eq!(IS_SADDLE[0b0000_0101], 0);
        assert_eq!(IS_SADDLE[0b0001_0001], 1);
        assert_eq!(IS_SADDLE[0b1111_1111], 0);
        assert_eq!(IS_SADDLE[0b0010_0010], 1);
        assert_eq!(first_arc(0b0001_0011), 0b0000_0011);
    }

    #[test]
    fn outer_nodata_has_an_open_rim_and_a_hole_has_not() {
        let grid = Grid::new(Shape::new(9, 9), [1.0, 1.0]).unwrap();
        let mut valid = vec![true; 81];
        for c in 0..9 {
            valid[c] = false;
        }
        valid[5 * 9 + 4] = false;
        let domain = RasterDomain::new(&grid, &valid);
        assert_eq!(domain.status[9 + 4], Status::BaseLevel, "below the outer nodata");
        assert_eq!(domain.status[4 * 9 + 4], Status::Interior, "beside the hole");
        assert!(domain.neighbours(4 * 9 + 4).all(|l| l.to != 5 * 9 + 4));
    }
}
