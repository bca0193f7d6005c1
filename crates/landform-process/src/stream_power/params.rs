//! Parameters of stream power.

use landform_core::algo::flow::Descent;
use landform_core::units::{
    Angle, Erodibility, ErodibilityDimension, LengthDimension, Rate, RateDimension, RatioDimension,
};
use landform_core::verb::{Changing, Environment, Estimate, Outlets, Params, Source, Varying};
use landform_core::{Error, Result, math};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::law::Law;
use super::talus;
use crate::mechanism::Lattice;

/// Slope that ground approaches and does not exceed, where none is given.
const USUAL_LIMITING_SLOPE: f64 = 0.9;
/// Least drainage area where slopes have a limit, m².
const LEAST_AREA: f64 = 5_000.0;

/// Stream-power erosion: rivers cut their beds and may deposit sediment, dz/dt = -k A^m S^n + G
/// Q/A. Lakes spill over their lowest pass; the sea may rise and fall.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct StreamPower {
    /// Erodibility k of the rock; may vary in space or change in time. Its true unit is m^(1-2m)/yr
    /// (for slope exponent 1): it is written 1/yr with lengths in metres, and a bare number is read
    /// the same way. If not given, each material of layered ground has its own erodibility, and
    /// other ground has 2e-6 1/yr. Loose layers always have their own.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e3))]
    pub erodibility: Option<Varying<ErodibilityDimension>>,
    /// How many times as fast rock wears; may vary in space, as along joints: { field = "joints" }
    /// of `layered_ground`. Loose layers wear as they do. If not given, it is 1.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e3))]
    pub weakness: Option<Varying<RatioDimension>>,
    /// Area exponent m; m/n is the concavity of river profiles.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub area_exponent: f64,
    /// Slope exponent n.
    #[schemars(extend("x-min" = 0.5, "x-max" = 4.0))]
    pub slope_exponent: f64,
    /// Steepest slope that ground can stand at: what is steeper falls at once, and makes planes of
    /// this angle. If not given, there is none, but where `limiting_slope` is 0 each material of
    /// layered ground stands at its own angle of repose.
    #[schemars(extend("x-above" = 0.0, "x-max" = 85.0))]
    pub talus_angle: Option<Angle>,
    /// Slope S_d that ground approaches and does not exceed: erosion is k A^m S^n/(1 - S/S_d), so
    /// that the steep heads of valleys are gullies rather than planes of one angle. With 0 there is
    /// no such slope. If not given, there is none where a talus angle is given; each material of
    /// layered ground has its own; other ground has 0.9. With it A is at least 5,000 m2, so that
    /// slopes do not grow as cells shrink.
    #[schemars(extend("x-min" = 0.0, "x-max" = 20.0))]
    pub limiting_slope: Option<f64>,
    /// How rivers are worn in a step: "implicit", or "sharp", which keeps knickpoints.
    pub scheme: Scheme,
    /// Where the nodes of a raster stand while rivers run. On meshes it has no effect.
    pub lattice: Lattice,
    /// Speed at which slopes above the talus angle are lowered, per unit of slope in excess. If not
    /// given, they are lowered at once.
    #[schemars(extend("x-above" = 0.0))]
    pub talus_relaxation: Option<Rate>,
    /// Deposition coefficient G of Yuan et al.: sediment is deposited as G times the flux over the
    /// drainage area. With 0 rivers carry everything away; rivers on sediment have about 0.2 to 2.
    #[schemars(extend("x-min" = 0.0, "x-max" = 100.0))]
    pub deposition: f64,
    /// Rainfall; may vary in space or change in time. Drainage area is weighted by rainfall over 1
    /// m/yr, so a wetter land is worn more; the discharge of rivers follows from it. If not given,
    /// it is the environment's rainfall, or else 1 m/yr.
    #[schemars(extend("x-min" = 0.0))]
    pub rainfall: Option<Varying<RateDimension>>,
    /// Where water leaves, at a base level that is held from now on: "border", "valleys" (the low
    /// points of the border), "sea" (every node at or under `sea_level`, as the sea rises and
    /// falls), a list of sides such as ["south"], parts of the border by a map ({ border_where =
    /// map, below = 0.33 }), or any nodes by a map ({ mask = map }). If not given, the outlets of
    /// the landscape are used.
    pub outlets: Option<Outlets>,
    /// Sea level; may change in time: { times = ["0 yr", "1 Myr"], values = ["0 m", "-100 m"] }, or
    /// { mean = "0 m", amplitude = "60 m", period = "100 kyr" }. With outlets "sea" rivers end at
    /// it; with other outlets base levels rise and fall with it. If not given, it is the
    /// environment's sea level, or else 0 m.
    pub sea_level: Option<Changing<LengthDimension>>,
    /// Value that A^m S^n must exceed before rivers cut: k max(0, A^m S^n - threshold), in m^(2m).
    /// Together with creep it keeps hillslopes smooth and valleys apart.
    #[schemars(extend("x-min" = 0.0))]
    pub threshold: f64,
    /// Whether A is the drainage area per width of a cell (m), as for sheet flow, rather than the
    /// area (m2). With `multiple_flow` the spacing of valleys then does not depend on the size of
    /// cells.
    pub specific_area: bool,
    /// Which lower neighbour receives a node's water.
    pub descent: Descent,
    /// Power of slope (Freeman: 1.1) by which drainage area is shared among all lower neighbours.
    /// If not given, all of it goes to one receiver.
    #[schemars(extend("x-min" = 0.0, "x-max" = 20.0))]
    pub multiple_flow: Option<f64>,
}

/// How rivers are worn in a step.
///
/// ```
/// use landform_process::stream_power::{Scheme, StreamPower};
///
/// assert_eq!(StreamPower::default().scheme, Scheme::Implicit);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Scheme {
    /// By the implicit law: stable for any step, for all exponents; knickpoints are smeared.
    #[default]
    Implicit,
    /// Along characteristics: knickpoints stay sharp. For slope exponent 1, without deposition,
    /// threshold, limiting slope and layers.
    Sharp,
}

impl Default for StreamPower {
    fn default() -> Self {
        Self {
            erodibility: None,
            weakness: None,
            area_exponent: 0.5,
            slope_exponent: 1.0,
            talus_angle: None,
            limiting_slope: None,
            scheme: Scheme::Implicit,
            lattice: Lattice::Jittered,
            talus_relaxation: None,
            deposition: 0.0,
            rainfall: None,
            outlets: None,
            sea_level: None,
            threshold: 0.0,
            specific_area: false,
            descent: Descent::Steepest,
            multiple_flow: None,
        }
    }
}

impl Params for StreamPower {
    const NAME: &'static str = "stream_power";
    const IN_TIME: &'static [&'static str] = &["erodibility", "rainfall"];
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
        Source {
            authors: "Bell (2024)",
            title: "Generating Terrain Models using the Stream Power Law, dissertation, University of Bath",
            doi: "",
        },
        Source {
            authors: "Yuan et al. (2019)",
            title: "A new efficient method to solve the stream power law model taking into account sediment deposition, JGR Earth Surface 124",
            doi: "10.1029/2018JF004867",
        },
        Source {
            authors: "Campforts & Govers (2015)",
            title: "Keeping the edge: A numerical method that avoids knickpoint smearing when solving the stream power law, JGR Earth Surface 120",
            doi: "10.1002/2014JF003376",
        },
        Source {
            authors: "Freeman (1991)",
            title: "Calculating catchment area with divergent flow based on a regular grid, Computers & Geosciences 17(3)",
            doi: "10.1016/0098-3004(91)90048-I",
        },
        Source {
            authors: "Perron, Dietrich & Kirchner (2008)",
            title: "Controls on the spacing of first-order valleys, JGR Earth Surface 113",
            doi: "10.1029/2007JF000977",
        },
        Source {
            authors: "Stock & Dietrich (2003)",
            title: "Valley incision by debris flows: Evidence of a topographic signature, Water Resources Research 39(4)",
            doi: "10.1029/2001WR001057",
        },
        Source {
            authors: "McGuire et al. (2023)",
            title: "Steady-state forms of channel profiles shaped by debris flow and fluvial processes, Earth Surface Dynamics 11",
            doi: "10.5194/esurf-11-1117-2023",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(if self.is_sharp() { 250 } else { 205 })
    }

    fn jitters(&self) -> bool {
        self.lattice == Lattice::Jittered
    }

    fn warning(&self, before: &Estimate, raised: f64) -> Option<String> {
        let erodibility = match &self.erodibility {
            Some(Varying::Uniform(k)) => k.si(),
            Some(_) => return None,
            None => Self::usual_erodibility().si(),
        };
        let (area_exponent, slope_exponent) = (self.area_exponent, self.slope_exponent);
        let law = talus::Uniform { angle: self.talus_angle?, erodibility, area_exponent, slope_exponent };
        talus::warning(&law, before, raised)
    }

    fn check(&self) -> Result<()> {
        if self.talus_relaxation.is_some() && self.talus_angle.is_none() {
            return Err(Error::Incomplete { name: "talus_relaxation".into(), needs: "talus_angle" });
        }
        if self.threshold > 0.0 && self.deposition > 0.0 {
            return Err(Error::parameter(
                "threshold",
                self.threshold,
                "0 with `deposition`: the two are not solved together",
            ));
        }
        self.check_sharp()?;
        self.outlets.as_ref().map_or(Ok(()), Outlets::check)
    }
}

impl StreamPower {
    /// Refuses what the sharp scheme does not solve.
    fn check_sharp(&self) -> Result<()> {
        let limit = self.limiting_slope.unwrap_or(0.0);
        let given = [
            ("slope_exponent", self.slope_exponent, 1.0),
            ("deposition", self.deposition, 0.0),
            ("threshold", self.threshold, 0.0),
            ("limiting_slope", limit, 0.0),
        ];
        match given.into_iter().find(|(_, value, needed)| self.is_sharp() && value != needed) {
            Some((name, value, needed)) => {
                Err(Error::parameter(name, value, &format!("{needed} with scheme = \"sharp\"")))
            }
            None => Ok(()),
        }
    }

    /// Whether steps follow characteristics.
    pub(super) fn is_sharp(&self) -> bool {
        self.scheme == Scheme::Sharp
    }

    /// The law of a step, with the sea at `sea_level`.
    pub(super) fn law(&self, sea_level: f64, dt: f64, layered: bool) -> Law {
        let (limiting_slope, limits_by_material) = match (self.limiting_slope, self.talus_angle) {
            (Some(slope), _) if slope > 0.0 => (slope, false),
            (Some(_), _) | (None, Some(_)) => (f64::INFINITY, false),
            (None, None) if self.is_sharp() => (f64::INFINITY, false),
            (None, None) if layered => (f64::INFINITY, true),
            (None, None) => (USUAL_LIMITING_SLOPE, false),
        };
        let law = Law {
            area_exponent: self.area_exponent,
            slope_exponent: self.slope_exponent,
            greatest_slope: self.talus_angle.map_or(f64::INFINITY, |a| math::tan(a.si())),
            relaxation: self.talus_relaxation.map_or(f64::INFINITY, |speed| speed.si() * dt),
            limiting_slope,
            limits_by_material,
            least_area: 0.0,
            sea_level,
            deposition: self.deposition,
            threshold: self.threshold,
            dt,
        };
        Law { least_area: if law.has_limit() { LEAST_AREA } else { 0.0 }, ..law }
    }

    /// Sea level at a time, if there is a sea.
    pub(super) fn sea_at(&self, time: f64, environment: &Environment) -> Option<f64> {
        let level = self.sea_level.as_ref().or(environment.sea_level.as_ref()).map(|s| s.at(time));
        level.or(self.ends_in_sea().then_some(0.0))
    }

    /// Erodibility where none is given, m^(1-2m)/s.
    pub(super) fn usual_erodibility() -> Erodibility {
        Erodibility::of(2e-6)
    }

    /// Whether rivers end wherever they meet the sea.
    pub(super) fn ends_in_sea(&self) -> bool {
        self.outlets.as_ref().is_some_and(Outlets::is_sea)
    }
}
