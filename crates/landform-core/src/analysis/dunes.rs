//! Dunes: height, spacing, direction of crests, and type.
//!
//! # Sources
//! Werner (1995) for the measures of a slab field; Fryberger (1979) and Wasson & Hyde (1983) for
//! the types by wind regime and sand supply: steady winds make barchans (little sand) or transverse
//! dunes (much), two winds linear dunes along their resultant, many winds stars. Pytel (2015),
//! table 4.1, for the share of sites near repose.

use serde::{Deserialize, Serialize};

use crate::algo::derivative::gradient;
use crate::grid::Grid;
use crate::verb::Rose;
use crate::{math, parallel};

/// Type of a dune field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DuneClass {
    /// Separate crescents on bare ground.
    Barchan,
    /// Ridges across the wind.
    Transverse,
    /// Ridges along the resultant of the winds.
    Linear,
    /// Peaks with slip faces on three sides and more, under winds from many.
    Star,
    /// No dunes.
    None,
}

/// Measures of a dune field.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dunes {
    /// Type of the dunes.
    pub class: DuneClass,
    /// Mean depth of sand, m.
    pub sand: f64,
    /// Root mean square of the elevation about its mean, m.
    pub roughness: f64,
    /// Highest less lowest ground, m.
    pub relief: f64,
    /// Distance between crests, m, by the first maximum of the autocorrelation across them; none if
    /// there is none.
    pub spacing: Option<f64>,
    /// Compass direction along which crests run, degrees from 0 to 180.
    pub crest_azimuth: f64,
    /// Share of slope across the crests relative to along them, 0 (none) to 1.
    pub alignment: f64,
    /// Power of waves along the wind over that across it, ⟨kx²⟩ / ⟨ky²⟩.
    pub anisotropy: f64,
    /// Share of the ground without sand.
    pub bare_share: f64,
    /// Share of sites whose steepest side is within a tenth of the angle of repose.
    pub near_repose_share: f64,
    /// Number of directions that slip faces face.
    pub slip_directions: usize,
    /// RDP/DP of the winds: length of their mean vector.
    pub steadiness: f64,
    /// Angle between crests and the resultant of the winds, degrees from 0 to 90.
    pub crest_to_wind: f64,
    /// Difference of the model's shelter from a shadow of 15 degrees; none where the shelter is not
    /// known.
    pub shadow: Option<ShadowError>,
}

/// Shelter by another rule compared with the geometric shadow: shares of sites where they differ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ShadowError {
    /// Of all sites.
    pub all: f64,
    /// Of sites that are neither on peaks nor in troughs: where the slope changes little from cell
    /// to cell, as on flanks and on level ground.
    pub flanks: f64,
}

/// Sand thinner than this part of a cell counts as none.
const BARE: f64 = 0.02;
/// Change of slope over a cell, summed over both axes, from which ground is a peak or a trough.
const CURVED: f64 = 0.1;
/// Bins of slip faces' directions.
const BINS: usize = 36;

/// Measures dunes on a raster of elevations and sand (m), with an angle of repose in rad; `torus`
/// if its sides meet. **Cost** O(n · spacing / cell).
pub fn dunes(grid: &Grid, z: &[f64], sand: &[f64], rose: &Rose, repose: f64, torus: bool) -> Dunes {
    let n = z.len();
    let cell = grid.spacing[0].min(grid.spacing[1]);
    let count = parallel::sum(n, |i| if z[i].is_nan() { 0.0 } else { 1.0 }).max(1.0);
    let mean_of =
        |f: &(dyn Fn(usize) -> f64 + Sync)| parallel::sum(n, |i| if z[i].is_nan() { 0.0 } else { f(i) }) / count;
    let mean = mean_of(&|i| z[i]);
    let is_sand = |i: usize| sand[i] > BARE * cell;
    let slopes = parallel::map(n, |i| gradient(grid, z, i));
    let [xx, xy, yy] = [0, 1, 2].map(|k| {
        parallel::sum(n, |i| {
            let g = slopes[i];
            if g.x.is_nan() || g.y.is_nan() { 0.0 } else { [g.x * g.x, g.x * g.y, g.y * g.y][k] }
        })
    });
    // Direction of the slopes, x east and y north; crests run square to it.
    let across = 0.5 * math::atan2(2.0 * xy, xx - yy);
    let alignment = math::hypot(xx - yy, 2.0 * xy) / (xx + yy).max(1e-300);
    let crest_azimuth = (-across.to_degrees()).rem_euclid(180.0);
    let resultant = rose.resultant();
    let downwind = math::atan2(resultant[0], resultant[1]).to_degrees();
    let fold = |d: f64| {
        let d = d.rem_euclid(180.0);
        d.min(180.0 - d)
    };
    let crest_to_wind = fold(crest_azimuth - downwind);
    let relief = parallel::max(n, |i| z[i]) + parallel::max(n, |i| -z[i]);
    let wind = [resultant[0], resultant[1]];
    let length = math::hypot(wind[0], wind[1]).max(1e-12);
    let along = parallel::sum(n, |i| square((slopes[i].x * wind[0] + slopes[i].y * wind[1]) / length));
    let sideways = parallel::sum(n, |i| square((slopes[i].y * wind[0] - slopes[i].x * wind[1]) / length));
    let mut dunes = Dunes {
        class: DuneClass::None,
        sand: mean_of(&|i| sand[i]),
        roughness: mean_of(&|i| (z[i] - mean) * (z[i] - mean)).sqrt(),
        relief,
        spacing: spacing(grid, z, mean, [math::cos(across), math::sin(across)], torus),
        crest_azimuth,
        alignment,
        anisotropy: along / sideways.max(1e-300),
        bare_share: mean_of(&|i| if is_sand(i) { 0.0 } else { 1.0 }),
        near_repose_share: mean_of(&|i| {
            let slope = steepest_side(grid, z, i, torus);
            if slope >= 0.9 * math::tan(repose) && slope <= 1.1 * math::tan(repose) { 1.0 } else { 0.0 }
        }),
        slip_directions: slip_directions(&slopes, repose, is_sand),
        steadiness: rose.steadiness(),
        crest_to_wind,
        shadow: None,
    };
    dunes.class = class(&dunes, cell);
    dunes
}

fn square(v: f64) -> f64 {
    if v.is_nan() { 0.0 } else { v * v }
}

fn class(d: &Dunes, cell: f64) -> DuneClass {
    if d.relief < cell || d.sand <= 0.0 {
        DuneClass::None
    } else if d.slip_directions >= 3 && d.alignment < 0.4 && d.steadiness < 0.5 {
        DuneClass::Star
    } else if d.crest_to_wind < 30.0 && d.alignment > 0.15 {
        DuneClass::Linear
    } else if d.bare_share > 0.55 {
        DuneClass::Barchan
    } else {
        DuneClass::Transverse
    }
}

/// Compares `shelter` (parts of the winds) with the shadows of 15 degrees that the ground casts in
/// each wind. Peaks and troughs are where the ground curves. **Cost** O(n · relief / cell).
pub fn shadow_error(grid: &Grid, z: &[f64], shelter: &[f64], rose: &Rose, torus: bool) -> ShadowError {
    let cell = grid.spacing[0].min(grid.spacing[1]);
    let fall = math::tan(15f64.to_radians()) * cell;
    let highest = parallel::max(z.len(), |i| z[i]);
    let total: f64 = rose.winds().iter().map(|w| w.weight).sum();
    let hidden = |i: usize, towards: [f64; 2]| {
        let here = grid.shape.cell(i);
        let by = [towards[0] * cell / grid.spacing[0], -towards[1] * cell / grid.spacing[1]];
        (1..)
            .map_while(|k| {
                let k = f64::from(k);
                (z[i] + k * fall < highest).then_some(k)
            })
            .any(|k| {
                let (r, c) =
                    ((here.row as f64 - k * by[1]).round() as i64, (here.col as f64 - k * by[0]).round() as i64);
                moved(grid, r, c, torus).is_some_and(|j| z[j] > z[i] + k * fall)
            })
    };
    let is_flank = |i: usize| curvature(grid, z, i, torus).abs() * cell < CURVED;
    let found = parallel::map(z.len(), |i| {
        let geometric: f64 =
            rose.winds().iter().map(|w| if hidden(i, w.towards()) { w.weight / total } else { 0.0 }).sum();
        ((geometric > 0.5) != (shelter[i] > 0.5), is_flank(i))
    });
    let share = |flanks: bool| {
        let of: Vec<bool> = found.iter().filter(|f| !flanks || f.1).map(|f| f.0).collect();
        of.iter().filter(|d| **d).count() as f64 / of.len().max(1) as f64
    };
    ShadowError { all: share(false), flanks: share(true) }
}

/// Laplacian of the heights at a node, 1/m; sides that do not meet go on level.
fn curvature(grid: &Grid, z: &[f64], i: usize, torus: bool) -> f64 {
    let cell = grid.shape.cell(i);
    let [dx, dy] = grid.spacing;
    let sides = [(0i64, 1i64, dx), (0, -1, dx), (1, 0, dy), (-1, 0, dy)];
    let rises = sides.map(|(r, c, distance)| {
        let beside = moved(grid, cell.row as i64 + r, cell.col as i64 + c, torus);
        beside.map_or(0.0, |j| (z[j] - z[i]) / (distance * distance))
    });
    rises.iter().sum()
}

/// The steepest side of a node towards its eight neighbours, rise over run.
fn steepest_side(grid: &Grid, z: &[f64], i: usize, torus: bool) -> f64 {
    let cell = grid.shape.cell(i);
    let mut most = 0.0f64;
    for (r, c) in [(-1i64, -1i64), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)] {
        if let Some(j) = moved(grid, cell.row as i64 + r, cell.col as i64 + c, torus) {
            let distance = math::hypot(c as f64 * grid.spacing[0], r as f64 * grid.spacing[1]);
            most = most.max((z[i] - z[j]).abs() / distance);
        }
    }
    most
}

fn moved(grid: &Grid, r: i64, c: i64, torus: bool) -> Option<usize> {
    let (rows, cols) = (grid.shape.rows as i64, grid.shape.cols as i64);
    if torus {
        return Some(grid.shape.index(r.rem_euclid(rows) as usize, c.rem_euclid(cols) as usize));
    }
    ((0..rows).contains(&r) && (0..cols).contains(&c)).then(|| grid.shape.index(r as usize, c as usize))
}

/// Number of directions that steep sand faces: maxima of the smoothed rose of slip faces, a quarter
/// of the greatest and more, and not nearer to each other than 50 degrees.
fn slip_directions(
    slopes: &[crate::algo::derivative::Gradient],
    repose: f64,
    is_sand: impl Fn(usize) -> bool,
) -> usize {
    let steep = math::tan(0.8 * repose);
    let mut bins = [0.0; BINS];
    for (i, g) in slopes.iter().enumerate() {
        if is_sand(i) && g.slope() >= steep {
            let azimuth = math::atan2(-g.x, -g.y).rem_euclid(std::f64::consts::TAU);
            bins[((azimuth / std::f64::consts::TAU * BINS as f64) as usize).min(BINS - 1)] += 1.0;
        }
    }
    let at = |k: usize, by: i64| bins[(k as i64 + by).rem_euclid(BINS as i64) as usize];
    let smooth: Vec<f64> = (0..BINS).map(|k| (-2..=2).map(|b| at(k, b)).sum()).collect();
    let most = smooth.iter().copied().fold(0.0, f64::max);
    let mut order: Vec<usize> = (0..BINS).filter(|&k| smooth[k] >= 0.25 * most && smooth[k] > 0.0).collect();
    order.sort_by(|&a, &b| smooth[b].total_cmp(&smooth[a]).then(a.cmp(&b)));
    let mut modes: Vec<usize> = Vec::new();
    for k in order {
        let is_top = (-2i64..=2).all(|b| smooth[(k as i64 + b).rem_euclid(BINS as i64) as usize] <= smooth[k]);
        let apart = |m: usize| (k.abs_diff(m)).min(BINS - k.abs_diff(m)) * 360 / BINS >= 50;
        if is_top && modes.iter().all(|&m| apart(m)) {
            modes.push(k);
        }
    }
    modes.len()
}

/// Distance of the first maximum of the autocorrelation after its first crossing of 0, along a
/// direction (x east, y north).
fn spacing(grid: &Grid, z: &[f64], mean: f64, along: [f64; 2], torus: bool) -> Option<f64> {
    let cell = grid.spacing[0].min(grid.spacing[1]);
    let reach = (0.5 * grid.shape.cols.min(grid.shape.rows).max(8) as f64) as usize;
    let reach = if torus { grid.shape.cols.max(grid.shape.rows) / 2 } else { reach };
    let correlation = |k: usize| {
        let by = [k as f64 * cell * along[0] / grid.spacing[0], -(k as f64) * cell * along[1] / grid.spacing[1]];
        let (c, r) = (by[0].round() as i64, by[1].round() as i64);
        let pair = |i: usize| {
            let here = grid.shape.cell(i);
            let j = moved(grid, here.row as i64 + r, here.col as i64 + c, torus)?;
            let product = (z[i] - mean) * (z[j] - mean);
            (!product.is_nan()).then_some(product)
        };
        let n = parallel::sum(z.len(), |i| f64::from(u8::from(pair(i).is_some())));
        parallel::sum(z.len(), |i| pair(i).unwrap_or(0.0)) / n.max(1.0)
    };
    let mut last = correlation(0);
    let (mut crossed, mut rising) = (false, false);
    for k in 1..reach {
        let now = correlation(k);
        crossed |= now < 0.0;
        if crossed && rising && now < last {
            return Some((k - 1) as f64 * cell);
        }
        rising = now > last;
        last = now;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;
    use crate::verb::Wind;

    #[test]
    fn ridges_are_told_by_their_direction() {
        let grid = Grid::new(Shape::new(96, 96), [2.0, 2.0]).unwrap();
        let ridges = |toward: [f64; 2]| -> Vec<f64> {
            (0..96 * 96)
                .map(|i| {
                    let [x, y] = grid.position(i);
                    4.0 * math::sin((x * toward[0] + y * toward[1]) * std::f64::consts::TAU / 24.0)
                })
                .collect()
        };
        let sand = vec![5.0; 96 * 96];
        let west = Rose::new("wind", &[Wind::from(270.0, 1.0)]).unwrap();
        let found = dunes(&grid, &ridges([1.0, 0.0]), &sand, &west, 0.57, true);
        assert_eq!(found.class, DuneClass::Transverse);
        assert!((found.spacing.unwrap() - 24.0).abs() <= 2.0 && found.alignment > 0.95 && found.crest_to_wind > 85.0);
        assert!(found.crest_azimuth < 2.0 || found.crest_azimuth > 178.0, "{}", found.crest_azimuth);
        let linear = dunes(&grid, &ridges([0.0, 1.0]), &sand, &west, 0.57, true);
        assert!(linear.class == DuneClass::Linear && linear.crest_to_wind < 5.0, "{linear:?}");
        let flat = dunes(&grid, &vec![1.0; 96 * 96], &sand, &west, 0.57, true);
        assert_eq!((flat.class, flat.spacing), (DuneClass::None, None));
    }
}
