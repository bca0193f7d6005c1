//! Fast marching: fronts that only advance, and the distances that they measure.
//!
//! # Model
//! |∇T| F = 1: T is the time at which a front arrives that starts at the seeds with speed F.
//!
//! # Method
//! The site with the least time among those beside the front is accepted next; its neighbours'
//! times are recomputed from accepted sites alone, by one-sided differences of first or second
//! order. Where the largest of the upwind times turns out later than the result, that axis is left
//! out. Distances start from an exact ball around each seed, without which the first cells spoil
//! the rest. A heap with lazy duplicates; ties go to the lower index. **Cost** O(n log n).
//!
//! # Sources
//! Sethian (1996); Sethian (1999) for the second order; Pytel (2015), listing A.6, whose T = d/F
//! leaves out the quadratic.
//!
//! # Checked by
//! `tests`: |∇T| F = 1, distances against Euclid's, order of convergence, Dijkstra's as a custom
//! update.
//!
//! # Example
//! Where a front is twice as fast, it takes half the time:
//!
//! ```
//! use landform_core::algo::fast_marching::{Order, arrival};
//! use landform_core::grid::Lattice;
//!
//! let line = Lattice::new([5, 1, 1], [1.0, 1.0, 1.0])?;
//! let time = arrival(&line, &[0], &[1.0, 1.0, 2.0, 2.0, 2.0], Order::First);
//! assert_eq!(time, [0.0, 1.0, 1.5, 2.0, 2.5]);
//! # Ok::<(), landform_core::Error>(())
//! ```

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::grid::Lattice;
use crate::math::ordered_bits;

/// Order of the differences.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// First.
    First,
    /// Second where two accepted sites lie behind each other, else first.
    Second,
}

/// Times of arrival while a front marches.
#[derive(Debug)]
pub struct Front<'a> {
    lattice: &'a Lattice,
    time: &'a [f64],
    accepted: &'a [bool],
}

impl Front<'_> {
    /// Time (s) of a site if it was accepted.
    #[inline]
    pub fn at(&self, site: usize) -> Option<f64> {
        self.accepted[site].then_some(self.time[site])
    }

    /// The accepted neighbours (along the axes) of a site: time (s) and distance (m).
    pub fn behind(&self, site: usize) -> impl Iterator<Item = (f64, f64)> {
        let place = self.lattice.place(site);
        faces().filter_map(move |(axis, by)| {
            let near = self.lattice.moved(place, by)?;
            Some((self.at(near)?, self.lattice.spacing[axis]))
        })
    }

    /// When a front of this slowness (1 / speed, s/m) arrives at a site, from its accepted
    /// neighbours; infinite if it has none.
    pub fn eikonal(&self, site: usize, slowness: f64, order: Order) -> f64 {
        let place = self.lattice.place(site);
        // Per axis: weight and origin of (T - origin)^2 * weight.
        let mut terms = [(0.0, f64::INFINITY); 3];
        for (axis, by) in faces() {
            let Some(t) = self.lattice.moved(place, by).and_then(|near| self.at(near)) else { continue };
            let h = self.lattice.spacing[axis];
            let term = match self.lattice.moved(place, by.map(|b| 2 * b)).and_then(|far| self.at(far)) {
                Some(far) if order == Order::Second && far <= t => (2.25 / (h * h), (4.0 * t - far) / 3.0),
                _ => (1.0 / (h * h), t),
            };
            if term.1 < terms[axis].1 {
                terms[axis] = term;
            }
        }
        terms.sort_by(|a, b| a.1.total_cmp(&b.1));
        let mut used = terms.iter().filter(|t| t.1.is_finite()).count();
        while used > 0 {
            let (a, b, c) = terms[..used]
                .iter()
                .fold((0.0, 0.0, -slowness * slowness), |(a, b, c), &(w, t)| (a + w, b + w * t, c + w * t * t));
            let discriminant = b * b - a * c;
            let root = (b + discriminant.max(0.0).sqrt()) / a;
            if discriminant >= 0.0 && root >= terms[used - 1].1 {
                return root;
            }
            used -= 1;
        }
        f64::INFINITY
    }
}

fn faces() -> impl Iterator<Item = (usize, [i64; 3])> {
    (0..6).map(|k| {
        let mut by = [0; 3];
        by[k / 2] = if k % 2 == 0 { -1 } else { 1 };
        (k / 2, by)
    })
}

/// Marches from seeds (site, time in s). `update` gives the time of a site from the front so far;
/// infinite keeps the front out. Sites that it never reaches stay infinite. `accept` sees every
/// site in order of time.
pub fn march(
    lattice: &Lattice,
    seeds: impl IntoIterator<Item = (usize, f64)>,
    mut update: impl FnMut(&Front, usize) -> f64,
    mut accept: impl FnMut(usize, f64),
) -> Vec<f64> {
    let mut time = vec![f64::INFINITY; lattice.len()];
    let mut accepted = vec![false; lattice.len()];
    let mut heap = BinaryHeap::new();
    for (site, t) in seeds {
        if t < time[site] {
            time[site] = t;
            heap.push(Reverse((ordered_bits(t), site)));
        }
    }
    while let Some(Reverse((_, site))) = heap.pop() {
        if std::mem::replace(&mut accepted[site], true) {
            continue;
        }
        accept(site, time[site]);
        let place = lattice.place(site);
        for (_, by) in faces() {
            let Some(near) = lattice.moved(place, by).filter(|&n| !accepted[n]) else { continue };
            let t = update(&Front { lattice, time: &time, accepted: &accepted }, near);
            if t < time[near] {
                time[near] = t;
                heap.push(Reverse((ordered_bits(t), near)));
            }
        }
    }
    time
}

/// Distance of every site to the nearest seed, m.
pub fn distance(lattice: &Lattice, seeds: &[usize], order: Order) -> Vec<f64> {
    distance_within(lattice, seeds, order, |_| true)
}

/// Distance (m) to the nearest seed along paths through sites that `open` lets in; infinite where
/// there is none.
pub fn distance_within(lattice: &Lattice, seeds: &[usize], order: Order, open: impl Fn(usize) -> bool) -> Vec<f64> {
    let start = exact_ball(lattice, seeds, &open);
    march(lattice, start, |f, i| if open(i) { f.eikonal(i, 1.0, order) } else { f64::INFINITY }, |_, _| {})
}

/// Exact distances within a few sites of the seeds.
fn exact_ball(lattice: &Lattice, seeds: &[usize], open: impl Fn(usize) -> bool) -> Vec<(usize, f64)> {
    const REACH: i64 = 2;
    let reach = |axis: usize| if lattice.size[axis] > 1 { REACH } else { 0 };
    let mut start = Vec::new();
    for &seed in seeds {
        let place = lattice.place(seed);
        for dz in -reach(2)..=reach(2) {
            for dy in -reach(1)..=reach(1) {
                for dx in -reach(0)..=reach(0) {
                    let d = [dx, dy, dz]
                        .iter()
                        .zip(lattice.spacing)
                        .map(|(&d, h)| (d as f64 * h) * (d as f64 * h))
                        .sum::<f64>()
                        .sqrt();
                    if let Some(site) = lattice
                        .moved(place, [dx, dy, dz])
                        .filter(|&s| s == seed || (in_sight(lattice, place, [dx, dy, dz], &open) && open(s)))
                    {
                        start.push((site, d));
                    }
                }
            }
        }
    }
    start
}

/// Whether the sites on the way to a site of the ball are open too, so that the ball does not look
/// through walls.
fn in_sight(lattice: &Lattice, place: [usize; 3], by: [i64; 3], open: impl Fn(usize) -> bool) -> bool {
    let longest = by.iter().map(|b| b.abs()).max().unwrap_or(0);
    longest < 2
        || (0..8).all(|corner| {
            // Halves rounded either way.
            let half = std::array::from_fn(|axis| {
                if corner >> axis & 1 == 0 { by[axis].div_euclid(2) } else { (by[axis] + 1).div_euclid(2) }
            });
            lattice.moved(place, half).is_some_and(&open)
        })
}

/// Time of arrival at every site of a front that starts at the seeds; `speed` in m per unit of
/// time, 0 keeps it out.
pub fn arrival(lattice: &Lattice, seeds: &[usize], speed: &[f64], order: Order) -> Vec<f64> {
    let start = seeds.iter().map(|&s| (s, 0.0));
    march(
        lattice,
        start,
        |f, i| if speed[i] > 0.0 { f.eikonal(i, 1.0 / speed[i], order) } else { f64::INFINITY },
        |_, _| {},
    )
}

/// Signed distance to the surface where `level` is 0, m: positive where `level` is. Beside the
/// surface it follows from `level` along the axes; infinite everywhere if there is no surface.
pub fn signed_distance(lattice: &Lattice, level: &[f64], order: Order) -> Vec<f64> {
    let inside = |i: usize| level[i] > 0.0;
    let mut beside = Vec::new();
    for i in 0..lattice.len() {
        let place = lattice.place(i);
        let mut nearest = [f64::INFINITY; 3];
        for (axis, by) in faces() {
            if let Some(j) = lattice.moved(place, by).filter(|&j| inside(j) != inside(i)) {
                let part = level[i] / (level[i] - level[j]);
                nearest[axis] = nearest[axis].min(part.clamp(0.0, 1.0) * lattice.spacing[axis]);
            }
        }
        // The plane through the crossings along the axes.
        let sum: f64 = nearest.iter().filter(|d| d.is_finite()).map(|d| 1.0 / (d * d).max(1e-300)).sum();
        if sum > 0.0 {
            beside.push((i, 1.0 / sum.sqrt()));
        }
    }
    let of_side = |side: bool| {
        let start = beside.iter().copied().filter(|&(i, _)| inside(i) == side);
        march(
            lattice,
            start,
            |f, i| if inside(i) == side { f.eikonal(i, 1.0, order) } else { f64::INFINITY },
            |_, _| {},
        )
    };
    let (within, without) = (of_side(true), of_side(false));
    (0..lattice.len()).map(|i| if inside(i) { within[i] } else { -without[i] }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(n: usize, h: f64) -> Lattice {
        Lattice::new([n, n, 1], [h, h, 1.0]).unwrap()
    }

    fn error(n: usize, order: Order) -> f64 {
        let h = 1.0 / n as f64;
        let lattice = square(n, h);
        let seed = lattice.site([n / 2, n / 2, 0]);
        let d = distance(&lattice, &[seed], order);
        let exact = |i: usize| lattice.offset(seed, i).iter().map(|v| v * v).sum::<f64>().sqrt();
        (0..d.len()).map(|i| (d[i] - exact(i)).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn distances_come_near_euclids_as_cells_get_smaller() {
        let (coarse, fine) = (error(41, Order::First), error(161, Order::First));
        assert!(fine < 0.012 && fine < 0.5 * coarse, "{coarse} {fine}");
        let second = error(161, Order::Second);
        assert!(second < 0.25 * fine, "{second} {fine}");
    }

    #[test]
    fn the_gradient_of_arrival_times_speed_is_one() {
        let n = 81;
        let lattice = square(n, 1.0);
        let speed: Vec<f64> = (0..n * n).map(|i| 1.0 + (i % n) as f64 / n as f64).collect();
        let seeds: Vec<usize> = (0..n).map(|r| r * n).collect();
        let t = arrival(&lattice, &seeds, &speed, Order::First);
        // T along x is the sum of 1/F.
        let exact: f64 = (1..n).map(|c| 1.0 / speed[c]).sum();
        assert!((t[n - 1] - exact).abs() < 1e-9);
        let walled: Vec<f64> = (0..n * n).map(|i| if i % n == 40 && i / n != 3 { 0.0 } else { 1.0 }).collect();
        let t = arrival(&lattice, &[0], &walled, Order::Second);
        assert!(t[40 + n * 9].is_infinite() && t[n * n - 1] > t[n - 1]);
    }

    #[test]
    fn a_custom_update_turns_the_march_into_dijkstras() {
        let lattice = Lattice::new([7, 6, 5], [1.0; 3]).unwrap();
        let mut seen = Vec::new();
        let update = |f: &Front, i: usize| f.behind(i).map(|(t, h)| t + h).fold(f64::INFINITY, f64::min);
        let steps = march(&lattice, [(0, 0.0)], update, |_, t| seen.push(t));
        for (i, t) in steps.iter().enumerate() {
            assert_eq!(*t, lattice.place(i).iter().sum::<usize>() as f64);
        }
        assert!(seen.is_sorted() && seen.len() == lattice.len());
    }

    #[test]
    fn signed_distance_of_a_sphere_and_around_periodic_sides() {
        let n = 41;
        let lattice = Lattice::new([n, n, n], [0.5; 3]).unwrap();
        let centre = lattice.site([20, 20, 20]);
        let level: Vec<f64> = (0..lattice.len())
            .map(|i| 5.0 - lattice.offset(centre, i).iter().map(|v| v * v).sum::<f64>().sqrt())
            .collect();
        let d = signed_distance(&lattice, &level, Order::Second);
        let worst = (0..d.len()).map(|i| (d[i] - level[i]).abs()).fold(0.0, f64::max);
        assert!(worst < 0.5, "{worst}");
        let ring = Lattice { periodic: [true, false, false], ..Lattice::new([10, 1, 1], [2.0, 1.0, 1.0]).unwrap() };
        assert_eq!(distance(&ring, &[9], Order::First)[..3], [2.0, 4.0, 6.0]);
    }
}
