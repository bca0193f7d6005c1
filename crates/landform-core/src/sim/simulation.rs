//! A run of a model: when it stops, its observers, its checkpoints.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use super::refine::Refining;
use super::schedule::next_multiple;
use super::steady::{Watched, step_watched};
use super::{Budget, Every, Model, Outcome, StepReport, Stop, Stopped};
use crate::random::Seed;
use crate::terrain::{NodeSurface, Refine, Terrain};
use crate::verb::{CancelToken, Change, Environment, Maps, Process};
use crate::{Error, Result};

/// Greatest number of steps of a run until steady without `iterations`.
const MOST_STEPS_WITHOUT_END: u64 = 10_000;

/// The state that an observer sees.
#[derive(Debug)]
pub struct View<'a, T> {
    /// The terrain after the step.
    pub terrain: &'a T,
    /// Steps taken.
    pub steps: u64,
    /// Time, s.
    pub time: f64,
    /// Length of the last step, s.
    pub dt: f64,
    /// Residual of the last step, if steadiness is watched for.
    pub residual: Option<f64>,
    /// Volumes that the last step moved, all processes together.
    pub change: Change,
}

type Observer<'a, T> = Box<dyn FnMut(&View<T>) -> Result<ControlFlow<()>> + Send + 'a>;
type Between<'a, T> = Box<dyn FnMut(&mut Model<T>) -> Result<ControlFlow<()>> + Send + 'a>;
type Saver<'a, T> = Box<dyn FnMut(&Model<T>) -> Result<()> + Send + 'a>;

/// Runs a model until a condition stops it, and calls observers on the way.
///
/// A step is the least of the clock's step, the steps that processes allow, and the time to the
/// next scheduled observation. Whether a run was interrupted and resumed makes no difference to its
/// bits.
///
/// ```
/// use std::ops::ControlFlow;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::sim::{Every, Simulation, Stopped};
/// use landform_core::terrain::HeightField;
///
/// let ground = HeightField::new(Grid::new(Shape::new(3, 3), [10.0, 10.0])?, vec![0.0; 9])?;
/// let mut run = Simulation::new(ground).dt(10.0).for_time(100.0).observe(Every::Steps(1), |view| {
///     Ok(if view.time < 30.0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) })
/// });
/// let outcome = run.run()?;
/// assert_eq!((outcome.stopped, outcome.steps), (Stopped::ByObserver, 3));
/// # Ok::<(), landform_core::Error>(())
/// ```
pub struct Simulation<'a, T: Terrain> {
    model: Model<T>,
    stop: Stop,
    /// The values whose change decides whether the terrain is steady.
    steady_values: Option<Watched<T>>,
    refining: Option<Refining<T>>,
    observers: Vec<(Every, Instant, Observer<'a, T>)>,
    /// Called between steps.
    between: Option<Between<'a, T>>,
    saver: Option<(f64, Instant, Saver<'a, T>)>,
}

impl<T: NodeSurface> Simulation<'_, T> {
    /// When to stop.
    pub fn until(mut self, stop: Stop) -> Self {
        self.steady_values = Some(T::elevation);
        self.stop = stop;
        self
    }
}

impl<T: Refine + NodeSurface> Simulation<'_, T> {
    /// First brings terrains of this many coarser levels to a steady state, each from the one
    /// before, and starts from the last. It serves steady states only, since the path to them is no
    /// history.
    pub fn refine(mut self, levels: u32) -> Self {
        self.refining = (levels > 0).then(|| Refining::new(levels));
        self
    }
}

impl<'a, T: Terrain> Simulation<'a, T> {
    /// A simulation of a terrain without processes.
    pub fn new(terrain: T) -> Self {
        Self::of(Model::new(terrain))
    }

    /// A run of a model.
    pub fn of(model: Model<T>) -> Self {
        let (observers, stop) = (Vec::new(), Stop::default());
        Self { model, stop, steady_values: None, refining: None, observers, between: None, saver: None }
    }

    /// Adds a process.
    ///
    /// # Errors
    /// Where [`Model::add`] fails.
    pub fn process<P: Process<T>>(mut self, params: P) -> Result<Self> {
        self.model.add(params)?;
        Ok(self)
    }

    /// The clock's step, s.
    pub fn dt(mut self, seconds: f64) -> Self {
        self.model = self.model.dt(seconds);
        self
    }

    /// Stops at a time, s.
    pub fn for_time(mut self, seconds: f64) -> Self {
        self.stop.time = Some(seconds);
        self
    }

    /// Stops after a number of steps.
    pub fn for_steps(mut self, steps: u64) -> Self {
        self.stop.steps = Some(steps);
        self
    }

    /// The seed.
    pub fn seed(mut self, seed: Seed) -> Self {
        self.model = self.model.seed(seed);
        self
    }

    /// Where maps are read from.
    pub fn maps(mut self, maps: Arc<dyn Maps>) -> Self {
        self.model = self.model.maps(maps);
        self
    }

    /// Sea level, rain, winds and materials, for processes that have no values of their own.
    pub fn environment(mut self, environment: Arc<Environment>) -> Self {
        self.model = self.model.environment(environment);
        self
    }

    /// Sets the token by which the run can be ended.
    pub fn cancel(mut self, token: CancelToken) -> Self {
        self.model = self.model.cancel(token);
        self
    }

    /// Calls an observer as `every` says; [`ControlFlow::Break`] ends the run.
    pub fn observe(
        mut self,
        every: Every,
        observer: impl FnMut(&View<T>) -> Result<ControlFlow<()>> + Send + 'a,
    ) -> Self {
        self.observers.push((every, Instant::now(), Box::new(observer)));
        self
    }

    /// Calls `between` after every step, once observers have seen it. It may change the model
    /// ([`Model::edit`]) or hold the run up; [`ControlFlow::Break`] ends the run.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    /// use landform_core::grid::{Grid, Shape};
    /// use landform_core::sim::Simulation;
    /// use landform_core::terrain::{HeightField, Layer, NodeSurface};
    ///
    /// let ground = HeightField::new(Grid::new(Shape::new(3, 3), [10.0, 10.0])?, vec![0.0; 9])?;
    /// let mut run = Simulation::new(ground).dt(10.0).for_steps(2).between(|model| {
    ///     model.edit(|ground| ground.change(Layer::Bedrock, |z| z[4] += 3.0))?;
    ///     Ok(ControlFlow::Continue(()))
    /// });
    /// run.run()?;
    /// assert_eq!(run.terrain().elevation()[4], 6.0);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn between(mut self, between: impl FnMut(&mut Model<T>) -> Result<ControlFlow<()>> + Send + 'a) -> Self {
        self.between = Some(Box::new(between));
        self
    }

    /// Calls `save` (which may use [`Model::save`]) each time this many seconds of wall-clock time
    /// have passed.
    pub fn save_every(mut self, seconds: f64, save: impl FnMut(&Model<T>) -> Result<()> + Send + 'a) -> Self {
        self.saver = Some((seconds, Instant::now(), Box::new(save)));
        self
    }

    /// The model that runs.
    pub fn model(&self) -> &Model<T> {
        &self.model
    }

    /// The model that ran, to go on with.
    pub fn into_model(self) -> Model<T> {
        self.model
    }

    /// The terrain as it is.
    pub fn terrain(&self) -> &T {
        &self.model.terrain
    }

    /// The terrain, taken out.
    pub fn into_terrain(self) -> T {
        self.model.terrain
    }

    /// Goes back to what the model of a simulation that was set up in the same way had saved.
    ///
    /// # Errors
    /// Where [`Model::restore`] fails.
    pub fn resume(mut self, key: &str, saved: &[u8]) -> Result<Self> {
        self.model.restore(key, saved)?;
        Ok(self)
    }

    /// Runs until a condition stops it. A cancelled run can be saved and resumed; any other is
    /// finished.
    ///
    /// # Errors
    /// If a process or an observer fails; [`Error::NonFinite`] if a number is not finite after a
    /// process; [`Error::Parameter`] if the clock cannot run.
    pub fn run(&mut self) -> Result<Outcome> {
        self.check_clock()?;
        // Other ends come sooner or later than a number of steps.
        self.model.planned = self.stop.steps.filter(|_| self.stop.time.is_none() && self.stop.steady.is_none());
        if !self.model.clock.started
            && let Some(refining) = self.refining.take()
        {
            refining.start(&mut self.model, self.stop.steady, self.steady_values)?;
        }
        let stopped = loop {
            if let Some(stopped) = self.reason_to_stop() {
                break stopped;
            }
            self.model.start()?;
            // What there is to do may only show once processes have begun.
            if let Some(stopped) = self.reason_to_stop() {
                break stopped;
            }
            if self.advance()?.is_break() {
                break Stopped::ByObserver;
            }
        };
        if stopped != Stopped::Cancelled {
            self.model.finish()?;
        }
        let c = self.model.clock;
        let budget = Budget { change: c.change, volume_start: c.volume_start, volume_end: self.model.terrain.volume() };
        Ok(Outcome { stopped, steps: c.steps, time: c.time, residual: c.residual, budget })
    }

    fn check_clock(&self) -> Result<()> {
        let (dt, duration) = (self.model.dt, self.stop.time.unwrap_or(f64::INFINITY));
        if !(dt.is_finite() && dt > 0.0) {
            return Err(Error::parameter("clock.dt", format!("{dt} s"), "> 0 s, for example \"1 kyr\""));
        }
        if !(duration >= 0.0) {
            return Err(Error::parameter("clock.duration", format!("{duration} s"), "at least 0 s"));
        }
        if self.stop.time.is_none() && self.stop.steady.is_none() && self.stop.steps.is_none() {
            return Err(Error::parameter("clock", "without end", "`duration`, `until = \"steady\"` or `iterations`"));
        }
        Ok(())
    }

    fn is_end_time(&self, time: f64) -> bool {
        // A remainder below a billionth of the step is rounding, not time.
        self.stop.time.is_some_and(|t| time >= t - 1e-9 * self.model.dt)
    }

    fn steps_are_used_up(&self, steps: u64) -> bool {
        let most = self.stop.steps.or(self.stop.time.is_none().then_some(MOST_STEPS_WITHOUT_END));
        most.is_some_and(|n| steps >= n)
    }

    fn reason_to_stop(&self) -> Option<Stopped> {
        let clock = &self.model.clock;
        if self.is_end_time(clock.time) {
            Some(Stopped::EndTime)
        } else if self.stop.steady.zip(clock.residual).is_some_and(|(tolerance, r)| r <= tolerance) {
            Some(Stopped::Steady)
        } else if clock.started && self.model.is_at_rest() {
            Some(if self.model.is_short_of_an_end() { Stopped::AtRestTooSoon } else { Stopped::AtRest })
        } else if self.steps_are_used_up(clock.steps) {
            Some(Stopped::MaxSteps)
        } else if self.model.cancel.is_cancelled() {
            Some(Stopped::Cancelled)
        } else {
            None
        }
    }

    fn next_dt(&self) -> f64 {
        let now = self.model.clock.time;
        let mut dt = self.model.allowed(self.model.dt);
        let mut until = |t: f64| {
            let left = t - now;
            // A last step up to a billionth longer saves one of a billionth's length.
            if left < dt * (1.0 + 1e-9) {
                dt = left;
            }
        };
        if let Some(t) = self.stop.time {
            until(t);
        }
        for (every, ..) in &self.observers {
            if let Every::Time(interval) = every {
                until(next_multiple(now, *interval));
            }
        }
        dt
    }

    fn advance(&mut self) -> Result<ControlFlow<()>> {
        let watched = self.steady_values.filter(|_| self.stop.steady.is_some());
        let dt = self.next_dt();
        let StepReport { dt, change } = step_watched(&mut self.model, dt, watched)?;
        let super::model::Clock { steps, time, residual, .. } = self.model.clock;
        let view = View { terrain: &self.model.terrain, steps, time, dt, residual, change };
        for (every, last, observer) in &mut self.observers {
            let due = match *every {
                Every::Steps(n) => steps % n.max(1) == 0,
                Every::Time(interval) => next_multiple(time - dt, interval) <= time * (1.0 + 1e-12),
                Every::Wall(seconds) => last.elapsed().as_secs_f64() >= seconds,
            };
            if due {
                *last = Instant::now();
                if observer(&view)?.is_break() {
                    return Ok(ControlFlow::Break(()));
                }
            }
        }
        if let Some(between) = &mut self.between
            && between(&mut self.model)?.is_break()
        {
            return Ok(ControlFlow::Break(()));
        }
        if let Some((seconds, last, save)) = &mut self.saver
            && last.elapsed().as_secs_f64() >= *seconds
        {
            save(&self.model)?;
            *last = Instant::now();
        }
        Ok(ControlFlow::Continue(()))
    }
}
