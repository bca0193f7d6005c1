//! The thread that computes previews: one at a time, and the newest that is asked for.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use landform::core::terrain::AnyTerrain;
use landform::core::verb::{CancelToken, Event, MemoryOutput};
use landform::io::memory;
use landform::recipe::{Cache, Level, Looker, Options, Outputs, Ran, Signal};
use landform::{Error, Result};

use super::charts::Charts;
use super::control::Control;
use super::layers::Rasters;
use super::order::{Order, halvings};
use super::paint::Easel;
use super::state::{Board, Lap, follow};
use super::watching::{Lefts, Watching};
use crate::hub::{Hub, lock};

/// While a value is dragged, a run that began so recently is let come to its end.
const LET_END: Duration = Duration::from_millis(1_000);
/// While a value is held, its process goes on for so long.
const HELD: Duration = Duration::from_secs(5);
/// A level that takes longer is too slow for a drag, s.
const QUICK: f64 = 0.05;

/// Computes previews.
pub(crate) struct Worker {
    desk: Mutex<Desk>,
    wake: Condvar,
    pub(crate) control: Control,
    pub(crate) board: Board,
    hub: Arc<Hub>,
    charts: Arc<Charts>,
    cache: Cache,
    rasters: Rasters,
    lefts: Mutex<Lefts>,
    pub(crate) easel: Easel,
    /// Seconds that the last run of each level took.
    speeds: Mutex<[Option<f64>; 7]>,
    /// Gets the seconds of the stages of a run.
    timed: Box<dyn Fn(u64, Vec<Option<f64>>) + Send + Sync>,
}

#[derive(Default)]
struct Desk {
    next: Option<Order>,
    running: Option<Running>,
    closed: bool,
}

struct Running {
    cancel: CancelToken,
    since: Instant,
    dragging: bool,
    watched: bool,
    shown: Arc<AtomicBool>,
}

impl Worker {
    /// `memory` bytes of ground are kept from run to run.
    pub(crate) fn new(
        hub: Arc<Hub>,
        charts: Arc<Charts>,
        memory: u64,
        timed: impl Fn(u64, Vec<Option<f64>>) + Send + Sync + 'static,
    ) -> Self {
        Self {
            desk: Mutex::default(),
            wake: Condvar::new(),
            control: Control::default(),
            board: Board::new(),
            hub,
            charts,
            cache: Cache::in_memory(memory),
            rasters: Rasters::default(),
            lefts: Mutex::default(),
            easel: Easel::default(),
            speeds: Mutex::default(),
            timed: Box::new(timed),
        }
    }

    /// Asks for a run; what runs is cancelled, unless both are of one drag and it is about to end.
    pub(crate) fn ask(&self, order: Order) {
        let mut desk = lock(&self.desk);
        if let Some(running) = &desk.running {
            let ends_soon = running.since.elapsed() < LET_END && !running.shown.load(Ordering::Relaxed);
            if !(order.dragging && running.dragging && ends_soon) {
                running.cancel.cancel();
            }
        }
        desk.next = Some(order);
        self.wake.notify_one();
    }

    /// Cancels what runs and what waits.
    pub(crate) fn stop(&self) {
        let mut desk = lock(&self.desk);
        desk.next = None;
        desk.running.iter().for_each(|running| running.cancel.cancel());
    }

    /// Whether a run of which every step is shown goes on or waits.
    pub(crate) fn is_watched(&self) -> bool {
        let desk = lock(&self.desk);
        desk.next.as_ref().map_or(desk.running.as_ref().is_some_and(|run| run.watched), |next| next.watched)
    }

    /// Whether something runs or waits.
    pub(crate) fn is_busy(&self) -> bool {
        let desk = lock(&self.desk);
        desk.running.is_some() || desk.next.is_some()
    }

    /// Ends the thread.
    pub(crate) fn close(&self) {
        self.stop();
        lock(&self.desk).closed = true;
        self.wake.notify_one();
    }

    /// Computes until it is closed.
    pub(crate) fn work(&self) {
        loop {
            let (order, cancel, shown) = {
                let mut desk = lock(&self.desk);
                desk.running = None;
                let order = loop {
                    if desk.closed {
                        return;
                    }
                    match desk.next.take() {
                        Some(order) => break order,
                        None => desk = self.wake.wait(desk).unwrap_or_else(PoisonError::into_inner),
                    }
                };
                let (cancel, shown) = (CancelToken::default(), Arc::new(AtomicBool::new(false)));
                let (since, dragging, watched) = (Instant::now(), order.dragging, order.watched);
                desk.running = Some(Running { cancel: cancel.clone(), since, dragging, watched, shown: shown.clone() });
                (order, cancel, shown)
            };
            // A mistake of the program ends this run, not the studio.
            let whole = catch_unwind(AssertUnwindSafe(|| self.preview(&order, &cancel, &shown)));
            if whole.is_err() {
                let text = "the run broke off by a mistake of the program; please report it with the recipe";
                self.hub.log("error", text);
                self.board.set(&self.hub, |state| state.error = Some(text.into()));
            }
            self.board.set(&self.hub, |state| (state.running, state.settling, state.paused) = (false, false, false));
        }
    }

    fn preview(&self, order: &Order, cancel: &CancelToken, shown: &AtomicBool) {
        let is_kept = |k: u32| order.goes_on.is_some_and(|stage| lock(&self.lefts).contains_key(&(k, stage)));
        let too_slow = |k: u32| !is_kept(k) && lock(&self.speeds)[k as usize].is_some_and(|seconds| seconds > QUICK);
        let levels = order.levels(too_slow);
        let mut failed = None;
        let mut was_shown = false;
        for (k, &level) in levels.iter().enumerate() {
            if cancel.is_cancelled() {
                return;
            }
            match self.level(order, level, cancel) {
                Ok(true) => {
                    was_shown = true;
                    shown.store(true, Ordering::Relaxed);
                    if order.dragging {
                        self.settle(order, level, cancel);
                    }
                }
                Ok(false) => return,
                // Too coarse for a stage, or too fine for the memory: another level may do.
                Err(error) => {
                    let is_last = k + 1 == levels.len();
                    self.hub.log(if is_last { "error" } else { "note" }, &format!("level {level}: {error}"));
                    failed = is_last.then_some(error);
                }
            }
        }
        if let Some(error) = failed {
            let text = error.hint().map_or(error.to_string(), |hint| format!("{error}; {hint}"));
            self.board.set(&self.hub, |state| state.error = Some(text).filter(|_| !was_shown));
        }
    }

    /// While a value is held, what it changes goes on, until something else is asked for.
    fn settle(&self, order: &Order, level: Level, cancel: &CancelToken) {
        let further = Order { stamp: None, recipe: order.recipe.clone(), steps: order.steps.clone(), ..*order };
        let since = Instant::now();
        if !self.board.get().settling {
            return;
        }
        while since.elapsed() < HELD && !cancel.is_cancelled() && lock(&self.desk).next.is_none() {
            if !self.hub.has_room() {
                std::thread::sleep(Duration::from_millis(4));
                continue;
            }
            match self.level(&further, level, cancel) {
                Ok(true) => {}
                _ => return,
            }
        }
    }

    /// Forgets what processes left.
    pub(crate) fn forget(&self) {
        lock(&self.lefts).clear();
        self.easel.clear();
        *lock(&self.speeds) = Default::default();
    }

    /// Whether processes of a stage can go on at a level from where they ended.
    pub(crate) fn can_go_on(&self, level: Level, stage: usize) -> bool {
        lock(&self.lefts).contains_key(&(halvings(level), stage))
    }

    /// Runs one level and shows it; false if it was cancelled.
    fn level(&self, order: &Order, level: Level, cancel: &CancelToken) -> Result<bool> {
        let began = Instant::now();
        let recipe = order.recipe.at(level)?;
        let recipe = order.shown.map_or(recipe.clone(), |shown| recipe.up_to(shown));
        let bytes = recipe.plan(Some(&self.cache), "")?.bytes;
        if let Some(available) = memory::available().filter(|available| bytes > *available) {
            return Err(Error::Memory { what: "this level".into(), needed: bytes, available });
        }
        self.board.set(&self.hub, |state| {
            (state.running, state.level, state.error) = (true, level.to_string(), None);
            (state.memory_bytes, state.seconds, state.seconds_left) = (bytes, 0.0, None);
            (state.paused, state.settling) = (order.watched && self.control.is_paused(), false);
        });
        let watching = Watching {
            hub: &self.hub,
            board: &self.board,
            control: &self.control,
            rasters: &self.rasters,
            order,
            level: level.to_string(),
            cancel: cancel.clone(),
            sea_level: super::sea::level_of(&recipe),
            last: Mutex::new(Instant::now()),
            easel: &self.easel,
            halvings: halvings(level),
            lefts: &self.lefts,
            changed: AtomicBool::new(false),
            began,
        };
        let lap = Lap::default();
        let progress = |signal: Signal| {
            if let Signal::Stage { index, cached, .. } = signal {
                lap.begin(index, cached);
            }
            self.board.nudge(&self.hub, |state| {
                follow(state, &signal, &order.steps, &lap);
                state.seconds = began.elapsed().as_secs_f64();
            });
        };
        let options = Options {
            cache: Some(&self.cache),
            cancel: cancel.clone(),
            outputs: Outputs::Nothing,
            progress: &progress,
            look: Some(&watching),
            ..Options::default()
        };
        let Ran::ToTheEnd(ground, history) = recipe.run(&mut MemoryOutput::default(), &options)? else {
            if !watching.has_changed_it() {
                self.note_speed(level, began);
            }
            return Ok(false);
        };
        lap.end();
        watching.show(&ground, time_of(&history), false)?;
        if !watching.has_changed_it() {
            self.note_speed(level, began);
            (self.timed)(order.revision, std::mem::take(&mut *lock(&lap.seconds)));
        }
        self.board.set(&self.hub, |state| {
            (state.seconds, state.seconds_left) = (began.elapsed().as_secs_f64(), None);
        });
        if !order.dragging {
            self.chart(order, level, ground, watching.sea_level);
        }
        Ok(true)
    }

    fn note_speed(&self, level: Level, began: Instant) {
        lock(&self.speeds)[halvings(level) as usize] = Some(began.elapsed().as_secs_f64());
    }

    fn chart(&self, order: &Order, level: Level, ground: Arc<AnyTerrain>, sea_level: Option<f64>) {
        self.charts.ask(order.revision, level.to_string(), ground, sea_level);
    }
}

/// Time at which processes ended, s.
fn time_of(history: &[Event]) -> f64 {
    history.iter().rev().find_map(|event| event.outcome).map_or(0.0, |outcome| outcome.time)
}
