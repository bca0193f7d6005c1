//! TOML with positions: every key and value has its place in the text.

use std::ops::Range;

use landform_core::{Error, Result};
use serde_json::Value as Json;
use serde_path_to_error::{Path, Segment};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and where it stands in the text (0..0 for what was set from outside).
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) span: Range<usize>,
    pub(super) value: Value,
}

#[derive(Clone, Debug)]
pub(super) enum Value {
    Leaf(Json),
    Array(Vec<Node>),
    Table(Vec<Entry>),
}

/// A key, where it stands, and its value.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) span: Range<usize>,
    pub(super) node: Node,
}

impl Node {
    /// Lines of the text, from 1, of a table under "" and of its keys.
    pub(super) fn lines(&self, text: &str) -> Vec<(String, usize)> {
        let entries = match &self.value {
            Value::Table(entries) => entries.as_slice(),
            _ => &[],
        };
        let own = std::iter::once((String::new(), &self.span));
        let all = own.chain(entries.iter().map(|e| (e.key.clone(), &e.span)));
        all.filter(|(_, span)| !span.is_empty()).map(|(key, span)| (key, place(text, span.start).0)).collect()
    }

    /// Reads a whole document.
    pub(super) fn parse(text: &str) -> Result<Self> {
        let document = DeTable::parse(text).map_err(|e| {
            let at = e.span().map(|s| place(text, s.start));
            Error::Recipe { at, what: e.message().trim().replace('\n', "; "), hint: None }
        })?;
        let span = document.span();
        table(text, document.into_inner(), span)
    }

    /// Reads a single value, as in `--set key=value`; what is not TOML is taken as text.
    pub(super) fn parse_value(text: &str) -> Result<Self> {
        let document = format!("value = {text}");
        match DeTable::parse(&document) {
            Ok(parsed) => {
                let mut node = table(&document, parsed.into_inner(), 0..0)?;
                node.forget_places();
                Ok(node.remove("value").map_or_else(|| Self::text(text), |e| e.node))
            }
            Err(_) => Ok(Self::text(text)),
        }
    }

    fn text(text: &str) -> Self {
        Self { span: 0..0, value: Value::Leaf(Json::String(text.into())) }
    }

    fn forget_places(&mut self) {
        self.span = 0..0;
        match &mut self.value {
            Value::Leaf(_) => {}
            Value::Array(items) => items.iter_mut().for_each(Self::forget_places),
            Value::Table(entries) => entries.iter_mut().for_each(|e| {
                e.span = 0..0;
                e.node.forget_places();
            }),
        }
    }

    pub(super) fn entries(&self) -> &[Entry] {
        if let Value::Table(entries) = &self.value { entries } else { &[] }
    }

    pub(super) fn get(&self, key: &str) -> Option<&Entry> {
        self.entries().iter().find(|e| e.key == key)
    }

    pub(super) fn remove(&mut self, key: &str) -> Option<Entry> {
        let Value::Table(entries) = &mut self.value else { return None };
        let at = entries.iter().position(|e| e.key == key)?;
        Some(entries.remove(at))
    }

    /// Where the value at a path of keys stands (`grid.cell_size`, `effects[0].rules`), or as much
    /// of the path as there is.
    pub(super) fn span_at(&self, path: &str) -> Range<usize> {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        let (key, item) = first.strip_suffix(']').and_then(|f| f.split_once('[')).unwrap_or((first, ""));
        let Some(entry) = self.get(key) else { return self.span.clone() };
        let node = match (&entry.node.value, item.parse::<usize>()) {
            (Value::Array(items), Ok(k)) => items.get(k).unwrap_or(&entry.node),
            _ => &entry.node,
        };
        if rest.is_empty() || node.entries().is_empty() { node.span.clone() } else { node.span_at(rest) }
    }

    /// Whether a key is there, descending along a path.
    pub(super) fn has(&self, path: &[&str]) -> bool {
        match path {
            [] => true,
            [key, rest @ ..] => self.get(key).is_some_and(|e| e.node.has(rest)),
        }
    }

    /// Sets a key of a table, descending along dots; tables on the way are made.
    pub(super) fn set(&mut self, path: &[&str], node: Self) -> bool {
        let Value::Table(entries) = &mut self.value else { return false };
        let [key, rest @ ..] = path else { return false };
        let at = entries.iter().position(|e| e.key == *key).unwrap_or_else(|| {
            let empty = Self { span: 0..0, value: Value::Table(Vec::new()) };
            entries.push(Entry { key: (*key).into(), span: 0..0, node: empty });
            entries.len() - 1
        });
        if rest.is_empty() {
            entries[at].node = node;
            return true;
        }
        entries[at].node.set(rest, node)
    }

    /// As JSON, without places.
    pub(super) fn json(&self) -> Json {
        match &self.value {
            Value::Leaf(leaf) => leaf.clone(),
            Value::Array(items) => Json::Array(items.iter().map(Self::json).collect()),
            Value::Table(entries) => Json::Object(entries.iter().map(|e| (e.key.clone(), e.node.json())).collect()),
        }
    }

    /// Where the thing at a path stands: the key, if the last step is a key.
    pub(super) fn locate(&self, path: &Path) -> Range<usize> {
        let (mut node, mut span) = (self, self.span.clone());
        for segment in path {
            match segment {
                Segment::Map { key } => {
                    let Some(entry) = node.get(key) else { break };
                    span = if entry.node.span.is_empty() { entry.span.clone() } else { entry.node.span.clone() };
                    node = &entry.node;
                }
                Segment::Seq { index } => {
                    let Value::Array(items) = &node.value else { break };
                    let Some(item) = items.get(*index) else { break };
                    span = item.span.clone();
                    node = item;
                }
                _ => {}
            }
        }
        span
    }
}

/// Line and column, from 1, of a byte.
pub(super) fn place(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(byte.min(text.len()))];
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

fn table(text: &str, table: DeTable, span: Range<usize>) -> Result<Node> {
    let mut entries = Vec::new();
    for (key, item) in table {
        entries.push(Entry { key: key.get_ref().to_string(), span: key.span(), node: convert(text, item)? });
    }
    // The parser sorts keys; people read them in the order of the text.
    entries.sort_by_key(|e| e.span.start);
    Ok(Node { span, value: Value::Table(entries) })
}

fn convert(text: &str, item: Spanned<DeValue>) -> Result<Node> {
    let span = item.span();
    let fail = |what: &str| Err(Error::Recipe { at: Some(place(text, span.start)), what: what.into(), hint: None });
    let leaf = match item.into_inner() {
        DeValue::String(s) => Json::String(s.into_owned()),
        DeValue::Boolean(b) => Json::Bool(b),
        DeValue::Integer(i) => match i64::from_str_radix(i.as_str(), i.radix()) {
            Ok(v) => v.into(),
            Err(_) => return fail("this number is too large"),
        },
        DeValue::Float(f) => match f.as_str().parse::<f64>().ok().and_then(serde_json::Number::from_f64) {
            Some(v) => Json::Number(v),
            None => return fail("this number is not finite"),
        },
        DeValue::Datetime(_) => return fail("a date is not expected anywhere; put it in quotes if it is text"),
        DeValue::Array(items) => {
            let items = items.into_iter().map(|i| convert(text, i)).collect::<Result<_>>()?;
            return Ok(Node { span, value: Value::Array(items) });
        }
        DeValue::Table(inner) => return table(text, inner, span),
    };
    Ok(Node { span, value: Value::Leaf(leaf) })
}
