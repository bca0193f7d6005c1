//! Parameters of particle erosion.

use landform_core::units::Length;
use landform_core::verb::{Formula, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::presets::Phenomenon;
use super::surroundings::{Emitter, FASTEST, Flow, FlowIn};

/// How ground in voxels is removed and laid.
///
/// ```
/// use landform_process::particles::Voxels;
/// assert_eq!(Voxels::default(), Voxels::Density);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Voxels {
    /// Voxels may be full in part.
    #[default]
    Density,
    /// Voxels are solid or empty: they move as a whole.
    Binary,
}

/// Law by which a load slows settling.
///
/// ```
/// use landform_process::particles::Hindrance;
/// assert_eq!(Hindrance::default(), Hindrance::RichardsonZaki);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Hindrance {
    /// (1 - C)^n, n from 4.65 (viscous) to 2.4 (turbulent), of the volume fraction C.
    #[default]
    RichardsonZaki,
    /// 1 - (C/C_max)^5, as in the thesis.
    Legacy,
}

/// Erosion by particles: drops, waves, grains or flows move through air and water, hit the ground,
/// wear it and lay down what they carry. Each iteration sends out a batch of particles. The
/// `phenomenon` sets all parameters that are not given. Runs without a clock.
///
/// ```
/// use landform_core::verb::Params;
/// use landform_process::particles::ParticleErosion;
/// let bouncy = ParticleErosion { restitution: Some(1.5), ..ParticleErosion::default() };
/// assert!(bouncy.validate().is_err());
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ParticleErosion {
    /// What the particles are.
    pub phenomenon: Phenomenon,
    /// Number of particles in an iteration.
    #[schemars(extend("x-min" = 1, "x-max" = 100_000))]
    pub particles: Option<u64>,
    /// Number of iterations, if there is no clock.
    #[schemars(extend("x-min" = 1, "x-max" = 1_000_000))]
    pub iterations: Option<u64>,
    /// Radius within which a particle works on the ground. If not given, it is so many cells or
    /// voxels as the phenomenon has; in metres the result does not depend on the cells.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1e6))]
    pub radius: Option<Length>,
    /// Greatest radius: each particle has one between the two. If not given, all have `radius`.
    #[schemars(extend("x-min" = 0.001, "x-max" = 1e6))]
    pub greatest_radius: Option<Length>,
    /// Density of the particle, kg/m³; air has 1, water 1000. A load makes it heavier.
    #[schemars(extend("x-min" = 0.1, "x-max" = 10_000.0))]
    pub density: Option<f64>,
    /// Part of its velocity into the ground with which a particle leaves it.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub restitution: Option<f64>,
    /// Coefficient of friction on the ground. If not given, it is half of what `restitution` is
    /// less than 1.
    #[schemars(extend("x-min" = 0.0, "x-max" = 10.0))]
    pub friction: Option<f64>,
    /// Greatest part of its volume that a particle carries.
    #[schemars(extend("x-min" = 0.0, "x-max" = 0.65))]
    pub capacity: Option<f64>,
    /// Speed at which ground is worn under a shear of 1, m/s.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub erosion: Option<f64>,
    /// Part of its settling load that a particle in contact lays down.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub deposition: Option<f64>,
    /// Load at the start, as a part of the greatest.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub initial_load: Option<f64>,
    /// Shear below which nothing is worn, as the square root of speed over distance, 1/s.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e6))]
    pub critical_shear: f64,
    /// Distance over which the flow is sheared at the ground. If not given, the radius.
    #[schemars(extend("x-min" = 1e-6, "x-max" = 1e6))]
    pub shear_distance: Option<Length>,
    /// Exponent of the excess of shear.
    #[schemars(extend("x-min" = 0.1, "x-max" = 5.0))]
    pub shear_exponent: f64,
    /// Effective viscosity, Pa s: it sets the drag, and how fast particles settle. If not given, a
    /// particle of the density of water falls through air at half of the speed at which waves of
    /// its radius run.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e12))]
    pub viscosity: Option<f64>,
    /// Law by which a load slows settling.
    pub hindrance: Hindrance,
    /// Part by which erosion has become weaker in the last iteration.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub weakening: f64,
    /// Velocity of air or water: "none", { uniform = [..] }, { formula = [..] } or { wind = {..} }.
    pub flow: Flow,
    /// Medium in which the flow is: "water", "air" or "everywhere".
    pub flow_in: Option<FlowIn>,
    /// Factor on the flow as particles feel it.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub flow_influence: f64,
    /// Level of the water. If not given, it is the environment's; without one there is no water.
    pub sea_level: Option<Length>,
    /// Where particles start: "sky", "upwind", "water", { point = {..} } or { box = {..} }.
    pub emitter: Option<Emitter>,
    /// Number of hits after which a particle is gone, and its load with it. If not given, there is
    /// no limit.
    #[schemars(extend("x-min" = 1, "x-max" = 1_000_000_000))]
    pub max_hits: Option<u32>,
    /// Number of steps of half a cell after which a particle lays down its load.
    #[schemars(extend("x-min" = 1, "x-max" = 1_000_000))]
    pub max_steps: u32,
    /// Material as which worn rock is laid down, on ground with layers or in voxels.
    pub deposits: String,
    /// Voxels only: "density", they may be full in part; or "binary", where those that are not
    /// full in part (`to_voxels` with `partial = false`) move as a whole.
    pub voxels: Voxels,
}

impl Default for ParticleErosion {
    fn default() -> Self {
        Self {
            phenomenon: Phenomenon::Rain,
            particles: None,
            iterations: None,
            radius: None,
            greatest_radius: None,
            density: None,
            restitution: None,
            friction: None,
            capacity: None,
            erosion: None,
            deposition: None,
            initial_load: None,
            critical_shear: 0.0,
            shear_distance: None,
            shear_exponent: 1.0,
            viscosity: None,
            hindrance: Hindrance::RichardsonZaki,
            weakening: 0.0,
            flow: Flow::None,
            flow_in: None,
            flow_influence: 1.0,
            sea_level: None,
            emitter: None,
            max_hits: None,
            max_steps: 1000,
            deposits: "sediment".into(),
            voxels: Voxels::Density,
        }
    }
}

impl Params for ParticleErosion {
    const NAME: &'static str = "particle_erosion";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Hartley et al. (2024)",
            title: "Flexible terrain erosion, The Visual Computer 40",
            doi: "10.1007/s00371-024-03444-w",
        },
        Source {
            authors: "Wojtan, Carlson, Mucha & Turk (2007)",
            title: "Animating corrosion and erosion, Eurographics Workshop on Natural Phenomena",
            doi: "10.2312/NPH/NPH07/015-022",
        },
        Source {
            authors: "Richardson & Zaki (1954)",
            title: "Sedimentation and fluidisation: Part I, Transactions of the Institution of Chemical Engineers 32",
            doi: "",
        },
        Source {
            authors: "Paris, Peytavie, Guérin, Argudo & Galin (2019)",
            title: "Desertscape simulation, Computer Graphics Forum 38(7)",
            doi: "10.1111/cgf.13815",
        },
    ];

    fn check(&self) -> Result<()> {
        if let (Some(least), Some(most)) = (self.radius, self.greatest_radius)
            && most.si() < least.si()
        {
            return Err(Error::parameter("greatest_radius", most, &format!("at least `radius`, {least}")));
        }
        if let Flow::Formula(formulas) = &self.flow {
            formulas.iter().try_for_each(|text| Formula::parse(text).map(drop))?;
        }
        let fast = |name: &str, speed: f64| match speed.abs() <= FASTEST {
            true => Ok(()),
            false => Err(Error::parameter(name, format!("{speed} m/s"), "at most 1000 m/s")),
        };
        match &self.flow {
            Flow::Uniform(velocity) => velocity.iter().try_for_each(|v| fast("flow.uniform", v.si()))?,
            Flow::Wind(wind) => fast("flow.wind.speed", wind.speed.si())?,
            Flow::None | Flow::Formula(_) => {}
        }
        if let Some(Emitter::Point(ball)) = &self.emitter
            && !(ball.radius.si() >= 0.0)
        {
            return Err(Error::parameter("emitter.point.radius", ball.radius, "0 m or more"));
        }
        if let Some(Emitter::Box(sides)) = &self.emitter
            && let Some(k) = (0..3).find(|&k| !(sides.low[k].si() <= sides.high[k].si()))
        {
            let given = format!("from {} to {}", sides.low[k], sides.high[k]);
            return Err(Error::parameter("emitter.box", given, "a box whose low sides are not above its high ones"));
        }
        Ok(())
    }

    fn bytes_a_node(&self) -> Option<u64> {
        Some(40)
    }
}
