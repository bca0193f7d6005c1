//! Passes between basins.
//!
//! A link between two basins stands as high as its higher end. A fractal surface has almost as many
//! such links as nodes; the minimum spanning tree needs few of them. Take the higher end v of a
//! link and the neighbours of v that are lower. Those that touch form arcs. Within an arc one can
//! walk from neighbour to neighbour below v, and v's own receiver lies in an arc, so a link from v
//! into its receiver's arc closes a cycle on which it is the highest: it is not in the tree. Of the
//! links into another arc one is enough, for the same reason. So only saddles, whose lower
//! neighbours form several arcs, hold passes, and each as many as it has further arcs. There are
//! about as many saddles as pits and peaks together.

use std::ops::Range;

use crate::grid::Domain;

/// A link between two basins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pass {
    /// Elevation of the higher end, m.
    pub(super) height: f64,
    /// Basins on both sides; while the tree grows, what they were merged into.
    pub(super) basins: [u32; 2],
    /// The higher end, in the first basin.
    pub(super) node: u32,
    /// The slot that leads from there to the end in the second basin.
    pub(super) slot: u8,
    /// The how many-th pass of its node this is: orders passes, after the node.
    pub(super) nth: u8,
}

/// Passes of a strip's nodes, in their order. **Cost** O(nodes), most of it reading `saddle`.
pub(super) fn find_passes<D: Domain>(
    domain: &D,
    elevation: &[f64],
    saddle: &[u8],
    slot: &[u8],
    label: &[u32],
    strip: &Range<usize>,
) -> Vec<Pass> {
    let mut found = Vec::new();
    // In a landscape that has almost drained most saddles lie within one basin.
    for node in strip.clone().filter(|&i| saddle[i] != 0 && domain.touches_other(label, i)) {
        let mut nth = 0;
        domain.lower_arcs(elevation, node, slot[node], |to| {
            let basins = [label[node], label[domain.neighbour(node, to)]];
            if basins[0] != basins[1] {
                found.push(Pass { height: elevation[node], basins, node: node as u32, slot: to, nth });
                nth += 1;
            }
        });
    }
    found
}
