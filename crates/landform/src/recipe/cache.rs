//! Terrains after each stage, kept under a key of everything upstream.

use std::fs;
use std::path::{Path, PathBuf};

use landform_core::sim::{pack, unpack};
use landform_core::verb::Event;
use landform_core::{Error, Result};
use landform_io::files::{read_whole, write_whole};
use serde_json::Value as Json;
use sha2::{Digest, Sha256};

use super::AnyTerrain;
use super::entry::Entry;

const EXTENSION: &str = "lfc";
/// Kept at most; the oldest go first.
const MOST_BYTES: u64 = 4 << 30;

/// A folder of terrains.
#[derive(Clone, Debug)]
pub(super) struct Cache {
    folder: PathBuf,
}

impl Cache {
    pub(super) fn new(folder: &Path) -> Self {
        Self { folder: folder.into() }
    }

    fn path(&self, key: &str) -> PathBuf {
        self.folder.join(key).with_extension(EXTENSION)
    }

    fn event_path(&self, key: &str) -> PathBuf {
        self.path(&format!("{key}-event"))
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.path(key).is_file() && self.event_path(key).is_file()
    }

    /// What made the terrain of a key.
    pub(super) fn event(&self, key: &str) -> Result<Event> {
        read_whole(&self.event_path(key)).and_then(|bytes| unpack("event", key, &bytes))
    }

    /// The terrain of a key.
    pub(super) fn terrain(&self, key: &str) -> Result<AnyTerrain> {
        read_whole(&self.path(key)).and_then(|bytes| unpack("terrain", key, &bytes))
    }

    /// Forgets a key, whose files turned out to be damaged.
    pub(super) fn forget(&self, key: &str) {
        fs::remove_file(self.path(key)).ok();
        fs::remove_file(self.event_path(key)).ok();
    }

    pub(super) fn store(&self, key: &str, terrain: &AnyTerrain, event: &Event) -> Result<()> {
        fs::create_dir_all(&self.folder).map_err(|e| Error::io("create folder", &self.folder, e))?;
        write_whole(&self.path(key), &pack("terrain", key, terrain)?)?;
        write_whole(&self.event_path(key), &pack("event", key, event)?)?;
        self.trim();
        Ok(())
    }

    /// Removes the oldest files beyond the limit. What cannot be read or removed is left.
    fn trim(&self) {
        let Ok(folder) = fs::read_dir(&self.folder) else { return };
        let mut files: Vec<_> = folder
            .flatten()
            .filter(|f| f.path().extension().is_some_and(|e| e == EXTENSION))
            .filter_map(|f| f.metadata().ok().and_then(|m| Some((m.modified().ok()?, m.len(), f.path()))))
            .collect();
        files.sort();
        let mut total: u64 = files.iter().map(|f| f.1).sum();
        for (_, length, path) in files {
            if total <= MOST_BYTES {
                return;
            }
            fs::remove_file(path).ok();
            total -= length;
        }
    }
}

/// The key of the terrain after a stage: what came before and beside it, the stage with its parameters and seed, the files that it reads,
/// and the program.
pub(super) fn key(before: &[&str], entry: &Entry, folder: &Path, salt: &str) -> String {
    let mut hash = Sha256::new();
    let surroundings = before.join(" ");
    for text in [
        surroundings.as_str(),
        &entry.name,
        &entry.seed.0.to_string(),
        &entry.work.normalized().to_string(),
        salt,
        env!("CARGO_PKG_VERSION"),
    ] {
        hash.update((text.len() as u64).to_le_bytes());
        hash.update(text);
    }
    for part in entry.work.parts() {
        for path in input_paths(part.stage().inputs, part.parameters()) {
            // A file that is missing is found out when the stage runs.
            let content = fs::read(folder.join(&path)).unwrap_or_default();
            hash.update(Sha256::digest(content));
        }
    }
    hash.finalize().iter().map(|b| format!("{b:02x}")).take(16).collect()
}

/// Files that parameters name: keys that are inputs, and maps in values that vary, however deep.
pub(super) fn input_paths(inputs: &[&str], json: &Json) -> Vec<String> {
    let mut paths: Vec<String> = inputs.iter().filter_map(|k| json[*k].as_str()).map(String::from).collect();
    if let Json::Object(map) = json {
        map.values().for_each(|value| maps_in(value, &mut paths));
    }
    paths
}

fn maps_in(json: &Json, paths: &mut Vec<String>) {
    if let Json::Object(map) = json {
        paths.extend(["image", "raster"].iter().filter_map(|k| json[*k].as_str()).map(String::from));
        map.values().for_each(|value| maps_in(value, paths));
    }
}
