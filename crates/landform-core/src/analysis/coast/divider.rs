//! Walking along a line with a pair of compasses.
//!
//! # Method
//! From the first point to the next place where the line leaves the circle of the step's radius,
//! and so on; what is left at the end counts as a part of a step. D is minus the slope of ln N on
//! ln s over steps that grow by √2.
//!
//! # Sources
//! Richardson (1961); Mandelbrot (1967).

use serde::{Deserialize, Serialize};

use super::{Dimension, extent, length};
use crate::math;

/// Ratio of the greatest step to the least from which steps say something about a dimension.
const DECADE: f64 = 10.0;

/// What a divider tells of a line: its dimension, or why it tells none.
///
/// ```
/// use landform_core::analysis::Divider;
///
/// let line: Vec<[f64; 2]> = (0..=900).map(|k| [f64::from(k), 0.0]).collect();
/// let straight = Divider::along(&line, 4.0, f64::INFINITY);
/// assert!((straight.dimension.unwrap_or(0.0) - 1.0).abs() < 0.01 && straight.why.is_none());
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Divider {
    /// Minus the slope of log count on log step, the dimension; none if the steps span less than a
    /// decade.
    pub dimension: Option<f64>,
    /// R² of the straight line; none with fewer than four steps.
    pub r2: Option<f64>,
    /// Least step that was walked, m.
    pub least_step: Option<f64>,
    /// Greatest step that was walked, m.
    pub greatest_step: Option<f64>,
    /// Why there is no dimension.
    pub why: Option<String>,
    /// (step in m, count).
    pub points: Vec<(f64, f64)>,
}

impl Divider {
    /// Walks along a line with steps from `least` to a quarter of its extent, or `most` (m).
    ///
    /// ```
    /// use landform_core::analysis::Divider;
    ///
    /// let short = Divider::along(&[[0.0, 0.0], [90.0, 0.0]], 4.0, f64::INFINITY);
    /// assert!(short.dimension.is_none() && short.why.is_some());
    /// assert_eq!(short.least_step, Some(4.0));
    /// ```
    pub fn along(points: &[[f64; 2]], least: f64, most: f64) -> Self {
        let points = walks(points, least, most);
        let (first, last) = (points.first().map(|p| p.0), points.last().map(|p| p.0));
        let fit = Dimension::of(points.clone());
        let span = first.zip(last).map(|(first, last)| last / first);
        let why = match span {
            Some(span) if fit.is_some() && span >= DECADE => None,
            None => Some("no step fits: the line is too short".to_string()),
            Some(span) => {
                let decades = math::log10(span);
                Some(format!("steps span {decades:.2} decades; a dimension needs 1: a longer line or finer points"))
            }
        };
        let dimension = fit.as_ref().filter(|_| why.is_none()).map(|fit| fit.dimension);
        Self { dimension, r2: fit.map(|fit| fit.r2), least_step: first, greatest_step: last, why, points }
    }
}

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
    Dimension::of(walks(points, least, most))
}

/// Steps and their counts; none where a walk would take too long.
fn walks(points: &[[f64; 2]], least: f64, most: f64) -> Vec<(f64, f64)> {
    if !(least > 1e-7 * length(points)) {
        return Vec::new();
    }
    // Beyond a quarter of the extent a walk has too few steps to say anything.
    let most = if most.is_finite() { most * (1.0 + 1e-9) } else { 0.25 * extent(points.iter()) };
    let sizes = (0..).map(|k| least * math::pow(2.0, 0.5 * f64::from(k))).take_while(|s| *s <= most);
    sizes.map(|s| (s, divider_steps(points, s))).filter(|p| p.1 >= 1.0).collect()
}
