//! A node relative to the ground around it.
//!
//! # Method
//! Square windows, cut at the border, nodata left out. Means come from running sums, extremes from
//! a sliding minimum (van Herk 1992, as a monotone queue), first along rows, then along columns:
//! cost does not grow with the window.
//!
//! # Sources
//! Topographic position index: Guisan, Weiss & Weiss (1999), elevation less the mean around it.
//! Local relief: greatest less least elevation.

use std::collections::VecDeque;

use crate::grid::Shape;
use crate::parallel;

/// Elevation less the mean of the window of (2 `radius` + 1)² nodes without the node itself, m
/// (topographic position index).
pub fn position_index(shape: Shape, values: &[f64], radius: usize) -> Vec<f64> {
    let filled: Vec<f64> = parallel::map(values.len(), |i| if values[i].is_nan() { 0.0 } else { values[i] });
    let present: Vec<f64> = parallel::map(values.len(), |i| f64::from(u8::from(!values[i].is_nan())));
    let (sum, count) = (window_sum(shape, &filled, radius), window_sum(shape, &present, radius));
    parallel::map(values.len(), |i| {
        let others = count[i] - 1.0;
        match values[i] {
            z if z.is_nan() => z,
            z if others > 0.0 => z - (sum[i] - z) / others,
            _ => 0.0,
        }
    })
}

/// Greatest less least elevation in the window of (2 `radius` + 1)² nodes, m.
pub fn local_relief(shape: Shape, values: &[f64], radius: usize) -> Vec<f64> {
    let high = window_max(shape, values, radius);
    let low: Vec<f64> = parallel::map(values.len(), |i| -values[i]);
    let low = window_max(shape, &low, radius);
    parallel::map(values.len(), |i| if values[i].is_nan() { f64::NAN } else { high[i] + low[i] })
}

fn window_sum(shape: Shape, values: &[f64], radius: usize) -> Vec<f64> {
    both_ways(shape, values, |line, out| {
        let n = line.len();
        let mut sum: f64 = line[..radius.min(n)].iter().sum();
        for i in 0..n {
            if i + radius < n {
                sum += line[i + radius];
            }
            if i > radius {
                sum -= line[i - radius - 1];
            }
            out[i] = sum;
        }
    })
}

fn window_max(shape: Shape, values: &[f64], radius: usize) -> Vec<f64> {
    both_ways(shape, values, |line, out| {
        let mut queue: VecDeque<usize> = VecDeque::new();
        for i in 0..line.len() + radius {
            if i < line.len() && !line[i].is_nan() {
                while queue.back().is_some_and(|&k| line[k] <= line[i]) {
                    queue.pop_back();
                }
                queue.push_back(i);
            }
            if i >= radius {
                while queue.front().is_some_and(|&k| k + radius < i - radius) {
                    queue.pop_front();
                }
                out[i - radius] = queue.front().map_or(f64::NAN, |&k| line[k]);
            }
        }
    })
}

/// Applies `f(line, out)` along rows, then along columns.
fn both_ways(shape: Shape, values: &[f64], f: impl Fn(&[f64], &mut [f64]) + Sync) -> Vec<f64> {
    let along = |values: &[f64], cols: usize| {
        let mut out = vec![0.0; values.len()];
        parallel::for_rows_mut(&mut out, cols, |row, out| f(&values[row * cols..(row + 1) * cols], out));
        out
    };
    let turned = |values: &[f64], rows: usize, cols: usize| -> Vec<f64> {
        parallel::map(values.len(), |i| values[i % rows * cols + i / rows])
    };
    let rows_done = along(values, shape.cols);
    let cols_done = along(&turned(&rows_done, shape.rows, shape.cols), shape.rows);
    turned(&cols_done, shape.cols, shape.rows)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Seed;

    #[test]
    fn windows_agree_with_the_definition() {
        let shape = Shape::new(13, 17);
        let z: Vec<f64> =
            (0..shape.len()).map(|i| if i % 29 == 3 { f64::NAN } else { Seed(1).uniform(i as u64) }).collect();
        for radius in [1, 3, 20] {
            let (tpi, relief) = (position_index(shape, &z, radius), local_relief(shape, &z, radius));
            for i in (0..z.len()).filter(|&i| !z[i].is_nan()) {
                let at = shape.cell(i);
                let near = |j: &usize| {
                    let c = shape.cell(*j);
                    c.row.abs_diff(at.row) <= radius && c.col.abs_diff(at.col) <= radius && !z[*j].is_nan()
                };
                let around: Vec<f64> = (0..z.len()).filter(near).map(|j| z[j]).collect();
                let mean = (around.iter().sum::<f64>() - z[i]) / (around.len() - 1) as f64;
                let range = around.iter().copied().fold(f64::NEG_INFINITY, f64::max)
                    - around.iter().copied().fold(f64::INFINITY, f64::min);
                assert!((tpi[i] - (z[i] - mean)).abs() < 1e-12 && (relief[i] - range).abs() < 1e-12);
            }
        }
    }
}
