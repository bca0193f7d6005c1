//! The environment of a landscape, set once for all stages.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Changing, Rose, Varying, Wind};
use crate::Result;
use crate::terrain::Materials;
use crate::units::{Length, LengthDimension, Rate, RateDimension};

/// Sea level, rain, winds and temperature of a landscape, for every stage that has no values of its
/// own.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Environment {
    /// Sea level; may change in time: { times = ["0 yr", "1 Myr"], values = ["0 m", "-100 m"] }, or
    /// { mean = "0 m", amplitude = "60 m", period = "100 kyr" }. If not given, it is 0 m.
    pub sea_level: Option<Changing<LengthDimension>>,
    /// Rainfall; may vary in space.
    #[schemars(extend("x-min" = 0.0))]
    pub rainfall: Option<Varying<RateDimension>>,
    /// Winds, and the fraction of the time that each blows.
    pub wind: Vec<Wind>,
    /// Mean temperature at 0 m, degrees Celsius.
    #[schemars(extend("x-min" = -80.0, "x-max" = 60.0))]
    pub temperature: Option<f64>,
    /// Fall of temperature with height, degrees Celsius a kilometre.
    #[schemars(extend("x-above" = 0.0, "x-max" = 20.0))]
    pub lapse_rate: f64,
    /// Materials of the ground.
    #[serde(skip)]
    #[schemars(skip)]
    pub materials: Materials,
}

impl Default for Environment {
    fn default() -> Self {
        Self {
            sea_level: None,
            rainfall: None,
            wind: Vec::new(),
            temperature: None,
            lapse_rate: 6.5,
            materials: Materials::default(),
        }
    }
}

impl Environment {
    /// Sea level at a time (s) since the start of a run, m.
    ///
    /// ```
    /// use landform_core::units::{Duration, Length, MYR};
    /// use landform_core::verb::{Changing, Environment};
    ///
    /// let falling = Changing::Linear {
    ///     times: vec![Duration::of(0.0), Duration::of(1e6)],
    ///     values: vec![Length::of(0.0), Length::of(-100.0)],
    /// };
    /// let environment = Environment { sea_level: Some(falling), ..Environment::default() };
    /// assert!((environment.sea_level_at(0.5 * MYR) + 50.0).abs() < 1e-9);
    /// ```
    pub fn sea_level_at(&self, time: f64) -> f64 {
        self.sea_level.as_ref().map_or(0.0, |level| level.at(time))
    }

    /// A stage's own level of the sea, else that at a time (s) since the start of a run, m.
    pub fn level_or(&self, own: Option<Length>, time: f64) -> f64 {
        own.map_or_else(|| self.sea_level_at(time), Length::si)
    }

    /// A stage's own sea level, else that of the environment at the start, m; none where neither is
    /// given.
    pub fn sea(&self, own: Option<Length>) -> Option<f64> {
        own.map(Length::si).or(self.sea_level.as_ref().map(|level| level.at(0.0)))
    }

    /// The rainfall, where it is the same everywhere.
    pub fn uniform_rain(&self) -> Option<Rate> {
        match self.rainfall {
            Some(Varying::Uniform(rain)) => Some(rain),
            _ => None,
        }
    }

    /// Elevation at which the mean temperature is 0 degrees Celsius, m, if the temperature is
    /// known.
    pub fn freezing_level(&self) -> Option<f64> {
        self.temperature.map(|t| 1000.0 * t / self.lapse_rate)
    }

    /// The winds of a stage: its own, else those of the environment, else a west wind.
    ///
    /// # Errors
    /// Where [`Rose::new`] fails.
    pub fn rose(&self, own: &[Wind]) -> Result<Rose> {
        let west = [Wind::from(270.0, 1.0)];
        let winds = [own, &self.wind, &west].into_iter().find(|w| !w.is_empty()).unwrap_or(&west);
        Rose::new("wind", winds)
    }

    /// Checks that ranges cannot express.
    ///
    /// # Errors
    /// [`crate::Error::Parameter`] for winds without any weight.
    pub fn check(&self) -> Result<()> {
        if self.wind.is_empty() {
            return Ok(());
        }
        Rose::new("wind", &self.wind).map(drop)
    }
}
