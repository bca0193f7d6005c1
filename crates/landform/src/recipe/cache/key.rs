//! Keys: everything that a terrain follows from.

use std::path::Path;

use landform_io::files::read_whole;
use serde_json::Value as Json;
use sha2::{Digest, Sha256};

use crate::recipe::entry::Entry;

/// The key of the terrain after a stage: what came before and beside it, the stage with its
/// parameters and seed, the files that it reads, and the program.
pub(in crate::recipe) fn key(before: &[&str], entry: &Entry, folder: &Path, salt: &str) -> String {
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
            let content = read_whole(&folder.join(&path)).unwrap_or_default();
            hash.update(Sha256::digest(content));
        }
    }
    hex(&hash.finalize(), 16)
}

/// A few digits that tell texts apart.
pub(in crate::recipe) fn short_hash(text: &str) -> String {
    hex(&Sha256::digest(text), 8)
}

fn hex(bytes: &[u8], most: usize) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).take(most).collect()
}

/// Files that parameters name: keys that are inputs, and maps in values that vary, however deep.
pub(in crate::recipe) fn input_paths(inputs: &[&str], json: &Json) -> Vec<String> {
    let mut paths: Vec<String> = inputs.iter().filter_map(|k| json[*k].as_str()).map(String::from).collect();
    if let Json::Object(map) = json {
        map.values().for_each(|value| maps_in(value, &mut paths));
    }
    paths
}

fn maps_in(json: &Json, paths: &mut Vec<String>) {
    if let Json::Array(list) = json {
        list.iter().for_each(|value| maps_in(value, paths));
    }
    if let Json::Object(map) = json {
        paths.extend(["image", "raster"].iter().filter_map(|k| json[*k].as_str()).map(String::from));
        map.values().for_each(|value| maps_in(value, paths));
    }
}
