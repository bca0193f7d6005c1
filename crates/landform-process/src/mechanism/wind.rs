//! Wind over a raster: lines swept downwind.
//!
//! # Method
//! Rows (or columns, whichever the wind crosses more squarely) are visited in the order in which the wind reaches them. What a node gets
//! comes from the place upwind of it on the line before, linear between the two nodes beside that place. On a torus the lines are swept
//! twice, the second time with what the first pass left at the seam.

use landform_core::grid::Shape;

/// The order in which a wind crosses a raster.
#[derive(Clone, Copy, Debug)]
pub struct Sweep {
    shape: Shape,
    torus: bool,
    /// Whether lines are columns (else rows).
    by_cols: bool,
    /// Whether lines are visited from the last to the first.
    backwards: bool,
    /// How far the wind drifts along a line while it crosses from one to the next, nodes, -1 to 1 for square cells.
    drift: f64,
    /// Distance that the wind travels from line to line, m.
    pub pace: f64,
}

impl Sweep {
    /// The sweep of a wind that blows along `towards` (x east, y north).
    pub fn new(shape: Shape, spacing: [f64; 2], torus: bool, towards: [f64; 2]) -> Self {
        let [c, r] = [towards[0] / spacing[0], -towards[1] / spacing[1]];
        let by_cols = c.abs() >= r.abs();
        let (major, minor) = if by_cols { (c, r) } else { (r, c) };
        Self { shape, torus, by_cols, backwards: major < 0.0, drift: minor / major.abs(), pace: 1.0 / major.abs() }
    }

    /// Number of lines and nodes of each.
    pub fn lines(&self) -> (usize, usize) {
        let Shape { rows, cols } = self.shape;
        if self.by_cols { (cols, rows) } else { (rows, cols) }
    }

    /// The node at a place of a line; lines count downwind.
    #[inline]
    pub fn node(&self, line: usize, at: usize) -> usize {
        let line = if self.backwards { self.lines().0 - 1 - line } else { line };
        if self.by_cols { self.shape.index(at, line) } else { self.shape.index(line, at) }
    }

    /// The places on the line before that lie upwind of a place, with the second one's weight; none off the field.
    #[inline]
    pub fn upwind(&self, at: usize) -> Option<(usize, usize, f64)> {
        let n = self.lines().1 as f64;
        let from = at as f64 - self.drift;
        let from = if self.torus { from.rem_euclid(n) } else { from };
        if !(0.0..=n - 1.0).contains(&from) && !self.torus {
            return None;
        }
        let low = from.floor();
        let (a, part) = (low as usize % n as usize, from - low);
        let b = if part == 0.0 { a } else { (a + 1) % n as usize };
        Some((a, b, part))
    }

    /// Whole nodes that the wind drifts along the line on its way into `line`: of several lines they add up to the true direction.
    pub fn whole_drift(&self, line: usize) -> i64 {
        let upto = |k: usize| (k as f64 * self.drift).round() as i64;
        upto(line) - upto(line.wrapping_sub(1).min(line))
    }

    /// A place of a line moved along it; none off a field that is no torus.
    #[inline]
    pub fn along(&self, at: usize, by: i64) -> Option<usize> {
        let (to, n) = (at as i64 + by, self.lines().1 as i64);
        if (0..n).contains(&to) { Some(to as usize) } else { self.torus.then(|| to.rem_euclid(n) as usize) }
    }

    /// How far the wind drifts along a line on its way to the next, nodes.
    pub fn drift(&self) -> f64 {
        self.drift
    }

    /// Whether the first line follows on the last.
    pub fn is_torus(&self) -> bool {
        self.torus
    }

    /// Height of the air that the ground upwind shelters, for every node: the highest of upwind ground less `tan_angle` times its distance,
    /// and no lower than the ground itself. A node lies in shadow where this is above its ground. `height` and the outcome in one unit;
    /// `drop` is how much the shadow falls from line to line in that unit. NaN ground casts no shadow.
    pub fn shelter(&self, height: impl Fn(usize) -> f32, drop: f32, out: &mut [f32]) {
        let (lines, length) = self.lines();
        let straight = self.drift == 0.0;
        let mut before = vec![f32::NEG_INFINITY; length];
        let mut here = before.clone();
        for pass in 0..if self.torus { 2 } else { 1 } {
            for line in 0..lines {
                for at in 0..length {
                    let shadow = if straight {
                        before[at]
                    } else {
                        self.upwind(at).map_or(f32::NEG_INFINITY, |(a, b, part)| {
                            if before[a] == f32::NEG_INFINITY || before[b] == f32::NEG_INFINITY {
                                before[a].min(before[b])
                            } else {
                                before[a] + (before[b] - before[a]) * part as f32
                            }
                        })
                    };
                    let node = self.node(line, at);
                    here[at] = height(node).max(shadow - drop);
                    if pass == 1 || !self.torus {
                        out[node] = here[at];
                    }
                }
                std::mem::swap(&mut before, &mut here);
            }
        }
    }
}

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
            let sweep = Sweep::new(grid.shape, grid.spacing, false, towards);
            let mut out = vec![0.0; 1200];
            sweep.shelter(|i| z[i] as f32, (0.25 * sweep.pace) as f32, &mut out);
            let geometric = shadow(&grid, &z, f64::to_radians(from), angle);
            // A line of sight along the very border may leave the map by a rounding error.
            let inner = |i: &usize| (1..29).contains(&(i / 40)) && (1..39).contains(&(i % 40));
            let wrong = (0..1200).filter(inner).filter(|&i| (f64::from(out[i]) > z[i] + 1e-6) != geometric[i]).count();
            assert!(wrong < 4, "{from}: {wrong}");
        }
    }

    #[test]
    fn a_slanting_wind_drifts_by_its_angle() {
        let sweep = Sweep::new(Shape::new(50, 50), [1.0; 2], true, [math::cos(0.5), math::sin(0.5)]);
        let total: i64 = (1..=40).map(|k| sweep.whole_drift(k)).sum();
        assert_eq!(total, -(40.0 * math::tan(0.5)).round() as i64);
        assert!((sweep.pace - 1.0 / math::cos(0.5)).abs() < 1e-12);
        let (a, b, part) = sweep.upwind(10).unwrap();
        assert!(a == 10 && b == 11 && (part - math::tan(0.5)).abs() < 1e-12);
    }
}
