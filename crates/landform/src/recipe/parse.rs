//! From text to a recipe.

use std::collections::BTreeMap;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use landform_core::error::nearest;
use landform_core::terrain::{MaterialParams, Materials};
use landform_core::verb::{Environment, Window};
use landform_core::{Error, Result};
use landform_io::import::FileMaps;
use serde_json::Value as Json;

use super::entry::{Entry, EntryReader};
use super::sequence::read_stages;
use super::stages::stage;
use super::tree::{Node, Value};

/// A recipe: read, checked, ready to run.
#[derive(Clone, Debug)]
pub struct Recipe {
    /// Title, for pictures and reports.
    pub title: String,
    /// Seed.
    pub seed: u64,
    /// Folder that paths are relative to.
    pub folder: PathBuf,
    /// Sea level, rain, winds and materials, for stages that have no values of their own.
    pub environment: Arc<Environment>,
    /// Notes to the user: keys of earlier recipes, and their present names.
    pub notes: Vec<String>,
    /// Whether files may be written outside of the output folder.
    pub allow_outside: bool,
    pub(super) entries: Vec<Entry>,
    /// Maps of its folder, each read once.
    pub(super) maps: Arc<FileMaps>,
    /// The part of the ground that is wanted, if not all of it is.
    pub(super) window: Option<Window>,
}

/// A key set from outside: `LABEL_OR_STAGE.key=value`.
///
/// ```
/// use std::path::Path;
/// use landform::core::verb::MemoryOutput;
/// use landform::recipe::{Options, Override, Ran, Recipe};
///
/// let text = "[[stage]]\nuse = \"flat\"\ngrid = { size = [\"400 m\", \"400 m\"] }";
/// let higher = Override::parse("flat.elevation=9 m")?;
/// let recipe = Recipe::parse(text, "plain", Path::new("."), &[higher])?;
/// let ran = recipe.run(&mut MemoryOutput::default(), &Options::default())?;
/// let Ran::ToTheEnd(terrain, _) = ran else { panic!("nobody interrupts it") };
/// assert_eq!(terrain.elevation()[0], 9.0);
/// # Ok::<(), landform::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Override {
    stage: String,
    path: Vec<String>,
    value: String,
}

impl Override {
    /// Reads `stage.key=value`, `stage.table.key=value`, `environment.key=value`,
    /// `materials.name.key=value`, `seed=value` or `title=value`.
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

impl fmt::Display for Override {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stage = if self.stage.is_empty() { String::new() } else { format!("{}.", self.stage) };
        write!(f, "{stage}{}={}", self.path.join("."), self.value)
    }
}

const TOP: [&str; 5] = ["seed", "title", "environment", "materials", "stage"];
const MOST_STAGES: usize = 1_000;

impl Recipe {
    /// Reads a recipe file.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read, or where [`Recipe::parse`] fails.
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
    /// [`Error::Recipe`] if a part of the text is wrong, with line and column, the expected value
    /// and the nearest name; [`Error::Several`] if several parts are.
    pub fn parse(text: &str, title: &str, folder: &Path, overrides: &[Override]) -> Result<Self> {
        let read = |overrides: &[Override]| Self::parse_with(text, title, folder, overrides);
        let failed = match read(overrides) {
            Err(error) if !overrides.is_empty() && read(&[]).is_ok() => error,
            other => return other,
        };
        // What is wrong stands in no line of the recipe.
        let blame = |set: &Override| {
            let source = read(std::slice::from_ref(set)).err()?;
            Some(Error::Override { text: set.to_string(), source: Box::new(source) })
        };
        let all: Vec<Error> = overrides.iter().filter_map(blame).collect();
        Err(if all.is_empty() { failed } else { Error::several(all) })
    }

    fn parse_with(text: &str, title: &str, folder: &Path, overrides: &[Override]) -> Result<Self> {
        let mut root = Node::parse(text)?;
        let reader = EntryReader { text, notes: Default::default() };
        for o in overrides {
            apply(&mut root, o)?;
        }
        let mut mistakes: Vec<Error> = unknown_words(&reader, &root);
        let seed = kept(read_seed(&reader, &root), &mut mistakes);
        let own_title = kept(reader.take_text(&mut root, "title"), &mut mistakes).flatten();
        let environment = kept(read_environment(&reader, &mut root), &mut mistakes);
        // A misspelt word may be the missing [[stage]].
        if !mistakes.is_empty() && root.get("stage").is_none() {
            return Err(Error::several(mistakes));
        }
        let stages = take_stages(&reader, &mut root).and_then(|list| read_stages(&reader, list, seed.unwrap_or(0)));
        let stages = kept(stages, &mut mistakes);
        let (Some(entries), Some(seed), Some(environment), []) = (stages, seed, environment, &mistakes[..]) else {
            return Err(Error::several(mistakes));
        };
        let (title, environment) = (own_title.map_or(title.to_string(), |t| t.0), Arc::new(environment));
        let notes = reader.notes.into_inner();
        let maps = Arc::new(FileMaps::new(folder));
        Ok(Self {
            title,
            seed,
            folder: folder.into(),
            environment,
            notes,
            allow_outside: false,
            entries,
            maps,
            window: None,
        })
    }
}

/// The value; a mistake is put to the others.
fn kept<T>(result: Result<T>, mistakes: &mut Vec<Error>) -> Option<T> {
    match result {
        Ok(value) => Some(value),
        Err(Error::Several(more)) => {
            mistakes.extend(more);
            None
        }
        Err(mistake) => {
            mistakes.push(mistake);
            None
        }
    }
}

fn unknown_words(reader: &EntryReader, root: &Node) -> Vec<Error> {
    let unknown = root.entries().iter().filter(|e| !TOP.contains(&e.key.as_str()));
    unknown
        .map(|e| {
            let hint = nearest(&e.key, TOP).map(|n| format!("did you mean `{n}`?"));
            let what = format!(
                "`{}` is not known here; a recipe has `seed`, `title`, [environment], [materials] and [[stage]]",
                e.key
            );
            reader.error(&e.span, what, hint)
        })
        .collect()
}

fn take_stages(reader: &EntryReader, root: &mut Node) -> Result<Vec<Node>> {
    let stages = match root.remove("stage") {
        Some(entry) => match entry.node.value {
            Value::Array(items) if items.len() <= MOST_STAGES => items,
            Value::Array(_) => return Err(reader.error(&entry.span, format!("more than {MOST_STAGES} stages"), None)),
            _ => return Err(reader.error(&entry.span, "`stage` is not a list", Some("write [[stage]]".into()))),
        },
        None => Vec::new(),
    };
    if stages.is_empty() {
        let hint = Some("write [[stage]] and below it use = \"stream_graph\"".into());
        return Err(Error::Recipe { at: None, what: "the recipe has no stages".into(), hint });
    }
    Ok(stages)
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

fn read_environment(reader: &EntryReader, root: &mut Node) -> Result<Environment> {
    let mut environment = match root.remove("environment") {
        Some(entry) => reader.table("environment", &entry.node, Environment::check)?,
        None => Environment::default(),
    };
    let mut changes: BTreeMap<String, MaterialParams> = BTreeMap::new();
    if let Some(entry) = root.remove("materials") {
        let Value::Table(materials) = entry.node.value else {
            let hint = Some("write [materials] and below it sandstone = { erodibility = \"1e-6 1/yr\" }".into());
            return Err(reader.error(&entry.node.span, "`materials` is not a table", hint));
        };
        for material in materials {
            changes.insert(material.key.clone(), reader.table(&material.key, &material.node, |_| Ok(()))?);
        }
    }
    environment.materials = Materials::with(&changes)?;
    Ok(environment)
}

/// Sets a key in every stage (or process within `evolve`) of a name, or in the one of a label.
fn apply(root: &mut Node, o: &Override) -> Result<()> {
    let path: Vec<&str> = o.path.iter().map(String::as_str).collect();
    let value = Node::parse_value(&o.value)?;
    if o.stage.is_empty() {
        if !["seed", "title"].contains(&path[0]) {
            let hint = Some("write --set STAGE.key=value".into());
            return Err(Error::Recipe { at: None, what: format!("of which stage is `{}`?", o.path[0]), hint });
        }
        root.set(&path, value);
        return Ok(());
    }
    if ["environment", "materials"].contains(&o.stage.as_str()) {
        let whole: Vec<&str> = std::iter::once(o.stage.as_str()).chain(path).collect();
        root.set(&whole, value);
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
        let what = format!("`{}` has no place for `{}`", o.stage, o.path.join("."));
        let hint = Some("a process within `evolve` is set by its own name, as in uplift.rate=...".into());
        return Err(Error::Recipe { at: None, what, hint });
    }
    let hint = nearest(&o.stage, names.iter().map(String::as_str)).map(|n| format!("did you mean `{n}`?"));
    let known = stage(&o.stage).is_some();
    let what = if known { "is not in the recipe" } else { "is neither a stage nor a label of the recipe" };
    Err(Error::Recipe { at: None, what: format!("`{}` {what}", o.stage), hint })
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
    let path = today(node, path);
    hit && node.set(&path.iter().map(String::as_str).collect::<Vec<_>>(), value.clone())
}

/// A path of an earlier recipe's keys by their present names.
fn today(node: &Node, path: &[&str]) -> Vec<String> {
    let name = node.get("use").and_then(|e| match &e.node.value {
        Value::Leaf(Json::String(name)) => Some(name.as_str()),
        _ => None,
    });
    let of_stage = |p: &[&str]| name.and_then(stage).and_then(|s| s.renamed.iter().find(|r| r.0 == p[0])).map(|r| r.1);
    let owned = |p: &[&str]| p.iter().map(|w| w.to_string()).collect::<Vec<_>>();
    match path {
        ["clock", "max_steps"] if !node.has(path) => owned(&["clock", "iterations"]),
        [_, rest @ ..] => match of_stage(path).filter(|_| node.get(path[0]).is_none()) {
            Some(new) => new.split('.').map(String::from).chain(owned(rest)).collect(),
            None => owned(path),
        },
        [] => Vec::new(),
    }
}
