//! Running a recipe.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use landform_core::random::Seed;
use landform_core::sim::{Every, Model, Simulation};
use landform_core::stage::Verb;
use landform_core::terrain::{AnyTerrain, HeightField, Representation, Surface, Terrain, Visit};
use landform_core::verb::{CancelToken, Context, Event, Landscape, Outcome, Output, Stopped};
use landform_core::{Error, Result};
use landform_io::files::write_whole;

use super::cache::Cache;
use super::entry::{Entry, Evolve, Work};
use super::watch::{Watch, Watcher};
use super::{Plan, Recipe};

/// A signal of a run while it goes on.
#[derive(Clone, Debug, PartialEq)]
pub enum Signal {
    /// A stage begins.
    Stage {
        /// From 1.
        index: usize,
        /// Number of stages.
        of: usize,
        /// Name.
        name: String,
        /// Whether its terrain was in the cache, so that it is not run.
        cached: bool,
    },
    /// A step of a process was taken.
    Step {
        /// Steps taken.
        steps: u64,
        /// Time, s.
        time: f64,
        /// Part done, 0 to 1, if it is known.
        part: Option<f64>,
        /// Residual, if steadiness is watched.
        residual: Option<f64>,
    },
    /// Processes came to an end.
    Outcome(Outcome),
    /// A note to the user.
    Note(String),
}

/// Takes signals.
pub type Progress<'a> = dyn Fn(Signal) + Sync + 'a;

/// How to run.
pub struct Options<'a> {
    /// Terrains of earlier runs, and where those of this one are kept.
    pub cache: Option<&'a Cache>,
    /// Where the state of an interrupted stage is kept; nowhere if none.
    pub checkpoint: Option<PathBuf>,
    /// Goes on from the checkpoint if it fits.
    pub resume: bool,
    /// Seconds between checkpoints.
    pub checkpoint_every: f64,
    /// Part of the cache's keys that differs between builds of the program.
    pub salt: String,
    /// Asks the run to stop.
    pub cancel: CancelToken,
    /// Measures and files that the run makes beside the terrain.
    pub tells: Tells,
    /// Receives the signals of the run.
    pub progress: &'a Progress<'a>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            cache: None,
            checkpoint: None,
            resume: false,
            checkpoint_every: 60.0,
            salt: String::new(),
            cancel: CancelToken::default(),
            tells: Tells::All,
            progress: &|_| {},
        }
    }
}

/// What a run measures and writes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tells {
    /// All that the recipe says.
    #[default]
    All,
    /// Its measures alone.
    Measures,
    /// Nothing: only the terrain is wanted.
    Nothing,
}

impl Tells {
    fn has(self, verb: Verb) -> bool {
        match self {
            Self::All => true,
            Self::Measures => verb == Verb::Measure,
            Self::Nothing => false,
        }
    }
}

/// How a run ended.
#[derive(Debug)]
pub enum Ran {
    /// To the end; the terrain and its history.
    ToTheEnd(Arc<AnyTerrain>, Vec<Event>),
    /// The run was asked to stop; the checkpoint, if one was kept.
    Interrupted(Option<PathBuf>),
}

/// A terrain that may still be in the cache only.
#[derive(Clone, Default)]
struct Slot {
    key: String,
    terrain: Option<Arc<AnyTerrain>>,
    history: Vec<Event>,
}

impl Recipe {
    /// Runs all stages; exports go to `out`.
    ///
    /// # Errors
    /// [`Error::Stage`] if a stage fails, with the error of the stage.
    pub fn run(&self, out: &mut dyn Output, options: &Options) -> Result<Ran> {
        let runner = Runner { recipe: self, options, cache: options.cache, damaged: Default::default() };
        self.notes.iter().for_each(|note| (options.progress)(Signal::Note(note.clone())));
        loop {
            let plan = self.plan(options.cache, &options.salt)?;
            runner.tell_notes();
            let ran = runner.run(&plan, out);
            // A terrain that seemed cached cannot be read: it is removed and made again.
            match runner.damaged.take() {
                Some((key, why)) => {
                    (options.progress)(Signal::Note(format!("cache: {why}; the stage is run again")));
                    options.cache.iter().for_each(|c| c.forget(&key));
                }
                None => return ran,
            }
        }
    }
}

struct Runner<'a> {
    recipe: &'a Recipe,
    options: &'a Options<'a>,
    cache: Option<&'a Cache>,
    /// Key of a cached terrain that could not be read, and why.
    damaged: std::cell::RefCell<Option<(String, String)>>,
}

impl Runner<'_> {
    fn run(&self, plan: &Plan, out: &mut dyn Output) -> Result<Ran> {
        let mut current = Slot::default();
        let mut labelled: BTreeMap<&str, Slot> = BTreeMap::new();
        let of = self.recipe.entries.len();
        for (k, (entry, planned)) in self.recipe.entries.iter().zip(&plan.stages).enumerate() {
            let fail = |source| match source {
                done @ Error::Stage { .. } => done,
                source => Error::Stage {
                    index: k + 1,
                    name: entry.label.clone().unwrap_or(entry.name.clone()),
                    source: Box::new(source),
                },
            };
            if let Some(slot) = entry.from.as_deref().and_then(|f| labelled.get(f)) {
                current = slot.clone();
            }
            // Files that are written on the way are not in the cache.
            let watched = entry.work.watch().is_some() && self.watches();
            let known = if planned.cached && !watched { self.known(&planned.key, &current) } else { None };
            (self.options.progress)(Signal::Stage {
                index: k + 1,
                of,
                name: planned.name.clone(),
                cached: known.is_some(),
            });
            if self.options.cancel.is_cancelled() {
                return Ok(Ran::Interrupted(None));
            }
            if let Some(slot) = known {
                current = slot;
            } else if !entry.work.changes_terrain() {
                if !self.options.tells.has(entry.work.verb()) {
                    continue;
                }
                let terrain = self.terrain(&mut current).map_err(fail)?;
                match self.tell(entry, &terrain, &current.history, out) {
                    // One measure that finds nothing to measure does not end a sweep.
                    Err(e) if self.options.tells == Tells::Measures => {
                        (self.options.progress)(Signal::Note(format!("`{}`: {e}", entry.name)));
                    }
                    told => told.map_err(fail)?,
                }
            } else {
                let mut with = Vec::new();
                for label in &entry.with {
                    if let Some(slot) = labelled.get_mut(label.as_str()) {
                        with.push((label.clone(), self.terrain(slot).map_err(fail)?));
                    }
                }
                match self.change(entry, &mut current, &with, &planned.key, out).map_err(fail)? {
                    Some(slot) => current = slot,
                    None => return Ok(Ran::Interrupted(self.options.checkpoint.clone())),
                }
            }
            self.tell_notes();
            if let Some(label) = &entry.label {
                labelled.insert(label, current.clone());
            }
        }
        let terrain = self.terrain(&mut current)?;
        let terrain = match self.shown(&terrain)? {
            Cow::Borrowed(_) => terrain,
            Cow::Owned(window) => Arc::new(window),
        };
        Ok(Ran::ToTheEnd(terrain, current.history))
    }

    /// Tells what readers of files noted.
    fn tell_notes(&self) {
        self.recipe.file_notes().into_iter().for_each(|note| (self.options.progress)(Signal::Note(note)));
    }

    /// The part of a terrain that was asked for, without its margin.
    fn shown<'t>(&self, terrain: &'t AnyTerrain) -> Result<Cow<'t, AnyTerrain>> {
        let Some(window) = self.recipe.window else { return Ok(Cow::Borrowed(terrain)) };
        let field = terrain.get::<HeightField>("region")?;
        Ok(Cow::Owned(field.window(&window.of(field.grid(), 0.0)?)?.wrap()))
    }

    /// The slot of a cached key; its terrain is read when it is wanted.
    fn known(&self, key: &str, before: &Slot) -> Option<Slot> {
        let event = self.cache?.event(key).ok()?;
        let mut history = before.history.clone();
        history.push(event);
        Some(Slot { key: key.into(), terrain: None, history })
    }

    fn terrain(&self, slot: &mut Slot) -> Result<Arc<AnyTerrain>> {
        if let Some(terrain) = &slot.terrain {
            return Ok(terrain.clone());
        }
        let Some(cache) = self.cache.filter(|_| !slot.key.is_empty()) else {
            return Err(Error::Recipe { at: None, what: "there is no terrain yet".into(), hint: None });
        };
        let terrain = cache.terrain(&slot.key).inspect_err(|e| {
            self.damaged.replace(Some((slot.key.clone(), e.to_string())));
        })?;
        slot.terrain = Some(terrain.clone());
        Ok(terrain)
    }

    /// Runs a stage that changes the terrain; none if it was interrupted.
    fn change(
        &self,
        entry: &Entry,
        current: &mut Slot,
        with: &[(String, Arc<AnyTerrain>)],
        key: &str,
        out: &mut dyn Output,
    ) -> Result<Option<Slot>> {
        let environment = &*self.recipe.environment;
        let (seed, window) = (entry.seed, self.recipe.window);
        let context = Context { seed, maps: &*self.recipe.maps, environment, with, window, ..Context::default() };
        let mut outcome = None;
        let terrain = match &entry.work {
            Work::Evolve(evolve) => {
                let before = self.terrain(current)?;
                let evolving = Evolving { runner: self, evolve, seed: entry.seed, key, out };
                let Some((terrain, ended)) = before.visit(evolving)? else {
                    return Ok(None);
                };
                (self.options.progress)(Signal::Outcome(ended));
                outcome = Some(ended);
                terrain
            }
            Work::Once(stage) if stage.stage().verb == Verb::Generate => stage.apply(None, &context)?,
            Work::Once(stage) => stage.apply(Some(&*self.terrain(current)?), &context)?,
        };
        let (terrain, event) = (Arc::new(terrain), event(entry, outcome));
        if let Some(cache) = self.cache
            && let Err(e) = cache.store(key, &terrain, &event)
        {
            (self.options.progress)(Signal::Note(format!("cache: {e}; the run goes on without it")));
        }
        let mut history = std::mem::take(&mut current.history);
        if entry.work.verb() == Verb::Generate {
            history.clear();
        }
        history.push(event);
        Ok(Some(Slot { key: key.into(), terrain: Some(terrain), history }))
    }

    /// Whether what `watch` asks for is written.
    fn watches(&self) -> bool {
        self.options.tells == Tells::All
    }

    fn tell(&self, entry: &Entry, terrain: &AnyTerrain, history: &[Event], out: &mut dyn Output) -> Result<()> {
        let Work::Once(stage) = &entry.work else { return Ok(()) };
        let terrain = &*self.shown(terrain)?;
        let mut landscape = Landscape::plain(terrain);
        landscape.environment = &self.recipe.environment;
        (landscape.history, landscape.seed, landscape.title) = (history, self.recipe.seed, &self.recipe.title);
        stage.tell(&landscape, out)
    }

    fn evolve<T: Surface>(
        &self,
        terrain: T,
        evolve: &Evolve,
        seed: Seed,
        key: &str,
        out: &mut dyn Output,
    ) -> Result<Option<(AnyTerrain, Outcome)>> {
        let clock = &evolve.clock;
        let mut model = Model::new(terrain);
        for part in &evolve.parts {
            part.add_to(T::KIND, &mut model)?;
        }
        let model = model
            .dt(clock.step())
            .seed(seed)
            .maps(self.recipe.maps.clone())
            .environment(self.recipe.environment.clone())
            .cancel(self.options.cancel.clone());
        let watcher = evolve.watch.as_ref().filter(|_| self.watches()).map(|w| Watcher::new(w, clock.timeless));
        let watcher = std::sync::Mutex::new(watcher);
        let stop = clock.stop();
        let mut first_residual = None;
        let mut simulation = Simulation::of(model).until(stop).refine(clock.refine).observe(Every::Steps(1), |view| {
            let part = match (stop.time, stop.steady, view.residual) {
                (Some(end), ..) => Some(view.time / end),
                (None, Some(tolerance), Some(residual)) => {
                    let first = *first_residual.get_or_insert(residual);
                    let gone = |r: f64| landform_core::math::log(r.max(tolerance) / tolerance);
                    Some(1.0 - gone(residual) / gone(first).max(1e-9))
                }
                _ => None,
            };
            let part = match stop.steps {
                Some(most) => Some(part.unwrap_or(0.0).max(view.steps as f64 / most as f64)),
                None => part,
            };
            (self.options.progress)(Signal::Step { steps: view.steps, time: view.time, part, residual: view.residual });
            Ok(ControlFlow::Continue(()))
        });
        if let Some(watch) = evolve.watch.as_ref().filter(|_| self.watches()) {
            simulation = simulation.observe(watch.interval(), |view| match watcher.lock() {
                Ok(mut watcher) => watcher.as_mut().map_or(Ok(ControlFlow::Continue(())), |w| w.look(view)),
                Err(_) => Ok(ControlFlow::Break(())),
            });
        }
        if let Some(every @ Every::Time(_)) = evolve.watch.as_ref().filter(|_| !self.watches()).map(Watch::interval) {
            // Without an observer steps are as long as with one.
            simulation = simulation.observe(every, |_| Ok(ControlFlow::Continue(())));
        }
        if let Some(path) = &self.options.checkpoint {
            simulation = simulation.save_every(self.options.checkpoint_every, |model| save(model, key, path));
            if self.options.resume && path.is_file() {
                simulation = self.resume(simulation, key, path)?;
                if evolve.watch.is_some() {
                    let note = "what `watch` saw before the interruption is lost; it goes on from here";
                    (self.options.progress)(Signal::Note(note.into()));
                }
            }
        }
        let outcome = simulation.run()?;
        if outcome.stopped == Stopped::Cancelled {
            if let Some(path) = &self.options.checkpoint {
                save(simulation.model(), key, path)?;
            }
            return Ok(None);
        }
        if let Some(path) = &self.options.checkpoint {
            std::fs::remove_file(path).ok();
        }
        let terrain = simulation.into_terrain().wrap();
        if let Ok(Some(watcher)) = watcher.into_inner()
            && let Some(note) = watcher.finish(out)?
        {
            (self.options.progress)(Signal::Note(note.into()));
        }
        Ok(Some((terrain, outcome)))
    }

    fn resume<'s, T: Terrain>(
        &self,
        simulation: Simulation<'s, T>,
        key: &str,
        path: &Path,
    ) -> Result<Simulation<'s, T>> {
        let bytes = landform_io::files::read_whole(path)?;
        if landform_core::sim::is_for("checkpoint", key, &bytes) {
            return simulation.resume(key, &bytes);
        }
        (self.options.progress)(Signal::Note(
            "the checkpoint is of another stage or recipe; this stage starts afresh".into(),
        ));
        Ok(simulation)
    }
}

/// Runs processes on a terrain of any kind.
struct Evolving<'a, 'b> {
    runner: &'a Runner<'b>,
    evolve: &'a Evolve,
    seed: Seed,
    key: &'a str,
    out: &'a mut dyn Output,
}

impl Visit for Evolving<'_, '_> {
    type Out = Result<Option<(AnyTerrain, Outcome)>>;
    fn visit<T: Surface>(self, terrain: &T) -> Self::Out {
        self.runner.evolve(terrain.clone(), self.evolve, self.seed, self.key, self.out)
    }
}

fn save<T: Terrain>(model: &Model<T>, key: &str, path: &Path) -> Result<()> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|e| Error::io("create folder", folder, e))?;
    }
    write_whole(path, &model.save(key)?)
}

fn event(entry: &Entry, outcome: Option<Outcome>) -> Event {
    let parts = entry.work.parts();
    let sources = parts.iter().flat_map(|p| p.stage().sources).map(|s| [s.authors, s.title, s.doi].map(String::from));
    Event {
        stage: entry.label.as_ref().map_or(entry.name.clone(), |l| format!("{l} ({})", entry.name)),
        parameters: entry.work.normalized().to_string(),
        sources: sources.collect(),
        outcome,
    }
}
