//! Space colonisation: a network grows from the springs, and each place that it must reach pulls
//! at the node next to it.
//!
//! Runions, Lane & Prusinkiewicz (2007), section 3, with open venation. A place stops to pull when
//! a node has come within a step and a half of it; the passage then ends there.

use super::keys::Keys;
use super::near::Cells;
use super::rock::Rock;
use super::space::{Skeleton, Vector, distance, minus, plus, unit};

/// A place that pulls.
struct Attractor {
    at: Vector,
    nearest: u32,
    far: f64,
}

/// Grows the network. Returns the node of each of the keys' ends.
pub(super) fn colonise(skeleton: &mut Skeleton, keys: &Keys, rock: &Rock<'_>) -> Vec<u32> {
    let ends = keys.ends();
    let mut reached = vec![u32::MAX; ends.len()];
    let mut pulling: Vec<(usize, Attractor)> =
        ends.iter().map(|&at| Attractor { at, nearest: 0, far: f64::INFINITY }).enumerate().collect();
    let step = rock.step;
    let mut fresh = 0;
    let mut taken = Cells::new(step);
    let side = (0..2).map(|k| rock.bounds[1][k] - rock.bounds[0][k]).sum::<f64>();
    for _ in 0..(6.0 * side / step) as usize + 20 {
        for n in fresh..skeleton.nodes.len() {
            taken.add(n as u32, skeleton.nodes[n]);
        }
        for (_, a) in &mut pulling {
            for n in fresh..skeleton.nodes.len() {
                let far = distance(a.at, skeleton.nodes[n]);
                if far < a.far {
                    (a.nearest, a.far) = (n as u32, far);
                }
            }
        }
        fresh = skeleton.nodes.len();
        pulling.retain(|(end, a)| {
            let is_there = a.far <= 1.5 * step;
            if is_there {
                reached[*end] = skeleton.grow(a.nearest, a.at);
            }
            !is_there
        });
        if pulling.is_empty() {
            break;
        }
        grow(skeleton, &pulling, &taken, rock);
    }
    // What no growth has reached is joined straight.
    for (end, a) in &pulling {
        let node = skeleton.node(a.at);
        skeleton.join(a.nearest, node, step);
        reached[*end] = node;
    }
    reached
}

/// Every node that is pulled at grows by a step.
fn grow(skeleton: &mut Skeleton, pulling: &[(usize, Attractor)], taken: &Cells, rock: &Rock<'_>) {
    let step = rock.step;
    let old = skeleton.nodes.len();
    let mut by_node: Vec<(u32, usize)> = pulling.iter().enumerate().map(|(k, (_, a))| (a.nearest, k)).collect();
    by_node.sort_unstable();
    for group in by_node.chunk_by(|a, b| a.0 == b.0) {
        let node = group[0].0;
        let from = skeleton.nodes[node as usize];
        let towards = |at: Vector| unit(minus(at, from));
        let sum = group.iter().fold([0.0; 3], |sum, g| plus(sum, towards(pulling[g.1].1.at), 1.0));
        let nearest = group.iter().map(|g| &pulling[g.1].1).min_by(|a, b| a.far.total_cmp(&b.far));
        let Some(nearest) = nearest else { continue };
        let straight = towards(nearest.at);
        // Opposite pulls cancel out: then the nearest decides.
        let mean = if super::space::length(sum) > 0.15 * group.len() as f64 { unit(sum) } else { straight };
        let is_close = nearest.far < 5.0 * step;
        let guided = if is_close { mean } else { rock.guided(from, mean) };
        let ways = [guided, mean, straight];
        // A fracture that leads off the map is not followed along its border.
        let leaves = |to: Vector, at: Vector| (0..2).any(|k| (to[k] - at[k]).abs() > 1e-9);
        let places = ways.iter().enumerate().filter_map(|(k, &way)| {
            let to = plus(from, way, step);
            let at = rock.held(to);
            ((k == 2 || !leaves(to, at)) && rock.is_in_rock(at)).then_some(at)
        });
        let joined = |at: Vector| {
            let is_near = |n: &Vector| distance(*n, at) < 0.5 * step;
            let is_taken = skeleton.nodes[old..].iter().any(is_near)
                || taken.around(at).any(|n| is_near(&skeleton.nodes[n as usize]));
            let gains = group.iter().any(|g| distance(pulling[g.1].1.at, at) < pulling[g.1].1.far - 0.05 * step);
            gains && !is_taken
        };
        let mut places = places;
        let found = places.find(|at| joined(*at));
        if let Some(at) = found {
            skeleton.grow(node, at);
        }
    }
}
