//! Velocity of air and water at a place.

use landform_core::random::Seed;
use landform_core::terrain::{Bounds, Ground};
use landform_core::verb::Formula;
use landform_core::{Error, Result, math};

use super::motion::{AIR, WATER};
use super::params::ParticleErosion;
use super::surroundings::{FASTEST, Flow, FlowIn};
use super::wind::WindField;

/// The fluids around the ground: their level, densities and velocity.
pub(super) struct Fluids {
    /// Level of the water, m; negative infinity without any.
    pub(super) level: f64,
    current: Current,
    flow_in: FlowIn,
    influence: f64,
    plan: [[f64; 2]; 2],
    seed: Seed,
}

enum Current {
    Still,
    Uniform([f64; 3]),
    Formula(Box<[Formula; 3]>),
    Wind(WindField),
}

impl Fluids {
    pub(super) fn new<T: Ground>(
        params: &ParticleErosion,
        ground: &T,
        bounds: &Bounds,
        level: Option<f64>,
        seed: Seed,
    ) -> Result<Self> {
        let current = match &params.flow {
            Flow::None => Current::Still,
            Flow::Uniform(velocity) => Current::Uniform(velocity.map(|v| v.si())),
            Flow::Formula([x, y, z]) => {
                Current::Formula(Box::new([Formula::parse(x)?, Formula::parse(y)?, Formula::parse(z)?]))
            }
            Flow::Wind(wind) => Current::Wind(WindField::over(ground, bounds, wind)),
        };
        Ok(Self {
            level: level.unwrap_or(f64::NEG_INFINITY),
            current,
            flow_in: params.flow_in.unwrap_or_else(|| params.phenomenon.preset().flow_in),
            influence: params.flow_influence,
            plan: [[bounds.low[0], bounds.low[1]], [bounds.high[0], bounds.high[1]]],
            seed: seed.named("flow"),
        })
    }

    /// Density at an elevation, kg/m³.
    #[inline]
    pub(super) fn density(&self, z: f64) -> f64 {
        if z < self.level { WATER } else { AIR }
    }

    /// Velocity at a place, m/s.
    pub(super) fn velocity(&self, at: [f64; 3]) -> Result<[f64; 3]> {
        let is_here = match self.flow_in {
            FlowIn::Water => at[2] < self.level,
            FlowIn::Air => at[2] >= self.level,
            FlowIn::Everywhere => true,
        };
        if !is_here {
            return Ok([0.0; 3]);
        }
        let velocity = match &self.current {
            Current::Still => return Ok([0.0; 3]),
            Current::Uniform(velocity) => *velocity,
            Current::Wind(field) => field.at([at[0], at[1]]),
            Current::Formula(formulas) => {
                let of = |k: usize| formulas[k].at(self.plan, [at[0], at[1]], at[2], self.seed);
                let velocity = [of(0), of(1), of(2)];
                if !velocity.iter().all(|v| v.abs() <= FASTEST) {
                    let place = at.map(|v| format!("{v:.1}")).join(", ");
                    let given = format!("{velocity:?} m/s at {place} m");
                    return Err(Error::parameter("flow.formula", given, "numbers of at most 1000 m/s everywhere"));
                }
                velocity
            }
        };
        Ok(velocity.map(|v| v * self.influence))
    }

    /// Whether nothing flows.
    pub(super) fn is_still(&self) -> bool {
        matches!(self.current, Current::Still)
    }

    /// Direction in which it flows over the map as a whole, east and north; none where it does not.
    pub(super) fn direction(&self, middle: [f64; 3]) -> Result<Option<[f64; 2]>> {
        let level = if self.flow_in == FlowIn::Water { self.level - 1e-6 } else { middle[2].max(self.level) };
        let [x, y, _] = self.velocity([middle[0], middle[1], level])?;
        let speed = math::hypot(x, y);
        Ok((speed > 0.0).then(|| [x / speed, y / speed]))
    }
}
