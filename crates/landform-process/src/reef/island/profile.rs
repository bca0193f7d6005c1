//! Curves through control points.

use landform_core::{Error, Result};

/// A smooth curve through points that does not overshoot: between two points it is monotone. Before
/// the first point and beyond the last it is level.
///
/// Cubic Hermite pieces with the slopes of Fritsch & Butland (1984), in the form for uneven spans.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Curve {
    x: Vec<f64>,
    y: Vec<f64>,
    slope: Vec<f64>,
}

/// Most points of a curve.
const MOST: usize = 1000;

impl Curve {
    /// Through at least two points (x, y) with x that grows.
    pub(super) fn through(name: &str, points: &[[f64; 2]]) -> Result<Self> {
        if !(2..=MOST).contains(&points.len()) {
            return Err(Error::parameter(name, format!("{} points", points.len()), &format!("2 to {MOST} points")));
        }
        if let Some(pair) = points.windows(2).find(|p| !(p[1][0] > p[0][0])) {
            let found = format!("a point at {} m after one at {} m", pair[1][0], pair[0][0]);
            return Err(Error::parameter(name, found, "distances that grow"));
        }
        let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (p[0], p[1])).unzip();
        let secant = |k: usize| (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
        let inner = |k: usize| {
            let (before, after) = (secant(k - 1), secant(k));
            if !(before * after > 0.0) {
                return 0.0;
            }
            let (left, right) = (x[k] - x[k - 1], x[k + 1] - x[k]);
            let (a, b) = (2.0 * right + left, right + 2.0 * left);
            (a + b) / (a / before + b / after)
        };
        let last = x.len() - 1;
        let slope = (0..=last).map(|k| if k == 0 || k == last { 0.0 } else { inner(k) }).collect();
        Ok(Self { x, y, slope })
    }

    /// The value at x.
    pub(super) fn at(&self, x: f64) -> f64 {
        let last = self.x.len() - 1;
        if !(x > self.x[0]) {
            return self.y[0];
        }
        if x >= self.x[last] {
            return self.y[last];
        }
        let k = self.x.partition_point(|&p| p <= x) - 1;
        let h = self.x[k + 1] - self.x[k];
        let t = (x - self.x[k]) / h;
        let (u, tt) = (1.0 - t, t * t);
        let value = (1.0 + 2.0 * t) * u * u * self.y[k] + tt * (3.0 - 2.0 * t) * self.y[k + 1];
        value + h * (t * u * u * self.slope[k] - tt * u * self.slope[k + 1])
    }

    /// The greatest x at which the curve comes down to a value; none where it never does.
    pub(super) fn last_at(&self, value: f64) -> Option<f64> {
        let k = (0..self.x.len() - 1).rev().find(|&k| self.y[k] > value && self.y[k + 1] <= value)?;
        let (mut low, mut high) = (self.x[k], self.x[k + 1]);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.at(middle) > value { low = middle } else { high = middle }
        }
        Some(high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_pass_through_their_points_and_fall_between_them() {
        let points = [[0.0, 600.0], [900.0, 180.0], [1600.0, 0.0], [2600.0, -900.0]];
        let curve = Curve::through("profile", &points).unwrap();
        assert!(points.iter().all(|p| (curve.at(p[0]) - p[1]).abs() < 1e-9));
        let heights: Vec<f64> = (0..=3000).map(|x| curve.at(f64::from(x))).collect();
        assert!(heights.windows(2).all(|w| w[1] <= w[0]) && heights[3000] == -900.0 && curve.at(-5.0) == 600.0);
        // No kink at a point.
        let rise = |x: f64| (curve.at(x + 1e-4) - curve.at(x - 1e-4)) / 2e-4;
        assert!(points.iter().all(|p| (rise(p[0] - 0.01) - rise(p[0] + 0.01)).abs() < 1e-3));
        assert!((curve.last_at(-300.0).map(|x| curve.at(x)).unwrap() + 300.0).abs() < 1e-6);
        assert_eq!(curve.last_at(-1000.0), None);
    }

    #[test]
    fn wrong_points_are_refused() {
        for points in [&[[0.0, 1.0]][..], &[[5.0, 1.0], [5.0, 0.0]], &[[0.0, 1.0], [f64::NAN, 0.0]]] {
            assert!(Curve::through("profile", points).is_err());
        }
    }
}
