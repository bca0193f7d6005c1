//! The plan of a recipe: its stages, sizes and memory.

use landform_core::stage::{Verb, bytes_a_node_of, warnings_of};
use landform_core::terrain::Kind;
use landform_core::verb::{Context, ELEVATIONS, Estimate, relative_path};
use landform_core::{Error, Result};

use super::Recipe;
use super::cache::{Cache, input_paths, key};
use super::entry::{Entry, Work};
use super::fields::Known;

/// A recipe's plan.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The stages in order.
    pub stages: Vec<PlannedStage>,
    /// Bytes at the greatest peak.
    pub bytes: u64,
    /// Names that the last landscape may have, beside those of its layers.
    pub fields: Vec<String>,
}

/// Bytes of the program itself.
const PROGRAM: u64 = 13 << 20;

/// The plan of one stage.
#[derive(Clone, Debug)]
pub struct PlannedStage {
    /// Name, or several joined.
    pub name: String,
    /// Label, if it has one.
    pub label: Option<String>,
    /// What it does.
    pub verb: Verb,
    /// Kind of the terrain after it.
    pub kind: Option<Kind>,
    /// Nodes of the terrain after it.
    pub nodes: u64,
    /// Bytes at its peak.
    pub bytes: u64,
    /// Whether its terrain is in the cache, so that it will not run, unless it is watched.
    pub cached: bool,
    /// Whether it writes files while it runs, and so runs even if its terrain is in the cache.
    pub watched: bool,
    /// What a user should know of its parameters before a run.
    pub notes: Vec<String>,
    /// Key of the terrain after it.
    pub(super) key: String,
}

impl PlannedStage {
    /// Reads what a cache keeps of the stage, and refuses it where it is not whole. A run would
    /// make it again.
    ///
    /// # Errors
    /// [`Error::Io`] or [`Error::Format`].
    pub fn check_kept(&self, cache: &Cache) -> Result<()> {
        cache.check(&self.key)
    }
}

impl Recipe {
    /// Checks without a run that files exist, sizes and memory, and finds what is cached.
    ///
    /// # Errors
    /// [`Error::Stage`] if it is known that a stage would fail.
    pub fn plan(&self, cache: Option<&Cache>, salt: &str) -> Result<Plan> {
        let mut stages: Vec<PlannedStage> = Vec::new();
        let mut current = (Estimate::default(), self.surroundings(), None, Known::default());
        let mut labelled = std::collections::BTreeMap::new();
        for (index, entry) in self.entries.iter().enumerate() {
            if let Some(from) = &entry.from
                && let Some(known) = labelled.get(from)
            {
                current = Clone::clone(known);
            }
            let fail = |source| entry.failed(index, source);
            self.check_inputs(entry).map_err(fail)?;
            self.check_outputs(entry).map_err(fail)?;
            let fields_before = current.3.count();
            current.3.pass(entry, &self.environment.materials).map_err(fail)?;
            if self.window.is_none() {
                entry.work.parts().iter().try_for_each(|part| part.check_places(&current.0)).map_err(fail)?;
            }
            let (environment, window) = (&*self.environment, self.window);
            let context = Context { seed: entry.seed, maps: &*self.maps, environment, window, ..Context::default() };
            let held = labelled.values().map(held).sum::<u64>() + fields_before * 8 * current.0.nodes;
            let notes = warnings_of(entry.work.parts(), &current.0);
            current.0 = estimate(entry, current.2, current.0, &context).map_err(fail)?;
            current.0.bytes += PROGRAM + held;
            if entry.work.changes_terrain() {
                let beside = entry.with.iter().filter_map(|label| labelled.get(label)).map(|l| l.1.as_str());
                let before: Vec<&str> = std::iter::once(current.1.as_str()).chain(beside).collect();
                current.1 = key(&before, entry, &self.folder, salt);
            }
            current.2 = entry.kind;
            if let Some(label) = &entry.label {
                labelled.insert(label.clone(), current.clone());
            }
            let parts = entry.work.parts();
            let names: Vec<_> = parts.iter().map(|p| p.stage().name).collect();
            stages.push(PlannedStage {
                name: if parts.len() > 1 { format!("evolve: {}", names.join(" + ")) } else { names.join("") },
                label: entry.label.clone(),
                verb: entry.work.verb(),
                kind: entry.kind,
                nodes: current.0.nodes,
                bytes: current.0.bytes,
                cached: entry.work.changes_terrain() && cache.is_some_and(|c| c.has(&current.1)),
                watched: entry.work.watch().is_some(),
                notes,
                key: current.1.clone(),
            });
        }
        let bytes = stages.iter().map(|s| s.bytes).max().unwrap_or(0);
        Ok(Plan { stages, bytes, fields: current.3.names() })
    }

    /// What the files that were read say and nobody follows, and what was assumed of them, since
    /// this was last asked.
    pub fn file_notes(&self) -> Vec<String> {
        self.maps.take_notes()
    }

    /// Files that it reads.
    pub fn inputs(&self) -> impl Iterator<Item = std::path::PathBuf> {
        let parts = self.entries.iter().flat_map(|e| e.work.parts());
        let around = serde_json::to_value(&*self.environment).unwrap_or_default();
        let paths = parts.flat_map(|p| input_paths(p.stage().inputs, p.parameters())).chain(input_paths(&[], &around));
        paths.map(|path| self.folder.join(path))
    }

    /// Files that it writes, below the output folder; of the numbered frames of a `watch` the
    /// first.
    pub fn outputs(&self) -> impl Iterator<Item = String> {
        self.entries.iter().flat_map(|e| e.work.outputs())
    }

    /// Whether a file of the output folder may be a numbered frame of a `watch`.
    pub fn is_frame(&self, path: &str) -> bool {
        self.entries.iter().filter_map(|e| e.work.watch()).any(|watch| watch.is_frame(path))
    }

    /// What the key of the first stage begins with: what surrounds the landscape.
    fn surroundings(&self) -> String {
        let environment = &*self.environment;
        let window = self.window.map(|w| format!("{w:?} ")).unwrap_or_default();
        if *environment == Default::default() {
            return window;
        }
        let said = serde_json::to_string(environment).unwrap_or_default();
        format!("{window}{said} {}", serde_json::to_string(&environment.materials).unwrap_or_default())
    }

    /// Refuses paths outside the output folder, unless they are allowed.
    fn check_outputs(&self, entry: &Entry) -> Result<()> {
        let leaves = |path: &String| relative_path(path).is_err();
        match entry.work.outputs().into_iter().find(leaves).filter(|_| !self.allow_outside) {
            Some(path) => Err(Error::Recipe {
                at: None,
                what: format!("`{path}` leads out of the output folder, or has `..` in it"),
                hint: Some("give a path below it, or allow it with --allow-outside".into()),
            }),
            None => Ok(()),
        }
    }

    fn check_inputs(&self, entry: &Entry) -> Result<()> {
        for part in entry.work.parts() {
            for path in input_paths(part.stage().inputs, part.parameters()) {
                let path = self.folder.join(path);
                std::fs::metadata(&path).map_err(|e| Error::io("read", &path, e))?;
            }
        }
        Ok(())
    }
}

/// What is known of a landscape on the way: size, key, kind, fields.
type Planned = (Estimate, String, Option<Kind>, Known);

/// Bytes that a landscape holds which a label keeps.
fn held((size, _, _, known): &Planned) -> u64 {
    size.nodes * (ELEVATIONS + 8 * known.count())
}

fn estimate(entry: &Entry, kind: Option<Kind>, before: Estimate, context: &Context) -> Result<Estimate> {
    match &entry.work {
        Work::Evolve(evolve) => {
            let parts: Vec<_> = entry.work.parts().iter().collect();
            let bytes = before.nodes * bytes_a_node_of(&parts, entry.kind);
            // Coarser levels have a quarter of the nodes each, and are held beside the finest.
            let coarser = if evolve.clock.halvings().is_empty() { 0 } else { bytes / 3 };
            Ok(Estimate { bytes: bytes + coarser, ..before })
        }
        Work::Once(stage) => stage.estimate(kind, before, context),
    }
}
