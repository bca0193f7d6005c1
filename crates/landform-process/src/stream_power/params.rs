//! The words of stream power.

use landform_core::algo::outlets::Outlets;
use landform_core::units::{Angle, Erodibility, ErodibilityDimension, RateDimension};
use landform_core::verb::{Params, Source, Varying};
use landform_core::{Error, Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Rivers that cut their beds: dz/dt = -k A^m S^n, with lakes that spill over their lowest pass.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct StreamPower {
    /// Erodibility k of the rock; may vary in space. Its true unit is m^(1-2m)/yr (for slope exponent 1): it is written
    /// 1/yr with lengths in metres, and a bare number is read the same way.
    #[schemars(extend("x-min" = 0.0))]
    pub erodibility: Varying<ErodibilityDimension>,
    /// Area exponent m; m/n is the concavity of river profiles.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub area_exponent: f64,
    /// Slope exponent n.
    #[schemars(extend("x-min" = 0.5, "x-max" = 4.0))]
    pub slope_exponent: f64,
    /// Steepest slope that ground can stand at; none if not given.
    #[schemars(extend("x-above" = 0.0, "x-max" = 85.0))]
    pub talus_angle: Option<Angle>,
    /// Rainfall; only its pattern matters, since area is weighted by rainfall over its mean. Uniform if not given.
    #[schemars(extend("x-min" = 0.0))]
    pub rainfall: Option<Varying<RateDimension>>,
    /// Where water leaves, at a base level that is held from now on: "border", "valleys" (the low points of the border), or
    /// a list of sides such as ["south"]. As the landscape has it, if not given.
    pub outlets: Option<Outlets>,
}

impl Default for StreamPower {
    fn default() -> Self {
        Self {
            erodibility: Erodibility::of(2e-6).into(),
            area_exponent: 0.5,
            slope_exponent: 1.0,
            talus_angle: None,
            rainfall: None,
            outlets: None,
        }
    }
}

impl Params for StreamPower {
    const NAME: &'static str = "stream_power";
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Braun & Willett (2013)",
            title: "A very efficient O(n), implicit and parallel method to solve the stream power equation, Geomorphology 180-181",
            doi: "10.1016/j.geomorph.2012.10.008",
        },
        Source {
            authors: "Cordonnier, Bovy & Braun (2019)",
            title: "A versatile, linear complexity algorithm for flow routing in topographies with depressions, Earth Surface Dynamics 7",
            doi: "10.5194/esurf-7-549-2019",
        },
        Source {
            authors: "Cordonnier et al. (2016)",
            title: "Large scale terrain generation from tectonic uplift and fluvial erosion, Computer Graphics Forum 35(2)",
            doi: "10.1111/cgf.12820",
        },
    ];

    fn check(&self) -> Result<()> {
        match &self.outlets {
            Some(Outlets::Sides(sides)) if sides.is_empty() => {
                Err(Error::parameter("outlets", "[]", "at least one side, for example [\"south\"]"))
            }
            _ => Ok(()),
        }
    }
}

impl StreamPower {
    /// Tangent of the talus angle; infinite without one.
    pub(super) fn greatest_slope(&self) -> f64 {
        self.talus_angle.map_or(f64::INFINITY, |a| math::tan(a.si()))
    }
}
