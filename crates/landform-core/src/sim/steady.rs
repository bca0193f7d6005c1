//! The residual: how far a terrain is from steady.

use super::{Model, StepReport};
use crate::terrain::Terrain;
use crate::{Result, parallel};

/// The values whose change decides whether a terrain is steady.
pub(super) type Watched<T> = fn(&T) -> &[f64];

/// Takes one step of `dt` s; the residual is kept if `watched` says of what.
pub(super) fn step_watched<T: Terrain>(
    model: &mut Model<T>,
    dt: f64,
    watched: Option<Watched<T>>,
) -> Result<StepReport> {
    let before = watched.map(|values| values(&model.terrain).to_vec());
    let report = model.take_step(dt)?;
    let residual =
        |(values, before): (Watched<T>, Vec<f64>)| residual(&before, values(&model.terrain), report.change.raised);
    model.clock.residual = watched.zip(before).map(residual);
    Ok(report)
}

/// The greatest change over what supply would have raised, or over the relief where a long step
/// would have raised more.
fn residual(before: &[f64], after: &[f64], raised: f64) -> f64 {
    let greatest = parallel::max(after.len(), |i| (after[i] - before[i]).abs()).max(0.0);
    let relief = parallel::max(after.len(), |i| after[i]) + parallel::max(after.len(), |i| -after[i]);
    let scale = if relief > 0.0 { raised.min(relief) } else { raised };
    if scale > 0.0 { greatest / scale } else { greatest }
}
