//! Input of a round of runoff, and the events of overflow.

use landform_core::grid::{Domain, RasterDomain, Status};

use super::Supply;

/// Ground and water of a round.
pub(super) struct RunoffInput<'a> {
    pub(super) domain: &'a RasterDomain,
    pub(super) ground: &'a [f64],
    pub(super) supply: &'a Supply<'a>,
}

impl RunoffInput<'_> {
    /// Whether water leaves here.
    #[inline]
    pub(super) fn is_end(&self, i: usize) -> bool {
        self.domain.status()[i] == Status::BaseLevel || self.supply.sinks.get(i).copied().unwrap_or(false)
    }
}

/// A pool or a node that overflow has reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum OverflowEvent {
    Pool(u32),
    Node(u32),
}
