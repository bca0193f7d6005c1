//! Shortest paths: the cheapest ways through random places in the rock, thinned to a gamma-graph.
//!
//! Paris et al. (2021), sections 4 and 5. A way between two keys is left out where the detour over
//! a third is cheaper by powers: d(i,k)^γ + d(k,j)^γ < d(i,j)^γ. Costs are per metre, so that they
//! do not depend on how many places there are.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

use landform_core::algo::DisjointSets;
use landform_core::terrain::Bounds;
use landform_core::{Error, Result, math, parallel};

use super::keys::Keys;
use super::near::Near;
use super::rock::Rock;
use super::space::{Skeleton, Vector, between, distance, dot, minus, plus, unit};

/// Power of the cost where none is given.
const GAMMA: f64 = 2.0;
/// Part of the way to the next places for which passages that met at one place stay together.
const TOGETHER: f64 = 0.5;
/// More places than this are refused.
const MOST_PLACES: f64 = 200_000.0;

/// Finds the network. Returns the node of each of the keys' ends.
///
/// # Errors
/// [`Error::Parameter`] for too many places.
pub(super) fn shortest(
    skeleton: &mut Skeleton,
    keys: &Keys,
    rock: &Rock<'_>,
    gamma: Option<f64>,
    loops: usize,
) -> Result<Vec<u32>> {
    let springs = skeleton.nodes.len();
    let mut places = skeleton.nodes.clone();
    places.extend(keys.ends());
    let count = places.len();
    scatter(&mut places, rock)?;
    let ways = Ways::new(&places, rock);
    let found: Vec<Search> = parallel::map(count, |key| ways.from(key as u32));
    let cost = |i: usize, j: usize| found[i.min(j)].far[i.max(j)];
    let power: Vec<f64> =
        (0..count * count).map(|k| math::pow(cost(k / count, k % count), gamma.unwrap_or(GAMMA))).collect();
    let is_direct = |i: usize, j: usize| {
        let p = power[i * count + j];
        p.is_finite() && (0..count).all(|k| k == i || k == j || power[i * count + k] + power[k * count + j] >= p)
    };
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
    let mut pairs: Vec<(f64, usize, usize)> =
        pairs.filter(|&(i, j)| is_direct(i, j)).map(|(i, j)| (power[i * count + j], i, j)).collect();
    if gamma.is_none() {
        pairs = with_loops(pairs, count, loops);
    }
    let mut used: BTreeSet<[u32; 2]> = BTreeSet::new();
    for (_, i, j) in pairs {
        let mut node = j as u32;
        while found[i].before[node as usize] != u32::MAX {
            let before = found[i].before[node as usize];
            used.insert([node.min(before), node.max(before)]);
            node = before;
        }
    }
    let mut number: BTreeMap<u32, u32> = (0..springs as u32).map(|n| (n, n)).collect();
    for key in springs..count {
        number.insert(key as u32, skeleton.node(places[key]));
    }
    for &[a, b] in &used {
        let ends = [a, b].map(|n| *number.entry(n).or_insert_with(|| skeleton.node(places[n as usize])));
        skeleton.edges.push(ends);
    }
    spread(skeleton);
    smooth(skeleton, count, rock);
    Ok((springs..count).map(|k| k as u32).collect())
}

/// The cheapest ways that hold all keys together, and the cheapest others, as many as loops are
/// wanted.
fn with_loops(mut pairs: Vec<(f64, usize, usize)>, count: usize, loops: usize) -> Vec<(f64, usize, usize)> {
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut sets = DisjointSets::new(count);
    let mut left = loops;
    pairs.retain(|&(_, i, j)| {
        let were_apart = sets.join(i as u32, j as u32);
        let is_loop = !were_apart && left > 0;
        left -= usize::from(is_loop);
        were_apart || is_loop
    });
    pairs
}

/// Random places around the water table, one a cell.
fn scatter(places: &mut Vec<Vector>, rock: &Rock<'_>) -> Result<()> {
    let cell = [2.5 * rock.step, 2.5 * rock.step, 1.25 * rock.step];
    let Bounds { low, high } = Bounds::around(places);
    let from = [rock.bounds[0][0], rock.bounds[0][1], low[2] - cell[2]];
    let to = [rock.bounds[1][0], rock.bounds[1][1], high[2] + cell[2]];
    let counts = [0, 1, 2].map(|k| ((to[k] - from[k]) / cell[k]).ceil().max(1.0));
    let all: f64 = counts.iter().product();
    if all > MOST_PLACES {
        let expected = format!("steps that make at most {MOST_PLACES} places");
        return Err(Error::parameter("step", format!("{} m: {all:.0} places", rock.step), &expected));
    }
    let counts = counts.map(|c| c as u64);
    let seed = rock.seed.named("places");
    for i in 0..counts.iter().product::<u64>() {
        let cell_at = [i % counts[0], i / counts[0] % counts[1], i / (counts[0] * counts[1])];
        let part = [0, 1, 2].map(|k| cell_at[k] as f64 + seed.uniform(3 * i + k as u64));
        let at = [0, 1, 2].map(|k| from[k] + part[k] * cell[k]);
        if rock.holds(at) {
            places.push(at);
        }
    }
    Ok(())
}

/// Ways between places and what they cost.
struct Ways {
    ways: Vec<Vec<(u32, f64)>>,
}

/// Costs from a place, and the place before each on the cheapest way.
#[derive(Clone, Default)]
struct Search {
    far: Vec<f64>,
    before: Vec<u32>,
}

impl Ways {
    fn new(places: &[Vector], rock: &Rock<'_>) -> Self {
        let reach = 5.0 * rock.step;
        let near = Near::new(places, reach);
        let of = |i: usize| {
            let others = near.within(places[i], reach).into_iter().filter(|&j| j as usize != i);
            others
                .filter(|&j| rock.is_clear(places[i], places[j as usize], rock.step))
                .map(|j| {
                    // The same either way.
                    let (a, b) = (i.min(j as usize), i.max(j as usize));
                    (j, rock.cost(places[a], places[b]))
                })
                .collect::<Vec<_>>()
        };
        let mut ways = parallel::map(places.len(), of);
        // A place without others around it is joined to the nearest of all.
        for i in 0..places.len() {
            if ways[i].is_empty() {
                let far = |j: &usize| distance(places[*j], places[i]);
                let others = (0..places.len()).filter(|j| *j != i);
                if let Some(j) = others.min_by(|a, b| far(a).total_cmp(&far(b))) {
                    let cost = rock.cost(places[i.min(j)], places[i.max(j)]);
                    ways[i].push((j as u32, cost));
                    ways[j].push((i as u32, cost));
                }
            }
        }
        Self { ways }
    }

    /// Dijkstra's search.
    fn from(&self, source: u32) -> Search {
        let n = self.ways.len();
        let mut search = Search { far: vec![f64::INFINITY; n], before: vec![u32::MAX; n] };
        search.far[source as usize] = 0.0;
        // Costs are not negative: their bits are in their order.
        let mut heap = BinaryHeap::from([Reverse((0_u64, source))]);
        while let Some(Reverse((bits, node))) = heap.pop() {
            let far = f64::from_bits(bits);
            if far > search.far[node as usize] {
                continue;
            }
            for &(to, cost) in &self.ways[node as usize] {
                let next = far + cost;
                if next < search.far[to as usize] {
                    search.far[to as usize] = next;
                    search.before[to as usize] = node;
                    heap.push(Reverse((next.to_bits(), to)));
                }
            }
        }
        search
    }
}

/// Leads passages that meet at one place together in pairs before it, so that no more than three
/// meet: those first between which the angle is the least.
fn spread(skeleton: &mut Skeleton) {
    let mut at: Vec<Vec<usize>> = vec![Vec::new(); skeleton.nodes.len()];
    for (e, ends) in skeleton.edges.iter().enumerate() {
        ends.iter().for_each(|&n| at[n as usize].push(e));
    }
    for (node, mut edges) in at.into_iter().enumerate() {
        let node = node as u32;
        while edges.len() > 3 {
            let here = skeleton.nodes[node as usize];
            let far_end = |e: usize| skeleton.edges[e].iter().sum::<u32>() - node;
            let way = |e: usize| minus(skeleton.nodes[far_end(e) as usize], here);
            let pairs = (0..edges.len()).flat_map(|i| (i + 1..edges.len()).map(move |j| (i, j)));
            let alike = |&(i, j): &(usize, usize)| dot(unit(way(edges[i])), unit(way(edges[j])));
            let Some((i, j)) = pairs.max_by(|a, b| alike(a).total_cmp(&alike(b))) else { break };
            let (a, b) = (edges[i], edges[j]);
            let to = between(here, between(plus(here, way(a), 1.0), plus(here, way(b), 1.0), 0.5), TOGETHER);
            let fork = skeleton.node(to);
            for e in [a, b] {
                let end = skeleton.edges[e].iter().position(|n| *n == node).unwrap_or(0);
                skeleton.edges[e][end] = fork;
            }
            edges.retain(|e| *e != a && *e != b);
            edges.push(skeleton.edges.len());
            skeleton.edges.push([node, fork]);
        }
    }
}

/// Takes the corners off passages between forks; the first `keys` nodes stay.
fn smooth(skeleton: &mut Skeleton, keys: usize, rock: &Rock<'_>) {
    let joined = skeleton.joined();
    let before = skeleton.nodes.clone();
    for (i, others) in joined.iter().enumerate().skip(keys) {
        if let [a, b] = others[..] {
            let middle = between(before[a as usize], before[b as usize], 0.5);
            let to = between(before[i], middle, 0.5);
            if [a, b].iter().all(|n| rock.is_clear(to, skeleton.nodes[*n as usize], rock.step)) {
                skeleton.nodes[i] = to;
            }
        }
    }
}
