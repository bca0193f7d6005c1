//! Units, and quantities as people type them.
//!
//! Inside everything is SI; a [`Quantity`] exists where a human writes or reads a number:
//! `"0.4 mm/yr"`, `"250 kyr"`, `"35 deg"`. Solvers call [`Quantity::si`] once and work in `f64`.
//!
//! A bare number is accepted only where no other unit than the stated one could be meant (metres
//! for lengths, the customary unit for erodibility, none for plain ratios). A bare `dt = 250` is
//! refused: seconds, years or thousands of years?
//!
//! ```
//! use landform_core::units::{Duration, Length, Rate, YEAR};
//!
//! let uplift = Rate::parse("0.4 mm/yr")?;
//! assert!((uplift.si() * 1_000.0 * YEAR - 0.4).abs() < 1e-12);
//! assert_eq!(Length::parse("2.5 km")?.si(), 2_500.0);
//! assert!(Duration::parse("250").is_err());
//! # Ok::<(), landform_core::Error>(())
//! ```

use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::ser::{Serialize, Serializer};

use crate::{Error, Result};

/// One Julian year in seconds.
pub const YEAR: f64 = 31_557_600.0;
/// A thousand years in seconds.
pub const KYR: f64 = 1e3 * YEAR;
/// A million years in seconds.
pub const MYR: f64 = 1e6 * YEAR;
/// A kilometre in metres.
pub const KM: f64 = 1e3;
/// One millimetre a year in m/s.
pub const MM_PER_YEAR: f64 = 1e-3 / YEAR;

/// What a [`Quantity`] measures: exponents of metre and second, and the unit that people expect.
pub trait Dimension: Clone + Copy + fmt::Debug + PartialEq + Send + Sync + 'static {
    /// What it is called: "length".
    const NAME: &'static str;
    /// Exponent of the metre.
    const METRES: i8;
    /// Exponent of the second.
    const SECONDS: i8;
    /// The customary unit, in which values are written back.
    const UNIT: &'static str;
    /// SI value of the customary unit.
    const UNIT_SI: f64;
    /// Whether a bare number is read in the customary unit.
    const BARE: bool;
    /// A good example for messages.
    const EXAMPLE: &'static str;
}

macro_rules! dimension {
    ($(#[$doc:meta])* $marker:ident, $alias:ident, $name:literal, $m:literal, $s:literal, $unit:literal, $si:expr, $bare:literal, $example:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $marker;
        impl Dimension for $marker {
            const NAME: &'static str = $name;
            const METRES: i8 = $m;
            const SECONDS: i8 = $s;
            const UNIT: &'static str = $unit;
            const UNIT_SI: f64 = $si;
            const BARE: bool = $bare;
            const EXAMPLE: &'static str = $example;
        }
        $(#[$doc])*
        pub type $alias = Quantity<$marker>;
    };
}

dimension!(/// Length, in metres.
    LengthDimension, Length, "length", 1, 0, "m", 1.0, true, "50 m");
dimension!(/// Area, in m².
    AreaDimension, Area, "area", 2, 0, "m2", 1.0, true, "1 km2");
dimension!(/// Time, in seconds; written in years.
    DurationDimension, Duration, "time", 0, 1, "yr", YEAR, false, "250 kyr");
dimension!(/// Velocity, such as uplift, in m/s; written in mm/yr.
    RateDimension, Rate, "rate", 1, -1, "mm/yr", MM_PER_YEAR, false, "0.4 mm/yr");
dimension!(/// Diffusivity, in m²/s; written in m²/yr.
    DiffusivityDimension, Diffusivity, "diffusivity", 2, -1, "m2/yr", 1.0 / YEAR, false, "0.01 m2/yr");
dimension!(
    /// Erodibility of the stream-power law. Its true unit is m^(1-2m)/yr for area exponent m (and
    /// slope exponent 1); it is written `1/yr` with lengths in metres, and a bare number is read
    /// the same way.
    ErodibilityDimension, Erodibility, "erodibility", 0, -1, "1/yr", 1.0 / YEAR, true, "5.6e-7 1/yr");
dimension!(/// Angle, in radians; written in degrees.
    AngleDimension, Angle, "angle", 0, 0, "deg", std::f64::consts::PI / 180.0, false, "35 deg");
dimension!(/// Discharge of a spring or a river, in m³/s.
    DischargeDimension, Discharge, "discharge", 3, -1, "m3/s", 1.0, true, "2 m3/s");
dimension!(/// Attenuation: the part by which light or waves lose strength over a length, in 1/m.
    AttenuationDimension, Attenuation, "attenuation", -1, 0, "1/m", 1.0, true, "0.1 1/m");
dimension!(/// A plain number.
    RatioDimension, Ratio, "number", 0, 0, "1", 1.0, true, "0.5");

/// The values of a dimension that people use, in its customary unit, over decades; none where that
/// follows from the parameter.
pub(crate) fn soft_range(dimension: &str) -> Option<[f64; 2]> {
    match dimension {
        "erodibility" => Some([1e-8, 1e-3]),
        "diffusivity" => Some([1e-4, 10.0]),
        _ => None,
    }
}

/// A number with a unit: reads `"0.02 m2/yr"`, refuses the wrong dimension, writes back in the
/// customary unit.
#[derive(Clone, Copy, PartialEq)]
pub struct Quantity<D: Dimension> {
    si: f64,
    dimension: PhantomData<D>,
}

impl<D: Dimension> Quantity<D> {
    /// From an SI value.
    pub const fn from_si(si: f64) -> Self {
        Self { si, dimension: PhantomData }
    }

    /// From a value in the customary unit ([`Dimension::UNIT`]).
    pub const fn of(value: f64) -> Self {
        Self::from_si(value * D::UNIT_SI)
    }

    /// The SI value.
    pub const fn si(self) -> f64 {
        self.si
    }

    /// The value in the customary unit.
    pub fn value(self) -> f64 {
        self.si / D::UNIT_SI
    }

    /// Reads a number with its unit.
    ///
    /// # Errors
    /// [`Error::Quantity`] if the text is no number, the unit is unknown, missing, or of another
    /// dimension.
    pub fn parse(text: &str) -> Result<Self> {
        let fail = |why: String| Error::Quantity { text: text.into(), expected: expected::<D>(), why };
        let (number, unit) = split_number(text).ok_or_else(|| fail("it does not start with a number".into()))?;
        if unit.is_empty() {
            return Self::bare(number).ok_or_else(|| fail("the unit is missing".into()));
        }
        let factor = unit_factor::<D>(unit).map_err(fail)?;
        let si = number * factor;
        if si.is_finite() { Ok(Self::from_si(si)) } else { Err(fail("it is not finite".into())) }
    }

    /// The customary unit's value for a bare number, where bare numbers are allowed.
    fn bare(number: f64) -> Option<Self> {
        (D::BARE || number == 0.0).then(|| Self::of(number))
    }
}

/// The SI factor of a unit of dimension `D`.
///
/// # Errors
/// If the unit is unknown or of another dimension; the error is a sentence that says which.
pub fn unit_factor<D: Dimension>(unit: &str) -> Result<f64, String> {
    let parsed = parse_unit(unit)?;
    let angle = D::NAME == "angle";
    if parsed.metres != D::METRES || parsed.seconds != D::SECONDS || parsed.angle != angle {
        return Err(format!("`{unit}` has the wrong dimension"));
    }
    Ok(parsed.factor)
}

/// A quantity as a number of a given unit; a bare number is one already.
///
/// ```
/// use landform_core::units::parse_as;
///
/// assert_eq!(parse_as("2 km", "m")?, 2000.0);
/// assert_eq!(parse_as("7", "deg")?, 7.0);
/// assert!(parse_as("2 kyr", "m").is_err());
/// # Ok::<(), landform_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Quantity`] if the text is no number, or has a unit that is unknown or of another
/// dimension.
pub fn parse_as(text: &str, unit: &str) -> Result<f64> {
    let fail = |why: String| Error::Quantity { text: text.into(), expected: format!("a quantity in {unit}"), why };
    let (number, given) = split_number(text).ok_or_else(|| fail("it does not start with a number".into()))?;
    let value = if given.is_empty() {
        number
    } else {
        let (from, to) = (parse_unit(given).map_err(fail)?, parse_unit(unit).map_err(fail)?);
        if (from.metres, from.seconds, from.angle) != (to.metres, to.seconds, to.angle) {
            return Err(fail(format!("`{given}` has the wrong dimension")));
        }
        number * from.factor / to.factor
    };
    if value.is_finite() { Ok(value) } else { Err(fail("it is not finite".into())) }
}

fn expected<D: Dimension>() -> String {
    format!(
        "{} {} such as \"{}\"",
        if D::NAME.starts_with('a') || D::NAME.starts_with('e') { "an" } else { "a" },
        D::NAME,
        D::EXAMPLE
    )
}

/// Splits "0.4 mm/yr" into number and unit.
fn split_number(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let is_end = |i: usize, c: char| {
        let exponent_sign = matches!(c, '+' | '-') && i > 0 && matches!(text.as_bytes()[i - 1], b'e' | b'E');
        let exponent = matches!(c, 'e' | 'E')
            && text[i + 1..].starts_with(|d: char| d.is_ascii_digit() || d == '+' || d == '-')
            && i > 0;
        !(c.is_ascii_digit() || c == '.' || c == '_' || exponent || exponent_sign || (i == 0 && matches!(c, '+' | '-')))
    };
    let end = text.char_indices().find(|&(i, c)| is_end(i, c)).map_or(text.len(), |(i, _)| i);
    let number = text[..end].replace('_', "").parse::<f64>().ok()?;
    Some((number, text[end..].trim()))
}

#[derive(Clone, Copy)]
struct Unit {
    factor: f64,
    metres: i8,
    seconds: i8,
    angle: bool,
}

const UNITS: &[(&str, f64, i8, i8, bool)] = &[
    ("m", 1.0, 1, 0, false),
    ("mm", 1e-3, 1, 0, false),
    ("cm", 1e-2, 1, 0, false),
    ("km", 1e3, 1, 0, false),
    ("um", 1e-6, 1, 0, false),
    ("ft", 0.3048, 1, 0, false),
    ("s", 1.0, 0, 1, false),
    ("min", 60.0, 0, 1, false),
    ("h", 3600.0, 0, 1, false),
    ("d", 86_400.0, 0, 1, false),
    ("day", 86_400.0, 0, 1, false),
    ("yr", YEAR, 0, 1, false),
    ("year", YEAR, 0, 1, false),
    ("years", YEAR, 0, 1, false),
    ("a", YEAR, 0, 1, false),
    ("kyr", KYR, 0, 1, false),
    ("ka", KYR, 0, 1, false),
    ("Myr", MYR, 0, 1, false),
    ("Ma", MYR, 0, 1, false),
    ("Gyr", 1e3 * MYR, 0, 1, false),
    ("Ga", 1e3 * MYR, 0, 1, false),
    ("deg", std::f64::consts::PI / 180.0, 0, 0, true),
    ("°", std::f64::consts::PI / 180.0, 0, 0, true),
    ("rad", 1.0, 0, 0, true),
    ("%", 0.01, 0, 0, false),
    ("1", 1.0, 0, 0, false),
];

fn parse_unit(text: &str) -> Result<Unit, String> {
    let mut unit = Unit { factor: 1.0, metres: 0, seconds: 0, angle: false };
    for (k, group) in text.split('/').enumerate() {
        let sign = if k == 0 { 1 } else { -1 };
        let mut empty = true;
        for factor in group.split(['*', '·', ' ']).filter(|f| !f.is_empty()) {
            empty = false;
            let (name, power) = split_power(factor)?;
            let &(_, si, metres, seconds, angle) =
                UNITS.iter().find(|u| u.0 == name).ok_or_else(|| unknown_unit(name))?;
            let power = power * sign;
            unit.factor *= if power >= 0 { powi(si, power) } else { 1.0 / powi(si, -power) };
            unit.metres += metres * power;
            unit.seconds += seconds * power;
            unit.angle |= angle;
        }
        if empty {
            return Err(format!("unit `{text}` is not complete"));
        }
    }
    Ok(unit)
}

fn powi(x: f64, n: i8) -> f64 {
    (0..n).fold(1.0, |product, _| product * x)
}

fn split_power(factor: &str) -> Result<(&str, i8), String> {
    for (mark, power) in [("²", 2), ("³", 3), ("⁻¹", -1)] {
        if let Some(name) = factor.strip_suffix(mark) {
            return Ok((name, power));
        }
    }
    if factor == "1" {
        return Ok((factor, 1));
    }
    let at = factor.find(|c: char| c.is_ascii_digit() || c == '^' || c == '-').unwrap_or(factor.len());
    let (name, power) = factor.split_at(at);
    let power = power.trim_start_matches('^');
    if power.is_empty() {
        return Ok((name, 1));
    }
    match power.parse::<i8>() {
        Ok(p) if p.abs() <= 4 => Ok((name, p)),
        _ => Err(format!("`{power}` is not a power")),
    }
}

fn unknown_unit(name: &str) -> String {
    if let Some(u) = UNITS.iter().find(|u| u.0.eq_ignore_ascii_case(name)) {
        return format!("unit `{name}` is not known; did you mean `{}`?", u.0);
    }
    format!("unit `{name}` is not known; known are m, mm, cm, km, ft, s, min, h, d, yr, kyr, Myr, deg, rad")
}

impl<D: Dimension> fmt::Debug for Quantity<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<D: Dimension> fmt::Display for Quantity<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", number_text(short(self.value())), D::UNIT)
    }
}

/// A number as people read it: with a power of ten where it would have many zeros.
///
/// ```
/// use landform_core::units::number_text;
///
/// assert_eq!([1250.5, 1e308, 1e-300].map(number_text), ["1250.5", "1e308", "1e-300"]);
/// ```
pub fn number_text(value: f64) -> String {
    let is_plain = value == 0.0 || !value.is_finite() || (1e-15..1e15).contains(&value.abs());
    if is_plain { value.to_string() } else { format!("{value:e}") }
}

/// A place on the map as people read it, m.
///
/// ```
/// use landform_core::units::place_text;
///
/// assert_eq!(place_text([1250.5, 1e20]), "1250.5, 1e20 m");
/// ```
pub fn place_text([x, y]: [f64; 2]) -> String {
    format!("{}, {} m", number_text(x), number_text(y))
}

/// The value without the noise that division by a unit leaves in the last digits.
fn short(value: f64) -> f64 {
    format!("{value:.12e}").parse().unwrap_or(value)
}

impl<D: Dimension> Serialize for Quantity<D> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if D::UNIT == "1" { serializer.serialize_f64(self.si) } else { serializer.collect_str(self) }
    }
}

impl<'de, D: Dimension> Deserialize<'de> for Quantity<D> {
    fn deserialize<De: Deserializer<'de>>(deserializer: De) -> Result<Self, De::Error> {
        struct V<D>(PhantomData<D>);
        impl<D: Dimension> Visitor<'_> for V<D> {
            type Value = Quantity<D>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(&expected::<D>())
            }
            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                Quantity::parse(text).map_err(E::custom)
            }
            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
                let fail = |why: &str| {
                    E::custom(Error::Quantity { text: value.to_string(), expected: expected::<D>(), why: why.into() })
                };
                if !value.is_finite() {
                    return Err(fail("it is not finite"));
                }
                Quantity::bare(value).ok_or_else(|| fail("the unit is missing"))
            }
            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }
            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
                self.visit_f64(value as f64)
            }
        }
        deserializer.deserialize_any(V(PhantomData))
    }
}

impl<D: Dimension> JsonSchema for Quantity<D> {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> std::borrow::Cow<'static, str> {
        D::NAME.into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let types: &[&str] = if D::BARE { &["string", "number"] } else { &["string"] };
        json_schema!({ "type": types, "x-unit": D::UNIT, "x-dimension": D::NAME, "x-example": D::EXAMPLE })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_many_digits_are_written_with_an_exponent() {
        assert_eq!(Length::of(1e308).to_string(), "1e308 m");
        assert_eq!(Length::of(-2.5e-300).to_string(), "-2.5e-300 m");
        assert_eq!(Length::of(120_000.0).to_string(), "120000 m");
        assert_eq!(Erodibility::of(5.6e-7).to_string(), "0.00000056 1/yr");
        assert_eq!(Length::parse(&Length::of(1e308).to_string()).unwrap(), Length::of(1e308));
    }

    #[test]
    fn quantities_are_read_with_their_units() {
        assert_eq!(Length::parse("32768 m").unwrap().si(), 32_768.0);
        assert_eq!(Length::parse("2.5km").unwrap().si(), 2_500.0);
        assert_eq!(Duration::parse("250 kyr").unwrap().si(), 2.5e5 * YEAR);
        assert!((Rate::parse("0.4 mm/yr").unwrap().si() - 4e-4 / YEAR).abs() < 1e-25);
        assert!((Diffusivity::parse("0.01 m²/yr").unwrap().si() - 0.01 / YEAR).abs() < 1e-24);
        assert_eq!(Diffusivity::parse("1 m^2/s").unwrap().si(), 1.0);
        assert!((Erodibility::parse("5.6e-7").unwrap().si() - 5.6e-7 / YEAR).abs() < 1e-28);
        assert!((Erodibility::parse("5.6e-7 1/yr").unwrap().si() - 5.6e-7 / YEAR).abs() < 1e-28);
        assert!((Angle::parse("35 deg").unwrap().si() - 0.610_865_238).abs() < 1e-8);
        assert_eq!(Rate::parse("0").unwrap().si(), 0.0);
    }

    #[test]
    fn wrong_quantities_say_what_is_wrong() {
        let why = |e: Result<Length>| e.unwrap_err().to_string();
        assert_eq!(why(Length::parse("5 yr")), "`5 yr` is not a length such as \"50 m\": `yr` has the wrong dimension");
        assert!(why(Length::parse("5 KM")).contains("did you mean `km`?"));
        assert!(why(Length::parse("many m")).contains("does not start with a number"));
        assert!(why(Length::parse("5 m/")).contains("not complete"));
        assert!(why(Length::parse("1e999 m")).contains("not finite"));
        assert!(why(Length::parse("5 m^99")).contains("not a power"));
        assert!(Duration::parse("250").unwrap_err().to_string().contains("the unit is missing"));
        assert!(Angle::parse("35").is_err() && Ratio::parse("35 deg").is_err());
    }

    #[test]
    fn what_is_written_is_read_back() {
        for q in [Rate::of(0.4), Rate::of(-1.0 / 3.0), Rate::of(1e-9)] {
            let back = Rate::parse(&q.to_string()).unwrap();
            assert!((back.si() - q.si()).abs() <= 1e-11 * q.si().abs());
        }
        assert_eq!(Rate::of(0.4).to_string(), "0.4 mm/yr");
        assert_eq!(Length::of(-1e308).to_string(), "-1e308 m");
        assert_eq!(Length::parse(&Length::of(2.5e17).to_string()).unwrap().si(), 2.5e17);
    }
}
