//! Pits whose way out follows from their neighbours alone.
//!
//! Water in a pit must rise at least to the pit's lowest neighbour. If that neighbour does not drain into the pit itself,
//! then it drains elsewhere (to come back it would have to pass another neighbour of the pit, and those are higher), so the
//! link to it is the lowest pass that the pit's basin can have: an edge of the minimum spanning tree, found without looking
//! at the basin's rim. On rough ground this settles about half of all pits before basins are even labelled.
//!
//! Everywhere nodes are compared by (elevation, index): flats have an order, and no two nodes are equal. So no cycle can
//! arise: each link taken is the lowest way out of its own basin.

use crate::grid::{Domain, Link, NO_SLOT, Status, is_below};
use crate::parallel;

const RUN: usize = 32;

/// Result of [`open_pits`].
pub(super) struct Pits {
    /// Pits, flats counted once.
    pub(super) all: usize,
    /// Those whose way out is not seen yet.
    pub(super) closed: usize,
}

/// Gives pits on flats that could not be tilted the equal neighbour of lower index as receiver, and pits with an open way out
/// that way.
pub(super) fn open_pits<D: Domain>(domain: &D, elevation: &[f64], receiver: &mut [u32], slot: &mut [u8]) -> Pits {
    let pits = without_receiver(domain, slot);
    let lowest =
        |i: usize| domain.neighbours(i).reduce(|a: Link, b| if is_below(elevation, b.to, a.to) { b } else { a });
    let mut lowest_of = Vec::with_capacity(pits.len());
    let mut found = Pits { all: 0, closed: 0 };
    for i in pits {
        match lowest(i) {
            Some(link) if is_below(elevation, link.to, i) => (receiver[i], slot[i]) = (link.to as u32, link.slot),
            Some(link) => lowest_of.push((i, link)),
            None => found.closed += 1,
        }
    }
    found.all = lowest_of.len() + found.closed;
    // The neighbours' receivers are final now: none of them is a pit itself.
    for (i, link) in lowest_of {
        if receiver[link.to] as usize == i {
            found.closed += 1;
        } else {
            (receiver[i], slot[i]) = (link.to as u32, link.slot);
        }
    }
    found
}

/// Interior nodes without a receiver, in order.
pub(super) fn without_receiver<D: Domain>(domain: &D, slot: &[u8]) -> Vec<usize> {
    let status = domain.status();
    parallel::map_pieces(slot.len(), |piece| {
        let mut found = Vec::new();
        // Most runs of slots hold none.
        for first in piece.clone().step_by(RUN) {
            let run = first..(first + RUN).min(piece.end);
            if slot[run.clone()].iter().fold(0, |most, &s| most.max(s)) == NO_SLOT {
                found.extend(run.filter(|&i| slot[i] == NO_SLOT && status[i] == Status::Interior));
            }
        }
        found
    })
    .concat()
}
