//! Whether the ground shows the lattice that it was made on, or one slope everywhere.
//!
//! # Method
//! Ground on a lattice drains in eight directions: its slopes face eight ways, its rivers run
//! straight, its hillsides are planes. Each number has the range that it takes on real ground. They
//! hold for cells of 9 m or more and a mean slope of 8° or more; slopes below 8° face anywhere.
//!
//! # Sources
//! Ranges: least and greatest value over crops of 512² nodes of ten real places; Horn (1981) for
//! slope and aspect; O'Callaghan & Mark (1984) for the eight directions of channels.

mod aspects;
mod channels;
mod planes;

use serde::{Deserialize, Serialize};

use super::surface::has_all_neighbours;
use super::{Drainage, Network, network};
use crate::algo::derivative::gradient;
use crate::grid::{Domain, Grid};
use crate::terrain::{HeightField, NodeSurface};
use crate::{math, parallel};

use aspects::aspects;
use channels::channels;
use planes::{plane_share, sharpness};

/// Slope above which a node faces somewhere, degrees.
const LEAST_SLOPE: f64 = 8.0;
/// Drainage area from which a node is on a channel, nodes.
const CHANNEL: f64 = 100.0;
/// Least cell for which the ranges hold, m.
const LEAST_CELL: f64 = 9.0;
/// Rounding of the ends of ranges.
const ROUNDING: f64 = 5e-4;

/// A number with its natural range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gate {
    /// Name.
    pub name: String,
    /// Value; none where there is too little of what it is measured on.
    pub value: Option<f64>,
    /// Least and greatest value on real ground.
    pub natural: [f64; 2],
    /// Whether it lies within.
    pub inside: Option<bool>,
    /// What it means, in a sentence.
    pub meaning: String,
}

/// Directions, facets and slopes of a raster.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Directions {
    /// Nodes with a slope whose eight neighbours have data.
    pub nodes: usize,
    /// Cell, m.
    pub cell_size: f64,
    /// Mean slope, degrees.
    pub slope_mean: f64,
    /// Whether the ranges hold: cells of 9 m or more and a mean slope of 8° or more.
    pub ranges_hold: bool,
    /// The numbers.
    pub gates: Vec<Gate>,
}

impl Directions {
    /// Names of the numbers outside their ranges; none where the ranges do not hold.
    pub fn outside(&self) -> Vec<&str> {
        let out = |g: &&Gate| self.ranges_hold && g.inside == Some(false);
        self.gates.iter().filter(out).map(|g| g.name.as_str()).collect()
    }
}

/// (name, least, greatest, meaning).
#[rustfmt::skip]
const GATES: [(&str, f64, f64, &str); 11] = [
    ("aspect_peak", 0.0, 1.5, "99th percentile of the histogram of aspects, in degrees, over its mean within 45 degrees: above where slopes face a few ways."),
    ("aspect_45", 0.94, 1.07, "Share of slopes that face within 2 degrees of the lattice's eight directions, over what chance gives."),
    ("aspect_r8", -0.02, 0.025, "Mean cosine of eight times the aspect: 0 without a lattice."),
    ("straight_channels", 0.0, 0.21, "Share of channel nodes in straight runs of more than ten."),
    ("reach_45", 0.0, 0.21, "Share of reaches of eight nodes within 2 degrees of the eight directions."),
    ("plane_share", 0.0, 0.005, "Share of steep ground that is a plane over five by five nodes."),
    ("slope_mode", 0.0, 0.095, "Share of ground in the commonest degree of slope: above where one slope is everywhere."),
    ("slope_skew", -0.6, 1.6, "Skew of slopes: below where most ground stands at the steepest angle."),
    ("hollow_sharpness", 0.8, 1.25, "Sharpest 5 percent of hollows over the sharpest 5 percent of crests: above where rivers are trenches."),
    ("chi_r2", 0.39, 0.93, "R2 of elevation against chi: above where every river is in balance."),
    ("slope_area_r2", 0.16, 0.97, "R2 of slope against area: above where nothing disturbs the law of rivers."),
];

/// Measures the directions of a raster of elevations (m), with its network as it was
/// measured. **Cost** O(n log n).
pub fn directions<D: Domain>(grid: &Grid, z: &[f64], drainage: &Drainage<D>, network: &Network) -> Directions {
    let slopes = parallel::map(z.len(), |i| math::atan(gradient(grid, z, i).slope()).to_degrees());
    // Water has no slope.
    let faces: Vec<usize> = (0..z.len()).filter(|&i| slopes[i] > 0.0 && has_all_neighbours(grid, z, i)).collect();
    let steep: Vec<usize> = faces.iter().copied().filter(|&i| slopes[i] > LEAST_SLOPE).collect();
    let (mode, skew, mean) = shape_of(&faces, &slopes);
    let facing = aspects(grid, z, &steep);
    let running = channels(grid, drainage, CHANNEL, |i| slopes[i] > 0.0);
    let values = [
        facing.map(|a| a.peak),
        facing.map(|a| a.near_45),
        facing.map(|a| a.r8),
        running.map(|c| c.straight),
        running.map(|c| c.near_45),
        plane_share(grid, z, &steep),
        Some(mode),
        Some(skew),
        sharpness(grid.shape, z, &faces),
        network.chi.as_ref().map(|c| c.r2),
        Some(network.slope_area.r2),
    ];
    let gate = |(&(name, low, high, meaning), value): (&(&str, f64, f64, &str), Option<f64>)| {
        let value = value.filter(|v| v.is_finite());
        let inside = value.and_then(|v| is_natural(v, [low, high]));
        Gate { name: name.into(), value, natural: [low, high], inside, meaning: meaning.into() }
    };
    let cell_size = grid.cell_area().sqrt();
    Directions {
        nodes: faces.len(),
        cell_size,
        slope_mean: mean,
        ranges_hold: cell_size >= LEAST_CELL && mean >= LEAST_SLOPE,
        gates: GATES.iter().zip(values).map(gate).collect(),
    }
}

/// Measures the directions of a raster. **Cost** O(n log n).
pub fn directions_of(field: &HeightField) -> Directions {
    let drainage = Drainage::with_open_holes(field);
    let z = field.elevation();
    let network = network(&drainage, z);
    directions(field.grid(), z, &drainage, &network)
}

/// Whether a direction lies within 2 degrees of a multiple of 45.
fn is_near_45(degrees: f64) -> bool {
    ((degrees + 22.5).rem_euclid(45.0) - 22.5).abs() <= 2.0
}

/// Whether a value lies in its natural range; none for one that is not finite.
pub(super) fn is_natural(value: f64, [low, high]: [f64; 2]) -> Option<bool> {
    // A rounding error at the end of a range is inside.
    let below = if low > 0.0 { ROUNDING.min(0.5 * low) } else { ROUNDING };
    value.is_finite().then_some(value >= low - below && value <= high + ROUNDING)
}

/// Share of the commonest degree, skew and mean of slopes.
fn shape_of(nodes: &[usize], slopes: &[f64]) -> (f64, f64, f64) {
    let n = nodes.len() as f64;
    let sum = |f: &(dyn Fn(f64) -> f64 + Sync)| parallel::sum(nodes.len(), |k| f(slopes[nodes[k]])) / n;
    let mean = sum(&|s| s);
    let variance = sum(&|s| (s - mean) * (s - mean));
    let third = sum(&|s| (s - mean) * (s - mean) * (s - mean));
    let mut bins = [0.0_f64; 91];
    nodes.iter().for_each(|&i| bins[slopes[i] as usize] += 1.0);
    (bins.iter().fold(0.0, |a: f64, &b| a.max(b)) / n, third / (variance * variance.sqrt()), mean)
}

#[cfg(test)]
mod tests;
