//! Values that may vary in space: one quantity, a picture, a raster, a formula, or a field that is already there.

use std::fmt;
use std::marker::PhantomData;
use std::path::Path;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::Formula;
use crate::random::Seed;
use crate::terrain::{HeightField, NodeSurface};
use crate::units::{Dimension, Quantity, unit_factor};
use crate::{Error, Result, math, parallel};

/// What a stage may ask of the world: its seed, and maps by path.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// Seed of the stage.
    pub seed: Seed,
    /// Where maps are read from.
    pub maps: &'a dyn Maps,
}

/// A grey picture, row 0 north, values from 0 (black) to 1 (white).
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub cols: usize,
    /// Row-major values.
    pub values: Vec<f64>,
}

/// Reads maps. Core opens no file; whoever runs a recipe says how.
pub trait Maps: Sync {
    /// Reads a picture as grey.
    ///
    /// # Errors
    /// [`Error::Io`] or [`Error::Format`].
    fn image(&self, path: &Path) -> Result<Image>;

    /// Reads a georeferenced raster.
    ///
    /// # Errors
    /// [`Error::Io`] or [`Error::Format`].
    fn raster(&self, path: &Path) -> Result<HeightField>;
}

/// No maps at all.
#[derive(Clone, Copy, Debug)]
pub struct NoMaps;

impl Maps for NoMaps {
    fn image(&self, path: &Path) -> Result<Image> {
        Err(Error::io("read", path, std::io::ErrorKind::NotFound.into()))
    }
    fn raster(&self, path: &Path) -> Result<HeightField> {
        Err(Error::io("read", path, std::io::ErrorKind::NotFound.into()))
    }
}

/// A quantity that is uniform or varies in space.
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
    /// Value at a node.
    #[inline]
    pub fn at(&self, node: usize) -> f64 {
        match self {
            Self::Uniform(v) => *v,
            Self::PerNode(values) => values[node],
        }
    }

    /// The greatest value.
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
    /// The values on the nodes of a terrain, SI; evaluated once, so a formula of z sees the elevation as it is now.
    ///
    /// # Errors
    /// A missing file or field, a raster that does not cover the terrain, or a value that is not finite, with `name` as the
    /// parameter's name.
    pub fn resolve<T: NodeSurface>(&self, name: &str, terrain: &T, context: &Context) -> Result<Resolved> {
        let n = terrain.elevation().len();
        let values = match self {
            Self::Uniform(q) => return Ok(Resolved::Uniform(q.si())),
            Self::Image { path, black, white } => {
                let image = context.maps.image(Path::new(path))?;
                let (b, w) = (black.si(), white.si());
                let [lo, hi] = terrain.bounds();
                parallel::map(n, |i| {
                    let [x, y] = terrain.position(i);
                    let (u, v) = (ratio(x - lo[0], hi[0] - lo[0]), ratio(y - lo[1], hi[1] - lo[1]));
                    math::lerp(b, w, image.at(u, v))
                })
            }
            Self::Raster { path, unit } => {
                let raster = context.maps.raster(Path::new(path))?;
                if let (Some(a), Some(b)) = (raster.grid.georeference.epsg, terrain.epsg())
                    && a != b
                {
                    return Err(Error::parameter(
                        name,
                        format!("a raster in EPSG:{a}"),
                        &format!("EPSG:{b}, as the terrain"),
                    ));
                }
                let factor = factor::<D>(unit);
                parallel::map(n, |i| factor * raster.elevation_at(terrain.position(i)))
            }
            Self::Formula { formula, unit } => {
                let factor = factor::<D>(unit);
                let bounds = terrain.bounds();
                parallel::map(n, |i| {
                    let z = terrain.elevation()[i];
                    factor * formula.at(bounds, terrain.position(i), z, context.seed)
                })
            }
            Self::Field { name: field, unit } => {
                let factor = factor::<D>(unit);
                let values = match field.as_str() {
                    "elevation" => terrain.elevation().to_vec(),
                    other => terrain.fields().by_name(other, &format!("`{name}`"))?,
                };
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

fn ratio(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 0.5 }
}

fn factor<D: Dimension>(unit: &str) -> f64 {
    unit_factor::<D>(unit).unwrap_or(D::UNIT_SI)
}

impl Image {
    /// Bilinear value at (u east, v north), both 0 to 1 between the outer pixels' centres.
    pub fn at(&self, u: f64, v: f64) -> f64 {
        let x = u.clamp(0.0, 1.0) * (self.cols - 1) as f64;
        let y = (1.0 - v.clamp(0.0, 1.0)) * (self.rows - 1) as f64;
        let (c, r) = (x as usize, y as usize);
        let (c1, r1) = ((c + 1).min(self.cols - 1), (r + 1).min(self.rows - 1));
        let at = |r: usize, c: usize| self.values[r * self.cols + c];
        let (fx, fy) = (x - c as f64, y - r as f64);
        math::lerp(math::lerp(at(r, c), at(r, c1), fx), math::lerp(at(r1, c), at(r1, c1), fx), fy)
    }
}

impl<D: Dimension> Serialize for Varying<D> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = match self {
            Self::Uniform(q) => return q.serialize(serializer),
            _ => serializer.serialize_map(None)?,
        };
        match self {
            Self::Uniform(_) => {}
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
            Self::Field { name, unit } => {
                map.serialize_entry("field", name)?;
                map.serialize_entry("unit", unit)?;
            }
        }
        map.end()
    }
}

const KEYS: &[&str] = &["image", "black", "white", "raster", "formula", "field", "unit"];

impl<'de, D: Dimension> Deserialize<'de> for Varying<D> {
    fn deserialize<De: Deserializer<'de>>(deserializer: De) -> Result<Self, De::Error> {
        deserializer.deserialize_any(VaryingVisitor(PhantomData))
    }
}

struct VaryingVisitor<D>(PhantomData<D>);

impl<'de, D: Dimension> Visitor<'de> for VaryingVisitor<D> {
    type Value = Varying<D>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a {} such as \"{}\", or a table with `image`, `raster`, `formula` or `field`", D::NAME, D::EXAMPLE)
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
                "unit" => {
                    let unit: String = map.next_value()?;
                    unit_factor::<D>(&unit).map_err(de::Error::custom)?;
                    parts.unit = Some(unit);
                }
                other => return Err(de::Error::unknown_field(other, KEYS)),
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
}

impl<D: Dimension> Default for Parts<D> {
    fn default() -> Self {
        Self { image: None, black: None, white: None, raster: None, formula: None, field: None, unit: None }
    }
}

impl<D: Dimension> Parts<D> {
    fn build<E: de::Error>(self) -> Result<Varying<D>, E> {
        let given = usize::from(self.image.is_some())
            + usize::from(self.raster.is_some())
            + usize::from(self.formula.is_some())
            + usize::from(self.field.is_some());
        if given != 1 {
            return Err(E::custom(format!(
                "{given} of `image`, `raster`, `formula`, `field` given; expected exactly one"
            )));
        }
        if self.image.is_none() && (self.black.is_some() || self.white.is_some()) {
            return Err(E::custom("`black` and `white` go with `image`"));
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
            ],
            "x-unit": D::UNIT, "x-dimension": D::NAME, "x-example": D::EXAMPLE, "x-varying": true
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::units::RateDimension;

    type Rate = Varying<RateDimension>;

    fn read(json: &str) -> Result<Rate, String> {
        serde_json::from_str(json).map_err(|e| e.to_string())
    }

    #[test]
    fn the_five_shapes_are_read_and_written_back() {
        for json in [
            r#""0.4 mm/yr""#,
            r#"{"image":"a.png","black":"0 mm/yr","white":"0.4 mm/yr"}"#,
            r#"{"raster":"a.tif","unit":"mm/yr"}"#,
            r#"{"formula":"0.4*(1 - r)","unit":"mm/yr"}"#,
            r#"{"field":"uplift","unit":"mm/yr"}"#,
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
            (r#""0.4 m""#, "wrong dimension"),
            ("true", "expected a rate such as \"0.4 mm/yr\", or a table"),
        ] {
            let error = read(json).unwrap_err();
            assert!(error.contains(message), "{json}: {error}");
        }
    }

    #[test]
    fn a_formula_is_evaluated_on_the_nodes() {
        let terrain = HeightField::new(Grid::new(Shape::new(3, 5), [10.0, 10.0]).unwrap(), vec![2.0; 15]).unwrap();
        let context = Context { seed: Seed(1), maps: &NoMaps };
        let rate = read(r#"{"formula":"u + z","unit":"mm/yr"}"#).unwrap();
        let values = rate.resolve("rate", &terrain, &context).unwrap();
        assert!((values.at(4) / crate::units::MM_PER_YEAR - 3.0).abs() < 1e-12);
        let bad = read(r#"{"formula":"1/(u - u)","unit":"mm/yr"}"#).unwrap();
        assert!(bad.resolve("rate", &terrain, &context).unwrap_err().to_string().contains("`rate` is not a number"));
        let missing = read(r#"{"field":"uplift"}"#).unwrap();
        assert!(missing.resolve("rate", &terrain, &context).is_err());
    }

    #[test]
    fn an_image_is_stretched_from_edge_to_edge() {
        let image = Image { rows: 2, cols: 2, values: vec![0.0, 1.0, 0.5, 0.25] };
        assert_eq!(image.at(0.0, 1.0), 0.0);
        assert_eq!(image.at(1.0, 1.0), 1.0);
        assert_eq!(image.at(0.0, 0.0), 0.5);
        assert_eq!(image.at(0.5, 1.0), 0.5);
    }
}
