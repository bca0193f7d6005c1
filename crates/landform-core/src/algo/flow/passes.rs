//! Passes between basins.
//!
//! A link between two basins stands as high as its higher end. Only the lowest link of each pair of basins matters, but a
//! fractal surface has almost as many links between basins as nodes. Many can be dropped where they are found: if the higher
//! end's own receiver touches the lower end, then the link from that receiver to the lower end joins the same two basins and
//! is lower. What is left are saddles, with the two ways down on opposite sides.

use crate::grid::{Domain, NO_SLOT};
use crate::parallel;

/// A link between two basins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pass {
    /// Elevation of the higher end, m.
    pub(super) height: f64,
    /// Basins on both sides; while the tree grows, what they were merged into.
    pub(super) basins: [u32; 2],
    /// The end in the first basin.
    pub(super) node: u32,
    /// The slot that leads from there to the end in the second basin.
    pub(super) slot: u8,
}

/// Passes in order of nodes, in pieces. **Cost** O(links).
pub(super) fn find_passes<D: Domain>(domain: &D, elevation: &[f64], slot: &[u8], label: &[u32]) -> Vec<Vec<Pass>> {
    parallel::map_pieces(domain.len(), |piece| {
        let mut found = Vec::with_capacity(piece.len() / 4);
        domain.for_each_link(piece, |a, a_slot, b, b_slot| {
            let basins = [label[a], label[b]];
            if basins[0] == basins[1] {
                return;
            }
            let (za, zb) = (elevation[a], elevation[b]);
            let (high, to_low, drop) = if za >= zb { (a, a_slot, za > zb) } else { (b, b_slot, true) };
            let way = slot[high];
            if drop && way != NO_SLOT && domain.adjacent_slots(high, way, to_low) {
                return;
            }
            found.push(Pass { height: za.max(zb), basins, node: a as u32, slot: a_slot });
        });
        found
    })
}
