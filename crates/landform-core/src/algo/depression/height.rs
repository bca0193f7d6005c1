//! Heights as keys of queues.

/// A height that is ordered totally.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Height(
    /// The height, m.
    pub f64,
);

impl Eq for Height {}

impl PartialOrd for Height {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Height {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}
