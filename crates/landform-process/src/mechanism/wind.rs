//! Wind over a raster: lines swept downwind.
//!
//! # Method
//! Rows (or columns, whichever the wind crosses more squarely) are visited in the order in which
//! the wind reaches them. A node takes the value of the point upwind of it on the line before,
//! linear between the two nodes beside that point. On a torus the sweep starts as many lines before
//! the seam as a shadow reaches.

use landform_core::grid::Shape;
use landform_core::parallel;

/// The order in which a wind crosses a raster.
#[derive(Clone, Copy, Debug)]
pub struct WindScan {
    shape: Shape,
    torus: bool,
    /// Whether lines are columns (else rows).
    by_cols: bool,
    /// Whether lines are visited from the last to the first.
    backwards: bool,
    /// How far the wind drifts along a line while it crosses from one to the next, nodes, -1 to 1
    /// for square cells.
    drift: f64,
    /// Distance that the wind travels from line to line, m.
    pub line_spacing: f64,
}

impl WindScan {
    /// The sweep of a wind that blows along `towards` (x east, y north).
    pub fn new(shape: Shape, spacing: [f64; 2], torus: bool, towards: [f64; 2]) -> Self {
        let [c, r] = [towards[0] / spacing[0], -towards[1] / spacing[1]];
        let by_cols = c.abs() >= r.abs();
        let (major, minor) = if by_cols { (c, r) } else { (r, c) };
        Self {
            shape,
            torus,
            by_cols,
            backwards: major < 0.0,
            drift: minor / major.abs(),
            line_spacing: 1.0 / major.abs(),
        }
    }

    /// Number of lines and nodes of each.
    pub fn scan_lines(&self) -> (usize, usize) {
        let Shape { rows, cols } = self.shape;
        if self.by_cols { (cols, rows) } else { (rows, cols) }
    }

    /// The node at a place of a line; lines count downwind.
    #[inline]
    pub fn node(&self, line: usize, at: usize) -> usize {
        let line = if self.backwards { self.scan_lines().0 - 1 - line } else { line };
        if self.by_cols { self.shape.index(at, line) } else { self.shape.index(line, at) }
    }

    /// How far the wind drifts along a line on its way to the next, nodes.
    pub fn lateral_offset(&self) -> f64 {
        self.drift
    }

    /// Height of the air that the ground upwind shelters, for every node: the highest of upwind
    /// ground less `drop` for every line that the wind has crossed since, and no lower than the
    /// ground itself. A node lies in shadow where this is above its ground. NaN ground casts no
    /// shadow. **Cost** O(n), a few ns a node.
    pub fn shelter(&self, height: impl Fn(usize) -> f32 + Sync, drop: f32, scratch: &mut Vec<f32>, out: &mut [f32]) {
        let (lines, length) = self.scan_lines();
        // Heights with lines one after the other, so that sweeping reads memory as it lies.
        scratch.resize(lines * length, 0.0);
        self.gather(&height, scratch);
        let (low, high) = scratch.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), &h| (a.min(h), b.max(h)));
        let reach = if high > low { (((high - low) / drop) as usize).saturating_add(2) } else { 1 };
        let mut before = vec![f32::NEG_INFINITY; length];
        let mut here = before.clone();
        // On a torus the wind comes from the last lines: from as far as any shadow reaches.
        let lead = if self.torus { reach.min(lines) } else { 0 };
        for k in 0..lead + lines {
            let line = if k < lead { lines - lead + k } else { k - lead };
            let heights = &mut scratch[line * length..(line + 1) * length];
            self.cast(&before, heights, drop, &mut here);
            if k >= lead {
                heights.copy_from_slice(&here);
            }
            std::mem::swap(&mut before, &mut here);
        }
        self.scatter(scratch, out);
    }

    /// Shelter on a line from that on the line before.
    fn cast(&self, before: &[f32], heights: &[f32], drop: f32, here: &mut [f32]) {
        if self.drift == 0.0 {
            for ((here, &h), &b) in here.iter_mut().zip(heights).zip(before) {
                *here = h.max(b - drop);
            }
            return;
        }
        let n = before.len() as i64;
        let shift = (-self.drift).floor();
        let (part, shift) = ((-self.drift - shift) as f32, shift as i64);
        let bring = |at: i64| match (0..n).contains(&at) {
            true => before[at as usize],
            false if self.torus => before[at.rem_euclid(n) as usize],
            false => f32::NEG_INFINITY,
        };
        for (at, (here, &h)) in here.iter_mut().zip(heights).enumerate() {
            let from = at as i64 + shift;
            let (a, b) = (bring(from), bring(from + 1));
            let shadow = if part == 0.0 || a == f32::NEG_INFINITY { a } else { a + (b - a) * part };
            *here = h.max(shadow - drop);
        }
    }

    fn gather(&self, height: &(impl Fn(usize) -> f32 + Sync), into: &mut [f32]) {
        let length = self.scan_lines().1;
        if !self.by_cols {
            parallel::for_rows_mut(into, length, |line, row| {
                row.iter_mut().enumerate().for_each(|(at, v)| *v = height(self.node(line, at)));
            });
            return;
        }
        // Bands of lines share the parts of rows that they read.
        parallel::for_rows_mut(into, length * BAND, |band, part| {
            for at in 0..length {
                for (k, line) in part.chunks_mut(length).enumerate() {
                    line[at] = height(self.node(band * BAND + k, at));
                }
            }
        });
    }

    fn scatter(&self, from: &[f32], out: &mut [f32]) {
        let (lines, length) = self.scan_lines();
        let cols = self.shape.cols;
        parallel::for_rows_mut(out, cols * BAND, |band, part| {
            for (k, row) in part.chunks_mut(cols).enumerate() {
                let r = band * BAND + k;
                for (c, v) in row.iter_mut().enumerate() {
                    let (line, at) = if self.by_cols { (c, r) } else { (r, c) };
                    let line = if self.backwards { lines - 1 - line } else { line };
                    *v = from[line * length + at];
                }
            }
        });
    }
}

/// Lines that are turned together, so that a line of memory serves them all.
const BAND: usize = 16;

#[cfg(test)]
mod tests {
    use landform_core::algo::horizon::shadow;
    use landform_core::grid::Grid;
    use landform_core::math;
    use landform_core::random::Seed;

    use super::*;

    #[test]
    fn shelter_is_the_geometric_shadow() {
        let grid = Grid::new(Shape::new(30, 40), [2.0, 2.0]).unwrap();
        let z: Vec<f64> = (0..1200).map(|i| Seed(2).uniform(i) * 8.0).collect();
        let angle = math::atan(0.25);
        for (from, towards) in [(270.0, [1.0, 0.0]), (90.0, [-1.0, 0.0]), (0.0, [0.0, -1.0]), (180.0, [0.0, 1.0])] {
            let sweep = WindScan::new(grid.shape, grid.spacing, false, towards);
            let mut out = vec![0.0; 1200];
            sweep.shelter(|i| z[i] as f32, (0.25 * sweep.line_spacing) as f32, &mut Vec::new(), &mut out);
            let geometric = shadow(&grid, &z, f64::to_radians(from), angle);
            // A line of sight along the very border may leave the map by a rounding error.
            let inner = |i: &usize| (1..29).contains(&(i / 40)) && (1..39).contains(&(i % 40));
            let wrong = (0..1200).filter(inner).filter(|&i| (f64::from(out[i]) > z[i] + 1e-6) != geometric[i]).count();
            assert!(wrong < 4, "{from}: {wrong}");
        }
    }

    #[test]
    fn a_slanting_wind_drifts_by_its_angle() {
        let sweep = WindScan::new(Shape::new(50, 50), [1.0; 2], true, [math::cos(0.5), math::sin(0.5)]);
        assert!((sweep.lateral_offset() + math::tan(0.5)).abs() < 1e-12);
        assert!((sweep.line_spacing - 1.0 / math::cos(0.5)).abs() < 1e-12);
    }
}
