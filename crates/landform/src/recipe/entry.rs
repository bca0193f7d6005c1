//! One stage of a recipe, read and checked.

use std::ops::Range;

use landform_core::error::nearest;
use landform_core::random::Seed;
use landform_core::stage::{ReadStage, Refusal, Stage, Verb};
use landform_core::terrain::Kind;
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

use super::stages::{stage, stages};
use super::tree::{Node, Value, place};
use super::{Clock, Watch};

/// The name of the stage with several processes on one clock.
pub(super) const EVOLVE: &str = "evolve";

/// A stage of a recipe.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// Name of the stage.
    pub(super) name: String,
    /// Name given to it.
    pub(super) label: Option<String>,
    /// Label of the stage that it starts from.
    pub(super) from: Option<String>,
    /// Labels of other stages whose terrains it gets.
    pub(super) with: Vec<String>,
    /// Seed.
    pub(super) seed: Seed,
    /// What it does.
    pub(super) work: Work,
    /// Kind of terrain after it.
    pub(super) kind: Option<Kind>,
    /// Lines of the recipe, from 1, by key; that of the stage under "".
    pub(super) lines: Vec<(String, usize)>,
}

impl Entry {
    /// The failure of the stage at an index, with the line that is to blame.
    pub(super) fn failed(&self, index: usize, source: Error) -> Error {
        if let Error::Stage { .. } = source {
            return source;
        }
        let line_of = |key: &str| self.lines.iter().find(|l| l.0 == key).map(|l| l.1);
        let key = match &source {
            Error::MissingField { .. } => Some("field"),
            source => source.parameter_name().and_then(|name| name.split(['.', '[']).next()),
        };
        let name = self.label.clone().unwrap_or(self.name.clone());
        let line = key.and_then(line_of).or_else(|| line_of(""));
        Error::Stage { index: index + 1, line, name, source: Box::new(source) }
    }
}

/// What a stage of a recipe does.
#[derive(Clone, Debug)]
pub(super) enum Work {
    /// One stage of the table.
    Once(ReadStage),
    /// Processes on a clock.
    Evolve(Box<Evolve>),
}

/// Processes on a clock.
#[derive(Clone, Debug)]
pub(super) struct Evolve {
    pub(super) clock: Clock,
    /// The processes.
    pub(super) parts: Vec<ReadStage>,
    /// Files that are written on the way.
    pub(super) watch: Option<Watch>,
}

impl Work {
    /// Files that are written while processes run.
    pub(super) fn watch(&self) -> Option<&Watch> {
        match self {
            Self::Evolve(evolve) => evolve.watch.as_ref(),
            Self::Once(_) => None,
        }
    }

    /// The stages of the table that take part.
    pub(super) fn parts(&self) -> &[ReadStage] {
        match self {
            Self::Once(stage) => std::slice::from_ref(stage),
            Self::Evolve(evolve) => &evolve.parts,
        }
    }

    /// The verb of the stage, by its first part.
    pub(super) fn verb(&self) -> Verb {
        match self {
            Self::Once(stage) => stage.stage().verb,
            Self::Evolve(_) => Verb::Process,
        }
    }

    /// Files that it writes, below the output folder; of numbered ones the first.
    pub(super) fn outputs(&self) -> Vec<String> {
        let watched = self.watch().into_iter().flat_map(Watch::outputs);
        watched.chain(self.parts().iter().flat_map(|p| p.outputs()).cloned()).collect()
    }

    pub(super) fn changes_terrain(&self) -> bool {
        self.verb().changes_terrain()
    }

    /// Whether its steps are rounds that have no length in time.
    pub(super) fn is_timeless(&self) -> bool {
        matches!(self, Self::Evolve(evolve) if evolve.clock.timeless)
    }

    /// The parameters in customary units, defaults included.
    pub(super) fn normalized(&self) -> Json {
        match self {
            Self::Once(stage) => stage.parameters().clone(),
            Self::Evolve(evolve) => {
                let named = |part: &ReadStage| {
                    let mut json = part.parameters().clone();
                    if let Json::Object(map) = &mut json {
                        map.insert("use".into(), part.stage().name.into());
                    }
                    json
                };
                let process: Vec<_> = evolve.parts.iter().map(named).collect();
                let mut json = serde_json::json!({ "clock": evolve.clock, "process": process });
                // Observations at fixed times shorten steps, and so affect the result.
                if let Some(every) = evolve.watch.as_ref().and_then(|w| w.every) {
                    json["look_every"] = serde_json::json!(every);
                }
                json
            }
        }
    }
}

/// Reads the stages of one recipe.
pub(super) struct EntryReader<'a> {
    /// The recipe's text.
    pub(super) text: &'a str,
    /// Notes to the user about the recipe.
    pub(super) notes: std::cell::RefCell<Vec<String>>,
}

impl EntryReader<'_> {
    pub(super) fn error(&self, span: &Range<usize>, what: impl Into<String>, hint: Option<String>) -> Error {
        let at = (!span.is_empty()).then(|| place(self.text, span.start));
        Error::Recipe { at, what: what.into(), hint }
    }

    /// A text value of a table, taken out.
    pub(super) fn take_text(&self, node: &mut Node, key: &str) -> Result<Option<(String, Range<usize>)>> {
        match node.remove(key) {
            None => Ok(None),
            Some(entry) => match &entry.node.value {
                Value::Leaf(Json::String(s)) => Ok(Some((s.clone(), entry.node.span.clone()))),
                _ => Err(self.error(&entry.node.span, format!("`{key}` is not a text"), None)),
            },
        }
    }

    /// Texts of a list of a table, taken out.
    pub(super) fn take_texts(&self, node: &mut Node, key: &str) -> Result<Vec<(String, Range<usize>)>> {
        let Some(entry) = node.remove(key) else { return Ok(Vec::new()) };
        let wrong = || self.error(&entry.node.span, format!("`{key}` is not a list of texts"), None);
        let Value::Array(items) = &entry.node.value else { return Err(wrong()) };
        let text = |item: &Node| match &item.value {
            Value::Leaf(Json::String(s)) => Ok((s.clone(), item.span.clone())),
            _ => Err(wrong()),
        };
        items.iter().map(text).collect()
    }

    /// What a stage does on a terrain of a kind.
    pub(super) fn work(&self, name: &str, span: &Range<usize>, node: &mut Node, kind: Option<Kind>) -> Result<Work> {
        if name == EVOLVE {
            return self.evolve(span, node, kind);
        }
        let stage = self.find(name, span, kind)?;
        let given = match (stage.verb, node.remove("clock")) {
            (Verb::Process, Some(entry)) => Some(self.clock(&entry.node)?),
            (_, Some(entry)) => {
                return Err(self.error(&entry.span, format!("`{name}` is no process and takes no `clock`"), None));
            }
            (_, None) => None,
        };
        if stage.verb != Verb::Process {
            return Ok(Work::Once(self.read(stage, node)?));
        }
        let watch = node.remove("watch");
        let part = self.read(stage, node)?;
        let Some(clock) = given.or(part.own_clock().map(Clock::of_rounds)) else {
            let hint = Some("for example clock = { duration = \"1 Myr\", dt = \"10 kyr\" }".into());
            return Err(self.error(span, format!("process `{name}` has no `clock`"), hint));
        };
        let watch = watch.map(|entry| self.watch(&entry, &clock)).transpose()?;
        self.may_refine(&clock, &part, span)?;
        Ok(Work::Evolve(Box::new(Evolve { clock, parts: vec![part], watch })))
    }

    fn evolve(&self, span: &Range<usize>, node: &mut Node, kind: Option<Kind>) -> Result<Work> {
        let Some(clock) = node.remove("clock") else {
            let hint = Some("for example clock = { duration = \"1 Myr\", dt = \"10 kyr\" }".into());
            return Err(self.error(span, "`evolve` has no `clock`", hint));
        };
        let clock = self.clock(&clock.node)?;
        let watch = node.remove("watch").map(|entry| self.watch(&entry, &clock)).transpose()?;
        let Some(list) = node.remove("process") else {
            let hint = Some("for example process = [ { use = \"uplift\", rate = \"0.5 mm/yr\" } ]".into());
            return Err(self.error(span, "`evolve` has no `process`", hint));
        };
        if let Some(extra) = node.entries().first() {
            let what = format!(
                "`{}` is not known here; `evolve` takes `clock`, `process`, `watch`, `label`, `from`",
                extra.key
            );
            let known = ["clock", "process", "watch", "label", "from"];
            let hint = nearest(&extra.key, known).map(|n| format!("did you mean `{n}`?"));
            return Err(self.error(&extra.span, what, hint));
        }
        let Value::Array(items) = list.node.value else {
            return Err(self.error(&list.node.span, "`process` is not a list of tables", None));
        };
        if items.is_empty() {
            return Err(self.error(&list.node.span, "`process` is empty", None));
        }
        let mut parts = Vec::new();
        for mut item in items {
            let span = item.span.clone();
            let Some((name, name_span)) = self.take_text(&mut item, "use")? else {
                return Err(self.error(&span, "this process has no `use`", None));
            };
            let stage = self.find(&name, &name_span, kind)?;
            if stage.verb != Verb::Process {
                return Err(self.error(
                    &name_span,
                    format!("`{name}` is no process: it cannot stand in `evolve`"),
                    None,
                ));
            }
            let part = self.read(stage, &mut item)?;
            self.may_refine(&clock, &part, &name_span)?;
            parts.push(part);
        }
        Ok(Work::Evolve(Box::new(Evolve { clock, parts, watch })))
    }

    /// Refuses coarse levels for processes that count rounds: they have no steady state.
    fn may_refine(&self, clock: &Clock, part: &ReadStage, span: &Range<usize>) -> Result<()> {
        if clock.refine > 0 && part.own_clock().is_some() {
            let hint = Some("take `refine` out of the clock, or this process out of the stage".into());
            return Err(self.error(
                span,
                format!("`{}` counts its own rounds and has no coarser levels", part.stage().name),
                hint,
            ));
        }
        Ok(())
    }

    /// The stage of a name that runs on a kind of terrain.
    fn find(&self, name: &str, span: &Range<usize>, kind: Option<Kind>) -> Result<&'static Stage> {
        let Some(found) = stage(name) else {
            let names = stages().map(|s| s.name).chain([EVOLVE]);
            let hint = nearest(name, names).map(|n| format!("did you mean `{n}`?"));
            let hint = hint.or_else(|| Some("`landform stages` lists them all".into()));
            return Err(self.error(span, format!("stage `{name}` is not known"), hint));
        };
        if found.act_on(kind).is_some() {
            return Ok(found);
        }
        let Some(kind) = kind else {
            let hint = Some("begin with a generator such as `stream_graph`, `noise` or `elevation_file`".into());
            return Err(self.error(span, format!("`{name}` has no terrain to work on"), hint));
        };
        let leads = |s: &&Stage| {
            s.verb == Verb::Convert
                && s.act_on(Some(kind)).and_then(|a| a.to).is_some_and(|to| found.kinds().any(|k| k == to))
        };
        let made = |s: &&Stage| {
            s.verb == Verb::Generate && s.acts.iter().any(|a| a.to.is_some_and(|to| found.kinds().any(|k| k == to)))
        };
        // Where few generators make what is wanted, they are told.
        let makers: Vec<_> = stages().filter(made).map(|s| format!("`{}`", s.name)).collect();
        let begin = if makers.len() <= 2 { makers.join(" or ") } else { String::new() };
        let begin = if begin.is_empty() { begin } else { format!(", or begin with {begin}") };
        let hint = stages().find(leads).map(|s| format!("put `{}` before it{begin}", s.name));
        let supports: Vec<_> = found.kinds().map(Kind::name).collect();
        let what = format!("`{name}` does not work on a {kind}; it works on a {}", supports.join(" or a "));
        Err(self.error(span, what, hint))
    }

    fn clock(&self, node: &Node) -> Result<Clock> {
        let mut node = node.clone();
        self.modernize("clock", Clock::RENAMED, &mut node)?;
        self.table("clock", &node, Clock::check)
    }

    /// Gives keys of earlier recipes their present names, with a note.
    fn modernize(&self, stage: &str, renamed: &[(&str, &str)], node: &mut Node) -> Result<()> {
        for (old, new) in renamed {
            let Some(entry) = node.remove(old) else { continue };
            let path: Vec<&str> = new.split('.').collect();
            if node.has(&path) {
                let what = format!("`{stage}`: `{old}` and `{new}` are the same; one is enough");
                return Err(self.error(&entry.span, what, Some(format!("take `{old}` out"))));
            }
            if !node.set(&path, entry.node) {
                return Err(self.error(&entry.span, format!("`{stage}`: `{old}` is `{new}` now"), None));
            }
            self.note(format!("`{stage}`: `{old}` is called `{new}` now"));
        }
        Ok(())
    }

    fn note(&self, note: String) {
        let mut notes = self.notes.borrow_mut();
        if !notes.contains(&note) {
            notes.push(note);
        }
    }

    fn watch(&self, entry: &super::tree::Entry, clock: &Clock) -> Result<Watch> {
        let watch: Watch = self.table("watch", &entry.node, Watch::check)?;
        watch.fits(clock).map_err(|e| self.error(&entry.span, format!("`watch`: {e}"), e.hint()))?;
        Ok(watch)
    }

    /// A table that belongs to a stage but is none of its parameters.
    pub(super) fn table<P>(&self, name: &str, node: &Node, check: fn(&P) -> Result<()>) -> Result<P>
    where
        P: JsonSchema + Serialize + DeserializeOwned,
    {
        let refused = |refusal| self.refuse(name, &landform_core::verb::properties::<P>(), refusal, node);
        let params: P = serde_path_to_error::deserialize(&node.json()).map_err(|e| refused(Refusal::Shape(e)))?;
        let values = serde_json::to_value(&params).unwrap_or_default();
        let schema = landform_core::verb::schema_of::<P>();
        let ranges = landform_core::verb::validate_ranges(&schema, &values);
        ranges.and_then(|()| check(&params)).map_err(|e| refused(Refusal::Value(e)))?;
        Ok(params)
    }

    /// Reads the parameters of a stage, once.
    fn read(&self, stage: &'static Stage, node: &mut Node) -> Result<ReadStage> {
        let old: Vec<_> = stage.renamed.iter().filter(|(old, _)| node.get(old).is_some()).collect();
        self.modernize(stage.name, stage.renamed, node)?;
        for (key, new) in stage.obsolete.iter().filter(|(key, _)| node.get(key).is_some()) {
            self.note(format!("`{}`: `{key}` is called `{new}` now", stage.name));
        }
        let refused = |refusal| by_old_names(self.refuse(stage.name, &(stage.form.properties)(), refusal, node), &old);
        stage.read(&node.json()).map_err(refused)
    }

    /// The refusal with its place and a hint.
    fn refuse(&self, name: &str, properties: &[(String, Json)], refusal: Refusal, node: &Node) -> Error {
        match refusal {
            Refusal::Shape(error) => {
                let span = node.locate(error.path());
                let message = without_place(&error.inner().to_string());
                // Keys that earlier recipes had here are now in a table of their own.
                let moved = stage(name).into_iter().flat_map(|s| s.renamed).map(|r| r.0.to_string());
                let known: Vec<String> = properties.iter().map(|p| p.0.clone()).chain(moved).collect();
                self.shape_error(name, &span, error.path(), &message, &known, node)
            }
            Refusal::Value(error) => {
                let span = error.parameter_name().map_or(node.span.clone(), |name| node.span_at(name));
                self.error(&span, format!("`{name}`: {error}"), error.hint())
            }
        }
    }

    fn shape_error(
        &self,
        stage: &str,
        span: &Range<usize>,
        path: &serde_path_to_error::Path,
        message: &str,
        known: &[String],
        node: &Node,
    ) -> Error {
        if let Some(word) = message.strip_prefix("unknown field `").and_then(|m| m.split('`').next()) {
            // At the top the parameters are known; deeper, the message lists what is.
            if let Some(entry) = node.get(word) {
                let hint = nearest(word, known.iter().map(String::as_str)).map(|n| format!("did you mean `{n}`?"));
                let all = if known.is_empty() { "none".into() } else { known.join(", ") };
                let hint = hint.or_else(|| Some(format!("it has {all}")));
                return self.error(&entry.span, format!("`{stage}` has no parameter `{word}`"), hint);
            }
            let listed: Vec<&str> = message.split('`').skip(3).step_by(2).collect();
            let hint = nearest(word, listed).map(|n| format!("did you mean `{n}`?"));
            return self.error(span, format!("`{stage}`, `{path}`: {message}"), hint);
        }
        if let Some(word) = message.strip_prefix("unknown variant `").and_then(|m| m.split('`').next()) {
            let listed: Vec<&str> = message.split('`').skip(3).step_by(2).collect();
            let hint = nearest(word, listed.iter().copied()).map(|n| format!("did you mean \"{n}\"?"));
            let what = format!("`{stage}`, `{path}`: there is no \"{word}\", expected one of {}", listed.join(", "));
            return self.error(span, what, hint);
        }
        let plain =
            message.replace("expected f64", "expected a number").replace("expected u32", "expected a whole number");
        self.error(span, format!("`{stage}`, `{path}`: {plain}"), None)
    }
}

/// The error, which also says how its keys are called in the recipe: names of old, and names now.
fn by_old_names(error: Error, renamed: &[&(&str, &str)]) -> Error {
    let Error::Recipe { at, mut what, hint } = error else { return error };
    for (old, new) in renamed {
        if what.contains(new) && !what.contains(old) {
            what += &format!(" (`{new}` is `{old}` in the recipe)");
        }
    }
    Error::Recipe { at, what, hint }
}

/// serde_json's message without its line and column, which refer to a text that the user does not
/// see.
fn without_place(message: &str) -> String {
    message.split(" at line ").next().unwrap_or(message).to_string()
}
