//! Light on a raster: how much of the sky and of the sun's disc each node sees.

use landform_core::grid::Grid;
use landform_core::{math, parallel};

const AZIMUTHS: usize = 12;

/// Part of the sky that each node sees, cosine-weighted, 0 to 1.
pub(super) fn sky_view(grid: &Grid, z: &[f64]) -> Vec<f64> {
    let azimuths = (0..AZIMUTHS).map(|k| std::f64::consts::TAU * (k as f64 + 0.5) / AZIMUTHS as f64);
    let lines: Vec<Vec<Look>> = azimuths.map(|a| looks(grid, [math::cos(a), math::sin(a)], 1.45)).collect();
    rows(grid, |row, open| {
        let mut tangent = vec![0.0; open.len()];
        for line in &lines {
            horizon(grid, z, row, line, &mut tangent);
            open.iter_mut().zip(&tangent).for_each(|(open, t)| *open += 1.0 / (1.0 + t * t));
        }
        open.iter_mut().for_each(|open| *open /= AZIMUTHS as f64);
    })
}

/// Part of the sun's disc (widened to three degrees for soft shadows) that each node sees.
pub(super) fn sun_view(grid: &Grid, z: &[f64], azimuth: f64, altitude: f64) -> Vec<f64> {
    let line = looks(grid, [math::sin(azimuth), math::cos(azimuth)], 1.06);
    let half = 1.5_f64.to_radians();
    let (low, high) = (math::tan((altitude - half).max(0.0)), math::tan((altitude + half).min(1.57)));
    rows(grid, |row, lit| {
        horizon(grid, z, row, &line, lit);
        for lit in lit {
            // Most ground lies clearly on one side of the shadow's edge.
            *lit = match *lit {
                t if t <= low && altitude > half => 1.0,
                t if t >= high => 0.0,
                t => 1.0 - math::smoothstep(altitude - half, altitude + half, math::atan(t)),
            };
        }
    })
}

fn rows(grid: &Grid, fill: impl Fn(usize, &mut [f64]) + Sync) -> Vec<f64> {
    let mut out = vec![0.0; grid.len()];
    parallel::for_rows_mut(&mut out, grid.shape.cols, fill);
    out
}

/// A node that is looked at from another: columns and rows away, and one over the distance, 1/m.
struct Look {
    cols: isize,
    rows: isize,
    per_distance: f64,
}

/// The nodes nearest to a line from a node, to the far side of the map; steps grow by a factor.
fn looks(grid: &Grid, [east, north]: [f64; 2], growth: f64) -> Vec<Look> {
    let unit = grid.spacing[0].min(grid.spacing[1]);
    let (dc, dr) = (east * unit / grid.spacing[0], -north * unit / grid.spacing[1]);
    let most = (grid.shape.cols.max(grid.shape.rows)) as f64;
    let (mut step, mut looks) = (1.0_f64, Vec::new());
    while (dc * step).abs().max((dr * step).abs()) < most {
        let nearest = |d: f64| (d * step + 0.5).floor() as isize;
        looks.push(Look { cols: nearest(dc), rows: nearest(dr), per_distance: 1.0 / (step * unit) });
        step = (step * growth).max(step + 0.7);
    }
    looks
}

/// Tangent of the horizon's angle above level (at least 0) seen from each node of a row. A look is
/// at the whole row at once.
fn horizon(grid: &Grid, z: &[f64], row: usize, line: &[Look], highest: &mut [f64]) {
    let n = grid.shape.cols;
    let here = &z[row * n..(row + 1) * n];
    highest.fill(0.0);
    for look in line {
        let Some(there) = row.checked_add_signed(look.rows).filter(|r| *r < grid.shape.rows) else { return };
        let there = &z[there * n..(there + 1) * n];
        let away = look.cols.unsigned_abs();
        let Some(kept) = n.checked_sub(away) else { return };
        let (from, to) = if look.cols < 0 { (away, 0) } else { (0, away) };
        let (here, there) = (&here[from..from + kept], &there[to..to + kept]);
        for ((highest, here), there) in highest[from..from + kept].iter_mut().zip(here).zip(there) {
            let tangent = (there - here) * look.per_distance;
            *highest = if tangent > *highest { tangent } else { *highest };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::Shape;

    #[test]
    fn a_plain_sees_all_and_a_wall_hides_half() {
        let grid = Grid::new(Shape::new(41, 41), [10.0, 10.0]).unwrap();
        let plain = vec![0.0; 1681];
        assert!(sky_view(&grid, &plain).iter().all(|&v| v == 1.0));
        let wall: Vec<f64> = (0..1681).map(|i| if i % 41 > 20 { 1e4 } else { 0.0 }).collect();
        let view = sky_view(&grid, &wall)[20 * 41 + 20];
        assert!((0.4..0.6).contains(&view), "{view}");
        let east = sun_view(&grid, &wall, std::f64::consts::FRAC_PI_2, 0.7);
        assert_eq!((east[20 * 41 + 10], east[20 * 41 + 30]), (0.0, 1.0));
    }
}
