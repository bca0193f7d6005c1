//! Donors before receivers, and sums down the flow, in one pass.

use crate::grid::NO_SLOT;

const DONE: u8 = u8::MAX;

/// Orders nodes by counting donors and adds `amount` down the flow on the way.
///
/// From each node without waiting donors the chain of receivers is followed as long as it runs through nodes that the scan
/// has passed; so the order keeps to neighbours in memory.
pub(super) fn order_and_accumulate(
    receiver: &[u32],
    slot: &[u8],
    donors: &mut [u8],
    order: &mut [u32],
    amount: &mut [f64],
) {
    let n = receiver.len();
    donors.fill(0);
    for i in 0..n {
        if slot[i] != NO_SLOT {
            donors[receiver[i] as usize] += 1;
        }
    }
    let mut placed = 0;
    for first in 0..n {
        let mut node = first;
        while donors[node] == 0 {
            donors[node] = DONE;
            order[placed] = node as u32;
            placed += 1;
            if slot[node] == NO_SLOT {
                break;
            }
            let next = receiver[node] as usize;
            amount[next] += amount[node];
            donors[next] -= 1;
            if next > first {
                break;
            }
            node = next;
        }
    }
    debug_assert_eq!(placed, n, "receivers form a cycle");
}
