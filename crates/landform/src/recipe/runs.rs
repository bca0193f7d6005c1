//! Runs of one recipe with different seeds and values of keys, which share their first stages.

use std::sync::Arc;
use std::time::Instant;

use landform_core::analysis::{Hypsometry, SlopeArea, Summary};
use landform_core::terrain::{AnyTerrain, Body, Surface, Visit, not_a_surface};
use landform_core::verb::{CancelToken, Landscape, Measure, MemoryOutput, Outcome};
use landform_core::{Error, Result, parallel};
use landform_io::measure::{MeasureSummary, Measured};

use super::{Cache, Options, Outputs, Override, Ran, Recipe};

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
    /// its value; NaN where it is null.
    pub measures: Vec<(String, f64)>,
    /// Wall-clock time, s.
    pub seconds: f64,
    /// The landscape, if it was to be kept.
    pub terrain: Option<Arc<AnyTerrain>>,
}

/// Bytes of terrains that runs share.
const MOST_MEMORY: u64 = 1 << 30;

/// A recipe whose keys take values, and what its runs have in common.
pub(super) struct Runs<'a, L> {
    keys: Vec<String>,
    load: L,
    memory: Option<u64>,
    /// Stages before the first that is varied are run once.
    cache: Cache,
    cancel: &'a CancelToken,
    /// Whether rows keep their landscapes.
    pub(super) keep: bool,
}

impl<'a, L: Fn(&[Override]) -> Result<Recipe> + Sync> Runs<'a, L> {
    /// Runs of a recipe, which is `own` without any values and which `load` reads with some, in so
    /// much memory (bytes).
    pub(super) fn new(
        keys: Vec<String>,
        own: &Recipe,
        load: L,
        memory: Option<u64>,
        cancel: &'a CancelToken,
    ) -> Result<Self> {
        if let Some(kind) = own.entries.last().and_then(|entry| entry.kind).filter(|kind| !kind.is_surface()) {
            return Err(not_a_surface(kind, "the table of a sweep"));
        }
        let cache = Cache::in_memory(memory.map_or(MOST_MEMORY, |m| (m / 8).min(MOST_MEMORY)));
        Ok(Self { keys, load, memory, cache, cancel, keep: false })
    }

    /// The recipe with a seed and values.
    pub(super) fn recipe(&self, seed: u64, values: &[String]) -> Result<Recipe> {
        let mut overrides = vec![Override::parse(&format!("seed={seed}"))?];
        for (key, value) in self.keys.iter().zip(values) {
            overrides.push(Override::parse(&format!("{key}={value}"))?);
        }
        (self.load)(&overrides)
    }

    /// Rows of runs, several at a time as far as memory and cores allow. `done` gets each run's
    /// number and row. An error that ends them early is returned beside the rows before it.
    pub(super) fn rows(
        &self,
        runs: &[(u64, Vec<String>)],
        done: impl Fn(usize, &Row) + Sync,
    ) -> Result<(Vec<Row>, Option<Error>)> {
        let recipes = runs.iter().map(|(seed, values)| self.recipe(*seed, values)).collect::<Result<Vec<_>>>()?;
        let mut bytes = 0;
        for recipe in &recipes {
            bytes = recipe.plan(None, "")?.bytes.max(bytes);
        }
        let room = self.memory.map_or(usize::MAX, |m| (m / bytes.max(1)) as usize);
        let at_once = room.clamp(1, parallel::threads());
        let mut rows = Vec::with_capacity(runs.len());
        for first in (0..runs.len()).step_by(at_once) {
            let batch = parallel::run_all((first..(first + at_once).min(runs.len())).collect(), |k: usize| {
                let row = self.one(&recipes[k], &runs[k])?;
                let row = if self.keep { row } else { Row { terrain: None, ..row } };
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
    fn one(&self, recipe: &Recipe, run: &(u64, Vec<String>)) -> Result<Row> {
        one(recipe, run, &self.cache, self.cancel).map_err(|e| match e {
            Error::Interrupted => e,
            e => {
                let values = self.keys.iter().zip(&run.1).map(|(key, v)| format!(", {key}={v}"));
                let what = format!("seed {}{}: {e}", run.0, values.collect::<String>());
                Error::Recipe { at: None, what, hint: e.hint() }
            }
        })
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
