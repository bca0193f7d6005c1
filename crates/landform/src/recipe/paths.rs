//! Paths as recipes write them.

use std::path::{Component, Path, PathBuf};

/// A path without steps that lead nowhere: "./a//b.png" is "a/b.png", and so is "c/../a/b.png".
pub(super) fn plain(path: &str) -> PathBuf {
    let mut plain = PathBuf::new();
    for step in Path::new(path).components() {
        match step {
            Component::CurDir => {}
            Component::ParentDir if matches!(plain.components().next_back(), Some(Component::Normal(_))) => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}
