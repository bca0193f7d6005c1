//! Planes in the rock: beds and sets of fractures.

use landform_core::random::Seed;
use landform_core::units::{Angle, Length};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanism::plane_normal;

/// A set of parallel fractures.
///
/// ```
/// let set = r#"{"dip_direction":"120 deg","dip":"85 deg","spacing":"9 m"}"#;
/// let set: landform_process::volume::FractureParams = serde_json::from_str(set).unwrap();
/// assert_eq!(set.permeability, 4.0);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FractureParams {
    /// Compass direction towards which the planes dip.
    pub dip_direction: Angle,
    /// Angle of the planes below the horizontal.
    #[schemars(extend("x-min" = 0.0, "x-max" = 90.0))]
    pub dip: Angle,
    /// Mean distance between planes, across them.
    #[schemars(extend("x-above" = 0.0))]
    pub spacing: Length,
    /// Permeability along the planes as a factor on that of plain rock.
    #[serde(default = "four")]
    #[schemars(extend("x-above" = 0.0, "x-max" = 1000.0))]
    pub permeability: f64,
    /// Opening of a plane, which adds to the porosity.
    #[serde(default = "closed")]
    #[schemars(extend("x-min" = 0.0, "x-max" = 10.0))]
    pub aperture: Length,
    /// Share of the spacing by which planes lie off even places: 0 none, 1 by up to half of it.
    #[serde(default = "half")]
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub irregularity: f64,
}

fn four() -> f64 {
    4.0
}

fn closed() -> Length {
    Length::of(0.0)
}

fn half() -> f64 {
    0.5
}

/// Direction across planes of a dip.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fall {
    normal: [f64; 3],
}

impl Fall {
    /// Planes that dip by an angle towards a compass direction, rad.
    pub(super) fn new(dip: f64, direction: f64) -> Self {
        Self { normal: plane_normal(dip, direction) }
    }

    /// Distance across the planes, upwards, m.
    pub(super) fn across(&self, place: [f64; 3]) -> f64 {
        (0..3).map(|k| self.normal[k] * place[k]).sum()
    }
}

/// A set of fractures at its place.
pub(super) struct Planes {
    fall: Fall,
    spacing: f64,
    irregularity: f64,
    seed: Seed,
    pub(super) permeability: f64,
    pub(super) aperture: f64,
}

impl FractureParams {
    pub(super) fn planes(&self, seed: Seed) -> Planes {
        Planes {
            fall: Fall::new(self.dip.si(), self.dip_direction.si()),
            spacing: self.spacing.si(),
            irregularity: self.irregularity,
            seed: seed.named("fractures"),
            permeability: self.permeability,
            aperture: self.aperture.si(),
        }
    }
}

impl Planes {
    /// Whether a plane leads through a voxel: none of its neighbours over faces lies nearer to it.
    pub(super) fn meets(&self, place: [f64; 3], sides: [f64; 3]) -> bool {
        let thick = (0..3).map(|k| (self.fall.normal[k] * sides[k]).abs()).fold(0.0, f64::max);
        let at = self.fall.across(place) / self.spacing;
        let shift = self.seed.uniform(0);
        // The planes on both sides of the place, each off its even position.
        let off = |j: f64| {
            let drawn = self.seed.with(1).uniform((j as i64) as u64) - 0.5;
            (at - (j + shift + self.irregularity * drawn)) * self.spacing
        };
        let near = (at - shift).round();
        [near - 1.0, near, near + 1.0].into_iter().any(|j| {
            let d = off(j);
            -0.5 * thick <= d && d < 0.5 * thick
        })
    }
}
