//! Mazes: nets of passages that fill a zone around the way from sinkholes to springs.

use landform_core::algo::DisjointSets;
use landform_core::{Error, Result, math};

use super::keys::Keys;
use super::near::Near;
use super::rock::Rock;
use super::space::{Skeleton, Vector, distance};
use super::{Preset, colonise};

/// Shares of the ways beyond those that hold the net together that are kept.
const KEPT: [f64; 2] = [0.4, 0.4];
/// Steps around the trunk that nets and sponges reach.
const REACH: [f64; 2] = [5.0, 2.0];

/// Fills the zone. Returns the node of each of the keys' ends.
pub(super) fn fill(skeleton: &mut Skeleton, keys: &Keys, rock: &Rock<'_>, preset: Preset) -> Result<Vec<u32>> {
    // The zone follows a network that grows as any.
    let mut trunk = skeleton.clone();
    colonise::colonise(&mut trunk, keys, rock);
    let ends = keys.ends();
    let key_count = skeleton.nodes.len() + ends.len();
    let mut places = skeleton.nodes.clone();
    places.extend(&ends);
    let is_rectilinear = preset == Preset::RectilinearMaze;
    let reach = REACH[usize::from(!is_rectilinear)] * rock.step;
    let zone = Zone { near: Near::new(&trunk.nodes, reach), reach };
    let mut ways = if is_rectilinear { net(&mut places, rock, &zone) } else { sponge(&mut places, rock, &zone)? };
    ways.retain(|w| rock.is_clear(places[w.1 as usize], places[w.2 as usize], rock.step));
    // Keys hang on the place next to them.
    for key in 0..key_count {
        let far = |n: &usize| distance(places[*n], places[key]);
        let nearest = (key_count..places.len()).min_by(|a, b| far(a).total_cmp(&far(b)));
        ways.push((0.0, key as u32, nearest.unwrap_or((key + 1) % key_count) as u32));
    }
    let kept = hold_together(ways, places.len(), KEPT[usize::from(!is_rectilinear)], rock, key_count);
    let first = skeleton.nodes.len();
    skeleton.nodes.extend(&places[first..]);
    kept.into_iter().for_each(|[a, b]| skeleton.join(a, b, rock.step));
    Ok((first..key_count).map(|k| k as u32).collect())
}

/// More places than this are refused.
const MOST_CELLS: u64 = 2_000_000;

struct Zone<'a> {
    near: Near<'a>,
    reach: f64,
}

impl Zone<'_> {
    fn holds(&self, at: Vector) -> bool {
        !self.near.within(at, self.reach).is_empty()
    }
}

type Way = (f64, u32, u32);

/// Two families of fractures at irregular distances, and the ways along them.
fn net(places: &mut Vec<Vector>, rock: &Rock<'_>, zone: &Zone<'_>) -> Vec<Way> {
    let strikes = rock.strikes();
    let first = strikes.first().copied().unwrap_or(0.6);
    let across = first + std::f64::consts::FRAC_PI_2;
    let second = strikes.get(1).copied().filter(|s| math::sin(s - first).abs() > 0.3).unwrap_or(across);
    let axes = [first, second].map(|s| [math::sin(s), math::cos(s)]);
    let middle = [0, 1].map(|k| 0.5 * (rock.bounds[0][k] + rock.bounds[1][k]));
    let half: f64 = (0..2).map(|k| rock.bounds[1][k] - rock.bounds[0][k]).sum();
    let seed = rock.seed.named("net");
    let lines = |family: u64| {
        let mut draws = seed.with(family).draws();
        let mut at = -half;
        let mut lines = Vec::new();
        while at < half {
            lines.push(at);
            // Fractures lie at distances of an exponential law.
            at += rock.step * (1.5 - 2.5 * math::log(1.0 - draws.uniform()));
        }
        lines
    };
    let lines = [lines(0), lines(1)];
    let mut number = vec![u32::MAX; lines[0].len() * lines[1].len()];
    let mut ways = Vec::new();
    for (i, a) in lines[0].iter().enumerate() {
        for (j, b) in lines[1].iter().enumerate() {
            let [x, y] = [0, 1].map(|k| middle[k] + a * axes[0][k] + b * axes[1][k]);
            let inside = (0..2).all(|k| ([x, y][k] - middle[k]).abs() <= 0.5 * (rock.bounds[1][k] - rock.bounds[0][k]));
            let level = rock.water_table([x, y, 0.0]) - 0.25 * rock.depth;
            let at = [x, y, rock.on_bed([x, y, level + 0.2 * rock.depth * Rock::noise(seed, [x, y, 0.0], rock.bend)])];
            if !inside || !rock.holds(at) || !zone.holds(at) {
                continue;
            }
            number[i * lines[1].len() + j] = places.len() as u32;
            places.push(at);
            for (di, dj) in [(1, 0), (0, 1)] {
                if i >= di && j >= dj {
                    let other = number[(i - di) * lines[1].len() + j - dj];
                    if other != u32::MAX {
                        ways.push((0.0, other, places.len() as u32 - 1));
                    }
                }
            }
        }
    }
    ways
}

/// Places at random in space, and the ways between those that have no third one between them.
///
/// # Errors
/// [`Error::Parameter`] for too many places.
fn sponge(places: &mut Vec<Vector>, rock: &Rock<'_>, zone: &Zone<'_>) -> Result<Vec<Way>> {
    let (first, gap) = (places.len(), 2.5 * rock.step);
    let seed = rock.seed.named("sponge");
    let deepest = rock.springs.iter().map(|s| s.1).fold(f64::INFINITY, f64::min) - rock.depth - gap;
    let highest = rock.springs.iter().map(|s| s.1).fold(f64::NEG_INFINITY, f64::max) + 0.5 * gap;
    let counts = [0, 1].map(|k| ((rock.bounds[1][k] - rock.bounds[0][k]) / gap).ceil().max(1.0) as u64);
    let levels = (2.0 * (highest - deepest) / gap).ceil().clamp(1.0, 64.0) as u64;
    let cells = counts[0] * counts[1] * levels;
    if cells > MOST_CELLS {
        let given = format!("{} m: {cells} places", rock.step);
        return Err(Error::parameter("step", given, &format!("steps that make at most {MOST_CELLS}; try longer ones")));
    }
    for i in 0..cells {
        let cell = [i % counts[0], i / counts[0] % counts[1], i / (counts[0] * counts[1])];
        let part = [0, 1, 2].map(|k| cell[k] as f64 + seed.uniform(3 * i + k as u64));
        let [x, y] = [0, 1].map(|k| rock.bounds[0][k] + gap * part[k]);
        let at = [x, y, deepest + 0.5 * gap * part[2]];
        if rock.holds(at) && zone.holds(at) {
            places.push(at);
        }
    }
    let near = Near::new(&places[first..], 1.6 * gap);
    let mut ways = Vec::new();
    for a in first..places.len() {
        let around = near.within(places[a], 1.6 * gap);
        for b in around.iter().map(|b| *b as usize + first).filter(|b| *b > a) {
            let far = distance(places[a], places[b]);
            let between = |c: usize| distance(places[a], places[c]).max(distance(places[b], places[c])) < far;
            if !around.iter().map(|c| *c as usize + first).any(|c| c != a && c != b && between(c)) {
                ways.push((0.0, a as u32, b as u32));
            }
        }
    }
    Ok(ways)
}

/// A tree of the ways, in random order, and a share of the others. Parts without a key are left
/// out; those with one are joined to the first.
fn hold_together(mut ways: Vec<Way>, count: usize, share: f64, rock: &Rock<'_>, keys: usize) -> Vec<[u32; 2]> {
    let seed = rock.seed.named("ways");
    for (k, way) in ways.iter_mut().enumerate() {
        let is_of_key = (way.1 as usize) < keys;
        way.0 = if is_of_key { -1.0 } else { seed.uniform(k as u64) };
    }
    ways.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut sets = DisjointSets::new(count);
    let mut kept = Vec::new();
    for (k, (_, a, b)) in ways.into_iter().enumerate() {
        if sets.join(a, b) || seed.with(1).uniform(k as u64) < share {
            kept.push([a, b]);
        }
    }
    kept.extend((1..keys as u32).filter(|&key| sets.join(0, key)).map(|key| [0, key]));
    let first = sets.root(0);
    kept.retain(|e| sets.root(e[0]) == first);
    kept
}
