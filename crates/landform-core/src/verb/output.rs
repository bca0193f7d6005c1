//! The place where exports put their files: a folder for the command line, a map for tests.

use std::collections::BTreeMap;
use std::path::{Component, Path};

use crate::{Error, Result};

/// A place for files.
pub trait Output {
    /// Puts a whole file at a path relative to the place, all of it or nothing.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be written, [`Error::Outside`] if the path leads out of the
    /// place.
    fn put(&mut self, path: &str, bytes: &[u8]) -> Result<()>;

    /// Takes note of what a file that was put does not hold of the landscape; a place without notes
    /// drops it.
    fn note(&mut self, _text: String) {}

    /// The notes since the last call.
    fn take_notes(&mut self) -> Vec<String> {
        Vec::new()
    }
}

/// Files in memory.
///
/// ```
/// use landform_core::verb::{MemoryOutput, Output};
///
/// let mut out = MemoryOutput::default();
/// out.put("maps/slope.npy", &[1, 2])?;
/// assert_eq!(out.0["maps/slope.npy"], [1, 2]);
/// assert!(out.put("../slope.npy", &[1, 2]).is_err());
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct MemoryOutput(pub BTreeMap<String, Vec<u8>>);

impl Output for MemoryOutput {
    fn put(&mut self, path: &str, bytes: &[u8]) -> Result<()> {
        self.0.insert(relative_path(path)?.into(), bytes.to_vec());
        Ok(())
    }
}

/// Whether a text is a name of letters, digits, spaces, _ and -, at most 60 bytes long.
///
/// ```
/// use landform_core::verb::is_plain_name;
///
/// assert!(is_plain_name("dead tree") && !is_plain_name("a/b") && !is_plain_name(" "));
/// ```
pub fn is_plain_name(name: &str) -> bool {
    let is_plain = |c: char| c.is_alphanumeric() || " _-".contains(c);
    !name.trim().is_empty() && name.len() <= 60 && name.chars().all(is_plain)
}

/// Refuses a path that names no file or does not end as one of `ends`, given without their dot.
///
/// # Errors
/// [`Error::Parameter`] if the path names no file, [`Error::Extension`] if it has another ending.
pub fn check_path(path: &str, ends: &[&'static str]) -> Result<()> {
    file_path(path)?;
    if ends.iter().any(|e| path.to_lowercase().ends_with(&format!(".{e}"))) {
        return Ok(());
    }
    Err(Error::extension("path", path, ends))
}

/// The path, if it can be that of a file: not empty, no folder, and not in the folder in which runs
/// keep their state.
///
/// # Errors
/// [`Error::Parameter`] if the path cannot be that of a file.
pub fn file_path(path: &str) -> Result<&str> {
    let own = Path::new(path).components().any(|c| c.as_os_str() == ".landform");
    let named = Path::new(path).file_name().is_some() && !path.ends_with(['/', '\\']) && !path.ends_with("/.");
    if own {
        let expected = "a name other than .landform, where runs keep their state";
        return Err(Error::parameter("path", format!("\"{path}\""), expected));
    }
    if !named || path.contains('\0') {
        return Err(Error::parameter("path", format!("\"{path}\""), "the name of a file"));
    }
    Ok(path)
}

/// The path, if it names a file below where it is put.
///
/// # Errors
/// [`Error::Outside`] if the path leads out of that place.
///
/// ```
/// # use landform_core::verb::relative_path;
/// assert_eq!(relative_path("maps/relief.png")?, "maps/relief.png");
/// assert!(relative_path("../relief.png").is_err());
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn relative_path(path: &str) -> Result<&str> {
    let inside = Path::new(path).components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    if !inside {
        return Err(Error::Outside { name: "path".into(), path: path.into(), by_link: false });
    }
    file_path(path)
}
