//! Heights as the steps of a height field of POV-Ray.

use landform_core::grid::Shape;

/// Greatest step.
const STEPS: f64 = 65_535.0;

/// Heights from the foot of a block to its top in 16-bit steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heights {
    /// Level of step 0, m.
    pub(super) foot: f64,
    /// Height of a step, m.
    pub(super) step: f64,
}

impl Heights {
    pub(super) fn between(foot: f64, top: f64) -> Self {
        Self { foot, step: (top - foot) / STEPS }
    }

    fn step_of(self, z: f64) -> u16 {
        if z.is_finite() { ((z - self.foot) / self.step).round().clamp(0.0, STEPS) as u16 } else { 0 }
    }

    /// The ground; nodata lies at its least elevation (m).
    pub(super) fn ground(self, z: &[f64], low: f64) -> Vec<u16> {
        z.iter().map(|&z| self.step_of(if z.is_nan() { low } else { z })).collect()
    }

    /// The surface of lakes; none without any. Beside a lake its surface goes on, under the ground
    /// of the shore; elsewhere it lies at the foot, out of sight.
    pub(super) fn lakes(self, shape: Shape, z: &[f64], depth: &[f64]) -> Option<Vec<u16>> {
        let surface = |i: usize| (depth[i] > 0.0 && z[i].is_finite()).then(|| self.step_of(z[i] + depth[i]));
        (0..z.len()).any(|i| surface(i).is_some()).then(|| {
            let shore = |i: usize| {
                let level = around(shape, i).filter_map(surface).max();
                level.map_or(0, |level| level.min(self.step_of(z[i]).saturating_sub(1)))
            };
            (0..z.len()).map(|i| surface(i).unwrap_or_else(|| shore(i))).collect()
        })
    }
}

/// The up to eight nodes around a node.
fn around(shape: Shape, i: usize) -> impl Iterator<Item = usize> {
    let (row, col) = (i / shape.cols, i % shape.cols);
    let span = |at: usize, count: usize| at.saturating_sub(1)..(at + 2).min(count);
    span(row, shape.rows)
        .flat_map(move |r| span(col, shape.cols).map(move |c| shape.index(r, c)))
        .filter(move |&j| j != i)
}
