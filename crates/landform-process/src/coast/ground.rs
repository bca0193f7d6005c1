//! Whether ground is as it was left.

use landform_core::parallel;
use landform_core::random::Seed;

/// Nodes that are summed together.
const CHUNK: usize = 1 << 14;

/// The part of one node in the fingerprint of a ground.
pub(super) fn print_of(node: usize, z: f64) -> u64 {
    Seed(z.to_bits()).bits(node as u64)
}

/// A number that is another one after almost any change of elevations: the sum of the nodes' parts,
/// so that known changes can be added. **Cost** O(n), about a nanosecond a node.
pub(super) fn fingerprint(z: &[f64]) -> u64 {
    let chunk = |k: usize| {
        let nodes = k * CHUNK..((k + 1) * CHUNK).min(z.len());
        nodes.fold(0u64, |sum, i| sum.wrapping_add(print_of(i, z[i])))
    };
    parallel::map(z.len().div_ceil(CHUNK), chunk).into_iter().fold(0, u64::wrapping_add)
}
