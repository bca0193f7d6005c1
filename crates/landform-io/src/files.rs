//! Files that are written whole or not at all: written under another name, then renamed.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use landform_core::verb::{Output, file_path, relative_path};
use landform_core::{Error, Result};

/// Writes a whole file: first under another name, then flushed to disk and renamed.
///
/// # Errors
/// [`Error::Io`] if the file cannot be written; then no part of it is left.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let aside = path.with_file_name(format!(".{name}.{}.part", std::process::id()));
    // A device or a pipe is written to, not replaced.
    if fs::metadata(path).is_ok_and(|meta| !meta.is_file() && !meta.is_dir()) {
        let mut to = fs::File::options().write(true).open(path).map_err(|e| Error::io("write", path, e))?;
        return to.write_all(bytes).map_err(|e| Error::io("write", path, e));
    }
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

/// Reads a whole file. A device or a pipe, which may have no end, is refused.
///
/// # Errors
/// [`Error::Io`].
pub fn read_whole(path: &Path) -> Result<Vec<u8>> {
    if fs::metadata(path).is_ok_and(|meta| !meta.is_file() && !meta.is_dir()) {
        let kind = std::io::Error::new(std::io::ErrorKind::InvalidInput, "it is a device or a pipe, not a file");
        return Err(Error::io("read", path, kind));
    }
    fs::read(path).map_err(|e| Error::io("read", path, e))
}

/// A folder that exports write to.
#[derive(Clone, Debug)]
pub struct Folder {
    root: PathBuf,
    written: Vec<PathBuf>,
    may_leave: bool,
}

impl Folder {
    /// A folder, which is created if it does not exist, and checked to be writable.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn create(root: &Path) -> Result<Self> {
        fs::create_dir_all(root).map_err(|e| Error::io("create folder", root, e))?;
        let probe = root.join(format!(".landform-probe.{}", std::process::id()));
        fs::write(&probe, b"")
            .and_then(|()| fs::remove_file(&probe))
            .map_err(|e| Error::io("write in folder", root, e))?;
        Ok(Self { root: root.into(), written: Vec::new(), may_leave: false })
    }

    /// Whether paths may lead out of the folder: by `..`, absolute, or over a link.
    #[must_use]
    pub fn may_leave(self, may_leave: bool) -> Self {
        Self { may_leave, ..self }
    }

    /// Refuses a folder that a link leads out to.
    fn check_inside(&self, path: &str, parent: &Path) -> Result<()> {
        let real = |path: &Path| fs::canonicalize(path).map_err(|e| Error::io("find", path, e));
        if real(parent)?.starts_with(real(&self.root)?) {
            return Ok(());
        }
        let value = format!("\"{path}\", which a link leads out of the output folder");
        Err(Error::parameter("path", value, "a file in the output folder, or leave to write outside"))
    }

    /// Refuses a path that leads out of the folder, where that is not allowed.
    ///
    /// # Errors
    /// [`Error::Parameter`] for such a path.
    pub fn check(&self, path: &str) -> Result<()> {
        if self.may_leave {
            return file_path(path).map(drop);
        }
        let target = self.root.join(relative_path(path)?);
        let there = target.ancestors().skip(1).find(|p| p.exists()).unwrap_or(&self.root);
        self.check_inside(path, there)
    }

    /// Files written so far, in order.
    pub fn written(&self) -> &[PathBuf] {
        &self.written
    }
}

impl Output for Folder {
    fn put(&mut self, path: &str, bytes: &[u8]) -> Result<()> {
        // Checked again, since a link may have come since; nothing is created beyond one either.
        self.check(path)?;
        let target = self.root.join(path);
        if let Some(parent) = target.parent() {
            fs::create_dir_all(parent).map_err(|e| Error::io("create folder", parent, e))?;
        }
        write_whole(&target, bytes)?;
        self.written.push(target);
        Ok(())
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_device_without_an_end_is_refused() {
        let error = read_whole(Path::new("/dev/zero")).unwrap_err();
        assert!(error.to_string().contains("a device or a pipe"), "{error}");
    }
}
