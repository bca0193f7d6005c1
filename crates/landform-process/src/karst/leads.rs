//! Blind side passages.
//!
//! Many are short and few are long: lengths follow a power law, as those of caves do (Curl 1986,
//! Fractal dimensions and geometries of caves, Mathematical Geology 18). They leave a passage along
//! another fracture, and may have side passages of their own.

use landform_core::math;
use landform_core::random::{Draws, Seed};

use super::near::Cells;
use super::rock::Rock;
use super::space::{Skeleton, Vector, distance, dot, minus, plus, unit};

/// Exponent of the law.
const LAW: f64 = 1.7;
/// The least length over that of bends.
const SHORTEST: f64 = 0.3;
/// The greatest length over the least.
const LONGEST: f64 = 40.0;
/// Mean distance between places where side passages leave, over the length of bends.
const SPACING: f64 = 0.4;

/// Part of the network along which side passages lie.
const GROUPS: f64 = 0.25;

/// Adds side passages to places along the network.
pub(super) fn add(skeleton: &mut Skeleton, count: usize, rock: &Rock<'_>, seed: Seed) {
    let joined = skeleton.joined();
    // Nodes along passages, with the next on either side.
    let along = |n: u32| <[u32; 2]>::try_from(joined[n as usize].as_slice()).ok().map(|next| (n, next));
    let mut starts: Vec<(u32, [u32; 2])> = (0..joined.len() as u32).filter_map(along).collect();
    let mut forks = Cells::new(SPACING * rock.bend);
    (0..joined.len()).filter(|n| joined[*n].len() > 2).for_each(|n| forks.add(n as u32, skeleton.nodes[n]));
    let mut passages = Cells::new(rock.step);
    (0..).zip(&skeleton.nodes).for_each(|(n, at)| passages.add(n, *at));
    // They lie in groups, where the rock dissolves more readily than elsewhere along the network.
    let mut resistances: Vec<f64> = starts.iter().map(|s| rock.resistance(skeleton.nodes[s.0 as usize])).collect();
    resistances.sort_by(f64::total_cmp);
    let most = resistances.get((GROUPS * resistances.len() as f64) as usize).copied().unwrap_or(0.0);
    let mut draws = seed.draws();
    for _ in 0..count {
        let Some(pick) = pick(&starts, skeleton, &forks, most, rock, &mut draws) else { return };
        let (start, next) = starts.swap_remove(pick);
        forks.add(start, skeleton.nodes[start as usize]);
        let [a, b] = next.map(|n| skeleton.nodes[n as usize]);
        let heading = rock.aside(skeleton.nodes[start as usize], unit(minus(b, a)), &mut draws);
        // A power law, cut off at both ends.
        let least = math::pow(LONGEST, -LAW);
        let far = SHORTEST * rock.bend * math::pow(1.0 - draws.uniform() * (1.0 - least), -1.0 / LAW);
        let way = walk(skeleton, start, heading, far, rock, &passages, &mut draws);
        starts.extend(way.windows(3).map(|w| (w[1], [w[0], w[2]])));
        way[1..].iter().for_each(|&n| passages.add(n, skeleton.nodes[n as usize]));
    }
}

/// A place for a side passage: at random, and seldom near another fork.
fn pick(
    starts: &[(u32, [u32; 2])],
    skeleton: &Skeleton,
    forks: &Cells,
    most: f64,
    rock: &Rock<'_>,
    draws: &mut Draws,
) -> Option<usize> {
    if starts.is_empty() {
        return None;
    }
    let mut found = 0;
    for _ in 0..24 {
        found = draws.below(starts.len());
        let at = skeleton.nodes[starts[found].0 as usize];
        if rock.resistance(at) > most {
            continue;
        }
        // Distances between forks are as those of places at random, without the least of them.
        let apart = -0.5 * SPACING * rock.bend * math::log(1.0 - draws.uniform());
        if forks.around(at).all(|f| distance(skeleton.nodes[f as usize], at) > apart) {
            break;
        }
    }
    Some(found)
}

/// Grows a passage of a length (m) until it comes near another. Returns its nodes.
fn walk(
    skeleton: &mut Skeleton,
    start: u32,
    mut heading: Vector,
    far: f64,
    rock: &Rock<'_>,
    passages: &Cells,
    draws: &mut Draws,
) -> Vec<u32> {
    let pieces = (far / rock.step).ceil().clamp(1.0, 10_000.0);
    let piece = far / pieces;
    // Turns add up to the same over a length, in however many pieces.
    let turn = 0.9 * (piece / rock.bend).sqrt();
    let mut way = vec![start];
    let from = skeleton.nodes[start as usize];
    for _ in 0..pieces as usize {
        let node = way[way.len() - 1];
        let at = skeleton.nodes[node as usize];
        let by = [draws.uniform() - 0.5, draws.uniform() - 0.5, 0.2 * (draws.uniform() - 0.5)];
        heading = unit(plus(heading, by, 2.0 * turn));
        let direction = if way.len() == 1 { heading } else { rock.guided(at, heading) };
        let to = rock.held(plus(at, direction, piece));
        // There is no room for more of it.
        if !rock.is_in_rock(to) || !rock.is_clear(at, to, rock.step) {
            break;
        }
        let is_near = |n: u32| {
            let other = skeleton.nodes[n as usize];
            distance(other, to) < 0.7 * rock.step && distance(other, from) > 1.5 * rock.step
        };
        if way.len() > 1 && passages.around(to).any(is_near) {
            break;
        }
        heading = unit(plus(direction, heading, 0.5));
        way.push(skeleton.grow(node, to));
        if dot(minus(to, at), minus(to, at)) < 1e-6 * piece * piece {
            break;
        }
    }
    way
}
