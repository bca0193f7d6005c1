//! From text to a recipe.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use landform_core::error::nearest;
use landform_core::{Error, Result};
use serde_json::Value as Json;

use super::entry::{Entry, EntryReader, Work};
use super::stage::stage_seed;
use super::tree::{Node, Value};
use super::{STAGES, Watch};

/// A recipe: read, checked, ready to run.
#[derive(Clone, Debug)]
pub struct Recipe {
    /// Title, for pictures and reports.
    pub title: String,
    /// Seed.
    pub seed: u64,
    /// Folder that paths are relative to.
    pub folder: PathBuf,
    pub(super) entries: Vec<Entry>,
}

/// A key set from outside: `LABEL_OR_STAGE.key=value`.
#[derive(Clone, Debug, PartialEq)]
pub struct Override {
    stage: String,
    path: Vec<String>,
    value: String,
}

impl Override {
    /// Reads `stage.key=value`, `stage.table.key=value`, `seed=value` or `title=value`.
    ///
    /// # Errors
    /// [`Error::Recipe`] if there is no `=` or no key.
    pub fn parse(text: &str) -> Result<Self> {
        let fail = || Error::Recipe {
            at: None,
            what: format!("`--set {text}` is not understood"),
            hint: Some("write --set STAGE.key=value, for example --set uplift.rate=\"1 mm/yr\"".into()),
        };
        let (key, value) = text.split_once('=').ok_or_else(fail)?;
        let mut path: Vec<String> = key.trim().split('.').map(String::from).collect();
        if path.iter().any(String::is_empty) {
            return Err(fail());
        }
        let stage = if path.len() > 1 { path.remove(0) } else { String::new() };
        Ok(Self { stage, path, value: value.trim().into() })
    }
}

const TOP: [&str; 3] = ["seed", "title", "stage"];
const MOST_STAGES: usize = 1_000;

impl Recipe {
    /// Reads a recipe file.
    ///
    /// # Errors
    /// [`Error::Io`], or what [`Recipe::parse`] finds.
    pub fn load(path: &Path, overrides: &[Override]) -> Result<Self> {
        let text = std::fs::read(path).map_err(|e| Error::io("read", path, e))?;
        let text = String::from_utf8(text).map_err(|e| {
            let valid = String::from_utf8_lossy(&e.as_bytes()[..e.utf8_error().valid_up_to()]).into_owned();
            let at = Some(super::tree::place(&valid, valid.len()));
            Error::Recipe { at, what: "this is not UTF-8 text".into(), hint: Some("is it a recipe?".into()) }
        })?;
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let name = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        Self::parse(&text, &name, &folder, overrides)
    }

    /// Reads a recipe's text; `title` if it has none, `folder` for its paths.
    ///
    /// # Errors
    /// [`Error::Recipe`] with line and column, what was expected, and the nearest name.
    pub fn parse(text: &str, title: &str, folder: &Path, overrides: &[Override]) -> Result<Self> {
        let mut root = Node::parse(text)?;
        let reader = EntryReader { text };
        for o in overrides {
            apply(&mut root, o)?;
        }
        if let Some(unknown) = root.entries().iter().find(|e| !TOP.contains(&e.key.as_str())) {
            let hint = nearest(&unknown.key, TOP).map(|n| format!("did you mean `{n}`?"));
            let what = format!("`{}` is not known here; a recipe has `seed`, `title` and [[stage]]", unknown.key);
            return Err(reader.error(&unknown.span, what, hint));
        }
        let seed = read_seed(&reader, &root)?;
        let title = reader.take_text(&mut root, "title")?.map_or(title.to_string(), |t| t.0);
        let stages = match root.remove("stage") {
            Some(entry) => match entry.node.value {
                Value::Array(items) if items.len() <= MOST_STAGES => items,
                Value::Array(_) => {
                    return Err(reader.error(&entry.span, format!("more than {MOST_STAGES} stages"), None));
                }
                _ => return Err(reader.error(&entry.span, "`stage` is not a list", Some("write [[stage]]".into()))),
            },
            None => Vec::new(),
        };
        if stages.is_empty() {
            let hint = Some("write [[stage]] and below it use = \"stream_graph\"".into());
            return Err(Error::Recipe { at: None, what: "the recipe has no stages".into(), hint });
        }
        let entries = read_stages(&reader, stages, seed)?;
        Ok(Self { title, seed, folder: folder.into(), entries })
    }
}

fn read_seed(reader: &EntryReader, root: &Node) -> Result<u64> {
    match root.get("seed").map(|e| (&e.node.value, &e.node.span)) {
        None => Ok(0),
        Some((Value::Leaf(Json::Number(n)), span)) => {
            n.as_u64().ok_or_else(|| reader.error(span, format!("`seed` is {n}; expected a whole number from 0"), None))
        }
        Some((_, span)) => Err(reader.error(span, "`seed` is not a whole number", None)),
    }
}

fn read_stages(reader: &EntryReader, stages: Vec<Node>, seed: u64) -> Result<Vec<Entry>> {
    let mut entries: Vec<Entry> = Vec::new();
    let mut kinds: BTreeMap<String, &'static str> = BTreeMap::new();
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    let mut kind = None;
    for mut node in stages {
        let span = node.span.clone();
        let Some((name, name_span)) = reader.take_text(&mut node, "use")? else {
            return Err(reader.error(
                &span,
                "this stage has no `use`",
                Some("say which stage it is: use = \"...\"".into()),
            ));
        };
        let label = reader.take_text(&mut node, "label")?;
        let from = reader.take_text(&mut node, "from")?;
        if let Some((from, span)) = &from {
            kind = Some(*kinds.get(from).ok_or_else(|| {
                let hint = nearest(from, kinds.keys().map(String::as_str)).map(|n| format!("did you mean `{n}`?"));
                reader.error(span, format!("no stage before this one has the label `{from}`"), hint)
            })?);
        }
        let work = reader.work(&name, &name_span, &mut node, kind)?;
        let after =
            work.parts().last().map_or("", |(s, _)| if s.verb.changes_terrain() { s.to } else { kind.unwrap_or("") });
        kind = Some(after);
        let count = counts.entry(name.clone()).or_default();
        *count += 1;
        let identity = label.as_ref().map_or_else(|| format!("{name}#{count}"), |l| l.0.clone());
        if let Some((label, span)) = &label
            && kinds.insert(label.clone(), after).is_some()
        {
            return Err(reader.error(span, format!("the label `{label}` is given twice"), None));
        }
        entries.push(Entry {
            seed: stage_seed(seed, &identity),
            label: label.map(|l| l.0),
            from: from.map(|f| f.0),
            kind: after,
            name,
            work,
        });
    }
    check_paths(&entries)?;
    Ok(entries)
}

/// Two exports to one path would leave only the second.
fn check_paths(entries: &[Entry]) -> Result<()> {
    let mut seen = BTreeMap::new();
    for (k, entry) in entries.iter().enumerate() {
        let mut paths: Vec<String> =
            entry.work.watch().into_iter().flat_map(Watch::paths).map(|p| p.1.into()).collect();
        if let Work::Once(stage, _) = &entry.work
            && !stage.verb.changes_terrain()
        {
            paths.extend(entry.work.normalized()["path"].as_str().map(String::from));
        }
        for path in paths {
            if let Some(first) = seen.insert(path.clone(), k + 1) {
                let what = format!("stages {first} and {} both write `{path}`", k + 1);
                return Err(Error::Recipe { at: None, what, hint: Some("give one of them another `path`".into()) });
            }
        }
    }
    Ok(())
}

/// Sets a key in every stage (or process within `evolve`) of a name, or in the one of a label.
fn apply(root: &mut Node, o: &Override) -> Result<()> {
    let path: Vec<&str> = o.path.iter().map(String::as_str).collect();
    let value = Node::parse_value(&o.value)?;
    if o.stage.is_empty() {
        if !["seed", "title"].contains(&path[0]) {
            let hint = Some("write --set STAGE.key=value".into());
            return Err(Error::Recipe { at: None, what: format!("`--set {}`: which stage?", o.path[0]), hint });
        }
        root.set(&path, value);
        return Ok(());
    }
    let mut found = false;
    let mut names: Vec<String> = Vec::new();
    if let Value::Table(entries) = &mut root.value
        && let Some(stages) = entries.iter_mut().find(|e| e.key == "stage")
        && let Value::Array(stages) = &mut stages.node.value
    {
        for stage in stages {
            found |= set_if_named(stage, &o.stage, &path, &value, &mut names);
            if let Value::Table(inner) = &mut stage.value
                && let Some(list) = inner.iter_mut().find(|e| e.key == "process")
                && let Value::Array(items) = &mut list.node.value
            {
                for item in items {
                    found |= set_if_named(item, &o.stage, &path, &value, &mut names);
                }
            }
        }
    }
    if found {
        return Ok(());
    }
    if names.contains(&o.stage) {
        let what = format!("`--set`: `{}` has no place for `{}`", o.stage, o.path.join("."));
        let hint = Some("a process within `evolve` is set by its own name, as in uplift.rate=...".into());
        return Err(Error::Recipe { at: None, what, hint });
    }
    let hint = nearest(&o.stage, names.iter().map(String::as_str)).map(|n| format!("did you mean `{n}`?"));
    let known = STAGES.iter().any(|s| s.name == o.stage);
    let what = if known { "is not in the recipe" } else { "is neither a stage nor a label of the recipe" };
    Err(Error::Recipe { at: None, what: format!("`--set`: `{}` {what}", o.stage), hint })
}

fn set_if_named(node: &mut Node, wanted: &str, path: &[&str], value: &Node, names: &mut Vec<String>) -> bool {
    let mut hit = false;
    for key in ["use", "label"] {
        if let Some(entry) = node.get(key)
            && let Value::Leaf(Json::String(name)) = &entry.node.value
        {
            hit |= name == wanted;
            names.push(name.clone());
        }
    }
    hit && node.set(path, value.clone())
}
