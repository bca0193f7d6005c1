//! The rock: where it is, its fractures and beds, the water table, and what a way costs.

use landform_core::algo::noise::gradient_noise;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::Length;
use landform_core::{Error, Result, math};

use super::KarstNetwork;
use super::space::{Vector, distance, dot, minus, plus, unit};
use crate::mechanism::plane_normal;

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
    /// [`Error::Parameter`] for a spring off the map or on nodata.
    pub(super) fn new(params: &KarstNetwork, ground: &'a HeightField, seed: Seed) -> Result<Self> {
        let bounds = ground.bounds();
        let side = (bounds[1][0] - bounds[0][0]).max(bounds[1][1] - bounds[0][1]);
        if !(side > 0.0) {
            return Err(Error::parameter("grid", "one node", "ground of some extent"));
        }
        let step = params.step.map_or(side / 100.0, Length::si);
        if side / step > 2_000.0 {
            return Err(Error::parameter("step", format!("{step} m"), &format!("at least {} m", side / 2_000.0)));
        }
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
            cover: params.radius[0].si() + 1.0,
            bend: params.bend.map_or(side / 40.0, Length::si),
            step,
            depth: params.phreatic_depth.si(),
            seed,
        };
        rock.springs = springs(params, &rock)?;
        Ok(rock)
    }

    /// Elevation of the ground, m; NaN beyond it.
    pub(super) fn surface(&self, x: f64, y: f64) -> f64 {
        self.ground.elevation_at([x, y])
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
    /// `cover` is the least rock over it, m.
    pub(super) fn inside(&self, mut at: Vector, cover: f64) -> Vector {
        for k in 0..2 {
            let inset = (0.002 * (self.bounds[1][k] - self.bounds[0][k])).min(self.step);
            at[k] = at[k].clamp(self.bounds[0][k] + inset, self.bounds[1][k] - inset);
        }
        for &(middle, radius) in &self.forbidden {
            if distance(at, middle) < radius {
                let out = minus(at, middle);
                // Sideways rather than up, where it does not matter.
                let out = if dot(out, out) > 0.0 { unit(out) } else { [1.0, 0.0, 0.0] };
                at = plus(middle, out, 1.001 * radius);
            }
        }
        let top = self.surface(at[0], at[1]);
        if top - cover < at[2] {
            at[2] = top - cover;
        }
        at
    }

    /// Moves a place of a growing network into the rock.
    pub(super) fn held(&self, at: Vector) -> Vector {
        self.inside(at, self.cover)
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

    /// Whether the rock of a place dissolves more readily than most.
    pub(super) fn dissolves(&self, at: Vector) -> bool {
        Self::noise(self.seed.with(7), at, 3.0 * self.bend) < -0.2
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
        let chance = self.seed.with(9).uniform(at[0].to_bits() ^ at[1].to_bits().rotate_left(17));
        let along = |k: usize| {
            let n = self.fracture(k, at);
            (plus(direction, n, -dot(direction, n)), self.fractures[k].weight)
        };
        let best = (0..self.fractures.len()).map(along).max_by(|a, b| dot(a.0, a.0).total_cmp(&dot(b.0, b.0)));
        // Passages are in a fracture or they are not; between fractures they cross the rock.
        if let Some((along, _)) = best.filter(|b| chance < b.1 / (0.5 + b.1)) {
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

fn springs(params: &KarstNetwork, rock: &Rock<'_>) -> Result<Vec<(Vector, f64)>> {
    let place = |at: [f64; 2], level: Option<f64>| {
        let top = rock.surface(at[0], at[1]);
        if !top.is_finite() {
            let given = format!("{}, {} m", at[0], at[1]);
            return Err(Error::parameter("springs", given, "places on the map, on ground with data"));
        }
        let level = level.unwrap_or(top);
        Ok(([at[0], at[1], top.min(level)], level))
    };
    if params.springs.is_empty() {
        let z = rock.ground.elevation();
        let finite = (0..z.len()).filter(|&i| z[i].is_finite());
        let lowest = finite.min_by(|&a, &b| z[a].total_cmp(&z[b])).unwrap_or(0);
        return Ok(vec![place(rock.ground.position(lowest), None)?]);
    }
    params.springs.iter().map(|s| place(s.at.map(Length::si), s.water_table.map(Length::si))).collect()
}
