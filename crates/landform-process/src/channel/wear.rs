//! Erosion by channels in a round (Eqs. 4.4 and 4.6 of Pytel 2015).
//!
//! # Model
//! In units of length u = extent / 256 (the thesis' grids have about as many cells), with f = (w_a
//! f_a + w_c f_c)^m:
//!
//! ∂z/∂t = f w_Δ Δz − f (w_d |∇h| + w_0), never lower than the lowest neighbour; pits have only f
//! w_Δ Δz − f w_0, down to the lowest elevation at the start.
//!
//! # Method
//! The cutting part is explicit and limited by the lowest neighbour at the start of the round.
//! Smoothing is implicit, by a few Jacobi sweeps from there, so that no weight makes it unstable.
//! No node reads what another has written: the result has the same bits on any number of threads.
//! Without `everywhere` smoothing only lowers: ground that would fill a channel's bed is washed
//! away.
//!
//! # Sources
//! Pytel (2015), Eqs. 4.4 to 4.6. His time step is in the weights and his f has no stated scale;
//! here f_c is the part of the map's water, and a round is [`STEP`] of a step of his equation,
//! found by looking. We take the slope of the water's surface, so that rivers stop cutting where
//! they run into lakes. Slopes are those of the fitted quadratic, as his; the Laplacian is not:
//! that of a quadratic fitted to nine nodes is positive for the checkerboard (8/3 for one of height
//! 1), so explicit or not it would grow.

use landform_core::algo::derivative::quadratic;
use landform_core::grid::{Domain, RasterDomain, Status};
use landform_core::grid::{Grid, Neighbours};
use landform_core::verb::Resolved;
use landform_core::{math, parallel};

use super::banks::{Bank, River};

/// Fraction of a step of the thesis' equation that a round is.
const STEP: f64 = 0.5;
/// Cells along a side of the thesis' grids.
const THESIS_CELLS: f64 = 256.0;
/// Sweeps of smoothing.
const SWEEPS: usize = 6;
/// Smoothing weaker than this has no visible effect.
const FAINT: f64 = 1e-4;

/// Weights of the terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weights {
    pub(super) avalanche: f64,
    pub(super) flow: f64,
    pub(super) exponent: f64,
    pub(super) diffusion: f64,
    pub(super) advection: f64,
    pub(super) base: f64,
    pub(super) uplift: f64,
    pub(super) everywhere: bool,
}

/// Input of a round of erosion.
pub(super) struct Ground<'a> {
    pub(super) grid: &'a Grid,
    pub(super) domain: &'a RasterDomain,
    pub(super) z: &'a [f64],
    /// Depth of standing water.
    pub(super) standing: &'a [f64],
    /// Flow as a part of the map's water.
    pub(super) flow: &'a [f64],
    pub(super) banks: &'a [Bank],
    pub(super) river: River,
    pub(super) softness: &'a Resolved,
    /// Lowest elevation that pits are cut to, m.
    pub(super) bottom: f64,
    /// Slope with which the ground beyond the open border falls to the bottom; none where base
    /// levels are held.
    pub(super) beyond: Option<f64>,
}

impl Ground<'_> {
    /// Whether a node is eroded.
    fn is_erodible(&self, i: usize) -> bool {
        let status = self.domain.status()[i];
        status == Status::Interior || status == Status::BaseLevel && self.beyond.is_some()
    }

    /// Slope of the ground beyond the border at a node of it.
    fn fall(&self, i: usize) -> f64 {
        match self.beyond {
            Some(b) if self.domain.status()[i] == Status::BaseLevel && self.z[i] > self.bottom => b,
            _ => 0.0,
        }
    }

    /// The lowest elevation beside a node.
    fn lowest(&self, i: usize) -> f64 {
        let beside = self.domain.neighbours(i).map(|l| self.z[l.to]).fold(f64::INFINITY, f64::min);
        match self.beyond {
            Some(b) if self.domain.status()[i] == Status::BaseLevel => {
                let across = self.grid.spacing[0].min(self.grid.spacing[1]);
                beside.min((self.z[i] - b * across).max(self.bottom))
            }
            _ => beside,
        }
    }
}

/// The unit of length, m.
pub(super) fn unit(grid: &Grid) -> f64 {
    let [w, h] = grid.extent();
    w.max(h).max(grid.spacing[0]) / THESIS_CELLS
}

/// Uplift in a round, m.
pub(super) fn uplift(grid: &Grid, weights: &Weights) -> f64 {
    STEP * weights.uplift * unit(grid)
}

/// A node once it is cut, before smoothing.
#[derive(Clone, Copy, Default)]
struct Cut {
    z: f64,
    /// f of the equation.
    power: f64,
    /// The lowest ground beside it.
    floor: f64,
}

/// The ground after a round.
pub(super) fn eroded_bed(g: &Ground, weights: &Weights) -> Vec<f64> {
    let u = unit(g.grid);
    let surface = parallel::map(g.z.len(), |i| g.z[i] + g.standing[i]);
    let power = |i: usize| {
        let f = weights.avalanche * g.banks[i].lateral_flow + weights.flow * g.flow[i];
        if f > 0.0 { math::pow(f, weights.exponent) } else { 0.0 }
    };
    let cut = parallel::map(g.z.len(), |i| {
        let (z, f) = (g.z[i], power(i));
        if !g.is_erodible(i) || f == 0.0 {
            return Cut { z, power: 0.0, floor: z };
        }
        let f = f * STEP * g.softness.at(i);
        let floor = g.lowest(i);
        // Standing water deepens the flow and so slows it; its shear stress on the ground grows
        // with the square of its speed.
        let still = g.standing[i];
        let flow_damping = if still > 0.0 {
            let d = g.river.depth(g.flow[i]);
            (d / (d + still)) * (d / (d + still))
        } else {
            1.0
        };
        let slope = if z > floor && weights.advection > 0.0 {
            let q = quadratic(g.grid, &surface, i);
            (q.p * q.p + q.q * q.q).sqrt()
        } else {
            0.0
        };
        let slope = slope.max(g.fall(i));
        let taken = f * flow_damping * u * (weights.advection * slope + weights.base);
        let new = if z > floor { (z - taken).max(floor) } else { (z - taken).max(g.bottom.min(z)) };
        Cut { z: new, power: f, floor }
    });
    let smoothing = if weights.everywhere { STEP } else { 1.0 };
    let kappa = weights.diffusion * smoothing * u * u;
    let strength = |i: usize| {
        let k = if weights.everywhere { kappa } else { kappa * cut[i].power };
        if g.is_erodible(i) { k } else { 0.0 }
    };
    let mut out = smooth(g, &cut, strength);
    parallel::update(&mut out, |i, new| {
        if !g.is_erodible(i) {
            *new = g.z[i];
            return;
        }
        // Nothing enters over a border that is cut.
        if !weights.everywhere || g.domain.status()[i] == Status::BaseLevel {
            *new = new.min(g.z[i]);
        }
        if g.z[i] > cut[i].floor {
            *new = new.max(cut[i].floor);
        }
    });
    out
}

/// Solves (1 + k Σ c) z' − k Σ c z'_j = z by Jacobi's sweeps, c = 1/dx² and 1/dy².
fn smooth(g: &Ground, cut: &[Cut], strength: impl Fn(usize) -> f64 + Sync) -> Vec<f64> {
    let [dx, dy] = g.grid.spacing;
    let (cx, cy) = (1.0 / (dx * dx), 1.0 / (dy * dy));
    let least = FAINT * dx.min(dy) * dx.min(dy);
    let (cols, rows) = (g.grid.shape.cols, g.grid.shape.rows);
    let status = g.domain.status();
    let is_whole = |i: usize| {
        let (row, col) = (i / cols, i % cols);
        let is_inside = row > 0 && row + 1 < rows && col > 0 && col + 1 < cols;
        is_inside && [i - 1, i + 1, i - cols, i + cols].iter().all(|&j| status[j] != Status::Masked)
    };
    // k / (1 + k Σ c) where all four neighbours are there; 0 for what is not smoothed, k < 0 for
    // what has fewer neighbours.
    let share = parallel::map(cut.len(), |i| match strength(i) {
        k if k < least => 0.0,
        k if is_whole(i) => k / (1.0 + 2.0 * k * (cx + cy)),
        k => -k,
    });
    let beside: Vec<usize> = (0..cut.len()).filter(|&i| share[i] < 0.0).collect();
    let z = parallel::map(cut.len(), |i| cut[i].z);
    let (mut now, mut next) = (z.clone(), z.clone());
    for _ in 0..SWEEPS {
        parallel::for_rows_mut(&mut next, cols, |row, out| {
            if row > 0 && row + 1 < rows && cols > 2 {
                smooth_row(row * cols, out, &share, &z, &now, [cx, cy]);
            }
        });
        for &i in &beside {
            let k = -share[i];
            let (mut weight, mut sum) = (1.0, 0.0);
            for link in g.domain.neighbours(i).filter(|l| l.slot % 2 == 0) {
                let c = k / (link.distance * link.distance);
                weight += c;
                sum += c * (now[link.to] - z[i]);
            }
            next[i] = z[i] + sum / weight;
        }
        std::mem::swap(&mut now, &mut next);
    }
    now
}

/// One sweep over a row that starts at node `first`: `out` from `now`. Without branches, so that it
/// runs on vectors.
fn smooth_row(first: usize, out: &mut [f64], share: &[f64], z: &[f64], now: &[f64], [cx, cy]: [f64; 2]) {
    let cols = out.len();
    let inner = |list| row_of(list, first + 1, cols - 2);
    let (share, z) = (inner(share), inner(z));
    let (up, down) = (row_of(now, first + 1 - cols, cols - 2), row_of(now, first + 1 + cols, cols - 2));
    let (left, right) = (row_of(now, first, cols - 2), row_of(now, first + 2, cols - 2));
    for (k, out) in out[1..cols - 1].iter_mut().enumerate() {
        // By differences, so that level ground stays level to the bit.
        let across = (left[k] - z[k]) + (right[k] - z[k]);
        let along = (up[k] - z[k]) + (down[k] - z[k]);
        let smooth = z[k] + share[k] * (cx * across + cy * along);
        // Beside nodata the sums are NaN.
        *out = if share[k] > 0.0 { smooth } else { z[k] };
    }
}

fn row_of(list: &[f64], first: usize, len: usize) -> &[f64] {
    &list[first..first + len]
}
