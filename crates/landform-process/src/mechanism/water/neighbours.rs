//! Per-node cache: the lowest neighbour, the drop to the second-lowest, and how many higher
//! neighbours are still unrouted.

use landform_core::grid::{Neighbours, RasterDomain, Shape};
use landform_core::parallel;

/// A node's neighbours, in eight bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LowestNeighbour {
    /// By how much the second lowest is higher than the lowest, m; as much as the node itself if no
    /// other is lower. Rounded down.
    gap: f32,
    /// The lowest neighbour by its place in the window of nine without its middle, row by row;
    /// [`PIT`] if none is lower, [`UNKNOWN`] if the node has not eight neighbours.
    lowest: u8,
    /// The lower neighbours, a bit each.
    lower: u8,
    /// How many higher neighbours have yet to be visited; [`DONE`] once the node itself has been.
    in_degree: u8,
}

const PIT: u8 = 8;
const UNKNOWN: u8 = u8::MAX;
const DONE: u8 = u8::MAX;

impl LowestNeighbour {
    /// The lowest neighbour's place, if it is lower than any other by so much that all of `depth` m
    /// of water run there.
    #[inline]
    pub(super) fn sole_receiver(self, depth: f64) -> Option<usize> {
        (self.lowest < PIT && depth <= f64::from(self.gap)).then_some(self.lowest as usize)
    }
}

/// The cache of all nodes.
#[derive(Clone, Debug, Default)]
pub(super) struct NeighbourTable {
    of: Vec<LowestNeighbour>,
    /// From a node to its eight neighbours.
    offset: [isize; 8],
}

impl NeighbourTable {
    /// Fills the table from the heights. Nodata is NaN.
    pub(super) fn build(&mut self, domain: &RasterDomain, ground: &[f64]) {
        let Shape { rows, cols } = domain.shape();
        let row = cols as isize;
        self.offset = [-row - 1, -row, -row + 1, -1, 1, row - 1, row, row + 1];
        self.of.resize(ground.len(), LowestNeighbour::default());
        parallel::for_rows_mut(&mut self.of, cols, |row, out| {
            let rim = |col: usize| rim_node(domain, ground, row * cols + col);
            if row == 0 || row + 1 >= rows || cols < 3 {
                out.iter_mut().enumerate().for_each(|(col, g)| *g = rim(col));
                return;
            }
            let three = &ground[(row - 1) * cols..(row + 2) * cols];
            for col in 1..cols - 1 {
                out[col] = inner_node(|k| three[(k / 3) * cols + col + k % 3 - 1]);
            }
            (out[0], out[cols - 1]) = (rim(0), rim(cols - 1));
        });
    }

    #[inline]
    pub(super) fn at(&self, node: usize) -> LowestNeighbour {
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
        let (mut lower, is_rim) = (neighbours.lower, neighbours.lowest == UNKNOWN);
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

fn rim_node(domain: &RasterDomain, ground: &[f64], i: usize) -> LowestNeighbour {
    let higher = domain.neighbours(i).filter(|l| ground[l.to] > ground[i]).count() as u8;
    LowestNeighbour {
        lowest: UNKNOWN,
        in_degree: if ground[i].is_nan() { DONE } else { higher },
        ..LowestNeighbour::default()
    }
}

/// From the heights of a window of nine, row by row.
#[inline]
fn inner_node(at: impl Fn(usize) -> f64) -> LowestNeighbour {
    let z = at(4);
    let (mut lowest, mut least, mut second) = (PIT, z, z);
    let (mut lower, mut higher) = (0, 0);
    for (place, k) in [0, 1, 2, 3, 5, 6, 7, 8].into_iter().enumerate() {
        let level = at(k);
        // Nodata is neither lower nor higher.
        lower |= u8::from(level < z) << place;
        higher += u8::from(level > z);
        let is_lowest = level < least;
        second = if is_lowest {
            least
        } else if level < second {
            level
        } else {
            second
        };
        lowest = if is_lowest { place as u8 } else { lowest };
        least = if is_lowest { level } else { least };
    }
    let gap = ((second - least) * (1.0 - 1e-6)) as f32;
    LowestNeighbour { gap, lowest, lower, in_degree: if z.is_nan() { DONE } else { higher } }
}
