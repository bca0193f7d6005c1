//! Cameras: before a block, so that all of it is in the frame, or in the land.

use landform_core::math;

use super::scene::Scene;
use super::{Standpoint, View};
use crate::render::colour::scale;
use crate::vector::{Vector, add, cross, dot, normalize, sub};

/// Field of view from bottom to top before a block, degrees.
const FIELD_OF_VIEW: f64 = 28.0;
/// The same in the land.
const WIDE_FIELD_OF_VIEW: f64 = 33.0;

pub(super) struct Camera {
    pub(super) at: Vector,
    pub(super) right: Vector,
    pub(super) up: Vector,
    pub(super) forward: Vector,
    pub(super) aspect: f64,
    pub(super) half_height: f64,
}

impl Camera {
    /// One that sees the whole block, from outside: all points of its outline. Its sides and its
    /// lowest ground are a start.
    pub(super) fn before(outline: &[Vector], [w, h]: [f64; 2], low: f64, view: &View) -> Self {
        let aspect = view.width as f64 / view.height as f64;
        let half_height = math::tan(0.5 * FIELD_OF_VIEW.to_radians());
        let centre = [0.5 * w, 0.5 * h, low];
        let (ct, st) = (math::cos(view.tilt), math::sin(view.tilt));
        let back = [math::sin(view.from) * ct, math::cos(view.from) * ct, st];
        let forward = scale(back, -1.0);
        let right = normalize(cross(forward, [0.0, 0.0, 1.0]));
        let up = cross(right, forward);
        // Step by step: put the middle of what is seen in the middle of the frame, then stand as
        // near as it fits.
        let (mut aim, mut distance) = (centre, 3.0 * (w + h));
        for _ in 0..12 {
            let seen = |axis: Vector| {
                let project = |p: &Vector| dot(sub(*p, aim), axis) / (distance + dot(sub(*p, aim), forward));
                outline.iter().map(project).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
            };
            let ((l, r), (b, t)) = (seen(right), seen(up));
            let fill = ((r - l) / (2.0 * half_height * aspect)).max((t - b) / (2.0 * half_height));
            let shift = [0, 1, 2].map(|k| 0.5 * distance * ((l + r) * right[k] + (b + t) * up[k]));
            aim = add(aim, shift);
            distance *= math::pow(fill / 0.94, 0.8);
        }
        let at = add(aim, scale(back, distance / view.zoom.max(0.05)));
        Self { at, right, up, forward, aspect, half_height }
    }

    /// The direction to a place in the frame: u from the left, v from the top, 0 to 1.
    pub(super) fn ray(&self, u: f64, v: f64) -> Vector {
        let (x, y) = ((2.0 * u - 1.0) * self.half_height * self.aspect, (1.0 - 2.0 * v) * self.half_height);
        normalize([0, 1, 2].map(|k| self.forward[k] + x * self.right[k] + y * self.up[k]))
    }

    /// The angle of a pixel in a picture of so many rows, radians.
    pub(super) fn pixel_angle(&self, rows: usize) -> f64 {
        2.0 * self.half_height / rows.max(1) as f64
    }

    /// One in the land, on the side from which it looks.
    pub(super) fn within(scene: &Scene, view: &View, standpoint: &Standpoint) -> Self {
        let height = standpoint.height.unwrap_or((0.03 * (scene.high - scene.low)).max(2.0)) * view.exaggeration;
        let eye = |[x, y]: [f64; 2]| {
            let [w, h] = scene.relief.extent;
            let p = [x.clamp(0.0, w), y.clamp(0.0, h), 0.0];
            [p[0], p[1], scene.height_at(p) + height]
        };
        let at = match standpoint.at {
            Some(place) => eye(place),
            None => {
                let places = candidates(scene, view.from);
                let value = |at: &Vector| Self::value_of(scene, view, *at);
                let all = places.into_iter().map(eye).map(|at| (value(&at), at));
                all.reduce(|a, b| if b.0 > a.0 { b } else { a }).map_or([0.0; 3], |best| best.1)
            }
        };
        let level = Self::level(view, at, 0.0);
        let tilt = standpoint.tilt.unwrap_or_else(|| level.tilt_for_skyline(scene));
        Self::level(view, at, tilt)
    }

    /// One at a place that looks down by an angle.
    fn level(view: &View, at: Vector, tilt: f64) -> Self {
        let (ct, st) = (math::cos(tilt), math::sin(tilt));
        let forward = [-math::sin(view.from) * ct, -math::cos(view.from) * ct, -st];
        let right = normalize(cross(forward, [0.0, 0.0, 1.0]));
        let half_height = math::tan(0.5 * WIDE_FIELD_OF_VIEW.to_radians()) / view.zoom.max(0.05);
        let aspect = view.width as f64 / view.height as f64;
        Self { at, right, up: cross(right, forward), forward, aspect, half_height }
    }

    /// How high the land rises in the frame's columns over the level of the eye, tan.
    fn skyline(&self, scene: &Scene) -> Vec<f64> {
        const COLUMNS: usize = 25;
        const STEPS: usize = 40;
        let rise = |k: usize| {
            let across = ((k as f64 + 0.5) / COLUMNS as f64 * 2.0 - 1.0) * self.half_height * self.aspect;
            let flat = |p: Vector| normalize([p[0], p[1], 0.0]);
            let along = add(flat(self.forward), scale(flat(self.right), across));
            let seen = |step: usize| {
                let tan = -0.6 + 1.4 * step as f64 / STEPS as f64;
                let hit = scene.hit(self.at, normalize([along[0], along[1], tan]));
                hit.is_some_and(|far| far > NEAR * scene.relief.extent[0]).then_some(tan)
            };
            (0..=STEPS).rev().find_map(seen).unwrap_or(-0.3)
        };
        (0..COLUMNS).map(rise).collect()
    }

    /// The angle down at which the skyline stands in the upper third of the frame.
    fn tilt_for_skyline(&self, scene: &Scene) -> f64 {
        let skyline = self.skyline(scene);
        let highest = skyline.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mean = skyline.iter().sum::<f64>() / skyline.len() as f64;
        // The highest summit keeps clear of the upper rim.
        let middle = (mean - 0.30 * self.half_height).max(highest - 0.80 * self.half_height);
        -math::atan(middle).clamp(-0.5, 0.6)
    }

    /// How well a place shows the land: much of it, near and far, under a lively skyline.
    fn value_of(scene: &Scene, view: &View, at: Vector) -> f64 {
        let camera = Self::level(view, at, 0.0);
        let tilted = Self::level(view, at, camera.tilt_for_skyline(scene));
        const ROWS: usize = 12;
        let (mut value, mut near, mut beyond) = (0.0, 0.0, 0.0);
        for k in 0..ROWS * 2 * ROWS {
            let (u, v) = ((k % (2 * ROWS)) as f64 + 0.5, (k / (2 * ROWS)) as f64 + 0.5);
            let ray = tilted.ray(u / (2 * ROWS) as f64, v / ROWS as f64);
            if let Some(far) = scene.hit(at, ray) {
                let part = far / scene.relief.extent[0].max(scene.relief.extent[1]);
                // Each doubling of the distance shows as much.
                value += math::smoothstep(0.01, 0.25, part);
                near += f64::from(u8::from(part < NEAR));
            } else if ray[2] < 0.0 && !scene.is_in_sea() {
                beyond += 1.0;
            }
        }
        let skyline = camera.skyline(scene);
        let mean = skyline.iter().sum::<f64>() / skyline.len() as f64;
        let uneven = skyline.iter().map(|s| (s - mean).abs()).sum::<f64>() / skyline.len() as f64;
        let all = (2 * ROWS * ROWS) as f64;
        (value - 2.0 * near - beyond) / all + 2.0 * uneven.min(0.15)
    }
}

/// Part of the width within which ground is too near to be looked at.
const NEAR: f64 = 0.012;

/// Places on the side from which one looks.
fn candidates(scene: &Scene, from: f64) -> Vec<[f64; 2]> {
    const SIDE: usize = 14;
    let [w, h] = scene.relief.extent;
    let back = [math::sin(from), math::cos(from)];
    let place = |k: usize| [(k % SIDE) as f64, (k / SIDE) as f64].map(|v| (v + 0.5) / SIDE as f64);
    let behind = |p: &[f64; 2]| (p[0] - 0.5) * back[0] + (p[1] - 0.5) * back[1] > 0.08;
    (0..SIDE * SIDE).map(place).filter(behind).map(|[u, v]| [u * w, v * h]).collect()
}
