//! What is going on, as pages show it.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use landform::recipe::Signal;
use serde::Serialize;
use serde_json::json;

use crate::hub::{Hub, Slot, lock};

/// Steps are told no more often.
const EVERY: Duration = Duration::from_millis(50);

/// The preview.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct State {
    pub(crate) running: bool,
    pub(crate) paused: bool,
    pub(crate) settling: bool,
    /// Level that runs or ran last.
    pub(crate) level: String,
    /// The step of the text that runs.
    pub(crate) stage: Option<usize>,
    /// How many steps there are.
    pub(crate) of: usize,
    pub(crate) name: String,
    pub(crate) steps: u64,
    /// Time of the process, s.
    pub(crate) time: f64,
    /// Part of the step that is done.
    pub(crate) part: Option<f64>,
    pub(crate) residual: Option<f64>,
    /// Memory that the level takes.
    pub(crate) memory_bytes: u64,
    /// Wall-clock time of the level.
    pub(crate) seconds: f64,
    pub(crate) seconds_left: Option<f64>,
    /// Why the last run failed.
    pub(crate) error: Option<String>,
    pub(crate) building: Option<Building>,
}

/// What is done in the background.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct Building {
    pub(crate) what: &'static str,
    pub(crate) stage: Option<usize>,
    pub(crate) of: usize,
    pub(crate) name: String,
    pub(crate) part: Option<f64>,
    pub(crate) seconds: f64,
    pub(crate) waiting: usize,
}

/// The state, told as it changes.
pub(crate) struct Board {
    inner: Mutex<(State, Instant)>,
}

impl Board {
    pub(crate) fn new() -> Self {
        Self { inner: Mutex::new((State::default(), Instant::now())) }
    }

    /// Changes the state and tells it.
    pub(crate) fn set(&self, hub: &Hub, change: impl FnOnce(&mut State)) {
        let mut inner = lock(&self.inner);
        change(&mut inner.0);
        inner.1 = Instant::now();
        tell(hub, &inner.0);
    }

    /// Changes the state; tells it if that was not done a moment ago.
    pub(crate) fn nudge(&self, hub: &Hub, change: impl FnOnce(&mut State)) {
        let mut inner = lock(&self.inner);
        change(&mut inner.0);
        if inner.1.elapsed() >= EVERY {
            inner.1 = Instant::now();
            tell(hub, &inner.0);
        }
    }

    pub(crate) fn get(&self) -> State {
        lock(&self.inner).0.clone()
    }
}

fn tell(hub: &Hub, state: &State) {
    let mut json = json!(state);
    json["tell"] = "state".into();
    hub.tell(Slot::State, &json);
}

/// Times of the stages of a run.
#[derive(Default)]
pub(crate) struct Lap {
    at: Mutex<Option<(usize, bool, Instant)>>,
    pub(crate) seconds: Mutex<Vec<Option<f64>>>,
}

impl Lap {
    /// A stage (from 1) begins; the one before has ended.
    pub(crate) fn begin(&self, index: usize, cached: bool) {
        let before = lock(&self.at).replace((index, cached, Instant::now()));
        self.put(before);
    }

    /// The last stage has ended.
    pub(crate) fn end(&self) {
        let before = lock(&self.at).take();
        self.put(before);
    }

    fn put(&self, ended: Option<(usize, bool, Instant)>) {
        let Some((index, false, since)) = ended else { return };
        let mut seconds = lock(&self.seconds);
        if seconds.len() < index {
            seconds.resize(index, None);
        }
        seconds[index - 1] = Some(since.elapsed().as_secs_f64());
    }

    /// Seconds since the stage that runs began.
    pub(crate) fn of_stage(&self) -> f64 {
        lock(&self.at).map_or(0.0, |(.., since)| since.elapsed().as_secs_f64())
    }
}

/// Puts a signal of a run to the state of the preview.
pub(crate) fn follow(state: &mut State, signal: &Signal, steps: &[usize], lap: &Lap) {
    match signal {
        Signal::Stage { index, of, name, .. } => {
            state.stage = steps.get(index - 1).copied();
            (state.of, state.name) = (*of, name.clone());
            (state.steps, state.time, state.part, state.residual, state.seconds_left) = Default::default();
        }
        Signal::Step { steps, time, part, residual } => {
            (state.steps, state.time, state.part, state.residual) = (*steps, *time, *part, *residual);
            let left = |part: f64| (part > 0.02).then(|| lap.of_stage() * (1.0 - part).max(0.0) / part);
            state.seconds_left = part.and_then(left);
        }
        _ => {}
    }
}
