//! Elevation, normal and extent of a surface.

use super::{HeightField, Mesh, NodeSurface, Terrain};

/// A box: least and greatest x, y, z, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least coordinates, m.
    pub low: [f64; 3],
    /// Greatest coordinates, m.
    pub high: [f64; 3],
}

impl Bounds {
    /// The box around some places, m; around none it is empty, with infinite sides.
    ///
    /// ```
    /// use landform_core::terrain::Bounds;
    ///
    /// let all = Bounds::around(&[[0.0, 5.0, 1.0], [2.0, 3.0, 1.0]]);
    /// assert_eq!((all.low, all.high), ([0.0, 3.0, 1.0], [2.0, 5.0, 1.0]));
    /// ```
    pub fn around(places: &[[f64; 3]]) -> Self {
        let fold = |f: fn(f64, f64) -> f64, start: f64| {
            places.iter().fold([start; 3], |b, p| [f(b[0], p[0]), f(b[1], p[1]), f(b[2], p[2])])
        };
        Self { low: fold(f64::min, f64::INFINITY), high: fold(f64::max, f64::NEG_INFINITY) }
    }
}

/// A terrain whose surface can be asked for.
pub trait Ground: Terrain {
    /// The box around the surface.
    fn bounding_box(&self) -> Bounds;

    /// Elevation of the uppermost surface at a place, m; none beyond the ground and on nodata.
    fn height_at(&self, place: [f64; 2]) -> Option<f64>;

    /// The distance below which the surface is not resolved, m.
    fn resolution(&self) -> f64;

    /// Unit normal of the surface at a place, pointing out of the ground; straight up beyond the
    /// ground. By default from differences over the resolution.
    fn normal_at(&self, place: [f64; 2]) -> [f64; 3] {
        let Some(middle) = self.height_at(place) else { return [0.0, 0.0, 1.0] };
        let half = 0.5 * self.resolution();
        let slope = |k: usize| {
            let beside = |by: f64| {
                let mut place = place;
                place[k] += by;
                self.height_at(place).map(|z| (by, z))
            };
            let (a, b) = (beside(-half).unwrap_or((0.0, middle)), beside(half).unwrap_or((0.0, middle)));
            if b.0 > a.0 { (b.1 - a.1) / (b.0 - a.0) } else { 0.0 }
        };
        let (gx, gy) = (slope(0), slope(1));
        let length = (1.0 + gx * gx + gy * gy).sqrt();
        [-gx / length, -gy / length, 1.0 / length]
    }

    /// How far a place lies under the surface, m, negative over it; none beyond the ground and on
    /// nodata. By default straight up.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Ground, HeightField};
    ///
    /// let plain = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![50.0; 9])?;
    /// assert_eq!(plain.depth_at([5.0, 5.0, 48.0]), Some(2.0));
    /// assert_eq!(plain.depth_at([-5.0, 5.0, 48.0]), None);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn depth_at(&self, [x, y, z]: [f64; 3]) -> Option<f64> {
        self.height_at([x, y]).map(|h| h - z)
    }

    /// The point of the surface beside a place (m), and its unit normal out of the ground; none
    /// beyond the ground and on nodata. By default along the normal over or under the place.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::terrain::{Ground, HeightField};
    ///
    /// let plain = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![50.0; 9])?;
    /// assert_eq!(plain.contact([5.0, 5.0, 48.0]), Some(([5.0, 5.0, 50.0], [0.0, 0.0, 1.0])));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    fn contact(&self, place: [f64; 3]) -> Option<([f64; 3], [f64; 3])> {
        along_normal(place, |[x, y]| Some((self.height_at([x, y])?, self.normal_at([x, y]))))
    }

    /// Where a straight line from `from` to `to` first enters the ground, as a part of its length,
    /// 0 to 1; none if it does not. By default in steps of half the resolution, halved further to a
    /// thousandth of it: narrower ridges are missed.
    fn hit(&self, from: [f64; 3], to: [f64; 3]) -> Option<f64> {
        let at = |t: f64| [0, 1, 2].map(|k| from[k] + t * (to[k] - from[k]));
        let inside = |t: f64| {
            let [x, y, z] = at(t);
            self.height_at([x, y]).is_some_and(|h| z <= h)
        };
        if inside(0.0) {
            return Some(0.0);
        }
        let across = ((to[0] - from[0]) * (to[0] - from[0]) + (to[1] - from[1]) * (to[1] - from[1])).sqrt();
        let steps = (2.0 * across / self.resolution()).ceil().clamp(1.0, 1e7) as usize;
        let first = (1..=steps).find(|&k| inside(k as f64 / steps as f64))?;
        let (mut low, mut high) = ((first - 1) as f64 / steps as f64, first as f64 / steps as f64);
        for _ in 0..10 {
            let middle = 0.5 * (low + high);
            if inside(middle) { high = middle } else { low = middle }
        }
        Some(high)
    }
}

/// The point of a surface along its normal from a place, and the normal there; `surface` gives the
/// height and the normal at a place of the map.
fn along_normal(
    [x, y, z]: [f64; 3],
    surface: impl Fn([f64; 2]) -> Option<(f64, [f64; 3])>,
) -> Option<([f64; 3], [f64; 3])> {
    let (height, normal) = surface([x, y])?;
    let depth = (height - z) * normal[2];
    let beside = [x + depth * normal[0], y + depth * normal[1]];
    match surface(beside) {
        Some((height, normal)) => Some(([beside[0], beside[1], height], normal)),
        None => Some(([x, y, height], normal)),
    }
}

fn span(surface: &impl NodeSurface) -> Bounds {
    let [[west, south], [east, north]] = surface.bounds();
    let range = |(a, b): (f64, f64), &z: &f64| (a.min(z), b.max(z));
    let (low, high) = surface.elevation().iter().fold((f64::INFINITY, f64::NEG_INFINITY), range);
    Bounds { low: [west, south, low], high: [east, north, high] }
}

impl Ground for HeightField {
    fn bounding_box(&self) -> Bounds {
        span(self)
    }

    fn height_at(&self, place: [f64; 2]) -> Option<f64> {
        Some(self.elevation_at(place)).filter(|z| !z.is_nan())
    }

    /// The slope is that of the bilinear surface at the point itself.
    fn contact(&self, place: [f64; 3]) -> Option<([f64; 3], [f64; 3])> {
        along_normal(place, |at| {
            let (height, [gx, gy]) = self.height_and_slope(at)?;
            let length = (1.0 + gx * gx + gy * gy).sqrt();
            Some((height, [-gx / length, -gy / length, 1.0 / length]))
        })
    }

    fn resolution(&self) -> f64 {
        self.grid().spacing[0].min(self.grid().spacing[1])
    }
}

impl Ground for Mesh {
    fn bounding_box(&self) -> Bounds {
        span(self)
    }

    /// **Cost** O(triangles): all are examined.
    fn height_at(&self, [x, y]: [f64; 2]) -> Option<f64> {
        self.triangles().iter().find_map(|&corners| {
            let [a, b, c] = corners.map(|i| self.positions()[i as usize]);
            let cross =
                |o: [f64; 2], u: [f64; 2], v: [f64; 2]| (u[0] - o[0]) * (v[1] - o[1]) - (u[1] - o[1]) * (v[0] - o[0]);
            let total = cross(a, b, c);
            let weights = [cross([x, y], b, c) / total, cross(a, [x, y], c) / total, cross(a, b, [x, y]) / total];
            let z = || (0..3).map(|k| weights[k] * self.elevation()[corners[k] as usize]).sum();
            weights.iter().all(|w| *w >= -1e-12).then(z)
        })
    }

    fn resolution(&self) -> f64 {
        (self.area() / self.positions().len() as f64).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Edges, Grid, Shape};
    use crate::terrain::Layer;

    #[test]
    fn a_plane_is_the_same_ground_as_raster_and_as_mesh() {
        let plane = |[x, y]: [f64; 2]| 20.0 + 0.5 * x - 0.25 * y;
        let grid = Grid::new(Shape::new(11, 11), [10.0; 2]).unwrap();
        let z = (0..121).map(|i| plane(grid.position(i))).collect();
        let raster = HeightField::new(grid.clone(), z).unwrap();
        let sites: Vec<_> = (0..121).map(|i| grid.position(i)).collect();
        let mut mesh = Mesh::delaunay(&sites, Edges::default()).unwrap();
        let positions = mesh.positions().to_vec();
        mesh.change(Layer::Bedrock, |z| z.iter_mut().zip(&positions).for_each(|(z, &p)| *z = plane(p)));
        fn check(ground: &impl Ground) {
            assert!((ground.height_at([33.0, 47.0]).unwrap() - (20.0 + 16.5 - 11.75)).abs() < 1e-9);
            assert_eq!(ground.height_at([-1.0, 0.0]), None);
            let n = ground.normal_at([50.0, 50.0]);
            let length = (1.0_f64 + 0.25 + 0.0625).sqrt();
            assert!((n[0] + 0.5 / length).abs() < 1e-9 && (n[1] - 0.25 / length).abs() < 1e-9);
            // Straight down from 100 m over a place at 45 m.
            let part = ground.hit([70.0, 40.0, 100.0], [70.0, 40.0, 0.0]).unwrap();
            assert!((part - 0.55).abs() < 2e-3, "{part}");
            assert_eq!(ground.hit([0.0, 0.0, 500.0], [90.0, 90.0, 500.0]), None);
            assert_eq!(ground.bounding_box().high[2], 70.0);
        }
        check(&raster);
        check(&mesh);
    }
}
