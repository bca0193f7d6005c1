//! How drainage areas and stream lengths are distributed: the exponents of river networks.
//!
//! # Method
//! Over all nodes: β from P(A > a) ~ a^−β between 8 nodes and a twelfth of the greatest area; h from bin means of log L against
//! log A between 20 nodes and half of the greatest area (Hack's law); ψ from P(L > l) ~ l^−ψ between 5 node distances and a
//! quarter of the greatest length. L is the longest way upstream.
//!
//! # Sources
//! Rodriguez-Iturbe & Rinaldo (1997), *Fractal River Basins*; Hack (1957); Maritan et al. (1996) for ψ = β/h and β + h = 1. The ranges are
//! those of the validation notes (1.2), where finite size biases β by some hundredths: compare with objects of known exponents.
//!
//! # Checked by
//! `tests`: Scheidegger's and Peano's networks (DN9).

use serde::{Deserialize, Serialize};

use crate::algo::flow::{Flow, node_areas};
use crate::grid::Domain;
use crate::math;
use crate::terrain::NodeSurface;

/// Exponents of a river network.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct NetworkScaling {
    /// β: exceedance of drainage area.
    pub area_exponent: f64,
    /// h: Hack's exponent.
    pub hack_exponent: f64,
    /// ψ: exceedance of upstream length.
    pub length_exponent: f64,
}

/// The exponents of a terrain's network. **Cost** O(n log n).
pub fn network_scaling<T: NodeSurface>(terrain: &T) -> NetworkScaling {
    let domain = terrain.domain();
    let mut area = node_areas(&*domain);
    let cell = area.iter().sum::<f64>() / area.iter().filter(|a| **a > 0.0).count().max(1) as f64;
    let mut flow = Flow::new();
    flow.route(&*domain, terrain.elevation(), &mut area);
    let mut length = vec![0.0_f64; area.len()];
    for &i in flow.order() {
        let (i, r) = (i as usize, flow.receivers()[i as usize] as usize);
        if r != i {
            length[r] = length[r].max(length[i] + domain.distance(i, flow.slots()[i]));
        }
    }
    let inner: Vec<usize> = (0..area.len()).filter(|&i| flow.receivers()[i] as usize != i).collect();
    let pick = |values: &[f64], unit: f64| inner.iter().map(|&i| values[i] / unit).collect::<Vec<_>>();
    scaling(&pick(&area, cell), &pick(&length, cell.sqrt()))
}

/// The exponents of areas (in nodes) and upstream lengths (in node distances), one of each per node.
pub fn scaling(area: &[f64], length: &[f64]) -> NetworkScaling {
    let greatest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let (most, longest) = (greatest(area), greatest(length));
    NetworkScaling {
        area_exponent: exceedance(area, 8.0, most / 12.0),
        hack_exponent: hack(area, length, 20.0, most / 2.0),
        length_exponent: exceedance(length, 5.0, longest / 4.0),
    }
}

const BINS: usize = 24;

/// Exponent of P(V > v) ~ v^−e between two values.
fn exceedance(values: &[f64], from: f64, to: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let points: Vec<(f64, f64)> = (0..=BINS)
        .map(|k| math::log(from) + (math::log(to) - math::log(from)) * k as f64 / BINS as f64)
        .filter_map(|v| {
            let above = sorted.len() - sorted.partition_point(|s| *s <= math::exp(v));
            (above > 0).then(|| (v, math::log(above as f64 / sorted.len() as f64)))
        })
        .collect();
    -math::line_fit(points.iter().copied()).0
}

/// Exponent of L ~ A^h through means of logarithms in bins.
fn hack(area: &[f64], length: &[f64], from: f64, to: f64) -> f64 {
    let mut bins = [(0.0, 0.0, 0.0); BINS];
    let (lo, hi) = (math::log(from), math::log(to));
    for (a, l) in area.iter().zip(length) {
        let at = (math::log(*a) - lo) / (hi - lo) * BINS as f64;
        if *l > 0.0 && at >= 0.0 && at < BINS as f64 {
            let bin = &mut bins[at as usize];
            *bin = (bin.0 + math::log(*a), bin.1 + math::log(*l), bin.2 + 1.0);
        }
    }
    let means = bins.iter().filter(|b| b.2 >= 3.0).map(|b| (b.0 / b.2, b.1 / b.2));
    math::line_fit(means.collect::<Vec<_>>().into_iter()).0
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
        // Each link becomes a chain of two with two side links at the middle: (area, length) of all nodes, outlet last.
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
        // DN9. Scheidegger: 1/3, 2/3; Peano: 1/2, 1/2. ψ = β/h. Finite size raises β over the usual range by about 0.05.
        let (mut mean, mut short) = ([0.0; 3], 0.0);
        for seed in 1..=3 {
            let (area, length) = scheidegger(600, 500, seed);
            let s = scaling(&area, &length);
            let most = area.iter().copied().fold(0.0, f64::max);
            short += exceedance(&area, 8.0, most / 100.0) / 3.0;
            mean =
                [mean[0] + s.area_exponent / 3.0, mean[1] + s.hack_exponent / 3.0, mean[2] + s.length_exponent / 3.0];
        }
        assert!((short - 1.0 / 3.0).abs() < 0.03, "{short}");
        assert!((mean[0] - 1.0 / 3.0 - 0.05).abs() < 0.03 && (mean[1] - 2.0 / 3.0).abs() < 0.03, "{mean:?}");
        assert!((mean[2] - 0.5).abs() < 0.05, "{mean:?}");
        let (area, length) = peano(9);
        let s = scaling(&area, &length);
        assert!((s.area_exponent - 0.5).abs() < 0.05 && (s.hack_exponent - 0.5).abs() < 0.03, "{s:?}");
    }
}
