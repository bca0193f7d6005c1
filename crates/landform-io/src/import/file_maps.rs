//! Maps by path, relative to a folder.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::SystemTime;

use landform_core::grid::Grid;
use landform_core::recent::Recent;
use landform_core::terrain::HeightField;
use landform_core::verb::{Image, Maps};
use landform_core::{Error, Result};

use crate::files::read_whole;
use crate::format::{Reading, read_grey, read_grid, read_raster};

/// Greatest number of bytes of rasters that are kept.
const MOST_BYTES: u64 = 1 << 30;

/// Reads maps from disk, each once: a raster is kept until rasters that were read later need the
/// memory.
#[derive(Debug)]
pub struct FileMaps {
    folder: PathBuf,
    rasters: Recent<File, Arc<HeightField>>,
    /// What files say that is not followed, and what was assumed.
    notes: Mutex<Vec<String>>,
}

/// A file as it was: its path, and what tells that it is still the same.
type File = (PathBuf, Option<(u64, SystemTime)>);

impl FileMaps {
    /// Paths are relative to this folder.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.into(), rasters: Recent::of(MOST_BYTES), notes: Mutex::default() }
    }

    /// Notes of the readers since the last call: what a file says that is not followed, and what
    /// was assumed.
    pub fn take_notes(&self) -> Vec<String> {
        std::mem::take(&mut *self.notes())
    }

    fn notes(&self) -> MutexGuard<'_, Vec<String>> {
        // A list that somebody panicked over is still a list.
        self.notes.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Length and time of a file, by which a changed file is known.
fn stamp(path: &Path) -> Option<(u64, SystemTime)> {
    let meta = fs::metadata(path).ok()?;
    Some((meta.len(), meta.modified().ok()?))
}

impl Maps for FileMaps {
    fn bytes(&self, path: &Path) -> Result<Vec<u8>> {
        read_whole(&self.folder.join(path))
    }

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
        let file = (path.clone(), stamp(&path));
        if let Some(raster) = file.1.and_then(|_| self.rasters.find(&file)) {
            return Ok(raster);
        }
        let Reading { field, notes } = read_raster(&path)?;
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        self.notes().extend(notes.iter().map(|note| format!("{name}: {note}")));
        let raster = Arc::new(field);
        self.rasters.keep(file, raster.clone(), 8 * raster.grid().len() as u64);
        Ok(raster)
    }

    fn grid(&self, path: &Path) -> Result<Grid> {
        // What was read already need not be read again, and what its reader notes comes with the
        // samples.
        let file = (self.folder.join(path), stamp(&self.folder.join(path)));
        match self.rasters.find(&file).filter(|_| file.1.is_some()) {
            Some(raster) => Ok(raster.grid().clone()),
            None => match read_grid(&file.0)? {
                Some(grid) => Ok(grid),
                None => self.raster(path).map(|raster| raster.grid().clone()),
            },
        }
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
        assert_eq!(maps.grid(Path::new("a.asc")).unwrap(), *first.grid());
        fs::write(&path, text.replace("3 4", "3 40")).unwrap();
        assert!(!Arc::ptr_eq(&first, &maps.raster(Path::new("a.asc")).unwrap()));
    }
}
