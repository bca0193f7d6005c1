//! Which fields a landscape has after each stage of a recipe, as far as is known without a run.

use std::collections::BTreeSet;

use landform_core::feature::{FeatureKind, Features};
use landform_core::field::names;
use landform_core::stage::{Stage, Verb};
use landform_core::terrain::Materials;
use landform_core::{Error, Result};
use serde_json::Value as Json;

use super::entry::Entry;

/// Names that a landscape may have, and stages that may have left it features.
#[derive(Clone, Debug, Default)]
pub(super) struct Known(BTreeSet<String>, BTreeSet<&'static str>);

impl Known {
    /// How many there are, elevations and layers left out.
    pub(super) fn count(&self) -> u64 {
        self.0.len() as u64
    }

    /// The names, in order.
    pub(super) fn names(&self) -> Vec<String> {
        let elevation = [names::ELEVATION.name.to_string()];
        self.0.iter().cloned().chain(elevation).collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// Refuses a stage that asks for a field that nothing before it leaves, and adds what it
    /// leaves.
    ///
    /// # Errors
    /// [`Error::MissingField`] with the names that there may be.
    pub(super) fn pass(&mut self, entry: &Entry, materials: &Materials) -> Result<()> {
        if entry.work.verb() == Verb::Generate {
            self.0.clear();
            self.1.clear();
        }
        for part in entry.work.parts() {
            self.need_features(part.stage())?;
            self.1.insert(part.stage().name);
        }
        // Processes on one clock may read what the others leave; a file's own field is its own.
        let leaves: Vec<&str> = entry.work.parts().iter().flat_map(|part| part.leaves()).collect();
        let reads_own = [Verb::Process, Verb::Generate].contains(&entry.work.verb());
        for part in entry.work.parts() {
            for name in asked(part.parameters()) {
                let is_left = self.0.contains(name) || reads_own && leaves.contains(&name);
                if !is_left && !always(name, materials) {
                    let available = self.names();
                    let needed_by = format!("`{}`", part.stage().name);
                    return Err(Error::MissingField { name: name.into(), needed_by, available });
                }
            }
        }
        self.0.extend(leaves.into_iter().map(String::from));
        Ok(())
    }
}

impl Known {
    /// Refuses a stage that needs features that no stage before it leaves.
    fn need_features(&self, stage: &Stage) -> Result<()> {
        let is_left = |kind: &FeatureKind| kind.left_by().iter().any(|by| self.1.contains(by));
        match stage.needs.iter().find(|kind| !is_left(kind)) {
            Some(kind) => Features::default().need(*kind, &format!("`{}`", stage.name)).map(drop),
            None => Ok(()),
        }
    }
}

/// Whether a landscape may have a name by what it is made of.
fn always(name: &str, materials: &Materials) -> bool {
    let is_layer = name.strip_suffix(names::DEPTH_SUFFIX).is_some_and(|layer| materials.find(layer).is_some());
    is_layer || [names::ELEVATION.name, names::SURFACE_MATERIAL.name].contains(&name)
}

/// The names of fields in parameters: `field = "slope"`, there or in a table of them.
fn asked(parameters: &Json) -> Vec<&str> {
    match parameters {
        Json::Object(table) => {
            let own = table.get("field").and_then(Json::as_str);
            own.into_iter().chain(table.values().flat_map(asked)).collect()
        }
        Json::Array(items) => items.iter().flat_map(asked).collect(),
        _ => Vec::new(),
    }
}
