//! Water on the ground: four transports behind one interface.
//!
//! # Model
//! A round brings water (rain, springs, inflow along sides), moves it, and tells what passed each node; what stands in hollows stays for
//! the next round. *Columns* and *averages* move all the water of a round at once, down to where it stands or leaves: between rounds only
//! standing water is left, which is what years of rain look like from a mountain's age. *Pipes* move it second by second, with momentum.
//! The *area map* knows no amounts: every hollow is full, and area stands for water.
//!
//! # Limits
//! Nothing seeps in. Depth of running water is not part of the balance but for pipes.
//!
//! # Sources
//! Pytel (2015), 4.3.1 and 4.4.3. The seed moves water by one neighbour an iteration, so that its rivers are as deep as iterations are
//! short; here a round is long against the time that water takes to the border.

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
    /// Nodes that swallow all water; empty if none.
    pub sinks: &'a [bool],
}

/// Where the water of a round went, as depths summed over nodes, m: before + entered = stored + left + evaporated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ledger {
    /// Stored before.
    pub before: f64,
    /// Came in.
    pub entered: f64,
    /// Stored after.
    pub stored: f64,
    /// Left over base levels and sinks.
    pub left: f64,
    /// Evaporated.
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
