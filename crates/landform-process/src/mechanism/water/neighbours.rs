//! Per-node cache: the neighbour down the steepest slope, by how much the next is less steep, and
//! how many higher neighbours are still unrouted.

use landform_core::grid::{Domain, Neighbours, RasterDomain, Shape};
use landform_core::parallel;

/// A node's neighbours, in eight bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct SteepestNeighbour {
    /// By how much the drop to it, over a cell's distance, is greater than the next, m; the drop
    /// itself if no other neighbour is lower. Rounded down.
    gap: f32,
    /// The neighbour by its place in the window of nine without its middle, row by row; [`PIT`] if
    /// none is lower, [`UNKNOWN`] if the node has not eight neighbours.
    steepest: u8,
    /// The lower neighbours, a bit each.
    lower: u8,
    /// How many higher neighbours have yet to be visited; [`DONE`] once the node itself has been.
    in_degree: u8,
}

const PIT: u8 = 8;
const UNKNOWN: u8 = u8::MAX;
const DONE: u8 = u8::MAX;

impl SteepestNeighbour {
    /// The neighbour's place, if it drops by so much more than any other that all of `depth` m of
    /// water run there.
    #[inline]
    pub(super) fn sole_receiver(self, depth: f64) -> Option<usize> {
        (self.steepest < PIT && depth <= f64::from(self.gap)).then_some(self.steepest as usize)
    }
}

/// The cache of all nodes.
#[derive(Clone, Debug, Default)]
pub(super) struct NeighbourTable {
    of: Vec<SteepestNeighbour>,
    /// From a node to its eight neighbours.
    offset: [isize; 8],
}

impl NeighbourTable {
    /// Fills the table from the heights. Nodata is NaN.
    pub(super) fn build(&mut self, domain: &RasterDomain, ground: &[f64]) {
        let Shape { rows, cols } = domain.shape();
        let row = cols as isize;
        self.offset = [-row - 1, -row, -row + 1, -1, 1, row - 1, row, row + 1];
        self.of.resize(ground.len(), SteepestNeighbour::default());
        let cell = domain.cell();
        let uniform = |slot: usize| domain.steepness(cols + 1, slot as u8) * cell;
        parallel::for_rows_mut(&mut self.of, cols, |row, out| {
            let rim = |col: usize| rim_node(domain, ground, row * cols + col);
            if row == 0 || row + 1 >= rows || cols < 3 {
                out.iter_mut().enumerate().for_each(|(col, g)| *g = rim(col));
                return;
            }
            let three = &ground[(row - 1) * cols..(row + 2) * cols];
            let window = |col: usize| move |k: usize| three[(k / 3) * cols + col + k % 3 - 1];
            match domain.steepness_around(row) {
                None => {
                    let scale: [f64; 8] = std::array::from_fn(uniform);
                    (1..cols - 1).for_each(|col| out[col] = inner_node(window(col), |slot| scale[slot]));
                }
                Some(steepness) => (1..cols - 1).for_each(|col| {
                    out[col] = inner_node(window(col), |slot| steepness(slot, col - 1) * cell);
                }),
            }
            (out[0], out[cols - 1]) = (rim(0), rim(cols - 1));
        });
    }

    #[inline]
    pub(super) fn at(&self, node: usize) -> SteepestNeighbour {
        self.of[node]
    }

    /// The neighbour at a place.
    #[inline]
    pub(super) fn neighbour(&self, node: usize, place: usize) -> usize {
        (node as isize + self.offset[place & 7]) as usize
    }

    /// Whether all higher neighbours have been visited, and not yet the node.
    #[inline]
    pub(super) fn is_ready(&self, node: usize) -> bool {
        self.of[node].in_degree == 0
    }

    /// Marks a node as visited: calls `ready` with every lower neighbour that waited for no other
    /// node.
    #[inline]
    pub(super) fn visited(&mut self, domain: &RasterDomain, ground: &[f64], node: usize, mut ready: impl FnMut(usize)) {
        let neighbours = &mut self.of[node];
        neighbours.in_degree = DONE;
        let (mut lower, is_rim) = (neighbours.lower, neighbours.steepest == UNKNOWN);
        let mut release = |to: usize| {
            let in_degree = &mut self.of[to].in_degree;
            *in_degree -= 1;
            if *in_degree == 0 {
                ready(to);
            }
        };
        if is_rim {
            domain.neighbours(node).filter(|l| ground[l.to] < ground[node]).for_each(|l| release(l.to));
            return;
        }
        while lower != 0 {
            let place = lower.trailing_zeros() as usize;
            lower &= lower - 1;
            release((node as isize + self.offset[place & 7]) as usize);
        }
    }
}

fn rim_node(domain: &RasterDomain, ground: &[f64], i: usize) -> SteepestNeighbour {
    let higher = domain.neighbours(i).filter(|l| ground[l.to] > ground[i]).count() as u8;
    SteepestNeighbour {
        steepest: UNKNOWN,
        in_degree: if ground[i].is_nan() { DONE } else { higher },
        ..SteepestNeighbour::default()
    }
}

/// From the heights of a window of nine, row by row, and what a drop to the neighbour in a slot is
/// multiplied by.
#[inline]
fn inner_node(at: impl Fn(usize) -> f64, scale: impl Fn(usize) -> f64) -> SteepestNeighbour {
    let z = at(4);
    let (mut steepest, mut most, mut second) = (PIT, 0.0, 0.0);
    let (mut lower, mut higher) = (0, 0);
    for (place, k) in [0, 1, 2, 3, 5, 6, 7, 8].into_iter().enumerate() {
        let level = at(k);
        // Nodata is neither lower nor higher.
        lower |= u8::from(level < z) << place;
        higher += u8::from(level > z);
        let drop = (z - level) * scale(RasterDomain::SLOTS_BY_INDEX[place]);
        let is_steepest = drop > most;
        second = if is_steepest {
            most
        } else if drop > second {
            drop
        } else {
            second
        };
        steepest = if is_steepest { place as u8 } else { steepest };
        most = if is_steepest { drop } else { most };
    }
    let gap = ((most - second) * (1.0 - 1e-6)) as f32;
    SteepestNeighbour { gap, steepest, lower, in_degree: if z.is_nan() { DONE } else { higher } }
}
