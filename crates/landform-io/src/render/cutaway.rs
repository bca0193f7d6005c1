//! A block of rock cut open: its floor and far sides with their beds, and the passages of a cave
//! as bodies in the room between.
//!
//! # Method
//! Rays are marched through the porosity of the voxels (or through empty and solid ones), between
//! which it is interpolated; the walls of passages are where it passes a bound. Floor and sides are
//! slabs. Light: the sky, the sun with shadows of the passages, and less of both where walls are
//! near.

use landform_core::analysis::cave::cave_voxels;
use landform_core::grid::Shape;
use landform_core::terrain::{Bounds, Ground, VoxelGrid};
use landform_core::{math, parallel};

use super::Picture;
use super::colour::{Rgb, blend, hex, mix, scale, to_srgb};
use crate::vector::{Vector, along, cross, dot, normalize};

/// How a block is looked at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CutawayView {
    /// Rows and columns.
    pub(crate) shape: Shape,
    /// Compass direction from which one looks, rad.
    pub(crate) from: f64,
    /// Angle by which one looks down, rad.
    pub(crate) tilt: f64,
    /// Compass direction and altitude of the sun, rad.
    pub(crate) sun: [f64; 2],
    /// Factor on the size of the block in the picture.
    pub(crate) zoom: f64,
}

/// Smooth values of the cave in a box.
struct Body {
    size: [usize; 3],
    low: Vector,
    side: Vector,
    /// x fastest, from the south, upwards; a border of zeros.
    values: Vec<f32>,
    /// Whether a passage is near a voxel.
    is_near: Vec<bool>,
}

/// Bound of the walls.
const WALL: f64 = 0.36;
/// Most steps of a ray along a side of the block.
const MOST_STEPS: f64 = 4096.0;

impl Body {
    fn new(ground: &VoxelGrid) -> Self {
        let (lattice, cave) = cave_voxels(ground);
        let size = lattice.size();
        let porosity = ground.field(VoxelGrid::POROSITY);
        let [nx, ny, nz] = size.map(|n| n + 2);
        let mut sharp = vec![0.0_f32; nx * ny * nz];
        for (n, i) in lattice.voxels().enumerate() {
            let [x, y, z] = lattice.place(i);
            // An open voxel counts as all open; walls by what is dissolved of them.
            let value = if cave[i] { 1.0 } else { porosity.map_or(0.0, |p| (1.2 * p[n] - 0.15).clamp(0.0, 0.45)) };
            sharp[((z + 1) * ny + size[1] - y) * nx + x + 1] = value;
        }
        let mut values = sharp;
        for step in [1, nx, nx * ny] {
            let before = values.clone();
            for i in step..values.len() - step {
                values[i] = (before[i - step] + 4.0 * before[i] + before[i + step]) / 6.0;
            }
        }
        let mut is_near = vec![false; values.len()];
        for (i, _) in values.iter().enumerate().filter(|v| *v.1 > 0.2) {
            for z in -2_isize..=2 {
                for y in -2_isize..=2 {
                    let first = i as isize + (z * ny as isize + y) * nx as isize - 2;
                    (first.max(0)..(first + 5).min(values.len() as isize)).for_each(|j| is_near[j as usize] = true);
                }
            }
        }
        let Bounds { low, .. } = ground.bounding_box();
        Self { size, low, side: lattice.sides(), values, is_near }
    }

    fn high(&self) -> Vector {
        [0, 1, 2].map(|k| self.low[k] + self.size[k] as f64 * self.side[k])
    }

    fn lattice(&self, p: Vector) -> Vector {
        [0, 1, 2].map(|k| (p[k] - self.low[k]) / self.side[k] + 0.5)
    }

    fn at(&self, p: Vector) -> f64 {
        let q = self.lattice(p);
        let [nx, ny, _] = self.size.map(|n| n + 2);
        if (0..3).any(|k| !(q[k] >= 0.0 && q[k] < (self.size[k] + 1) as f64)) {
            return 0.0;
        }
        let (cell, f) = (q.map(|v| v as usize), [0, 1, 2].map(|k| q[k] - q[k].floor()));
        let first = (cell[2] * ny + cell[1]) * nx + cell[0];
        let row = |i: usize| math::lerp(f64::from(self.values[i]), f64::from(self.values[i + 1]), f[0]);
        let sheet = |i: usize| math::lerp(row(i), row(i + nx), f[1]);
        math::lerp(sheet(first), sheet(first + nx * ny), f[2])
    }

    fn near(&self, p: Vector) -> bool {
        let q = self.lattice(p).map(|v| v + 0.5);
        let [nx, ny, _] = self.size.map(|n| n + 2);
        let is_in = (0..3).all(|k| q[k] >= 0.0 && q[k] < (self.size[k] + 2) as f64);
        is_in && self.is_near[((q[2] as usize) * ny + q[1] as usize) * nx + q[0] as usize]
    }

    fn normal(&self, p: Vector) -> Vector {
        let slope = |k: usize| {
            let (mut a, mut b) = (p, p);
            a[k] -= 0.6 * self.side[k];
            b[k] += 0.6 * self.side[k];
            (self.at(a) - self.at(b)) / self.side[k]
        };
        normalize([slope(0), slope(1), slope(2)])
    }

    /// Where a ray first meets a passage, between two distances.
    fn hit(&self, from: Vector, way: Vector, [mut t, end]: [f64; 2]) -> Option<f64> {
        // Flat voxels of a wide block would make steps without end.
        let widest = (0..3).map(|k| self.size[k] as f64 * self.side[k]).fold(0.0, f64::max);
        let step = self.side[0].min(self.side[1]).min(self.side[2]).max(widest / MOST_STEPS);
        let mut before = t;
        while t < end {
            let p = along(from, way, t);
            if self.near(p) {
                if self.at(p) > WALL {
                    let (mut out, mut inside) = (before, t);
                    for _ in 0..6 {
                        let middle = 0.5 * (out + inside);
                        if self.at(along(from, way, middle)) > WALL { inside = middle } else { out = middle }
                    }
                    return Some(inside);
                }
                before = t;
                t += 0.3 * step;
            } else {
                before = t;
                t += 1.2 * step;
            }
        }
        None
    }

    /// How open it is around a wall, 0 to 1.
    fn openness(&self, p: Vector, normal: Vector) -> f64 {
        let size = self.side[0];
        let blocked = [1.2, 2.4, 4.0].iter().map(|d| self.at(along(p, normal, d * size)) / d).sum::<f64>();
        (1.0 - 0.9 * blocked).clamp(0.25, 1.0)
    }
}

/// The distances at which a ray enters and leaves a box, and the axis over which it enters.
pub(super) fn through([low, high]: [Vector; 2], from: Vector, way: Vector) -> Option<([f64; 2], usize)> {
    let (mut first, mut last, mut axis) = (0.0_f64, f64::INFINITY, 0);
    for k in 0..3 {
        let ends = [low[k], high[k]].map(|v| (v - from[k]) / way[k]);
        let (a, b) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        if a > first {
            (first, axis) = (a, k);
        }
        last = last.min(b);
    }
    (first < last).then_some(([first, last], axis))
}

struct Scene<'a> {
    ground: &'a VoxelGrid,
    body: Body,
    /// Floor and far sides.
    slabs: Vec<[Vector; 2]>,
    sun: Vector,
    /// Metres of a piece of the rule on the floor's edge.
    rule: f64,
}

const PALE: u32 = 0xd9cbb0;
const TINTS: [u32; 6] = [0xcdbb98, 0x8c8a86, 0xb98f6a, 0xa3a07a, 0xc7a6a0, 0x7d93a3];

impl Scene<'_> {
    /// Colour of the rock at a place.
    fn rock(&self, p: Vector) -> Rgb {
        let body = &self.body;
        let cell =
            [0, 1, 2].map(|k| ((p[k] - body.low[k]) / body.side[k]).clamp(0.0, body.size[k] as f64 - 1.0) as usize);
        let node = self.ground.plan().shape.index(body.size[1] - 1 - cell[1], cell[0]);
        let i = cell[2] * self.ground.plan().len() + node;
        let number = self.ground.material(cell[2], node).or_else(|| {
            let beside = (0..node).rev().take(40).find_map(|n| self.ground.material(cell[2], n));
            beside.or_else(|| (node..self.ground.plan().len()).find_map(|n| self.ground.material(cell[2], n)))
        });
        let rank = number.map_or(0, |n| self.rank(n));
        let tint = hex(TINTS[rank % TINTS.len()]);
        // Fractures and planes between beds show as darker lines.
        let wide = self.ground.field(VoxelGrid::PERMEABILITY).map_or(1.0, |k| f64::from(k[i]));
        scale(tint, 1.0 - 0.28 * ((wide - 2.5) / 3.0).clamp(0.0, 1.0))
    }

    /// Materials are tinted in the order of their solubility, the most soluble pale.
    fn rank(&self, number: u8) -> usize {
        let all = self.ground.materials();
        let of = |n: u8| all.get(n).solubility;
        if of(number) >= 0.95 { 0 } else { 1 + usize::from(number) % (TINTS.len() - 1) }
    }

    fn is_lit(&self, p: Vector) -> f64 {
        let reach = (0..3).map(|k| self.body.size[k] as f64 * self.body.side[k]).fold(0.0, f64::max);
        let start = 1.2 * self.body.side[0];
        if self.body.hit(p, self.sun, [start, start + reach]).is_some() { 0.0 } else { 1.0 }
    }

    fn shade(&self, colour: Rgb, p: Vector, normal: Vector, open: f64) -> Rgb {
        let sun = dot(normal, self.sun).max(0.0);
        let sun = if sun > 0.0 { sun * self.is_lit(p) } else { 0.0 };
        let sky = 0.5 + 0.5 * normal[2];
        let light =
            [0, 1, 2].map(|k| sun * [1.05, 0.98, 0.86][k] * 0.85 + open * (0.30 + 0.34 * sky) * [0.92, 0.98, 1.1][k]);
        [0, 1, 2].map(|k| colour[k] * light[k])
    }

    fn slab(&self, from: Vector, way: Vector) -> Option<(f64, Vector, bool)> {
        let hits = self.slabs.iter().enumerate().filter_map(|(n, slab)| {
            let ([t, _], axis) = through(*slab, from, way)?;
            let mut normal = [0.0; 3];
            normal[axis] = -way[axis].signum();
            (t > 0.0).then_some((t, normal, n == 0))
        });
        hits.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn colour(&self, from: Vector, way: Vector) -> Rgb {
        let slab = self.slab(from, way);
        let limit = slab.map_or(f64::INFINITY, |s| s.0);
        let (low, high) = (self.body.low, self.body.high());
        let inside = through([low, high], from, way).map(|(span, _)| [span[0], span[1].min(limit)]);
        if let Some(t) = inside.and_then(|span| self.body.hit(from, way, span)) {
            let p = along(from, way, t);
            let normal = self.body.normal(p);
            let height = (p[2] - low[2]) / (high[2] - low[2]);
            // Deep passages are darker and redder, high ones pale.
            let ramp = if height < 0.5 {
                mix(hex(0x8c3f1d), hex(0xd98a3a), 2.0 * height)
            } else {
                mix(hex(0xd98a3a), hex(0xf4dfa6), 2.0 * height - 1.0)
            };
            return self.shade(blend(ramp, self.rock(p), 0.22), p, normal, self.body.openness(p, normal));
        }
        let Some((t, normal, is_floor)) = slab else { return self.background(way) };
        let p = along(from, way, t);
        let is_edge = is_floor && normal[2] == 0.0;
        let axis = usize::from(normal[0] != 0.0);
        if is_edge && p[2] > low[2] - 0.6 * self.thick() {
            let piece = ((p[axis] - low[axis]) / self.rule).floor() as i64;
            return self.shade(if piece % 2 == 0 { hex(0x202020) } else { hex(0xf2efe6) }, p, normal, 1.0);
        }
        let colour = if is_edge { hex(PALE) } else { self.rock(p) };
        // Where a passage leaves the block, its mouth is dark.
        let within = along(p, normal, 0.5 * self.body.side[0]);
        let dark = if self.body.at(within) > WALL { 0.12 } else { 1.0 };
        self.shade(scale(colour, dark), p, normal, self.body.openness(p, normal))
    }

    fn thick(&self) -> f64 {
        0.02 * (self.body.size[0] as f64 * self.body.side[0]).max(self.body.size[1] as f64 * self.body.side[1])
    }

    fn background(&self, way: Vector) -> Rgb {
        mix(hex(0xe9eef0), hex(0xb9c7ce), (0.9 + way[2]).clamp(0.0, 1.0))
    }
}

/// A round length of which a side has some six.
fn rule(side: f64) -> f64 {
    let power = math::pow(10.0, math::floor(math::log10(side / 5.0)));
    [5.0, 2.0, 1.0].into_iter().map(|f| f * power).find(|r| side / r >= 4.0).unwrap_or(power)
}

/// The block cut open, with a rule on the edge of its floor, and the length of a piece of it, m.
pub(crate) fn cutaway(ground: &VoxelGrid, view: &CutawayView) -> (Picture, f64) {
    let body = Body::new(ground);
    let (low, high) = (body.low, body.high());
    let towards = [
        math::cos(view.tilt) * math::sin(view.from),
        math::cos(view.tilt) * math::cos(view.from),
        math::sin(view.tilt),
    ];
    let [azimuth, altitude] = view.sun;
    let sun = [math::cos(altitude) * math::sin(azimuth), math::cos(altitude) * math::cos(azimuth), math::sin(altitude)];
    let side = (high[0] - low[0]).max(high[1] - low[1]);
    let thick = 0.02 * side;
    let floor = [[low[0], low[1], low[2] - thick], [high[0], high[1], low[2]]];
    let mut slabs = vec![floor];
    for k in 0..2 {
        let (mut from, mut to) = ([low[0], low[1], low[2] - thick], high);
        // The side that looks at the viewer from inside.
        if towards[k] > 0.0 {
            (from[k], to[k]) = (low[k] - thick, low[k])
        } else {
            (from[k], to[k]) = (high[k], high[k] + thick)
        }
        slabs.push([from, to]);
    }
    let scene = Scene { ground, body, slabs, sun, rule: rule(side) };
    let right = normalize([towards[1], -towards[0], 0.0].map(|v| -v));
    let ahead = towards.map(|v| -v);
    let up = cross(right, ahead);
    let middle = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
    // All corners are in the frame.
    let corners =
        (0..8).map(|n| [0, 1, 2].map(|k| if n >> k & 1 == 1 { high[k] - middle[k] } else { low[k] - middle[k] }));
    let (wide, tall) =
        corners.fold((0.0_f64, 0.0_f64), |(w, h), c| (w.max(dot(c, right).abs()), h.max(dot(c, up).abs())));
    let Shape { rows, cols } = view.shape;
    let pixel =
        (2.0 * (wide + thick) / cols as f64).max(2.0 * (tall + thick) / (0.92 * rows as f64)) * 1.06 / view.zoom;
    let far = 4.0 * (wide + tall);
    let pixels = parallel::map(rows * cols, |i| {
        let mut sum = [0.0; 3];
        // Two by two rays a pixel.
        for (a, b) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
            let x = ((i % cols) as f64 + a - 0.5 * cols as f64) * pixel;
            let y = (0.48 * rows as f64 - (i / cols) as f64 - b) * pixel;
            let from = along(along(along(middle, towards, far), right, x), up, y);
            let colour = scene.colour(from, ahead);
            sum = [0, 1, 2].map(|k| sum[k] + 0.25 * colour[k]);
        }
        to_srgb(sum)
    });
    (Picture { shape: view.shape, pixels }, scene.rule)
}
