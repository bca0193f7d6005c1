//! Terrains after each stage, kept under a key of everything upstream: in memory, then on disk.

mod disk;
mod key;

use std::path::Path;
use std::sync::Arc;

use landform_core::recent::Recent;
use landform_core::terrain::bytes_a_node;
use landform_core::verb::Event;
use landform_core::{Error, Result};

use super::AnyTerrain;
use disk::Disk;
pub use disk::Kept;
pub(super) use key::{input_paths, key, short_hash};

/// Terrains after each stage, kept between runs. The least recently used terrains are removed
/// first, in memory and on disk.
///
/// ```
/// use landform::core::verb::MemoryOutput;
/// use landform::recipe::{Cache, Options, Recipe, Signal};
/// use std::sync::atomic::{AtomicU32, Ordering};
/// let text = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"1 km\", \"1 km\"], cell_size = \"100 m\" }";
/// let recipe = Recipe::parse(text, "plain", "".as_ref(), &[])?;
/// let (cache, hits) = (Cache::in_memory(1 << 20), AtomicU32::new(0));
/// let progress = |signal| {
///     if let Signal::Stage { cached: true, .. } = signal {
///         hits.fetch_add(1, Ordering::Relaxed);
///     }
/// };
/// for _ in 0..3 {
///     let options = Options { cache: Some(&cache), progress: &progress, ..Options::default() };
///     recipe.run(&mut MemoryOutput::default(), &options)?;
/// }
/// assert_eq!(hits.into_inner(), 2);
/// # Ok::<(), landform::core::Error>(())
/// ```
#[derive(Debug)]
pub struct Cache {
    memory: Recent<String, (Arc<AnyTerrain>, Event)>,
    disk: Option<Disk>,
}

/// Default limit of a cache on disk, bytes.
pub const CACHE_LIMIT: u64 = 4 << 30;

impl Cache {
    /// A cache in memory alone, of `bytes` bytes.
    pub fn in_memory(bytes: u64) -> Self {
        Self { memory: Recent::of(bytes), disk: None }
    }

    /// A cache in a folder, of at most [`CACHE_LIMIT`] bytes.
    pub fn on_disk(folder: &Path) -> Self {
        Self { memory: Recent::of(0), disk: Some(Disk::new(folder, CACHE_LIMIT)) }
    }

    /// Sets the number of bytes in memory before those on disk.
    #[must_use]
    pub fn with_memory(self, bytes: u64) -> Self {
        Self { memory: Recent::of(bytes), ..self }
    }

    /// Sets the greatest number of bytes on disk.
    #[must_use]
    pub fn with_limit(mut self, bytes: u64) -> Self {
        self.disk = self.disk.map(|disk| disk.with_limit(bytes));
        self
    }

    /// The terrains on disk, the most recently used first.
    ///
    /// # Errors
    /// [`Error::Io`] if the folder cannot be read.
    pub fn kept(&self) -> Result<Vec<Kept>> {
        self.disk.as_ref().map_or(Ok(Vec::new()), Disk::kept)
    }

    /// Removes everything; returns how many bytes became free on disk.
    ///
    /// # Errors
    /// [`Error::Io`] if a file cannot be removed.
    pub fn clear(&self) -> Result<u64> {
        self.memory.clear();
        self.disk.as_ref().map_or(Ok(0), Disk::clear)
    }

    /// Removes the least recently used terrains, down to the limit; returns how many bytes became
    /// free on disk.
    pub fn trim(&self) -> u64 {
        self.disk.as_ref().map_or(0, Disk::trim)
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.memory.find(&key.to_string()).is_some() || self.disk.as_ref().is_some_and(|disk| disk.has(key))
    }

    /// Reads what is kept under a key, and refuses it where it is not whole.
    pub(super) fn check(&self, key: &str) -> Result<()> {
        match (self.memory.find(&key.to_string()), &self.disk) {
            (None, Some(disk)) => disk.check(key),
            _ => Ok(()),
        }
    }

    /// What made the terrain of a key.
    pub(super) fn event(&self, key: &str) -> Result<Event> {
        match (self.memory.find(&key.to_string()), &self.disk) {
            (Some((_, event)), _) => Ok(event),
            (None, Some(disk)) => disk.event(key),
            (None, None) => Err(missing()),
        }
    }

    /// The terrain of a key.
    pub(super) fn terrain(&self, key: &str) -> Result<Arc<AnyTerrain>> {
        match (self.memory.find(&key.to_string()), &self.disk) {
            (Some((terrain, _)), _) => Ok(terrain),
            (None, Some(disk)) => {
                let terrain = Arc::new(disk.terrain(key)?);
                // The event is read for the memory's sake alone.
                if self.memory.has_room() {
                    self.remember(key, &terrain, &disk.event(key)?);
                }
                Ok(terrain)
            }
            (None, None) => Err(missing()),
        }
    }

    fn remember(&self, key: &str, terrain: &Arc<AnyTerrain>, event: &Event) {
        let bytes = terrain.nodes() as u64 * bytes_a_node(terrain.kind());
        self.memory.keep(key.to_string(), (terrain.clone(), event.clone()), bytes);
    }

    /// Forgets a key, whose files turned out to be damaged.
    pub(super) fn forget(&self, key: &str) {
        self.memory.forget(&key.to_string());
        self.disk.iter().for_each(|disk| {
            disk.forget(key);
        });
    }

    pub(super) fn store(&self, key: &str, terrain: &Arc<AnyTerrain>, event: &Event) -> Result<()> {
        self.remember(key, terrain, event);
        self.disk.as_ref().map_or(Ok(()), |disk| disk.store(key, terrain, event))
    }
}

fn missing() -> Error {
    Error::Empty { what: "the cache".into() }
}
