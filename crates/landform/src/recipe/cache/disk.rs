//! Terrains on disk.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use landform_core::sim::{pack, undamaged, unpack};
use landform_core::verb::Event;
use landform_core::{Error, Result};
use landform_io::files::{read_whole, sweep, write_whole};

use crate::recipe::AnyTerrain;

const EXTENSION: &str = "lfc";
/// Suffix of the file that holds the history of a terrain.
const EVENT: &str = "-event";

/// A folder of terrains.
#[derive(Clone, Debug)]
pub(super) struct Disk {
    folder: PathBuf,
    most_bytes: u64,
}

/// A terrain on disk.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Kept {
    /// Key of everything that it follows from.
    pub key: String,
    /// The stage that made it; none if that cannot be read.
    pub stage: Option<String>,
    /// Bytes on disk.
    pub bytes: u64,
    /// When it was made or last read.
    pub used: SystemTime,
}

impl Disk {
    pub(super) fn new(folder: &Path, most_bytes: u64) -> Self {
        Self { folder: folder.into(), most_bytes }
    }

    pub(super) fn with_limit(self, most_bytes: u64) -> Self {
        Self { most_bytes, ..self }
    }

    fn path(&self, key: &str) -> PathBuf {
        self.folder.join(key).with_extension(EXTENSION)
    }

    fn event_path(&self, key: &str) -> PathBuf {
        self.path(&format!("{key}{EVENT}"))
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.path(key).is_file() && self.event_path(key).is_file()
    }

    /// Refuses a key whose files are not whole.
    pub(super) fn check(&self, key: &str) -> Result<()> {
        for path in [self.event_path(key), self.path(key)] {
            undamaged(&read_whole(&path)?)?;
        }
        Ok(())
    }

    /// What made the terrain of a key.
    pub(super) fn event(&self, key: &str) -> Result<Event> {
        read_whole(&self.event_path(key)).and_then(|bytes| unpack("event", key, &bytes))
    }

    /// The terrain of a key.
    pub(super) fn terrain(&self, key: &str) -> Result<AnyTerrain> {
        let terrain = read_whole(&self.path(key)).and_then(|bytes| unpack("terrain", key, &bytes))?;
        // Read is used. Where the time cannot be set, the file only looks older than it is.
        fs::File::options().append(true).open(self.path(key)).and_then(|f| f.set_modified(SystemTime::now())).ok();
        Ok(terrain)
    }

    /// Forgets a key, whose files turned out to be damaged.
    pub(super) fn forget(&self, key: &str) -> bool {
        let gone = fs::remove_file(self.path(key)).is_ok();
        fs::remove_file(self.event_path(key)).ok();
        gone
    }

    pub(super) fn store(&self, key: &str, terrain: &AnyTerrain, event: &Event) -> Result<()> {
        fs::create_dir_all(&self.folder).map_err(|e| Error::io("create folder", &self.folder, e))?;
        write_whole(&self.event_path(key), &pack("event", key, event)?)?;
        write_whole(&self.path(key), &pack("terrain", key, terrain)?)?;
        self.trim();
        Ok(())
    }

    /// What is kept, the most recently used first.
    pub(super) fn kept(&self) -> Result<Vec<Kept>> {
        let mut kept = self.files()?;
        for item in &mut kept {
            item.stage = self.event(&item.key).ok().map(|event| event.stage);
        }
        Ok(kept)
    }

    /// As [`Disk::kept`], without looking into the files.
    fn files(&self) -> Result<Vec<Kept>> {
        let entries = match fs::read_dir(&self.folder) {
            Ok(entries) => entries,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
            Err(e) => return Err(Error::io("read", &self.folder, e)),
        };
        let mut files: Vec<Kept> = entries.flatten().filter_map(|entry| self.file(&entry.path())).collect();
        files.sort_by(|a, b| b.used.cmp(&a.used).then_with(|| a.key.cmp(&b.key)));
        Ok(files)
    }

    fn file(&self, path: &Path) -> Option<Kept> {
        let key = path.file_stem()?.to_str()?.to_string();
        if path.extension()? != EXTENSION || key.ends_with(EVENT) {
            return None;
        }
        let meta = fs::metadata(path).ok()?;
        let event = fs::metadata(self.event_path(&key)).map_or(0, |m| m.len());
        Some(Kept { stage: None, bytes: meta.len() + event, used: meta.modified().ok()?, key })
    }

    /// Removes everything; returns how many bytes became free.
    pub(super) fn clear(&self) -> Result<u64> {
        sweep(&self.folder);
        let kept = self.files()?;
        for item in &kept {
            let path = self.path(&item.key);
            fs::remove_file(&path).map_err(|e| Error::io("remove", &path, e))?;
            fs::remove_file(self.event_path(&item.key)).ok();
        }
        Ok(kept.iter().map(|item| item.bytes).sum())
    }

    /// Removes the least recently used terrains beyond the limit; returns how many bytes became
    /// free. Files that cannot be removed are left. What killed processes left unfinished goes,
    /// too.
    pub(super) fn trim(&self) -> u64 {
        sweep(&self.folder);
        let mut kept = self.files().unwrap_or_default();
        let mut total: u64 = kept.iter().map(|item| item.bytes).sum();
        let mut freed = 0;
        while total > self.most_bytes {
            let Some(oldest) = kept.pop() else { break };
            freed += if self.forget(&oldest.key) { oldest.bytes } else { 0 };
            total -= oldest.bytes;
        }
        freed
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::{HeightField, Representation};

    #[test]
    #[allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]
    fn a_limit_holds_and_what_is_kept_is_listed() {
        let folder = tempfile::tempdir().unwrap();
        let disk = Disk::new(folder.path(), u64::MAX);
        let terrain = HeightField::new(Grid::new(Shape::new(9, 9), [1.0, 1.0]).unwrap(), vec![0.0; 81]).unwrap().wrap();
        let event = Event { stage: "flat".into(), parameters: String::new(), sources: Vec::new(), outcome: None };
        for key in ["aa", "bb", "cc"] {
            disk.store(key, &terrain, &event).unwrap();
        }
        let kept = disk.kept().unwrap();
        assert!(kept.len() == 3 && kept.iter().all(|k| k.stage.as_deref() == Some("flat")));
        let old = SystemTime::UNIX_EPOCH;
        for key in ["bb", "cc"] {
            fs::File::options().append(true).open(disk.path(key)).unwrap().set_modified(old).unwrap();
        }
        assert!(disk.terrain("cc").unwrap() == terrain, "reading makes it young again");
        let two = kept.iter().take(2).map(|k| k.bytes).sum();
        assert!(disk.clone().with_limit(two).trim() > 0);
        assert!(disk.has("aa") && disk.has("cc") && !disk.has("bb"));
        assert!(disk.clear().unwrap() == two && disk.kept().unwrap().is_empty());
    }
}
