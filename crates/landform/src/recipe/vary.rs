//! The same recipe many times: seeds, and values of keys.

use landform_core::grid::Shape;
use landform_core::verb::CancelToken;
use landform_core::{Error, Result, math};
use landform_io::export::WritePicture;
use landform_io::render::Picture;

use super::runs::{Row, Runs};
use super::watch::draw;
use super::{Override, Recipe};

/// A key and the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// `STAGE.key`.
    pub key: String,
    /// Values as typed.
    pub values: Vec<String>,
}

impl Axis {
    /// Reads `STAGE.key=a,b,c`; semicolons part the values where they hold commas themselves.
    /// `a..b:n` stands for n values from a to b with equal steps, `a..b:nlog` with equal ratios.
    ///
    /// ```
    /// use landform::recipe::Axis;
    ///
    /// let axis = Axis::parse("uplift.rate=0.1 mm/yr..0.3 mm/yr:3,1 mm/yr")?;
    /// assert_eq!(axis.values, ["0.1 mm/yr", "0.2 mm/yr", "0.3 mm/yr", "1 mm/yr"]);
    /// # Ok::<(), landform::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Recipe`] without `=`, key or values.
    pub fn parse(text: &str) -> Result<Self> {
        let fail = || Error::Recipe {
            at: None,
            what: format!("`--over {text}` is not understood"),
            hint: Some("write --over STAGE.key=a,b,c, for example --over \"uplift.rate=0.1 mm/yr,0.4 mm/yr\"".into()),
        };
        let (key, values) = text.split_once('=').ok_or_else(fail)?;
        let separator = if outside_brackets(values, ';').len() > 1 { ';' } else { ',' };
        let values = outside_brackets(values, separator);
        if !key.contains('.') || values.iter().any(String::is_empty) {
            return Err(fail());
        }
        let values = values.iter().map(|value| range(value)).collect::<Result<Vec<_>>>()?.concat();
        Ok(Self { key: key.trim().into(), values })
    }
}

/// A number and the unit after it.
fn quantity(text: &str) -> Option<(f64, &str)> {
    let (number, unit) = text.trim().split_once(char::is_whitespace).unwrap_or((text.trim(), ""));
    number.parse().ok().filter(|v: &f64| v.is_finite()).map(|v| (v, unit.trim()))
}

/// The values of `a..b:n` and `a..b:nlog`; any other text is a value itself.
fn range(text: &str) -> Result<Vec<String>> {
    let ends = text.split_once("..").and_then(|(from, rest)| {
        let (to, count) = rest.rsplit_once(':')?;
        Some((quantity(from)?, quantity(to)?, count.trim()))
    });
    let Some(((from, first_unit), (to, unit), count)) = ends else { return Ok(vec![text.into()]) };
    let wrong = |expected: &str| Err(Error::parameter("over", format!("`{text}`"), expected));
    if !first_unit.is_empty() && first_unit != unit {
        return wrong("one unit at both ends, as 0.1 mm/yr..0.5 mm/yr:5");
    }
    let (count, is_log) = count.strip_suffix("log").map_or((count, false), |count| (count.trim(), true));
    let Some(count) = count.parse::<usize>().ok().filter(|n| (2..=MOST_RUNS).contains(n)) else {
        return wrong("2 to 10,000 values, as 0.1 mm/yr..0.5 mm/yr:5, or :5log for equal ratios");
    };
    if is_log && !(from > 0.0 && to > 0.0) {
        return wrong("ends above 0 for equal ratios");
    }
    let value = |k: usize| {
        let part = k as f64 / (count - 1) as f64;
        let exact = if is_log { from * math::pow(to / from, part) } else { math::lerp(from, to, part) };
        // Twelve digits: 0.3, not 0.30000000000000004.
        let short = format!("{exact:.11e}").parse().unwrap_or(exact);
        format!("{short} {unit}").trim_end().to_string()
    };
    Ok((0..count).map(value).collect())
}

/// The parts of a text between separators that stand in no brackets and no quotes.
fn outside_brackets(text: &str, separator: char) -> Vec<String> {
    let (mut parts, mut depth, mut quoted) = (vec![String::new()], 0_i32, false);
    for c in text.chars() {
        match c {
            '"' => quoted = !quoted,
            '[' | '{' | '(' if !quoted => depth += 1,
            ']' | '}' | ')' if !quoted => depth -= 1,
            _ => {}
        }
        if c == separator && depth == 0 && !quoted {
            parts.push(String::new());
        } else if let Some(part) = parts.last_mut() {
            part.push(c);
        }
    }
    parts.into_iter().map(|p| p.trim().to_string()).collect()
}

/// Which runs to make: every combination of seeds and values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sweep {
    /// Seeds; the recipe's own if there are none.
    pub seeds: Vec<u64>,
    /// Keys and values; the last one changes fastest.
    pub over: Vec<Axis>,
    /// Whether rows keep their landscapes.
    pub keep: bool,
}

/// Greatest number of runs of a sweep.
const MOST_RUNS: usize = 10_000;

impl Sweep {
    /// Seeds and values of every run.
    ///
    /// # Errors
    /// [`Error::Parameter`] for more than 10,000 runs, or a key that is given twice.
    pub fn runs(&self, own_seed: u64) -> Result<Vec<(u64, Vec<String>)>> {
        for (k, over) in self.over.iter().enumerate() {
            if self.over[..k].iter().any(|o| o.key == over.key) {
                return Err(Error::parameter("over", format!("`{}` twice", over.key), "each key once"));
            }
        }
        let seeds = if self.seeds.is_empty() { vec![own_seed] } else { self.seeds.clone() };
        let count = self.over.iter().fold(seeds.len(), |n, o| n.saturating_mul(o.values.len()));
        if count > MOST_RUNS {
            return Err(Error::parameter("over", format!("{count} runs"), &format!("at most {MOST_RUNS}")));
        }
        let mut runs: Vec<(u64, Vec<String>)> = seeds.into_iter().map(|s| (s, Vec::new())).collect();
        for over in &self.over {
            runs = runs
                .into_iter()
                .flat_map(|(seed, before)| {
                    over.values.iter().map(move |v| {
                        let mut values = before.clone();
                        values.push(v.clone());
                        (seed, values)
                    })
                })
                .collect();
        }
        Ok(runs)
    }

    /// Runs a recipe, which `load` reads with the given overrides, once for each combination,
    /// several at a time as far as `memory` (bytes) and cores allow. Nothing is exported. `done`
    /// gets each run's number and row. An error that ends the sweep early is returned beside the
    /// rows that came before it.
    ///
    /// # Errors
    /// If a recipe cannot be read, before anything runs.
    pub fn run(
        &self,
        load: impl Fn(&[Override]) -> Result<Recipe> + Sync,
        memory: Option<u64>,
        cancel: &CancelToken,
        done: impl Fn(usize, &Row) + Sync,
    ) -> Result<(Vec<Row>, Option<Error>)> {
        let own = load(&[])?;
        let runs = self.runs(own.seed)?;
        let keys = self.over.iter().map(|over| over.key.clone()).collect();
        let mut together = Runs::new(keys, &own, load, memory, cancel)?;
        together.keep = self.keep;
        together.rows(&runs, done)
    }
}

/// Pictures side by side, each with its number in the corner, in rows that make the sheet about
/// square.
///
/// # Errors
/// [`Error::Parameter`] without rows, or where drawing fails.
pub fn contact_sheet(rows: &[Row], picture: &WritePicture, gap: usize) -> Result<Picture> {
    let pictures = rows.iter().flat_map(|r| &r.terrain).map(|t| draw(t, picture)).collect::<Result<Vec<_>>>()?;
    let greatest = |f: fn(&Picture) -> usize| pictures.iter().map(f).max();
    let (Some(width), Some(height)) = (greatest(|p| p.shape.cols), greatest(|p| p.shape.rows)) else {
        return Err(Error::parameter("sheet", "without runs", "at least one run"));
    };
    let across = ((pictures.len() * height) as f64 / width as f64).sqrt().ceil().max(1.0) as usize;
    let down = pictures.len().div_ceil(across);
    let shape = Shape::new(down * (height + gap) + gap, across * (width + gap) + gap);
    let mut sheet = Picture { shape, pixels: vec![[244, 243, 240]; shape.len()] };
    for (k, picture) in pictures.iter().enumerate() {
        let (top, left) = (gap + k / across * (height + gap), gap + k % across * (width + gap));
        for row in 0..picture.shape.rows {
            let from = picture.shape.index(row, 0);
            let to = shape.index(top + row, left);
            sheet.pixels[to..to + picture.shape.cols].copy_from_slice(&picture.pixels[from..from + picture.shape.cols]);
        }
        number(&mut sheet, [top + 4, left + 4], k + 1);
    }
    Ok(sheet)
}

/// Digits of 3 by 5 dots, a row in three bits.
const DIGITS: [[u8; 5]; 10] = [
    [7, 5, 5, 5, 7],
    [2, 6, 2, 2, 7],
    [7, 1, 7, 4, 7],
    [7, 1, 7, 1, 7],
    [5, 5, 7, 1, 1],
    [7, 4, 7, 1, 7],
    [7, 4, 7, 5, 7],
    [7, 1, 2, 2, 2],
    [7, 5, 7, 5, 7],
    [7, 5, 7, 1, 7],
];

/// Paints a number, dark on light, at a corner.
fn number(picture: &mut Picture, [top, left]: [usize; 2], value: usize) {
    const DOT: usize = 3;
    let text = value.to_string();
    let (rows, cols) = (7 * DOT, (4 * text.len() + 1) * DOT);
    let mut paint = |row: usize, col: usize, colour: [u8; 3]| {
        if top + row < picture.shape.rows && left + col < picture.shape.cols {
            let i = picture.shape.index(top + row, left + col);
            picture.pixels[i] = colour;
        }
    };
    for row in 0..rows {
        for col in 0..cols {
            paint(row, col, [250, 250, 248]);
        }
    }
    for (k, digit) in text.bytes().enumerate() {
        let dots = &DIGITS[usize::from(digit - b'0')];
        for row in 0..5 * DOT {
            for col in 0..3 * DOT {
                if dots[row / DOT] >> (2 - col / DOT) & 1 == 1 {
                    paint(row + DOT, col + DOT * (4 * k + 1), [40, 40, 44]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_values_at_equal_steps_or_ratios() {
        let values = |text: &str| Axis::parse(&format!("a.b={text}")).unwrap().values;
        assert_eq!(values("0.1 mm/yr..0.5 mm/yr:5").join(";"), "0.1 mm/yr;0.2 mm/yr;0.3 mm/yr;0.4 mm/yr;0.5 mm/yr");
        assert_eq!(values("1..3 km:2"), ["1 km", "3 km"]);
        assert_eq!(values("1e-6..1e-4:3log"), ["0.000001", "0.00001", "0.0001"]);
        assert_eq!(values("5..-5:3,7"), ["5", "0", "-5", "7"]);
        // Paths and what is no range stay as they are.
        assert_eq!(values("../map.tif"), ["../map.tif"]);
        for bad in ["1..2:1", "1..2:x", "1..2:10001", "1 m..2 km:3", "-1..1:3log"] {
            assert!(Axis::parse(&format!("a.b={bad}")).is_err(), "{bad}");
        }
    }
}
