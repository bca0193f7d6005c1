//! Wind over a raster: lines swept downwind.
//!
//! # Method
//! Rows (or columns, whichever the wind crosses more squarely) are visited in the order in which
//! the wind reaches them. A node takes the value of the point upwind of it on the line before,
//! linear between the two nodes beside that point. On a torus the sweep starts as many lines before
//! the seam as a shadow reaches.

use std::ops::Range;

use landform_core::grid::Shape;

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
    /// shadow.
    ///
    /// `heights` gives those of a run of nodes from the first on, `found` takes the shelter of a
    /// run. `relief` is the highest less the lowest ground. **Cost** O(n), about a nanosecond a
    /// node.
    pub fn shelter(
        &self,
        heights: impl Fn(usize, &mut [f32]),
        relief: f32,
        drop: f32,
        mut found: impl FnMut(usize, &[f32]),
    ) {
        let (lines, length) = self.scan_lines();
        let reach = if relief > 0.0 { ((relief / drop) as usize).saturating_add(2) } else { 1 };
        // On a torus the wind comes from the last lines: from as far as any shadow reaches.
        let lead = if self.torus { reach.min(lines) } else { 0 };
        let mut air = Air::new(self, length);
        // Lines of a band do not lie a power of two apart, where caches would hold few of them.
        let stride = length + BAND;
        let mut band = vec![0.0; BAND * stride];
        for (all, is_told) in [(lines - lead..lines, false), (0..lines, true)] {
            for first in all.clone().step_by(BAND) {
                let last = (first + BAND).min(all.end);
                self.gather(first..last, &heights, &mut band, stride);
                for line in band.chunks_mut(stride).take(last - first) {
                    air.cross(&mut line[..length], drop);
                }
                if is_told {
                    self.scatter(first..last, &band, stride, &mut found);
                }
            }
        }
    }

    /// Heights of some lines, one after the other so that sweeping reads memory as it lies.
    fn gather(&self, band: Range<usize>, heights: &impl Fn(usize, &mut [f32]), into: &mut [f32], stride: usize) {
        let length = self.scan_lines().1;
        if !self.by_cols {
            for (line, into) in band.zip(into.chunks_mut(stride)) {
                heights(self.node(line, 0), &mut into[..length]);
            }
            return;
        }
        let mut run = [0.0; BAND];
        let run = &mut run[..band.len()];
        for at in 0..length {
            heights(self.first_of(&band, at), run);
            for (k, &height) in run.iter().enumerate() {
                let line = if self.backwards { band.len() - 1 - k } else { k };
                into[line * stride + at] = height;
            }
        }
    }

    /// Tells the shelter of some lines, in runs of nodes as they lie in memory.
    fn scatter(&self, band: Range<usize>, from: &[f32], stride: usize, found: &mut impl FnMut(usize, &[f32])) {
        let length = self.scan_lines().1;
        if !self.by_cols {
            return band.zip(from.chunks(stride)).for_each(|(line, from)| found(self.node(line, 0), &from[..length]));
        }
        let mut run = [0.0; BAND];
        let run = &mut run[..band.len()];
        for at in 0..length {
            for (k, air) in run.iter_mut().enumerate() {
                let line = if self.backwards { band.len() - 1 - k } else { k };
                *air = from[line * stride + at];
            }
            found(self.first_of(&band, at), run);
        }
    }

    /// The westernmost node of some columns at a place of them.
    fn first_of(&self, band: &Range<usize>, at: usize) -> usize {
        self.node(if self.backwards { band.end - 1 } else { band.start }, at)
    }
}

/// The sheltered air on the line that the wind crossed last, with some nodes beyond its ends.
struct Air {
    line: Vec<f32>,
    torus: bool,
    /// Weight of the farther of two nodes, and where the nearer one stands in `line`.
    part: f32,
    shift: usize,
}

impl Air {
    fn new(scan: &WindScan, length: usize) -> Self {
        let shift = (-scan.drift).floor();
        Self {
            line: vec![f32::NEG_INFINITY; length + 3],
            torus: scan.torus,
            part: (-scan.drift - shift) as f32,
            shift: (shift.clamp(-1.0, 1.0) + 1.0) as usize,
        }
    }

    /// Crosses a line: turns its heights into those of its sheltered air.
    fn cross(&mut self, heights: &mut [f32], drop: f32) {
        let n = heights.len();
        let near = &self.line[self.shift..self.shift + n];
        if self.part == 0.0 {
            heights.iter_mut().zip(near).for_each(|(h, air)| *h = higher(*h, air - drop));
        } else {
            let far = &self.line[self.shift + 1..self.shift + 1 + n];
            for ((h, &a), &b) in heights.iter_mut().zip(near).zip(far) {
                let between = a + (b - a) * self.part;
                let air = if a == f32::NEG_INFINITY { a } else { between };
                *h = higher(*h, air - drop);
            }
        }
        self.line[1..=n].copy_from_slice(heights);
        if self.torus {
            self.line[0] = heights[n - 1];
            (self.line[n + 1], self.line[n + 2]) = (heights[0], heights[1 % n]);
        }
    }
}

/// The higher of two heights; of NaN ground the shadow over it.
#[inline]
fn higher(ground: f32, shadow: f32) -> f32 {
    if ground > shadow { ground } else { shadow }
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
            let drop = (0.25 * sweep.line_spacing) as f32;
            let heights = |first: usize, run: &mut [f32]| {
                run.iter_mut().zip(&z[first..]).for_each(|(h, &z)| *h = z as f32);
            };
            sweep.shelter(heights, 8.0, drop, |first, air| out[first..first + air.len()].copy_from_slice(air));
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
