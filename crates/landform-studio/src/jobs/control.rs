//! Holding a run and letting it go.

use std::sync::{Condvar, Mutex};
use std::time::{Duration, Instant};

use landform::core::verb::CancelToken;

use crate::hub::lock;

/// Longest time between looks at the cancel token.
const NAP: Duration = Duration::from_millis(20);
/// Longest pace, ms.
const MOST_PACE: f64 = 10_000.0;

/// Whether runs are held.
#[derive(Default)]
pub(crate) struct Control {
    hold: Mutex<Hold>,
    wake: Condvar,
}

#[derive(Clone, Copy, Default)]
struct Hold {
    paused: bool,
    /// Steps that a held run may still take.
    steps: u64,
    /// Least time from step to step.
    pace: Duration,
    /// A held run has something to do before it goes on holding.
    nudged: bool,
}

impl Control {
    pub(crate) fn pause(&self) {
        let mut hold = lock(&self.hold);
        (hold.paused, hold.steps) = (true, 0);
    }

    pub(crate) fn play(&self, pace: Option<f64>) {
        let mut hold = lock(&self.hold);
        (hold.paused, hold.steps) = (false, 0);
        if let Some(pace) = pace.filter(|pace| pace.is_finite()) {
            hold.pace = Duration::from_secs_f64(pace.clamp(0.0, MOST_PACE) / 1e3);
        }
        self.wake.notify_all();
    }

    /// One step, after which it holds.
    pub(crate) fn step(&self) {
        let mut hold = lock(&self.hold);
        hold.steps = if hold.paused { hold.steps.saturating_add(1) } else { 1 };
        hold.paused = true;
        self.wake.notify_all();
    }

    /// Lets a held run look again.
    pub(crate) fn nudge(&self) {
        lock(&self.hold).nudged = true;
        self.wake.notify_all();
    }

    pub(crate) fn is_paused(&self) -> bool {
        lock(&self.hold).paused
    }

    /// Whether a run holds now.
    pub(crate) fn holds(&self) -> bool {
        let hold = lock(&self.hold);
        hold.paused && hold.steps == 0
    }

    /// The step that was just taken is one of those allowed.
    pub(crate) fn count(&self, cancel: &CancelToken) {
        if !cancel.is_cancelled() {
            let mut hold = lock(&self.hold);
            hold.steps = hold.steps.saturating_sub(1);
        }
    }

    /// Returns when the next step may be taken, or the run is cancelled. The last step was taken at
    /// `paced`, if there is to be a pace. False if there is something to do meanwhile.
    pub(crate) fn wait(&self, paced: Option<Instant>, cancel: &CancelToken) -> bool {
        let mut hold = lock(&self.hold);
        while !cancel.is_cancelled() {
            if std::mem::take(&mut hold.nudged) {
                return false;
            }
            let rest = paced.map_or(Duration::ZERO, |last| hold.pace.saturating_sub(last.elapsed()));
            let held = hold.paused && hold.steps == 0;
            if !held && rest.is_zero() {
                return true;
            }
            let nap = if held { NAP } else { rest.min(NAP) };
            hold = self.wake.wait_timeout(hold, nap).unwrap_or_else(std::sync::PoisonError::into_inner).0;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_held_run_can_be_cancelled_and_stepped() {
        let control = Control::default();
        let cancel = CancelToken::default();
        assert!(control.wait(None, &cancel));
        control.step();
        assert!(control.is_paused() && !control.holds());
        control.count(&cancel);
        assert!(control.holds());
        std::thread::scope(|scope| {
            let waits = scope.spawn(|| control.wait(None, &cancel));
            std::thread::sleep(Duration::from_millis(30));
            assert!(!waits.is_finished());
            control.nudge();
            assert!(!waits.join().unwrap());
            let waits = scope.spawn(|| control.wait(Some(Instant::now()), &cancel));
            cancel.cancel();
            assert!(waits.join().unwrap());
        });
        control.play(Some(f64::NAN));
        assert!(!control.is_paused());
    }
}
