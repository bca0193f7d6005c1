//! The table of stages: the rows of every crate, joined.

use landform_core::stage::Stage;

/// Every stage, once.
pub fn stages() -> impl Iterator<Item = &'static Stage> + Clone {
    let parts = landform_process::STAGES.iter().chain(landform_io::STAGES);
    parts.flat_map(|rows| rows.iter())
}

/// The stage of a name.
pub(super) fn stage(name: &str) -> Option<&'static Stage> {
    stages().find(|s| s.name == name)
}
