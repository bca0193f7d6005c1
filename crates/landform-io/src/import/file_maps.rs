//! Maps by path, relative to a folder.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::SystemTime;

use landform_core::terrain::HeightField;
use landform_core::verb::{Image, Maps};
use landform_core::{Error, Result};

use crate::files::read_whole;
use crate::format::{read_grey, read_raster};

/// Greatest number of bytes of rasters that are kept.
const MOST_BYTES: usize = 1 << 30;

/// Reads maps from disk, each once: a raster is kept until rasters that were read later need the memory.
#[derive(Debug)]
pub struct FileMaps {
    folder: PathBuf,
    /// The most recently used last.
    rasters: Mutex<Vec<Kept>>,
    /// What files say that is not followed, and what was assumed.
    notes: Mutex<Vec<String>>,
}

#[derive(Debug)]
struct Kept {
    path: PathBuf,
    stamp: Option<(u64, SystemTime)>,
    raster: Arc<HeightField>,
}

impl FileMaps {
    /// Paths are relative to this folder.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.into(), rasters: Mutex::default(), notes: Mutex::default() }
    }

    /// Notes of the readers since the last call: what a file says that is not followed, and what was assumed.
    pub fn take_notes(&self) -> Vec<String> {
        std::mem::take(&mut *self.notes.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn rasters(&self) -> MutexGuard<'_, Vec<Kept>> {
        // A list is still valid after a panic of another thread.
        self.rasters.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Length and time of a file, by which a changed file is known.
fn stamp(path: &Path) -> Option<(u64, SystemTime)> {
    let meta = fs::metadata(path).ok()?;
    Some((meta.len(), meta.modified().ok()?))
}

impl Maps for FileMaps {
    fn image(&self, path: &Path) -> Result<Image> {
        let path = self.folder.join(path);
        read_grey(&read_whole(&path)?).map_err(|e| match e {
            Error::Format { format, what, .. } => Error::Format {
                format,
                what: format!("{what} ({})", path.display()),
                hint: Some("`image` takes PNG and PNM pictures; give an elevation model as `raster`".into()),
            },
            other => other,
        })
    }

    fn raster(&self, path: &Path) -> Result<Arc<HeightField>> {
        let path = self.folder.join(path);
        let now = stamp(&path);
        let mut rasters = self.rasters();
        if let Some(at) = rasters.iter().position(|kept| kept.path == path && kept.stamp == now && now.is_some()) {
            let kept = rasters.remove(at);
            let raster = kept.raster.clone();
            rasters.push(kept);
            return Ok(raster);
        }
        drop(rasters);
        let reading = read_raster(&path)?;
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let mut notes = self.notes.lock().unwrap_or_else(PoisonError::into_inner);
        notes.extend(reading.notes.iter().map(|note| format!("{name}: {note}")));
        drop(notes);
        let raster = Arc::new(reading.field);
        let mut rasters = self.rasters();
        rasters.retain(|kept| kept.path != path);
        rasters.push(Kept { path, stamp: now, raster: raster.clone() });
        let mut bytes: usize = rasters.iter().map(|kept| 8 * kept.raster.grid().len()).sum();
        while bytes > MOST_BYTES {
            bytes -= 8 * rasters.remove(0).raster.grid().len();
        }
        Ok(raster)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]
    fn a_raster_is_read_once_until_it_changes() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.asc");
        let text = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n";
        fs::write(&path, text).unwrap();
        let maps = FileMaps::new(folder.path());
        let first = maps.raster(Path::new("a.asc")).unwrap();
        assert!(Arc::ptr_eq(&first, &maps.raster(Path::new("a.asc")).unwrap()));
        fs::write(&path, text.replace("3 4", "3 40")).unwrap();
        assert!(!Arc::ptr_eq(&first, &maps.raster(Path::new("a.asc")).unwrap()));
    }
}
