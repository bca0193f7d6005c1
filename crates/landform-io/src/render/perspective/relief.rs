//! The surface that rays meet: bilinear patches between nodes, under a pyramid of their highest
//! points.

use landform_core::grid::{Grid, Shape};
use landform_core::math;

use super::block;
use crate::render::pyramid::Pyramid;
use crate::vector::Vector;

/// A surface in local metres: x east, y north from the south-west corner.
pub(super) struct Relief {
    shape: Shape,
    pub(super) spacing: [f64; 2],
    pub(super) extent: [f64; 2],
    pub(super) surface: Vec<f64>,
    pyramid: Pyramid,
}

/// A ray in columns and rows: where it is at the start, and its way a metre.
struct GridRay {
    from: [f64; 2],
    speed: [f64; 2],
    height: f64,
    rise: f64,
}

impl GridRay {
    fn at(&self, t: f64) -> [f64; 2] {
        [self.from[0] + t * self.speed[0], self.from[1] + t * self.speed[1]]
    }

    fn height(&self, t: f64) -> f64 {
        self.height + t * self.rise
    }
}

impl Relief {
    pub(super) fn new(grid: &Grid, surface: Vec<f64>) -> Self {
        let pyramid = Pyramid::new(grid.shape, &surface);
        Self { shape: grid.shape, spacing: grid.spacing, extent: block::extent(grid), surface, pyramid }
    }

    /// The four nodes around a place (north-west, north-east, south-west, south-east), and how far
    /// it lies east and south of the first, in cells.
    pub(super) fn corners(&self, p: Vector) -> ([usize; 4], [f64; 2]) {
        let c = (p[0] / self.spacing[0]).clamp(0.0, (self.shape.cols - 1) as f64);
        let r = ((self.extent[1] - p[1]) / self.spacing[1]).clamp(0.0, (self.shape.rows - 1) as f64);
        let (col, row) = (c as usize, r as usize);
        (self.nodes_of(col, row), [c - col as f64, r - row as f64])
    }

    fn nodes_of(&self, col: usize, row: usize) -> [usize; 4] {
        let (east, south) = ((col + 1).min(self.shape.cols - 1), (row + 1).min(self.shape.rows - 1));
        let at = |r, c| self.shape.index(r, c);
        [at(row, col), at(row, east), at(south, col), at(south, east)]
    }

    pub(super) fn height_at(&self, p: Vector) -> f64 {
        let (k, [u, v]) = self.corners(p);
        let [a, b, c, d] = k.map(|i| self.surface[i]);
        math::lerp(math::lerp(a, b, u), math::lerp(c, d, u), v)
    }

    /// Distance to the surface along a ray, by leaps over blocks that it passes above.
    pub(super) fn march(&self, from: Vector, direction: Vector, start: f64, leave: f64) -> Option<f64> {
        let ray = GridRay {
            from: [from[0] / self.spacing[0], (self.extent[1] - from[1]) / self.spacing[1]],
            speed: [direction[0] / self.spacing[0], -direction[1] / self.spacing[1]],
            height: from[2],
            rise: direction[2],
        };
        // Times at which it crosses a whole column or row are products, not quotients.
        // Along one that it does not cross, the wall behind is never reached.
        let per_speed = ray.speed.map(|v| if v == 0.0 { f64::NEG_INFINITY } else { 1.0 / v });
        let ahead = ray.speed.map(|v| usize::from(v > 0.0));
        let nudge = 1e-6 * self.spacing[0];
        let top = self.pyramid.levels.len() - 1;
        let cells = self.pyramid.levels[0].0;
        let (mut t, mut level) = (start, top);
        while t < leave {
            let now = t + nudge;
            let [c, r] = ray.at(now);
            let cell = [(c.max(0.0) as usize).min(cells.cols - 1), (r.max(0.0) as usize).min(cells.rows - 1)];
            let mut end = leave;
            for k in 0..2 {
                let wall = (((cell[k] >> level) + ahead[k]) << level) as f64;
                let time = (wall - ray.from[k]) * per_speed[k];
                // Beside the map a ray may be past the wall already.
                end = if time < end { time.max(now) } else { end };
            }
            let (blocks, greatest) = &self.pyramid.levels[level];
            let lowest = ray.height(t).min(ray.height(end));
            if lowest > f64::from(greatest[blocks.index(cell[1] >> level, cell[0] >> level)]) {
                t = end.max(now);
                level = (level + 1).min(top);
            } else if level > 0 {
                level -= 1;
            } else {
                if let Some(hit) = self.meet(&ray, cell, t, end) {
                    return Some(hit);
                }
                t = end.max(now);
            }
        }
        None
    }

    /// When a ray goes under the patch of a cell: its height over a bilinear patch is a quadratic
    /// of the way.
    fn meet(&self, ray: &GridRay, cell: [usize; 2], start: f64, end: f64) -> Option<f64> {
        let [a, b, c, d] = self.nodes_of(cell[0], cell[1]).map(|i| self.surface[i]);
        let (east, south, twist) = (b - a, c - a, a - b - c + d);
        let [x, y] = ray.at(start);
        let [u, v] = [x - cell[0] as f64, y - cell[1] as f64];
        let [along_u, along_v] = ray.speed;
        let over = ray.height(start) - (a + east * u + south * v + twist * u * v);
        if over <= 0.0 {
            return Some(start);
        }
        let slope = ray.rise - east * along_u - south * along_v - twist * (u * along_v + v * along_u);
        let bend = -twist * along_u * along_v;
        let root = (slope * slope - 4.0 * bend * over).sqrt();
        if root.is_nan() {
            return None;
        }
        // Without cancellation; a plane patch has one crossing.
        let q = -0.5 * (slope + root.copysign(slope));
        let first =
            [over / q, q / bend].into_iter().filter(|s| *s > 0.0 && s.is_finite()).fold(f64::INFINITY, f64::min);
        (start + first <= end).then_some(start + first)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vector::{along, normalize};

    /// Where a ray first is under the surface, by small steps.
    fn by_steps(relief: &Relief, from: Vector, direction: Vector, leave: f64) -> Option<f64> {
        let steps = 200_000;
        (0..steps).map(|k| leave * f64::from(k) / f64::from(steps)).find(|t| {
            let p = along(from, direction, *t);
            p[2] <= relief.height_at(p)
        })
    }

    #[test]
    fn rays_meet_the_surface_where_small_steps_do() {
        let grid = Grid::new(Shape::new(17, 23), [10.0, 7.0]).unwrap();
        let z = (0..grid.len()).map(|i| 12.0 * math::sin(1.3 * i as f64) + (i % 5) as f64).collect();
        let relief = Relief::new(&grid, z);
        for k in 0..60 {
            let (angle, down) = (0.37 * f64::from(k), 0.05 + 0.01 * f64::from(k % 20));
            let direction = normalize([math::cos(angle), math::sin(angle), -down]);
            let from = [110.0, 56.0, 20.0];
            let out = |k: usize| {
                let wall = if direction[k] > 0.0 { relief.extent[k] } else { 0.0 };
                (wall - from[k]) / direction[k]
            };
            let leave = out(0).min(out(1));
            let (hit, expected) =
                (relief.march(from, direction, 0.0, leave), by_steps(&relief, from, direction, leave));
            match (hit, expected) {
                (Some(hit), Some(expected)) => assert!((hit - expected).abs() < 2e-3, "{k}: {hit} {expected}"),
                (None, None) => {}
                other => panic!("{k}: {other:?}"),
            }
        }
    }

    #[test]
    fn strips_and_upright_rays_are_met() {
        let strip = Relief::new(&Grid::new(Shape::new(1, 5), [10.0, 10.0]).unwrap(), vec![1.0; 5]);
        let down = strip.march([20.0, 0.0, 5.0], [0.0, 0.0, -1.0], 0.0, 100.0);
        assert!(down.is_some_and(|t| (t - 4.0).abs() < 1e-9), "{down:?}");
    }
}
