//! Level ground: flow away from higher ground, towards the drain.
//!
//! Nodes without a lower neighbour but with an equal one form flats. Each node of a flat is raised
//! by a few units of the last place (of 1 m below 1 m): two for every step to the nearest node that
//! drains, and one for every step by which it is nearer to higher ground than the flat's middle.
//! Descent over the raised surface gathers water in the middle of flats and leads it out. A flat
//! that drains nowhere (the floor of a pit) is led to its middle, where the pit then is (to its
//! first node, if nothing around is higher). Where the next higher ground is nearer than what a
//! flat would be raised by, equal nodes are ordered by their numbers, as all remaining ties are.
//!
//! # Sources
//! Garbrecht & Martz (1997); Barnes, Lehman & Mulla (2014b), which weighs the two gradients 2 : 1.

use std::ops::Range;

use super::pits::without_receiver;
use crate::grid::{Domain, NO_SLOT, Status};
use crate::parallel;

/// The surface with its flats tilted, by a few units of the last place; none if there are
/// none. **Cost** O(n).
pub fn tilt_flats<D: Domain>(domain: &D, elevation: &[f64]) -> Option<Vec<f64>> {
    let (mut receiver, mut slot) = (vec![0; elevation.len()], vec![0; elevation.len()]);
    domain.steepest_descent(elevation, &mut receiver, &mut slot);
    let mut flats = Flats::default();
    flats.tilt(domain, elevation, &without_receiver(domain, &slot), &slot).then_some(flats.tilted)
}

/// Buffers that are kept from step to step: most steps find a few flats, and fresh memory would
/// cost more than they do.
#[derive(Clone, Debug, Default)]
pub(super) struct Flats {
    is_level: Vec<bool>,
    to_rise: Vec<u32>,
    to_drain: Vec<u32>,
    flat: Vec<u32>,
    /// The surface with its flats tilted.
    pub(super) tilted: Vec<f64>,
    /// Nodes of flats: all that may differ from the surface.
    pub(super) level: Vec<usize>,
}

impl Flats {
    /// Tilts the flats of a surface; whether there are any. `slot` is what steepest descent gave,
    /// `pits` where it ends. **Cost** O(n) once to copy the surface, else O(pits).
    pub(super) fn tilt<D: Domain>(&mut self, domain: &D, elevation: &[f64], pits: &[usize], slot: &[u8]) -> bool {
        let equals = |i: usize| domain.neighbours(i).map(|l| l.to).filter(move |&j| elevation[j] == elevation[i]);
        // No neighbour of a pit is lower.
        let is_level = |i: usize| domain.lowest(elevation, i).is_some_and(|(to, _)| elevation[to] == elevation[i]);
        let level = |piece: Range<usize>| pits[piece].iter().copied().filter(|&i| is_level(i)).collect();
        self.level = parallel::map_pieces::<Vec<usize>>(pits.len(), level).concat();
        if self.level.is_empty() {
            return false;
        }
        if self.is_level.len() != elevation.len() {
            let n = elevation.len();
            *self = Self { level: std::mem::take(&mut self.level), ..Self::default() };
            (self.is_level, self.to_rise, self.to_drain, self.flat) =
                (vec![false; n], vec![0; n], vec![0; n], vec![0; n]);
        }
        self.tilted.clear();
        self.tilted.extend_from_slice(elevation);
        let Self { is_level, to_rise, to_drain, flat, tilted, level } = self;
        level.iter().for_each(|&i| is_level[i] = true);
        let joined = |i: usize, j: usize| is_level[j] && elevation[i] == elevation[j];
        let rises = |i: &usize| domain.neighbours(*i).any(|l| elevation[l.to] > elevation[*i]);
        let drains = |i: &usize| equals(*i).any(|j| slot[j] != NO_SLOT || domain.status()[j] == Status::BaseLevel);
        spread_steps(domain, joined, level.iter().copied().filter(rises), to_rise);
        spread_steps(domain, joined, level.iter().copied().filter(drains), to_drain);
        for &first in level.iter() {
            if flat[first] == 0 {
                let nodes = spread_steps(domain, joined, std::iter::once(first), flat);
                lead_to_middle(domain, joined, &nodes, to_rise, to_drain);
                raise(domain, &nodes, elevation, |i| fall(to_drain[i], to_rise[i]), tilted);
            }
        }
        for &i in level.iter() {
            (is_level[i], to_rise[i], to_drain[i], flat[i]) = (false, 0, 0, 0);
        }
        true
    }
}

/// Twice the steps to the drain less the steps to higher ground (and a constant): falls by at least
/// one with a step towards the drain.
pub fn fall(to_drain: u32, to_rise: u32) -> u32 {
    (1 << 30) + 2 * to_drain - to_rise
}

/// Counts steps from the nearest of some nodes, which count 1, over nodes that are `joined`;
/// `steps` has one value per node, 0 where the count has not come. Returns the nodes reached,
/// nearest first. **Cost** O(nodes reached).
pub fn spread_steps<D: Domain>(
    domain: &D,
    joined: impl Fn(usize, usize) -> bool,
    from: impl Iterator<Item = usize>,
    steps: &mut [u32],
) -> Vec<u32> {
    let mut reached: Vec<u32> = from.map(|i| i as u32).collect();
    reached.iter().for_each(|&i| steps[i as usize] = 1);
    let mut next = 0;
    while next < reached.len() {
        let i = reached[next] as usize;
        next += 1;
        for l in domain.neighbours(i).filter(|l| joined(i, l.to)) {
            if steps[l.to] == 0 {
                steps[l.to] = steps[i] + 1;
                reached.push(l.to as u32);
            }
        }
    }
    reached
}

/// Lets a flat without a drain end in its middle.
fn lead_to_middle<D: Domain>(
    domain: &D,
    joined: impl Fn(usize, usize) -> bool,
    flat: &[u32],
    to_rise: &[u32],
    to_drain: &mut [u32],
) {
    if flat.iter().all(|&i| to_drain[i as usize] == 0) {
        let middle = flat.iter().map(|&i| i as usize).max_by_key(|&i| (to_rise[i], std::cmp::Reverse(i)));
        spread_steps(domain, joined, middle.into_iter(), to_drain);
    }
}

/// Raises a flat, if it stays below all that is higher.
fn raise<D: Domain>(domain: &D, flat: &[u32], elevation: &[f64], fall: impl Fn(usize) -> u32, tilted: &mut [f64]) {
    let nodes = || flat.iter().map(|&i| i as usize);
    let falls = || nodes().map(&fall);
    let (Some(first), Some(least), Some(most)) = (nodes().next(), falls().min(), falls().max()) else { return };
    let z = elevation[first];
    let raised = |fall: u32| z + f64::EPSILON * z.abs().max(1.0) * f64::from(fall - least + 1);
    let higher = nodes().flat_map(|i| domain.neighbours(i)).map(|l| elevation[l.to]).filter(|&h| h > z);
    if raised(most) < higher.fold(f64::INFINITY, f64::min) {
        nodes().for_each(|i| tilted[i] = raised(fall(i)));
    }
}
