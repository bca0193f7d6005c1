//! Length of coast relative to that of a straight one, at each site of the coast.
//!
//! # Method
//! Global: sides of all sites over sides at the start. Local: sides of sites within the radius over
//! 2 R, the length of a straight coast there, or over the length of all coasts at the start if that
//! is less; so a radius beyond the domain gives the global model. Counted by sums along the rows,
//! two look-ups for each row of the disc; short coasts site by site. Contiguous: only sites of the
//! same shore, which are those that eight-neighbour steps along the coast join. (Pytel 2015 leaves
//! the unit of L in Eq. 4.2 open; with raw lengths his g would leave no force at all.) Sectors:
//! lengths by marching squares, summed over a grid of sectors, linear between their middles, over
//! the side of one.

use landform_core::grid::Shape;
use landform_core::parallel;

use super::params::{Perimeter, Search};

/// The coast in a round.
pub(super) struct Coast<'a> {
    /// Sites by index.
    pub(super) sites: &'a [usize],
    /// Sides of each that the sea reaches.
    pub(super) sides: &'a [u8],
    pub(super) shape: Shape,
    pub(super) land: &'a [bool],
    /// Whether columns and rows wrap.
    pub(super) wraps: [bool; 2],
}

/// A coast of fewer sites is counted site by site.
const SHORT: usize = 200;

/// L / L0 for every site of the coast that is wanted.
pub(super) fn ratios(perimeter: Perimeter, coast: &Coast, start: f64, spacing: [f64; 2], wanted: &[bool]) -> Vec<f64> {
    let cell = 0.5 * (spacing[0] + spacing[1]);
    match perimeter {
        Perimeter::Whole(_) => {
            let all: f64 = coast.sides.iter().map(|&s| f64::from(s)).sum();
            vec![all / start.max(1.0); coast.sites.len()]
        }
        Perimeter::Local { local, search } => {
            let radius = local.si() / cell;
            let reference = (2.0 * radius).min(start).max(1.0);
            let mut counts = vec![0u32; coast.sites.len()];
            for shore in shores(coast, search) {
                count(coast, &shore, radius, wanted, &mut counts);
            }
            counts.iter().map(|&n| f64::from(n) / reference).collect()
        }
        Perimeter::Sectors { sectors } => in_sectors(coast, sectors, start),
    }
}

/// Positions in the coast's list of the sites of each shore.
fn shores(coast: &Coast, search: Search) -> Vec<Vec<u32>> {
    let n = coast.sites.len();
    if search == Search::All {
        return vec![(0..n as u32).collect()];
    }
    let mut seen = vec![false; n];
    let mut shores = Vec::new();
    let position = |site: usize| coast.sites.binary_search(&site).ok();
    let Shape { rows, cols } = coast.shape;
    for first in 0..n {
        if std::mem::replace(&mut seen[first], true) {
            continue;
        }
        let mut shore = vec![first as u32];
        let mut next = 0;
        while let Some(&k) = shore.get(next) {
            next += 1;
            let cell = coast.shape.cell(coast.sites[k as usize]);
            for d in (0..9).filter(|&d| d != 4) {
                let at = |at: usize, by: usize, n: usize, wraps: bool| match (at + by).checked_sub(1) {
                    Some(to) if to < n => Some(to),
                    Some(_) => wraps.then_some(0),
                    None => wraps.then(|| n - 1),
                };
                let (Some(r), Some(c)) =
                    (at(cell.row, d / 3, rows, coast.wraps[1]), at(cell.col, d % 3, cols, coast.wraps[0]))
                else {
                    continue;
                };
                if let Some(j) = position(coast.shape.index(r, c))
                    && !std::mem::replace(&mut seen[j], true)
                {
                    shore.push(j as u32);
                }
            }
        }
        shore.sort_unstable();
        shores.push(shore);
    }
    shores
}

/// Sides of a shore within a radius (cells) of each of its sites.
fn count(coast: &Coast, shore: &[u32], radius: f64, wanted: &[bool], counts: &mut [u32]) {
    let asked: Vec<u32> = shore.iter().copied().filter(|&k| wanted[k as usize]).collect();
    let found = if shore.len() <= SHORT {
        one_by_one(coast, shore, &asked, radius)
    } else {
        by_rows(coast, shore, &asked, radius)
    };
    for (k, n) in asked.into_iter().zip(found) {
        counts[k as usize] = n;
    }
}

fn one_by_one(coast: &Coast, shore: &[u32], asked: &[u32], radius: f64) -> Vec<u32> {
    let Shape { rows, cols } = coast.shape;
    let apart = |a: usize, b: usize, n: usize, wraps: bool| {
        let d = a.abs_diff(b);
        if wraps { d.min(n - d) } else { d }
    };
    let near = |a: u32, b: u32| {
        let (a, b) = (coast.shape.cell(coast.sites[a as usize]), coast.shape.cell(coast.sites[b as usize]));
        let (c, r) = (apart(a.col, b.col, cols, coast.wraps[0]), apart(a.row, b.row, rows, coast.wraps[1]));
        ((c * c + r * r) as f64) <= radius * radius
    };
    let of = |k: u32| shore.iter().filter(|&&j| near(k, j)).map(|&j| u32::from(coast.sides[j as usize])).sum();
    asked.iter().map(|&k| of(k)).collect()
}

fn by_rows(coast: &Coast, shore: &[u32], asked: &[u32], radius: f64) -> Vec<u32> {
    let Shape { rows, cols } = coast.shape;
    // sums[r][c]: sides in the row west of column c.
    let width = cols + 1;
    let mut sums = vec![0u32; rows * width];
    for &k in shore {
        let cell = coast.shape.cell(coast.sites[k as usize]);
        sums[cell.row * width + cell.col + 1] = u32::from(coast.sides[k as usize]);
    }
    parallel::for_rows_mut(&mut sums, width, |_, row| {
        for c in 1..row.len() {
            row[c] += row[c - 1];
        }
    });
    let reach = (radius.min((rows + cols) as f64)).floor() as i64;
    let half: Vec<i64> =
        (0..=reach).map(|d| (radius * radius - (d * d) as f64).max(0.0).sqrt().floor() as i64).collect();
    let (most_rows, most_cols) = (rows as i64, cols as i64);
    let span = |row: usize, from: i64, to: i64| -> u32 {
        let line = &sums[row * width..(row + 1) * width];
        let upto = |c: i64| line[c.clamp(0, most_cols) as usize];
        if !coast.wraps[0] || (from >= 0 && to < most_cols) {
            return upto(to + 1) - upto(from);
        }
        if to - from + 1 >= most_cols {
            return line[cols];
        }
        // Around the seam.
        let (a, b) = (from.rem_euclid(most_cols), to.rem_euclid(most_cols));
        if a <= b { upto(b + 1) - upto(a) } else { line[cols] - upto(a) + upto(b + 1) }
    };
    parallel::map(asked.len(), |k| {
        let cell = coast.shape.cell(coast.sites[asked[k] as usize]);
        let (r0, c0) = (cell.row as i64, cell.col as i64);
        let mut total = 0;
        let (first, last) = if coast.wraps[1] {
            // Each row once, however large the disc.
            let reach = reach.min((most_rows - 1) / 2);
            (-reach, reach + i64::from(most_rows % 2 == 0 && half.len() as i64 > most_rows / 2))
        } else {
            ((-reach).max(-r0), reach.min(most_rows - 1 - r0))
        };
        for d in first..=last {
            let row = (r0 + d).rem_euclid(most_rows) as usize;
            let h = half[d.unsigned_abs() as usize];
            total += span(row, c0 - h, c0 + h);
        }
        total
    })
}

/// Marching squares in sectors.
fn in_sectors(coast: &Coast, power: u32, start: f64) -> Vec<f64> {
    let Shape { rows, cols } = coast.shape;
    let n = 1usize << power;
    let mut lengths = vec![0.0; n * n];
    let along = |at: usize, of: usize| (at as f64 + 0.5) / of as f64 * n as f64;
    for &site in coast.sites {
        let cell = coast.shape.cell(site);
        let (r, c) = (along(cell.row, rows) as usize, along(cell.col, cols) as usize);
        lengths[r.min(n - 1) * n + c.min(n - 1)] += marching_length(coast, site);
    }
    let side = (cols + rows) as f64 / (2 * n) as f64;
    let reference = side.min(start).max(1.0);
    let at = |r: usize, c: usize| lengths[r * n + c];
    let of = |k: usize| {
        let cell = coast.shape.cell(coast.sites[k]);
        // Linear between the middles of sectors, level beyond the outermost.
        let place = |at: usize, of: usize| {
            let u = (along(at, of) - 0.5).clamp(0.0, (n - 1) as f64);
            let low = (u as usize).min(n.saturating_sub(2));
            (low, (low + 1).min(n - 1), u - low as f64)
        };
        let ((r0, r1, v), (c0, c1, u)) = (place(cell.row, rows), place(cell.col, cols));
        let row = |r: usize| at(r, c0) + (at(r, c1) - at(r, c0)) * u;
        (row(r0) + (row(r1) - row(r0)) * v) / if power == 0 { start.max(1.0) } else { reference }
    };
    (0..coast.sites.len()).map(of).collect()
}

/// Length of the line that marching squares draw around a site, in cells: that of each of the four
/// squares of 2 x 2 sites around it, shared among the sites of the square that are land. Both
/// squares with land on a diagonal are cut alike, into two short lines.
pub(super) fn marching_length(coast: &Coast, site: usize) -> f64 {
    let Shape { rows, cols } = coast.shape;
    let cell = coast.shape.cell(site);
    let is_land = |r: i64, c: i64| {
        let wrap = |at: i64, n: usize, wraps: bool| match (0..n as i64).contains(&at) {
            true => Some(at as usize),
            false => wraps.then(|| at.rem_euclid(n as i64) as usize),
        };
        match (wrap(r, rows, coast.wraps[1]), wrap(c, cols, coast.wraps[0])) {
            (Some(r), Some(c)) => coast.land[coast.shape.index(r, c)],
            _ => false,
        }
    };
    let (r, c) = (cell.row as i64, cell.col as i64);
    let short = std::f64::consts::FRAC_1_SQRT_2;
    [(-1, -1), (-1, 0), (0, -1), (0, 0)]
        .into_iter()
        .map(|(dr, dc)| {
            let square = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(a, b)| is_land(r + dr + a, c + dc + b));
            match square.iter().filter(|l| **l).count() {
                1 => short,
                2 if square[0] == square[3] => 2.0 * short / 2.0,
                2 => 0.5,
                3 => short / 3.0,
                _ => 0.0,
            }
        })
        .sum()
}

/// Both ways of counting, for a test that they agree.
#[cfg(test)]
pub(super) fn both_counts(coast: &Coast, shore: &[u32], radius: f64) -> (Vec<u32>, Vec<u32>) {
    (one_by_one(coast, shore, shore, radius), by_rows(coast, shore, shore, radius))
}
