//! Protochannels: where water seeps from its inlets before it has found a way out.
//!
//! # Method
//! Pytel, section 5.2.1. Each inlet has the zone that is nearer to it than to others by the way
//! through the rock, over its pressure (the thesis measures straight; a way feels barriers). On the
//! border of the zone stand protosinks. The greatest flow from the inlet to them fills the widest
//! ways first; channels follow it back from each protosink.

use std::collections::VecDeque;

use landform_core::algo::lattice::{FACES, Lattice, MaxFlow, NEIGHBOURS, lower};
use landform_core::random::Seed;

use super::growth::Rock;

/// A zone that is nobody's: as near to one inlet as to another.
pub(super) const CONTESTED: u8 = u8::MAX;
/// Voxels around an inlet in which nothing is narrow.
const AROUND: usize = 2;

/// Zones: 1 for the first inlet, and so on; stored as the lattice says, 0 in its border.
pub(super) fn zones(lattice: &Lattice, rock: &Rock, inlets: &[(Vec<usize>, f64)]) -> Vec<u8> {
    let highest = inlets.iter().map(|i| i.1).fold(0.0, f64::max);
    let mut best = vec![u32::MAX; lattice.stored()];
    let mut zones = vec![0; lattice.stored()];
    for (number, (voxels, pressure)) in (1..).zip(inlets) {
        let weight = (4096.0 * highest / pressure) as f32;
        let slopes: Vec<f32> = rock.permeability.iter().map(|k| if *k > 0.0 { weight / k } else { 0.0 }).collect();
        let mut way = lattice.padded(std::iter::repeat_n(u32::MAX, lattice.stored()), 0);
        voxels.iter().for_each(|&i| way[i] = 0);
        lower(lattice, &mut way, &slopes, voxels);
        for i in lattice.voxels() {
            if way[i] < best[i] {
                (best[i], zones[i]) = (way[i], number);
            } else if way[i] == best[i] {
                zones[i] = CONTESTED;
            }
        }
    }
    zones
}

/// What is asked of protochannels.
pub(super) struct Wanted {
    /// Protosinks of each zone.
    pub(super) count: usize,
    /// Part of them that stand where the zone is nearest to an outlet or to another zone.
    pub(super) clustered: f64,
    pub(super) seed: Seed,
}

/// Whether each stored voxel is in a protochannel.
pub(super) fn protochannels(
    lattice: &Lattice,
    rock: &Rock,
    zones: &[u8],
    inlets: &[(Vec<usize>, f64)],
    outlets: &[usize],
    wanted: &Wanted,
) -> Vec<bool> {
    let mut sinks = Vec::new();
    for number in 1..=inlets.len() as u8 {
        let border = border(lattice, zones, number, &inlets[usize::from(number) - 1].0);
        sinks.extend(choose(lattice, &border, outlets, wanted, number));
    }
    let sources: Vec<usize> = inlets.iter().flat_map(|i| i.0.iter().copied()).collect();
    sinks.retain(|i| !sources.contains(i));
    let capacity = capacities(lattice, rock, &sources, &sinks);
    let flow = MaxFlow::widest_first(lattice, &capacity, zones, &sources, &sinks);
    follow_back(lattice, &flow, &sources, &sinks)
}

/// What voxels let through: pores times permeability. Protosinks take as much as a wide voxel, so
/// that the widest ways to them fill first; around an inlet, where all ways begin, nothing is
/// narrow, so that the nearest protosinks do not take all.
fn capacities(lattice: &Lattice, rock: &Rock, sources: &[usize], sinks: &[usize]) -> Vec<u16> {
    let let_through = |i: usize| rock.porosity[i] as f32 / (1 << 24) as f32 * rock.permeability[i];
    let mut all: Vec<f32> = lattice.voxels().map(let_through).collect();
    all.sort_by(f32::total_cmp);
    let wide = all[all.len() * 9 / 10].max(1e-9);
    // A wide voxel has a sixteenth of the most.
    let scale = f32::from(MaxFlow::MOST / 16) / wide;
    let mut capacity = vec![0; lattice.stored()];
    lattice.voxels().for_each(|i| capacity[i] = ((let_through(i) * scale) as u16).clamp(1, MaxFlow::MOST));
    for &source in sources {
        let at = lattice.place(source);
        let range = |k: usize| at[k].saturating_sub(AROUND)..(at[k] + AROUND + 1).min(lattice.size()[k]);
        for (z, y) in range(2).flat_map(|z| range(1).map(move |y| (z, y))) {
            range(0).for_each(|x| capacity[lattice.at([x, y, z])] = MaxFlow::MOST);
        }
    }
    sinks.iter().for_each(|&i| capacity[i] = MaxFlow::MOST / 16);
    capacity
}

/// Voxels of a zone beside another zone or at the side of the box, its inlet excepted.
fn border(lattice: &Lattice, zones: &[u8], number: u8, inlet: &[usize]) -> Vec<usize> {
    let is_border = |i: usize| FACES.iter().any(|&k| zones[lattice.neighbour(i, k)] != number);
    lattice.voxels().filter(|&i| zones[i] == number && is_border(i) && !inlet.contains(&i)).collect()
}

/// Some of a zone's border: those in a cluster nearest to the outlets, others far from each other.
fn choose(lattice: &Lattice, border: &[usize], outlets: &[usize], wanted: &Wanted, number: u8) -> Vec<usize> {
    let square = |a: usize, b: usize| {
        let (a, b) = (lattice.place(a), lattice.place(b));
        (0..3)
            .map(|k| {
                let d = (a[k] as f64 - b[k] as f64) * lattice.sides()[k];
                d * d
            })
            .sum::<f64>()
    };
    let seed = wanted.seed.with(u64::from(number));
    let mut chosen: Vec<usize> = Vec::new();
    let clustered = (wanted.count as f64 * wanted.clustered).round() as usize;
    // Distances to the nearest outlet, from a few of them spread over their voxels.
    let stride = outlets.len().div_ceil(64).max(1);
    let to_outlet = |i: usize| outlets.iter().step_by(stride).map(|&o| square(i, o)).fold(f64::INFINITY, f64::min);
    let mut by_distance: Vec<(f64, usize)> = border.iter().map(|&i| (to_outlet(i), i)).collect();
    by_distance.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    // Drawn from the nearest tenth, so that they do not all stand in one corner.
    let nearest = &by_distance[..by_distance.len().div_ceil(10).min(by_distance.len())];
    for k in 0..clustered.min(nearest.len()) {
        let drawn = nearest[((seed.uniform(k as u64) * nearest.len() as f64) as usize).min(nearest.len() - 1)].1;
        chosen.push(drawn);
    }
    // Then always the one farthest from those that stand, of some that are drawn.
    for k in chosen.len()..wanted.count.min(border.len()) {
        let drawn =
            |j: u64| border[((seed.with(k as u64).uniform(j) * border.len() as f64) as usize).min(border.len() - 1)];
        let apart = |i: usize| chosen.iter().map(|&c| square(i, c)).fold(f64::INFINITY, f64::min);
        let far = (0..24).map(drawn).max_by(|&a, &b| apart(a).total_cmp(&apart(b)).then(b.cmp(&a)));
        chosen.extend(far);
    }
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

/// The ways of the flow, from each sink back to a source.
fn follow_back(lattice: &Lattice, flow: &MaxFlow, sources: &[usize], sinks: &[usize]) -> Vec<bool> {
    let none = usize::MAX;
    let mut from = vec![none; lattice.stored()];
    let mut queue: VecDeque<usize> = sources.iter().copied().collect();
    sources.iter().for_each(|&i| from[i] = i);
    while let Some(i) = queue.pop_front() {
        for k in (0..NEIGHBOURS).filter(|&k| flow.to(i, k) > 0) {
            let to = lattice.neighbour(i, k);
            if from[to] == none {
                from[to] = i;
                queue.push_back(to);
            }
        }
    }
    let mut channel = vec![false; lattice.stored()];
    for &sink in sinks.iter().filter(|&&i| from[i] != none) {
        let mut at = sink;
        while !std::mem::replace(&mut channel[at], true) && from[at] != at {
            at = from[at];
        }
    }
    sources.iter().for_each(|&i| channel[i] = true);
    channel
}
