//! Light on a raster: how much of the sky and of the sun's disc each node sees.

use landform_core::grid::Grid;
use landform_core::{math, parallel};

const AZIMUTHS: usize = 12;

/// Part of the sky that each node sees, cosine-weighted, 0 to 1.
pub(super) fn sky_view(grid: &Grid, z: &[f64]) -> Vec<f64> {
    let directions: Vec<[f64; 2]> = (0..AZIMUTHS)
        .map(|k| std::f64::consts::TAU * (k as f64 + 0.5) / AZIMUTHS as f64)
        .map(|a| [math::cos(a), math::sin(a)])
        .collect();
    parallel::map(z.len(), |i| {
        let open: f64 = directions
            .iter()
            .map(|&d| {
                let tangent = horizon(grid, z, i, d, 1.45);
                1.0 / (1.0 + tangent * tangent)
            })
            .sum();
        open / AZIMUTHS as f64
    })
}

/// Part of the sun's disc (widened to three degrees for soft shadows) that each node sees.
pub(super) fn sun_view(grid: &Grid, z: &[f64], azimuth: f64, altitude: f64) -> Vec<f64> {
    let towards = [math::sin(azimuth), math::cos(azimuth)];
    let half = 1.5_f64.to_radians();
    parallel::map(z.len(), |i| {
        let angle = math::atan(horizon(grid, z, i, towards, 1.06));
        1.0 - math::smoothstep(altitude - half, altitude + half, angle)
    })
}

/// Tangent of the horizon's angle above level (at least 0) seen from a node; steps grow by a factor.
fn horizon(grid: &Grid, z: &[f64], node: usize, [east, north]: [f64; 2], growth: f64) -> f64 {
    let shape = grid.shape;
    let cell = shape.cell(node);
    let here = z[node];
    let unit = grid.spacing[0].min(grid.spacing[1]);
    let (dc, dr) = (east * unit / grid.spacing[0], -north * unit / grid.spacing[1]);
    let (mut step, mut highest) = (1.0_f64, 0.0_f64);
    loop {
        let (c, r) = (cell.col as f64 + dc * step, cell.row as f64 + dr * step);
        if c < 0.0 || r < 0.0 || c > (shape.cols - 1) as f64 || r > (shape.rows - 1) as f64 {
            return highest;
        }
        let there = z[shape.index((r + 0.5) as usize, (c + 0.5) as usize)];
        highest = highest.max((there - here) / (step * unit));
        step = (step * growth).max(step + 0.7);
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
