//! A wind that the ground turns and quickens.
//!
//! # Model
//! v0 = a (1 + k_W h), k_W = 0.005 1/m; for the ground blurred by σ = 200 m and 50 m, g_i its
//! gradient, α_i = min(1, |g_i|), n_i the perpendicular of g_i on the side of v0: v = Σ c_i [(1 −
//! α_i) v0 + α_i k_i n_i |a|/a_0], c = 0.8 and 0.2, k = 30 and 5 m/s. Heights count from the lowest
//! ground.
//!
//! # Sources
//! Paris et al. (2019), Section 4. The perpendicular has two signs of which they choose none; where
//! it is across the wind, v0 is kept. Their k_i are for winds of some metres a second; ours grow
//! with the wind, a_0 = 10 m/s. Limits: no lee, no vertical wind.
//!
//! # Checked by
//! `tests`: flat ground, a ridge along the wind, a cone.

use landform_core::math;
use landform_core::terrain::{Bounds, Ground};

use super::surroundings::WindParams;

const VENTURI: f64 = 0.005;
/// Scale (m), weight, strength of turning (m/s at the wind a_0).
const SCALES: [(f64, f64, f64); 2] = [(200.0, 0.8, 30.0), (50.0, 0.2, 5.0)];
/// a_0, m/s.
const USUAL: f64 = 10.0;
/// Most points along a side.
const MOST: f64 = 256.0;

/// Wind on a lattice over the map.
pub(super) struct WindField {
    low: [f64; 2],
    spacing: f64,
    size: [usize; 2],
    wind: Vec<[f64; 2]>,
}

impl WindField {
    /// The wind over the uppermost surface.
    pub(super) fn over<T: Ground>(ground: &T, bounds: &Bounds, params: &WindParams) -> Self {
        let extent = [bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1]];
        let spacing = ground.resolution().max(extent[0].max(extent[1]) / MOST);
        let size = extent.map(|e| (e / spacing).round() as usize + 1);
        let low = [bounds.low[0], bounds.low[1]];
        let place = |i: usize| [low[0] + (i % size[0]) as f64 * spacing, low[1] + (i / size[0]) as f64 * spacing];
        let heights: Vec<f64> =
            (0..size[0] * size[1]).map(|i| ground.height_at(place(i)).map_or(0.0, |h| h - bounds.low[2])).collect();
        let angle = params.from.si();
        let towards = [-math::sin(angle), -math::cos(angle)];
        let speed = params.speed.si();
        let plain = |i: usize| towards.map(|v| v * speed * (1.0 + VENTURI * heights[i]));
        let mut wind = vec![[0.0; 2]; heights.len()];
        for (scale, weight, strength) in SCALES {
            let smooth = blurred(&heights, size, scale / spacing);
            for (i, wind) in wind.iter_mut().enumerate() {
                let turned = turned(plain(i), gradient(&smooth, size, spacing, i), strength * speed / USUAL);
                (0..2).for_each(|k| wind[k] += weight * turned[k]);
            }
        }
        Self { low, spacing, size, wind }
    }

    /// East, north and up, m/s; that of the nearest side beyond the map.
    pub(super) fn at(&self, place: [f64; 2]) -> [f64; 3] {
        let cell = |k: usize| {
            let at = ((place[k] - self.low[k]) / self.spacing).clamp(0.0, (self.size[k] - 1) as f64);
            let first = (at as usize).min(self.size[k].saturating_sub(2));
            (first, (first + 1).min(self.size[k] - 1), at - first as f64)
        };
        let (c, r) = (cell(0), cell(1));
        let of = |row: usize, col: usize, k: usize| self.wind[row * self.size[0] + col][k];
        let line = |row: usize, k: usize| math::lerp(of(row, c.0, k), of(row, c.1, k), c.2);
        let value = |k: usize| math::lerp(line(r.0, k), line(r.1, k), r.2);
        [value(0), value(1), 0.0]
    }
}

/// A wind that a slope turns along its contours.
fn turned(wind: [f64; 2], slope: [f64; 2], strength: f64) -> [f64; 2] {
    let steepness = math::hypot(slope[0], slope[1]).min(1.0);
    let across = [-slope[1], slope[0]];
    let along = across[0] * wind[0] + across[1] * wind[1];
    if along == 0.0 {
        return wind;
    }
    let side = if along > 0.0 { 1.0 } else { -1.0 };
    [0, 1].map(|k| (1.0 - steepness) * wind[k] + steepness * strength * side * across[k])
}

fn gradient(values: &[f64], size: [usize; 2], spacing: f64, i: usize) -> [f64; 2] {
    let (col, row) = (i % size[0], i / size[0]);
    let slope = |at: usize, n: usize, step: usize| {
        let (back, on) = (usize::from(at > 0), usize::from(at + 1 < n));
        let run = (back + on) as f64 * spacing;
        if run > 0.0 { (values[i + on * step] - values[i - back * step]) / run } else { 0.0 }
    };
    [slope(col, size[0], 1), slope(row, size[1], size[0])]
}

/// Values blurred by a Gaussian kernel of `sigma` points, cut at three; near sides by what there
/// is.
fn blurred(values: &[f64], size: [usize; 2], sigma: f64) -> Vec<f64> {
    let reach = ((3.0 * sigma).ceil() as usize).min(size[0].max(size[1]));
    let kernel: Vec<f64> = (0..=reach).map(|k| math::exp(-0.5 * (k as f64 / sigma) * (k as f64 / sigma))).collect();
    let along = |values: &[f64], step: usize, n: usize, at: &(dyn Fn(usize) -> usize + Sync)| -> Vec<f64> {
        let mean = |i: usize| {
            let here = at(i);
            let (mut sum, mut whole) = (kernel[0] * values[i], kernel[0]);
            for (d, weight) in kernel.iter().enumerate().skip(1) {
                if here >= d {
                    (sum, whole) = (sum + weight * values[i - d * step], whole + weight);
                }
                if here + d < n {
                    (sum, whole) = (sum + weight * values[i + d * step], whole + weight);
                }
            }
            sum / whole
        };
        landform_core::parallel::map(values.len(), mean)
    };
    let rows = along(values, 1, size[0], &|i| i % size[0]);
    along(&rows, size[0], size[1], &|i| i / size[0])
}
