//! How a particle moves through air and water.
//!
//! # Model
//! ρ V dv/dt = V (ρ − ρ_f) g − 6π μ R (v − u), with the density ρ of the particle and its load,
//! that of the fluid ρ_f, the velocity u of the fluid, the radius R and the viscosity μ. Its
//! solution over a step in which these do not change is
//!
//! v(t) = v∞ + (v − v∞) exp(−t/τ), x(t) = x + v∞ t + (v − v∞) τ (1 − exp(−t/τ)),
//!
//! where v∞ = u + w_s, w_s = 2/9 (ρ − ρ_f) g R²/μ (Stokes) and τ = 2/9 ρ R²/μ. Without viscosity it
//! is free fall, of which Verlet's steps are exact.
//!
//! # Sources
//! Hartley (thesis), Equations 6.5 to 6.8, corrected: forces are divided by the mass; w_s is not
//! added to gravity, of which it follows; without drag there would be no terminal velocity.
//! Hindered settling: Richardson & Zaki (1954), (1 − C)^n; the form 1 − (C/C_max)^n of the thesis
//! is flat where there is little load.

use landform_core::math;

use super::params::Hindrance;

/// Acceleration of free fall, m/s².
pub(super) const GRAVITY: f64 = 9.81;
/// Density of grains of the load, kg/m³.
pub(super) const GRAINS: f64 = 2650.0;
/// Densities of air and water, kg/m³.
pub(super) const AIR: f64 = 1.0;
pub(super) const WATER: f64 = 1000.0;

/// A particle's size and the fluid's resistance to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    /// m.
    pub(super) radius: f64,
    /// Without load, kg/m³.
    pub(super) density: f64,
    /// Pa s.
    pub(super) viscosity: f64,
}

/// Place (m) and velocity (m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State {
    pub(super) at: [f64; 3],
    pub(super) velocity: [f64; 3],
}

impl Body {
    /// Volume, m³.
    pub(super) fn volume(&self) -> f64 {
        4.0 / 3.0 * std::f64::consts::PI * self.radius * self.radius * self.radius
    }

    /// Density with a load that takes a part of the volume, kg/m³.
    pub(super) fn loaded(&self, part: f64) -> f64 {
        self.density + part * (GRAINS - self.density)
    }

    /// Acceleration upwards in a fluid at rest, m/s².
    pub(super) fn weight(&self, density: f64, fluid: f64) -> f64 {
        GRAVITY * (fluid - density) / density
    }

    /// Time in which drag takes hold, s; infinite without viscosity.
    pub(super) fn relaxation(&self, density: f64) -> f64 {
        2.0 / 9.0 * density * self.radius * self.radius / self.viscosity
    }

    /// Stokes' velocity upwards at which it ends in a fluid at rest, m/s; infinite without
    /// viscosity.
    pub(super) fn terminal(&self, density: f64, fluid: f64) -> f64 {
        2.0 / 9.0 * (fluid - density) * GRAVITY * self.radius * self.radius / self.viscosity
    }

    /// Moves for `dt` seconds through a fluid of a density (kg/m³) and velocity (m/s).
    pub(super) fn fly(&self, from: State, density: f64, fluid: f64, flow: [f64; 3], dt: f64) -> State {
        self.drift(from, density, [0.0, 0.0, self.weight(density, fluid)], flow, dt)
    }

    /// Moves for `dt` seconds under an acceleration (m/s²) beside the drag of a flow (m/s).
    pub(super) fn drift(&self, from: State, density: f64, push: [f64; 3], flow: [f64; 3], dt: f64) -> State {
        if !(self.viscosity > 0.0) {
            return State {
                at: [0, 1, 2].map(|k| from.at[k] + from.velocity[k] * dt + 0.5 * push[k] * dt * dt),
                velocity: [0, 1, 2].map(|k| from.velocity[k] + push[k] * dt),
            };
        }
        let slow = self.relaxation(density);
        let left = math::exp(-dt / slow);
        let end = [0, 1, 2].map(|k| flow[k] + push[k] * slow);
        let over = [0, 1, 2].map(|k| from.velocity[k] - end[k]);
        State {
            at: [0, 1, 2].map(|k| from.at[k] + end[k] * dt + over[k] * slow * (1.0 - left)),
            velocity: [0, 1, 2].map(|k| end[k] + over[k] * left),
        }
    }

    /// Exponent of Richardson & Zaki by the Reynolds number of a particle that settles.
    pub(super) fn exponent(&self, fluid: f64) -> f64 {
        let speed = self.terminal(self.density, fluid).abs();
        richardson_zaki(2.0 * fluid * speed * self.radius / self.viscosity)
    }
}

/// Exponent of hindered settling, 4.65 to 2.4, by the Reynolds number.
pub(super) fn richardson_zaki(reynolds: f64) -> f64 {
    match reynolds {
        r if r < 0.2 => 4.65,
        r if r < 1.0 => 4.4 * math::pow(r, -0.03),
        r if r < 500.0 => 4.4 * math::pow(r, -0.1),
        _ => 2.4,
    }
}

/// By how much a load slows settling, 0 to 1: `part` of the particle's volume of at most `most`.
pub(super) fn hindered(law: Hindrance, part: f64, most: f64, exponent: f64) -> f64 {
    match law {
        Hindrance::RichardsonZaki => math::pow((1.0 - part).max(0.0), exponent),
        Hindrance::Legacy if most > 0.0 => 1.0 - math::powi((part / most).min(1.0), 5),
        Hindrance::Legacy => 1.0,
    }
}

/// Speed of waves of a length, m/s: a scale for what is slow.
pub(super) fn wave_speed(radius: f64) -> f64 {
    (GRAVITY * radius).sqrt()
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
