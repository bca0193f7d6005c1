//! Counting the boxes that lines pass through.
//!
//! # Method
//! Boxes of a square lattice, counted for four positions of the lattice; the mean of the four.
//! Sizes grow by √2 up to an eighth of the extent.

use super::{Dimension, extent, length};
use crate::math;

/// Number of boxes of side `size` (m) that lines pass through, the mean of four positions of the
/// lattice.
pub fn box_counts(lines: &[&[[f64; 2]]], size: f64) -> f64 {
    let counts = [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5]].map(|shift| {
        let mut boxes: Vec<(i64, i64)> = Vec::new();
        for line in lines {
            for pair in line.windows(2) {
                let scaled = [pair[0], pair[1]].map(|p| [p[0] / size + shift[0], p[1] / size + shift[1]]);
                cross(scaled[0], scaled[1], &mut boxes);
            }
            // Neighbouring segments repeat boxes; keep the list short.
            if boxes.len() > 1 << 22 {
                boxes.sort_unstable();
                boxes.dedup();
            }
        }
        boxes.sort_unstable();
        boxes.dedup();
        boxes.len()
    });
    counts.into_iter().sum::<usize>() as f64 / 4.0
}

/// The unit boxes that a segment passes through.
fn cross(a: [f64; 2], b: [f64; 2], boxes: &mut Vec<(i64, i64)>) {
    let cell = |p: [f64; 2]| (math::floor(p[0]) as i64, math::floor(p[1]) as i64);
    let (mut at, end) = (cell(a), cell(b));
    if boxes.last() != Some(&at) {
        boxes.push(at);
    }
    let d = [b[0] - a[0], b[1] - a[1]];
    let next = |k: usize, c: i64| {
        let line = if d[k] > 0.0 { c as f64 + 1.0 } else { c as f64 };
        if d[k] == 0.0 { f64::INFINITY } else { (line - a[k]) / d[k] }
    };
    for _ in 0..(at.0.abs_diff(end.0) + at.1.abs_diff(end.1)) {
        if next(0, at.0) <= next(1, at.1) {
            at.0 += if d[0] > 0.0 { 1 } else { -1 };
        } else {
            at.1 += if d[1] > 0.0 { 1 } else { -1 };
        }
        boxes.push(at);
    }
}

/// The dimension by boxes from `least` (m) to an eighth of the lines' extent, or `most`; none if
/// fewer than four sizes fit, or `least` is so small that more than ten million boxes would be
/// counted.
pub fn dimension_by_boxes(lines: &[&[[f64; 2]]], least: f64, most: f64) -> Option<Dimension> {
    if !(least > 1e-7 * lines.iter().map(|l| length(l)).sum::<f64>()) {
        return None;
    }
    let most = (0.125 * extent(lines.iter().flat_map(|l| l.iter()))).min(most * (1.0 + 1e-9));
    let sizes = (0..).map(|k| least * math::pow(2.0, 0.5 * f64::from(k))).take_while(|s| *s <= most);
    Dimension::of(sizes.map(|s| (s, box_counts(lines, s))).collect())
}
