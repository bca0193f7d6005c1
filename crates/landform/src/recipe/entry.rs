//! One stage of a recipe, read and checked.

use std::ops::Range;

use landform_core::error::nearest;
use landform_core::random::Seed;
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

use super::stage::{Form, Refusal, schema_of};
use super::tree::{Node, Value, place};
use super::{Clock, STAGES, Stage, Verb, Watch};

/// The word for several processes on one clock.
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
    /// Seed.
    pub(super) seed: Seed,
    /// What it does.
    pub(super) work: Work,
    /// Kind of terrain after it.
    pub(super) kind: &'static str,
}

/// What a stage of a recipe does.
#[derive(Clone, Debug)]
pub(super) enum Work {
    /// One stage of the table, with its parameters as typed.
    Once(&'static Stage, Json),
    /// Processes on a clock.
    Evolve(Box<Evolve>),
}

/// Processes on a clock.
#[derive(Clone, Debug)]
pub(super) struct Evolve {
    pub(super) clock: Clock,
    /// Processes with their parameters as typed.
    pub(super) parts: Vec<(&'static Stage, Json)>,
    /// What is written on the way.
    pub(super) watch: Option<Watch>,
}

impl Work {
    /// What is written while processes run.
    pub(super) fn watch(&self) -> Option<&Watch> {
        match self {
            Self::Evolve(evolve) => evolve.watch.as_ref(),
            Self::Once(..) => None,
        }
    }

    /// The stages of the table that take part.
    pub(super) fn parts(&self) -> Vec<(&'static Stage, &Json)> {
        match self {
            Self::Once(stage, json) => vec![(stage, json)],
            Self::Evolve(evolve) => evolve.parts.iter().map(|(s, j)| (*s, j)).collect(),
        }
    }

    pub(super) fn changes_terrain(&self) -> bool {
        self.parts().iter().any(|(s, _)| s.verb.changes_terrain())
    }

    /// The parameters in customary units, defaults included.
    pub(super) fn normalized(&self) -> Json {
        let one = |stage: &Stage, json: &Json| (stage.form.normalize)(json).unwrap_or_else(|_| json.clone());
        match self {
            Self::Once(stage, json) => one(stage, json),
            Self::Evolve(evolve) => {
                let process: Vec<_> = evolve
                    .parts
                    .iter()
                    .map(|(stage, json)| {
                        let mut json = one(stage, json);
                        if let Json::Object(map) = &mut json {
                            map.insert("use".into(), stage.name.into());
                        }
                        json
                    })
                    .collect();
                let mut json = serde_json::json!({ "clock": evolve.clock, "process": process });
                // Looks at fixed times shorten steps, and so are part of what comes out.
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

    /// What a stage does on a terrain of a kind.
    pub(super) fn work(&self, name: &str, span: &Range<usize>, node: &mut Node, kind: Option<&str>) -> Result<Work> {
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
            self.check(stage, node)?;
            return Ok(Work::Once(stage, node.json()));
        }
        let watch = node.remove("watch");
        self.check(stage, node)?;
        let Some(clock) = given.or(stage.own_clock(&node.json())?.map(Clock::of_rounds)) else {
            let hint = Some("for example clock = { duration = \"1 Myr\", dt = \"10 kyr\" }".into());
            return Err(self.error(span, format!("process `{name}` has no `clock`"), hint));
        };
        let watch = watch.map(|entry| self.watch(&entry, &clock)).transpose()?;
        self.may_refine(&clock, stage, &node.json(), span)?;
        Ok(Work::Evolve(Box::new(Evolve { clock, parts: vec![(stage, node.json())], watch })))
    }

    fn evolve(&self, span: &Range<usize>, node: &mut Node, kind: Option<&str>) -> Result<Work> {
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
            self.check(stage, &item)?;
            self.may_refine(&clock, stage, &item.json(), &name_span)?;
            parts.push((stage, item.json()));
        }
        Ok(Work::Evolve(Box::new(Evolve { clock, parts, watch })))
    }

    /// Refuses coarse levels for processes that count rounds: what they leave is no steady state.
    fn may_refine(&self, clock: &Clock, stage: &Stage, json: &Json, span: &Range<usize>) -> Result<()> {
        if clock.refine > 0 && stage.own_clock(json)?.is_some() {
            let hint = Some("take `refine` out of the clock, or this process out of the stage".into());
            return Err(self.error(
                span,
                format!("`{}` counts its own rounds and has no coarser levels", stage.name),
                hint,
            ));
        }
        Ok(())
    }

    /// The stage of a name that runs on a kind of terrain.
    fn find(&self, name: &str, span: &Range<usize>, kind: Option<&str>) -> Result<&'static Stage> {
        let named: Vec<_> = STAGES.iter().filter(|s| s.name == name).collect();
        if named.is_empty() {
            let names = STAGES.iter().map(|s| s.name).chain([EVOLVE]);
            let hint = nearest(name, names).map(|n| format!("did you mean `{n}`?"));
            let hint = hint.or_else(|| Some("`landform stages` lists them all".into()));
            return Err(self.error(span, format!("stage `{name}` is not known"), hint));
        }
        if let Some(stage) = named.iter().find(|s| s.on.is_none() || s.on == kind) {
            return Ok(stage);
        }
        let supports: Vec<_> = named.iter().filter_map(|s| s.on).collect();
        let Some(kind) = kind else {
            let hint = Some("begin with a generator such as `stream_graph`, `noise` or `elevation_file`".into());
            return Err(self.error(span, format!("`{name}` has no terrain to work on"), hint));
        };
        let hint = STAGES
            .iter()
            .find(|s| s.verb == Verb::Convert && s.on == Some(kind) && supports.contains(&s.to))
            .map(|s| format!("put `{}` before it", s.name));
        let what = format!("`{name}` does not work on a {kind}; it works on a {}", supports.join(" or a "));
        Err(self.error(span, what, hint))
    }

    fn clock(&self, node: &Node) -> Result<Clock> {
        self.table("clock", node, Clock::check)
    }

    fn watch(&self, entry: &super::tree::Entry, clock: &Clock) -> Result<Watch> {
        let watch: Watch = self.table("watch", &entry.node, Watch::check)?;
        watch.fits(clock).map_err(|e| self.error(&entry.span, format!("`watch`: {e}"), e.hint()))?;
        Ok(watch)
    }

    /// A table that belongs to a stage but is none of its parameters.
    fn table<P>(&self, name: &str, node: &Node, check: fn(&P) -> Result<()>) -> Result<P>
    where
        P: JsonSchema + Serialize + DeserializeOwned,
    {
        let refused = |refusal| self.refuse(name, &landform_core::verb::properties::<P>(), refusal, node);
        let params: P = serde_path_to_error::deserialize(&node.json()).map_err(|e| refused(Refusal::Shape(e)))?;
        let values = serde_json::to_value(&params).unwrap_or_default();
        let ranges = landform_core::verb::validate_ranges(&schema_of::<P>(), &values);
        ranges.and_then(|()| check(&params)).map_err(|e| refused(Refusal::Value(e)))?;
        Ok(params)
    }

    fn check(&self, stage: &'static Stage, node: &Node) -> Result<()> {
        self.check_form(stage.name, &stage.form, node)
    }

    fn check_form(&self, name: &str, form: &Form, node: &Node) -> Result<()> {
        (form.normalize)(&node.json()).map(drop).map_err(|e| self.refuse(name, &(form.properties)(), e, node))
    }

    /// The refusal with its place and a hint.
    fn refuse(&self, name: &str, properties: &[(String, Json)], refusal: Refusal, node: &Node) -> Error {
        match refusal {
            Refusal::Shape(error) => {
                let span = node.locate(error.path());
                let message = without_place(&error.inner().to_string());
                let known: Vec<String> = properties.iter().map(|p| p.0.clone()).collect();
                self.shape_error(name, &span, error.path(), &message, &known, node)
            }
            Refusal::Value(error) => {
                let span = match &error {
                    Error::Parameter { name, .. } => node.get(name).map_or(node.span.clone(), |e| e.node.span.clone()),
                    _ => node.span.clone(),
                };
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
                let hint = hint.or_else(|| Some(format!("it has {}", known.join(", "))));
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

/// serde_json's message without its line and column, which are of no text that anyone sees.
fn without_place(message: &str) -> String {
    message.split(" at line ").next().unwrap_or(message).to_string()
}
