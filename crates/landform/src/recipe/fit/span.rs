//! A key and the range in which its value is searched.

use landform_core::{Error, Result, math};

/// A key and the least and greatest value that it may take.
///
/// ```
/// use landform::recipe::Span;
///
/// let rate = Span::parse("uplift.rate=0.1..1 mm/yr")?;
/// assert_eq!((rate.low, rate.high, rate.unit.as_str()), (0.1, 1.0, "mm/yr"));
/// assert!(Span::parse("uplift.rate=1 mm/yr..0.1 mm/yr").is_err());
/// # Ok::<(), landform::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// `STAGE.key`.
    pub key: String,
    /// Least value, a number of units.
    pub low: f64,
    /// Greatest value, a number of units.
    pub high: f64,
    /// Unit of both; empty for none.
    pub unit: String,
}

/// Ratio of the ends from which a range is searched by equal ratios rather than differences.
const WIDE: f64 = 10.0;

impl Span {
    /// Reads `STAGE.key=LO..HI`; a unit stands after each number, or after the second for both.
    ///
    /// ```
    /// use landform::recipe::Span;
    ///
    /// assert_eq!(Span::parse("noise.hurst=0.5..1")?.high, 1.0);
    /// assert!(Span::parse("noise.hurst=0.5,1").is_err());
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Recipe`] without a key, `..` or two numbers, with two units, or where LO is not
    /// less than HI.
    pub fn parse(text: &str) -> Result<Self> {
        let fail = |what: &str| Error::Recipe {
            at: None,
            what: format!("`--over {text}` {what}"),
            hint: Some("write --over STAGE.key=LO..HI, for example --over \"uplift.rate=0.1 mm/yr..1 mm/yr\"".into()),
        };
        let (key, range) = text.split_once('=').ok_or_else(|| fail("is not understood"))?;
        let (low, high) = range.split_once("..").ok_or_else(|| fail("is no range"))?;
        if !key.contains('.') {
            return Err(fail("names no stage and key"));
        }
        let number = |end: &str| quantity(end).ok_or_else(|| fail(&format!("has no number in `{}`", end.trim())));
        let ((low, own), (high, unit)) = (number(low)?, number(high)?);
        if !own.is_empty() && own != unit {
            let second = if unit.is_empty() { "none".into() } else { format!("`{unit}`") };
            return Err(fail(&format!("has unit `{own}` at one end and {second} at the other; expected one unit")));
        }
        if !(low < high) {
            return Err(fail(&format!("goes from {low} to {high}; expected LO less than HI")));
        }
        Ok(Self { key: key.trim().into(), low, high, unit })
    }

    /// The value at a part of the way, 0 to 1, in six digits; wide ranges above 0 are gone through
    /// by ratios.
    pub(super) fn at(&self, part: f64, is_whole: bool) -> String {
        let Self { low, high, .. } = *self;
        let value = if low > 0.0 && high / low >= WIDE {
            math::exp(math::lerp(math::log(low), math::log(high), part))
        } else {
            math::lerp(low, high, part)
        };
        let value = if is_whole { value.round() } else { format!("{value:.5e}").parse().unwrap_or(value) };
        self.text(value.clamp(low, high))
    }

    /// Whether both ends are whole numbers without unit.
    pub(super) fn may_be_whole(&self) -> bool {
        self.unit.is_empty() && self.low.fract() == 0.0 && self.high.fract() == 0.0
    }

    /// A value as it is typed in a recipe.
    pub(super) fn text(&self, value: f64) -> String {
        let is_plain = value == 0.0 || (1e-4..1e7).contains(&value.abs());
        let number = if is_plain { format!("{value}") } else { format!("{value:e}") };
        if self.unit.is_empty() { number } else { format!("{number} {}", self.unit) }
    }
}

/// A number and the unit after it.
fn quantity(text: &str) -> Option<(f64, String)> {
    let text = text.trim();
    let ends = text.char_indices().map(|(i, c)| i + c.len_utf8()).rev();
    let number = |end: usize| Some((text[..end].parse::<f64>().ok().filter(|v| v.is_finite())?, end));
    let (value, end) = ends.into_iter().find_map(number)?;
    Some((value, text[end..].trim().to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_with_their_units() {
        for (text, low, high, unit) in [
            ("a.b=0.1..1", 0.1, 1.0, ""),
            ("a.b=-5 m..5 m", -5.0, 5.0, "m"),
            ("a.b=5e-7..1e-5 1/yr", 5e-7, 1e-5, "1/yr"),
            ("a.b=20deg..35deg", 20.0, 35.0, "deg"),
        ] {
            assert_eq!(Span::parse(text).unwrap(), Span { key: "a.b".into(), low, high, unit: unit.into() });
        }
        for text in ["a.b", "a.b=1", "ab=1..2", "a.b=2..1", "a.b=1..1", "a.b=1 m..2 km", "a.b=1 m..2", "a.b=x..2"] {
            let error = Span::parse(text).unwrap_err();
            assert!(error.hint().is_some() && error.to_string().contains(text), "{error}");
        }
    }

    #[test]
    fn places_are_values_in_six_digits() {
        let span = Span::parse("a.b=0..1000 m").unwrap();
        assert_eq!([span.at(0.0, false), span.at(1.0 / 3.0, false)], ["0 m", "333.333 m"]);
        let wide = Span::parse("a.b=1e-7..1e-5 1/yr").unwrap();
        assert_eq!(wide.at(0.5, false), "1e-6 1/yr");
        let whole = Span::parse("a.b=1..9").unwrap();
        assert!(whole.may_be_whole());
        assert_eq!(whole.at(0.3, true), "3");
    }
}
