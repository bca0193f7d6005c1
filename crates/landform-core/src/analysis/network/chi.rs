//! Elevation against χ.
//!
//! # Method
//! χ is the integral of (1 km² / A)^θ along the flow from the outlet of the largest basin, by the
//! trapezoid rule, over channel nodes. On a landscape in balance with even uplift and rock,
//! elevation is linear in χ and all tributaries fall on one line.
//!
//! # Sources
//! Perron & Royden (2013). A0 = 1 km²; the slope of the line times A0^θ is the steepness k_sn.

use serde::{Deserialize, Serialize};

use crate::analysis::Drainage;
use crate::grid::Domain;
use crate::math;

const A0: f64 = 1e6;
/// The usual reference concavity.
const REFERENCE: f64 = 0.45;

/// The χ plot of the largest basin.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Chi {
    /// R² of elevation on χ (θ = 0.45), all channels.
    pub r2: f64,
    /// R² on the trunk alone.
    pub r2_trunk: f64,
    /// Normalised steepness k_sn: slope of the line times A0^0.45, m^0.9.
    pub steepness: f64,
    /// θ from 0.05 to 1 with the greatest R².
    pub best_concavity: f64,
    /// (χ in m, elevation in m) of the trunk and of at most a few thousand other channel nodes.
    pub points: Vec<(f64, f64)>,
    /// How many of the points, at the beginning, are the trunk's.
    pub trunk: usize,
}

/// The plot from elevations without depressions; none with fewer than ten channel nodes. **Cost**
/// O(n).
pub fn chi_profile<D: Domain>(drainage: &Drainage<D>, carved: &[f64], least: f64) -> Option<Chi> {
    let (area, receivers) = (&drainage.area, drainage.flow.receivers());
    let outlet = (0..area.len()).fold(0, |best, i| if area[i] > area[best] { i } else { best });
    // Channel nodes of its basin, receivers before donors.
    let mut inside = vec![false; area.len()];
    let mut nodes: Vec<usize> = Vec::new();
    let mut main_donor: std::collections::HashMap<usize, usize> = std::collections::HashMap::new();
    for &i in drainage.flow.order().iter().rev() {
        let i = i as usize;
        let r = receivers[i] as usize;
        inside[i] = i == outlet || (r != i && inside[r] && area[i] >= least);
        if inside[i] {
            nodes.push(i);
            if i != outlet && main_donor.get(&r).is_none_or(|&d| area[i] > area[d]) {
                main_donor.insert(r, i);
            }
        }
    }
    if nodes.len() < 10 {
        return None;
    }
    let mut place = vec![0u32; area.len()];
    for (k, &i) in nodes.iter().enumerate() {
        place[i] = k as u32;
    }
    let chi = |theta: f64| {
        let weight = |i: usize| math::pow(A0 / area[i], theta);
        let mut chi = vec![0.0; nodes.len()];
        for (k, &i) in nodes.iter().enumerate().skip(1) {
            let r = receivers[i] as usize;
            let distance = drainage.domain.distance(i, drainage.flow.slots()[i]);
            chi[k] = chi[place[r] as usize] + 0.5 * (weight(i) + weight(r)) * distance;
        }
        chi
    };
    let fit = |chi: &[f64]| math::line_fit(nodes.iter().zip(chi).map(|(&i, &x)| (x, carved[i])));
    let reference = chi(REFERENCE);
    let (slope, _, r2) = fit(&reference);
    let mut trunk = vec![outlet];
    while let Some(&up) = main_donor.get(&trunk[trunk.len() - 1]) {
        trunk.push(up);
    }
    let point = |i: usize| (reference[place[i] as usize], carved[i]);
    let r2_trunk = math::line_fit(trunk.iter().map(|&i| point(i))).2;
    let best = (1..=20)
        .map(|k| 0.05 * f64::from(k))
        .map(|theta| (theta, fit(&chi(theta)).2))
        .fold((f64::NAN, f64::NEG_INFINITY), |a, b| if b.1 > a.1 { b } else { a });
    let every = |n: usize, most: usize| n.div_ceil(most).max(1);
    let mut points: Vec<(f64, f64)> = trunk.iter().step_by(every(trunk.len(), 600)).map(|&i| point(i)).collect();
    let of_trunk = points.len();
    points.extend(nodes.iter().step_by(every(nodes.len(), 2_500)).map(|&i| point(i)));
    Some(Chi {
        r2,
        r2_trunk,
        steepness: slope * math::pow(A0, REFERENCE),
        best_concavity: best.0,
        points,
        trunk: of_trunk,
    })
}
