//! Whole files or none: written aside, then renamed.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use landform_core::verb::{Output, relative_path};
use landform_core::{Error, Result};

/// Writes a whole file: aside first, flushed to disk, then renamed into place.
///
/// # Errors
/// [`Error::Io`]; then nothing is left behind.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let aside = path.with_file_name(format!(".{name}.{}.part", std::process::id()));
    let write = || -> std::io::Result<()> {
        let mut file = fs::File::create(&aside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&aside, path)
    };
    write().map_err(|e| {
        fs::remove_file(&aside).ok();
        Error::io("write", path, e)
    })
}

/// Reads a whole file.
///
/// # Errors
/// [`Error::Io`].
pub fn read_whole(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).map_err(|e| Error::io("read", path, e))
}

/// A folder that exports write to.
#[derive(Clone, Debug)]
pub struct Folder {
    root: PathBuf,
    written: Vec<PathBuf>,
}

impl Folder {
    /// A folder, made if it is not there, and found to be writable.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn create(root: &Path) -> Result<Self> {
        fs::create_dir_all(root).map_err(|e| Error::io("create folder", root, e))?;
        let probe = root.join(format!(".landform-probe.{}", std::process::id()));
        fs::write(&probe, b"")
            .and_then(|()| fs::remove_file(&probe))
            .map_err(|e| Error::io("write in folder", root, e))?;
        Ok(Self { root: root.into(), written: Vec::new() })
    }

    /// Files written so far, in order.
    pub fn written(&self) -> &[PathBuf] {
        &self.written
    }
}

impl Output for Folder {
    fn put(&mut self, path: &str, bytes: &[u8]) -> Result<()> {
        let path = self.root.join(relative_path(path)?);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|e| Error::io("create folder", parent, e))?;
        }
        write_whole(&path, bytes)?;
        self.written.push(path);
        Ok(())
    }
}
