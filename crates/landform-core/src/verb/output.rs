//! Where exports put their files: a folder for the command line, a map for tests.

use std::collections::BTreeMap;
use std::path::{Component, Path};

use crate::{Error, Result};

/// A place for files.
pub trait Output {
    /// Puts a whole file at a path relative to the place, all of it or nothing.
    ///
    /// # Errors
    /// [`Error::Io`], or [`Error::Parameter`] for a path that leads out of the place.
    fn put(&mut self, path: &str, bytes: &[u8]) -> Result<()>;
}

/// Files in memory.
#[derive(Clone, Debug, Default)]
pub struct MemoryOutput(pub BTreeMap<String, Vec<u8>>);

impl Output for MemoryOutput {
    fn put(&mut self, path: &str, bytes: &[u8]) -> Result<()> {
        self.0.insert(relative_path(path)?.into(), bytes.to_vec());
        Ok(())
    }
}

/// Refuses a path that leaves the output folder or does not end as one of `ends`.
///
/// # Errors
/// [`Error::Parameter`] otherwise.
pub fn check_path(path: &str, ends: &[&str]) -> Result<()> {
    relative_path(path)?;
    if ends.iter().any(|e| path.to_lowercase().ends_with(e)) {
        return Ok(());
    }
    Err(Error::parameter("path", format!("\"{path}\""), &format!("a name that ends with {}", ends.join(" or "))))
}

/// The path, if it names a file below where it is put.
///
/// # Errors
/// [`Error::Parameter`] otherwise.
pub fn relative_path(path: &str) -> Result<&str> {
    let inside = Path::new(path).components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    let own = Path::new(path).starts_with(".landform") || Path::new(path).starts_with("./.landform");
    if path.is_empty() || own || !inside || path.ends_with('/') {
        return Err(Error::parameter("path", format!("\"{path}\""), "a file name, below the output folder"));
    }
    Ok(path)
}
