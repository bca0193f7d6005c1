//! Steady states from coarse to fine.

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
        let mut levels: Vec<T> = Vec::new();
        for _ in 0..self.levels {
            match (self.coarser)(levels.last().unwrap_or(&model.terrain)) {
                Some(coarser) => levels.push(coarser),
                None => break,
            }
        }
        let mut coarse: Option<T> = None;
        while let Some(level) = levels.pop() {
            let fine = model.exchange(level);
            if self.start_shaped(model, coarse.as_ref()).is_err() {
                // Too coarse, for the outlets that were asked for for example; the finest level
                // says what is really wrong.
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
        self.start_shaped(model, coarse.as_ref())
    }

    fn start_shaped(&self, model: &mut Model<T>, coarse: Option<&T>) -> Result<()> {
        model.clock = Clock::default();
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
