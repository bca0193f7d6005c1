//! Running processes on their clock, with what is told, seen and kept on the way.

use std::ops::ControlFlow;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use landform_core::random::Seed;
use landform_core::sim::{Every, Model, Simulation, Stop, View};
use landform_core::stage::ReadStage;
use landform_core::terrain::{AnyTerrain, Body, Surface, Terrain, Visit, not_a_surface};
use landform_core::units::MYR;
use landform_core::verb::{Outcome, Output, Stopped};
use landform_core::{Error, Result};

use super::checkpoint::Checkpoint;
use super::entry::Evolve;
use super::look::{self, look};
use super::options::{Options, Progress, Signal};
use super::watch::{Watch, Watcher};
use super::{Level, Recipe};

/// Runs processes on a terrain of any kind; none if the run was interrupted.
pub(super) struct Evolving<'a, 'b> {
    pub(super) run: Run<'a, 'b>,
    /// Coarser levels on which it begins, coarsest first.
    pub(super) coarser: Vec<Coarser>,
    /// Where the state is kept.
    pub(super) checkpoint: Option<Checkpoint<'a>>,
    pub(super) out: &'a mut dyn Output,
}

/// A coarser level of a stage with processes.
pub(super) struct Coarser {
    /// Which it is.
    pub(super) level: Level,
    /// The ground before the stage.
    pub(super) ground: Arc<AnyTerrain>,
    /// The processes, for such cells.
    pub(super) parts: Vec<ReadStage>,
    /// Time until which it runs, s.
    pub(super) until: f64,
}

/// What processes run by, on every level.
#[derive(Clone, Copy)]
pub(super) struct Run<'a, 'b> {
    pub(super) recipe: &'a Recipe,
    pub(super) options: &'a Options<'b>,
    pub(super) evolve: &'a Evolve,
    /// The stage, from 0.
    pub(super) stage: usize,
    /// What is watched in this run.
    pub(super) watch: Option<&'a Watch>,
    pub(super) seed: Seed,
}

impl Visit for Evolving<'_, '_> {
    type Out = Result<Option<(AnyTerrain, Outcome)>>;

    fn surface<T: Surface>(self, terrain: &T) -> Self::Out {
        let Self { run, coarser, checkpoint, out } = self;
        let (clock, options) = (&run.evolve.clock, run.options);
        if let Some(settled) = run.go_on(terrain) {
            return settled;
        }
        let mut model = run.model(terrain, &run.evolve.parts)?;
        let resume = options.resume && checkpoint.as_ref().is_some_and(Checkpoint::is_there);
        let saves = checkpoint.is_some();
        let watcher = run.watch.map(|watch| Watcher::new(watch, &run.recipe.environment, clock.timeless));
        let beside = Mutex::new(Beside { watcher, checkpoint });
        if !resume && !coarser.is_empty() {
            model.start()?;
            let Some(coarse) = run.on_coarser(&coarser, model.terrain(), &beside)? else { return Ok(None) };
            model = model.begin_at(coarse.time, coarse.steps);
            model.start_changed(&coarse.before, &coarse.after)?;
            let at = coarse.time / MYR;
            let note = format!("volumes are counted since the last halving of cells, at {at:.3} Myr");
            (options.progress)(Signal::Note(note));
        }
        let mut simulation = Simulation::of(model).until(clock.stop());
        if clock.until.is_some() {
            simulation = simulation.refine(clock.refine);
        }
        simulation = run.observed(simulation, &beside, |view, beside| open(beside).look(view));
        if options.look.is_some() {
            simulation = simulation.between(|model| look(options.look, &mut look::Running(model)));
        }
        if saves {
            simulation = simulation.save_every(options.checkpoint_every, |model| open(&beside).save(model));
        }
        if resume {
            simulation = open(&beside).resume(simulation)?;
        }
        let outcome = simulation.run()?;
        if outcome.stopped == Stopped::Cancelled {
            open(&beside).save(simulation.model())?;
            return Ok(None);
        }
        run.tell_end(&simulation);
        simulation.model().notes().for_each(|note| (options.progress)(Signal::Note(note)));
        let terrain = simulation.into_terrain().at_centres().into_owned().wrap();
        let watcher = open(&beside).watcher.take();
        if let Some(note) = watcher.map(|watcher| watcher.finish(out)).transpose()?.flatten() {
            (options.progress)(Signal::Note(note.into()));
        }
        Ok(Some((terrain, outcome)))
    }

    fn body<T: Body>(self, terrain: &T) -> Self::Out {
        let Self { run, coarser, checkpoint, .. } = self;
        let (clock, options) = (&run.evolve.clock, run.options);
        let stop = clock.stop();
        let asked = [
            (run.evolve.watch.is_some(), "`watch`"),
            (!coarser.is_empty(), "`refine`"),
            (stop.steady.is_some(), "a run until it is steady"),
        ];
        if let Some((_, what)) = asked.iter().find(|asked| asked.0) {
            return Err(not_a_surface(T::KIND, what));
        }
        let mut model = run.around(Model::new(terrain.clone()).seed(run.seed));
        run.evolve.parts.iter().try_for_each(|part| part.add_to(T::KIND, &mut model))?;
        let resume = options.resume && checkpoint.as_ref().is_some_and(Checkpoint::is_there);
        let saves = checkpoint.is_some();
        let beside = Mutex::new(Beside { watcher: None, checkpoint });
        let mut simulation = Simulation::of(model).observe(Every::Steps(1), steps(stop, options.progress));
        if let Some(time) = stop.time {
            simulation = simulation.for_time(time);
        }
        if let Some(steps) = stop.steps {
            simulation = simulation.for_steps(steps);
        }
        if saves {
            simulation = simulation.save_every(options.checkpoint_every, |model| open(&beside).save(model));
        }
        if resume {
            simulation = open(&beside).resume(simulation)?;
        }
        let outcome = simulation.run()?;
        if outcome.stopped == Stopped::Cancelled {
            open(&beside).save(simulation.model())?;
            return Ok(None);
        }
        Ok(Some((simulation.into_terrain().wrap(), outcome)))
    }
}

/// That something failed on coarser cells, though it may not on those of the recipe.
pub(super) fn failed_on(level: Level, error: Error) -> Error {
    let what = format!("on the coarser cells of `refine`, {} times as long: {error}", level.factor());
    Error::Recipe { at: None, what, hint: Some("give a lower `refine`, or finer cells".into()) }
}

/// Where a coarser level left off: its ground at time 0 and now.
struct LeftOff<T> {
    before: T,
    after: T,
    time: f64,
    steps: u64,
}

impl<'a, 'b> Run<'a, 'b> {
    /// Runs from where what looks on says, until it breaks off; none if it says nothing.
    fn go_on<T: Surface>(self, before: &T) -> Option<Result<Option<(AnyTerrain, Outcome)>>> {
        let left = self.options.look?.goes_on_from(self.stage)?;
        let ground = T::of(&left.ground).filter(|ground| ground.nodes() == before.nodes())?;
        let run = || {
            let model = self.model(ground, &self.evolve.parts)?.begin_at(left.time, left.steps);
            let end = Stop { time: Some(f64::INFINITY), ..Stop::default() };
            let mut simulation = Simulation::of(model).until(end);
            simulation = simulation.observe(Every::Steps(1), steps(end, self.options.progress));
            simulation = simulation.between(|model| look(self.options.look, &mut look::Running(model)));
            let outcome = simulation.run()?;
            if outcome.stopped != Stopped::Cancelled {
                self.tell_end(&simulation);
            }
            let ground = simulation.into_terrain().at_centres().into_owned().wrap();
            Ok((outcome.stopped != Stopped::Cancelled).then_some((ground, outcome)))
        };
        Some(run())
    }

    fn tell_end<T: Surface>(self, simulation: &Simulation<T>) {
        let model = simulation.model();
        let left = || look::Left {
            ground: Arc::new(model.terrain().clone().wrap()),
            time: model.time(),
            steps: model.steps(),
        };
        self.options.look.iter().for_each(|look| look.ended(self.stage, &left));
    }

    fn model<T: Surface>(self, terrain: &T, parts: &[ReadStage]) -> Result<Model<T>> {
        Ok(self.around(model_of(terrain, parts, self.seed)?))
    }

    /// A model with the clock and the surroundings of the run.
    fn around<T: Terrain>(self, model: Model<T>) -> Model<T> {
        model
            .dt(self.evolve.clock.step())
            .maps(self.recipe.maps.clone())
            .environment(self.recipe.environment.clone())
            .cancel(self.options.cancel.clone())
    }

    /// Runs coarser levels, each from where the one before left off; none if the run was asked to
    /// stop. What looks sees the finest ground, changed as the coarser one was.
    fn on_coarser<T: Surface>(
        self,
        levels: &[Coarser],
        finest: &T,
        beside: &Mutex<Beside<'a>>,
    ) -> Result<Option<LeftOff<T>>> {
        let mut left: Option<LeftOff<T>> = None;
        for level in levels {
            let ran = self.on_level(level, left.as_ref(), finest, beside).map_err(|e| failed_on(level.level, e))?;
            let Some(now) = ran else { return Ok(None) };
            left = Some(now);
        }
        Ok(left)
    }

    /// Runs one coarser level; none if the run was asked to stop.
    fn on_level<T: Surface>(
        self,
        level: &Coarser,
        left: Option<&LeftOff<T>>,
        finest: &T,
        beside: &Mutex<Beside<'a>>,
    ) -> Result<Option<LeftOff<T>>> {
        let mut model = self.model(level.ground.get::<T>("refine")?, &level.parts)?;
        model.start()?;
        let before = model.terrain().clone();
        if let Some(left) = left {
            model = model.begin_at(left.time, left.steps);
            model.start_changed(&left.before, &left.after)?;
        }
        let end = Stop { time: Some(level.until), ..Stop::default() };
        let mut simulation = self.observed(Simulation::of(model).until(end), beside, |view, beside| {
            let mut terrain = finest.clone();
            terrain.take_change_of(&before, view.terrain);
            open(beside).look(&View { terrain: &terrain, ..*view })
        });
        if self.options.look.is_some() {
            simulation = simulation
                .between(|model| look(self.options.look, &mut look::Coarser { model, before: &before, finest }));
        }
        let outcome = simulation.run()?;
        let after = simulation.into_terrain();
        let left = LeftOff { before, after, time: outcome.time, steps: outcome.steps };
        Ok((outcome.stopped != Stopped::Cancelled).then_some(left))
    }

    /// A simulation that tells of its steps, with what looks at it.
    fn observed<'s, T: Surface>(
        self,
        simulation: Simulation<'s, T>,
        beside: &'s Mutex<Beside<'a>>,
        look: impl Fn(&View<T>, &Mutex<Beside<'a>>) -> Result<ControlFlow<()>> + Send + 's,
    ) -> Simulation<'s, T>
    where
        'a: 's,
        'b: 's,
    {
        let stop = self.evolve.clock.stop();
        let simulation = simulation.observe(Every::Steps(1), steps(stop, self.options.progress));
        match (self.watch, self.evolve.watch.as_ref().map(Watch::interval)) {
            (Some(watch), _) => simulation.observe(watch.interval(), move |view| look(view, beside)),
            // Without an observer steps are as long as with one.
            (None, Some(every @ Every::Time(_))) => simulation.observe(every, |_| Ok(ControlFlow::Continue(()))),
            _ => simulation,
        }
    }
}

/// A model of a terrain with processes, its nodes off the centres of cells if one of them wants
/// that.
///
/// # Errors
/// Where [`ReadStage::add_to`] fails.
pub(crate) fn model_of<T: Surface>(terrain: &T, parts: &[ReadStage], seed: Seed) -> Result<Model<T>> {
    let jitters = parts.iter().any(ReadStage::jitters);
    let jittered = jitters.then(|| terrain.jittered(seed.named("lattice"))).flatten();
    let mut model = Model::new(jittered.unwrap_or_else(|| terrain.clone())).seed(seed);
    for part in parts {
        part.add_to(T::KIND, &mut model)?;
    }
    Ok(model)
}

/// What looks at a run, and what keeps its state.
struct Beside<'a> {
    watcher: Option<Watcher<'a>>,
    checkpoint: Option<Checkpoint<'a>>,
}

impl Beside<'_> {
    fn look<T: Surface>(&mut self, view: &View<T>) -> Result<ControlFlow<()>> {
        self.watcher.as_mut().map_or(Ok(ControlFlow::Continue(())), |watcher| watcher.look(view))
    }

    fn save<T: Terrain>(&mut self, model: &Model<T>) -> Result<()> {
        self.checkpoint.as_mut().map_or(Ok(()), |checkpoint| checkpoint.save(model, self.watcher.as_mut()))
    }

    fn resume<'s, T: Terrain>(&mut self, simulation: Simulation<'s, T>) -> Result<Simulation<'s, T>> {
        match &mut self.checkpoint {
            Some(checkpoint) => checkpoint.resume(simulation, self.watcher.as_mut()),
            None => Ok(simulation),
        }
    }
}

/// A lock that a panic elsewhere does not close: rows and pictures are whole at any time.
fn open<'m, 'a>(beside: &'m Mutex<Beside<'a>>) -> MutexGuard<'m, Beside<'a>> {
    beside.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Tells of every step.
fn steps<'p, T: Terrain>(
    stop: Stop,
    progress: &'p Progress<'p>,
) -> impl FnMut(&View<T>) -> Result<ControlFlow<()>> + Send + 'p {
    let mut first_residual = None;
    move |view| {
        let part = part_done(stop, view, &mut first_residual);
        progress(Signal::Step { steps: view.steps, time: view.time, part, residual: view.residual });
        Ok(ControlFlow::Continue(()))
    }
}

/// The part of a run that is done, as far as it is known when it ends.
fn part_done<T>(stop: Stop, view: &View<T>, first_residual: &mut Option<f64>) -> Option<f64> {
    let part = match (stop.time, stop.steady, view.residual) {
        (Some(end), ..) => Some(view.time / end),
        (None, Some(tolerance), Some(residual)) => {
            let first = *first_residual.get_or_insert(residual);
            let gone = |r: f64| landform_core::math::log(r.max(tolerance) / tolerance);
            Some(1.0 - gone(residual) / gone(first).max(1e-9))
        }
        _ => None,
    };
    match stop.steps {
        Some(most) => Some(part.unwrap_or(0.0).max(view.steps as f64 / most as f64)),
        None => part,
    }
}
