//! Priority-Flood.
//!
//! # Sources
//! Barnes, Lehman & Mulla (2014), algorithm 2 (the heap with a plain queue inside depressions).

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

use super::Height;
use crate::grid::{Domain, Status};

/// The level to which each node must be filled so that water reaches a base level. NaN on masked
/// nodes; nodes that no base level can be reached from keep their elevation.
///
/// **Cost** O(n + m log m), with m nodes outside of depressions.
pub fn flood_levels<D: Domain>(domain: &D, elevation: &[f64]) -> Vec<f64> {
    let status = domain.status();
    let mut level = elevation.to_vec();
    let mut closed = vec![false; level.len()];
    let mut heap = BinaryHeap::new();
    let mut lake = VecDeque::new();
    for i in (0..level.len()).filter(|&i| status[i] == Status::BaseLevel) {
        heap.push(Reverse((Height(level[i]), i)));
        closed[i] = true;
    }
    while let Some(i) = lake.pop_front().or_else(|| heap.pop().map(|Reverse((_, i))| i)) {
        for link in domain.neighbours(i) {
            let j = link.to;
            if status[j] == Status::Masked || std::mem::replace(&mut closed[j], true) {
                continue;
            }
            if level[j] <= level[i] {
                level[j] = level[i];
                lake.push_back(j);
            } else {
                heap.push(Reverse((Height(level[j]), j)));
            }
        }
    }
    level
}
