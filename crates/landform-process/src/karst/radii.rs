//! Radii from the water that passages carry.
//!
//! Water enters at sinkholes and, a little, at dead ends; it leaves at springs. Along branches its
//! way is known. Through loops it follows from the conductance of each passage, r⁴ over its length,
//! in turns with the radii. Where passages join, the cube of the radius is the sum of theirs
//! (Murray 1926).

use landform_core::feature::ConduitNetwork;
use landform_core::math;

/// Water of a dead end, where a sinkhole has 1.
const SEEPAGE: f64 = 0.1;
/// Turns of water and radii.
const TURNS: usize = 3;

/// Conduits as edges between their ends, and the water that enters at each node.
struct Flow {
    ends: Vec<[usize; 2]>,
    supply: Vec<f64>,
    is_spring: Vec<bool>,
    /// Water in each conduit from its first node to its last.
    flow: Vec<f64>,
}

/// The share of all water in each conduit, 0 to 1; negative where it runs against its nodes.
/// Conduits end at sinkholes and springs.
pub(super) fn shares(network: &ConduitNetwork, sinkholes: &[u32], springs: &[u32]) -> Vec<f64> {
    let n = network.nodes.len();
    let ends: Vec<[usize; 2]> =
        network.conduits.iter().map(|c| [c.nodes[0] as usize, c.nodes[c.nodes.len() - 1] as usize]).collect();
    let mut degree = vec![0_u32; n];
    ends.iter().flatten().for_each(|&e| degree[e] += 1);
    let mut supply: Vec<f64> = degree.iter().map(|d| if *d == 1 { SEEPAGE } else { 0.0 }).collect();
    sinkholes.iter().for_each(|&s| supply[s as usize] = 1.0);
    springs.iter().for_each(|&s| supply[s as usize] = 0.0);
    let total: f64 = supply.iter().sum::<f64>().max(1e-12);
    let mut is_spring = vec![false; n];
    springs.iter().for_each(|&s| is_spring[s as usize] = true);
    let flow = vec![0.0; ends.len()];
    let mut flow = Flow { ends, supply, is_spring, flow };
    let rings = flow.along_branches();
    if !rings.is_empty() {
        let lengths: Vec<f64> = rings.iter().map(|&k| network.length_of(&network.conduits[k]).max(1e-3)).collect();
        flow.through_loops(&rings, &lengths, total);
    }
    flow.flow.iter().map(|f| f / total).collect()
}

impl Flow {
    /// The water of branches, from their tips down. Returns the conduits in which it may take
    /// several ways; their nodes are supplied by the branches.
    fn along_branches(&mut self) -> Vec<usize> {
        let n = self.supply.len();
        let mut at: Vec<Vec<usize>> = vec![Vec::new(); n];
        // A conduit that returns to its start carries no water.
        let mut is_left: Vec<bool> = self.ends.iter().map(|e| e[0] != e[1]).collect();
        for (k, e) in self.ends.iter().enumerate().filter(|(k, _)| is_left[*k]) {
            e.iter().for_each(|&n| at[n].push(k));
        }
        let mut degree: Vec<usize> = at.iter().map(Vec::len).collect();
        let mut tips: Vec<usize> = (0..n).filter(|&i| degree[i] == 1 && !self.is_spring[i]).collect();
        while let Some(tip) = tips.pop() {
            let Some(&k) = at[tip].iter().find(|k| is_left[**k]) else { continue };
            is_left[k] = false;
            let [a, b] = self.ends[k];
            let below = if tip == a { b } else { a };
            self.flow[k] = if tip == a { self.supply[tip] } else { -self.supply[tip] };
            self.supply[below] += self.supply[tip];
            degree[below] -= 1;
            if degree[below] == 1 && !self.is_spring[below] {
                tips.push(below);
            }
        }
        (0..self.ends.len()).filter(|k| is_left[*k]).collect()
    }

    /// The water of the other conduits, of such lengths (m).
    fn through_loops(&mut self, rings: &[usize], lengths: &[f64], total: f64) {
        let ends: Vec<[usize; 2]> = rings.iter().map(|&k| self.ends[k]).collect();
        let mut conductance: Vec<f64> = lengths.iter().map(|l| 1.0 / l).collect();
        for _ in 0..TURNS {
            let head = heads(&ends, &conductance, &self.supply, &self.is_spring);
            for (k, [a, b]) in ends.iter().enumerate() {
                let flow = conductance[k] * (head[*a] - head[*b]);
                self.flow[rings[k]] = flow;
                // r⁴ of r³ in proportion to the water; some is left to passages that lose it.
                conductance[k] = math::pow((flow / total).abs().max(1e-4), 4.0 / 3.0) / lengths[k];
            }
        }
    }
}

/// Heads at which as much water leaves each node as is supplied, by conjugate gradients.
fn heads(ends: &[[usize; 2]], conductance: &[f64], supply: &[f64], is_held: &[bool]) -> Vec<f64> {
    let n = supply.len();
    let mut weight = vec![0.0; n];
    for (k, &[a, b]) in ends.iter().enumerate() {
        weight[a] += conductance[k];
        weight[b] += conductance[k];
    }
    let free: Vec<usize> = (0..n).filter(|&i| weight[i] > 0.0 && !is_held[i]).collect();
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
        free.iter().for_each(|&i| z[i] = r[i] / weight[i]);
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
