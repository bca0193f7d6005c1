//! Heights between level sets.
//!
//! # Method
//! From the distances to the lower and the upper level set, measured within the band between them
//! by fast marching: linearly, or by Hermite's polynomials with limited slopes at the level sets,
//! so that the ground has no creases there. On summits, within the last level set, its slope
//! continues, up to one interval. Least bending starts from Hermite's surface and is held to it
//! along the level sets.
//!
//! # Sources
//! Hormann, Spinello & Schroeder (2003) for slopes across level sets; Fritsch & Carlson (1980) for
//! their limit; Szeliski & Terzopoulos (1989) for least bending.

use landform_core::algo::fast_marching::{Order, march};
use landform_core::algo::thin_plate::Plate;
use landform_core::grid::{Lattice, Shape};
use landform_core::parallel;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Part of plate in the surface of least bending; the rest is membrane, which keeps it from
/// overshooting.
const PLATE: f64 = 0.9;
/// Weight of the heights along level sets.
const HOLD: f64 = 0.5;

/// How heights between level sets are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LevelInterpolation {
    /// The height of the lower level set: terraces.
    Nearest,
    /// In proportion to the distances.
    Linear,
    /// Smooth across level sets.
    #[default]
    Hermite,
    /// The surface that bends least through the level sets.
    Variational,
}

/// Heights above the sea of land in numbered bands, m; 0 at sea. `typical_slope` is that of islets
/// within which no level set lies.
pub(super) fn heights(
    lattice: &Lattice,
    levels: &[u32],
    interval: f64,
    typical_slope: f64,
    interpolation: LevelInterpolation,
    shore: impl Fn(usize) -> bool,
) -> Vec<f64> {
    if interpolation == LevelInterpolation::Variational {
        let start = heights(lattice, levels, interval, typical_slope, LevelInterpolation::Hermite, shore);
        return least_bending(lattice, levels, start);
    }
    let floor = |i: usize| f64::from(levels[i].saturating_sub(1)) * interval;
    if interpolation == LevelInterpolation::Nearest {
        // Half an interval up, so that the lowest terrace is land.
        return (0..levels.len()).map(|i| if levels[i] == 0 { 0.0 } else { floor(i) + 0.5 * interval }).collect();
    }
    let below = Bands::distances(lattice, levels, |other, own| other < own, shore);
    let above = Bands::distances(lattice, levels, |other, own| other > own, |_| false);
    let width = |i: usize| below.distance[i] + above.distance[i];
    let slope = |i: usize| if width(i).is_finite() { interval / width(i) } else { f64::NAN };
    let of = |i: usize| {
        if levels[i] == 0 {
            return 0.0;
        }
        // The slope of the band on the other side of a level set, where the way from here crosses
        // it.
        let beyond = |bands: &Bands| bands.foot(i).map_or(f64::NAN, slope);
        let (d, w, own) = (below.distance[i], width(i), slope(i));
        let at_set = |other: f64| match (own.is_nan(), other.is_nan()) {
            (false, false) => (2.0 / (1.0 / own + 1.0 / other)).min(3.0 * own.min(other)),
            (false, true) => own,
            (true, false) => other,
            (true, true) => typical_slope,
        };
        let outer = at_set(beyond(&below));
        if !w.is_finite() {
            return floor(i) + if d.is_finite() { (outer * d).min(interval) } else { 0.0 };
        }
        let t = d / w;
        if interpolation == LevelInterpolation::Linear {
            return floor(i) + t * interval;
        }
        let inner = at_set(beyond(&above));
        let (h10, h01, h11) = (t * (1.0 - t) * (1.0 - t), t * t * (3.0 - 2.0 * t), t * t * (t - 1.0));
        floor(i) + h10 * w * outer + h01 * interval + h11 * w * inner
    };
    (0..levels.len()).map(of).collect()
}

/// The surface of least bending through what lies along level sets; what is under the sea is held.
fn least_bending(lattice: &Lattice, levels: &[u32], mut z: Vec<f64>) -> Vec<f64> {
    let around = |i: usize| {
        let place = lattice.place(i);
        [[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0]].into_iter().filter_map(move |by| lattice.moved(place, by))
    };
    let on_set = |i: usize| around(i).any(|j| levels[j] != levels[i]);
    let weight = parallel::map(z.len(), |i| if on_set(i) { HOLD } else { 0.0 });
    let held: Vec<bool> = levels.iter().map(|&l| l == 0).collect();
    let shape = Shape::new(lattice.size[1], lattice.size[0]);
    Plate { shape, tension: PLATE, weight: &weight, held: &held }.relax(&mut z, 1e-4);
    // Where the plate sags under the sea's level it is lifted back.
    parallel::update(&mut z, |i, z| *z = if held[i] { 0.0 } else { z.max(1e-3) });
    z
}

/// Distances within bands to one of their borders, and where the way there crosses it.
struct Bands {
    distance: Vec<f64>,
    /// The site beyond the border at the end of the way; own index if none.
    foot: Vec<u32>,
}

impl Bands {
    fn distances(
        lattice: &Lattice,
        levels: &[u32],
        is_border: impl Fn(u32, u32) -> bool,
        shore: impl Fn(usize) -> bool,
    ) -> Self {
        let n = levels.len();
        let half = 0.5 * lattice.spacing[0].min(lattice.spacing[1]);
        let around = |i: usize| {
            let place = lattice.place(i);
            [[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0]].into_iter().filter_map(move |by| lattice.moved(place, by))
        };
        let mut foot: Vec<u32> = (0..n as u32).collect();
        let mut distance = vec![f64::INFINITY; n];
        let mut bands: Vec<Vec<u32>> = Vec::new();
        for i in 0..n {
            if levels[i] == 0 {
                continue;
            }
            let beyond = around(i).find(|&j| is_border(levels[j], levels[i]));
            if beyond.is_some() || shore(i) {
                foot[i] = beyond.unwrap_or(i) as u32;
                let band = levels[i] as usize;
                bands.resize(bands.len().max(band + 1), Vec::new());
                bands[band].push(i as u32);
            }
        }
        for (band, seeds) in bands.iter().enumerate().filter(|b| !b.1.is_empty()) {
            let mut order = Vec::new();
            let start = seeds.iter().map(|&s| (s as usize, half));
            let inside = |i: usize| levels[i] as usize == band;
            let d = march(
                lattice,
                start,
                |f, i| if inside(i) { f.eikonal(i, 1.0, Order::First) } else { f64::INFINITY },
                |i, _| order.push(i),
            );
            for i in order.into_iter().filter(|&i| d[i].is_finite()) {
                distance[i] = d[i];
                if foot[i] == i as u32 {
                    // Back the way that the front came.
                    let from = around(i).filter(|&j| inside(j)).min_by(|&a, &b| d[a].total_cmp(&d[b]));
                    foot[i] = from.map_or(i as u32, |j| foot[j]);
                }
            }
        }
        Self { distance, foot }
    }

    fn foot(&self, i: usize) -> Option<usize> {
        let foot = self.foot[i] as usize;
        (foot != i && self.distance[i].is_finite()).then_some(foot)
    }
}
