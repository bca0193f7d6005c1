//! Errors with their place in the text.

use landform::Error;
use serde::Serialize;

use crate::text::{Block, blocks};

/// Something that is wrong with a text.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Mistake {
    /// Line, from 1, if it is known.
    pub(crate) line: Option<usize>,
    /// Column, from 1, if it is known.
    pub(crate) column: Option<usize>,
    pub(crate) what: String,
    pub(crate) hint: Option<String>,
    /// The step that it is about, those that are off counted too.
    pub(crate) stage: Option<usize>,
}

/// All that an error says is wrong.
pub(crate) fn mistakes(error: &Error, text: &str) -> Vec<Mistake> {
    let blocks = blocks(text);
    let mut all = Vec::new();
    collect(error, &blocks, &mut all);
    all
}

fn collect(error: &Error, blocks: &[Block], all: &mut Vec<Mistake>) {
    let hint = error.hint();
    match error {
        Error::Several(errors) => errors.iter().for_each(|error| collect(error, blocks, all)),
        Error::Stage { index, line, source, .. } => all.push(Mistake {
            line: *line,
            column: None,
            what: source.to_string(),
            hint,
            stage: on(blocks).nth(index.saturating_sub(1)),
        }),
        Error::Recipe { at, what, .. } => {
            let (line, column) = (at.map(|at| at.0), at.map(|at| at.1));
            let stage = line.and_then(|line| blocks.iter().rposition(|block| !block.off && block.line <= line));
            all.push(Mistake { line, column, what: what.clone(), hint, stage });
        }
        other => all.push(Mistake { line: None, column: None, what: other.to_string(), hint, stage: None }),
    }
}

/// Places of the steps that are on, in the list of all.
pub(crate) fn on(blocks: &[Block]) -> impl Iterator<Item = usize> + '_ {
    blocks.iter().enumerate().filter(|(_, block)| !block.off).map(|(k, _)| k)
}
