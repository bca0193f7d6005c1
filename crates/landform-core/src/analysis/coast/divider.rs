//! Walking along a line with a pair of compasses.
//!
//! # Method
//! From the first point to the next place where the line leaves the circle of the step's radius,
//! and so on; what is left at the end counts as a part of a step. D is minus the slope of ln N on
//! ln s over steps that grow by √2.
//!
//! # Sources
//! Richardson (1961); Mandelbrot (1967).

use super::{Dimension, extent, length};
use crate::math;

/// Number of steps of length `step` along a line.
pub fn divider_steps(points: &[[f64; 2]], step: f64) -> f64 {
    let Some((&first, _)) = points.split_first() else { return 0.0 };
    let (mut at, mut segment, mut part) = (first, 0, 0.0);
    let mut steps = 0.0;
    while let Some((k, t)) = next_step(points, at, step, segment, part) {
        at = [0, 1].map(|i| math::lerp(points[k][i], points[k + 1][i], t));
        (segment, part) = (k, t);
        steps += 1.0;
    }
    let last = points[points.len() - 1];
    steps + math::hypot(last[0] - at[0], last[1] - at[1]) / step
}

/// Segment and part of it at which the line next leaves the circle around `at`, on or after a place
/// on it.
fn next_step(points: &[[f64; 2]], at: [f64; 2], step: f64, segment: usize, part: f64) -> Option<(usize, f64)> {
    let mut from = part;
    for k in segment..points.len() - 1 {
        if let Some(t) = leaves(at, points[k], points[k + 1], step, from) {
            return Some((k, t));
        }
        from = 0.0;
    }
    None
}

/// Where on the segment a–b, at or after `from`, the line leaves the circle around `centre`.
fn leaves(centre: [f64; 2], a: [f64; 2], b: [f64; 2], radius: f64, from: f64) -> Option<f64> {
    let d = [b[0] - a[0], b[1] - a[1]];
    let f = [a[0] - centre[0], a[1] - centre[1]];
    // Only the end can be outside if the segment leaves for good; the far crossing is the way out.
    if math::hypot(b[0] - centre[0], b[1] - centre[1]) < radius {
        return None;
    }
    let (aa, bb) = (d[0] * d[0] + d[1] * d[1], f[0] * d[0] + f[1] * d[1]);
    let cc = f[0] * f[0] + f[1] * f[1] - radius * radius;
    let root = bb * bb - aa * cc;
    if aa == 0.0 || root < 0.0 {
        return None;
    }
    let t = (-bb + root.sqrt()) / aa;
    (t > from && t <= 1.0).then_some(t)
}

/// The dimension over steps from `least` to a quarter of the line's extent, or `most`; none if
/// fewer than four steps fit, or `least` is so small that a walk would take more than ten million
/// steps.
pub fn dimension_by_divider(points: &[[f64; 2]], least: f64, most: f64) -> Option<Dimension> {
    if !(least > 1e-7 * length(points)) {
        return None;
    }
    // Beyond a quarter of the extent a walk has too few steps to say anything.
    let most = if most.is_finite() { most * (1.0 + 1e-9) } else { 0.25 * extent(points.iter()) };
    let sizes = (0..).map(|k| least * math::pow(2.0, 0.5 * f64::from(k))).take_while(|s| *s <= most);
    Dimension::of(sizes.map(|s| (s, divider_steps(points, s))).filter(|p| p.1 >= 1.0).collect())
}
