//! Water on the ground: four transports behind one interface.
//!
//! # Model
//! A round brings water (rain, springs, inflow along sides), moves it, and records the water that
//! passed each node. Water in depressions stays for the next round. *Columns* and *averages* move
//! all the water of a round at once, down to where it stands or leaves: between rounds only
//! standing water is left, as it appears on the time scale of mountains. *Pipes* move water in time
//! steps, with momentum. The *area map* has no amounts: every depression is full, and drainage area
//! replaces water.
//!
//! # Limits
//! Water does not seep into the ground. Depth of running water is part of the balance for pipes
//! only.
//!
//! # Sources
//! Pytel (2015), 4.3.1 and 4.4.3. The thesis moves water by one neighbour an iteration, so that the
//! shorter its iterations are, the deeper its rivers get; here a round is long against the time
//! that water takes to the border.

mod input;
mod load;
mod neighbours;
mod order;
mod pipes;
mod pools;
mod runoff;
mod spread;
mod sweep;

pub use order::highest_first;
pub use pipes::Pipes;
pub use spread::{FlowPartition, Rule};
pub use sweep::Sweep;

/// Water that a round brings and takes.
#[derive(Clone, Copy, Debug)]
pub struct Supply<'a> {
    /// Depth that comes to every node, m.
    pub depth: &'a [f64],
    /// Its sum, m.
    pub total: f64,
    /// Depth that evaporates from standing water, m.
    pub evaporation: f64,
    /// Sinkholes, nodes that take all water; empty if there are none.
    pub sinks: &'a [bool],
}

/// Balance of the water of a round, as depths summed over nodes, m: before + entered = stored +
/// left + evaporated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ledger {
    /// Water stored before, m³.
    pub before: f64,
    /// Water that entered, m³.
    pub entered: f64,
    /// Water stored after, m³.
    pub stored: f64,
    /// Water that left over base levels and into sinkholes, m³.
    pub left: f64,
    /// Evaporated, m³.
    pub evaporated: f64,
}

impl Ledger {
    /// The part of the water that is unaccounted for: 0 up to rounding.
    pub fn imbalance(&self) -> f64 {
        let all = self.before + self.entered;
        if all > 0.0 { ((all - self.stored - self.left - self.evaporated) / all).abs() } else { 0.0 }
    }
}

#[cfg(test)]
mod tests;
