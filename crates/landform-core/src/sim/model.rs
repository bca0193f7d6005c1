//! A terrain with processes and a clock, which can be stepped, examined and changed.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::running::{Run, Running};
use super::{Budget, pack, unpack};
use crate::random::Seed;
use crate::terrain::{Refine, Terrain};
use crate::verb::{CancelToken, Change, Context, Environment, Maps, NoMaps, Process, Step};
use crate::{Error, Result};

/// Where a model is: what a checkpoint holds besides terrain and states.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Clock {
    pub(super) started: bool,
    pub(super) steps: u64,
    pub(super) time: f64,
    pub(super) residual: Option<f64>,
    pub(super) change: Change,
    pub(super) volume_start: f64,
}

/// Result of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepReport {
    /// Length of the step, s.
    pub dt: f64,
    /// Volumes that all processes moved.
    pub change: Change,
}

#[derive(Serialize)]
struct Saving<'a, T> {
    clock: Clock,
    terrain: &'a T,
    states: Vec<(String, Vec<u8>)>,
}

#[derive(Deserialize)]
struct Saved<T> {
    clock: Clock,
    terrain: T,
    states: Vec<(String, Vec<u8>)>,
}

/// Steps that a model had taken when it was saved; its terrain is not read.
///
/// # Errors
/// [`Error::Format`] if it is damaged or belongs to another model.
pub fn saved_steps(key: &str, saved: &[u8]) -> Result<u64> {
    // The clock comes first.
    unpack::<Clock>("checkpoint", key, saved).map(|clock| clock.steps)
}

/// A terrain, the processes that act on it with their states, and a clock. It owns all its data, so
/// that it can be kept, sent to another thread, and changed between steps.
///
/// In a step processes act one after the other in the order in which they were added (sequential
/// splitting). After each, a guard looks for numbers that are not finite. The same calls give the
/// same bits.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::sim::Model;
/// use landform_core::terrain::HeightField;
///
/// # fn main() -> landform_core::Result<()> {
/// let ground = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![0.0; 9])?;
/// let mut model = Model::new(ground).dt(5.0);
/// model.advance(12.0)?;
/// assert_eq!((model.time(), model.steps()), (12.0, 3));
/// # Ok(())
/// # }
/// ```
pub struct Model<T: Terrain> {
    pub(super) terrain: T,
    pub(super) processes: Vec<Box<dyn Running<T>>>,
    pub(super) dt: f64,
    /// Steps of the whole run, where that and nothing else ends it.
    pub(super) planned: Option<u64>,
    seed: Seed,
    maps: Arc<dyn Maps>,
    environment: Arc<Environment>,
    pub(super) cancel: CancelToken,
    pub(super) clock: Clock,
    /// Whether the terrain was changed from outside since the processes last read it.
    stale: bool,
}

impl<T: Terrain> Model<T> {
    /// A model of a terrain without processes, at time 0.
    pub fn new(terrain: T) -> Self {
        Self {
            terrain,
            processes: Vec::new(),
            dt: 0.0,
            planned: None,
            seed: Seed::default(),
            maps: Arc::new(NoMaps),
            environment: Arc::default(),
            cancel: CancelToken::default(),
            clock: Clock::default(),
            stale: false,
        }
    }

    /// Adds a process.
    ///
    /// # Errors
    /// [`Error::Parameter`] if a parameter is out of range.
    pub fn add<P: Process<T>>(&mut self, params: P) -> Result<()> {
        params.validate()?;
        self.processes.push(Box::new(Run::<P, P::State> { params, state: None }));
        Ok(())
    }

    /// The longest step, s.
    pub fn dt(mut self, seconds: f64) -> Self {
        self.dt = seconds;
        self
    }

    /// The seed.
    pub fn seed(mut self, seed: Seed) -> Self {
        self.seed = seed;
        self
    }

    /// Where maps are read from.
    pub fn maps(mut self, maps: Arc<dyn Maps>) -> Self {
        self.maps = maps;
        self
    }

    /// Sea level, rain, winds and materials, for processes that have no values of their own.
    pub fn environment(mut self, environment: Arc<Environment>) -> Self {
        self.environment = environment;
        self
    }

    /// Sets the token by which long steps can be interrupted.
    pub fn cancel(mut self, token: CancelToken) -> Self {
        self.cancel = token;
        self
    }

    /// Begins at a time (s) and a number of steps, rather than at 0.
    pub fn begin_at(mut self, time: f64, steps: u64) -> Self {
        (self.clock.time, self.clock.steps) = (time, steps);
        self
    }

    /// The terrain as it is.
    pub fn terrain(&self) -> &T {
        &self.terrain
    }

    /// The terrain, taken out.
    pub fn into_terrain(self) -> T {
        self.terrain
    }

    /// Time since the start, s.
    pub fn time(&self) -> f64 {
        self.clock.time
    }

    /// Steps since the start.
    pub fn steps(&self) -> u64 {
        self.clock.steps
    }

    /// Volumes moved since the start, edits included.
    pub fn budget(&self) -> Budget {
        let Clock { change, volume_start, .. } = self.clock;
        Budget { change, volume_start, volume_end: self.terrain.volume() }
    }

    /// Names of the processes, in order.
    pub fn processes(&self) -> impl Iterator<Item = &'static str> {
        self.processes.iter().map(|p| p.name())
    }

    /// Whether nothing is left to do: there are processes, and all are at rest.
    pub fn is_at_rest(&self) -> bool {
        !self.processes.is_empty() && self.processes.iter().all(|p| p.is_at_rest(&self.terrain))
    }

    /// Whether a process has not reached the end that its parameters ask for.
    pub fn is_short_of_an_end(&self) -> bool {
        self.processes.iter().any(|p| p.is_short_of_its_end(&self.terrain))
    }

    /// Starts the processes, if they have not started; the first step does so too.
    ///
    /// # Errors
    /// If a process does not find what it needs: a map, a field, an outlet.
    pub fn start(&mut self) -> Result<()> {
        if !self.clock.started {
            self.restart()?;
            self.clock.volume_start = self.terrain.volume();
            self.clock.started = true;
        }
        Ok(())
    }

    /// Starts all processes on the terrain as it is.
    fn restart(&mut self) -> Result<()> {
        self.each(|process, terrain, context| process.start(terrain, context))?;
        self.stale = false;
        Ok(())
    }

    /// Calls every process with the terrain and its context, in order.
    fn each(&mut self, call: impl Fn(&mut dyn Running<T>, &mut T, &Context) -> Result<()>) -> Result<()> {
        let Self { terrain, processes, seed, maps, environment, clock, .. } = self;
        for (k, process) in processes.iter_mut().enumerate() {
            let (seed, time, step) = (seed.with(k as u64), clock.time, clock.steps);
            call(
                &mut **process,
                terrain,
                &Context { seed, maps: &**maps, environment, time, step, ..Context::default() },
            )?;
        }
        Ok(())
    }

    /// The length of the next step if it may be as long as `at_most`, s.
    pub(super) fn allowed(&self, at_most: f64) -> f64 {
        let wanted = self.processes.iter().filter_map(|p| p.max_step(&self.terrain));
        wanted.fold(at_most, f64::min)
    }

    /// Takes one step of exactly `dt` s, whatever processes would allow.
    pub(super) fn take_step(&mut self, dt: f64) -> Result<StepReport> {
        let (clock, seed, planned) = (self.clock, self.seed, self.planned);
        let (cancel, environment) = (self.cancel.clone(), self.environment.clone());
        let at = |k: usize| Step {
            index: clock.steps,
            of: planned,
            time: clock.time,
            dt,
            seed: seed.with(k as u64).with(clock.steps),
            environment: environment.clone(),
            cancel: cancel.clone(),
        };
        for (k, process) in self.processes.iter_mut().enumerate() {
            process.begin(&self.terrain, &at(k))?;
        }
        let mut change = Change::default();
        for (k, process) in self.processes.iter_mut().enumerate() {
            let at = at(k);
            change = change.plus(process.step(&mut self.terrain, &at)?);
            if let Err((field, node)) = self.terrain.check_finite() {
                let after = format!("`{}` in step {}", process.name(), at.index);
                return Err(Error::NonFinite { field: field.into(), node, after });
            }
        }
        self.clock.steps += 1;
        self.clock.time += dt;
        self.clock.change = self.clock.change.plus(change);
        Ok(StepReport { dt, change })
    }

    /// Takes one step, of at most `at_most` seconds and as long as all processes allow.
    ///
    /// # Errors
    /// [`Error::Parameter`] if the step is not positive; [`Error::NonFinite`] if a number is not
    /// finite after a process; or if a process fails.
    pub fn step(&mut self, at_most: f64) -> Result<StepReport> {
        if !(at_most > 0.0 && at_most.is_finite()) {
            return Err(Error::parameter("dt", format!("{at_most} s"), "> 0 s, for example \"1 kyr\""));
        }
        self.start()?;
        if self.stale {
            self.reconcile()?;
        }
        self.take_step(self.allowed(at_most))
    }

    /// Goes on for `time` seconds, in steps of at most [`Model::dt`].
    ///
    /// # Errors
    /// Where [`Model::step`] fails.
    pub fn advance(&mut self, time: f64) -> Result<Change> {
        let end = self.clock.time + time;
        let mut change = Change::default();
        // A remainder below a billionth of the step is rounding, not time.
        while self.clock.time < end - 1e-9 * self.dt {
            let left = end - self.clock.time;
            let at_most = if left < self.dt * (1.0 + 1e-9) { left } else { self.dt };
            change = change.plus(self.step(at_most)?.change);
        }
        Ok(change)
    }

    /// Goes on for a number of steps of at most [`Model::dt`].
    ///
    /// # Errors
    /// Where [`Model::step`] fails.
    pub fn advance_steps(&mut self, steps: u64) -> Result<Change> {
        (0..steps).try_fold(Change::default(), |change, _| Ok(change.plus(self.step(self.dt)?.change)))
    }

    /// Lets processes add their derived fields, as after the last step. The model can go on
    /// afterwards.
    ///
    /// # Errors
    /// If a process fails; the error is the process's own.
    pub fn finish(&mut self) -> Result<()> {
        self.start()?;
        let Self { terrain, processes, environment, .. } = self;
        processes.iter_mut().try_for_each(|process| process.finish(terrain, environment))
    }

    /// What users should know of the ground after [`Model::finish`].
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::sim::Model;
    /// use landform_core::terrain::HeightField;
    ///
    /// let ground = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![0.0; 9])?;
    /// // Nothing runs on it, and nothing is told of it.
    /// assert_eq!(Model::new(ground).notes().count(), 0);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn notes(&self) -> impl Iterator<Item = String> {
        self.processes.iter().filter_map(|process| process.note(&self.terrain))
    }

    /// Changes the terrain from outside. Volume that the edit adds or takes is counted as supplied
    /// or as removed, so that mass closes. Sediment that processes carried is counted as exported.
    /// Then the processes begin anew on the terrain.
    ///
    /// # Errors
    /// If a process no longer finds what it needs. The edit is kept.
    pub fn edit<R>(&mut self, edit: impl FnOnce(&mut T) -> R) -> Result<R> {
        let before = self.terrain.volume();
        let result = edit(&mut self.terrain);
        if self.clock.started {
            let more = self.terrain.volume() - before;
            let change = &mut self.clock.change;
            change.supplied += more.max(0.0);
            change.eroded += (-more).max(0.0);
            change.exported += (-more).max(0.0);
            self.stale = true;
            self.reconcile()?;
        }
        Ok(result)
    }

    /// Gives a process other parameters; it begins anew on the terrain as it is.
    ///
    /// # Errors
    /// [`Error::Parameter`] if there is no such process or a parameter is out of range; or if the
    /// process does not find what it needs.
    pub fn set<P: Process<T>>(&mut self, index: usize, params: P) -> Result<()> {
        params.validate()?;
        let found = self.processes.get(index).map(|p| p.name());
        if found != Some(P::NAME) {
            let found = found.map_or("nothing".to_string(), |n| format!("`{n}`"));
            return Err(Error::parameter("process", found, &format!("`{}` at place {index}", P::NAME)));
        }
        self.processes[index] = Box::new(Run::<P, P::State> { params, state: None });
        if self.clock.started {
            self.stale = true;
            self.reconcile()?;
        }
        Ok(())
    }

    /// Begins as a coarser form of the same ground changed between two states, where another model
    /// left off: processes start on the ground as it was, and begin anew on the changed ground. The
    /// budget begins there.
    ///
    /// # Errors
    /// Where [`Model::start`] fails.
    ///
    /// ```
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::sim::Model;
    /// use landform_core::terrain::{HeightField, NodeSurface};
    ///
    /// # fn main() -> landform_core::Result<()> {
    /// let flat = |n: usize, cell: f64, z: f64| -> landform_core::Result<HeightField> {
    ///     HeightField::new(Grid::new(Shape::new(n, n), [cell; 2])?, vec![z; n * n])
    /// };
    /// // Coarse ground rose by 3 m; the fine ground, 10 m high, begins 3 m higher.
    /// let mut model = Model::new(flat(9, 5.0, 10.0)?);
    /// model.start_changed(&flat(5, 10.0, 0.0)?, &flat(5, 10.0, 3.0)?)?;
    /// assert!((model.terrain().elevation()[40] - 13.0).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    pub fn start_changed(&mut self, before: &T, after: &T) -> Result<()>
    where
        T: Refine,
    {
        self.start()?;
        self.terrain.take_change_of(before, after);
        self.reconcile()?;
        (self.clock.change, self.clock.volume_start) = (Change::default(), self.terrain.volume());
        Ok(())
    }

    fn reconcile(&mut self) -> Result<()> {
        let change = &mut self.clock.change;
        change.exported += std::mem::take(&mut change.carried);
        self.each(|process, terrain, context| process.reconcile(terrain, context))?;
        self.stale = false;
        Ok(())
    }

    /// Everything that [`Model::restore`] needs, as bytes; `key` names what it belongs to. The
    /// terrain is written as it stands, without a second copy.
    ///
    /// # Errors
    /// [`Error::Format`] if a state cannot be encoded.
    pub fn save(&self, key: &str) -> Result<Vec<u8>> {
        let states = self.processes.iter().map(|p| Ok((p.name().into(), p.save()?))).collect::<Result<_>>()?;
        pack("checkpoint", key, &Saving { clock: self.clock, terrain: &self.terrain, states })
    }

    /// Goes back to what a model of the same processes had saved.
    ///
    /// # Errors
    /// [`Error::Format`] if it is damaged or belongs to another model.
    pub fn restore(&mut self, key: &str, saved: &[u8]) -> Result<()> {
        let saved: Saved<T> = unpack("checkpoint", key, saved)?;
        if !self.processes.iter().map(|p| p.name()).eq(saved.states.iter().map(|s| s.0.as_str())) {
            return Err(Error::format("landform state", "it is of other processes"));
        }
        for (process, (_, state)) in self.processes.iter_mut().zip(&saved.states) {
            process.load(state)?;
        }
        (self.terrain, self.clock, self.stale) = (saved.terrain, saved.clock, false);
        Ok(())
    }

    /// Starts over on another terrain of the same kind, at time 0, and returns the one before.
    pub(super) fn exchange(&mut self, terrain: T) -> T {
        self.clock = Clock::default();
        std::mem::replace(&mut self.terrain, terrain)
    }
}
