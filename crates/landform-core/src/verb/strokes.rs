//! Strokes of a brush: a value that was painted, kept as what the hand did.
//!
//! # Method
//! A stroke is a line of places with a pressure at each. It covers a place by
//! c = p (1 − (d/r)²)² within the radius r of the line, d the distance to it and p the pressure
//! there; of all parts of the line the greatest counts, so that going over twice does not add. The
//! strokes act in order on a value v: *raise* v + s c, *lower* v − s c (but not below 0 from above
//! it), *level* v + (s − v) c, with the strength s.
//!
//! # Limits
//! At most [`MOST_STROKES`] strokes with [`MOST_POINTS`] points in all: about 64 kB of text.
//! Seconds are kept and not used.
//!
//! # Checked by
//! The tests below: a stroke gone over twice, order, bounds.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use crate::parallel;
use crate::units::{Dimension, Length, Quantity};

/// Strokes of one value at most.
const MOST_STROKES: usize = 400;
/// Points of all strokes of one value at most.
const MOST_POINTS: usize = 4_000;
/// Farther places are a mistake, m.
const FARTHEST: f64 = 1e9;

/// What a stroke does.
///
/// ```
/// use landform_core::verb::Tool;
///
/// assert_eq!(serde_json::from_str::<Tool>("\"lower\"")?, Tool::Lower);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Tool {
    /// Adds the strength.
    #[default]
    Raise,
    /// Takes the strength away; what was not negative is not made so.
    Lower,
    /// Brings the value to the strength.
    Level,
}

/// A stroke of a brush.
///
/// ```
/// use landform_core::units::RateDimension;
/// use landform_core::verb::Stroke;
///
/// let json = r#"{"radius":"2 km","strength":"1 mm/yr","points":[[0,0],[5000,0]]}"#;
/// let stroke: Stroke<RateDimension> = serde_json::from_str(json)?;
/// assert_eq!((stroke.coverage([2500.0, 0.0]), stroke.coverage([2500.0, 2000.0])), (1.0, 0.0));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, bound = "")]
pub struct Stroke<D: Dimension> {
    /// What it does.
    #[serde(default)]
    pub tool: Tool,
    /// Distance from its line up to which it reaches.
    pub radius: Length,
    /// How much it adds or takes in its middle; of `level` the value itself.
    pub strength: Quantity<D>,
    /// Places: x and y (m), pressure (0 to 1; 1 if not given), seconds since its begin.
    pub points: Vec<Vec<f64>>,
}

impl<D: Dimension> Stroke<D> {
    /// What is wrong with it, if something is.
    fn check(&self) -> Result<(), String> {
        let radius = self.radius.si();
        if !(radius > 0.0 && radius <= FARTHEST) {
            return Err(format!("the radius of a stroke is {}; expected > 0 m", self.radius));
        }
        if !self.strength.si().is_finite() {
            return Err("the strength of a stroke is not finite".into());
        }
        let is_place = |p: &Vec<f64>| {
            (2..=4).contains(&p.len())
                && p[..2].iter().all(|x| x.abs() <= FARTHEST)
                && p.get(2).is_none_or(|pressure| (0.0..=1.0).contains(pressure))
                && p.get(3).is_none_or(|seconds| (0.0..=1e6).contains(seconds))
        };
        match self.points.iter().find(|p| !is_place(p)) {
            Some(point) => Err(format!("a point of a stroke is {point:?}; expected [x, y], pressure 0 to 1, seconds")),
            None if self.points.is_empty() => Err("a stroke has no points".into()),
            None => Ok(()),
        }
    }

    /// The share of its strength that reaches a place (m), 0 to 1.
    ///
    /// ```
    /// # use landform_core::units::RateDimension;
    /// # use landform_core::verb::Stroke;
    /// let json = r#"{"radius":"10 m","strength":"1 mm/yr","points":[[0,0,0.5]]}"#;
    /// let touch: Stroke<RateDimension> = serde_json::from_str(json)?;
    /// assert_eq!(touch.coverage([0.0, 0.0]), 0.5);
    /// # Ok::<(), serde_json::Error>(())
    /// ```
    pub fn coverage(&self, at: [f64; 2]) -> f64 {
        covered(&self.points, self.radius.si(), at)
    }

    fn apply(&self, value: f64, at: [f64; 2]) -> f64 {
        let (c, s) = (self.coverage(at), self.strength.si());
        match self.tool {
            _ if c == 0.0 => value,
            Tool::Raise => value + s * c,
            Tool::Lower => (value - s * c).max(value.min(0.0)),
            Tool::Level => value + (s - value) * c,
        }
    }

    /// The rectangle that it reaches into: lowest and highest x and y, m.
    fn bounds(&self) -> [[f64; 2]; 2] {
        let radius = self.radius.si();
        let span = |k: usize, pick: fn(f64, f64) -> f64, start: f64| self.points.iter().map(|p| p[k]).fold(start, pick);
        let low = [0, 1].map(|k| span(k, f64::min, f64::INFINITY) - radius);
        [low, [0, 1].map(|k| span(k, f64::max, f64::NEG_INFINITY) + radius)]
    }
}

/// The share by which a line of points [x, y, pressure] with a radius (m) covers a place, 0 to 1.
///
/// ```
/// use landform_core::verb::covered;
///
/// let line = [vec![0.0, 0.0], vec![9.0, 0.0]];
/// assert_eq!((covered(&line, 2.0, [5.0, 0.0]), covered(&line, 2.0, [5.0, 2.0])), (1.0, 0.0));
/// ```
pub fn covered(points: &[Vec<f64>], radius: f64, at: [f64; 2]) -> f64 {
    let pressure = |p: &[f64]| p.get(2).copied().unwrap_or(1.0);
    let single = (points.len() == 1).then(|| (&points[0], &points[0]));
    let pairs = points.windows(2).map(|pair| (&pair[0], &pair[1])).chain(single);
    let one = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0] * along[0] + along[1] * along[1];
        let part = ((at[0] - a[0]) * along[0] + (at[1] - a[1]) * along[1]) / length;
        let part = if length > 0.0 { part.clamp(0.0, 1.0) } else { 0.0 };
        let away = [at[0] - a[0] - part * along[0], at[1] - a[1] - part * along[1]];
        let ratio = (away[0] * away[0] + away[1] * away[1]) / (radius * radius);
        if ratio >= 1.0 {
            return 0.0;
        }
        (pressure(a) + part * (pressure(b) - pressure(a))) * (1.0 - ratio) * (1.0 - ratio)
    };
    pairs.map(one).fold(0.0, f64::max)
}

/// Refuses strokes that are too many, or wrong.
pub(super) fn check<D: Dimension>(strokes: &[Stroke<D>]) -> Result<(), String> {
    let points: usize = strokes.iter().map(|stroke| stroke.points.len()).sum();
    if strokes.len() > MOST_STROKES || points > MOST_POINTS {
        let found = format!("{} strokes with {points} points", strokes.len());
        return Err(format!("there are {found}; expected at most {MOST_STROKES} with {MOST_POINTS}"));
    }
    strokes.iter().try_for_each(Stroke::check)
}

/// Values at places after the strokes, in their order.
pub(super) fn paint<D: Dimension>(
    strokes: &[Stroke<D>],
    nodes: usize,
    place: impl Fn(usize) -> [f64; 2] + Sync,
    value: impl Fn(usize) -> f64 + Sync,
) -> Vec<f64> {
    let bounds: Vec<_> = strokes.iter().map(Stroke::bounds).collect();
    parallel::map(nodes, |i| {
        let at = place(i);
        let is_near = |[low, high]: &[[f64; 2]; 2]| (0..2).all(|k| low[k] <= at[k] && at[k] <= high[k]);
        let near = strokes.iter().zip(&bounds).filter(|(_, bounds)| is_near(bounds));
        near.fold(value(i), |value, (stroke, _)| stroke.apply(value, at))
    })
}

/// The schema of a list of strokes.
pub(super) fn schema<D: Dimension>(generator: &mut SchemaGenerator) -> Schema {
    let (quantity, radius) = (Quantity::<D>::json_schema(generator), Length::json_schema(generator));
    json_schema!({ "type": "array", "maxItems": MOST_STROKES, "items": {
        "type": "object", "additionalProperties": false, "required": ["radius", "strength", "points"],
        "properties": { "tool": { "enum": ["raise", "lower", "level"] }, "radius": radius, "strength": quantity,
            "points": { "type": "array", "minItems": 1,
                "items": { "type": "array", "minItems": 2, "maxItems": 4, "items": { "type": "number" } } } } } })
}

#[cfg(test)]
mod tests {
    use crate::grid::{Grid, Shape};
    use crate::terrain::HeightField;
    use crate::units::{MM_PER_YEAR, RateDimension};
    use crate::verb::{Context, Varying};

    type Rate = Varying<RateDimension>;

    fn at(json: &str, node: usize) -> f64 {
        let rate: Rate = serde_json::from_str(json).unwrap();
        // Read and written back it is the same.
        assert_eq!(serde_json::from_str::<Rate>(&serde_json::to_string(&rate).unwrap()).unwrap(), rate);
        let ground = HeightField::new(Grid::new(Shape::new(3, 11), [100.0, 100.0]).unwrap(), vec![0.0; 33]).unwrap();
        rate.resolve("rate", &ground, &Context::default()).unwrap().at(node) / MM_PER_YEAR
    }

    fn json(base: &str, strokes: &[&str]) -> String {
        format!("{{\"strokes\":[{}],\"base\":{base}}}", strokes.join(","))
    }

    const LINE: &str = r#""radius":"250 m","points":[[0,100],[1000,100]]"#;

    #[test]
    fn going_over_twice_does_not_add_and_another_stroke_does() {
        let once = format!("{{\"strength\":\"2 mm/yr\",{LINE}}}");
        let twice = once.replace("[[0,100],[1000,100]]", "[[0,100],[1000,100],[0,100]]");
        let base = "\"0.5 mm/yr\"";
        for node in [11, 16, 21, 5, 27] {
            assert_eq!(at(&json(base, &[&once]), node), at(&json(base, &[&twice]), node));
        }
        assert!((at(&json(base, &[&once]), 16) - 2.5).abs() < 1e-12);
        // 100 m away: (1 - 0.16)².
        assert!((at(&json(base, &[&once]), 5) - (0.5 + 2.0 * 0.84 * 0.84)).abs() < 1e-12);
        assert!((at(&json(base, &[&once, &once]), 16) - 4.5).abs() < 1e-12);
    }

    #[test]
    fn strokes_act_in_their_order_on_any_base() {
        let raise = format!("{{\"tool\":\"raise\",\"strength\":\"2 mm/yr\",{LINE}}}");
        let lower = format!("{{\"tool\":\"lower\",\"strength\":\"9 mm/yr\",{LINE}}}");
        let level = format!("{{\"tool\":\"level\",\"strength\":\"3 mm/yr\",{LINE}}}");
        let formula = r#"{"formula":"u","unit":"mm/yr"}"#;
        assert!((at(&json(formula, &[&raise]), 21) - 3.0).abs() < 1e-12);
        assert_eq!(at(&json(formula, &[&lower]), 16), 0.0);
        assert_eq!(at(&json("\"-1 mm/yr\"", &[&lower]), 16), -1.0);
        assert!((at(&json(formula, &[&lower, &raise]), 16) - 2.0).abs() < 1e-12);
        assert!((at(&json(formula, &[&raise, &level]), 16) - 3.0).abs() < 1e-12);
        let half = raise.replace("[0,100],[1000,100]", "[500,100,0.5,0.1]");
        assert!((at(&json("\"0 mm/yr\"", &[&half]), 16) - 1.0).abs() < 1e-12);
        // Without a base, on nothing.
        assert!((at(&format!("{{\"strokes\":[{raise}]}}"), 16) - 2.0).abs() < 1e-12);
        assert_eq!(at(r#"{"strokes":[],"base":"7 mm/yr"}"#, 3), 7.0);
    }

    #[test]
    fn hostile_strokes_are_refused() {
        let read = |json: &str| serde_json::from_str::<Rate>(json).map_err(|e| e.to_string());
        let with = |from: &str, to: &str| {
            json("\"0 m/yr\"", &[&format!("{{\"strength\":\"2 mm/yr\",{LINE}}}").replace(from, to)])
        };
        for (json, why) in [
            (with("250 m", "0 m"), "radius"),
            (with("250 m", "-1 m"), "radius"),
            (with("250 m", "1e300 m"), "radius"),
            (with("[[0,100],[1000,100]]", "[]"), "no points"),
            (with("[0,100]", "[0]"), "a point"),
            (with("[0,100]", "[0,1e300]"), "a point"),
            (with("[0,100]", "[0,1,2]"), "a point"),
            (with("[0,100]", "[0,1,1,1,1]"), "a point"),
            (with("2 mm/yr", "2 m"), "dimension"),
            (with("\"strength\"", "\"strenght\""), "unknown field"),
            (r#"{"strokes":[],"base":{"strokes":[]}}"#.into(), "base"),
            (r#"{"strokes":[],"base":{"times":["0 yr","1 yr"],"values":["0 m/yr","1 m/yr"]}}"#.into(), "base"),
            (r#"{"base":"1 m/yr"}"#.into(), "exactly one"),
            (r#"{"base":"1 m/yr","field":"x"}"#.into(), "goes with `strokes`"),
            (r#"{"strokes":[],"formula":"1","unit":"m/yr"}"#.into(), "exactly one"),
        ] {
            let error = read(&json).unwrap_err();
            assert!(error.contains(why), "{json}: {error}");
        }
        let point = "[0,0],".repeat(4_001);
        let many = with("[[0,100],[1000,100]]", &format!("[{}]", point.trim_end_matches(',')));
        assert!(read(&many).unwrap_err().contains("4001 points"));
    }
}
