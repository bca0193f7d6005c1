//! Basins by following receivers.

use std::ops::Range;

use super::strips::{fetch, split};
use crate::parallel;

/// The label of all nodes that drain to a base level.
pub(super) const OUTSIDE: u32 = 0;
const UNKNOWN: u32 = u32::MAX;
/// Labels from here on mean ground beyond a seam: the k-th way out of the strip.
const BEYOND: u32 = 0xc000_0000;

/// Labels every node with its basin: 0 for nodes that drain to a base level (or are masked), 1..
/// for `pits`, in their order. Strips follow their own receivers side by side; ways over a seam are
/// joined afterwards.
pub(super) fn label_basins(receiver: &[u32], pits: &[usize], cuts: &[Range<usize>], label: &mut [u32]) {
    let parts: Vec<_> = cuts.iter().zip(split(label, cuts)).collect();
    let exits = parallel::run_all(parts, |(strip, label)| label_strip(receiver, pits, strip, label));
    if exits.iter().all(Vec::is_empty) {
        return;
    }
    let resolved: Vec<Vec<u32>> =
        exits.iter().map(|nodes| nodes.iter().map(|&node| resolve(node, label, cuts, &exits)).collect()).collect();
    let parts: Vec<_> = split(label, cuts).into_iter().zip(&resolved).collect();
    parallel::run_all(parts, |(label, resolved)| {
        for v in label.iter_mut().filter(|v| **v >= BEYOND) {
            *v = resolved[(*v - BEYOND) as usize];
        }
    });
}

/// Labels one strip; returns the nodes beyond its seams that its ways lead to.
fn label_strip(receiver: &[u32], pits: &[usize], strip: &Range<usize>, label: &mut [u32]) -> Vec<u32> {
    let first = strip.start;
    label.fill(UNKNOWN);
    fetch(&receiver[strip.clone()]);
    let from = pits.partition_point(|&p| p < first);
    for (k, &pit) in pits.iter().enumerate().skip(from).take_while(|p| *p.1 < strip.end) {
        label[pit - first] = k as u32 + 1;
    }
    let mut exits = Vec::new();
    for start in 0..label.len() {
        let mut node = start;
        let found = loop {
            if label[node] != UNKNOWN {
                break label[node];
            }
            let next = (receiver[first + node] as usize).wrapping_sub(first);
            if next == node {
                break OUTSIDE;
            }
            if next >= label.len() {
                exits.push(receiver[first + node]);
                break BEYOND + (exits.len() - 1) as u32;
            }
            node = next;
        };
        let mut node = start;
        while node < label.len() && label[node] == UNKNOWN {
            label[node] = found;
            node = (receiver[first + node] as usize).wrapping_sub(first);
        }
    }
    exits
}

/// The label of a node, followed over seams.
fn resolve(node: u32, label: &[u32], cuts: &[Range<usize>], exits: &[Vec<u32>]) -> u32 {
    let mut node = node as usize;
    loop {
        let found = label[node];
        if found < BEYOND {
            return found;
        }
        let strip = cuts.partition_point(|c| c.end <= node);
        node = exits[strip][(found - BEYOND) as usize] as usize;
    }
}
