//! Kinds of rock: beds drawn by laws, and folds.
//!
//! # Model
//! Thicknesses are exponential, erodibilities and limiting slopes log-normal: ln K = ln K₀ + σ g,
//! ln S_d = ln S₀ − s (ρ g + √(1 − ρ²) h) with standard normal g, h and ρ = 0.8, so that a bed that
//! wears slowly mostly stands steeply too. A fold raises the beds by a sin(2π s/λ + 2π w n), where
//! s runs across the axis and n is noise of three wavelengths that bends it.
//!
//! # Sources
//! Exponential thicknesses: Drummond & Wilkinson (1996), Journal of Geology 104(6). The spread of
//! erodibilities is our own choice, within that of Stock & Montgomery (1999), GSA Bulletin 111(8).

use std::f64::consts::TAU;

use landform_core::algo::noise::gradient_noise;
use landform_core::math;
use landform_core::random::Seed;
use landform_core::terrain::{Bed, Material, Materials};
use landform_core::units::{Angle, Erodibility, Length};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How strongly limiting slope goes with strength.
const TOGETHER: f64 = 0.8;
/// Limiting slopes are held within these.
const SLOPES: [f64; 2] = [0.15, 5.0];
/// A bed is at least so thick, m.
const THINNEST: f64 = 0.1;

/// A kind of rock: beds, dip and folds together.
///
/// ```
/// use landform_process::generate::{LayeredGround, RockKind};
///
/// let ground: LayeredGround = serde_json::from_str(r#"{ "rock": "folded" }"#).unwrap();
/// assert_eq!(ground.rock, Some(RockKind::Folded));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RockKind {
    /// Thick beds that hardly differ, almost level.
    Massive,
    /// Beds of very different strength in folds.
    Folded,
    /// Level beds of very different strength.
    Tableland,
    /// Beds of very different strength that dip to one side.
    Cuesta,
    /// Many thin flows of hard lava with weaker ash between, almost level.
    Volcanic,
}

/// The laws that beds are drawn by. What is not given is that of the kind of rock, or of a
/// tableland.
///
/// ```
/// use landform_process::generate::SequenceParams;
///
/// let sequence: SequenceParams = serde_json::from_str(r#"{ "thickness": "30 m" }"#).unwrap();
/// assert!(sequence.beds.is_none());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SequenceParams {
    /// Number of beds; below them the sequence repeats.
    #[schemars(extend("x-min" = 1, "x-max" = 200))]
    pub beds: Option<u32>,
    /// Mean thickness across the beds; exponential.
    #[schemars(extend("x-above" = 0.0))]
    pub thickness: Option<Length>,
    /// Median of the erodibility; log-normal.
    #[schemars(extend("x-above" = 0.0))]
    pub erodibility: Option<Erodibility>,
    /// Standard deviation of the logarithm of the erodibility, a number: with 1, two beds of three
    /// lie within a factor of 2.7 of the median.
    #[schemars(extend("x-min" = 0.0, "x-max" = 5.0))]
    pub erodibility_spread: Option<f64>,
    /// Median of the limiting slope, rise over run; log-normal.
    #[schemars(extend("x-above" = 0.0, "x-max" = 5.0))]
    pub limiting_slope: Option<f64>,
    /// Standard deviation of the logarithm of the limiting slope.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub limiting_slope_spread: Option<f64>,
}

/// Folds of the beds.
///
/// ```
/// use landform_process::generate::FoldParams;
///
/// assert_eq!(FoldParams::default().waviness, 0.2);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct FoldParams {
    /// Distance from crest to crest.
    #[schemars(extend("x-above" = 0.0))]
    pub wavelength: Length,
    /// Height of a crest above the beds' mean; a trough lies as far below.
    #[schemars(extend("x-min" = 0.0))]
    pub amplitude: Length,
    /// Compass direction of the axes, along which beds do not rise.
    pub axis: Angle,
    /// Number of wavelengths by which noise bends the axes to either side; with 0 they are
    /// straight.
    #[schemars(extend("x-min" = 0.0, "x-max" = 2.0))]
    pub waviness: f64,
}

impl Default for FoldParams {
    fn default() -> Self {
        Self { wavelength: Length::of(5_000.0), amplitude: Length::of(400.0), axis: Angle::of(20.0), waviness: 0.2 }
    }
}

impl FoldParams {
    /// How far the beds are raised at a place, m.
    pub(super) fn rise(&self, seed: Seed, [x, y]: [f64; 2]) -> f64 {
        let (axis, wavelength) = (self.axis.si(), self.wavelength.si());
        let across = x * math::cos(axis) - y * math::sin(axis);
        let bend = if self.waviness > 0.0 {
            self.waviness * gradient_noise(seed.named("folds"), x / (3.0 * wavelength), y / (3.0 * wavelength))
        } else {
            0.0
        };
        self.amplitude.si() * math::sin(TAU * (across / wavelength + bend))
    }
}

/// What a kind of rock is made of.
pub(super) struct Kind {
    beds: u32,
    thickness: f64,
    /// 1/yr.
    erodibility: f64,
    erodibility_spread: f64,
    limiting_slope: f64,
    limiting_slope_spread: f64,
    /// Dip and its direction, degrees.
    pub(super) dip: [f64; 2],
    pub(super) folds: Option<FoldParams>,
}

impl RockKind {
    pub(super) fn kind(self) -> Kind {
        let kind =
            |beds, thickness, [erodibility, erodibility_spread]: [f64; 2], [limit, spread]: [f64; 2], dip| Kind {
                beds,
                thickness,
                erodibility,
                erodibility_spread,
                limiting_slope: limit,
                limiting_slope_spread: spread,
                dip,
                folds: None,
            };
        match self {
            Self::Massive => kind(8, 250.0, [4e-6, 0.2], [1.0, 0.1], [1.0, 120.0]),
            Self::Folded => {
                Kind { folds: Some(FoldParams::default()), ..kind(16, 110.0, [1e-5, 0.8], [0.9, 0.3], [3.0, 110.0]) }
            }
            Self::Tableland => kind(12, 60.0, [6e-6, 1.0], [0.9, 0.35], [0.3, 160.0]),
            Self::Cuesta => kind(14, 90.0, [8e-6, 1.0], [0.9, 0.35], [6.0, 120.0]),
            Self::Volcanic => kind(40, 18.0, [3e-6, 0.9], [1.2, 0.35], [1.0, 200.0]),
        }
    }
}

/// Beds drawn by laws, with a material for each after those of the table.
///
/// # Errors
/// [`Error::Parameter`] where the materials would be more than 255.
pub(super) fn draw(
    rock: Option<RockKind>,
    laws: &SequenceParams,
    materials: &Materials,
    seed: Seed,
) -> Result<(Materials, Vec<Bed>)> {
    let kind = rock.unwrap_or(RockKind::Tableland).kind();
    let thickness = laws.thickness.map_or(kind.thickness, Length::si);
    let erodibility = laws.erodibility.map_or(Erodibility::of(kind.erodibility).si(), Erodibility::si);
    let spread = laws.erodibility_spread.unwrap_or(kind.erodibility_spread);
    let limit = laws.limiting_slope.unwrap_or(kind.limiting_slope);
    let limit_spread = laws.limiting_slope_spread.unwrap_or(kind.limiting_slope_spread);
    let number = laws.beds.unwrap_or(kind.beds) as usize;
    let first = materials.all().len();
    if first + number > usize::from(u8::MAX) {
        let value = number.to_string();
        return Err(Error::parameter("sequence.beds", value, &format!("at most {}", usize::from(u8::MAX) - first)));
    }
    let (thick, strong) = (seed.named("thickness"), seed.named("strength"));
    let (mut drawn, mut beds) = (Vec::new(), Vec::new());
    for k in 0..number {
        let (g, h) = strong.normal_pair(k as u64);
        let apart = (1.0 - TOGETHER * TOGETHER).sqrt();
        let slope = limit * math::exp(-limit_spread * (TOGETHER * g + apart * h));
        let slope = slope.clamp(SLOPES[0], SLOPES[1]);
        let mut material: Material = materials.get(0).clone();
        material.name = format!("bed {}", k + 1);
        material.erodibility = erodibility * math::exp(spread * g);
        (material.limiting_slope, material.repose) = (slope, math::atan(slope));
        drawn.push(material);
        // 1 − u lies in (0, 1].
        let thickness = (-thickness * math::log(1.0 - thick.uniform(k as u64))).max(THINNEST);
        beds.push(Bed { material: (first + k) as u8, thickness });
    }
    Ok((materials.and(drawn)?, beds))
}
