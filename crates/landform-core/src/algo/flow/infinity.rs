//! Flow in any direction: D-infinity.
//!
//! # Method
//! Around a node lie eight triangles. Water runs down the steepest of their slopes, and is shared
//! between the triangle's two nodes by how close the direction is to each. The surface is that of
//! the water, so that no water runs in a circle; where it is level (lakes, flats) and nothing is
//! lower, water follows the receivers of [`Flow`].
//!
//! Area per width of contour is what is accumulated over the cell's side times max(|cos|, |sin|) of
//! the direction: water on its way crosses one column (or row) at a time.
//!
//! # Sources
//! Tarboton (1997). Validation notes 2.14; written here for cells that need not be square.

use super::Flow;
use crate::grid::{Domain, Grid, Neighbours, RasterDomain, Status};
use crate::{math, parallel};

/// Direction of flow from a node: the slots of a cardinal neighbour and of the diagonal one beside
/// it, and the part that goes to the latter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Slot of the cardinal neighbour: 0 east, 2 north, 4 west, 6 south.
    pub cardinal: u8,
    /// Slot of the diagonal neighbour.
    pub diagonal: u8,
    /// Part of the water that the diagonal neighbour receives.
    pub part: f64,
    /// Direction counter-clockwise from east, radians.
    pub angle: f64,
    /// Slope in that direction, rise over run.
    pub slope: f64,
}

/// Cardinal and diagonal slots of the eight facets, and the sign with which angles grow from the
/// cardinal to the diagonal.
const FACETS: [(u8, u8, f64); 8] =
    [(0, 1, 1.0), (2, 1, -1.0), (2, 3, 1.0), (4, 3, -1.0), (4, 5, 1.0), (6, 5, -1.0), (6, 7, 1.0), (0, 7, -1.0)];

/// The direction of steepest descent (rad) at a node, if any neighbour is lower. Facets with a
/// missing neighbour are left out.
pub fn direction(domain: &RasterDomain, grid: &Grid, surface: &[f64], node: usize) -> Option<Direction> {
    let mut around = [f64::NAN; 8];
    for link in domain.neighbours(node) {
        around[link.slot as usize] = surface[link.to];
    }
    let z = surface[node];
    let mut best: Option<Direction> = None;
    for (cardinal, diagonal, sign) in FACETS {
        let (e1, e2) = (around[cardinal as usize], around[diagonal as usize]);
        let along_x = cardinal % 4 == 0;
        let (d1, d2) = if along_x { (grid.spacing[0], grid.spacing[1]) } else { (grid.spacing[1], grid.spacing[0]) };
        if e1.is_nan() || e2.is_nan() {
            continue;
        }
        let (s1, s2) = ((z - e1) / d1, (e1 - e2) / d2);
        let widest = math::atan2(d2, d1);
        let (mut r, mut slope) = (math::atan2(s2, s1), math::hypot(s1, s2));
        if r < 0.0 {
            (r, slope) = (0.0, s1);
        } else if r > widest {
            (r, slope) = (widest, (z - e2) / math::hypot(d1, d2));
        }
        if slope > best.map_or(0.0, |b| b.slope) {
            let quarter = f64::from(cardinal) * std::f64::consts::FRAC_PI_4;
            best = Some(Direction { cardinal, diagonal, part: r / widest, angle: quarter + sign * r, slope });
        }
    }
    best
}

impl Flow {
    /// Replaces `amount` (the amount of each node itself) by the amount that passes through each
    /// node along D-infinity. To be called after [`Flow::route`] over the same elevation. **Cost**
    /// O(n log n).
    pub fn accumulate_infinity(&self, domain: &RasterDomain, grid: &Grid, elevation: &[f64], amount: &mut [f64]) {
        let level = self.water_level(elevation);
        let status = domain.status();
        let directions: Vec<Option<Direction>> = parallel::map(level.len(), |i| {
            if status[i] == Status::Interior { direction(domain, grid, &level, i) } else { None }
        });
        for &i in &self.highest_first(&level) {
            let i = i as usize;
            let r = self.receiver[i] as usize;
            if r == i {
                continue;
            }
            match directions[i] {
                Some(d) => {
                    amount[domain.neighbour(i, d.diagonal)] += amount[i] * d.part;
                    amount[domain.neighbour(i, d.cardinal)] += amount[i] * (1.0 - d.part);
                }
                None => amount[r] += amount[i],
            }
        }
    }
}
