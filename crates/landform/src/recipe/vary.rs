//! The same recipe many times: seeds, and values of keys.

use std::sync::Arc;
use std::time::Instant;

use landform_core::analysis::{Hypsometry, SlopeArea, Summary};
use landform_core::grid::Shape;
use landform_core::terrain::{AnyTerrain, Body, Surface, Visit, not_a_surface};
use landform_core::verb::{CancelToken, Landscape, Measure, MemoryOutput, Outcome};
use landform_core::{Error, Result, parallel};
use landform_io::export::WritePicture;
use landform_io::measure::{MeasureSummary, Measured};
use landform_io::render::Picture;

use super::watch::draw;
use super::{Cache, Options, Outputs, Override, Ran, Recipe};

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
        Ok(Self { key: key.trim().into(), values })
    }
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

/// One run of a sweep.
#[derive(Clone, Debug)]
pub struct Row {
    /// Seed.
    pub seed: u64,
    /// Values, in the order of the keys.
    pub values: Vec<String>,
    /// How the last processes ended, if there were any.
    pub outcome: Option<Outcome>,
    /// Elevations and slopes.
    pub summary: Summary,
    /// Hypsometry: the area of ground at each height.
    pub hypsometry: Hypsometry,
    /// Slope against drainage area.
    pub slope_area: SlopeArea,
    /// Numbers of the recipe's measures: the stage's label or name and the path of the number, and
    /// its value.
    pub measures: Vec<(String, f64)>,
    /// Wall-clock time, s.
    pub seconds: f64,
    /// The landscape, if it was to be kept.
    pub terrain: Option<Arc<AnyTerrain>>,
}

/// Greatest number of runs of a sweep.
const MOST_RUNS: usize = 10_000;
/// Bytes of terrains that runs share.
const MOST_MEMORY: u64 = 1 << 30;

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
        let recipes =
            runs.iter().map(|(seed, values)| load(&self.overrides(*seed, values)?)).collect::<Result<Vec<_>>>()?;
        if let Some(kind) = own.entries.last().and_then(|entry| entry.kind).filter(|kind| !kind.is_surface()) {
            return Err(not_a_surface(kind, "the table of a sweep"));
        }
        let mut bytes = 0;
        for recipe in &recipes {
            bytes = recipe.plan(None, "")?.bytes.max(bytes);
        }
        let room = memory.map_or(usize::MAX, |m| (m / bytes.max(1)) as usize);
        let at_once = room.clamp(1, parallel::threads());
        // Stages before the first that is varied are run once.
        let cache = Cache::in_memory(memory.map_or(MOST_MEMORY, |m| (m / 8).min(MOST_MEMORY)));
        let mut rows = Vec::with_capacity(runs.len());
        for first in (0..runs.len()).step_by(at_once) {
            let batch = parallel::run_all((first..(first + at_once).min(runs.len())).collect(), |k: usize| {
                let row = self.one(&recipes[k], &runs[k], &cache, cancel)?;
                done(k, &row);
                Ok(row)
            });
            for row in batch {
                match row {
                    Ok(row) => rows.push(row),
                    Err(e) => return Ok((rows, Some(e))),
                }
            }
        }
        Ok((rows, None))
    }

    /// One run; an error says which.
    fn one(&self, recipe: &Recipe, run: &(u64, Vec<String>), cache: &Cache, cancel: &CancelToken) -> Result<Row> {
        let row = one(recipe, run, cache, cancel).map_err(|e| match e {
            Error::Interrupted => e,
            e => {
                let values = self.over.iter().zip(&run.1).map(|(o, v)| format!(", {}={v}", o.key));
                let what = format!("seed {}{}: {e}", run.0, values.collect::<String>());
                Error::Recipe { at: None, what, hint: e.hint() }
            }
        })?;
        Ok(if self.keep { row } else { Row { terrain: None, ..row } })
    }

    fn overrides(&self, seed: u64, values: &[String]) -> Result<Vec<Override>> {
        let mut overrides = vec![Override::parse(&format!("seed={seed}"))?];
        for (over, value) in self.over.iter().zip(values) {
            overrides.push(Override::parse(&format!("{}={value}", over.key))?);
        }
        Ok(overrides)
    }
}

fn one(recipe: &Recipe, (seed, values): &(u64, Vec<String>), cache: &Cache, cancel: &CancelToken) -> Result<Row> {
    let started = Instant::now();
    let options =
        Options { cache: Some(cache), cancel: cancel.clone(), outputs: Outputs::Measures, ..Options::default() };
    let mut told = MemoryOutput::default();
    let Ran::ToTheEnd(terrain, history) = recipe.run(&mut told, &options)? else {
        return Err(Error::Interrupted);
    };
    let seconds = started.elapsed().as_secs_f64();
    let Measured { summary, hypsometry, slope_area, .. } = terrain.visit(Summing)?;
    let outcome = history.iter().rev().find_map(|e| e.outcome);
    let (terrain, measures) = (Some(terrain), recipe.numbers(&told));
    Ok(Row {
        measures,
        seed: *seed,
        values: values.clone(),
        outcome,
        summary,
        hypsometry,
        slope_area,
        seconds,
        terrain,
    })
}

/// The numbers of a run's end.
struct Summing;

impl Visit for Summing {
    type Out = Result<Measured>;
    fn surface<T: Surface>(self, terrain: &T) -> Result<Measured> {
        MeasureSummary::default().measure(&Landscape::plain(terrain))
    }

    fn body<T: Body>(self, _: &T) -> Self::Out {
        Err(not_a_surface(T::KIND, "the table of a sweep"))
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
