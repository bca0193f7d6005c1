//! The driver: several processes on one clock.

use std::ops::ControlFlow;
use std::time::Instant;

use serde::{Deserialize, Serialize};

use super::running::{Run, Running};
use super::schedule::next_multiple;
use super::{Budget, Every, Outcome, Stop, Stopped, pack, unpack};
use crate::random::Seed;
use crate::terrain::Terrain;
use crate::verb::{CancelToken, Change, Context, Maps, NoMaps, Process, Step};
use crate::{Error, Result, parallel};

/// A run until steady that says no `max_steps` gives up here.
const MOST_STEPS_WITHOUT_END: u64 = 10_000;
/// Residual of a coarse level that a finer one starts from.
const ENOUGH_FOR_THE_NEXT_LEVEL: f64 = 1e-6;
/// A coarse level that takes longer is left as it is.
const MOST_STEPS_A_LEVEL: usize = 100;

/// What an observer sees.
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
    /// What the last step did, all processes together.
    pub change: Change,
}

type Observer<'a, T> = Box<dyn FnMut(&View<T>) -> Result<ControlFlow<()>> + Send + 'a>;
type Saver<'a, T> = Box<dyn FnMut(&Simulation<'_, T>) -> Result<()> + Send + 'a>;

/// Runs processes on a terrain, in the order in which they were added, each step one after the other (sequential splitting).
///
/// The step is the least of the clock's, what every process allows, and the time to the next scheduled look. After each
/// process a guard looks for numbers that are not finite. Given the same calls a run gives the same bits, whether it was
/// interrupted and resumed or not.
pub struct Simulation<'a, T: Terrain> {
    terrain: T,
    processes: Vec<Box<dyn Running<T>>>,
    dt: f64,
    stop: Stop,
    refine: u32,
    seed: Seed,
    maps: &'a dyn Maps,
    observers: Vec<(Every, Instant, Observer<'a, T>)>,
    saver: Option<(f64, Instant, Saver<'a, T>)>,
    cancel: CancelToken,
    clock: Clock,
}

/// Where a run is: what a checkpoint holds besides terrain and states.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Clock {
    started: bool,
    steps: u64,
    time: f64,
    residual: Option<f64>,
    change: Change,
    volume_start: f64,
}

#[derive(Serialize, Deserialize)]
struct Saved<T> {
    clock: Clock,
    terrain: T,
    states: Vec<(String, Vec<u8>)>,
}

impl<'a, T: Terrain> Simulation<'a, T> {
    /// A simulation of a terrain without processes.
    pub fn new(terrain: T) -> Self {
        Self {
            terrain,
            processes: Vec::new(),
            dt: 0.0,
            stop: Stop::default(),
            refine: 0,
            seed: Seed::default(),
            maps: &NoMaps,
            observers: Vec::new(),
            saver: None,
            cancel: CancelToken::default(),
            clock: Clock::default(),
        }
    }

    /// Adds a process.
    ///
    /// # Errors
    /// What its parameters are wrong in.
    pub fn process<P: Process<T>>(mut self, params: P) -> Result<Self> {
        self.add(params)?;
        Ok(self)
    }

    /// Adds a process in place.
    ///
    /// # Errors
    /// What its parameters are wrong in.
    pub fn add<P: Process<T>>(&mut self, params: P) -> Result<()> {
        params.validate()?;
        self.processes.push(Box::new(Run::<P, P::State> { params, state: None }));
        Ok(())
    }

    /// The same simulation, for observers and maps that live less long.
    pub fn shorten<'b>(self) -> Simulation<'b, T>
    where
        'a: 'b,
    {
        let Self { terrain, processes, dt, stop, refine, seed, maps, cancel, clock, .. } = self;
        Simulation {
            terrain,
            processes,
            dt,
            stop,
            refine,
            seed,
            maps,
            observers: Vec::new(),
            saver: None,
            cancel,
            clock,
        }
    }

    /// The clock's step, s.
    pub fn dt(mut self, seconds: f64) -> Self {
        self.dt = seconds;
        self
    }

    /// When to stop.
    pub fn until(mut self, stop: Stop) -> Self {
        self.stop = stop;
        self
    }

    /// Brings terrains of so many coarser levels to a steady state first, each from the one before, and starts from the
    /// last: for steady states alone, since the way there is no history.
    pub fn refine(mut self, levels: u32) -> Self {
        self.refine = levels;
        self
    }

    /// The seed.
    pub fn seed(mut self, seed: Seed) -> Self {
        self.seed = seed;
        self
    }

    /// Where maps are read from.
    pub fn maps(mut self, maps: &'a dyn Maps) -> Self {
        self.maps = maps;
        self
    }

    /// Calls an observer now and then; [`ControlFlow::Break`] ends the run.
    pub fn observe(
        mut self,
        every: Every,
        observer: impl FnMut(&View<T>) -> Result<ControlFlow<()>> + Send + 'a,
    ) -> Self {
        self.observers.push((every, Instant::now(), Box::new(observer)));
        self
    }

    /// Calls `save` (which will want [`Simulation::checkpoint`]) each time so many seconds have passed on the wall.
    pub fn save_every(mut self, seconds: f64, save: impl FnMut(&Simulation<'_, T>) -> Result<()> + Send + 'a) -> Self {
        self.saver = Some((seconds, Instant::now(), Box::new(save)));
        self
    }

    /// Lets somebody else end the run.
    pub fn cancel(mut self, token: CancelToken) -> Self {
        self.cancel = token;
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

    /// Everything that [`Simulation::resume`] needs, as bytes; `key` names what it belongs to.
    ///
    /// # Errors
    /// [`Error::Format`] if a state cannot be encoded.
    pub fn checkpoint(&self, key: &str) -> Result<Vec<u8>> {
        let states = self.processes.iter().map(|p| Ok((p.name().into(), p.save()?))).collect::<Result<_>>()?;
        pack("checkpoint", key, &Saved { clock: self.clock, terrain: self.terrain.clone(), states })
    }

    /// Goes back to a checkpoint of a simulation that was set up in the same way.
    ///
    /// # Errors
    /// [`Error::Format`] if it is damaged or belongs to another simulation.
    pub fn resume(mut self, key: &str, checkpoint: &[u8]) -> Result<Self> {
        let saved: Saved<T> = unpack("checkpoint", key, checkpoint)?;
        if !self.processes.iter().map(|p| p.name()).eq(saved.states.iter().map(|s| s.0.as_str())) {
            return Err(Error::format("landform state", "it is of other processes"));
        }
        for (process, (_, state)) in self.processes.iter_mut().zip(&saved.states) {
            process.load(state)?;
        }
        self.terrain = saved.terrain;
        self.clock = saved.clock;
        Ok(self)
    }

    /// Runs until something stops it. A cancelled run can be saved and resumed; any other is finished.
    ///
    /// # Errors
    /// What a process or an observer reports; [`Error::NonFinite`] from the guard; [`Error::Parameter`] for a clock that
    /// cannot run.
    pub fn run(&mut self) -> Result<Outcome> {
        self.check_clock()?;
        if !self.clock.started {
            self.start_from_coarse()?;
        }
        let stopped = loop {
            if let Some(stopped) = self.reason_to_stop() {
                break stopped;
            }
            if self.advance()?.is_break() {
                break Stopped::ByObserver;
            }
        };
        if stopped != Stopped::Cancelled {
            for process in &mut self.processes {
                process.finish(&mut self.terrain)?;
            }
        }
        let c = self.clock;
        let budget = Budget { change: c.change, volume_start: c.volume_start, volume_end: self.terrain.volume() };
        Ok(Outcome { stopped, steps: c.steps, time: c.time, residual: c.residual, budget })
    }

    fn check_clock(&self) -> Result<()> {
        let duration = self.stop.time.unwrap_or(f64::INFINITY);
        if !(self.dt.is_finite() && self.dt > 0.0) {
            return Err(Error::parameter("clock.dt", format!("{} s", self.dt), "> 0 s, for example \"1 kyr\""));
        }
        if !(duration >= 0.0) {
            return Err(Error::parameter("clock.duration", format!("{duration} s"), "at least 0 s"));
        }
        if self.stop.time.is_none() && self.stop.steady.is_none() && self.stop.steps.is_none() {
            return Err(Error::parameter("clock", "without end", "`duration`, `until = \"steady\"` or `max_steps`"));
        }
        Ok(())
    }

    /// Starts, with the shape that coarser levels came to. Observers see nothing of those.
    fn start_from_coarse(&mut self) -> Result<()> {
        let mut levels: Vec<T> = Vec::new();
        for _ in 0..self.refine {
            match levels.last().unwrap_or(&self.terrain).coarser() {
                Some(coarser) => levels.push(coarser),
                None => break,
            }
        }
        let mut coarse: Option<T> = None;
        while let Some(level) = levels.pop() {
            let fine = std::mem::replace(&mut self.terrain, level);
            if self.start_shaped(coarse.as_ref()).is_err() {
                // Too coarse, for the outlets that were asked for for example; the finest level says what is really wrong.
                self.terrain = fine;
                continue;
            }
            self.settle()?;
            coarse = Some(std::mem::replace(&mut self.terrain, fine));
            if self.cancel.is_cancelled() {
                // Nothing has begun yet: whoever resumes begins here.
                self.clock = Clock::default();
                return Ok(());
            }
        }
        self.start_shaped(coarse.as_ref())
    }

    fn start_shaped(&mut self, coarse: Option<&T>) -> Result<()> {
        self.start()?;
        if let Some(coarse) = coarse {
            self.terrain.take_elevation_of(coarse);
            self.clock.volume_start = self.terrain.volume();
        }
        Ok(())
    }

    /// Steps without anyone looking, until a coarse level is steady enough to start a finer one.
    fn settle(&mut self) -> Result<()> {
        let goal = self.stop.steady.unwrap_or(ENOUGH_FOR_THE_NEXT_LEVEL).max(ENOUGH_FOR_THE_NEXT_LEVEL);
        for _ in 0..MOST_STEPS_A_LEVEL {
            if self.cancel.is_cancelled() || self.clock.residual.is_some_and(|r| r <= goal) {
                break;
            }
            self.step(self.next_dt())?;
        }
        Ok(())
    }

    fn start(&mut self) -> Result<()> {
        for (k, process) in self.processes.iter_mut().enumerate() {
            let context = Context { seed: self.seed.with(k as u64), maps: self.maps };
            process.start(&mut self.terrain, &context)?;
        }
        self.clock = Clock { started: true, volume_start: self.terrain.volume(), ..Clock::default() };
        Ok(())
    }

    fn is_end_time(&self, time: f64) -> bool {
        // A remainder below a billionth of the step is rounding, not time.
        self.stop.time.is_some_and(|t| time >= t - 1e-9 * self.dt)
    }

    fn steps_are_used_up(&self, steps: u64) -> bool {
        let most = self.stop.steps.or(self.stop.time.is_none().then_some(MOST_STEPS_WITHOUT_END));
        most.is_some_and(|n| steps >= n)
    }

    fn reason_to_stop(&self) -> Option<Stopped> {
        if self.is_end_time(self.clock.time) {
            Some(Stopped::EndTime)
        } else if self.stop.steady.zip(self.clock.residual).is_some_and(|(tolerance, r)| r <= tolerance) {
            Some(Stopped::Steady)
        } else if !self.processes.is_empty() && self.processes.iter().all(|p| p.is_at_rest(&self.terrain)) {
            Some(Stopped::AtRest)
        } else if self.steps_are_used_up(self.clock.steps) {
            Some(Stopped::MaxSteps)
        } else if self.cancel.is_cancelled() {
            Some(Stopped::Cancelled)
        } else {
            None
        }
    }

    fn next_dt(&self) -> f64 {
        let mut dt = self.dt;
        for process in &self.processes {
            dt = dt.min(process.max_step(&self.terrain).unwrap_or(dt));
        }
        let mut until = |t: f64| {
            let left = t - self.clock.time;
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
                until(next_multiple(self.clock.time, *interval));
            }
        }
        dt
    }

    fn advance(&mut self) -> Result<ControlFlow<()>> {
        let dt = self.next_dt();
        let change = self.step(dt)?;
        self.look(dt, change)
    }

    fn step(&mut self, dt: f64) -> Result<Change> {
        let before = self.stop.steady.map(|_| self.terrain.watched().to_vec());
        let (clock, seed, cancel) = (self.clock, self.seed, &self.cancel);
        let may_be_last =
            self.stop.steady.is_some() || self.steps_are_used_up(clock.steps + 1) || self.is_end_time(clock.time + dt);
        let of = self.stop.steps.filter(|_| self.stop.time.is_none() && self.stop.steady.is_none());
        let at = |k: usize| Step {
            index: clock.steps,
            of,
            time: clock.time,
            dt,
            may_be_last,
            seed: seed.with(k as u64).with(clock.steps),
            cancel: cancel.clone(),
        };
        for (k, process) in self.processes.iter_mut().enumerate() {
            process.begin(&self.terrain, &at(k))?;
        }
        let mut change = Change::default();
        for (k, process) in self.processes.iter_mut().enumerate() {
            let at = at(k);
            change = change.plus(process.step(&mut self.terrain, &at)?);
            if let Some((field, node)) = self.terrain.find_non_finite() {
                return Err(Error::NonFinite {
                    field: field.into(),
                    node,
                    after: format!("`{}` in step {}", process.name(), at.index),
                });
            }
        }
        let residual = before.map(|before| residual(&before, self.terrain.watched(), change.raised));
        let time = self.clock.time + dt;
        let steps = self.clock.steps + 1;
        self.clock = Clock { steps, time, residual, change: self.clock.change.plus(change), ..self.clock };
        Ok(change)
    }

    fn look(&mut self, dt: f64, change: Change) -> Result<ControlFlow<()>> {
        let Clock { steps, time, residual, .. } = self.clock;
        let view = View { terrain: &self.terrain, steps, time, dt, residual, change };
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
        if let Some((seconds, last, mut save)) = self.saver.take() {
            let due = last.elapsed().as_secs_f64() >= seconds;
            if due {
                save(self)?;
            }
            self.saver = Some((seconds, if due { Instant::now() } else { last }, save));
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// The greatest change over what supply would have raised, or over the relief where a long step would have raised more.
fn residual(before: &[f64], after: &[f64], raised: f64) -> f64 {
    let greatest = parallel::max(after.len(), |i| (after[i] - before[i]).abs()).max(0.0);
    let relief = parallel::max(after.len(), |i| after[i]) + parallel::max(after.len(), |i| -after[i]);
    let scale = if relief > 0.0 { raised.min(relief) } else { raised };
    if scale > 0.0 { greatest / scale } else { greatest }
}
