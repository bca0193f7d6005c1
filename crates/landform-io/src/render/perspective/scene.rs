//! The land as rays meet it: its surface, its light, its colours.

use landform_core::algo::derivative::gradient;
use landform_core::algo::noise::{fbm, gradient_noise_and_rise};
use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::{math, parallel};

use super::View;
use super::block;
use super::paint::Paint;
use super::relief::Relief;
use super::sky::Sky;
use crate::render::colour::{Rgb, blend, hex, mix, scale};
use crate::render::cover::cut;
use crate::render::ground::{CUT, DEEP, DEEPENS, LAGOON, has_coral};
use crate::render::light::{sky_view, sun_view};
use crate::render::{Waters, waters};
use crate::vector::{Vector, along, dot, normalize};

const SUN_LIGHT: Rgb = [2.20, 1.98, 1.66];
const SKY_LIGHT: Rgb = [0.42, 0.51, 0.68];
/// Optical depth of air over the length of both sides of a block.
const HAZE: f64 = 0.35;
/// Way through clear air after which two thirds of the light are lost, m.
const CLEAR_AIR: f64 = 24_000.0;
/// Water is all that one sees where it is so deep, m.
const CLEAR: f64 = 0.9;

/// All values of a node that shading needs.
struct Skin {
    normal: Vector,
    colour: Rgb,
    sky: f64,
    sun: f64,
    /// Depth of water over the ground, m.
    water: f64,
    /// How rough the ground is up close, 0 to 1.
    roughness: f64,
}

/// Values of a [`Skin`] in the order of its fields, in half of the memory.
type StoredSkin = [f32; 10];

impl Skin {
    fn stored(&self) -> StoredSkin {
        let ([nx, ny, nz], [red, green, blue]) = (self.normal, self.colour);
        [nx, ny, nz, red, green, blue, self.sky, self.sun, self.water, self.roughness].map(|v| v as f32)
    }
}

/// The block in local metres: x east, y north from the south-west corner, elevations exaggerated.
pub(super) struct Scene<'a> {
    field: &'a HeightField,
    exaggeration: f64,
    /// Surface, water included.
    pub(super) relief: Relief,
    skin: Vec<StoredSkin>,
    pub(super) low: f64,
    pub(super) high: f64,
    foot: f64,
    sun: Vector,
    sky: Sky,
    /// Whether the water is clear, as over coral reefs.
    is_clear: bool,
    around: Option<Around>,
}

/// Images of the map that a ray passes, at most.
const MOST_IMAGES: usize = 16;

/// Where a ray meets the land or an image of it.
struct Meeting {
    /// The point of the map.
    at: Vector,
    /// How far it is, m.
    far: f64,
    /// -1 along x or y where the image is turned round.
    turned: [f64; 2],
}

/// How ground is seen from within.
struct Near {
    /// What a pixel covers, m.
    footprint: f64,
    turned: [f64; 2],
}

/// What lies around the map, where the eye stands in it.
struct Around {
    /// Its level, m.
    level: f64,
    /// Its colour.
    colour: Rgb,
    /// Whether it is the sea.
    is_sea: bool,
    /// Way after which air has taken away most of what is seen, m.
    clear: f64,
}

impl<'a> Scene<'a> {
    /// Points that the frame must hold.
    pub(super) fn outline(&self) -> Vec<Vector> {
        block::outline(self.field.grid(), &self.relief.surface, self.foot)
    }

    pub(super) fn new(field: &'a HeightField, view: &View) -> Self {
        let grid = field.grid();
        let extent = block::extent(grid);
        let (lo, hi) = block::range(field.elevation());
        let ground: Vec<f64> =
            field.elevation().iter().map(|&z| if z.is_nan() { lo } else { z } * view.exaggeration).collect();
        let Waters { lake, river } = waters(field);
        let depth = block::water_depth(field, &lake, (lo, hi), view.sea_level, view.water);
        let surface: Vec<f64> = (0..ground.len()).map(|i| ground[i] + depth[i] * view.exaggeration).collect();
        let (low, high) = (lo * view.exaggeration, hi * view.exaggeration);
        let surface_high = surface.iter().copied().fold(high, f64::max);
        let seen_sky = sky_view(grid, &surface);
        let sun = sun_view(grid, &surface, view.sun, view.sun_altitude);
        let is_within = view.standpoint.is_some() && view.water;
        // In the land rivers are water that mirrors the sky, not ink on a map.
        let (inked, streams) = match (view.water, is_within) {
            (false, _) => (Vec::new(), Vec::new()),
            (true, false) => (river, Vec::new()),
            (true, true) => (Vec::new(), river),
        };
        let stream = |i: usize| streams.get(i).map_or(0.0, |s| 0.8 * math::smoothstep(0.45, 0.8, *s));
        let paint = Paint::new(field, inked, (lo, hi), view);
        let cols = grid.shape.cols;
        let mut skin = vec![[0.0; 10]; ground.len()];
        parallel::for_rows_mut(&mut skin, cols, |row, skins| {
            let painted = paint.row(grid, row);
            for (col, skin) in skins.iter_mut().enumerate() {
                let i = row * cols + col;
                let g = gradient(grid, &ground, i);
                let normal =
                    if depth[i] > 0.0 { water_normal(grid, &surface, i) } else { normalize([-g.x, -g.y, 1.0]) };
                let node = Skin {
                    normal,
                    colour: paint.ground(&painted, col, i, ground[i], g),
                    sky: seen_sky[i],
                    sun: sun[i],
                    water: depth[i].max(stream(i)),
                    roughness: paint.roughness(i),
                };
                *skin = node.stored();
            }
        });
        let ca = math::cos(view.sun_altitude);
        let foot = block::foot(extent, low, high);
        Self {
            field,
            exaggeration: view.exaggeration,
            relief: Relief::new(grid, surface),
            skin,
            low,
            high: surface_high,
            foot,
            sun: [math::sin(view.sun) * ca, math::cos(view.sun) * ca, math::sin(view.sun_altitude)],
            // A model stands before a backdrop, land under the sky.
            sky: Sky::rising_from(if view.standpoint.is_some() { -0.06 } else { -0.35 }),
            is_clear: has_coral(field),
            around: view.standpoint.map(|_| {
                let sea = view.sea_level;
                let is_sea = hi > sea && wet_border(grid.shape, field.elevation(), sea) > 0.3;
                Around {
                    level: if is_sea { sea * view.exaggeration } else { low },
                    colour: hex(if paint.is_desert() { 0xc9ab80 } else { 0x77764f }),
                    is_sea,
                    clear: CLEAR_AIR.max(1.5 * extent[0].max(extent[1])),
                }
            }),
        }
    }

    /// The colour that comes along a ray to the eye; `angle` is that of a pixel, radians.
    pub(super) fn trace(&self, from: Vector, direction: Vector, angle: f64) -> Rgb {
        if let Some(around) = &self.around {
            return self.trace_within(around, from, direction, angle);
        }
        let Some((enter, leave)) = self.box_span(from, direction) else {
            return self.sky.colour(direction[2]);
        };
        let start = enter.max(0.0);
        let p = along(from, direction, start);
        let (colour, hit) = if enter > 0.0 && p[2] <= self.relief.height_at(p) {
            (self.wall(p), start)
        } else {
            match self.relief.march(from, direction, start, leave) {
                Some(t) => (self.shade(along(from, direction, t), direction, None), t),
                None => return self.sky.colour(direction[2]),
            }
        };
        // Only air over the block hazes: the camera stands far back, as before a model.
        let haze = 1.0 - math::exp(-HAZE * (hit - start) / (self.relief.extent[0] + self.relief.extent[1]));
        blend(colour, self.sky.colour(0.0), haze)
    }

    /// As [`Scene::trace`], from a standpoint in the land.
    fn trace_within(&self, around: &Around, from: Vector, direction: Vector, angle: f64) -> Rgb {
        let (colour, far) = match self.hit_beyond(around, from, direction) {
            Some(Meeting { at, far, turned }) => {
                (self.shade(at, direction, Some(Near { footprint: far * angle, turned })), far)
            }
            None if direction[2] < -1e-6 => {
                let far = (around.level - from[2]).min(0.0) / direction[2];
                (self.shade_around(around, direction), far)
            }
            None => return self.sky.colour(direction[2]),
        };
        let haze = 1.0 - math::exp(-far / around.clear);
        blend(colour, self.sky.colour(0.0), haze)
    }

    /// Where a ray meets the land or its images: land goes on beyond the map as in a mirror at each
    /// side, so that it has no edge. The sea has no images.
    fn hit_beyond(&self, around: &Around, from: Vector, direction: Vector) -> Option<Meeting> {
        let (mut from, mut direction, mut passed, mut turned) = (from, direction, 0.0, [1.0; 2]);
        for _ in 0..MOST_IMAGES {
            if direction[2] >= 0.0 && from[2] > self.high {
                return None;
            }
            let (enter, leave) = self.box_span(from, direction)?;
            if let Some(far) = self.relief.march(from, direction, enter.max(0.0), leave) {
                return Some(Meeting { at: along(from, direction, far), far: passed + far, turned });
            }
            let exit = along(from, direction, leave);
            let is_wall =
                |k: usize| exit[k] <= 1e-6 * self.relief.extent[k] || exit[k] >= (1.0 - 1e-6) * self.relief.extent[k];
            let wall = (0..2).find(|&k| is_wall(k) && direction[k] * (exit[k] - 0.5 * self.relief.extent[k]) > 0.0)?;
            passed += leave;
            if around.is_sea || passed > 4.0 * around.clear {
                return None;
            }
            direction[wall] = -direction[wall];
            turned[wall] = -turned[wall];
            from = [exit[0].clamp(0.0, self.relief.extent[0]), exit[1].clamp(0.0, self.relief.extent[1]), exit[2]];
        }
        None
    }

    /// Distance to the land or an image of it along a ray from within.
    #[cfg(test)]
    pub(super) fn distance_within(&self, from: Vector, direction: Vector) -> Option<f64> {
        let around = self.around.as_ref()?;
        self.hit_beyond(around, from, direction).map(|meeting| meeting.far)
    }

    /// Distance to the surface along a ray, if it meets it.
    pub(super) fn hit(&self, from: Vector, direction: Vector) -> Option<f64> {
        let (enter, leave) = self.box_span(from, direction)?;
        self.relief.march(from, direction, enter.max(0.0), leave)
    }

    /// Whether the map lies in the sea.
    pub(super) fn is_in_sea(&self) -> bool {
        self.around.as_ref().is_some_and(|around| around.is_sea)
    }

    /// The plain or the sea beyond the map.
    fn shade_around(&self, around: &Around, direction: Vector) -> Rgb {
        let lit = |colour: Rgb| {
            let sun = self.sun[2].max(0.0);
            [0, 1, 2].map(|k| colour[k] * (SUN_LIGHT[k] * sun + SKY_LIGHT[k]))
        };
        if around.is_sea { self.mirror(lit(hex(DEEP)), direction) } else { lit(around.colour) }
    }

    /// Water of a colour, under the sky that it mirrors.
    fn mirror(&self, below: Rgb, direction: Vector) -> Rgb {
        let facing = (-direction[2]).clamp(0.0, 1.0);
        let share = 0.03 + 0.97 * math::powi(1.0 - facing, 5);
        blend(below, self.sky.colour(-direction[2]), share)
    }

    /// Where a ray is inside the block's box.
    fn box_span(&self, from: Vector, direction: Vector) -> Option<(f64, f64)> {
        // An eye in the land may stand above it.
        let top = if self.around.is_some() { f64::MAX } else { self.high + 1e-3 };
        let (lo, hi) = ([0.0, 0.0, self.foot], [self.relief.extent[0], self.relief.extent[1], top]);
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for k in 0..3 {
            let (a, b) = ((lo[k] - from[k]) / direction[k], (hi[k] - from[k]) / direction[k]);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (enter < leave && leave > 0.0).then_some((enter, leave))
    }

    /// Level of the surface at a place, m.
    pub(super) fn height_at(&self, p: Vector) -> f64 {
        self.relief.height_at(p)
    }

    fn skin_at(&self, p: Vector) -> Skin {
        let (k, [u, v]) = self.relief.corners(p);
        let weights = [(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v];
        let mut mean = [0.0; 10];
        for (i, w) in k.into_iter().zip(weights) {
            mean.iter_mut().zip(&self.skin[i]).for_each(|(mean, v)| *mean += w * f64::from(*v));
        }
        let [nx, ny, nz, red, green, blue, sky, sun, water, roughness] = mean;
        Skin { normal: normalize([nx, ny, nz]), colour: [red, green, blue], sky, sun, water, roughness }
    }

    /// The colour of a point of the surface, seen along a direction, from outside the block or from
    /// near.
    fn shade(&self, p: Vector, direction: Vector, near: Option<Near>) -> Rgb {
        let mut skin = self.skin_at(p);
        if let Some(Near { footprint, turned }) = near {
            if skin.water < 0.3 * CLEAR {
                self.roughen(&mut skin, p, footprint);
            }
            (0..2).for_each(|k| skin.normal[k] *= turned[k]);
        }
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
        let lagoon = || mix(hex(DEEP), hex(LAGOON), math::exp(-skin.water / DEEPENS));
        let deep = lit(if self.is_clear { lagoon() } else { hex(DEEP) }, [0.0, 0.0, 1.0]);
        let murk = 1.0 - 0.65 * math::exp(-skin.water / 3.0);
        let below = blend(scale(ground, 0.7), deep, murk);
        // Brooks and shores show the ground through.
        blend(ground, self.mirror(below, direction), math::smoothstep(0.0, CLEAR, skin.water))
    }

    /// Gives ground a grain finer than its nodes, in waves that a pixel does not blur: tufts and
    /// stones by colour, bumps by slope.
    fn roughen(&self, skin: &mut Skin, p: Vector, footprint: f64) {
        let cell = self.relief.spacing[0].min(self.relief.spacing[1]);
        let normal = skin.normal;
        let fall = [0, 1].map(|k| normal[k] / normal[2].max(0.2));
        let (mut tone, mut bump) = (0.0, [0.0; 2]);
        for (k, part) in [1.3, 0.45, 0.15, 0.05, 0.017].into_iter().enumerate() {
            let wave = part * cell;
            let seen = 1.0 - math::smoothstep(0.2, 0.6, footprint / wave);
            if seen <= 0.0 {
                break;
            }
            let (here, rise) = grain(Seed(20 + k as u64), p.map(|v| v / wave), normal);
            tone += seen * here;
            (0..2).for_each(|k| bump[k] += seen * (rise[k] - fall[k] * rise[2]));
        }
        skin.colour = scale(skin.colour, 1.0 + 0.17 * skin.roughness * tone.clamp(-1.5, 1.5));
        let bump = bump.map(|b| 0.045 * skin.roughness * b);
        skin.normal = normalize([normal[0] - bump[0], normal[1] - bump[1], normal[2]]);
    }

    /// The cut side of the block: its beds, or plain rock under a little soil.
    fn wall(&self, p: Vector) -> Rgb {
        let on_x = p[0] <= 1e-6 * self.relief.extent[0] || p[0] >= self.relief.extent[0] * (1.0 - 1e-6);
        let normal = if on_x {
            [if p[0] > 0.5 * self.relief.extent[0] { 1.0 } else { -1.0 }, 0.0, 0.0]
        } else {
            [0.0, if p[1] > 0.5 * self.relief.extent[1] { 1.0 } else { -1.0 }, 0.0]
        };
        let scale_length = 0.02 * (self.relief.extent[0] + self.relief.extent[1]);
        let along_wall = if on_x { p[1] } else { p[0] };
        let under = (self.relief.height_at(p) - p[2]) / scale_length;
        let (k, [u, v]) = self.relief.corners(p);
        let (to, t) = if on_x { (k[2], v) } else { (k[1], u) };
        let beds = cut(self.field, [k[0], to], t, p[2] / self.exaggeration);
        let grain = fbm(Seed(11), along_wall / (0.5 * scale_length), p[2] / (0.5 * scale_length), 4, 2.1, 0.6);
        let plain = || mix(hex(CUT[0]), hex(CUT[1]), 0.25 * under + 0.35 * grain);
        let soil = |rock: Rgb| mix(hex(0x54463a), rock, math::smoothstep(0.02, 0.07, under));
        let colour = beds.map_or_else(|| soil(plain()), |bed| scale(bed, 0.9 + 0.12 * grain));
        let light = 0.25 + 0.75 * dot(normal, self.sun).max(0.0);
        [0, 1, 2].map(|k| colour[k] * (0.6 * SUN_LIGHT[k] * light + 0.6 * SKY_LIGHT[k]))
    }
}

/// Noise on a surface, seen along the axes that it faces, and how it rises along x, y and z: on
/// steep ground it is not drawn out.
fn grain(seed: Seed, p: Vector, normal: Vector) -> (f64, Vector) {
    let weights = normal.map(|n| (n * n - 0.1).max(0.0));
    let per_weight = 1.0 / weights.iter().map(|w| w * w).sum::<f64>().sqrt().max(1e-9);
    let (mut sum, mut rise) = (0.0, [0.0; 3]);
    for (k, [u, v]) in [[1, 2], [0, 2], [0, 1]].into_iter().enumerate() {
        let weight = weights[k] * per_weight;
        if weight > 0.0 {
            let (value, [along_u, along_v]) = gradient_noise_and_rise(seed.with(k as u64), p[u], p[v]);
            sum += weight * value;
            rise[u] += weight * along_u;
            rise[v] += weight * along_v;
        }
    }
    (sum, rise)
}

/// Part of the border that lies below a level, m.
fn wet_border(shape: Shape, z: &[f64], level: f64) -> f64 {
    let Shape { rows, cols } = shape;
    let sides = (0..cols).flat_map(|c| [(0, c), (rows - 1, c)]).chain((0..rows).flat_map(|r| [(r, 0), (r, cols - 1)]));
    let (wet, all) =
        sides.fold((0, 0), |(wet, all), (r, c)| (wet + usize::from(z[shape.index(r, c)] < level), all + 1));
    wet as f64 / f64::from(all.max(1))
}

/// Upright on lakes; rivers lie along their beds.
fn water_normal(grid: &Grid, surface: &[f64], i: usize) -> Vector {
    let g = gradient(grid, surface, i);
    // At a shore the slope is the land's, not the water's.
    let slope = g.slope();
    let most = if slope > 0.3 { 0.3 / slope } else { 1.0 };
    normalize([-g.x * most, -g.y * most, 1.0])
}
