//! Maps by path, relative to a folder.

use std::path::{Path, PathBuf};

use landform_core::terrain::HeightField;
use landform_core::verb::{Image, Maps};
use landform_core::{Error, Result};

use crate::files::read_whole;
use crate::format::{load_raster, read_grey};

/// Reads maps from disk.
#[derive(Clone, Debug)]
pub struct FileMaps {
    folder: PathBuf,
}

impl FileMaps {
    /// Paths are relative to this folder.
    pub fn new(folder: &Path) -> Self {
        Self { folder: folder.into() }
    }
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

    fn raster(&self, path: &Path) -> Result<HeightField> {
        load_raster(&self.folder.join(path))
    }
}
