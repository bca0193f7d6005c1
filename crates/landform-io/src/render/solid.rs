//! A block of voxels seen from outside: its surface with overhangs and arches, its cut sides, the
//! sea.
//!
//! # Method
//! Parallel rays are marched through how full voxels are, linear between their middles; the surface
//! is where they are half full. Bricks of voxels that hold nothing are passed at once. Light: the
//! sun with shadows, and a sky that hollows see less of. The sea is a clear sheet at its level.

use landform_core::grid::Shape;
use landform_core::terrain::{Bounds, Ground, VoxelGrid};
use landform_core::{math, parallel};

use super::Picture;
use super::colour::{Rgb, blend, hex, mix, to_srgb};
use super::cutaway::{CutawayView, through};
use crate::vector::{Vector, along, cross, dot, normalize};

/// Voxels along the side of a brick.
const BRICK: usize = 4;
/// Way through water after which nothing is seen of what lies in it, in heights of the block.
const CLEAR: f64 = 0.35;

struct Scene<'a> {
    ground: &'a VoxelGrid,
    low: Vector,
    high: Vector,
    /// Sides of a voxel, m.
    side: Vector,
    bricks: [usize; 3],
    /// Whether a brick, or the voxels next to it, holds something.
    is_full: Vec<bool>,
    sun: Vector,
    sea: Option<f64>,
}

impl<'a> Scene<'a> {
    fn new(ground: &'a VoxelGrid, sun: Vector, sea: Option<f64>) -> Self {
        let (Bounds { low, high }, [dx, dy]) = (ground.bounding_box(), ground.plan().spacing);
        let Shape { rows, cols } = ground.plan().shape;
        let size = [cols, rows, ground.levels()];
        let bricks = size.map(|n| n.div_ceil(BRICK));
        let holds = |[x, y, z]: [usize; 3]| {
            let node = (rows - 1 - y) * cols + x;
            let part = ground.fill().map(|fill| fill[z * rows * cols + node] > 0.0);
            part.unwrap_or_else(|| ground.material(z, node).is_some())
        };
        let is_full = parallel::map(bricks.iter().product(), |i| {
            let brick = [i % bricks[0], i / bricks[0] % bricks[1], i / (bricks[0] * bricks[1])];
            let range = |k: usize| (BRICK * brick[k]).saturating_sub(1)..(BRICK * (brick[k] + 1) + 1).min(size[k]);
            range(2).any(|z| range(1).any(|y| range(0).any(|x| holds([x, y, z]))))
        });
        Self { ground, low, high, side: [dx, dy, ground.height()], bricks, is_full, sun, sea }
    }

    fn part(&self, p: Vector) -> f64 {
        self.ground.fill_at(p).unwrap_or(0.0)
    }

    /// The brick of a place.
    fn brick(&self, p: Vector) -> [usize; 3] {
        [0, 1, 2].map(|k| {
            let at = (p[k] - self.low[k]) / (BRICK as f64 * self.side[k]);
            (at.max(0.0) as usize).min(self.bricks[k] - 1)
        })
    }

    /// Where a ray leaves the brick of a place.
    fn leaves(&self, p: Vector, way: Vector) -> f64 {
        let brick = self.brick(p);
        let until = |k: usize| {
            let face = brick[k] + usize::from(way[k] > 0.0);
            let to = self.low[k] + (BRICK * face) as f64 * self.side[k] - p[k];
            if way[k] == 0.0 { f64::INFINITY } else { (to / way[k]).max(0.0) }
        };
        until(0).min(until(1)).min(until(2))
    }

    /// Where a ray first meets the ground between two distances.
    fn hit(&self, from: Vector, way: Vector, [start, end]: [f64; 2]) -> Option<f64> {
        let step = 0.5 * self.side[0].min(self.side[1]).min(self.side[2]);
        let (mut t, mut before) = (start, start);
        while t <= end {
            let p = along(from, way, t);
            let [x, y, z] = self.brick(p);
            if !self.is_full[(z * self.bricks[1] + y) * self.bricks[0] + x] {
                before = t;
                t += self.leaves(p, way) + 0.01 * step;
                continue;
            }
            if self.part(p) >= 0.5 {
                let (mut out, mut inside) = (before, t);
                for _ in 0..8 {
                    let middle = 0.5 * (out + inside);
                    if self.part(along(from, way, middle)) >= 0.5 { inside = middle } else { out = middle }
                }
                return Some(inside);
            }
            before = t;
            t += step;
        }
        None
    }

    /// That of the surface which the parts of voxels add up to, the mean around a place: by how
    /// full they are alone, slopes would be stairs.
    fn normal(&self, p: Vector) -> Vector {
        // The sides of the block are cuts.
        for k in 0..2 {
            let near = 1e-3 * self.side[k];
            let out = f64::from(i8::from(p[k] > self.high[k] - near) - i8::from(p[k] < self.low[k] + near));
            if out != 0.0 {
                let mut normal = [0.0; 3];
                normal[k] = out;
                return normal;
            }
        }
        let mut sum = [0.0; 3];
        for (axis, by) in (0..3).flat_map(|axis| [(axis, -0.6), (axis, 0.6)]) {
            let mut beside = p;
            beside[axis] += by * self.side[axis];
            if let Some((_, normal)) = self.ground.contact(beside) {
                (0..3).for_each(|k| sum[k] += normal[k]);
            }
        }
        if sum == [0.0; 3] { [0.0, 0.0, 1.0] } else { normalize(sum) }
    }

    /// How much of the sky a place sees, 0 to 1.
    fn openness(&self, p: Vector, normal: Vector) -> f64 {
        let up = normalize([normal[0], normal[1], normal[2] + 0.7]);
        let size = self.side[0];
        let blocked: f64 = [2.0, 4.0, 7.0, 12.0].iter().map(|d| self.part(along(p, up, d * size))).sum();
        1.0 - 0.2 * blocked
    }

    fn rock(&self, p: Vector, normal: Vector) -> Rgb {
        let inside = along(p, normal, -0.6 * self.side[2]);
        let cell = |k: usize| ((inside[k] - self.low[k]) / self.side[k]).max(0.0) as usize;
        let Shape { rows, cols } = self.ground.plan().shape;
        let (col, row, level) = (cell(0).min(cols - 1), cell(1).min(rows - 1), cell(2).min(self.ground.levels() - 1));
        let number = self.ground.material(level, (rows - 1 - row) * cols + col).unwrap_or(0);
        let name = self.ground.materials().get(number).name.as_str();
        let (flat, steep) = match name {
            "sand" | "sediment" | "coral" => (hex(0xd8c698), hex(0xc2ab7c)),
            "limestone" => (hex(0xcdc6b4), hex(0xb5ac98)),
            "sandstone" => (hex(0xc99a6b), hex(0xb07a4e)),
            "shale" | "clay" | "soil" => (hex(0x9a8c78), hex(0x837561)),
            "basalt" => (hex(0x6b6763), hex(0x575350)),
            _ => (hex(0xa9a183), hex(0x8e7f6c)),
        };
        mix(steep, flat, math::smoothstep(0.55, 0.9, normal[2]))
    }

    fn shade(&self, colour: Rgb, p: Vector, normal: Vector, open: f64) -> Rgb {
        let straight = dot(normal, self.sun).max(0.0);
        let start = along(p, normal, 0.8 * self.side[0]);
        let span = through([self.low, self.high], start, self.sun).map_or([0.0, 0.0], |found| found.0);
        let is_dark = straight > 0.0 && self.hit(start, self.sun, [0.0, span[1]]).is_some();
        let sun = if is_dark { 0.0 } else { straight };
        let sky = open * (0.32 + 0.22 * normal[2]);
        [0, 1, 2].map(|k| colour[k] * (sun * [1.0, 0.93, 0.80][k] + sky * [0.90, 0.98, 1.12][k]))
    }

    /// Colour of the ground where a ray meets it, with the distance.
    fn ground(&self, from: Vector, way: Vector, (span, axis): ([f64; 2], usize)) -> Option<(f64, Rgb)> {
        let t = self.hit(from, way, span)?;
        let p = along(from, way, t);
        if t - span[0] > 1e-6 * span[1] {
            let normal = self.normal(p);
            return Some((t, self.shade(self.rock(p, normal), p, normal, self.openness(p, normal))));
        }
        // The cut side of the block.
        let mut normal = [0.0; 3];
        normal[axis] = -way[axis].signum();
        let colour = self.rock(p, normal).map(|v| 0.75 * v);
        Some((t, self.shade(colour, p, normal, 0.9)))
    }

    fn colour(&self, from: Vector, way: Vector) -> Rgb {
        let background = mix(hex(0xe9eef0), hex(0xb9c7ce), (0.9 + way[2]).clamp(0.0, 1.0));
        let Some(entry) = through([self.low, self.high], from, way) else { return background };
        let (span, axis) = entry;
        let hit = self.ground(from, way, entry);
        let (end, behind) = hit.unwrap_or((span[1], background));
        let Some(sea) = self.sea else { return behind };
        let surface = (sea - from[2]) / way[2];
        let start = if way[2] < 0.0 { surface.max(span[0]) } else { span[0] };
        if !(sea > self.low[2] && start < end - 1e-6 * end) || along(from, way, start)[2] > sea + 1e-6 * sea.abs() {
            return behind;
        }
        let clear = CLEAR * (self.high[2] - self.low[2]);
        let thick = 1.0 - math::exp(-(end - start) / clear);
        let p = along(from, way, start);
        let (mut normal, is_side) = ([0.0, 0.0, 1.0], start <= span[0]);
        if is_side && axis != 2 {
            normal = [0.0; 3];
            normal[axis] = -way[axis].signum();
        }
        let water = if is_side { hex(0x2f6f80) } else { mix(hex(0x3f8f9c), hex(0x245c70), thick) };
        blend(behind, self.shade(water, p, normal, 1.0), 0.35 + 0.6 * thick)
    }
}

/// The block from outside, with the sea at its level (m) where it has one.
pub(crate) fn solid(ground: &VoxelGrid, view: &CutawayView, sea: Option<f64>) -> Picture {
    let [azimuth, altitude] = view.sun;
    let sun = [math::cos(altitude) * math::sin(azimuth), math::cos(altitude) * math::cos(azimuth), math::sin(altitude)];
    let scene = Scene::new(ground, sun, sea);
    let (low, high) = (scene.low, scene.high);
    let towards = [
        math::cos(view.tilt) * math::sin(view.from),
        math::cos(view.tilt) * math::cos(view.from),
        math::sin(view.tilt),
    ];
    let right = normalize([-towards[1], towards[0], 0.0]);
    let ahead = towards.map(|v| -v);
    let up = cross(right, ahead);
    let middle = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
    let corners =
        (0..8).map(|n| [0, 1, 2].map(|k| if n >> k & 1 == 1 { high[k] - middle[k] } else { low[k] - middle[k] }));
    let (wide, tall) =
        corners.fold((0.0_f64, 0.0_f64), |(w, h), c| (w.max(dot(c, right).abs()), h.max(dot(c, up).abs())));
    let Shape { rows, cols } = view.shape;
    let pixel = (2.0 * wide / cols as f64).max(2.0 * tall / (0.92 * rows as f64)) * 1.06 / view.zoom;
    let far = 4.0 * (wide + tall);
    let pixels = parallel::map(rows * cols, |i| {
        let mut sum = [0.0; 3];
        for (a, b) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
            let x = ((i % cols) as f64 + a - 0.5 * cols as f64) * pixel;
            let y = (0.48 * rows as f64 - (i / cols) as f64 - b) * pixel;
            let from = along(along(along(middle, towards, far), right, x), up, y);
            let colour = scene.colour(from, ahead);
            sum = [0, 1, 2].map(|k| sum[k] + 0.25 * colour[k]);
        }
        to_srgb(sum)
    });
    Picture { shape: view.shape, pixels }
}
