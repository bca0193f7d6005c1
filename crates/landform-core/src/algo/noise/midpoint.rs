//! Random midpoint displacement: diamond-square, and 4-8 subdivision.
//!
//! # Method
//! A lattice of coarse heights is refined in half-steps. Each puts a new node into the middle of
//! every square of the lattice, which is straight and turned by 45 degrees in turn, and moves it by
//! a Gaussian offset whose variance falls by 2^−H from one half-step to the next.
//!
//! *Diamond-square* takes the mean of a square's corners and never moves a node again: peaks stay
//! sharp and bumps recur at the coarse nodes. *4-8 subdivision* takes the same mean for the new
//! node and moves the old ones to ½ of themselves and ⅛ of each of their four neighbours, so that
//! the surface without offsets is smooth (C⁴). The rim is refined as a cubic spline: midpoints,
//! then ¾ and ⅛ and ⅛. Nodes of the coarse lattice may be held.
//!
//! Neither gives the Hurst exponent with which its offsets fall: nodes that are never moved again,
//! and masks that smooth, change the spectrum. Offsets fall by an exponent that was found so that
//! spectra have the one asked for ([`Subdivision::decay`]).
//!
//! # Sources
//! Fournier, Fussell & Carpenter (1982); Miller (1986) for the artefacts; Velho & Zorin (2001);
//! masks from validation notes 2.16; Pytel's thesis 2.1.5.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::grid::Shape;
use crate::random::Seed;
use crate::{math, parallel};

/// How a lattice is refined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Subdivision {
    /// Means that stay where they are: sharp peaks, creases along the lattice.
    DiamondSquare,
    /// Velho and Zorin's smooth refinement.
    #[default]
    FourEight,
}

impl Subdivision {
    /// The H of 2^−H by which offsets fall so that the surface has this Hurst exponent. Fitted to
    /// the spectra of surfaces of 513² nodes between H = 0.5 and 0.9.
    fn decay(self, hurst: f64) -> f64 {
        match self {
            Self::DiamondSquare => 0.070 + 1.013 * hurst,
            Self::FourEight => 0.105 + 1.067 * hurst,
        }
    }
}

/// A refinement.
#[derive(Clone, Debug, PartialEq)]
pub struct Midpoint {
    /// How the lattice is refined.
    pub subdivision: Subdivision,
    /// Coarse heights, row-major from the north-west, m.
    pub coarse: Vec<f64>,
    /// Their shape, at least 2 × 2.
    pub shape: Shape,
    /// Steps; each halves the distance between nodes.
    pub levels: u32,
    /// Standard deviation of the first offsets, m.
    pub offset: f64,
    /// Hurst exponent of the surface: its spectrum falls as k^−(2H + 2).
    pub hurst: f64,
    /// Whether the coarse nodes stay where they are.
    pub hold: bool,
}

impl Midpoint {
    /// Shape of the result: each coarse cell becomes 2^levels cells.
    pub fn fine_shape(&self) -> Shape {
        let fine = |n: usize| ((n - 1) << self.levels) + 1;
        Shape::new(fine(self.shape.rows), fine(self.shape.cols))
    }

    /// The surface, m. **Cost** O(n) in time and memory.
    pub fn surface(&self, seed: Seed) -> Vec<f64> {
        let shape = self.fine_shape();
        let mut z = vec![0.0; shape.len()];
        let coarse_step = 1usize << self.levels;
        let decay = self.subdivision.decay(self.hurst);
        for (k, &h) in self.coarse.iter().enumerate() {
            let cell = self.shape.cell(k);
            z[shape.index(cell.row * coarse_step, cell.col * coarse_step)] = h;
        }
        for level in 0..self.levels {
            let step = coarse_step >> level;
            let offset = |half: u32| {
                let deviation = self.offset * math::pow(2.0, -0.5 * decay * f64::from(2 * level + half));
                (deviation, seed.with(u64::from(2 * level + half)))
            };
            let lattice = Lattice { shape, step, hold: self.hold.then_some(coarse_step) };
            let smooth = self.subdivision == Subdivision::FourEight;
            if smooth {
                lattice.smooth_straight(&mut z);
            }
            lattice.fill_centres(&mut z, offset(0), smooth);
            if smooth {
                lattice.smooth_turned(&mut z);
            }
            lattice.fill_edges(&mut z, offset(1), smooth);
        }
        z
    }
}

/// Nodes at multiples of `step` of a fine raster.
struct Lattice {
    shape: Shape,
    step: usize,
    /// Nodes at multiples of this are never moved.
    hold: Option<usize>,
}

impl Lattice {
    fn held(&self, r: usize, c: usize) -> bool {
        self.hold.is_some_and(|h| r.is_multiple_of(h) && c.is_multiple_of(h))
    }

    fn on_rim(&self, r: usize, c: usize) -> bool {
        r == 0 || c == 0 || r + 1 == self.shape.rows || c + 1 == self.shape.cols
    }

    fn at(&self, z: &[f64], r: usize, c: usize) -> f64 {
        z[self.shape.index(r, c)]
    }

    /// New values of the rows that hold nodes, computed from the old ones; `f` gives none where a
    /// node stays.
    fn renew(&self, z: &mut [f64], first: usize, by: usize, f: impl Fn(&[f64], usize, usize) -> Option<f64> + Sync) {
        let (rows, cols, half) = (self.shape.rows, self.shape.cols, self.step / 2);
        let of_row = |k: usize| first + k * by;
        let count = (rows + by - 1).saturating_sub(first) / by;
        let old = &*z;
        let new: Vec<Vec<(usize, f64)>> = parallel::map(count, |k| {
            let r = of_row(k);
            (0..cols).step_by(half.max(1)).filter_map(|c| f(old, r, c).map(|v| (c, v))).collect()
        });
        for (k, row) in new.into_iter().enumerate() {
            for (c, v) in row {
                z[self.shape.index(of_row(k), c)] = v;
            }
        }
    }

    /// Old nodes of the straight lattice: ½ and four times ⅛ of the neighbours along the axes. The
    /// new nodes still to come are means of the corners as they were, so centres must be made from
    /// what this replaces: they are put in first.
    fn smooth_straight(&self, z: &mut [f64]) {
        let s = self.step;
        // Centres first, from the corners before they move.
        self.centres(z, |mean, _, _| mean);
        self.renew(z, 0, s, |z, r, c| {
            let moves = c % s == 0 && !self.on_rim(r, c) && !self.held(r, c);
            moves.then(|| {
                let sum = self.at(z, r - s, c) + self.at(z, r + s, c) + self.at(z, r, c - s) + self.at(z, r, c + s);
                0.5 * self.at(z, r, c) + 0.125 * sum
            })
        });
    }

    fn centres(&self, z: &mut [f64], f: impl Fn(f64, usize, usize) -> f64 + Sync) {
        let (s, h) = (self.step, self.step / 2);
        self.renew(z, h, s, |z, r, c| {
            (c % s == h).then(|| {
                let sum = self.at(z, r - h, c - h)
                    + self.at(z, r - h, c + h)
                    + self.at(z, r + h, c - h)
                    + self.at(z, r + h, c + h);
                f(0.25 * sum, r, c)
            })
        });
    }

    /// Nodes in the middles of squares, moved by their offsets.
    fn fill_centres(&self, z: &mut [f64], offset: (f64, Seed), made: bool) {
        let (s, h) = (self.step, self.step / 2);
        if !made {
            return self.centres(z, |mean, r, c| mean + self.offset(offset, r, c));
        }
        self.renew(z, h, s, |z, r, c| (c % s == h).then(|| self.at(z, r, c) + self.offset(offset, r, c)));
    }

    fn offset(&self, (deviation, seed): (f64, Seed), r: usize, c: usize) -> f64 {
        if deviation == 0.0 {
            return 0.0;
        }
        // Keyed by place on the lattice of half-steps, so that more levels add detail and move
        // nothing.
        let h = self.step / 2;
        deviation * seed.normal_pair(((r / h) as u64) << 32 | (c / h) as u64).0
    }

    /// Old nodes of the turned lattice (the straight one's and the centres): ½ and four times ⅛ of
    /// the diagonal neighbours; the rim as a spline.
    fn smooth_turned(&self, z: &mut [f64]) {
        let (s, h) = (self.step, self.step / 2);
        self.edges(z, |mean, _, _| mean);
        self.renew(z, 0, h, |z, r, c| {
            let (on_lattice, centre) = (r % s == 0 && c % s == 0, r % s == h && c % s == h);
            if !(on_lattice || centre) || self.held(r, c) {
                return None;
            }
            let (top, side) = (r == 0 || r + 1 == self.shape.rows, c == 0 || c + 1 == self.shape.cols);
            let rim = |a: f64, b: f64| 0.75 * self.at(z, r, c) + 0.125 * (a + b);
            match (top, side) {
                (true, true) => None,
                (true, false) => Some(rim(self.at(z, r, c - s), self.at(z, r, c + s))),
                (false, true) => Some(rim(self.at(z, r - s, c), self.at(z, r + s, c))),
                (false, false) => {
                    let sum = self.at(z, r - h, c - h)
                        + self.at(z, r - h, c + h)
                        + self.at(z, r + h, c - h)
                        + self.at(z, r + h, c + h);
                    Some(0.5 * self.at(z, r, c) + 0.125 * sum)
                }
            }
        });
    }

    /// Nodes in the middles of the turned squares: the edges of the straight lattice. On the rim a
    /// turned square lacks a corner.
    fn edges(&self, z: &mut [f64], f: impl Fn(f64, usize, usize) -> f64 + Sync) {
        let (s, h) = (self.step, self.step / 2);
        self.renew(z, 0, h, |z, r, c| {
            let upright = r % s == h && c % s == 0;
            let level = r % s == 0 && c % s == h;
            if !(upright || level) {
                return None;
            }
            let up = (r >= h).then(|| self.at(z, r.saturating_sub(h), c));
            let down = (r + h < self.shape.rows).then(|| self.at(z, (r + h).min(self.shape.rows - 1), c));
            let west = (c >= h).then(|| self.at(z, r, c.saturating_sub(h)));
            let east = (c + h < self.shape.cols).then(|| self.at(z, r, (c + h).min(self.shape.cols - 1)));
            let mean = match (up, down, west, east) {
                (Some(a), Some(b), Some(c), Some(d)) => 0.25 * (a + b + c + d),
                (Some(a), Some(b), ..) => 0.5 * (a + b),
                (_, _, Some(c), Some(d)) => 0.5 * (c + d),
                _ => return None,
            };
            Some(f(mean, r, c))
        });
    }

    fn fill_edges(&self, z: &mut [f64], offset: (f64, Seed), made: bool) {
        let (s, h) = (self.step, self.step / 2);
        if !made {
            return self.edges(z, |mean, r, c| mean + self.offset(offset, r, c));
        }
        self.renew(z, 0, h, |z, r, c| {
            let is_edge = (r % s == h && c % s == 0) || (r % s == 0 && c % s == h);
            is_edge.then(|| self.at(z, r, c) + self.offset(offset, r, c))
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refine(subdivision: Subdivision, coarse: &[f64], n: usize, levels: u32, hold: bool) -> (Shape, Vec<f64>) {
        let shape = Shape::new(n, n);
        let m = Midpoint { subdivision, coarse: coarse.to_vec(), shape, levels, offset: 0.0, hurst: 0.8, hold };
        (m.fine_shape(), m.surface(Seed(1)))
    }

    #[test]
    fn planes_stay_planes() {
        let plane: Vec<f64> = (0..25).map(|i| 3.0 * f64::from(i % 5) - 2.0 * f64::from(i / 5) + 1.0).collect();
        for subdivision in [Subdivision::DiamondSquare, Subdivision::FourEight] {
            let (shape, z) = refine(subdivision, &plane, 5, 3, false);
            for i in 0..z.len() {
                let cell = shape.cell(i);
                let expected = 3.0 * cell.col as f64 / 8.0 - 2.0 * cell.row as f64 / 8.0 + 1.0;
                assert!((z[i] - expected).abs() < 1e-12, "{subdivision:?} {cell:?}");
            }
        }
    }

    #[test]
    fn an_impulse_looks_alike_from_eight_sides_and_is_smooth() {
        let mut coarse = vec![0.0; 81];
        coarse[40] = 1.0;
        let (shape, z) = refine(Subdivision::FourEight, &coarse, 9, 4, false);
        let n = shape.rows;
        for i in 0..z.len() {
            let (r, c) = (i / n, i % n);
            assert!((z[i] - z[c * n + r]).abs() < 1e-14 && (z[i] - z[r * n + n - 1 - c]).abs() < 1e-14);
        }
        // Fourth differences fall with the fourth power of the spacing where a surface is C⁴; a
        // peak's do not.
        let sharpest = |z: &[f64], step: usize| {
            let row = &z[(n / 2) * n..(n / 2 + 1) * n];
            (2 * step..n - 2 * step)
                .map(|c| {
                    (row[c - 2 * step] - 4.0 * row[c - step] + 6.0 * row[c] - 4.0 * row[c + step] + row[c + 2 * step])
                        .abs()
                })
                .fold(0.0, f64::max)
        };
        assert!(sharpest(&z, 1) < 0.12 * sharpest(&z, 2), "{} {}", sharpest(&z, 1), sharpest(&z, 2));
        let (_, peak) = refine(Subdivision::DiamondSquare, &coarse, 9, 4, false);
        assert!(sharpest(&peak, 1) > 0.4 * sharpest(&peak, 2));
        let (_, held) = refine(Subdivision::FourEight, &coarse, 9, 4, true);
        assert_eq!((held[shape.len() / 2], peak[shape.len() / 2]), (1.0, 1.0));
        assert!(z[shape.len() / 2] < 0.7);
    }

    #[test]
    fn more_levels_add_detail_to_the_same_land() {
        let make = |levels| Midpoint {
            subdivision: Subdivision::DiamondSquare,
            coarse: vec![0.0; 9],
            shape: Shape::new(3, 3),
            levels,
            offset: 10.0,
            hurst: 0.8,
            hold: false,
        };
        let (coarse, fine) = (make(3), make(5));
        let (a, b) = (coarse.surface(Seed(2)), fine.surface(Seed(2)));
        let (sa, sb) = (coarse.fine_shape(), fine.fine_shape());
        assert!((0..a.len()).all(|i| a[i] == b[sb.index(sa.cell(i).row * 4, sa.cell(i).col * 4)]));
    }
}
