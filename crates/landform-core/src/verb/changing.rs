//! Values that may change in time: one quantity, a list of times and values, or a cycle.

use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::math;
use crate::units::{Dimension, Duration, Quantity};

/// A quantity that is constant or changes in time.
#[derive(Clone, Debug, PartialEq)]
pub enum Changing<D: Dimension> {
    /// Always the same.
    Constant(Quantity<D>),
    /// Linear between times, the first value before them, the last one after.
    Linear {
        /// Times since the start of the run, growing.
        times: Vec<Duration>,
        /// Value at each time.
        values: Vec<Quantity<D>>,
    },
    /// A sine: `mean` at the start, rising first.
    Cycle {
        /// Value about which it swings.
        mean: Quantity<D>,
        /// Greatest distance from the mean.
        amplitude: Quantity<D>,
        /// Time of a full swing.
        period: Duration,
    },
}

impl<D: Dimension> From<Quantity<D>> for Changing<D> {
    fn from(quantity: Quantity<D>) -> Self {
        Self::Constant(quantity)
    }
}

impl<D: Dimension> Changing<D> {
    /// The value at a time (s) since the start of the run, SI.
    pub fn at(&self, time: f64) -> f64 {
        match self {
            Self::Constant(q) => q.si(),
            Self::Linear { times, values } => {
                let after = times.iter().position(|t| t.si() > time).unwrap_or(times.len());
                match (after.checked_sub(1), after) {
                    (None, _) => values[0].si(),
                    (Some(k), next) if next == times.len() => values[k].si(),
                    (Some(k), next) => {
                        let part = (time - times[k].si()) / (times[next].si() - times[k].si());
                        math::lerp(values[k].si(), values[next].si(), part)
                    }
                }
            }
            Self::Cycle { mean, amplitude, period } => {
                mean.si() + amplitude.si() * math::sin(std::f64::consts::TAU * time / period.si())
            }
        }
    }
}

impl<D: Dimension> Changing<D> {
    /// The greatest value of its course, SI; none without a value.
    ///
    /// ```
    /// use landform_core::units::Rate;
    /// use landform_core::verb::Changing;
    ///
    /// assert_eq!(Changing::from(Rate::of(2.0)).greatest(), Some(Rate::of(2.0).si()));
    /// ```
    pub fn greatest(&self) -> Option<f64> {
        match self {
            Self::Constant(q) => Some(q.si()),
            Self::Linear { values, .. } => values.iter().map(|q| q.si()).reduce(f64::max),
            Self::Cycle { mean, amplitude, .. } => Some(mean.si() + amplitude.si().abs()),
        }
    }

    /// The mean value from one time (s) to a later one, SI: exact for lines, by Simpson's rule in
    /// sixteen parts for cycles.
    pub fn mean(&self, from: f64, to: f64) -> f64 {
        if !(to > from) {
            return self.at(from);
        }
        match self {
            Self::Constant(q) => q.si(),
            Self::Linear { times, .. } => {
                let inside = times.iter().map(|t| t.si()).filter(|t| *t > from && *t < to);
                let knots: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
                let area = |w: &[f64]| 0.5 * (self.at(w[0]) + self.at(w[1])) * (w[1] - w[0]);
                knots.windows(2).map(area).sum::<f64>() / (to - from)
            }
            Self::Cycle { .. } => {
                let weight = |k: i32| if k == 0 || k == 32 { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
                let at = |k: i32| weight(k) * self.at(from + (to - from) * f64::from(k) / 32.0);
                (0..=32).map(at).sum::<f64>() / 96.0
            }
        }
    }
}

impl<D: Dimension> Serialize for Changing<D> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = match self {
            Self::Constant(q) => return q.serialize(serializer),
            _ => serializer.serialize_map(None)?,
        };
        match self {
            Self::Constant(_) => {}
            Self::Linear { times, values } => {
                map.serialize_entry("times", times)?;
                map.serialize_entry("values", values)?;
            }
            Self::Cycle { mean, amplitude, period } => {
                map.serialize_entry("mean", mean)?;
                map.serialize_entry("amplitude", amplitude)?;
                map.serialize_entry("period", period)?;
            }
        }
        map.end()
    }
}

impl<'de, D: Dimension> Deserialize<'de> for Changing<D> {
    fn deserialize<De: Deserializer<'de>>(deserializer: De) -> Result<Self, De::Error> {
        deserializer.deserialize_any(ChangingVisitor(PhantomData))
    }
}

struct ChangingVisitor<D>(PhantomData<D>);

const KEYS: &[&str] = &["times", "values", "mean", "amplitude", "period"];

impl<'de, D: Dimension> Visitor<'de> for ChangingVisitor<D> {
    type Value = Changing<D>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "a {} such as \"{}\", or a table with `times` and `values`, or with `mean`, `amplitude` and `period`",
            D::NAME,
            D::EXAMPLE
        )
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Changing<D>, E> {
        Quantity::parse(text).map(Changing::Constant).map_err(E::custom)
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Changing<D>, E> {
        Quantity::deserialize(de::value::F64Deserializer::new(value)).map(Changing::Constant)
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Changing<D>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Changing<D>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Changing<D>, A::Error> {
        let mut course = Course::default();
        while let Some(key) = map.next_key::<String>()? {
            if !course.take(&key, &mut map)? {
                return Err(de::Error::unknown_field(&key, KEYS));
            }
        }
        course.build().map_err(de::Error::custom)
    }
}

/// The parts of a table that gives a course in time, as they are read.
pub(super) struct Course<D: Dimension> {
    times: Option<Vec<Duration>>,
    values: Option<Vec<Quantity<D>>>,
    mean: Option<Quantity<D>>,
    amplitude: Option<Quantity<D>>,
    period: Option<Duration>,
}

impl<D: Dimension> Default for Course<D> {
    fn default() -> Self {
        Self { times: None, values: None, mean: None, amplitude: None, period: None }
    }
}

impl<D: Dimension> Course<D> {
    /// Reads the value of a key, if the key is of a course.
    pub(super) fn take<'de, A: MapAccess<'de>>(&mut self, key: &str, map: &mut A) -> Result<bool, A::Error> {
        match key {
            "times" => self.times = Some(map.next_value()?),
            "values" => self.values = Some(map.next_value()?),
            "mean" => self.mean = Some(map.next_value()?),
            "amplitude" => self.amplitude = Some(map.next_value()?),
            "period" => self.period = Some(map.next_value()?),
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Whether nothing was read.
    pub(super) fn is_empty(&self) -> bool {
        self.times.is_none()
            && self.values.is_none()
            && self.mean.is_none()
            && self.amplitude.is_none()
            && self.period.is_none()
    }

    pub(super) fn build(self) -> Result<Changing<D>, String> {
        match (self.times, self.values, self.mean, self.amplitude, self.period) {
            (Some(times), Some(values), None, None, None) => linear(times, values),
            (None, None, Some(mean), Some(amplitude), Some(period)) => cycle(mean, amplitude, period),
            _ => Err("expected `times` and `values`, or `mean`, `amplitude` and `period`".into()),
        }
    }
}

fn linear<D: Dimension>(times: Vec<Duration>, values: Vec<Quantity<D>>) -> Result<Changing<D>, String> {
    if times.is_empty() || times.len() != values.len() {
        return Err(format!(
            "{} `times` and {} `values`; expected as many of each, at least one",
            times.len(),
            values.len()
        ));
    }
    if times.windows(2).any(|w| w[1].si() <= w[0].si()) {
        return Err("`times` must grow".into());
    }
    Ok(Changing::Linear { times, values })
}

fn cycle<D: Dimension>(mean: Quantity<D>, amplitude: Quantity<D>, period: Duration) -> Result<Changing<D>, String> {
    if !(period.si() > 0.0) {
        return Err("`period` must be > 0".into());
    }
    Ok(Changing::Cycle { mean, amplitude, period })
}

impl<D: Dimension> JsonSchema for Changing<D> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        format!("changing {}", D::NAME).into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let value = Quantity::<D>::json_schema(generator);
        let [lines, cycle] = course_schemas::<D>(generator);
        json_schema!({
            "anyOf": [value, lines, cycle],
            "x-unit": D::UNIT, "x-dimension": D::NAME, "x-example": D::EXAMPLE, "x-changing": true
        })
    }
}

/// The schemas of the tables that give a course in time.
pub(super) fn course_schemas<D: Dimension>(generator: &mut SchemaGenerator) -> [Schema; 2] {
    let (value, time) = (Quantity::<D>::json_schema(generator), Duration::json_schema(generator));
    [
        json_schema!({ "type": "object", "additionalProperties": false, "required": ["times", "values"],
            "properties": { "times": { "type": "array", "items": time }, "values": { "type": "array", "items": value } } }),
        json_schema!({ "type": "object", "additionalProperties": false, "required": ["mean", "amplitude", "period"],
            "properties": { "mean": value, "amplitude": value, "period": time } }),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{LengthDimension, MYR};

    fn read(json: &str) -> Result<Changing<LengthDimension>, String> {
        serde_json::from_str(json).map_err(|e| e.to_string())
    }

    #[test]
    fn the_three_shapes_are_read_written_back_and_evaluated() {
        for (json, expected) in [
            (r#""-3 m""#, [-3.0, -3.0, -3.0]),
            (r#"{"times":["1000000 yr","3000000 yr"],"values":["0 m","-100 m"]}"#, [0.0, -50.0, -100.0]),
            (r#"{"mean":"10 m","amplitude":"50 m","period":"4000000 yr"}"#, [10.0, 10.0, -40.0]),
        ] {
            let changing = read(json).unwrap();
            assert_eq!(serde_json::to_string(&changing).unwrap(), json);
            for (time, value) in [0.0, 2.0, 3.0].into_iter().zip(expected) {
                assert!((changing.at(time * MYR) - value).abs() < 1e-9, "{json} at {time} Myr");
            }
        }
    }

    #[test]
    fn means_over_a_step_are_those_of_many_small_ones() {
        for json in [
            r#"{"times":["1 Myr","3 Myr","4 Myr"],"values":["0 m","-100 m","50 m"]}"#,
            r#"{"mean":"10 m","amplitude":"50 m","period":"4 Myr"}"#,
        ] {
            let changing = read(json).unwrap();
            let fine = (0..10_000).map(|k| changing.at((0.5 + (f64::from(k) + 0.5) * 4.5e-4) * MYR)).sum::<f64>() / 1e4;
            assert!((changing.mean(0.5 * MYR, 5.0 * MYR) - fine).abs() < 1e-3, "{json}");
            assert_eq!(changing.mean(MYR, MYR), changing.at(MYR));
        }
    }

    #[test]
    fn wrong_shapes_say_what_is_wrong() {
        for (json, message) in [
            (r#"{"times":["0 yr"],"values":[]}"#, "as many of each"),
            (r#"{"times":["2 yr","1 yr"],"values":["0 m","1 m"]}"#, "must grow"),
            (r#"{"mean":"0 m","amplitude":"1 m","period":"0 yr"}"#, "must be > 0"),
            (r#"{"mean":"0 m"}"#, "expected `times` and `values`"),
            (r#"{"maen":"0 m"}"#, "unknown field `maen`"),
            ("true", "expected"),
        ] {
            let error = read(json).unwrap_err();
            assert!(error.contains(message), "{json}: {error}");
        }
    }
}
