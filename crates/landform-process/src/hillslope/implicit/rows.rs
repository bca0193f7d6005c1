//! The implicit step on a raster: successive over-relaxation in two colours.
//!
//! # Method
//! The five-point stencil couples nodes of one colour of a chessboard to the other alone. Each
//! colour is stored by itself, so that a sweep reads one and writes the other, in rows, side by
//! side. The relaxation factor is Chebyshev's, from a bound of the spectral radius of Jacobi's
//! iteration: with D Δt of half a cell's area a sweep leaves a seventh of the error. The volumes
//! that move follow from the fluxes at the end, so that none is lost whatever the error.
//!
//! # Sources
//! Young (1954), Iterative methods for solving partial difference equations of elliptic type; Golub
//! & Varga (1961) for the factors.

use landform_core::grid::{Domain, Link, Shape, Status};
use landform_core::{Error, Result, parallel};

use super::TOLERANCE;
use super::links::Links;

/// Steps so long that they would need more are left to conjugate gradients.
const MOST_SWEEPS: usize = 20_000;
/// Rows that are swept together.
const BAND: usize = 16;
/// Rounding of a sweep; the nearer the factor is to 2 the longer it stays.
const ROUNDING: f64 = 2e-15;

/// A raster in two colours, with a rim of empty places around it.
#[derive(Clone, Debug)]
pub(in super::super) struct Rows {
    shape: Shape,
    /// Places of a colour in a row, rim included.
    width: usize,
    /// Conductance to the node in the east and in the south, m²/s; 0 where there is none.
    east: [Vec<f64>; 2],
    south: [Vec<f64>; 2],
    /// Conductance to all neighbours, m²/s; negative at nodes that do not change.
    sum: [Vec<f64>; 2],
    area: f64,
    /// The change, and what drives it.
    change: [Vec<f64>; 2],
    rhs: [Vec<f64>; 2],
    /// One over the diagonal; 0 at nodes that do not change.
    inverse: [Vec<f64>; 2],
}

impl Rows {
    /// The links of a raster, `conductance` (m²/s) of those to the east and south; those back are
    /// the same.
    pub(in super::super) fn new<D: Domain>(domain: &D, shape: Shape, conductance: impl Fn(usize, Link) -> f64) -> Self {
        let mut rows = Self::unlinked(shape, domain.area(0));
        let status = domain.status();
        for i in 0..domain.len() {
            let (colour, at) = rows.place(i);
            rows.sum[colour][at] = -1.0;
            if status[i] == Status::Masked {
                continue;
            }
            let mut sum = 0.0;
            for link in domain.neighbours(i) {
                let g = conductance(i, link);
                sum += g;
                match link.slot {
                    0 => rows.east[colour][at] = g,
                    6 => rows.south[colour][at] = g,
                    _ => {}
                }
            }
            if status[i] == Status::Interior {
                rows.sum[colour][at] = sum;
            }
        }
        rows
    }

    /// A raster of cells of an area (m²) without links.
    pub(in super::super) fn unlinked(shape: Shape, area: f64) -> Self {
        let width = shape.cols.div_ceil(2) + 2;
        let empty = || [0, 1].map(|_| vec![0.0; width * (shape.rows + 2)]);
        let [east, south, sum, change, rhs, inverse] = std::array::from_fn(|_| empty());
        Self { shape, width, east, south, sum, area, change, rhs, inverse }
    }

    /// Links anew: `conductance` (m²/s) of a node's links to the east and to the south, 0 where
    /// there is none.
    pub(in super::super) fn link(&mut self, status: &[Status], conductance: impl Fn(usize) -> [f64; 2] + Sync) {
        let (shape, width) = (self.shape, self.width);
        let each = |colour: usize, out: &mut [f64], value: &(dyn Fn(usize, usize) -> f64 + Sync)| {
            parallel::for_rows_mut(out, width, |row, out| {
                if row == 0 || row > shape.rows {
                    return;
                }
                let first = (row - 1 + colour) & 1;
                for (k, col) in (first..shape.cols).step_by(2).enumerate() {
                    out[k + 1] = value((row - 1) * shape.cols + col, col);
                }
            });
        };
        for colour in 0..2 {
            each(colour, &mut self.east[colour], &|i, _| conductance(i)[0]);
            each(colour, &mut self.south[colour], &|i, _| conductance(i)[1]);
            each(colour, &mut self.sum[colour], &|i, col| {
                if status[i] != Status::Interior {
                    return -1.0;
                }
                let [east, south] = conductance(i);
                let west = if col > 0 { conductance(i - 1)[0] } else { 0.0 };
                let north = if i >= shape.cols { conductance(i - shape.cols)[1] } else { 0.0 };
                (east + west) + (south + north)
            });
        }
    }

    /// Colour of a node, and its place there.
    #[inline]
    fn place(&self, node: usize) -> (usize, usize) {
        let cell = self.shape.cell(node);
        ((cell.row + cell.col) & 1, (cell.row + 1) * self.width + 1 + cell.col / 2)
    }

    fn pack(&self, values: &[f64]) -> [Vec<f64>; 2] {
        let mut packed = [0, 1].map(|_| vec![0.0; self.width * (self.shape.rows + 2)]);
        let cols = self.shape.cols;
        for (colour, packed) in packed.iter_mut().enumerate() {
            parallel::for_rows_mut(packed, self.width, |row, out| {
                if row == 0 || row > self.shape.rows {
                    return;
                }
                let values = &values[(row - 1) * cols..row * cols];
                let first = (row - 1 + colour) & 1;
                for (k, out) in out[1..].iter_mut().enumerate() {
                    *out = values.get(2 * k + first).copied().filter(|v| !v.is_nan()).unwrap_or(0.0);
                }
            });
        }
        packed
    }

    /// The change of heights `z` in a backward-Euler step of `dt` s by the fluxes at its end, and
    /// as it was solved for.
    pub(super) fn change(&mut self, z: &[f64], dt: f64) -> Result<[Vec<f64>; 2]> {
        let packed = self.pack(z);
        for colour in 0..2 {
            let mut rhs = std::mem::take(&mut self.rhs[colour]);
            self.flux_into(colour, &packed, &mut rhs);
            self.rhs[colour] = rhs;
        }
        self.solve_step(dt, TOLERANCE)?;
        let after = [0, 1].map(|c: usize| {
            let (a, b) = (&packed[c], &self.change[c]);
            parallel::map(a.len(), |i| a[i] + b[i])
        });
        let mut moved = [0, 1].map(|c: usize| vec![0.0; self.change[c].len()]);
        (0..2).for_each(|c| self.flux_into(c, &after, &mut moved[c]));
        Ok([self.unpack(&moved, 1.0 / (self.area / dt)), self.unpack(&self.change, 1.0)])
    }

    /// The change of every node in `dt` s that a volume flux into it (m³/s) calls for, what then
    /// flows over links included, to a `tolerance` over the greatest change.
    pub(in super::super) fn change_by(&mut self, rhs: &[f64], dt: f64, tolerance: f64) -> Result<Vec<f64>> {
        self.rhs = self.pack(rhs);
        self.solve_step(dt, tolerance)?;
        Ok(self.unpack(&self.change, 1.0))
    }

    /// The same links, row by row.
    pub(super) fn links(&self) -> Links {
        let (n, cols) = (self.shape.len(), self.shape.cols);
        let of = |values: &[Vec<f64>; 2], node: usize| {
            let (colour, at) = self.place(node);
            values[colour][at]
        };
        let links = |i: usize| {
            let cell = self.shape.cell(i);
            let west = if cell.col > 0 { of(&self.east, i - 1) } else { 0.0 };
            let north = if cell.row > 0 { of(&self.south, i - cols) } else { 0.0 };
            let all = [(i + 1, of(&self.east, i)), (i.wrapping_sub(cols), north), (i.wrapping_sub(1), west)];
            all.into_iter().chain([(i + cols, of(&self.south, i))]).filter(|l| l.1 > 0.0).map(|(to, g)| (to as u32, g))
        };
        Links::of(links, vec![self.area; n], |i| of(&self.sum, i) >= 0.0)
    }

    fn unpack(&self, values: &[Vec<f64>; 2], factor: f64) -> Vec<f64> {
        parallel::map(self.shape.len(), |i| {
            let (colour, at) = self.place(i);
            factor * values[colour][at]
        })
    }

    /// Finds the change for what drives it.
    fn solve_step(&mut self, dt: f64, tolerance: f64) -> Result<()> {
        let diagonal = self.area / dt;
        let (mut radius, mut greatest_rhs) = (0.0_f64, 0.0_f64);
        for colour in 0..2 {
            self.change[colour].fill(0.0);
            let (sum, rhs) = (&self.sum[colour], &self.rhs[colour]);
            parallel::fill(&mut self.inverse[colour], |i| if sum[i] >= 0.0 { 1.0 / (diagonal + sum[i]) } else { 0.0 });
            radius = radius.max(parallel::max(sum.len(), |i| sum[i].max(0.0) / (diagonal + sum[i].max(0.0))));
            greatest_rhs = greatest_rhs.max(parallel::max(rhs.len(), |i| rhs[i].abs()));
        }
        if greatest_rhs > 0.0 { self.solve(radius * radius, tolerance) } else { Ok(()) }
    }

    /// Volume flux into every node of a colour that changes, m³/s.
    fn flux_into(&self, colour: usize, z: &[Vec<f64>; 2], out: &mut [f64]) {
        let width = self.width;
        parallel::for_rows_mut(out, width, |row, out| {
            if row == 0 || row > self.shape.rows {
                return;
            }
            let around = self.around(colour, row, &z[1 - colour]);
            let (own, sum) = (&z[colour][row * width + 1..], &self.sum[colour][row * width + 1..]);
            for k in 0..width - 2 {
                let sums = around.weighted(k);
                out[k + 1] = if sum[k] > 0.0 { sums - sum[k] * own[k] } else { 0.0 };
            }
        });
    }

    /// Links of a row of a colour to the values of the other.
    fn around<'a>(&'a self, colour: usize, row: usize, other: &'a [f64]) -> Around<'a> {
        let (width, n) = (self.width, self.width - 2);
        let start = row * width + 1;
        // Whether the other colour of this place lies in the west.
        let shift = (row - 1 + colour) & 1;
        let (east, west) = (start + shift, start + shift - 1);
        let part = |values: &'a [f64], from: usize| &values[from..from + n];
        let (own, rest) = (colour, 1 - colour);
        Around {
            links: [
                part(&self.east[own], start),
                part(&self.east[rest], west),
                part(&self.south[own], start),
                part(&self.south[rest], start - width),
            ],
            values: [part(other, east), part(other, west), part(other, start + width), part(other, start - width)],
        }
    }

    fn solve(&mut self, radius: f64, tolerance: f64) -> Result<()> {
        let (mut factor, mut first) = (1.0, true);
        let last = 2.0 / (1.0 + (1.0 - radius).sqrt());
        let enough = (tolerance * (2.0 - last)).max(ROUNDING / (2.0 - last));
        for _ in 0..MOST_SWEEPS {
            let (mut step, mut greatest) = (0.0_f64, 0.0_f64);
            for colour in 0..2 {
                let [s, g] = self.sweep(colour, factor);
                (step, greatest) = (step.max(s), greatest.max(g));
                factor = if first { 1.0 / (1.0 - 0.5 * radius) } else { 1.0 / (1.0 - 0.25 * radius * factor) };
                first = false;
            }
            if step <= enough * greatest {
                return Ok(());
            }
        }
        Err(Error::NotConverged { what: "linear diffusion".into(), iterations: MOST_SWEEPS, residual: f64::NAN })
    }

    /// Relaxes the nodes of a colour; returns the greatest step and the greatest change so far.
    fn sweep(&mut self, colour: usize, factor: f64) -> [f64; 2] {
        let width = self.width;
        let mut own = std::mem::take(&mut self.change[colour]);
        let (other, rhs, inverse) = (&self.change[1 - colour], &self.rhs[colour], &self.inverse[colour]);
        let found = parallel::map_pieces_mut([&mut own], width * BAND, |first, [band]| {
            let mut most = [0.0_f64; 2];
            for (k, row) in band.chunks_mut(width).enumerate() {
                let at = first / width + k;
                if at == 0 || at > self.shape.rows {
                    continue;
                }
                let start = at * width + 1;
                let around = self.around(colour, at, other);
                let (rhs, inverse) = (&rhs[start..start + width - 2], &inverse[start..start + width - 2]);
                let [step, greatest] = relax(&mut row[1..width - 1], &around, rhs, inverse, factor);
                most = [most[0].max(step), most[1].max(greatest)];
            }
            most
        });
        self.change[colour] = own;
        found.into_iter().fold([0.0; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])])
    }
}

/// Links to the east, west, south and north, and the values there.
struct Around<'a> {
    links: [&'a [f64]; 4],
    values: [&'a [f64]; 4],
}

impl Around<'_> {
    #[inline]
    fn weighted(&self, k: usize) -> f64 {
        let [e, w, s, n] = self.links;
        let [ve, vw, vs, vn] = self.values;
        (e[k] * ve[k] + w[k] * vw[k]) + (s[k] * vs[k] + n[k] * vn[k])
    }
}

fn relax(own: &mut [f64], around: &Around, rhs: &[f64], inverse: &[f64], factor: f64) -> [f64; 2] {
    let n = own.len();
    let [e, w, s, no] = around.links.map(|v| &v[..n]);
    let [ve, vw, vs, vn] = around.values.map(|v| &v[..n]);
    let (rhs, inverse) = (&rhs[..n], &inverse[..n]);
    let (mut step, mut greatest) = ([0.0_f64; 4], [0.0_f64; 4]);
    for k in 0..n {
        let sums = (e[k] * ve[k] + w[k] * vw[k]) + (s[k] * vs[k] + no[k] * vn[k]);
        let by = factor * ((sums + rhs[k]) * inverse[k] - own[k]);
        own[k] += by;
        // Four at a time; the greatest does not depend on the order.
        step[k & 3] = if by.abs() > step[k & 3] { by.abs() } else { step[k & 3] };
        greatest[k & 3] = if own[k].abs() > greatest[k & 3] { own[k].abs() } else { greatest[k & 3] };
    }
    [step, greatest].map(|v| v.into_iter().fold(0.0, f64::max))
}
