//! How straight channels run.

use super::is_near_45;
use crate::analysis::Drainage;
use crate::grid::{Domain, Grid, NO_SLOT};
use crate::{math, parallel};

/// Longer runs of one direction count as straight, nodes.
const STRAIGHT: usize = 10;
/// Length of a reach, nodes.
const REACH: usize = 8;

/// How straight channels run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Channels {
    /// Share of channel nodes in runs of one direction of more than ten.
    pub(super) straight: f64,
    /// Share of reaches of eight nodes within 2 degrees of a multiple of 45.
    pub(super) near_45: f64,
}

/// The channels of a raster, on `least` nodes of area and more, where ground slopes; none where
/// there are none.
pub(super) fn channels<D: Domain>(
    grid: &Grid,
    drainage: &Drainage<D>,
    least: f64,
    slopes: impl Fn(usize) -> bool + Sync,
) -> Option<Channels> {
    let (receivers, slots) = (drainage.flow.receivers(), drainage.flow.slots());
    let least = least * grid.cell_area() * (1.0 - 1e-9);
    let on = |i: usize| drainage.area[i] >= least && slots[i] != NO_SLOT && slopes(i);
    // The donor with the largest area goes on into its receiver.
    let mut main = vec![u32::MAX; receivers.len()];
    for i in (0..receivers.len()).filter(|&i| on(i)) {
        let to = receivers[i] as usize;
        if main[to] == u32::MAX || drainage.area[i] > drainage.area[main[to] as usize] {
            main[to] = i as u32;
        }
    }
    let (mut all, mut long) = (0, 0);
    for i in (0..receivers.len()).filter(|&i| on(i)) {
        let up = main[i];
        if up != u32::MAX && slots[up as usize] == slots[i] {
            continue;
        }
        let (mut run, mut at) = (1, i);
        loop {
            let to = receivers[at] as usize;
            if slots[to] != slots[i] || main[to] as usize != at || !on(to) {
                break;
            }
            run += 1;
            at = to;
        }
        all += run;
        long += if run > STRAIGHT { run } else { 0 };
    }
    if all == 0 {
        return None;
    }
    let reach = |i: usize| {
        let mut at = i;
        for _ in 0..REACH {
            if slots[at] == NO_SLOT {
                return None;
            }
            at = receivers[at] as usize;
        }
        let (a, b) = (grid.shape.cell(i), grid.shape.cell(at));
        let angle = math::atan2(a.row as f64 - b.row as f64, b.col as f64 - a.col as f64).to_degrees();
        Some(is_near_45(angle))
    };
    let found = parallel::map(receivers.len(), |i| if on(i) { reach(i) } else { None });
    let count = |wanted: bool| found.iter().filter(|f| **f == Some(wanted)).count() as f64;
    let (near, off) = (count(true), count(false));
    Some(Channels { straight: long as f64 / all as f64, near_45: near / (near + off).max(1.0) })
}
