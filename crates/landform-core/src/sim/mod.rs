//! Running processes in time: a [`Model`] is stepped, examined and changed; a [`Simulation`] runs
//! it to an end.

mod checkpoint;
mod model;
mod refine;
mod running;
mod schedule;
mod simulation;
mod steady;
#[cfg(test)]
mod tests;

pub use crate::verb::{Budget, Outcome, Stopped};
pub use checkpoint::{is_for, pack, undamaged, unpack};
pub use model::{Model, StepReport, saved_steps};
pub use schedule::{Every, Stop};
pub use simulation::{Simulation, View};
