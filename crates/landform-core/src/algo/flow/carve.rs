//! Carving: in every lake the path from the exit down to the pit is turned round, so that it leads
//! out.
//!
//! Paths of two basins never meet. Strips turn the paths of their own pits side by side; what of a
//! path lies beyond a seam is turned at the end.

use std::ops::Range;

use super::exits::{Exit, home};
use super::strips::split_receivers;
use crate::grid::{Domain, NO_SLOT};
use crate::parallel;

/// A node that is about to get another receiver.
struct Turn {
    node: usize,
    receiver: usize,
    slot: u8,
}

/// Turns the path from each basin's exit down to its pit.
pub(super) fn carve<D: Domain>(
    domain: &D,
    exits: &[Exit],
    pits: &[usize],
    cuts: &[Range<usize>],
    receiver: &mut [u32],
    slot: &mut [u8],
) {
    let beyond = parallel::run_all(split_receivers(receiver, slot, cuts), |part| {
        let home = home(pits, &part.strip);
        let leaving = exits[home.start as usize..home.end as usize].iter().filter(|e| e.slot != NO_SLOT);
        let turns = leaving.map(|e| Turn {
            node: e.node as usize,
            receiver: domain.neighbour(e.node as usize, e.slot),
            slot: e.slot,
        });
        turns.filter_map(|t| turn_path(domain, t, part.strip.start, part.receiver, part.slot)).collect::<Vec<_>>()
    });
    for turn in beyond.into_iter().flatten() {
        turn_path(domain, turn, 0, receiver, slot);
    }
}

/// Turns a path as far as it lies among the nodes from `first` on; returns what is left of it.
fn turn_path<D: Domain>(
    domain: &D,
    mut turn: Turn,
    first: usize,
    receiver: &mut [u32],
    slot: &mut [u8],
) -> Option<Turn> {
    loop {
        let at = turn.node.wrapping_sub(first);
        if at >= slot.len() {
            return Some(turn);
        }
        let old_slot = std::mem::replace(&mut slot[at], turn.slot);
        let old_receiver = std::mem::replace(&mut receiver[at], turn.receiver as u32) as usize;
        if old_slot == NO_SLOT {
            return None;
        }
        let slot = domain.slot_back(turn.node, old_slot);
        turn = Turn { node: old_receiver, receiver: turn.node, slot };
    }
}
