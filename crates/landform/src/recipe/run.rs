//! Running a recipe.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use landform_core::stage::Verb;
use landform_core::terrain::{AnyTerrain, HeightField, Representation};
use landform_core::verb::{Context, Event, Landscape, Outcome, Output};
use landform_core::{Error, Result};

use super::cache::Cache;
use super::checkpoint::{Checkpoint, check_undamaged, tidy};
use super::entry::{Entry, Work};
use super::evolve::{Evolving, Run};
use super::look::{Left, Looker};
use super::options::{Options, Outputs, Signal};
use super::watch::Watch;
use super::{Plan, Recipe};

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
        let mut runner =
            Runner { recipe: self, options, cache: options.cache, damaged: Default::default(), kept: None };
        self.notes.iter().for_each(|note| runner.note(note.clone()));
        let mut plan = self.plan(options.cache, &options.salt)?;
        plan.stages.iter().flat_map(|stage| &stage.notes).for_each(|note| runner.note(note.clone()));
        runner.kept = runner.find_kept(&plan)?;
        loop {
            runner.tell_notes();
            let ran = runner.run(&plan, out);
            // A terrain that seemed cached cannot be read: it is removed and made again.
            match runner.damaged.take() {
                Some((key, why)) => {
                    runner.note(format!("cache: {why}; the stage is run again"));
                    options.cache.iter().for_each(|c| c.forget(&key));
                    plan = self.plan(options.cache, &options.salt)?;
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
    /// What an earlier run left of a stage of this recipe.
    kept: Option<Kept>,
}

/// The state of a stage that an interrupted run left.
struct Kept {
    /// Index of the stage.
    stage: usize,
    /// Steps up to which it is worth more than the state of a run that begins anew.
    ahead: u64,
}

impl Runner<'_> {
    fn run(&self, plan: &Plan, out: &mut dyn Output) -> Result<Ran> {
        let mut current = Slot::default();
        let mut labelled: BTreeMap<&str, Slot> = BTreeMap::new();
        let of = self.recipe.entries.len();
        for (k, (entry, planned)) in self.recipe.entries.iter().zip(&plan.stages).enumerate() {
            let fail = |source| entry.failed(k, source);
            if let Some(slot) = entry.from.as_deref().and_then(|f| labelled.get(f)) {
                current = slot.clone();
            }
            // Files that are written on the way are not in the cache.
            let watched = self.watch_of(entry).is_some();
            let looked = matches!(entry.work, Work::Evolve(_)) && self.options.look.is_some_and(|look| look.wants(k));
            let known = if planned.cached && !watched && !looked && !self.is_changed() {
                self.known(&planned.key, &current)
            } else {
                None
            };
            (self.options.progress)(Signal::Stage {
                index: k + 1,
                of,
                name: planned.name.clone(),
                cached: known.is_some(),
                timeless: entry.work.is_timeless(),
            });
            if self.options.cancel.is_cancelled() {
                return Ok(Ran::Interrupted(None));
            }
            if let Some(slot) = known {
                current = slot;
                self.tell_known(k, entry, &mut current).map_err(fail)?;
            } else if !entry.work.changes_terrain() {
                if !self.options.outputs.has(entry.work.verb()) {
                    continue;
                }
                let terrain = self.terrain(&mut current).map_err(fail)?;
                match self.report(entry, &terrain, &current.history, out) {
                    // One measure that finds nothing to measure does not end a sweep.
                    Err(e) if self.options.outputs == Outputs::Measures => {
                        self.note(format!("`{}`: {e}", entry.name));
                    }
                    told => told.map_err(fail)?,
                }
                out.take_notes().into_iter().for_each(|note| self.note(note));
            } else {
                let mut with = Vec::new();
                for label in &entry.with {
                    if let Some(slot) = labelled.get_mut(label.as_str()) {
                        with.push((label.clone(), self.terrain(slot).map_err(fail)?));
                    }
                }
                match self.change(k, entry, &mut current, &with, &planned.key, out).map_err(fail)? {
                    Some(slot) => current = slot,
                    None => return Ok(Ran::Interrupted(self.options.checkpoint.clone().filter(|path| path.is_file()))),
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

    /// Tells what looks on of processes whose ground was in the cache.
    fn tell_known(&self, stage: usize, entry: &Entry, slot: &mut Slot) -> Result<()> {
        let (Some(look), Work::Evolve(_)) = (self.options.look, &entry.work) else { return Ok(()) };
        let ended = slot.history.last().and_then(|event| event.outcome).map(|o| (o.time, o.steps));
        let ((time, steps), ground) = (ended.unwrap_or_default(), self.terrain(slot)?);
        look.ended(stage, &|| Left { ground: ground.clone(), time, steps });
        Ok(())
    }

    /// Whether what looks on has changed the ground, so that it is no longer what its key says.
    fn is_changed(&self) -> bool {
        self.options.look.is_some_and(Looker::has_changed_it)
    }

    /// Tells what readers of files noted.
    fn tell_notes(&self) {
        self.recipe.file_notes().into_iter().for_each(|note| self.note(note));
    }

    fn note(&self, text: impl Into<String>) {
        (self.options.progress)(Signal::Note(text.into()));
    }

    /// What an earlier run left of a stage that is to run; says where it is, or why it is of no
    /// use.
    fn find_kept(&self, plan: &Plan) -> Result<Option<Kept>> {
        let resume = self.options.resume;
        self.options.checkpoint.as_deref().into_iter().for_each(tidy);
        let Some(path) = self.options.checkpoint.as_deref().filter(|path| path.is_file()) else {
            if resume {
                self.note("there is no checkpoint to go on from; what is not in the cache starts afresh");
            }
            return Ok(None);
        };
        let entries = self.recipe.entries.iter().zip(&plan.stages).enumerate();
        let found = entries
            .filter(|(_, (entry, planned))| !planned.cached || self.watch_of(entry).is_some())
            .map(|(k, (entry, planned))| (k, planned, Checkpoint::new(path, &planned.key, self.watch_of(entry))))
            .find(|(.., checkpoint)| checkpoint.is_there());
        match found {
            Some((stage, ..)) if resume => Ok(Some(Kept { stage, ahead: 0 })),
            Some((stage, planned, checkpoint)) => Ok(checkpoint.steps().map(|ahead| {
                let place = format!("{} (stage {}, `{}`, step {ahead})", path.display(), stage + 1, planned.name);
                let how = "this run starts the stage afresh; to go on from there, stop it and run with --resume";
                self.note(format!("there is a checkpoint of this recipe, {place}; {how}"));
                Kept { stage, ahead }
            })),
            None => {
                if resume {
                    check_undamaged(path)?;
                    self.note("the checkpoint is of another stage or recipe; what is not in the cache starts afresh");
                }
                Ok(None)
            }
        }
    }

    /// Where the state of a stage is kept, if it is; that of a later stage is worth more and left
    /// alone.
    fn checkpoint<'k>(&'k self, stage: usize, key: &'k str, watch: Option<&Watch>) -> Option<Checkpoint<'k>> {
        let new = || Some(Checkpoint::new(self.options.checkpoint.as_deref()?, key, watch));
        match &self.kept {
            Some(kept) if kept.stage > stage => None,
            Some(kept) if kept.stage == stage => new().map(|checkpoint| checkpoint.keep_until(kept.ahead)),
            _ => new(),
        }
    }

    /// What is watched of a stage in this run.
    fn watch_of<'e>(&self, entry: &'e Entry) -> Option<&'e Watch> {
        entry.work.watch().filter(|_| self.options.outputs == Outputs::All)
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
        index: usize,
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
                let (recipe, options, watch) = (self.recipe, self.options, self.watch_of(entry));
                let checkpoint = self.checkpoint(index, key, watch);
                let Some(coarser) = recipe.coarser_levels(index, options)? else { return Ok(None) };
                let run = Run { recipe, options, evolve, stage: index, watch, seed };
                let evolving = Evolving { run, coarser, checkpoint, out };
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
        if let Some(cache) = self.cache.filter(|_| !self.is_changed())
            && let Err(e) = cache.store(key, &terrain, &event)
        {
            self.note(format!("cache: {e}; the run goes on without it"));
        }
        // Only now is nothing lost without it.
        self.checkpoint(index, key, None).iter().for_each(Checkpoint::remove);
        let mut history = std::mem::take(&mut current.history);
        if entry.work.verb() == Verb::Generate {
            history.clear();
        }
        history.push(event);
        Ok(Some(Slot { key: key.into(), terrain: Some(terrain), history }))
    }

    fn report(&self, entry: &Entry, terrain: &AnyTerrain, history: &[Event], out: &mut dyn Output) -> Result<()> {
        let Work::Once(stage) = &entry.work else { return Ok(()) };
        let terrain = &*self.shown(terrain)?;
        let mut landscape = Landscape::plain(terrain);
        landscape.environment = &self.recipe.environment;
        (landscape.history, landscape.seed, landscape.title) = (history, self.recipe.seed, &self.recipe.title);
        stage.report(&landscape, out)
    }
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
