//! What a particle wears and lays down in contact, and how it leaves the ground.
//!
//! # Model
//! Shear rate θ = v/l, τ = θ^½; detached: K max(0, τ − τ_c)^a times time and the area πR² of
//! contact, no more than finds room; laid: ω |w_s| f(C) C times time and area, no more than is
//! carried. C is the load as a part of the particle's volume, w_s the speed with which its excess
//! of weight over that of what carries it (the particle itself, or a denser fluid) makes it sink. K
//! is that of rock times the erodibility of the material over that of rock.
//!
//! # Sources
//! Wojtan et al. (2007); Hartley (thesis), Equations 6.1 to 6.4, with the time, the limits by what
//! there is, and no erosion below the critical shear, which are missing there.

use landform_core::math;
use landform_core::terrain::Materials;

use super::motion::{Body, GRAINS, dot, hindered, wave_speed};
use super::params::{Hindrance, ParticleErosion};
use super::presets::Preset;

/// The parameters of the exchange with the ground.
#[derive(Clone, Debug)]
pub(super) struct Law {
    pub(super) capacity: f64,
    pub(super) erosion: f64,
    pub(super) deposition: f64,
    pub(super) critical_shear: f64,
    pub(super) shear_distance: Option<f64>,
    pub(super) shear_exponent: f64,
    pub(super) restitution: f64,
    pub(super) friction: f64,
    pub(super) hindrance: Hindrance,
    /// Erodibility over that of rock, by number of the material; empty on plain ground.
    pub(super) softness: Vec<f64>,
    pub(super) most_hits: Option<u32>,
    pub(super) most_steps: u32,
}

/// Volumes of a contact, m³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Exchanged {
    pub(super) detached: f64,
    pub(super) deposited: f64,
}

/// Part of the speed of waves below which a particle is at rest.
const AT_REST: f64 = 0.01;

impl Law {
    /// The law at a part of the run, 0 to 1.
    pub(super) fn new(params: &ParticleErosion, preset: &Preset, table: Option<&Materials>, part: f64) -> Self {
        let restitution = params.restitution.unwrap_or(preset.restitution);
        let of_rock = table.map_or(1.0, |table| table.get(0).erodibility);
        let softness = |table: &Materials| table.all().iter().map(|m| (m.erodibility / of_rock).min(1e3)).collect();
        Self {
            capacity: params.capacity.unwrap_or(preset.capacity),
            erosion: params.erosion.unwrap_or(preset.erosion) * (1.0 - params.weakening * part.min(1.0)),
            deposition: params.deposition.unwrap_or(preset.deposition),
            critical_shear: params.critical_shear,
            shear_distance: params.shear_distance.map(|l| l.si()),
            shear_exponent: params.shear_exponent,
            restitution,
            friction: params.friction.unwrap_or(0.5 * (1.0 - restitution)),
            hindrance: params.hindrance,
            softness: if of_rock > 0.0 { table.map(softness).unwrap_or_default() } else { Vec::new() },
            most_hits: params.max_hits,
            most_steps: params.max_steps,
        }
    }

    /// What is worn and laid in a contact of `time` seconds at a speed (m/s), with a load (m³);
    /// `ask` is given what weighs the number of the material.
    pub(super) fn exchange(
        &self,
        body: &Body,
        load: f64,
        speed: f64,
        time: f64,
        fluid: f64,
        ask: impl FnOnce(&dyn Fn(u8) -> f64) -> f64,
    ) -> Exchanged {
        let (volume, area) = (body.volume(), std::f64::consts::PI * body.radius * body.radius);
        let shear = (speed / self.shear_distance.unwrap_or(body.radius)).sqrt() - self.critical_shear;
        let room = (self.capacity * volume - load).max(0.0);
        let detached = if shear > 0.0 && room > 0.0 {
            let soft = if self.softness.is_empty() { 1.0 } else { ask(&|number| self.softness[usize::from(number)]) };
            (self.erosion * soft * math::pow(shear, self.shear_exponent) * time * area).min(room)
        } else {
            0.0
        };
        let deposited = if load > 0.0 { self.laid(body, load, time * area, fluid) } else { 0.0 };
        Exchanged { detached, deposited }
    }

    fn laid(&self, body: &Body, load: f64, contact: f64, fluid: f64) -> f64 {
        let part = load / body.volume();
        // Grains sink in what carries them: the particle itself, or the fluid where that is denser.
        let carrier = fluid.max(body.density);
        let settling = body.terminal(carrier + part * (GRAINS - carrier), carrier).abs();
        if !settling.is_finite() {
            return 0.0;
        }
        let exponent = body.exponent(fluid);
        let settling = settling * hindered(self.hindrance, part, self.capacity, exponent);
        (self.deposition * settling * contact * part).min(load)
    }

    /// Velocity after contact with the ground: the normal part comes back by the restitution, the
    /// other loses what friction takes.
    pub(super) fn leave(&self, velocity: [f64; 3], normal: [f64; 3], least: f64) -> [f64; 3] {
        let into = dot(velocity, normal);
        if into >= 0.0 {
            return velocity;
        }
        let back = if -into > least { self.restitution } else { 0.0 };
        let along = [0, 1, 2].map(|k| velocity[k] - into * normal[k]);
        let speed = dot(along, along).sqrt();
        let lost = self.friction * (1.0 + back) * -into;
        let kept = if speed > lost { 1.0 - lost / speed } else { 0.0 };
        [0, 1, 2].map(|k| along[k] * kept - back * into * normal[k])
    }

    /// Whether a particle on the ground stays where it is: slow, and not pushed by more than
    /// friction holds.
    pub(super) fn rests(&self, body: &Body, velocity: [f64; 3], normal: [f64; 3], push: [f64; 3]) -> bool {
        let slow = AT_REST * wave_speed(body.radius);
        if dot(velocity, velocity) > slow * slow {
            return false;
        }
        let into = dot(push, normal);
        let along = [0, 1, 2].map(|k| push[k] - into * normal[k]);
        let whole = dot(push, push).sqrt();
        into <= 0.0 && dot(along, along).sqrt() <= self.friction * -into + 0.01 * whole
    }
}
