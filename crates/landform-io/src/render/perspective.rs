//! The perspective view: a block of land under a low sun, ray by ray.
//!
//! # Method
//! Rays march through a pyramid of greatest elevations and are refined on the bilinear patch that
//! they hit. Sun and sky visibility are computed once per node ([`light`](super::light)) and
//! interpolated, as are normals and ground colours: grass on gentle low ground, bare soil and rock
//! with slope and height, snow on gentle high ground. Water is a surface above the ground (flat on
//! lakes, along the bed in rivers), tinted by its depth, and mirrors the sky by Schlick's law.
//! Several rays a pixel, jittered by key.

use landform_core::algo::derivative::gradient;
use landform_core::grid::Grid;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::{math, parallel};

use super::colour::{Rgb, blend, from_oklab, hex, mix, scale, to_oklab, to_srgb};
use super::cover::{Cover, cut};
use super::light::{sky_view, sun_view};
use super::pyramid::Pyramid;
use super::{Picture, waters};
use landform_core::algo::noise::fbm;
use landform_core::grid::Shape;

/// Where the camera stands and how the picture is made.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Columns of the picture.
    pub width: usize,
    /// Rows of the picture.
    pub height: usize,
    /// Compass direction from which the camera looks, radians clockwise from north.
    pub from: f64,
    /// Angle by which the camera looks down, radians.
    pub tilt: f64,
    /// Compass direction of the sun, radians clockwise from north.
    pub sun: f64,
    /// Altitude of the sun, radians.
    pub sun_altitude: f64,
    /// Factor on elevations.
    pub exaggeration: f64,
    /// 1 frames the whole block; more comes closer.
    pub zoom: f64,
    /// Rays a pixel along each side.
    pub samples: usize,
    /// Whether rivers and lakes are drawn.
    pub water: bool,
}

impl Default for View {
    fn default() -> Self {
        Self {
            width: 1600,
            height: 900,
            from: 200.0_f64.to_radians(),
            tilt: 26.0_f64.to_radians(),
            sun: 285.0_f64.to_radians(),
            sun_altitude: 32.0_f64.to_radians(),
            exaggeration: 1.0,
            zoom: 1.0,
            samples: 2,
            water: true,
        }
    }
}

type Vector = [f64; 3];

const FIELD_OF_VIEW: f64 = 28.0;
const SUN_LIGHT: Rgb = [2.20, 1.98, 1.66];
const SKY_LIGHT: Rgb = [0.42, 0.51, 0.68];
/// Optical depth of air over the length of both sides of the block.
const HAZE: f64 = 0.35;
/// Steps of the sky's ramp; more would not show in eight bits.
const SKY_STEPS: usize = 512;
/// Water is all that one sees where it is so deep, m.
const CLEAR: f64 = 0.9;
const ZENITH: u32 = 0x8fb2d6;
const HORIZON: u32 = 0xe6ebee;

/// Draws a raster in perspective. Nodata is left out as if it lay at the foot of the block.
pub fn perspective(field: &HeightField, view: &View) -> Picture {
    let scene = Scene::new(field, view);
    let camera = Camera::new(&scene, view);
    let shape = Shape::new(view.height.max(1), view.width.max(1));
    let samples = view.samples.clamp(1, 8);
    let pixels = parallel::map(shape.len(), |i| {
        let pixel = shape.cell(i);
        let mut sum = [0.0; 3];
        for s in 0..samples * samples {
            let seed = Seed(i as u64).with(s as u64);
            let x = pixel.col as f64 + ((s % samples) as f64 + seed.uniform(0)) / samples as f64;
            let y = pixel.row as f64 + ((s / samples) as f64 + seed.uniform(1)) / samples as f64;
            let colour = tone(scene.trace(camera.at, camera.ray(x / shape.cols as f64, y / shape.rows as f64)));
            sum = [0, 1, 2].map(|k| sum[k] + colour[k]);
        }
        to_srgb(scale(sum, 1.0 / (samples * samples) as f64))
    });
    Picture { shape, pixels }
}

/// Compresses highlights (Reinhard's curve with a white point), so that snow keeps its shading.
fn tone(colour: Rgb) -> Rgb {
    const WHITE: f64 = 2.2;
    colour.map(|v| v * (1.0 + v / (WHITE * WHITE)) / (1.0 + 0.55 * v))
}

struct Camera {
    at: Vector,
    right: Vector,
    up: Vector,
    forward: Vector,
    aspect: f64,
    half_height: f64,
}

impl Camera {
    fn new(scene: &Scene, view: &View) -> Self {
        let aspect = view.width as f64 / view.height as f64;
        let half_height = math::tan(0.5 * FIELD_OF_VIEW.to_radians());
        let [w, h] = scene.extent;
        let centre = [0.5 * w, 0.5 * h, scene.low];
        let (ct, st) = (math::cos(view.tilt), math::sin(view.tilt));
        let back = [math::sin(view.from) * ct, math::cos(view.from) * ct, st];
        let forward = scale(back, -1.0);
        let right = normalize(cross(forward, [0.0, 0.0, 1.0]));
        let up = cross(right, forward);
        let outline = scene.outline();
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

    fn ray(&self, u: f64, v: f64) -> Vector {
        let (x, y) = ((2.0 * u - 1.0) * self.half_height * self.aspect, (1.0 - 2.0 * v) * self.half_height);
        normalize([0, 1, 2].map(|k| self.forward[k] + x * self.right[k] + y * self.up[k]))
    }
}

/// All values of a node that shading needs.
#[derive(Clone, Copy, Default)]
struct Skin {
    normal: Vector,
    colour: Rgb,
    sky: f64,
    sun: f64,
    /// Depth of water over the ground, m.
    water: f64,
}

/// The block in local metres: x east, y north from the south-west corner, elevations exaggerated.
struct Scene<'a> {
    field: &'a HeightField,
    exaggeration: f64,
    shape: Shape,
    spacing: [f64; 2],
    extent: [f64; 2],
    /// Surface, water included.
    surface: Vec<f64>,
    skin: Vec<Skin>,
    pyramid: Pyramid,
    low: f64,
    high: f64,
    foot: f64,
    sun: Vector,
    background: Vec<Rgb>,
}

/// Blocks along a side whose highest points the frame must hold.
const FRAMED: usize = 96;

impl<'a> Scene<'a> {
    /// Points that the frame must hold: the corners of the foot, and the highest point of every
    /// part of the surface.
    fn outline(&self) -> Vec<Vector> {
        let Shape { rows, cols } = self.shape;
        let [w, h] = self.extent;
        let mut points = vec![[0.0, 0.0, self.foot], [w, 0.0, self.foot], [0.0, h, self.foot], [w, h, self.foot]];
        let step = (rows.max(cols) / FRAMED).max(1);
        for (r, c) in (0..rows).step_by(step).flat_map(|r| (0..cols).step_by(step).map(move |c| (r, c))) {
            let block = (r..(r + step).min(rows)).flat_map(|r| (c..(c + step).min(cols)).map(move |c| (r, c)));
            let height = |&(r, c): &(usize, usize)| self.surface[self.shape.index(r, c)];
            if let Some((r, c)) = block.max_by(|a, b| height(a).total_cmp(&height(b))) {
                let [x, y] = [c as f64 * self.spacing[0], (rows - 1 - r) as f64 * self.spacing[1]];
                points.push([x, y, height(&(r, c))]);
            }
        }
        points
    }

    fn new(field: &'a HeightField, view: &View) -> Self {
        let grid = field.grid();
        let extent = grid.extent().map(|e| e.max(1e-6));
        let finite = field.elevation().iter().filter(|z| z.is_finite());
        let (lo, hi) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &z| (a.min(z), b.max(z)));
        let ground: Vec<f64> =
            field.elevation().iter().map(|&z| if z.is_nan() { lo } else { z } * view.exaggeration).collect();
        let depth = water_depth(field, lo, hi, view.water);
        let surface: Vec<f64> = (0..ground.len()).map(|i| ground[i] + depth[i] * view.exaggeration).collect();
        let (low, high) = (lo * view.exaggeration, hi * view.exaggeration);
        let surface_high = surface.iter().copied().fold(high, f64::max);
        let sky = sky_view(grid, &surface);
        let sun = sun_view(grid, &surface, view.sun, view.sun_altitude);
        let mut paint = Paint::new(field, (lo, hi), view.exaggeration);
        if !view.water {
            paint.river.fill(0.0);
        }
        let skin = parallel::map(ground.len(), |i| {
            let g = gradient(grid, &ground, i);
            let normal = if depth[i] > 0.0 { water_normal(grid, &surface, i) } else { normalize([-g.x, -g.y, 1.0]) };
            Skin { normal, colour: paint.ground(grid, &ground, i), sky: sky[i], sun: sun[i], water: depth[i] }
        });
        let ca = math::cos(view.sun_altitude);
        let pyramid = Pyramid::new(grid.shape, &surface);
        let foot = low - (0.06 * extent[0].min(extent[1])).max(0.15 * (high - low));
        Self {
            field,
            exaggeration: view.exaggeration,
            shape: grid.shape,
            spacing: grid.spacing,
            extent,
            surface,
            skin,
            pyramid,
            low,
            high: surface_high,
            foot,
            sun: [math::sin(view.sun) * ca, math::cos(view.sun) * ca, math::sin(view.sun_altitude)],
            background: sky_ramp(),
        }
    }

    fn trace(&self, from: Vector, direction: Vector) -> Rgb {
        let Some((enter, leave)) = self.box_span(from, direction) else {
            return sky_colour(&self.background, direction[2]);
        };
        let start = enter.max(0.0);
        let p = along(from, direction, start);
        let (colour, hit) = if enter > 0.0 && p[2] <= self.height_at(p) {
            (self.wall(p), start)
        } else {
            match self.march(from, direction, start, leave) {
                Some(t) => (self.shade(along(from, direction, t), direction), t),
                None => return sky_colour(&self.background, direction[2]),
            }
        };
        // Only air over the block hazes: the camera stands far back, as before a model.
        let haze = 1.0 - math::exp(-HAZE * (hit - start) / (self.extent[0] + self.extent[1]));
        blend(colour, sky_colour(&self.background, 0.0), haze)
    }

    /// Where a ray is inside the block's box.
    fn box_span(&self, from: Vector, direction: Vector) -> Option<(f64, f64)> {
        let (lo, hi) = ([0.0, 0.0, self.foot], [self.extent[0], self.extent[1], self.high + 1e-3]);
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for k in 0..3 {
            let (a, b) = ((lo[k] - from[k]) / direction[k], (hi[k] - from[k]) / direction[k]);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (enter < leave && leave > 0.0).then_some((enter, leave))
    }

    /// Column and row of a position, as real numbers.
    fn col_row(&self, p: Vector) -> [f64; 2] {
        let c = (p[0] / self.spacing[0]).clamp(0.0, (self.shape.cols - 1) as f64);
        let r = ((self.extent[1] - p[1]) / self.spacing[1]).clamp(0.0, (self.shape.rows - 1) as f64);
        [c, r]
    }

    fn corners(&self, p: Vector) -> ([usize; 4], [f64; 2]) {
        let [c, r] = self.col_row(p);
        let (c0, r0) = (c as usize, r as usize);
        let (c1, r1) = ((c0 + 1).min(self.shape.cols - 1), (r0 + 1).min(self.shape.rows - 1));
        let at = |r, c| self.shape.index(r, c);
        ([at(r0, c0), at(r0, c1), at(r1, c0), at(r1, c1)], [c - c0 as f64, r - r0 as f64])
    }

    fn height_at(&self, p: Vector) -> f64 {
        let (k, [u, v]) = self.corners(p);
        let [a, b, c, d] = k.map(|i| self.surface[i]);
        math::lerp(math::lerp(a, b, u), math::lerp(c, d, u), v)
    }

    /// Distance to the surface along a ray, by leaps over blocks that it passes above.
    fn march(&self, from: Vector, direction: Vector, start: f64, leave: f64) -> Option<f64> {
        let top = self.pyramid.levels.len() - 1;
        let (mut t, mut level) = (start, top);
        let speed = [direction[0] / self.spacing[0], -direction[1] / self.spacing[1]];
        let nudge = 1e-6 * self.spacing[0];
        while t < leave {
            let p = along(from, direction, t + nudge);
            let [c, r] = self.col_row(p);
            let (shape, greatest) = &self.pyramid.levels[level];
            let side = (1usize << level) as f64;
            let (bc, br) = (((c / side) as usize).min(shape.cols - 1), ((r / side) as usize).min(shape.rows - 1));
            // Time until the ray leaves this block.
            let edge = |at: f64, block: usize, speed: f64| {
                let wall = if speed > 0.0 { (block + 1) as f64 * side } else { block as f64 * side };
                if speed == 0.0 { f64::INFINITY } else { ((wall - at) / speed).max(0.0) }
            };
            let step = edge(c, bc, speed[0]).min(edge(r, br, speed[1])) + nudge;
            let end = (t + step).min(leave);
            let lowest = along(from, direction, end)[2].min(along(from, direction, t)[2]);
            if lowest > f64::from(greatest[shape.index(br, bc)]) {
                t = end.max(t + nudge);
                level = (level + 1).min(top);
            } else if level > 0 {
                level -= 1;
            } else {
                if let Some(hit) = self.refine(from, direction, t, end) {
                    return Some(hit);
                }
                t = end.max(t + nudge);
            }
        }
        None
    }

    /// The first crossing within a cell, by a few samples and bisection.
    fn refine(&self, from: Vector, direction: Vector, start: f64, end: f64) -> Option<f64> {
        const PARTS: usize = 3;
        let above = |t: f64| {
            let p = along(from, direction, t);
            p[2] - self.height_at(p)
        };
        let mut a = start;
        if above(a) <= 0.0 {
            return Some(a);
        }
        for k in 1..=PARTS {
            let b = start + (end - start) * k as f64 / PARTS as f64;
            if above(b) <= 0.0 {
                let mut b = b;
                for _ in 0..10 {
                    let middle = 0.5 * (a + b);
                    if above(middle) > 0.0 { a = middle } else { b = middle }
                }
                return Some(b);
            }
            a = b;
        }
        None
    }

    fn skin_at(&self, p: Vector) -> Skin {
        let (k, [u, v]) = self.corners(p);
        let weights = [(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v];
        let mut s = Skin { normal: [0.0; 3], colour: [0.0; 3], sky: 0.0, sun: 0.0, water: 0.0 };
        for (i, w) in k.into_iter().zip(weights) {
            let o = &self.skin[i];
            for n in 0..3 {
                s.normal[n] += w * o.normal[n];
                s.colour[n] += w * o.colour[n];
            }
            s.sky += w * o.sky;
            s.sun += w * o.sun;
            s.water += w * o.water;
        }
        s.normal = normalize(s.normal);
        s
    }

    fn shade(&self, p: Vector, direction: Vector) -> Rgb {
        let skin = self.skin_at(p);
        let lit = |colour: Rgb, normal: Vector| {
            let sun = dot(normal, self.sun).max(0.0) * skin.sun;
            let sky = skin.sky * (0.5 + 0.5 * normal[2]);
            // Light thrown back by the ground around, warm and weak.
            let bounce = 0.10 * (1.0 - 0.5 * skin.sky) + 0.03;
            [0, 1, 2].map(|k| colour[k] * (SUN_LIGHT[k] * sun + SKY_LIGHT[k] * sky + bounce * SUN_LIGHT[k]))
        };
        let ground = lit(skin.colour, skin.normal);
        if skin.water <= 0.0 {
            return ground;
        }
        let deep = lit(hex(0x1f4e6b), [0.0, 0.0, 1.0]);
        let murk = 1.0 - 0.65 * math::exp(-skin.water / 3.0);
        let below = blend(scale(ground, 0.7), deep, murk);
        let facing = (-direction[2]).clamp(0.0, 1.0);
        let mirror = 0.03 + 0.97 * math::pow(1.0 - facing, 5.0);
        let reflected = sky_colour(&self.background, -direction[2]);
        // Brooks and shores show the ground through.
        blend(ground, blend(below, reflected, mirror), math::smoothstep(0.0, CLEAR, skin.water))
    }

    /// The cut side of the block: its beds, or plain rock under a little soil.
    fn wall(&self, p: Vector) -> Rgb {
        let on_x = p[0] <= 1e-6 * self.extent[0] || p[0] >= self.extent[0] * (1.0 - 1e-6);
        let normal = if on_x {
            [if p[0] > 0.5 * self.extent[0] { 1.0 } else { -1.0 }, 0.0, 0.0]
        } else {
            [0.0, if p[1] > 0.5 * self.extent[1] { 1.0 } else { -1.0 }, 0.0]
        };
        let scale_length = 0.02 * (self.extent[0] + self.extent[1]);
        let along_wall = if on_x { p[1] } else { p[0] };
        let under = (self.height_at(p) - p[2]) / scale_length;
        let (k, [u, v]) = self.corners(p);
        let (to, t) = if on_x { (k[2], v) } else { (k[1], u) };
        let beds = cut(self.field, [k[0], to], t, p[2] / self.exaggeration);
        let grain = fbm(Seed(11), along_wall / (0.5 * scale_length), p[2] / (0.5 * scale_length), 4, 2.1, 0.6);
        let plain = || mix(hex(0x857a6e), hex(0x6d645b), 0.25 * under + 0.35 * grain);
        let soil = |rock: Rgb| mix(hex(0x54463a), rock, math::smoothstep(0.02, 0.07, under));
        let colour = beds.map_or_else(|| soil(plain()), |bed| scale(bed, 0.9 + 0.12 * grain));
        let light = 0.25 + 0.75 * dot(normal, self.sun).max(0.0);
        [0, 1, 2].map(|k| colour[k] * (0.6 * SUN_LIGHT[k] * light + 0.6 * SKY_LIGHT[k]))
    }
}

/// Upright on lakes; rivers lie along their beds.
fn water_normal(grid: &Grid, surface: &[f64], i: usize) -> Vector {
    let g = gradient(grid, surface, i);
    // At a shore the slope is the land's, not the water's.
    let slope = g.slope();
    let most = if slope > 0.3 { 0.3 / slope } else { 1.0 };
    normalize([-g.x * most, -g.y * most, 1.0])
}

/// Depth of lakes (if `inland`) and of the sea over each node, m. Sea is what lies below 0 in a
/// land that also rises above it.
fn water_depth(field: &HeightField, lo: f64, hi: f64, inland: bool) -> Vec<f64> {
    let water = waters(field);
    let has_sea = lo < 0.0 && hi > 0.0;
    let z = field.elevation();
    (0..z.len())
        .map(|i| {
            if has_sea && z[i] < 0.0 {
                -z[i]
            } else if inland {
                water.lake[i]
            } else {
                0.0
            }
        })
        .collect()
}

/// Colours of the ground: each a pair between which patches vary, in Oklab, so that a node's colour
/// is a few plain means.
struct Inks {
    meadow: [Rgb; 2],
    heath: [Rgb; 2],
    forest: [Rgb; 2],
    rock: [Rgb; 2],
    snow: Rgb,
    river: Rgb,
}

impl Inks {
    fn new() -> Self {
        let ink = |code: u32| to_oklab(hex(code));
        Self {
            meadow: [ink(0x59693c), ink(0x7d7d50)],
            heath: [ink(0x7a7056), ink(0x92856c)],
            forest: [ink(0x2f3f28), ink(0x465634)],
            rock: [ink(0x7d736a), ink(0x9d948a)],
            snow: ink(0xdfe4ea),
            river: ink(0x35617f),
        }
    }
}

/// What the ground's colours follow.
struct Paint {
    inks: Inks,
    river: Vec<f64>,
    cover: Cover,
    low: f64,
    relief: f64,
    exaggeration: f64,
}

impl Paint {
    fn new(field: &HeightField, (lo, hi): (f64, f64), exaggeration: f64) -> Self {
        let low = if lo < 0.0 && hi > 0.0 { 0.0 } else { lo };
        Self {
            inks: Inks::new(),
            river: waters(field).river,
            cover: Cover::of(field),
            low: low * exaggeration,
            relief: ((hi - low) * exaggeration).max(1e-9),
            exaggeration,
        }
    }

    fn ground(&self, grid: &Grid, z: &[f64], i: usize) -> Rgb {
        let gradient = gradient(grid, z, i);
        let slope = gradient.slope() / self.exaggeration;
        let [x, y] = grid.position(i);
        let size = grid.extent()[0].max(grid.extent()[1]).max(1e-9);
        let patch = fbm(Seed(3), 24.0 * x / size, 24.0 * y / size, 5, 2.0, 0.55);
        let height = (z[i] - self.low) / self.relief + 0.07 * patch;
        let mean = |a: Rgb, b: Rgb, t: f64| blend(a, b, t.clamp(0.0, 1.0));
        let patched = |[a, b]: [Rgb; 2], strength: f64| mean(a, b, 0.5 + strength * patch);
        let Inks { meadow, heath, forest, rock, snow: white, river: blue } = &self.inks;
        let mut colour = mean(patched(*meadow, 0.8), patched(*heath, 0.7), math::smoothstep(0.18, 0.55, height));
        if !self.cover.is_desert() {
            // Trees like the shade, and leave heights and the steepest ground.
            let stands = fbm(Seed(5), 90.0 * x / size, 90.0 * y / size, 4, 2.1, 0.6);
            let shady = (-gradient.y / self.exaggeration).clamp(-0.6, 0.6);
            let room = 0.45 + 0.8 * stands + 0.7 * shady - 1.3 * math::smoothstep(0.40, 0.72, height);
            let share = math::smoothstep(0.3, 0.6, room - math::smoothstep(0.75, 1.2, slope));
            colour = mean(colour, patched(*forest, 0.8), 0.9 * share);
        }
        let steep = math::smoothstep(0.30, 0.75, slope + 0.12 * patch + 0.3 * (height - 0.35).max(0.0));
        colour = mean(colour, patched(*rock, 0.8), steep);
        // The lower the land, the nearer to its top the snow begins.
        let line = math::lerp(1.1, 0.72, math::smoothstep(800.0, 1800.0, self.relief / self.exaggeration));
        let snow =
            math::smoothstep(line - 0.02, line + 0.1, height) * (1.0 - math::smoothstep(0.7, 1.2, slope + 0.2 * patch));
        colour = mean(colour, *white, snow);
        let river = self.river[i];
        if river > 0.45 {
            colour = mean(colour, *blue, math::smoothstep(0.45, 0.8, river));
        }
        self.cover.tint(from_oklab(colour), i, 0.92 + 0.08 * patch)
    }
}

/// The sky from the horizon to the zenith: mixing in Oklab costs too much to do for each ray.
fn sky_ramp() -> Vec<Rgb> {
    (0..=SKY_STEPS).map(|k| mix(hex(HORIZON), hex(ZENITH), k as f64 / SKY_STEPS as f64)).collect()
}

/// Colour of the sky in a direction that rises by `up`.
fn sky_colour(ramp: &[Rgb], up: f64) -> Rgb {
    let t = math::smoothstep(-0.35, 0.45, up) * SKY_STEPS as f64;
    let k = (t as usize).min(SKY_STEPS - 1);
    blend(ramp[k], ramp[k + 1], t - k as f64)
}

fn along(from: Vector, direction: Vector, t: f64) -> Vector {
    [0, 1, 2].map(|k| from[k] + t * direction[k])
}

fn add(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + b[k])
}

fn sub(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn normalize(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    if length > 0.0 { scale(v, 1.0 / length) } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_frame_holds_the_highest_summit() {
        let grid = Grid::new(Shape::new(40, 60), [10.0, 10.0]).unwrap();
        // One needle at a far corner.
        let z = (0..grid.len()).map(|i| if i == 3 * 60 + 4 { 400.0 } else { 0.0 }).collect();
        let field = HeightField::new(grid, z).unwrap();
        for from in [0.0, 1.0, 2.5, 4.0] {
            let view = View { width: 160, height: 90, from, ..View::default() };
            let scene = Scene::new(&field, &view);
            let camera = Camera::new(&scene, &view);
            for point in scene.outline() {
                let d = sub(point, camera.at);
                let far = dot(d, camera.forward) * camera.half_height;
                let (x, y) = (dot(d, camera.right) / (far * camera.aspect), dot(d, camera.up) / far);
                assert!(x.abs() < 1.0 && y.abs() < 1.0, "from {from}: {point:?} at {x}, {y}");
            }
        }
    }
}
