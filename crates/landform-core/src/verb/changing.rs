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
        let (mut times, mut values): (Option<Vec<Duration>>, Option<Vec<Quantity<D>>>) = (None, None);
        let (mut mean, mut amplitude, mut period) = (None, None, None);
        while let Some(key) = map.next_key::<String>()? {
            match key.as_str() {
                "times" => times = Some(map.next_value()?),
                "values" => values = Some(map.next_value()?),
                "mean" => mean = Some(map.next_value()?),
                "amplitude" => amplitude = Some(map.next_value()?),
                "period" => period = Some(map.next_value()?),
                other => return Err(de::Error::unknown_field(other, KEYS)),
            }
        }
        match (times, values, mean, amplitude, period) {
            (Some(times), Some(values), None, None, None) => linear(times, values).map_err(de::Error::custom),
            (None, None, Some(mean), Some(amplitude), Some(period)) => {
                cycle(mean, amplitude, period).map_err(de::Error::custom)
            }
            _ => Err(de::Error::custom("expected `times` and `values`, or `mean`, `amplitude` and `period`")),
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
        let (value, time) = (Quantity::<D>::json_schema(generator), Duration::json_schema(generator));
        json_schema!({
            "anyOf": [
                value,
                { "type": "object", "additionalProperties": false, "required": ["times", "values"],
                  "properties": { "times": { "type": "array", "items": time }, "values": { "type": "array", "items": value } } },
                { "type": "object", "additionalProperties": false, "required": ["mean", "amplitude", "period"],
                  "properties": { "mean": value, "amplitude": value, "period": time } },
            ],
            "x-unit": D::UNIT, "x-dimension": D::NAME, "x-example": D::EXAMPLE, "x-changing": true
        })
    }
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
