//! The session: one recipe, its text, what it comes to. It lives in the server; pages show it.

mod mistake;
mod open;
mod reading;
mod starter;
mod stroke;
mod view;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use landform::{Error, Result};
use serde_json::Value as Json;

pub(crate) use mistake::on;
pub(crate) use view::recipe as view_of;
pub(crate) use view::verb;

use crate::protocol::Request;
use crate::root::Root;
use crate::text::{self, History, Spot};
use reading::Reading;

/// Longer texts are refused, bytes.
pub(crate) const MOST_TEXT: usize = 512 << 10;

/// One recipe at work.
pub(crate) struct Session {
    pub(crate) history: History,
    /// Counts the texts.
    pub(crate) revision: u64,
    /// The file that it came from and is saved to.
    pub(crate) path: Option<PathBuf>,
    /// Folder that its paths are relative to.
    folder: PathBuf,
    /// What it is called where it has no title.
    pub(crate) name: String,
    /// The text as the file has it.
    saved: Option<Arc<str>>,
    pub(crate) reading: Reading,
    /// Wall-clock seconds of each step that is on, in the last run.
    pub(crate) seconds: Vec<Option<f64>>,
    /// The step after which all look at the ground.
    pub(crate) shown: Option<usize>,
    root: Arc<Root>,
    output: PathBuf,
}

impl Session {
    /// An empty session.
    pub(crate) fn new(root: Arc<Root>, output: &Path) -> Self {
        let folder = root.folder().to_path_buf();
        Self {
            history: History::of(""),
            revision: 0,
            path: None,
            folder,
            name: "untitled".into(),
            saved: None,
            reading: Reading::default(),
            seconds: Vec::new(),
            shown: None,
            root,
            output: output.into(),
        }
    }

    /// Changes the text as a page asks; whether it did.
    ///
    /// # Errors
    /// If it cannot be done; the text is then as it was.
    pub(crate) fn edit(&mut self, request: &Request) -> Result<bool> {
        let now = self.history.now().clone();
        let mut going_on = None;
        let new = match request {
            Request::Text { text } => text.clone(),
            Request::Set { stage, process, key, value, dragging, .. } => {
                let spot = Spot { stage: *stage, process: *process, key: key.clone() };
                going_on = Some(format!("{spot:?}"));
                let new = text::set(&now, &spot, Some(value))?;
                self.take(new, going_on.clone())?;
                if !dragging {
                    self.history.settle();
                }
                return Ok(*self.history.now() != now);
            }
            Request::Insert { at, name, process_of } => {
                text::insert(&now, *at, &starter::of(name, process_of.is_some())?, *process_of)?
            }
            Request::Remove { stage, process } => text::remove(&now, *stage, *process)?,
            Request::Move { stage, to } => text::relocate(&now, *stage, *to)?,
            Request::Toggle { stage } => text::toggle(&now, *stage)?,
            Request::Stroke { stage, process, key, tool, radius, strength, points } => {
                let spot = Spot { stage: Some(*stage), process: *process, key: key.clone() };
                let stroke = stroke::of(tool.as_deref(), radius, strength, points)?;
                stroke::add(self, &spot, stroke)?
            }
            Request::Undo | Request::Redo => {
                let undo = matches!(request, Request::Undo);
                if !(if undo { self.history.undo() } else { self.history.redo() }) {
                    let what = format!("there is nothing to {}", if undo { "take back" } else { "do again" });
                    return Err(Error::Recipe { at: None, what, hint: None });
                }
                self.understand();
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.take(new, going_on)?;
        Ok(*self.history.now() != now)
    }

    fn take(&mut self, new: String, going_on: Option<String>) -> Result<()> {
        if new.len() > MOST_TEXT {
            let found = format!("{} bytes", new.len());
            return Err(Error::parameter("text", found, &format!("at most {MOST_TEXT} bytes")));
        }
        if *new != **self.history.now() {
            self.history.take(new, going_on);
            self.understand();
        }
        Ok(())
    }

    /// Reads the text as it is now.
    fn understand(&mut self) {
        self.revision += 1;
        self.reading = Reading::of(self.history.now(), &self.name, &self.folder, &self.root);
    }

    pub(crate) fn is_saved(&self) -> bool {
        self.saved.as_ref() == Some(self.history.now())
    }

    /// The command line that builds the recipe.
    pub(crate) fn command(&self) -> String {
        let file = self.path.clone().unwrap_or_else(|| PathBuf::from(format!("{}.toml", self.name)));
        let here = std::env::current_dir().unwrap_or_default();
        let short = |path: &Path| {
            let path = path.strip_prefix(&here).unwrap_or(path);
            quoted(&path.display().to_string())
        };
        format!("landform run {} -o {}", short(&file), short(&self.output))
    }

    /// Places of the steps that are on, in the list of all.
    pub(crate) fn steps(&self) -> Vec<usize> {
        on(&text::blocks(self.history.now())).collect()
    }

    /// Takes the seconds of the stages of a run; those that were not run keep theirs.
    pub(crate) fn take_times(&mut self, seconds: Vec<Option<f64>>) {
        let before = std::mem::take(&mut self.seconds);
        let of = |k: usize| seconds.get(k).copied().flatten().or(before.get(k).copied().flatten());
        self.seconds = (0..self.reading.planned.len()).map(of).collect();
    }

    /// The number, among the steps that are on, of the step that is shown.
    pub(crate) fn shown_on(&self) -> Option<usize> {
        let blocks = text::blocks(self.history.now());
        let shown = self.shown?;
        // A step that is off is that of the last one before it that is on.
        on(&blocks).take_while(|&k| k <= shown).count().checked_sub(1)
    }
}

/// A word as a shell reads it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+:@%".contains(c);
    if !word.is_empty() && !word.starts_with('-') && word.chars().all(plain) {
        return word.into();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

/// The JSON of an error for the page.
pub(crate) fn refusal(request: u64, error: &Error) -> Json {
    serde_json::json!({ "tell": "refused", "request": request, "what": error.to_string(), "hint": error.hint() })
}

#[cfg(test)]
mod tests;
