//! From coarse to fine: steady states, and runs over a time.

use super::Model;
use super::model::Clock;
use super::steady::{Watched, step_watched};
use crate::Result;
use crate::terrain::{Refine, Terrain};

/// Residual of a coarse level that a finer one starts from.
const ENOUGH_FOR_THE_NEXT_LEVEL: f64 = 1e-6;
/// A coarse level that takes longer is left as it is.
const MOST_STEPS_A_LEVEL: usize = 100;

/// What a run needs to begin with coarser forms of its terrain.
pub(super) struct Refining<T> {
    levels: u32,
    coarser: fn(&T) -> Option<T>,
    take_shape_of: fn(&mut T, &T),
}

impl<T: Terrain> Refining<T> {
    pub(super) fn new(levels: u32) -> Self
    where
        T: Refine,
    {
        Self { levels, coarser: T::coarser, take_shape_of: T::take_shape_of }
    }

    /// Starts with the shape that coarser levels reached. Observers are not called for those.
    pub(super) fn start(&self, model: &mut Model<T>, steady: Option<f64>, watched: Option<Watched<T>>) -> Result<()> {
        let mut levels = self.levels(&model.terrain);
        let mut coarse: Option<T> = None;
        while let Some(level) = levels.pop() {
            let fine = model.exchange(level);
            if self.start_shaped(model, coarse.as_ref(), Clock::default()).is_err() {
                // Too coarse, for the outlets that were asked for for example; the finest level says what is really wrong.
                model.exchange(fine);
                continue;
            }
            settle(model, steady, watched)?;
            coarse = Some(model.exchange(fine));
            if model.cancel.is_cancelled() {
                // Nothing has begun yet: whoever resumes begins here.
                return Ok(());
            }
        }
        self.start_shaped(model, coarse.as_ref(), Clock::default())
    }

    /// Lets coarser levels live through the first part of the time until `end` (s): the coarsest through a half of it, each finer one
    /// through a half of what is left. Observers are not called for those.
    pub(super) fn grow(&self, model: &mut Model<T>, end: f64) -> Result<()> {
        let begin = model.clock;
        let (mut levels, mut now, mut coarse) = (self.levels(&model.terrain), begin, None::<T>);
        while let Some(level) = levels.pop() {
            let fine = model.exchange(level);
            if self.start_shaped(model, coarse.as_ref(), now).is_err() {
                // As above.
                model.exchange(fine);
                continue;
            }
            let until = now.time + 0.5 * (end - now.time);
            while model.clock.time < until - 1e-9 * model.dt && !model.cancel.is_cancelled() {
                let left = until - model.clock.time;
                model.take_step(model.allowed(model.dt).min(left))?;
            }
            let cancelled = model.cancel.is_cancelled();
            now = Clock { time: model.clock.time, steps: model.clock.steps, ..Clock::default() };
            coarse = Some(model.exchange(fine));
            if cancelled {
                model.clock = begin;
                return Ok(());
            }
        }
        self.start_shaped(model, coarse.as_ref(), now)
    }

    /// The coarser forms of a terrain, the coarsest last.
    fn levels(&self, terrain: &T) -> Vec<T> {
        let mut levels: Vec<T> = Vec::new();
        for _ in 0..self.levels {
            match (self.coarser)(levels.last().unwrap_or(terrain)) {
                Some(coarser) => levels.push(coarser),
                None => break,
            }
        }
        levels
    }

    fn start_shaped(&self, model: &mut Model<T>, coarse: Option<&T>, at: Clock) -> Result<()> {
        model.clock = at;
        model.start()?;
        if let Some(coarse) = coarse {
            (self.take_shape_of)(&mut model.terrain, coarse);
            model.clock.volume_start = model.terrain.volume();
        }
        Ok(())
    }
}

/// Steps until a coarse level is steady enough to start a finer one.
fn settle<T: Terrain>(model: &mut Model<T>, steady: Option<f64>, watched: Option<Watched<T>>) -> Result<()> {
    let goal = steady.unwrap_or(ENOUGH_FOR_THE_NEXT_LEVEL).max(ENOUGH_FOR_THE_NEXT_LEVEL);
    for _ in 0..MOST_STEPS_A_LEVEL {
        if model.cancel.is_cancelled() || model.clock.residual.is_some_and(|r| r <= goal) {
            break;
        }
        step_watched(model, model.allowed(model.dt), watched)?;
    }
    Ok(())
}
