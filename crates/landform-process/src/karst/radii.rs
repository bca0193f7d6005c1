//! Radii from the water that passages carry.
//!
//! Water enters at sinkholes and, a little, at dead ends; it leaves at springs. Its ways through
//! loops follow from the conductance of each passage, r⁴ over its length, in turns with the radii.
//! Where passages join, the cube of the radius is the sum of theirs (Murray 1926).

use landform_core::feature::ConduitNetwork;
use landform_core::math;

use super::space::distance;

/// Water of a dead end, where a sinkhole has 1.
const SEEPAGE: f64 = 0.1;
/// Turns of water and radii.
const TURNS: usize = 3;

/// The share of all water in each conduit, 0 to 1; negative where it runs against its nodes.
pub(super) fn shares(network: &ConduitNetwork, sinkholes: &[u32], springs: &[u32]) -> Vec<f64> {
    let n = network.nodes.len();
    let mut degree = vec![0_u32; n];
    let ends: Vec<[usize; 2]> =
        network.conduits.iter().map(|c| [c.nodes[0] as usize, c.nodes[c.nodes.len() - 1] as usize]).collect();
    ends.iter().flatten().for_each(|&e| degree[e] += 1);
    let mut supply: Vec<f64> = degree.iter().map(|d| if *d == 1 { SEEPAGE } else { 0.0 }).collect();
    sinkholes.iter().for_each(|&s| supply[s as usize] = 1.0);
    springs.iter().for_each(|&s| supply[s as usize] = 0.0);
    let lengths: Vec<f64> = network
        .conduits
        .iter()
        .map(|c| {
            let legs = c.nodes.windows(2).map(|w| distance(network.nodes[w[0] as usize], network.nodes[w[1] as usize]));
            legs.sum::<f64>().max(1e-3)
        })
        .collect();
    let mut conductance: Vec<f64> = lengths.iter().map(|l| 1.0 / l).collect();
    let mut is_held = vec![false; n];
    springs.iter().for_each(|&s| is_held[s as usize] = true);
    let total: f64 = supply.iter().sum::<f64>().max(1e-12);
    let mut flow = vec![0.0; ends.len()];
    for _ in 0..TURNS {
        let head = heads(&ends, &conductance, &supply, &is_held, &degree);
        for (k, [a, b]) in ends.iter().enumerate() {
            flow[k] = conductance[k] * (head[*a] - head[*b]) / total;
            // r⁴ of r³ in proportion to the water; some is left to passages that lose it.
            conductance[k] = math::pow(flow[k].abs().max(1e-4), 4.0 / 3.0) / lengths[k];
        }
    }
    flow
}

/// Heads at which as much water leaves each node as is supplied, by conjugate gradients.
fn heads(ends: &[[usize; 2]], conductance: &[f64], supply: &[f64], is_held: &[bool], degree: &[u32]) -> Vec<f64> {
    let n = supply.len();
    let free: Vec<usize> = (0..n).filter(|&i| degree[i] > 0 && !is_held[i]).collect();
    let mut weight = vec![0.0; n];
    for (k, &[a, b]) in ends.iter().enumerate().filter(|(_, e)| e[0] != e[1]) {
        weight[a] += conductance[k];
        weight[b] += conductance[k];
    }
    let apply = |x: &[f64], out: &mut [f64]| {
        out.fill(0.0);
        for (k, &[a, b]) in ends.iter().enumerate() {
            let q = conductance[k] * (x[a] - x[b]);
            out[a] += q;
            out[b] -= q;
        }
    };
    let dot = |x: &[f64], y: &[f64]| free.iter().map(|&i| x[i] * y[i]).sum::<f64>();
    let (mut x, mut r, mut image) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    free.iter().for_each(|&i| r[i] = supply[i]);
    let scaled = |r: &[f64]| {
        let mut z = vec![0.0; n];
        free.iter().filter(|i| weight[**i] > 0.0).for_each(|&i| z[i] = r[i] / weight[i]);
        z
    };
    let mut p = scaled(&r);
    let mut rho = dot(&r, &p);
    let least = 1e-26 * rho;
    for _ in 0..20 * free.len() {
        if !(rho > least) {
            break;
        }
        apply(&p, &mut image);
        let steep = dot(&p, &image);
        if !(steep > 0.0) {
            break;
        }
        let alpha = rho / steep;
        free.iter().for_each(|&i| {
            x[i] += alpha * p[i];
            r[i] -= alpha * image[i];
        });
        let z = scaled(&r);
        let next = dot(&r, &z);
        free.iter().for_each(|&i| p[i] = z[i] + next / rho * p[i]);
        rho = next;
    }
    x
}

/// Radii (m) of passages between the thinnest and the widest.
pub(super) fn radii(shares: &[f64], [thin, wide]: [f64; 2]) -> Vec<f64> {
    let most = shares.iter().fold(1e-12_f64, |m, s| m.max(s.abs()));
    shares.iter().map(|s| (wide * math::cbrt(s.abs() / most)).clamp(thin, wide)).collect()
}
