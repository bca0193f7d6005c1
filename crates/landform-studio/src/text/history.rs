//! Texts that were and can come back.

use std::collections::VecDeque;
use std::sync::Arc;

/// Bytes of texts that are kept to go back to.
const MOST_BYTES: usize = 64 << 20;
/// How many are kept.
const MOST: usize = 5_000;

/// A text with those before it and those that were taken back.
#[derive(Clone, Debug)]
pub(crate) struct History {
    now: Arc<str>,
    before: VecDeque<Arc<str>>,
    after: Vec<Arc<str>>,
    bytes: usize,
    /// What the last change was of, while it goes on.
    going_on: Option<String>,
}

impl History {
    pub(crate) fn of(text: &str) -> Self {
        Self { now: text.into(), before: VecDeque::new(), after: Vec::new(), bytes: 0, going_on: None }
    }

    /// The text as it is.
    pub(crate) fn now(&self) -> &Arc<str> {
        &self.now
    }

    /// Takes a new text. While one and the same thing goes on changing, that is one change.
    pub(crate) fn take(&mut self, text: String, going_on: Option<String>) {
        if *text == *self.now {
            // A row that begins with no change begins with the first one.
            self.going_on = self.going_on.take().filter(|old| Some(old) == going_on.as_ref());
            return;
        }
        let same = going_on.is_some() && going_on == self.going_on;
        self.going_on = going_on;
        self.after.clear();
        let old = std::mem::replace(&mut self.now, text.into());
        if same {
            return;
        }
        self.bytes += old.len();
        self.before.push_back(old);
        while self.bytes > MOST_BYTES || self.before.len() > MOST {
            let Some(oldest) = self.before.pop_front() else { break };
            self.bytes -= oldest.len();
        }
    }

    /// The last change of a going-on row has come: the next is one of its own.
    pub(crate) fn settle(&mut self) {
        self.going_on = None;
    }

    /// Goes back by a change; whether there was one.
    pub(crate) fn undo(&mut self) -> bool {
        self.going_on = None;
        let Some(old) = self.before.pop_back() else { return false };
        self.bytes -= old.len();
        self.after.push(std::mem::replace(&mut self.now, old));
        true
    }

    /// Goes on to what was taken back; whether there was something.
    pub(crate) fn redo(&mut self) -> bool {
        self.going_on = None;
        let Some(next) = self.after.pop() else { return false };
        let old = std::mem::replace(&mut self.now, next);
        self.bytes += old.len();
        self.before.push_back(old);
        true
    }

    pub(crate) fn can_undo(&self) -> bool {
        !self.before.is_empty()
    }

    pub(crate) fn can_redo(&self) -> bool {
        !self.after.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drag_is_one_change() {
        let mut history = History::of("0");
        for text in ["1", "2", "3"] {
            history.take(text.into(), Some("rate".into()));
        }
        history.settle();
        history.take("4".into(), Some("rate".into()));
        assert!(history.undo());
        assert_eq!(&**history.now(), "3");
        assert!(history.undo() && !history.undo());
        assert_eq!(&**history.now(), "0");
        assert!(history.redo() && history.redo() && !history.redo());
        assert_eq!(&**history.now(), "4");
    }
}
