//! Running processes in time.

mod checkpoint;
mod running;
mod schedule;
mod simulation;
#[cfg(test)]
mod tests;

pub use crate::verb::{Budget, Outcome, Stopped};
pub use checkpoint::{is_for, pack, unpack};
pub use schedule::{Every, Stop};
pub use simulation::{Simulation, View};
