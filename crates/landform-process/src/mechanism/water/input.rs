//! What a round of runoff is given, and what waits for water that comes late.

use landform_core::grid::{Domain, RasterDomain, Status};

use super::Supply;

/// What a round runs over.
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

/// A pool or a node that overflow has come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum OverflowEvent {
    Pool(u32),
    Node(u32),
}
