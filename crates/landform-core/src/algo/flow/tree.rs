//! The minimum spanning tree of basins, and the outlet of every lake.

use super::labels::OUTSIDE;
use super::passes::Pass;
use crate::grid::{Domain, NO_SLOT};

const NONE: (f64, u32) = (f64::INFINITY, u32::MAX);

/// The passes of the minimum spanning tree, by Borůvka's rounds with filtering; basins are numbered 0..`basins`.
///
/// Equal heights are ordered by position in the list. **Cost** O(passes · log basins), in practice a few rounds over a list that
/// halves each time.
pub(super) fn spanning_tree(mut passes: Vec<Pass>, basins: usize) -> Vec<Pass> {
    let mut parent: Vec<u32> = (0..basins as u32).collect();
    let mut tree: Vec<Pass> = Vec::with_capacity(basins);
    let mut best = vec![NONE; basins];
    loop {
        best.fill(NONE);
        let mut kept = 0;
        for k in 0..passes.len() {
            let mut pass = passes[k];
            pass.basins = pass.basins.map(|x| find(&mut parent, x));
            if pass.basins[0] == pass.basins[1] {
                continue;
            }
            for root in pass.basins {
                if pass.height < best[root as usize].0 {
                    best[root as usize] = (pass.height, kept as u32);
                }
            }
            passes[kept] = pass;
            kept += 1;
        }
        if kept == 0 {
            return tree;
        }
        passes.truncate(kept);
        for root in 0..basins {
            let (_, k) = best[root];
            if k == u32::MAX {
                continue;
            }
            let pass = passes[k as usize];
            let [a, b] = pass.basins.map(|x| find(&mut parent, x));
            if a != b {
                // The lower number stays the root, so that the outside keeps number 0.
                parent[a.max(b) as usize] = a.min(b);
                tree.push(pass);
            }
        }
    }
}

fn find(parent: &mut [u32], mut x: u32) -> u32 {
    while parent[x as usize] != x {
        parent[x as usize] = parent[parent[x as usize] as usize];
        x = parent[x as usize];
    }
    x
}

/// Walks the tree from the outside and turns the path from each pass down to the pit behind it, so that it leads out.
///
/// Basins that no pass joins to the outside (a closed domain) are left draining to the pit of the first among them.
pub(super) fn carve<D: Domain>(
    domain: &D,
    mut tree: Vec<Pass>,
    label: &[u32],
    basins: usize,
    receiver: &mut [u32],
    slot: &mut [u8],
) {
    for pass in &mut tree {
        let node = pass.node as usize;
        pass.basins = [label[node], label[domain.neighbour(node, pass.slot)]];
    }
    let (start, passes) = by_basin(&tree, basins);
    let mut seen = vec![false; basins];
    let mut stack = Vec::new();
    for root in OUTSIDE..basins as u32 {
        if std::mem::replace(&mut seen[root as usize], true) {
            continue;
        }
        stack.push(root);
        while let Some(basin) = stack.pop() {
            for &k in &passes[start[basin as usize]..start[basin as usize + 1]] {
                let pass = tree[k as usize];
                let (other, inner, out) = leaving(domain, &pass, basin);
                if !std::mem::replace(&mut seen[other as usize], true) {
                    stack.push(other);
                    turn_path(domain, inner, out, receiver, slot);
                }
            }
        }
    }
}

/// Tree passes of each basin, in compressed rows.
fn by_basin(tree: &[Pass], basins: usize) -> (Vec<usize>, Vec<u32>) {
    let mut start = vec![0; basins + 1];
    for basin in tree.iter().flat_map(|p| p.basins) {
        start[basin as usize + 1] += 1;
    }
    for k in 0..basins {
        start[k + 1] += start[k];
    }
    let mut at = start.clone();
    let mut passes = vec![0; tree.len() * 2];
    for (k, pass) in tree.iter().enumerate() {
        for basin in pass.basins {
            passes[at[basin as usize]] = k as u32;
            at[basin as usize] += 1;
        }
    }
    (start, passes)
}

/// Seen from `basin`: the basin behind the pass, the pass's node in it, and the slot that leads from there into `basin`.
fn leaving<D: Domain>(domain: &D, pass: &Pass, basin: u32) -> (u32, usize, u8) {
    let node = pass.node as usize;
    if pass.basins[0] == basin {
        (pass.basins[1], domain.neighbour(node, pass.slot), domain.slot_back(node, pass.slot))
    } else {
        (pass.basins[0], node, pass.slot)
    }
}

fn turn_path<D: Domain>(domain: &D, first: usize, out: u8, receiver: &mut [u32], slot: &mut [u8]) {
    let (mut node, mut new_slot) = (first, out);
    let mut new_receiver = domain.neighbour(first, out);
    loop {
        let old_slot = std::mem::replace(&mut slot[node], new_slot);
        let old_receiver = std::mem::replace(&mut receiver[node], new_receiver as u32) as usize;
        if old_slot == NO_SLOT {
            return;
        }
        new_slot = domain.slot_back(node, old_slot);
        new_receiver = node;
        node = old_receiver;
    }
}
