//! Loops: passages between places that lie near each other and far apart along the network.

use std::collections::BTreeSet;

use landform_core::random::Seed;

use super::near::Near;
use super::rock::Rock;
use super::space::{Skeleton, distance};

/// Closes up to `count` loops.
pub(super) fn close(skeleton: &mut Skeleton, count: usize, rock: &Rock<'_>, seed: Seed) {
    if count == 0 {
        return;
    }
    let joined = skeleton.joined();
    let ways = Ways::of(skeleton, &joined);
    let reach = 16.0 * rock.step;
    let near = Near::new(&skeleton.nodes, reach);
    let mut candidates: Vec<(f64, u32, u32)> = Vec::new();
    for a in 0..skeleton.nodes.len() as u32 {
        let at = skeleton.nodes[a as usize];
        for b in near.within(at, reach).into_iter().filter(|b| *b > a) {
            let to = skeleton.nodes[b as usize];
            let gap = distance(at, to);
            // Level ones: loops follow a bed or the water table.
            let is_level = (to[2] - at[2]).abs() < 0.5 * gap;
            if gap > 2.0 * rock.step && is_level && ways.between(a, b).is_none_or(|along| along > 2.5 * gap) {
                let chance = seed.uniform((u64::from(a) << 32) | u64::from(b));
                candidates.push((gap * (0.3 + chance), a, b));
            }
        }
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut taken: BTreeSet<u32> = BTreeSet::new();
    let mut closed = 0;
    for (_, a, b) in candidates {
        if closed == count {
            break;
        }
        let is_free = |n: u32| !taken.contains(&n) && joined[n as usize].len() < 3;
        if is_free(a) && is_free(b) {
            for n in [a, b] {
                taken.insert(n);
                taken.extend(&joined[n as usize]);
            }
            skeleton.join(a, b, rock.step);
            closed += 1;
        }
    }
}

/// Ways along a forest.
struct Ways {
    parent: Vec<u32>,
    depth: Vec<u32>,
    /// Distance from the root, m.
    along: Vec<f64>,
}

impl Ways {
    fn of(skeleton: &Skeleton, joined: &[Vec<u32>]) -> Self {
        let n = skeleton.nodes.len();
        let mut ways = Self { parent: vec![u32::MAX; n], depth: vec![u32::MAX; n], along: vec![0.0; n] };
        for root in 0..n as u32 {
            if ways.depth[root as usize] != u32::MAX {
                continue;
            }
            ways.depth[root as usize] = 0;
            let mut stack = vec![root];
            while let Some(v) = stack.pop() {
                for &w in &joined[v as usize] {
                    if ways.depth[w as usize] == u32::MAX {
                        ways.depth[w as usize] = ways.depth[v as usize] + 1;
                        ways.parent[w as usize] = v;
                        let leg = distance(skeleton.nodes[v as usize], skeleton.nodes[w as usize]);
                        ways.along[w as usize] = ways.along[v as usize] + leg;
                        stack.push(w);
                    }
                }
            }
        }
        ways
    }

    /// Distance along the tree, m; none between trees.
    fn between(&self, a: u32, b: u32) -> Option<f64> {
        let (mut x, mut y) = (a, b);
        while x != y {
            if self.depth[x as usize] < self.depth[y as usize] {
                std::mem::swap(&mut x, &mut y);
            }
            x = self.parent[x as usize];
            if x == u32::MAX {
                return None;
            }
        }
        Some(self.along[a as usize] + self.along[b as usize] - 2.0 * self.along[x as usize])
    }
}
