//! The rock: where it is, its fractures and beds, the water table, and what a way costs.

use landform_core::algo::noise::gradient_noise;
use landform_core::random::{Draws, Seed};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Length, number_text, place_text};
use landform_core::verb::Params;
use landform_core::{Error, Result, math};

use super::KarstNetwork;
use super::space::{Vector, distance, dot, minus, plus, unit};
use crate::mechanism::plane_normal;

/// Ground higher than this many times the longer side of the map is refused.
const RELIEF: f64 = 10.0;
/// Ground beyond this elevation is refused, m.
const HIGHEST: f64 = 1e6;
/// Length over which rock is fractured alike, over that of bends.
const STRETCH: f64 = 2.5;
/// How far out of a sphere passages are moved, over its radius.
const OUTSIDE: f64 = 1.002;

/// The rock under a surface.
pub(super) struct Rock<'a> {
    ground: &'a HeightField,
    /// South-west and north-east corner, m.
    pub(super) bounds: [[f64; 2]; 2],
    /// Place of each spring, and the level of its water table (m).
    pub(super) springs: Vec<(Vector, f64)>,
    fractures: Vec<Family>,
    beds: Vec<Plane>,
    forbidden: Vec<(Vector, f64)>,
    /// Whether there are no spheres and no nodata.
    is_whole: bool,
    /// Least rock over a passage, m.
    cover: f64,
    /// Length of bends, m.
    pub(super) bend: f64,
    pub(super) step: f64,
    pub(super) depth: f64,
    pub(super) seed: Seed,
}

struct Plane {
    at: Vector,
    normal: Vector,
    weight: f64,
}

/// Fractures of nearly the same attitude.
struct Family {
    dip_direction: f64,
    dip: f64,
    tolerance: f64,
    weight: f64,
}

impl<'a> Rock<'a> {
    /// # Errors
    /// [`Error::Parameter`] for lengths that do not fit the ground, and springs, waypoints and beds
    /// that do not lie in it; [`Error::Recipe`] for ground that is too high.
    pub(super) fn new(params: &KarstNetwork, ground: &'a HeightField, seed: Seed) -> Result<Self> {
        let bounds = ground.bounds();
        let side = (bounds[1][0] - bounds[0][0]).max(bounds[1][1] - bounds[0][1]);
        if !(side > 0.0) {
            return Err(Error::parameter("grid", "one node", "ground of some extent"));
        }
        params.check_on([0, 1].map(|k| bounds[1][k] - bounds[0][k]))?;
        let heights = ground.elevation().iter().filter(|z| z.is_finite());
        let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(*z), h.max(*z)));
        if low > high {
            return Err(Error::Empty { what: "the ground".into() });
        }
        if high - low > RELIEF * side || low.abs().max(high.abs()) > HIGHEST {
            return Err(too_high(low, high, side));
        }
        let step = params.step.map_or(side / 100.0, Length::si);
        let middle = [0, 1].map(|k| 0.5 * (bounds[0][k] + bounds[1][k]));
        let bed = |b: &super::Bed| Plane {
            at: [middle[0], middle[1], b.elevation.si()],
            normal: plane_normal(b.dip.si(), b.dip_direction.si()),
            weight: b.weight,
        };
        let family = |f: &super::Fracture| Family {
            dip_direction: f.dip_direction.si(),
            dip: f.dip.si(),
            tolerance: f.tolerance.si(),
            weight: f.weight,
        };
        let mut rock = Self {
            ground,
            bounds,
            springs: Vec::new(),
            fractures: params.fractures.iter().map(family).collect(),
            beds: params.beds.iter().map(bed).collect(),
            forbidden: params.forbidden.iter().map(|f| (f.at.map(Length::si), f.radius.si())).collect(),
            is_whole: params.forbidden.is_empty() && ground.elevation().iter().all(|z| z.is_finite()),
            cover: params.radius[0].si() + 1.0,
            bend: params.bend.map_or(side / 40.0, Length::si),
            step,
            depth: params.phreatic_depth.si(),
            seed,
        };
        rock.springs = springs(params, &rock, side)?;
        rock.check_waypoints(params, side)?;
        let lies_in = |b: &super::Bed| (low - side..=high + side).contains(&b.elevation.si());
        match params.beds.iter().find(|b| !lies_in(b)) {
            Some(bed) => {
                let expected = format!("{} to {} m on this ground", low - side, high + side);
                Err(Error::parameter("beds.elevation", bed.elevation, &expected))
            }
            None => Ok(rock),
        }
    }

    /// Refuses waypoints in the sky, under nodata or far under the map.
    fn check_waypoints(&self, params: &KarstNetwork, side: f64) -> Result<()> {
        for waypoint in &params.waypoints {
            let [x, y, z] = waypoint.map(Length::si);
            let top = self.surface(x, y);
            let is_inside = z <= top - self.cover && z >= top - side;
            if !(is_inside && self.is_free([x, y, z])) {
                let expected = if top.is_finite() {
                    format!("elevations of {} to {} m there, outside `forbidden` spheres", top - side, top - self.cover)
                } else {
                    "places on the map, under ground with data".into()
                };
                let [x, y, z] = waypoint;
                return Err(Error::parameter("waypoints", format!("{x}, {y}, {z}"), &expected));
            }
        }
        Ok(())
    }

    /// Elevation of the ground, m; NaN beyond it.
    pub(super) fn surface(&self, x: f64, y: f64) -> f64 {
        // Places are kept to the millimetre; the border need not lie on one.
        let on_map = |v: f64, k: usize| {
            let held = v.clamp(self.bounds[0][k], self.bounds[1][k]);
            if (held - v).abs() < 1e-3 { held } else { v }
        };
        self.ground.elevation_at([on_map(x, 0), on_map(y, 1)])
    }

    /// Whether the ground has data at a place of the map and next to it.
    fn is_known_around(&self, at: [f64; 2]) -> bool {
        let near = |k: usize, by: f64| (at[k] + by).clamp(self.bounds[0][k], self.bounds[1][k]);
        [-0.01, 0.01]
            .into_iter()
            .all(|x| [-0.01, 0.01].into_iter().all(|y| self.surface(near(0, x), near(1, y)).is_finite()))
    }

    /// Level of the water table, that of the nearest spring, m.
    pub(super) fn water_table(&self, at: Vector) -> f64 {
        let far = |s: &Vector| math::hypot(s[0] - at[0], s[1] - at[1]);
        let nearest = self.springs.iter().min_by(|a, b| far(&a.0).total_cmp(&far(&b.0)));
        nearest.map_or(0.0, |s| s.1)
    }

    /// The strike of the first two families of steep fractures, radians from north.
    pub(super) fn strikes(&self) -> Vec<f64> {
        let steep = self.fractures.iter().filter(|f| f.dip > 0.7);
        steep.map(|f| f.dip_direction + std::f64::consts::FRAC_PI_2).take(2).collect()
    }

    /// Moves a place into the rock: onto the map, under the ground, out of forbidden spheres.
    /// `cover` is the least rock over it, m. Where no place near it will do, it stays.
    pub(super) fn inside(&self, at: Vector, cover: f64) -> Vector {
        let moved = self.under(at, cover);
        if self.is_free(moved) {
            return moved;
        }
        let mut moved = at;
        for _ in 0..4 {
            for &(middle, radius) in &self.forbidden {
                if distance(moved, middle) >= radius {
                    continue;
                }
                let out = minus(moved, middle);
                let out = if dot(out, out) > 0.0 { unit(out) } else { [1.0, 0.0, 0.0] };
                moved = plus(middle, out, OUTSIDE * radius);
            }
            moved = self.under(moved, cover);
            if self.is_free(moved) {
                return moved;
            }
        }
        self.beside(at, cover).unwrap_or_else(|| self.under(at, cover))
    }

    /// Onto the map and under the ground.
    fn under(&self, mut at: Vector, cover: f64) -> Vector {
        for k in 0..2 {
            let inset = (0.002 * (self.bounds[1][k] - self.bounds[0][k])).min(self.step);
            at[k] = at[k].clamp(self.bounds[0][k] + inset, self.bounds[1][k] - inset);
        }
        let top = self.surface(at[0], at[1]);
        if top - cover < at[2] {
            at[2] = top - cover;
        }
        at
    }

    /// The nearest place sideways of or under the spheres around a place that is in the rock.
    fn beside(&self, at: Vector, cover: f64) -> Option<Vector> {
        let around = self.forbidden.iter().filter(|f| distance(at, f.0) < f.1);
        let places = around.flat_map(|&(middle, radius)| {
            let turn = |k: usize| std::f64::consts::TAU * k as f64 / 16.0;
            let sideways = (0..16).map(move |k| [math::cos(turn(k)), math::sin(turn(k)), 0.0]);
            let ways = sideways.chain([[0.0, 0.0, -1.0]]);
            ways.map(move |way| {
                // As far as it takes to leave the sphere this way.
                let off = minus(at, middle);
                let along = dot(off, way);
                let far = (along * along - dot(off, off) + OUTSIDE * OUTSIDE * radius * radius).max(0.0).sqrt() - along;
                plus(at, way, far)
            })
        });
        let fits = places.map(|p| self.under(p, cover)).filter(|p| self.is_in_rock(*p));
        fits.min_by(|a, b| distance(*a, at).total_cmp(&distance(*b, at)))
    }

    /// Moves a place of a growing network into the rock.
    pub(super) fn held(&self, at: Vector) -> Vector {
        self.inside(at, self.cover)
    }

    /// Whether a place lies outside all forbidden spheres.
    pub(super) fn is_free(&self, at: Vector) -> bool {
        self.forbidden.iter().all(|f| distance(at, f.0) >= f.1)
    }

    /// Whether a place lies on the map, under ground with data, and outside forbidden spheres.
    pub(super) fn is_in_rock(&self, at: Vector) -> bool {
        at[2] <= self.surface(at[0], at[1]) + 1e-6 && self.is_free(at)
    }

    /// A place to the millimetre, not above the ground.
    pub(super) fn settled(&self, at: Vector) -> Vector {
        let [x, y, z] = at.map(|v| (v * 1000.0).round() / 1000.0);
        let top = self.surface(x, y);
        // Nodata has no top; a place under it is found out elsewhere.
        if top < z { [x, y, (top * 1000.0).floor() / 1000.0] } else { [x, y, z] }
    }

    /// The direction down along the wall of the nearest sphere; a level heading on top of it.
    pub(super) fn along_wall(&self, at: Vector, heading: Vector) -> Vector {
        let off = |f: &(Vector, f64)| distance(at, f.0) - f.1;
        let nearest = self.forbidden.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let Some((middle, _)) = nearest else { return [0.0, 0.0, -1.0] };
        let out = unit(minus(at, *middle));
        let down = plus([0.0, 0.0, -1.0], out, out[2]);
        if dot(down, down) > 1e-4 { unit(down) } else { heading }
    }

    /// Whether a straight way, looked at in pieces of a length (m), keeps to the rock.
    pub(super) fn is_clear(&self, a: Vector, b: Vector, piece: f64) -> bool {
        if self.is_whole {
            return true;
        }
        let pieces = (distance(a, b) / piece).ceil().clamp(1.0, 10_000.0) as usize;
        let misses = |f: &(Vector, f64)| off_line(f.0, a, b).1 >= f.1;
        (0..=pieces).all(|k| {
            let at = plus(a, minus(b, a), k as f64 / pieces as f64);
            self.surface(at[0], at[1]).is_finite()
        }) && self.forbidden.iter().all(misses)
    }

    /// A place on a straight way, moved onto an arc around a sphere that is in the way. The arc
    /// leads to the side on which the way passes the middle, else to another that is in the rock.
    pub(super) fn around(&self, a: Vector, b: Vector, at: Vector, cover: f64) -> Vector {
        let mut moved = at;
        for &(middle, radius) in &self.forbidden {
            let radius = OUTSIDE * radius;
            let (foot, off) = off_line(middle, a, b);
            let along = distance(at, foot);
            if off >= radius || along >= (radius * radius - off * off).sqrt() {
                continue;
            }
            let way = unit(minus(b, a));
            let side = if off > 1e-6 { unit(minus(foot, middle)) } else { across(way) };
            let other = [
                way[1] * side[2] - way[2] * side[1],
                way[2] * side[0] - way[0] * side[2],
                way[0] * side[1] - way[1] * side[0],
            ];
            let sides = [side, other, other.map(|v| -v), side.map(|v| -v)];
            let top = |s: &&Vector| self.is_in_rock(plus(plus(middle, **s, radius), [0.0, 0.0, cover], 1.0));
            let side = sides.iter().find(top).unwrap_or(&side);
            let out = (radius * radius - along * along).max(0.0).sqrt();
            moved = plus(plus(middle, minus(at, foot), 1.0), *side, out);
        }
        moved
    }

    /// Least rock over passages, m.
    pub(super) fn cover(&self) -> f64 {
        self.cover
    }

    /// Whether a place lies in rock that dissolves.
    pub(super) fn holds(&self, at: Vector) -> bool {
        let top = self.surface(at[0], at[1]);
        at[2] <= top - self.cover && self.forbidden.iter().all(|f| distance(at, f.0) >= f.1)
    }

    /// Noise in space, in about [-1, 1].
    pub(super) fn noise(seed: Seed, at: Vector, wave: f64) -> f64 {
        let [x, y, z] = at.map(|v| v / wave);
        0.7 * (gradient_noise(seed, x + 0.31 * z, y - 0.27 * z)
            + gradient_noise(seed.with(1), x - y + 0.7, 1.3 * z + 0.4))
    }

    /// How hard the rock of a place is to dissolve, in about [-1, 1].
    pub(super) fn resistance(&self, at: Vector) -> f64 {
        Self::noise(self.seed.with(8), at, 8.0 * self.bend)
    }

    /// Part of the rock in which passages follow fractures, 0 to 1.
    pub(super) fn fractured(&self) -> f64 {
        self.fractures.iter().map(|f| share(f.weight)).fold(0.0, f64::max)
    }

    /// The attitude of fractures of a family at a place, as a normal.
    fn fracture(&self, k: usize, at: Vector) -> Vector {
        let family = &self.fractures[k];
        let turn = Self::noise(self.seed.with(40 + k as u64), at, 3.0 * self.bend).clamp(-1.0, 1.0);
        plane_normal(family.dip, family.dip_direction + turn * family.tolerance)
    }

    /// Turns a direction towards the nearest family of fractures and bed.
    pub(super) fn guided(&self, at: Vector, direction: Vector) -> Vector {
        let mut sum = direction;
        // Stretches of rock are fractured or they are not.
        let [x, y, _] = at.map(|v| (v / (STRETCH * self.bend)).floor() as i64 as u64);
        let chance = self.seed.with(9).uniform(x ^ y.rotate_left(32));
        let along = |k: usize| {
            let n = self.fracture(k, at);
            (plus(direction, n, -dot(direction, n)), self.fractures[k].weight)
        };
        let best = (0..self.fractures.len()).map(along).max_by(|a, b| dot(a.0, a.0).total_cmp(&dot(b.0, b.0)));
        // Passages are in a fracture or they are not; between fractures they cross the rock.
        if let Some((along, _)) = best.filter(|b| chance < share(b.1)) {
            sum = unit(along);
        }
        if let Some((bed, off)) = self.nearest_bed(at) {
            // Back onto the bed over a few steps, and along it.
            let pull = (-off / (3.0 * self.step)).clamp(-1.0, 1.0);
            let flat = plus(sum, bed.normal, -dot(sum, bed.normal));
            sum = plus(plus(sum, unit(flat), bed.weight), bed.normal, 1.5 * bed.weight * pull);
        }
        unit(sum)
    }

    /// A direction aside of a passage: along a fracture that the passage does not follow, else to
    /// either side.
    pub(super) fn aside(&self, at: Vector, passage: Vector, draws: &mut Draws) -> Vector {
        let side = if draws.uniform() < 0.5 { 1.0 } else { -1.0 };
        let strike = |k: usize| {
            let n = self.fracture(k, at);
            unit([-n[1], n[0], 0.0])
        };
        let chance = draws.uniform();
        let turn = draws.uniform();
        let follows = |k: &usize| chance < share(self.fractures[*k].weight);
        let across = (0..self.fractures.len()).filter(follows).map(strike).filter(|s| dot(*s, passage).abs() < 0.85);
        let ways: Vec<Vector> = across.collect();
        if !ways.is_empty() {
            let way = ways[((turn * ways.len() as f64) as usize).min(ways.len() - 1)];
            return way.map(|v| side * v);
        }
        let angle = side * (0.7 + 1.2 * turn);
        let (s, c) = (math::sin(angle), math::cos(angle));
        unit([c * passage[0] - s * passage[1], s * passage[0] + c * passage[1], 0.0])
    }

    /// The nearest bed, and how far above it a place lies, m.
    fn nearest_bed(&self, at: Vector) -> Option<(&Plane, f64)> {
        let off = |b: &Plane| dot(minus(at, b.at), b.normal);
        let all = self.beds.iter().map(|b| (b, off(b)));
        all.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
    }

    /// The elevation of the bed next to a place, m; the place's own without beds.
    pub(super) fn on_bed(&self, at: Vector) -> f64 {
        self.nearest_bed(at).map_or(at[2], |(bed, off)| at[2] - off * bed.weight.min(1.0) / bed.normal[2].max(0.2))
    }

    /// What a straight way costs: its length (m) times a factor of the rock and of the water.
    pub(super) fn cost(&self, a: Vector, b: Vector) -> f64 {
        let (way, middle) = (minus(b, a), plus(a, minus(b, a), 0.5));
        let far = (dot(way, way)).sqrt();
        let direction = unit(way);
        let across = (0..self.fractures.len())
            .map(|k| (dot(direction, self.fracture(k, middle)).abs(), self.fractures[k].weight))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let fractures = across.map_or(0.0, |(across, weight)| 2.0 * weight * across);
        let beds = self
            .nearest_bed(middle)
            .map_or(0.0, |(bed, off)| bed.weight * (off.abs() / self.depth.max(self.step)).min(3.0));
        let above = middle[2] - self.water_table(middle);
        // Water falls through drained rock, and keeps to the upper part of what it fills.
        let water =
            if above > 0.0 { 1.5 * (1.0 - direction[2].abs()) } else { (-above / self.depth.max(1.0)).min(4.0) };
        let dissolves = math::exp(0.8 * Self::noise(self.seed.with(7), middle, 3.0 * self.bend));
        far * dissolves * (1.0 + fractures + beds + water)
    }
}

/// Part of the rock in which passages follow fractures of a weight.
fn share(weight: f64) -> f64 {
    weight / (0.5 + weight)
}

/// The place of a line between two places next to another, and how far from it, m.
fn off_line(from: Vector, a: Vector, b: Vector) -> (Vector, f64) {
    let way = minus(b, a);
    let t = (dot(minus(from, a), way) / dot(way, way).max(1e-300)).clamp(0.0, 1.0);
    let foot = plus(a, way, t);
    (foot, distance(foot, from))
}

/// A level direction across another.
fn across(way: Vector) -> Vector {
    let level = [-way[1], way[0], 0.0];
    if dot(level, level) > 1e-12 { unit(level) } else { [1.0, 0.0, 0.0] }
}

fn too_high(low: f64, high: f64, side: f64) -> Error {
    let [from, to] = [low, high].map(number_text);
    Error::Recipe {
        at: None,
        what: format!(
            "the ground lies at {from} to {to} m; `karst_network` takes heights of at most {:.0} m",
            RELIEF * side
        ),
        hint: Some("are its elevations in metres?".into()),
    }
}

fn springs(params: &KarstNetwork, rock: &Rock<'_>, side: f64) -> Result<Vec<(Vector, f64)>> {
    let place = |at: [f64; 2], level: Option<f64>| {
        let top = rock.surface(at[0], at[1]);
        if !top.is_finite() {
            return Err(Error::parameter(
                "springs",
                place_text([at[0], at[1]]),
                "places on the map, on ground with data",
            ));
        }
        let level = level.unwrap_or(top);
        if level > top {
            let expected = format!("at most {} m, the ground there: water leaves through it", number_text(top));
            return Err(Error::parameter("springs.water_table", format!("{} m", number_text(level)), &expected));
        }
        if level < top - side {
            let expected = format!("at least {} m there: no deeper than the map is wide", top - side);
            return Err(Error::parameter("springs.water_table", format!("{} m", number_text(level)), &expected));
        }
        let at = [at[0], at[1], top.min(level)];
        if !rock.is_free(at) {
            return Err(Error::parameter("springs", place_text([at[0], at[1]]), "places outside `forbidden` spheres"));
        }
        Ok((at, level))
    };
    if params.springs.is_empty() {
        let z = rock.ground.elevation();
        let is_open = |i: &usize| {
            let [x, y] = rock.ground.position(*i);
            z[*i].is_finite() && rock.is_free([x, y, z[*i]]) && rock.is_known_around([x, y])
        };
        let Some(lowest) = (0..z.len()).filter(is_open).min_by(|&a, &b| z[a].total_cmp(&z[b])) else {
            let what = "there is no place for a spring: no ground with data lies outside `forbidden` spheres";
            let hint = Some("give smaller spheres, or ground with data on nodes side by side".into());
            return Err(Error::Recipe { at: None, what: what.into(), hint });
        };
        return Ok(vec![place(rock.ground.position(lowest), None)?]);
    }
    params.springs.iter().map(|s| place(s.at.map(Length::si), s.water_table.map(Length::si))).collect()
}
