//! Values that may vary in space: one quantity, a picture, a raster, a formula, strokes of a brush,
//! or a field that is already there.

use std::fmt;
use std::marker::PhantomData;
use std::path::Path;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::changing::{Course, course_schemas};
use super::strokes::{self, Stroke};
use super::{Changing, Formula, Maps, Reach};
use crate::feature::{FeatureKind, near};
use crate::grid::{Grid, Registration};
use crate::random::Seed;
use crate::terrain::NodeSurface;
use crate::units::{Dimension, Length, Quantity, unit_factor};
use crate::{Error, Result, math, parallel};

/// Context in which values are resolved.
pub trait Lookup: Sync {
    /// Seed of the stage.
    fn seed(&self) -> Seed;
    /// Where maps are read from.
    fn maps(&self) -> &dyn Maps;
    /// Time of the run, s.
    fn time(&self) -> f64;
}

/// A quantity that is uniform or varies in space.
///
/// Rain that doubles from the west side to the east side:
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
/// use landform_core::units::RateDimension;
/// use landform_core::verb::{Context, Formula, Varying};
///
/// let formula = Formula::parse("1 + u")?;
/// let rain: Varying<RateDimension> = Varying::Formula { formula, unit: "mm/yr".into() };
/// let ground = HeightField::new(Grid::new(Shape::new(2, 3), [10.0, 10.0])?, vec![0.0; 6])?;
/// let rain = rain.resolve("rainfall", &ground, &Context::default())?;
/// assert!((rain.at(2) / rain.at(0) - 2.0).abs() < 1e-12);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Varying<D: Dimension> {
    /// The same everywhere.
    Uniform(Quantity<D>),
    /// A picture stretched over the terrain, linear in its grey.
    Image {
        /// Path, relative to the recipe.
        path: String,
        /// Value of black.
        black: Quantity<D>,
        /// Value of white.
        white: Quantity<D>,
    },
    /// A georeferenced raster, placed by its coordinates.
    Raster {
        /// Path, relative to the recipe.
        path: String,
        /// Unit of its values.
        unit: String,
    },
    /// A formula of the position; see [`Formula`].
    Formula {
        /// The formula.
        formula: Formula,
        /// Unit of its value.
        unit: String,
    },
    /// One value on features of the landscape and near them, another elsewhere.
    Feature {
        /// Name of the kind of features: "rivers".
        kind: String,
        /// Distance up to which a node counts as near.
        buffer: Length,
        /// Value on and near them.
        inside: Quantity<D>,
        /// Value elsewhere.
        outside: Quantity<D>,
    },
    /// The same everywhere, but changing in time.
    InTime(Changing<D>),
    /// Strokes of a brush over another value; see [`Stroke`].
    Strokes {
        /// The strokes, in order.
        strokes: Vec<Stroke<D>>,
        /// The value before them.
        base: Box<Varying<D>>,
    },
    /// A field of the landscape, in the customary unit unless `unit` says otherwise.
    Field {
        /// Name of the field.
        name: String,
        /// Unit of its values.
        unit: String,
    },
}

/// A [`Varying`] on the nodes of a terrain, SI.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub enum Resolved {
    /// The same everywhere.
    Uniform(f64),
    /// One value per node.
    PerNode(Vec<f64>),
}

impl Resolved {
    /// Value at a node, SI.
    #[inline]
    pub fn at(&self, node: usize) -> f64 {
        match self {
            Self::Uniform(v) => *v,
            Self::PerNode(values) => values[node],
        }
    }

    /// The values, of which none on a node is below 0.
    ///
    /// # Errors
    /// [`Error::AtNode`] with the first that is.
    ///
    /// ```
    /// use landform_core::verb::Resolved;
    ///
    /// assert!(Resolved::PerNode(vec![0.0, 2.0]).at_least_zero("weakness").is_ok());
    /// assert!(Resolved::PerNode(vec![0.0, -2.0]).at_least_zero("weakness").is_err());
    /// ```
    pub fn at_least_zero(self, name: &str) -> Result<Self> {
        if let Self::PerNode(values) = &self
            && let Some(node) = parallel::find_first(values.len(), |i| values[i] < 0.0)
        {
            return Err(Error::AtNode { name: name.into(), node, value: values[node], expected: "at least 0" });
        }
        Ok(self)
    }

    /// The greatest value, SI.
    pub fn max(&self) -> f64 {
        match self {
            Self::Uniform(v) => *v,
            Self::PerNode(values) => parallel::max(values.len(), |i| values[i]),
        }
    }
}

impl<D: Dimension> Default for Varying<D> {
    fn default() -> Self {
        Self::Uniform(Quantity::from_si(0.0))
    }
}

impl<D: Dimension> From<Quantity<D>> for Varying<D> {
    fn from(quantity: Quantity<D>) -> Self {
        Self::Uniform(quantity)
    }
}

impl<D: Dimension> Varying<D> {
    /// The mean from one time (s) to a later one, SI, where the quantity changes in time; none
    /// where it does not.
    pub fn in_time(&self, from: f64, to: f64) -> Option<f64> {
        if let Self::InTime(course) = self { Some(course.mean(from, to)) } else { None }
    }

    /// How far around a node the ground can affect the value there.
    pub fn reach(&self) -> Reach {
        match self {
            Self::Feature { buffer, .. } => Reach::Distance(buffer.si()),
            Self::Strokes { base, .. } => base.reach(),
            _ => Reach::Point,
        }
    }

    /// The values on the nodes of a terrain, SI; evaluated once, so that a formula of z uses the
    /// elevation as it is now, and a course in time its value at the start ([`Varying::in_time`]
    /// gives it later).
    ///
    /// # Errors
    /// If a file or a field is missing, a raster does not cover the terrain, or a value is not
    /// finite; the error names the parameter `name`.
    pub fn resolve<T: NodeSurface>(&self, name: &str, terrain: &T, context: &impl Lookup) -> Result<Resolved> {
        let n = terrain.elevation().len();
        let values = match self {
            Self::Uniform(q) => return Ok(Resolved::Uniform(q.si())),
            Self::InTime(course) => return Ok(Resolved::Uniform(course.at(context.time()))),
            Self::Image { path, black, white } => {
                let image = context.maps().image(Path::new(path))?;
                let (b, w) = (black.si(), white.si());
                let [lo, hi] = terrain.whole_bounds();
                parallel::map(n, |i| {
                    let [x, y] = terrain.position(i);
                    let (u, v) = (ratio(x - lo[0], hi[0] - lo[0]), ratio(y - lo[1], hi[1] - lo[1]));
                    math::lerp(b, w, image.at(u, v))
                })
            }
            Self::Raster { path, unit } => {
                let raster = context.maps().raster(Path::new(path))?;
                if let (Some(a), Some(b)) = (raster.grid().georeference.epsg, terrain.epsg())
                    && a != b
                {
                    return Err(Error::parameter(
                        name,
                        format!("a raster in EPSG:{a}"),
                        &format!("EPSG:{b}, as the terrain"),
                    ));
                }
                let factor = factor::<D>(unit);
                parallel::map(n, |i| factor * raster.elevation_at(within_pixels(raster.grid(), terrain.position(i))))
            }
            Self::Formula { formula, unit } => {
                let factor = factor::<D>(unit);
                let bounds = terrain.whole_bounds();
                parallel::map(n, |i| {
                    let z = terrain.elevation()[i];
                    factor * formula.at(bounds, terrain.position(i), z, context.seed())
                })
            }
            Self::Strokes { strokes, base } => {
                let base = base.resolve(name, terrain, context)?;
                strokes::paint(strokes, n, |i| terrain.position(i), |i| base.at(i))
            }
            Self::Feature { kind: word, buffer, inside, outside } => {
                let features = terrain.features();
                let kind = FeatureKind::of(word).filter(|kind| features.of(*kind).next().is_some());
                let Some(kind) = kind else {
                    return Err(Error::MissingField {
                        name: word.clone(),
                        needed_by: format!("`{name}`"),
                        available: FeatureKind::ALL
                            .iter()
                            .filter(|k| features.of(k.1).next().is_some())
                            .map(|k| k.0.to_string())
                            .collect(),
                    });
                };
                let places: Vec<[f64; 2]> = (0..n).map(|i| terrain.position(i)).collect();
                let marked = near(features.of(kind), buffer.si(), &places);
                marked.iter().map(|&m| if m { inside.si() } else { outside.si() }).collect()
            }
            Self::Field { name: field, unit } => {
                let factor = factor::<D>(unit);
                let values = terrain.real(field, &format!("`{name}`"))?;
                parallel::map(n, |i| factor * values[i])
            }
        };
        let wrong = |i: usize| !values[i].is_finite() && terrain.elevation()[i].is_finite();
        if let Some(i) = parallel::find_first(n, wrong) {
            let [x, y] = terrain.position(i);
            return Err(Error::parameter(name, format!("not a number at ({x:.1}, {y:.1})"), "a value at every node"));
        }
        Ok(Resolved::PerNode(values))
    }
}

/// A position on the outer half of a pixel as one between the pixels' centres: the outermost values
/// hold to the pixels' edges.
fn within_pixels(grid: &Grid, position: [f64; 2]) -> [f64; 2] {
    let [lo, hi] = grid.bounds();
    let near = |k: usize| position[k].clamp(lo[k], hi[k]);
    let half = |k: usize| 0.5 * grid.spacing[k] * (1.0 + 1e-9);
    let is_on = grid.georeference.registration == Registration::Area
        && (0..2).all(|k| (near(k) - position[k]).abs() <= half(k));
    if is_on { [near(0), near(1)] } else { position }
}

fn ratio(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 0.5 }
}

fn factor<D: Dimension>(unit: &str) -> f64 {
    unit_factor::<D>(unit).unwrap_or(D::UNIT_SI)
}

impl<D: Dimension> Serialize for Varying<D> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = match self {
            Self::Uniform(q) => return q.serialize(serializer),
            Self::InTime(course) => return course.serialize(serializer),
            _ => serializer.serialize_map(None)?,
        };
        match self {
            Self::Uniform(_) | Self::InTime(_) => {}
            Self::Image { path, black, white } => {
                map.serialize_entry("image", path)?;
                map.serialize_entry("black", black)?;
                map.serialize_entry("white", white)?;
            }
            Self::Raster { path, unit } => {
                map.serialize_entry("raster", path)?;
                map.serialize_entry("unit", unit)?;
            }
            Self::Formula { formula, unit } => {
                map.serialize_entry("formula", formula.text())?;
                map.serialize_entry("unit", unit)?;
            }
            Self::Strokes { strokes, base } => {
                map.serialize_entry("strokes", strokes)?;
                map.serialize_entry("base", base)?;
            }
            Self::Feature { kind, buffer, inside, outside } => {
                map.serialize_entry("feature", kind)?;
                map.serialize_entry("buffer", buffer)?;
                map.serialize_entry("inside", inside)?;
                map.serialize_entry("outside", outside)?;
            }
            Self::Field { name, unit } => {
                map.serialize_entry("field", name)?;
                map.serialize_entry("unit", unit)?;
            }
        }
        map.end()
    }
}

const KEYS: &[&str] = &[
    "image",
    "black",
    "white",
    "raster",
    "formula",
    "field",
    "feature",
    "buffer",
    "inside",
    "outside",
    "unit",
    "strokes",
    "base",
    "times",
    "values",
    "mean",
    "amplitude",
    "period",
];

impl<'de, D: Dimension> Deserialize<'de> for Varying<D> {
    fn deserialize<De: Deserializer<'de>>(deserializer: De) -> Result<Self, De::Error> {
        deserializer.deserialize_any(VaryingVisitor(PhantomData))
    }
}

struct VaryingVisitor<D>(PhantomData<D>);

impl<'de, D: Dimension> Visitor<'de> for VaryingVisitor<D> {
    type Value = Varying<D>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "a {} such as \"{}\", or a table with `image`, `raster`, `formula`, `field`, `feature`, `strokes`, or `times` and `values`",
            D::NAME,
            D::EXAMPLE
        )
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Varying<D>, E> {
        Quantity::parse(text).map(Varying::Uniform).map_err(E::custom)
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Varying<D>, E> {
        Quantity::deserialize(de::value::F64Deserializer::new(value)).map(Varying::Uniform)
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Varying<D>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Varying<D>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Varying<D>, A::Error> {
        let mut parts = Parts::<D>::default();
        while let Some(key) = map.next_key::<String>()? {
            match key.as_str() {
                "image" => parts.image = Some(map.next_value()?),
                "black" => parts.black = Some(map.next_value()?),
                "white" => parts.white = Some(map.next_value()?),
                "raster" => parts.raster = Some(map.next_value()?),
                "formula" => {
                    let text: String = map.next_value()?;
                    parts.formula = Some(Formula::parse(&text).map_err(de::Error::custom)?);
                }
                "field" => parts.field = Some(map.next_value()?),
                "feature" => {
                    let word: String = map.next_value()?;
                    if FeatureKind::of(&word).is_none() {
                        let words: Vec<&str> = FeatureKind::ALL.iter().map(|k| k.0).collect();
                        let what = format!("there is no feature \"{word}\", expected one of {}", words.join(", "));
                        return Err(de::Error::custom(what));
                    }
                    parts.feature = Some(word);
                }
                "strokes" => parts.strokes = Some(map.next_value()?),
                "base" => parts.base = Some(Box::new(map.next_value()?)),
                "buffer" => parts.buffer = Some(map.next_value()?),
                "inside" => parts.inside = Some(map.next_value()?),
                "outside" => parts.outside = Some(map.next_value()?),
                "unit" => {
                    let unit: String = map.next_value()?;
                    unit_factor::<D>(&unit).map_err(de::Error::custom)?;
                    parts.unit = Some(unit);
                }
                other => {
                    if !parts.course.take(other, &mut map)? {
                        return Err(de::Error::unknown_field(other, KEYS));
                    }
                }
            }
        }
        parts.build()
    }
}

struct Parts<D: Dimension> {
    image: Option<String>,
    black: Option<Quantity<D>>,
    white: Option<Quantity<D>>,
    raster: Option<String>,
    formula: Option<Formula>,
    field: Option<String>,
    unit: Option<String>,
    feature: Option<String>,
    buffer: Option<Length>,
    inside: Option<Quantity<D>>,
    outside: Option<Quantity<D>>,
    strokes: Option<Vec<Stroke<D>>>,
    base: Option<Box<Varying<D>>>,
    course: Course<D>,
}

impl<D: Dimension> Default for Parts<D> {
    fn default() -> Self {
        Self {
            image: None,
            black: None,
            white: None,
            raster: None,
            formula: None,
            field: None,
            unit: None,
            feature: None,
            buffer: None,
            inside: None,
            outside: None,
            strokes: None,
            base: None,
            course: Course::default(),
        }
    }
}

impl<D: Dimension> Parts<D> {
    fn build<E: de::Error>(self) -> Result<Varying<D>, E> {
        let given = usize::from(self.image.is_some())
            + usize::from(self.raster.is_some())
            + usize::from(self.formula.is_some())
            + usize::from(self.field.is_some())
            + usize::from(self.feature.is_some())
            + usize::from(self.strokes.is_some())
            + usize::from(!self.course.is_empty());
        if given != 1 {
            return Err(E::custom(format!(
                "{given} of `image`, `raster`, `formula`, `field`, `feature`, `strokes`, `times` given; expected exactly one"
            )));
        }
        if let Some(strokes) = self.strokes {
            return with_strokes(strokes, self.base, self.unit.is_some());
        }
        if self.base.is_some() {
            return Err(E::custom("`base` goes with `strokes`"));
        }
        if self.image.is_none() && (self.black.is_some() || self.white.is_some()) {
            return Err(E::custom("`black` and `white` go with `image`"));
        }
        if let Some(kind) = self.feature {
            let one = |value: f64| Quantity::of(value);
            let (inside, outside) = (self.inside.unwrap_or(one(1.0)), self.outside.unwrap_or(one(0.0)));
            let buffer = self.buffer.unwrap_or(Length::of(0.0));
            if !(buffer.si() >= 0.0) || self.unit.is_some() {
                return Err(E::custom(
                    "`feature` takes a `buffer` of at least 0 m, and no `unit`: give it with `inside` and `outside`",
                ));
            }
            return Ok(Varying::Feature { kind, buffer, inside, outside });
        }
        if self.buffer.is_some() || self.inside.is_some() || self.outside.is_some() {
            return Err(E::custom("`buffer`, `inside` and `outside` go with `feature`"));
        }
        if !self.course.is_empty() {
            if self.unit.is_some() {
                return Err(E::custom("a course in time takes no `unit`: give it with every value"));
            }
            return self.course.build().map(Varying::InTime).map_err(E::custom);
        }
        if let Some(path) = self.image {
            if self.unit.is_some() {
                return Err(E::custom("`image` takes no `unit`: give it with `black` and `white`"));
            }
            return match (self.black, self.white) {
                (Some(black), Some(white)) => Ok(Varying::Image { path, black, white }),
                _ => {
                    Err(E::custom(format!("`image` needs `black` and `white`, for example black = \"{}\"", D::EXAMPLE)))
                }
            };
        }
        let unit = match (self.unit, &self.field) {
            (Some(unit), _) => unit,
            (None, Some(_)) => D::UNIT.into(),
            (None, None) if D::BARE => D::UNIT.into(),
            (None, None) => return Err(E::custom(format!("`unit` is missing, for example unit = \"{}\"", D::UNIT))),
        };
        Ok(match (self.raster, self.formula, self.field) {
            (Some(path), _, _) => Varying::Raster { path, unit },
            (_, Some(formula), _) => Varying::Formula { formula, unit },
            (_, _, name) => Varying::Field { name: name.unwrap_or_default(), unit },
        })
    }
}

/// Strokes over a value, which is 0 if none is given.
fn with_strokes<D: Dimension, E: de::Error>(
    strokes: Vec<Stroke<D>>,
    base: Option<Box<Varying<D>>>,
    unit: bool,
) -> Result<Varying<D>, E> {
    if unit {
        return Err(E::custom("`strokes` take no `unit`: give it with every `strength`"));
    }
    strokes::check(&strokes).map_err(E::custom)?;
    let base = base.unwrap_or_default();
    if matches!(*base, Varying::Strokes { .. } | Varying::InTime(_)) {
        return Err(E::custom(
            "the `base` of strokes is a value that does not change in time, without strokes of its own",
        ));
    }
    Ok(Varying::Strokes { strokes, base })
}

impl<D: Dimension> JsonSchema for Varying<D> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        format!("varying {}", D::NAME).into()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let quantity = Quantity::<D>::json_schema(generator);
        let text = json_schema!({ "type": "string" });
        let [lines, cycle] = course_schemas::<D>(generator);
        let strokes = strokes::schema::<D>(generator);
        let words: Vec<&str> = FeatureKind::ALL.iter().map(|kind| kind.0).collect();
        json_schema!({
            "anyOf": [
                quantity,
                { "type": "object", "additionalProperties": false, "required": ["image", "black", "white"],
                  "properties": { "image": text, "black": quantity, "white": quantity } },
                { "type": "object", "additionalProperties": false, "required": ["raster"],
                  "properties": { "raster": text, "unit": text } },
                { "type": "object", "additionalProperties": false, "required": ["formula"],
                  "properties": { "formula": text, "unit": text } },
                { "type": "object", "additionalProperties": false, "required": ["field"],
                  "properties": { "field": text, "unit": text } },
                { "type": "object", "additionalProperties": false, "required": ["feature"],
                  "properties": { "feature": { "enum": words },
                    "buffer": Length::json_schema(generator), "inside": quantity, "outside": quantity } },
                { "type": "object", "additionalProperties": false, "required": ["strokes"],
                  "properties": { "strokes": strokes, "base": { "anyOf": [quantity, { "type": "object" }] } } },
                lines,
                cycle,
            ],
            "x-unit": D::UNIT, "x-dimension": D::NAME, "x-example": D::EXAMPLE, "x-varying": true
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::terrain::HeightField;
    use crate::units::RateDimension;
    use crate::verb::{Context, Image, NoMaps};
    use std::sync::Arc;

    type Rate = Varying<RateDimension>;

    fn read(json: &str) -> Result<Rate, String> {
        serde_json::from_str(json).map_err(|e| e.to_string())
    }

    #[test]
    fn the_eight_shapes_are_read_and_written_back() {
        for json in [
            r#""0.4 mm/yr""#,
            r#"{"image":"a.png","black":"0 mm/yr","white":"0.4 mm/yr"}"#,
            r#"{"raster":"a.tif","unit":"mm/yr"}"#,
            r#"{"formula":"0.4*(1 - r)","unit":"mm/yr"}"#,
            r#"{"field":"uplift","unit":"mm/yr"}"#,
            r#"{"strokes":[{"tool":"raise","radius":"900 m","strength":"1 mm/yr","points":[[1.5,2.0,0.5,0.1]]}],"base":"0.1 mm/yr"}"#,
            r#"{"times":["0 yr","1000 yr"],"values":["0 mm/yr","1 mm/yr"]}"#,
            r#"{"feature":"rivers","buffer":"50 m","inside":"0.1 mm/yr","outside":"0 mm/yr"}"#,
        ] {
            assert_eq!(serde_json::to_string(&read(json).unwrap()).unwrap(), json);
        }
    }

    #[test]
    fn wrong_shapes_say_what_is_wrong() {
        for (json, message) in [
            (r#"{"image":"a.png"}"#, "needs `black` and `white`"),
            (r#"{"formula":"1"}"#, "`unit` is missing"),
            (r#"{"formula":"1 +","unit":"mm/yr"}"#, "formula `1 +`"),
            (r#"{"formula":"1","unit":"m"}"#, "wrong dimension"),
            (r#"{"fromula":"1","unit":"m"}"#, "unknown field `fromula`"),
            (r#"{"formula":"1","field":"x","unit":"mm/yr"}"#, "expected exactly one"),
            (r#"{"times":["0 yr"],"field":"x"}"#, "expected exactly one"),
            (r#"{"feature":"river"}"#, "expected one of rivers, lakes"),
            (r#"{"buffer":"3 m","field":"x"}"#, "go with `feature`"),
            (r#""0.4 m""#, "wrong dimension"),
            ("true", "expected a rate such as \"0.4 mm/yr\", or a table"),
        ] {
            let error = read(json).unwrap_err();
            assert!(error.contains(message), "{json}: {error}");
        }
    }

    #[test]
    fn the_outermost_pixels_hold_to_their_edges() {
        struct OneMap(HeightField);
        impl Maps for OneMap {
            fn image(&self, path: &Path) -> Result<Image> {
                NoMaps.image(path)
            }
            fn raster(&self, _: &Path) -> Result<Arc<HeightField>> {
                Ok(Arc::new(self.0.clone()))
            }
        }
        // Four cells of 120 m over the very area of 16 x 16 nodes of 30 m.
        let mut terrain = Grid::new(Shape::new(16, 16), [30.0, 30.0]).unwrap();
        (terrain.origin, terrain.georeference.registration) = ([15.0, 465.0], Registration::Area);
        let mut coarse = Grid::new(Shape::new(4, 4), [120.0, 120.0]).unwrap();
        (coarse.origin, coarse.georeference.registration) = ([60.0, 420.0], Registration::Area);
        let terrain = HeightField::new(terrain, vec![0.0; 256]).unwrap();
        let map = |grid: &Grid| OneMap(HeightField::new(grid.clone(), (0..16).map(f64::from).collect()).unwrap());
        let rate = read(r#"{"raster":"a.tif","unit":"mm/yr"}"#).unwrap();
        let maps = map(&coarse);
        let values = rate.resolve("rate", &terrain, &Context { maps: &maps, ..Context::default() }).unwrap();
        let [first, last] = [0, 255].map(|i| values.at(i) / crate::units::MM_PER_YEAR);
        assert!(first.abs() < 1e-9 && (last - 15.0).abs() < 1e-9, "{first} {last}");
        // Points have no edges.
        coarse.georeference.registration = Registration::Point;
        let maps = map(&coarse);
        let error = rate.resolve("rate", &terrain, &Context { maps: &maps, ..Context::default() }).unwrap_err();
        assert!(error.to_string().contains("not a number"), "{error}");
    }

    #[test]
    fn a_formula_is_evaluated_on_the_nodes() {
        let terrain = HeightField::new(Grid::new(Shape::new(3, 5), [10.0, 10.0]).unwrap(), vec![2.0; 15]).unwrap();
        let context = Context { seed: Seed(1), ..Context::default() };
        let rate = read(r#"{"formula":"u + z","unit":"mm/yr"}"#).unwrap();
        let values = rate.resolve("rate", &terrain, &context).unwrap();
        assert!((values.at(4) / crate::units::MM_PER_YEAR - 3.0).abs() < 1e-12);
        let bad = read(r#"{"formula":"1/(u - u)","unit":"mm/yr"}"#).unwrap();
        assert!(bad.resolve("rate", &terrain, &context).unwrap_err().to_string().contains("`rate` is not a number"));
        let missing = read(r#"{"field":"uplift"}"#).unwrap();
        assert!(missing.resolve("rate", &terrain, &context).is_err());
    }
}
