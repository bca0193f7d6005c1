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
        let [from, to] = [a, b].map(|n| skeleton.nodes[n as usize]);
        if is_free(a) && is_free(b) && rock.is_clear(from, to, rock.step) {
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
    /// Ancestors of each node: the next, the second, the fourth and so on; a root's is itself.
    above: Vec<Vec<u32>>,
    root: Vec<u32>,
    depth: Vec<u32>,
    /// Distance from the root, m.
    along: Vec<f64>,
}

impl Ways {
    fn of(skeleton: &Skeleton, joined: &[Vec<u32>]) -> Self {
        let n = skeleton.nodes.len();
        let mut parent: Vec<u32> = (0..n as u32).collect();
        let mut ways = Self { above: Vec::new(), root: vec![u32::MAX; n], depth: vec![0; n], along: vec![0.0; n] };
        for root in 0..n as u32 {
            if ways.root[root as usize] != u32::MAX {
                continue;
            }
            ways.root[root as usize] = root;
            let mut stack = vec![root];
            while let Some(v) = stack.pop() {
                for &w in &joined[v as usize] {
                    if ways.root[w as usize] == u32::MAX {
                        ways.root[w as usize] = root;
                        ways.depth[w as usize] = ways.depth[v as usize] + 1;
                        parent[w as usize] = v;
                        let leg = distance(skeleton.nodes[v as usize], skeleton.nodes[w as usize]);
                        ways.along[w as usize] = ways.along[v as usize] + leg;
                        stack.push(w);
                    }
                }
            }
        }
        let deepest = ways.depth.iter().copied().max().unwrap_or(0);
        ways.above.push(parent);
        while deepest >> ways.above.len() > 0 {
            let last = &ways.above[ways.above.len() - 1];
            ways.above.push(last.iter().map(|&p| last[p as usize]).collect());
        }
        ways
    }

    /// Distance along the tree, m; none between trees.
    fn between(&self, a: u32, b: u32) -> Option<f64> {
        if self.root[a as usize] != self.root[b as usize] {
            return None;
        }
        let depth = |n: u32| self.depth[n as usize];
        let (mut x, mut y) = if depth(a) < depth(b) { (b, a) } else { (a, b) };
        let lift = depth(x) - depth(y);
        for (_, above) in self.above.iter().enumerate().filter(|(k, _)| lift >> k & 1 == 1) {
            x = above[x as usize];
        }
        for above in self.above.iter().rev() {
            if above[x as usize] != above[y as usize] {
                (x, y) = (above[x as usize], above[y as usize]);
            }
        }
        let fork = if x == y { x } else { self.above[0][x as usize] };
        Some(self.along[a as usize] + self.along[b as usize] - 2.0 * self.along[fork as usize])
    }
}
