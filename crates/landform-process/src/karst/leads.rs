//! Blind side passages.
//!
//! Many are short and few are long: lengths follow a power law, as those of caves do (Curl 1986,
//! Fractal dimensions and geometries of caves, Mathematical Geology 18).

use landform_core::math;
use landform_core::random::Seed;

use super::rock::Rock;
use super::space::{Skeleton, plus, unit};

/// Exponent of the law, and the greatest length over the least.
const LAW: f64 = 2.0;
/// The least length over that of bends.
const SHORTEST: f64 = 0.35;
const LONGEST: f64 = 15.0;

/// Adds side passages to places along the network.
pub(super) fn add(skeleton: &mut Skeleton, count: usize, rock: &Rock<'_>, seed: Seed) {
    let joined = skeleton.joined();
    let between: Vec<u32> = (0..joined.len() as u32).filter(|n| joined[*n as usize].len() == 2).collect();
    // They begin where the rock dissolves readily, and so in groups.
    let starts: Vec<u32> = between.iter().copied().filter(|n| rock.dissolves(skeleton.nodes[*n as usize])).collect();
    let starts = if starts.is_empty() { between } else { starts };
    if starts.is_empty() {
        return;
    }
    let mut draws = seed.draws();
    for _ in 0..count {
        let start = starts[draws.below(starts.len())];
        // A power law, cut off at both ends.
        let least = math::pow(LONGEST, -LAW);
        let far = SHORTEST * rock.bend * math::pow(1.0 - draws.uniform() * (1.0 - least), -1.0 / LAW);
        let turn = std::f64::consts::TAU * draws.uniform();
        let mut heading = [math::sin(turn), math::cos(turn), 0.15 * (draws.uniform() - 0.5)];
        let pieces = (far / rock.step).ceil();
        let mut node = start;
        for _ in 0..(pieces as usize).min(10_000) {
            let at = skeleton.nodes[node as usize];
            heading = unit(plus(heading, [draws.uniform() - 0.5, draws.uniform() - 0.5, 0.0], 0.8));
            let to = rock.held(plus(at, rock.guided(at, heading), far / pieces));
            // There is no room for more of it.
            if !rock.is_in_rock(to) || !rock.is_clear(at, to, rock.step) {
                break;
            }
            node = skeleton.grow(node, to);
        }
    }
}
