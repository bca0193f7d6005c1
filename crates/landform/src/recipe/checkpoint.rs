//! The state of a stage that is kept while it runs: the model in one file, and in pieces beside it
//! what `watch` saw.
//!
//! A piece holds what was seen from one save to the next, so that pictures are written once. Pieces
//! are named by the step at which they end: the model says up to which step they count.

use std::borrow::Cow;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use landform_core::sim::{Model, Simulation, is_for, pack, saved_steps, undamaged, unpack};
use landform_core::terrain::Terrain;
use landform_core::{Error, Result};
use landform_io::files::{read_whole, sweep, write_whole};
use landform_io::render::Picture;
use serde::{Deserialize, Serialize};

use super::cache::short_hash;
use super::watch::{Watch, Watcher};

const KIND: &str = "checkpoint";
const SEEN: &str = "watch";
const EXTENSION: &str = "lfc";
/// More than kind and key of a container take.
const HEAD: u64 = 1_024;

/// What `watch` saw from one save to the next.
#[derive(Serialize, Deserialize)]
pub(super) struct Piece<'a> {
    /// Steps at the save before.
    from: u64,
    pub(super) rows: Cow<'a, str>,
    pub(super) frames: Cow<'a, [Picture]>,
}

/// Where the state of one stage is kept.
#[derive(Debug)]
pub(super) struct Checkpoint<'a> {
    path: &'a Path,
    key: &'a str,
    /// Key of what `watch` saw, if it looks.
    seen: Option<String>,
    /// Whether what lies there is of this run.
    ours: bool,
    /// Steps at the last save.
    saved: u64,
    /// Steps of an earlier run's state, which is left alone until this run has come as far.
    ahead: u64,
}

impl<'a> Checkpoint<'a> {
    pub(super) fn new(path: &'a Path, key: &'a str, watch: Option<&Watch>) -> Self {
        let seen = watch.map(|watch| format!("{key}{}", short_hash(&serde_json::json!(watch).to_string())));
        Self { path, key, seen, ours: false, saved: 0, ahead: 0 }
    }

    /// Whether the state that lies there is of this stage.
    pub(super) fn is_there(&self) -> bool {
        is_for(KIND, self.key, &head(self.path))
    }

    /// Steps of the whole state that lies there; none if it, or what `watch` saw, is not of this
    /// stage.
    pub(super) fn steps(&self) -> Option<u64> {
        let steps = read_whole(self.path).and_then(|bytes| saved_steps(self.key, &bytes)).ok()?;
        let fits = |seen| steps == 0 || is_for(SEEN, seen, &head(&self.piece(steps)));
        self.seen.as_deref().is_none_or(fits).then_some(steps)
    }

    /// Leaves the state that lies there alone until more steps than these are taken.
    pub(super) fn keep_until(self, ahead: u64) -> Self {
        Self { ahead, ..self }
    }

    /// Keeps the state of a model and what was seen since the last save.
    pub(super) fn save<T: Terrain>(&mut self, model: &Model<T>, watcher: Option<&mut Watcher>) -> Result<()> {
        let steps = model.steps();
        if self.ahead > 0 && steps <= self.ahead {
            return Ok(());
        }
        if !self.ours {
            clear(self.path);
        }
        self.ours = true;
        create_folder(self.path.parent())?;
        if let (Some(watcher), Some(seen)) = (watcher, &self.seen)
            && steps > self.saved
        {
            let (rows, frames) = watcher.since_last();
            let piece = Piece { from: self.saved, rows: rows.into(), frames: frames.into() };
            create_folder(Some(&pieces(self.path)))?;
            write_whole(&self.piece(steps), &pack(SEEN, seen, &piece)?)?;
            watcher.is_kept();
        }
        write_whole(self.path, &model.save(self.key)?)?;
        self.saved = steps;
        Ok(())
    }

    /// Goes back to the state that lies there, and to what was seen until then.
    pub(super) fn resume<'s, T: Terrain>(
        &mut self,
        simulation: Simulation<'s, T>,
        watcher: Option<&mut Watcher>,
    ) -> Result<Simulation<'s, T>> {
        let bytes = read_whole(self.path)?;
        let simulation = simulation.resume(self.key, &bytes).map_err(|e| unusable(self.path, &e))?;
        (self.ours, self.saved) = (true, simulation.model().steps());
        if let (Some(watcher), Some(seen)) = (watcher, &self.seen) {
            self.recall(seen, watcher)?;
        }
        Ok(simulation)
    }

    /// Shows a watcher again what was seen until the save; pieces of a save that did not come to
    /// its end go.
    fn recall(&self, seen: &str, watcher: &mut Watcher) -> Result<()> {
        let mut until = 0;
        for end in piece_ends(self.path)? {
            let path = self.piece(end);
            if end > self.saved {
                fs::remove_file(&path).map_err(|e| Error::io("remove", &path, e))?;
                continue;
            }
            let bytes = read_whole(&path)?;
            undamaged(&bytes).map_err(|e| unusable(&path, &e))?;
            if !is_for(SEEN, seen, &bytes) {
                let what = format!("{}: `watch` asked for something else when this was kept", path.display());
                let hint = "give it its former values, or run without --resume: the stage then starts afresh";
                return Err(Error::Recipe { at: None, what, hint: Some(hint.into()) });
            }
            let piece: Piece = unpack(SEEN, seen, &bytes).map_err(|e| unusable(&path, &e))?;
            if piece.from != until {
                break;
            }
            watcher.recall(&piece.rows, piece.frames.into_owned());
            until = end;
        }
        if until == self.saved {
            return Ok(());
        }
        let what = format!("{}: what `watch` saw after step {until} is missing", pieces(self.path).display());
        Err(Error::Recipe { at: None, what, hint: Some(WAY_ON.into()) })
    }

    /// Removes the state of this stage, which is finished.
    pub(super) fn remove(&self) {
        if self.is_there() {
            clear(self.path);
        }
    }

    fn piece(&self, end: u64) -> PathBuf {
        pieces(self.path).join(format!("{end:012}")).with_extension(EXTENSION)
    }
}

const WAY_ON: &str = "delete it, or run without --resume: the stage then starts afresh";

/// An error that names the file and the way on.
fn unusable(path: &Path, e: &Error) -> Error {
    match e {
        Error::Format { format, what, .. } => {
            Error::Format { format, what: format!("{}: {what}", path.display()), hint: Some(WAY_ON.into()) }
        }
        e => Error::Recipe { at: None, what: e.to_string(), hint: Some(WAY_ON.into()) },
    }
}

/// Refuses a file that is damaged or no checkpoint.
///
/// # Errors
/// [`Error::Format`] that names the file and the way on; [`Error::Io`].
pub(super) fn check_undamaged(path: &Path) -> Result<()> {
    undamaged(&read_whole(path)?).map(drop).map_err(|e| unusable(path, &e))
}

/// The first bytes of a file; none if there is none.
fn head(path: &Path) -> Vec<u8> {
    let mut bytes = Vec::new();
    // A file that cannot be read is of no stage.
    fs::File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut bytes)).ok();
    bytes
}

/// Removes what a killed run left unfinished where the state at a path is kept.
pub(super) fn tidy(path: &Path) {
    path.parent().into_iter().for_each(sweep);
    sweep(&pieces(path));
}

/// The folder of what was seen.
fn pieces(path: &Path) -> PathBuf {
    path.with_extension("watch")
}

/// Steps at which pieces end, in order.
fn piece_ends(path: &Path) -> Result<Vec<u64>> {
    let folder = pieces(path);
    let entries = match fs::read_dir(&folder) {
        Ok(entries) => entries,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(e) => return Err(Error::io("read", folder, e)),
    };
    let names = entries.flatten().map(|entry| PathBuf::from(entry.file_name()));
    let pieces = names.filter(|name| name.extension().is_some_and(|e| e == EXTENSION));
    let mut ends: Vec<u64> = pieces.filter_map(|name| name.file_stem()?.to_str()?.parse().ok()).collect();
    ends.sort_unstable();
    Ok(ends)
}

/// Removes a state; first the model, without which pieces mean nothing.
fn clear(path: &Path) {
    // What cannot be removed is written over.
    fs::remove_file(path).ok();
    fs::remove_dir_all(pieces(path)).ok();
    path.parent().into_iter().for_each(sweep);
}

fn create_folder(folder: Option<&Path>) -> Result<()> {
    let Some(folder) = folder else { return Ok(()) };
    fs::create_dir_all(folder).map_err(|e| Error::io("create folder", folder, e))
}
