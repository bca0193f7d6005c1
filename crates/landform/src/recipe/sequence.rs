//! The stages of a recipe, in order.

use std::collections::BTreeMap;
use std::ops::Range;

use landform_core::error::nearest;
use landform_core::random::Seed;
use landform_core::terrain::Kind;
use landform_core::{Error, Result};

use super::entry::{Entry, EntryReader};
use super::paths::plain;
use super::stages::{stage, stages as known_stages};
use super::tree::Node;

/// Labels that have another meaning.
const RESERVED: [&str; 3] = ["environment", "materials", "grid"];
/// Mistakes that are shown at once.
const MOST_MISTAKES: usize = 20;

/// Reads all stages; returns the mistakes of all of them.
pub(super) fn read_stages(reader: &EntryReader, stages: Vec<Node>, seed: u64) -> Result<Vec<Entry>> {
    let mut sequence = Sequence { reader, seed, entries: Vec::new(), kinds: BTreeMap::new(), kind: None };
    let mut counts = BTreeMap::new();
    let mut mistakes = Vec::new();
    for mut node in stages {
        let found = sequence.add(&mut node, &mut counts);
        if let Err(mistake) = found {
            mistakes.push(mistake.error);
            // Stages after an unknown one cannot be checked.
            let Some(kind) = mistake.kind else { break };
            sequence.kind = kind;
        }
        if mistakes.len() == MOST_MISTAKES {
            break;
        }
    }
    if mistakes.is_empty() {
        check_paths(&sequence.entries)?;
        return Ok(sequence.entries);
    }
    Err(Error::several(mistakes))
}

/// A mistake in a stage, and the kind of terrain after the stage, if it is known.
struct Mistake {
    error: Error,
    kind: Option<Option<Kind>>,
}

impl From<Error> for Mistake {
    fn from(error: Error) -> Self {
        Self { error, kind: None }
    }
}

/// Stages that were read.
struct Sequence<'a> {
    reader: &'a EntryReader<'a>,
    seed: u64,
    entries: Vec<Entry>,
    /// Kinds of labelled terrains.
    kinds: BTreeMap<String, Option<Kind>>,
    /// Kind of the terrain after the last stage.
    kind: Option<Kind>,
}

impl Sequence<'_> {
    fn add(&mut self, node: &mut Node, counts: &mut BTreeMap<String, usize>) -> Result<(), Mistake> {
        let (reader, span) = (self.reader, node.span.clone());
        let lines = node.lines(reader.text);
        let Some((name, name_span)) = reader.take_text(node, "use")? else {
            let hint = Some("say which stage it is: use = \"...\"".into());
            return Err(reader.error(&span, "this stage has no `use`", hint).into());
        };
        let count = counts.entry(name.clone()).or_default();
        *count += 1;
        let count = *count;
        let label = reader.take_text(node, "label")?;
        let from = reader.take_text(node, "from")?;
        let with = reader.take_texts(node, "with")?;
        let kind = match &from {
            Some(from) => self.kind_of(from)?,
            None => self.kind,
        };
        // Where a stage is wrong but known, those after it can still be read.
        let after = match stage(&name) {
            Some(stage) => stage.act_on(kind).map(|act| act.to.or(kind)),
            None => (name == super::entry::EVOLVE).then_some(kind),
        };
        let known = |error| Mistake { error, kind: after };
        with.iter().try_for_each(|label| self.kind_of(label).map(drop)).map_err(known)?;
        if let Some((label, span)) = &label {
            if self.kinds.insert(label.clone(), after.flatten()).is_some() {
                return Err(known(reader.error(span, format!("the label `{label}` is given twice"), None)));
            }
            if RESERVED.contains(&label.as_str()) {
                let hint = Some("give it another name".into());
                return Err(known(reader.error(span, format!("`{label}` is a word of recipes and no label"), hint)));
            }
        }
        let work = reader.work(&name, &name_span, node, kind).map_err(known)?;
        if let Some((_, span)) = with.first()
            && !work.parts().iter().any(|part| part.stage().with)
        {
            let takers =
                known_stages().filter(|s| s.with).map(|s| format!("`{}`", s.name)).collect::<Vec<_>>().join(", ");
            let hint = Some(format!("these do: {takers}"));
            return Err(known(reader.error(span, format!("`{name}` takes no other landscape (`with`)"), hint)));
        }
        let to = work.parts().last().and_then(|part| part.stage().act_on(kind)).and_then(|act| act.to);
        self.kind = to.or(kind);
        let identity = label.as_ref().map_or_else(|| format!("{name}#{count}"), |l| l.0.clone());
        self.entries.push(Entry {
            seed: Seed(self.seed).named(&identity),
            label: label.map(|l| l.0),
            from: from.map(|f| f.0),
            with: with.into_iter().map(|w| w.0).collect(),
            kind: self.kind,
            lines,
            name,
            work,
        });
        Ok(())
    }

    /// The kind of a labelled terrain.
    fn kind_of(&self, (label, span): &(String, Range<usize>)) -> Result<Option<Kind>> {
        self.kinds.get(label).copied().ok_or_else(|| {
            let hint = nearest(label, self.kinds.keys().map(String::as_str)).map(|n| format!("did you mean `{n}`?"));
            self.reader.error(span, format!("no stage before this one has the label `{label}`"), hint)
        })
    }
}

/// Two stages that write one file would leave only the second.
fn check_paths(entries: &[Entry]) -> Result<()> {
    let mut seen = BTreeMap::new();
    for (k, entry) in entries.iter().enumerate() {
        for path in entry.work.outputs() {
            if let Some(first) = seen.insert(plain(&path), k + 1) {
                let what = match first == k + 1 {
                    true => format!("stage {first} writes `{path}` twice"),
                    false => format!("stages {first} and {} both write `{path}`", k + 1),
                };
                return Err(Error::Recipe { at: None, what, hint: Some("give one of them another `path`".into()) });
            }
        }
    }
    entries.iter().enumerate().try_for_each(|(k, entry)| check_frames(k + 1, entry, entries))
}

/// Nor may a stage write a file that may be a numbered frame of another.
fn check_frames(number: usize, entry: &Entry, entries: &[Entry]) -> Result<()> {
    let Some(watch) = entry.work.watch() else { return Ok(()) };
    let first = watch.frame(1);
    for (k, other) in entries.iter().enumerate() {
        let same = |path: &String| Some(path) != first.as_ref() && watch.is_frame(path);
        if let Some(path) = other.work.outputs().into_iter().find(same) {
            let what = format!("stage {} writes `{path}`, which is a name of the `frames` of stage {number}", k + 1);
            return Err(Error::Recipe { at: None, what, hint: Some("give one of them another name".into()) });
        }
    }
    Ok(())
}
