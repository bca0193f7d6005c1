//! Passes between basins.
//!
//! A link between two basins stands as high as its higher end. Only the lowest link of each pair of basins matters, but a
//! fractal surface has almost as many links between basins as nodes. Most can be dropped where they are found: if the higher
//! end's own receiver touches the lower end, then the link from that receiver to the lower end joins the same two basins and
//! is lower. What is left are true saddles, with the two ways down on opposite sides.

use super::labels::OUTSIDE;
use crate::grid::{Domain, NO_SLOT};
use crate::parallel;

/// A link between two basins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pass {
    /// Elevation of the higher end, m.
    pub(super) height: f64,
    /// Basins on both sides.
    pub(super) basins: [u32; 2],
    /// The end in the first basin.
    pub(super) node: u32,
    /// The slot that leads from there to the end in the second basin.
    pub(super) slot: u8,
}

/// Fills `passes` in order of nodes. **Cost** O(links).
pub(super) fn find_passes<D: Domain>(domain: &D, elevation: &[f64], slot: &[u8], label: &[u32], passes: &mut Vec<Pass>) {
    passes.clear();
    let found = parallel::map_pieces(domain.len(), |piece| {
        let mut found = Vec::new();
        domain.for_each_link(piece, |a, a_slot, b, b_slot| {
            if label[a] == label[b] {
                return;
            }
            let (za, zb) = (elevation[a], elevation[b]);
            let (high, to_low, drop) = if za >= zb { (a, a_slot, za > zb) } else { (b, b_slot, true) };
            let way = slot[high];
            if drop && way != NO_SLOT && way != to_low && domain.adjacent_slots(high, way, to_low) {
                return;
            }
            debug_assert!(label[a] != OUTSIDE || label[b] != OUTSIDE);
            found.push(Pass { height: za.max(zb), basins: [label[a], label[b]], node: a as u32, slot: a_slot });
        });
        found
    });
    passes.reserve(found.iter().map(Vec::len).sum());
    for piece in found {
        passes.extend(piece);
    }
}
