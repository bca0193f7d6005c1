//! Slope and curvature from a quadratic surface through the nine nodes around a node.
//!
//! # Sources
//! Evans (1972): the least-squares quadratic z = ½ r x² + s x y + ½ t y² + p x + q y + z₀ over a 3
//! × 3 window; Zevenbergen & Thorne (1987) for the slope through the four neighbours alone.
//! Curvatures as Minár et al. (2020) name them: profile (along the slope) and plan (of the
//! contour), positive where the ground is convex, in 1/m.

use crate::grid::Grid;

use super::horn::{Gradient, window};

/// First and second derivatives at a node, x east and y north.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic {
    /// ∂z/∂x, rise over run.
    pub p: f64,
    /// ∂z/∂y, rise over run.
    pub q: f64,
    /// ∂²z/∂x², 1/m.
    pub r: f64,
    /// ∂²z/∂x∂y, 1/m.
    pub s: f64,
    /// ∂²z/∂y², 1/m.
    pub t: f64,
}

impl Quadratic {
    /// Curvature along the line of steepest slope, 1/m: positive on shoulders, negative at the foot
    /// of a slope; 0 on level ground.
    pub fn profile_curvature(self) -> f64 {
        let Self { p, q, r, s, t } = self;
        let g = p * p + q * q;
        if g == 0.0 { 0.0 } else { -(p * p * r + 2.0 * p * q * s + q * q * t) / (g * (1.0 + g) * (1.0 + g).sqrt()) }
    }

    /// Curvature of the contour, 1/m: positive on spurs, negative in hollows; 0 on level ground.
    pub fn plan_curvature(self) -> f64 {
        let Self { p, q, r, s, t } = self;
        let g = p * p + q * q;
        if g == 0.0 { 0.0 } else { -(q * q * r - 2.0 * p * q * s + p * p * t) / (g * g.sqrt()) }
    }
}

/// The quadratic at a node, by values in m; NaN on nodata. Beyond the border and on nodata the
/// surface goes on as a plane.
pub fn quadratic(grid: &Grid, values: &[f64], node: usize) -> Quadratic {
    let [nw, n, ne, w, z, e, sw, s, se] = window(grid, values, node);
    let [dx, dy] = grid.spacing;
    Quadratic {
        p: ((ne + e + se) - (nw + w + sw)) / (6.0 * dx),
        q: ((nw + n + ne) - (sw + s + se)) / (6.0 * dy),
        r: ((nw + w + sw + ne + e + se) - 2.0 * (n + z + s)) / (3.0 * dx * dx),
        s: ((ne + sw) - (nw + se)) / (4.0 * dx * dy),
        t: ((nw + n + ne + sw + s + se) - 2.0 * (w + z + e)) / (3.0 * dy * dy),
    }
}

/// The gradient (rise over run) through the four neighbours (Zevenbergen & Thorne 1987); NaN on
/// nodata.
pub fn gradient_of_four(grid: &Grid, values: &[f64], node: usize) -> Gradient {
    let [_, n, _, w, _, e, _, s, _] = window(grid, values, node);
    Gradient { x: (e - w) / (2.0 * grid.spacing[0]), y: (n - s) / (2.0 * grid.spacing[1]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;

    #[test]
    fn a_quadratic_surface_is_found_exactly() {
        let grid = Grid::new(Shape::new(5, 5), [2.0, 3.0]).unwrap();
        let f = |[x, y]: [f64; 2]| 0.05 * x * x + 0.02 * x * y - 0.03 * y * y + 0.3 * x - 0.1 * y;
        let z: Vec<f64> = (0..25).map(|i| f(grid.position(i))).collect();
        let [x, y] = grid.position(12);
        let found = quadratic(&grid, &z, 12);
        let expected = [0.1 * x + 0.02 * y + 0.3, 0.02 * x - 0.06 * y - 0.1, 0.1, 0.02, -0.06];
        let found_all = [found.p, found.q, found.r, found.s, found.t];
        assert!(found_all.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found_all:?}");
        let four = gradient_of_four(&grid, &z, 12);
        assert!((four.x - expected[0]).abs() < 1e-12 && (four.y - expected[1]).abs() < 1e-12);
    }

    #[test]
    fn a_dome_is_convex_both_ways_and_a_cone_along_contours_only() {
        let grid = Grid::new(Shape::new(41, 41), [1.0, 1.0]).unwrap();
        let radius = |i: usize| {
            let [x, y] = grid.position(i);
            ((x - 20.0) * (x - 20.0) + (y - 20.0) * (y - 20.0)).sqrt()
        };
        let cone: Vec<f64> = (0..grid.len()).map(|i| -0.5 * radius(i)).collect();
        let at = grid.shape.index(20, 35);
        let c = quadratic(&grid, &cone, at);
        // Contours are circles of radius 15.
        assert!((c.plan_curvature() - 1.0 / 15.0).abs() < 1e-3 && c.profile_curvature().abs() < 1e-3);
        let dome: Vec<f64> = (0..grid.len()).map(|i| -0.01 * radius(i) * radius(i)).collect();
        let d = quadratic(&grid, &dome, at);
        assert!(d.plan_curvature() > 0.0 && d.profile_curvature() > 0.0);
    }
}
