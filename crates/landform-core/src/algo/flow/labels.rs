//! Basins by following receivers.

use crate::grid::{BASE_LEVEL, MASKED};

/// The label of everything that reaches a base level.
pub(super) const OUTSIDE: u32 = 0;
const UNKNOWN: u32 = u32::MAX;

/// Labels every node with its basin: 0 for what reaches a base level (or is masked), 1.. for pits, in order of first visit.
/// `pits` receives each basin's lowest node (a placeholder for basin 0).
pub(super) fn label_basins(status: &[u8], receiver: &[u32], label: &mut [u32], pits: &mut Vec<u32>) {
    pits.clear();
    pits.push(u32::MAX);
    label.fill(UNKNOWN);
    for first in 0..label.len() {
        let mut node = first;
        while label[node] == UNKNOWN && receiver[node] as usize != node {
            node = receiver[node] as usize;
        }
        let found = if label[node] != UNKNOWN {
            label[node]
        } else if status[node] == BASE_LEVEL || status[node] == MASKED {
            OUTSIDE
        } else {
            pits.push(node as u32);
            (pits.len() - 1) as u32
        };
        let mut node = first;
        while label[node] == UNKNOWN {
            label[node] = found;
            node = receiver[node] as usize;
        }
    }
}
