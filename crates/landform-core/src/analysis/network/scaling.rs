//! How drainage areas and stream lengths are distributed: the exponents of river networks.
//!
//! # Method
//! Over all nodes, by tenths of a decade. β from P(A ≥ a) ~ a^−β between 8 nodes and a twelfth (or
//! a hundredth) of the greatest area; h from bin means of log L against log A between 20 nodes and
//! half of the greatest area (Hack's law), bins with at least 10 nodes; ψ from P(L ≥ l) ~ l^−ψ
//! between 5 node distances and a quarter of the greatest length. L is the longest way upstream.
//!
//! # Sources
//! Rodriguez-Iturbe & Rinaldo (1997), *Fractal River Basins*; Hack (1957); Maritan et al. (1996)
//! for ψ = β/h and β + h = 1. Finite size raises β by about 0.045 (to a hundredth: 0.015 to 0.02):
//! compare with objects of known exponents.
//!
//! # Checked by
//! `tests`: Scheidegger's and Peano's networks (DN9).

use serde::{Deserialize, Serialize};

use crate::analysis::Drainage;
use crate::grid::{Domain, Status};
use crate::math;

/// Exponents of a river network; NaN where there are too few nodes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct NetworkScaling {
    /// Exponent β of the exceedance of drainage area.
    pub area_exponent: f64,
    /// Exponent β by areas up to a hundredth of the greatest: less bias by finite size.
    pub area_exponent_short: f64,
    /// h: Hack's exponent.
    pub hack_exponent: f64,
    /// R² of Hack's law through the bins.
    pub hack_r2: f64,
    /// Exponent ψ of the exceedance of upstream length.
    pub length_exponent: f64,
}

/// Areas in nodes and upstream lengths in node distances, one of each per node.
#[derive(Clone, Debug, Default)]
pub struct NetworkSizes {
    /// Drainage areas, the node's own included.
    pub area: Vec<f64>,
    /// Longest ways upstream, m; 0 at sources.
    pub length: Vec<f64>,
}

impl NetworkSizes {
    /// Of a routed terrain. **Cost** O(n).
    pub fn of<D: Domain>(drainage: &Drainage<D>) -> Self {
        let (domain, flow) = (&drainage.domain, &drainage.flow);
        let status = domain.status();
        let mut length = vec![0.0_f64; status.len()];
        for &i in flow.order() {
            let (i, r) = (i as usize, flow.receivers()[i as usize] as usize);
            if r != i {
                length[r] = length[r].max(length[i] + domain.distance(i, flow.slots()[i]));
            }
        }
        let valid = || (0..status.len()).filter(|&i| status[i] != Status::Masked);
        let cell = valid().map(|i| domain.area(i)).sum::<f64>() / valid().count().max(1) as f64;
        Self {
            area: valid().map(|i| drainage.area[i] / cell).collect(),
            length: valid().map(|i| length[i] / cell.sqrt()).collect(),
        }
    }
}

/// The exponents of a routed terrain's network. **Cost** O(n log n).
pub fn network_scaling<D: Domain>(drainage: &Drainage<D>) -> NetworkScaling {
    scaling(NetworkSizes::of(drainage))
}

/// The exponents of areas and lengths.
pub fn scaling(sizes: NetworkSizes) -> NetworkScaling {
    let NetworkSizes { mut area, mut length } = sizes;
    let greatest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let (most, longest) = (greatest(&area), greatest(&length));
    let (hack_exponent, hack_r2) = hack(&area, &length, 20.0, most / 2.0);
    crate::parallel::sort_by(&mut area, f64::total_cmp);
    crate::parallel::sort_by(&mut length, f64::total_cmp);
    NetworkScaling {
        area_exponent: exceedance(&area, 8.0, most / 12.0),
        area_exponent_short: exceedance(&area, 8.0, most / 100.0),
        hack_exponent,
        hack_r2,
        length_exponent: exceedance(&length, 5.0, longest / 4.0),
    }
}

/// The logarithms of tenths of a decade between two values.
fn tenths(from: f64, to: f64) -> impl Iterator<Item = f64> + Clone {
    let first = math::log10(from);
    let count = if to > from { (10.0 * (math::log10(to) - first) + 1e-9).floor() as usize + 1 } else { 0 };
    (0..count).map(move |k| first + 0.1 * k as f64)
}

/// Exponent of P(V ≥ v) ~ v^−e between two values of a sorted list.
fn exceedance(sorted: &[f64], from: f64, to: f64) -> f64 {
    let points: Vec<(f64, f64)> = tenths(from, to)
        .filter_map(|v| {
            let value = math::pow(10.0, v) * (1.0 - 1e-12);
            let above = sorted.len() - sorted.partition_point(|s| *s < value);
            (above > 0).then(|| (v, math::log10(above as f64 / sorted.len() as f64)))
        })
        .collect();
    -math::line_fit(points.iter().copied()).0
}

/// Exponent and R² of L ~ A^h through means of logarithms in bins.
fn hack(area: &[f64], length: &[f64], from: f64, to: f64) -> (f64, f64) {
    let count = tenths(from, to).count().saturating_sub(1);
    let mut bins = vec![(0.0, 0.0, 0usize); count];
    let first = math::log10(from);
    for (a, l) in area.iter().zip(length) {
        let at = 10.0 * (math::log10(*a) - first) + 1e-9;
        if *l > 0.0
            && at >= 0.0
            && let Some(bin) = bins.get_mut(at as usize)
        {
            *bin = (bin.0 + math::log10(*a), bin.1 + math::log10(*l), bin.2 + 1);
        }
    }
    let means = bins.iter().filter(|b| b.2 >= 10).map(|b| (b.0 / b.2 as f64, b.1 / b.2 as f64));
    let (slope, _, r2) = math::line_fit(means.collect::<Vec<_>>().into_iter());
    (slope, r2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Seed;

    /// Every node of a row drains to one of the two below it, at random; columns are periodic.
    fn scheidegger(rows: usize, cols: usize, seed: u64) -> (Vec<f64>, Vec<f64>) {
        let (mut area, mut length) = (vec![1.0; rows * cols], vec![0.0_f64; rows * cols]);
        for i in 0..(rows - 1) * cols {
            let (row, col) = (i / cols, i % cols);
            let right = Seed(seed).uniform(i as u64) < 0.5;
            let to = (row + 1) * cols + if right { col } else { (col + 1) % cols };
            area[to] += area[i];
            length[to] = length[to].max(length[i] + 1.0);
        }
        (area, length)
    }

    /// Peano's basin after so many generations: areas and lengths of its links.
    fn peano(generations: u32) -> (Vec<f64>, Vec<f64>) {
        // Each link becomes a chain of two with two side links at the middle: (area, length) of all
        // nodes, outlet last.
        fn grow(level: u32, above: (f64, f64), out: &mut Vec<(f64, f64)>) -> (f64, f64) {
            if level == 0 {
                let link = (above.0 + 1.0, above.1 + 1.0);
                out.push(link);
                return link;
            }
            let upper = grow(level - 1, above, out);
            let sides = [grow(level - 1, (0.0, 0.0), out), grow(level - 1, (0.0, 0.0), out)];
            let joined = (upper.0 + sides[0].0 + sides[1].0, upper.1.max(sides[0].1));
            grow(level - 1, joined, out)
        }
        let mut links = Vec::new();
        grow(generations, (0.0, 0.0), &mut links);
        links.into_iter().unzip()
    }

    #[test]
    fn the_exponents_of_known_networks_are_found() {
        // DN9. Scheidegger: 1/3, 2/3; Peano: 1/2, 1/2. ψ = β/h. Finite size raises β over the usual
        // range by about 0.05.
        let (mut mean, mut short) = ([0.0; 3], 0.0);
        for seed in 1..=3 {
            let (area, length) = scheidegger(600, 500, seed);
            let s = scaling(NetworkSizes { area, length });
            short += s.area_exponent_short / 3.0;
            mean =
                [mean[0] + s.area_exponent / 3.0, mean[1] + s.hack_exponent / 3.0, mean[2] + s.length_exponent / 3.0];
        }
        assert!((short - 1.0 / 3.0).abs() < 0.03, "{short}");
        assert!((mean[0] - 1.0 / 3.0 - 0.05).abs() < 0.03 && (mean[1] - 2.0 / 3.0).abs() < 0.03, "{mean:?}");
        assert!((mean[2] - 0.5).abs() < 0.05, "{mean:?}");
        let (area, length) = peano(9);
        let s = scaling(NetworkSizes { area, length });
        assert!((s.area_exponent - 0.5).abs() < 0.05 && (s.hack_exponent - 0.5).abs() < 0.03, "{s:?}");
    }
}
