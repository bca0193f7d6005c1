//! Winds in recipes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::random::Seed;
use crate::units::Angle;
use crate::{Error, Result, math};

/// A wind of a rose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wind {
    /// Compass direction that it comes from: 270 deg is a west wind.
    pub from: Angle,
    /// Fraction of the time that it blows, relative to the other winds.
    #[serde(default = "one")]
    #[schemars(extend("x-min" = 0.0))]
    pub weight: f64,
}

fn one() -> f64 {
    1.0
}

impl Wind {
    /// A wind from a compass direction, degrees.
    pub fn from(degrees: f64, weight: f64) -> Self {
        Self { from: Angle::of(degrees), weight }
    }

    /// Unit vector that it blows along, x east and y north. Winds along rows, columns and diagonals
    /// are exactly that.
    pub fn towards(self) -> [f64; 2] {
        let angle = self.from.si();
        let clean = |v: f64| if v.abs() < 1e-12 { 0.0 } else { v };
        [clean(-math::sin(angle)), clean(-math::cos(angle))]
    }
}

/// Several winds that take turns.
///
/// Winds from opposite directions cancel in the mean:
///
/// ```
/// use landform_core::verb::{Rose, Wind};
///
/// let rose = Rose::new("wind", &[Wind::from(270.0, 1.0), Wind::from(90.0, 1.0)])?;
/// assert_eq!(rose.winds()[0].towards(), [1.0, 0.0]);
/// assert!(rose.steadiness() < 1e-12);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Rose {
    winds: Vec<Wind>,
    total: f64,
}

impl Rose {
    /// A rose; `name` is the parameter's name.
    ///
    /// # Errors
    /// [`Error::Parameter`] if there is no wind, or no weight.
    pub fn new(name: &str, winds: &[Wind]) -> Result<Self> {
        let total: f64 = winds.iter().map(|w| w.weight).sum();
        if winds.iter().any(|w| !(w.weight >= 0.0 && w.weight.is_finite() && w.from.si().is_finite())) || !(total > 0.0)
        {
            let what = if winds.is_empty() { "no wind" } else { "weights that are negative or all 0" };
            return Err(Error::parameter(name, what, "a list such as [ { from = \"270 deg\", weight = 1 } ]"));
        }
        Ok(Self { winds: winds.to_vec(), total })
    }

    /// The winds.
    pub fn winds(&self) -> &[Wind] {
        &self.winds
    }

    /// Which wind blows at a turn: drawn by weight.
    pub fn draw(&self, seed: Seed, turn: u64) -> usize {
        let mut left = seed.uniform(turn) * self.total;
        for (k, wind) in self.winds.iter().enumerate() {
            left -= wind.weight;
            if left < 0.0 {
                return k;
            }
        }
        self.winds.len() - 1
    }

    /// Mean vector of all winds by weight: its direction is where sand goes, its length (RDP/DP)
    /// how steady the regime is, 0 to 1.
    pub fn resultant(&self) -> [f64; 2] {
        self.winds.iter().fold([0.0; 2], |[x, y], w| {
            let [dx, dy] = w.towards();
            [x + dx * w.weight / self.total, y + dy * w.weight / self.total]
        })
    }

    /// RDP/DP: the length of [`Rose::resultant`].
    pub fn steadiness(&self) -> f64 {
        let [x, y] = self.resultant();
        (x * x + y * y).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_west_wind_blows_east_and_winds_share_their_time() {
        assert_eq!(Wind::from(270.0, 1.0).towards(), [1.0, 0.0]);
        assert_eq!(Wind::from(0.0, 1.0).towards(), [0.0, -1.0]);
        let rose = Rose::new("wind", &[Wind::from(270.0, 3.0), Wind::from(180.0, 1.0)]).unwrap();
        let west = (0..10_000).filter(|&t| rose.draw(Seed(1), t) == 0).count();
        assert!((7_300..7_700).contains(&west), "{west}");
        assert!((rose.steadiness() - 0.625f64.sqrt()).abs() < 1e-12);
        assert!(Rose::new("wind", &[]).is_err() && Rose::new("wind", &[Wind::from(0.0, 0.0)]).is_err());
    }
}
