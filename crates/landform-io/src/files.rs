//! Files that are written whole or not at all: written under another name, then renamed.

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;

use landform_core::verb::{Output, file_path, relative_path};
use landform_core::{Error, Result};

/// End of the name of a file that is not whole yet; before it stand the file's own name and the
/// process that writes it.
const UNFINISHED: &str = ".landform.part";
/// Begin of the name of a file that shows whether a folder can be written to.
const PROBE: &str = ".landform-probe.";
/// Where processes cannot be looked up, what was not touched for so long is of one that lives no
/// more.
const A_DAY: Duration = Duration::from_secs(86_400);

/// Writes a whole file: first under another name, then flushed to disk and renamed.
///
/// # Errors
/// [`Error::Io`] if the file cannot be written; then no part of it is left.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let aside = path.with_file_name(format!(".{name}.{}{UNFINISHED}", std::process::id()));
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

/// Removes from a folder what processes that were killed left unfinished. Files of processes that
/// live are left, as is all that this program did not make.
pub fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        let writer = entry.file_name().to_str().and_then(writer);
        if is_file && writer.is_some_and(|process| is_gone(process, &entry)) {
            // What cannot be removed only takes room.
            fs::remove_file(entry.path()).ok();
        }
    }
}

/// The process that writes an unfinished file; none of any other file.
fn writer(name: &str) -> Option<u32> {
    let part = || name.strip_prefix('.')?.strip_suffix(UNFINISHED)?.rsplit_once('.').map(|(_, process)| process);
    let digits = name.strip_prefix(PROBE).or_else(part)?;
    digits.bytes().all(|b| b.is_ascii_digit()).then(|| digits.parse().ok())?
}

fn is_gone(process: u32, entry: &fs::DirEntry) -> bool {
    let processes = Path::new("/proc");
    if processes.join("self").exists() {
        return !processes.join(process.to_string()).exists();
    }
    let touched = entry.metadata().and_then(|meta| meta.modified());
    process != std::process::id() && touched.is_ok_and(|at| at.elapsed().is_ok_and(|age| age > A_DAY))
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
    /// Folders in which nothing unfinished is left.
    swept: BTreeSet<PathBuf>,
    notes: Vec<String>,
}

impl Folder {
    /// A folder, which is created if it does not exist, and checked to be writable. What killed
    /// processes left unfinished in it goes.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn create(root: &Path) -> Result<Self> {
        fs::create_dir_all(root).map_err(|e| Error::io("create folder", root, e))?;
        let probe = root.join(format!("{PROBE}{}", std::process::id()));
        fs::write(&probe, b"")
            .and_then(|()| fs::remove_file(&probe))
            .map_err(|e| Error::io("write in folder", root, e))?;
        sweep(root);
        let swept = BTreeSet::from([root.into()]);
        Ok(Self { root: root.into(), written: Vec::new(), may_leave: false, swept, notes: Vec::new() })
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
        Err(Error::Outside { name: "path".into(), path: path.into(), by_link: true })
    }

    /// Refuses a path that leads out of the folder, where that is not allowed.
    ///
    /// # Errors
    /// [`Error::Outside`] for such a path.
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
            if self.swept.insert(parent.into()) {
                sweep(parent);
            }
        }
        write_whole(&target, bytes)?;
        self.written.push(target);
        Ok(())
    }

    fn note(&mut self, text: String) {
        self.notes.push(text);
    }

    fn take_notes(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notes)
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
