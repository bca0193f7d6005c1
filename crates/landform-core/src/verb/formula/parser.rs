//! Reads the text of a formula.

use super::functions::{FUNCTIONS, VARIABLES};
use super::words::Words;
use crate::error::nearest;
use crate::{Error, Result};

/// A step of a program, which works on a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Op {
    Number(f64),
    Variable(usize),
    Negate,
    Binary(char),
    Call(usize, usize),
    /// A variable of the stage.
    Own(usize),
    /// A function of the stage.
    OwnCall(OwnCall),
}

/// A call of a function of the stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OwnCall {
    pub(super) function: usize,
    /// Which call of the formula it is.
    pub(super) call: usize,
    /// Places of its expressions in [`Program::expressions`].
    pub(super) expressions: [usize; 2],
    /// How many expressions it has.
    pub(super) count: usize,
    /// How many numbers it takes off the stack.
    pub(super) numbers: usize,
}

/// A formula as steps.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Program {
    pub(super) steps: Vec<Op>,
    /// Expressions that functions of the stage read at other cells; each uses earlier ones alone.
    pub(super) expressions: Vec<Vec<Op>>,
}

/// How deeply brackets may be nested.
pub(super) const DEEPEST: usize = 64;

const NO_WORDS: Words<'static> =
    Words { variables: &[], constants: &std::collections::BTreeMap::new(), functions: &[] };

/// Reads a formula in which a stage's words may stand, where it has any.
///
/// # Errors
/// [`Error::Formula`] if the text is no formula, with the position of the
/// wrong character.
pub(super) fn parse(text: &str, words: Option<Words>) -> Result<Program> {
    let words = words.unwrap_or(NO_WORDS);
    let mut parser =
        Parser { text: text.chars().collect(), words, at: 0, depth: 0, calls: 0, program: Program::default() };
    let result = parser.expression(0).and_then(|()| match parser.peek() {
        None => Ok(()),
        Some(c) => Err(format!("`{c}` was not expected here")),
    });
    match result {
        Ok(()) => Ok(parser.program),
        Err(why) => Err(Error::Formula { formula: text.into(), at: parser.at + 1, why }),
    }
}

struct Parser<'a> {
    text: Vec<char>,
    words: Words<'a>,
    at: usize,
    depth: usize,
    /// How often functions of the stage were called.
    calls: usize,
    program: Program,
}

impl Parser<'_> {
    fn peek(&mut self) -> Option<char> {
        while self.text.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    /// The operator here, its binding power and its length.
    fn operator(&mut self) -> Option<(char, u8, usize)> {
        let c = self.peek()?;
        let equal = self.text.get(self.at + 1) == Some(&'=');
        Some(match c {
            '=' | '!' if equal => (c, 1, 2),
            '<' if equal => ('{', 1, 2),
            '>' if equal => ('}', 1, 2),
            '<' | '>' => (c, 1, 1),
            '+' | '-' => (c, 2, 1),
            '*' | '/' => (c, 3, 1),
            '^' => (c, 5, 1),
            _ => return None,
        })
    }

    fn expression(&mut self, least: u8) -> Result<(), String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err("too many brackets".into());
        }
        self.operand()?;
        while let Some((op, power, length)) = self.operator() {
            if power < least.max(1) {
                break;
            }
            self.at += length;
            // Powers bind to the right: 2^3^2 is 2^9.
            self.expression(if op == '^' { power } else { power + 1 })?;
            self.program.steps.push(Op::Binary(op));
        }
        self.depth -= 1;
        Ok(())
    }

    fn operand(&mut self) -> Result<(), String> {
        match self.peek() {
            None => Err("something is missing at the end".into()),
            Some('-') => {
                self.at += 1;
                self.expression(4)?;
                self.program.steps.push(Op::Negate);
                Ok(())
            }
            Some('+') => {
                self.at += 1;
                self.expression(4)
            }
            Some('(') => {
                self.at += 1;
                self.expression(0)?;
                self.close()
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.name(),
            Some(c) => Err(format!("`{c}` was not expected here")),
        }
    }

    fn close(&mut self) -> Result<(), String> {
        if self.peek() == Some(')') {
            self.at += 1;
            Ok(())
        } else {
            Err("a closing bracket is missing".into())
        }
    }

    fn number(&mut self) -> Result<(), String> {
        let start = self.at;
        while let Some(&c) = self.text.get(self.at) {
            let after_e = self.at > start && matches!(self.text[self.at - 1], 'e' | 'E');
            let is_exponent = matches!(c, 'e' | 'E')
                && self.text.get(self.at + 1).is_some_and(|d| d.is_ascii_digit() || matches!(d, '+' | '-'));
            if !(c.is_ascii_digit() || c == '.' || is_exponent || (after_e && matches!(c, '+' | '-'))) {
                break;
            }
            self.at += 1;
        }
        let text: String = self.text[start..self.at].iter().collect();
        let value = text.parse().map_err(|_| format!("`{text}` is not a number"))?;
        self.program.steps.push(Op::Number(value));
        Ok(())
    }

    fn name(&mut self) -> Result<(), String> {
        let start = self.at;
        while self.text.get(self.at).is_some_and(|c| c.is_alphanumeric() || *c == '_') {
            self.at += 1;
        }
        let name: String = self.text[start..self.at].iter().collect();
        if self.peek() == Some('(') {
            return self.call(&name, start);
        }
        let constant = match name.as_str() {
            "pi" => Some(std::f64::consts::PI),
            "e" => Some(std::f64::consts::E),
            own => self.words.constants.get(own).copied(),
        };
        let step = if let Some(k) = self.words.variables.iter().position(|v| *v == name) {
            Op::Own(k)
        } else if let Some(value) = constant {
            Op::Number(value)
        } else if let Some(k) = VARIABLES.iter().position(|v| *v == name) {
            Op::Variable(k)
        } else {
            self.at = start;
            return Err(self.unknown(&name));
        };
        self.program.steps.push(step);
        Ok(())
    }

    /// What is said of a word that is no variable.
    fn unknown(&self, name: &str) -> String {
        if self.functions().any(|f| f == name) {
            return format!("`{name}` is a function; expected brackets after it");
        }
        let own = self.words.variables.iter().chain(self.words.constants.keys()).map(String::as_str);
        let all: Vec<&str> = own.chain(VARIABLES.into_iter().filter(|v| !self.words.is_variable(v))).collect();
        let near = nearest(name, all.iter().copied()).filter(|_| name.chars().count() > 2);
        let near = near.map(|n| format!(" (did you mean `{n}`?)")).unwrap_or_default();
        format!("`{name}` is not known{near}; variables are {}", all.join(", "))
    }

    /// Names of functions, the stage's first.
    fn functions(&self) -> impl Iterator<Item = &'static str> {
        self.words.functions.iter().map(|f| f.name).chain(FUNCTIONS.iter().map(|f| f.0))
    }

    fn call(&mut self, name: &str, start: usize) -> Result<(), String> {
        if let Some(k) = self.words.functions.iter().position(|f| f.name == name) {
            return self.own_call(k, start);
        }
        let Some(k) = FUNCTIONS.iter().position(|f| f.0 == name) else {
            self.at = start;
            let near = nearest(name, self.functions()).map(|n| format!("; did you mean `{n}`?"));
            return Err(format!("function `{name}` is not known{}", near.unwrap_or_default()));
        };
        let count = self.values(|parser, _| parser.expression(0))?;
        self.count(name, FUNCTIONS[k].1.counts(), count, start)?;
        self.program.steps.push(Op::Call(k, count));
        Ok(())
    }

    fn own_call(&mut self, function: usize, start: usize) -> Result<(), String> {
        let called = self.words.functions[function];
        let mut expressions = [0; 2];
        let most = called.expressions[1].min(expressions.len());
        let count = self.values(|parser, k| {
            if k >= most {
                return parser.expression(0);
            }
            let around = std::mem::take(&mut parser.program.steps);
            let read = parser.expression(0);
            let own = std::mem::replace(&mut parser.program.steps, around);
            let all = &mut parser.program.expressions;
            expressions[k] = all.iter().position(|e| *e == own).unwrap_or(all.len());
            if expressions[k] == all.len() {
                all.push(own);
            }
            read
        })?;
        self.count(called.name, called.counts(), count, start)?;
        let call =
            OwnCall { function, call: self.calls, expressions, count: count - called.numbers, numbers: called.numbers };
        self.calls += 1;
        self.program.steps.push(Op::OwnCall(call));
        Ok(())
    }

    /// Reads what stands in brackets; `read` is given the place of each value. Returns how many
    /// there are.
    fn values(&mut self, mut read: impl FnMut(&mut Self, usize) -> Result<(), String>) -> Result<usize, String> {
        self.at += 1;
        let mut count = 0;
        if self.peek() != Some(')') {
            loop {
                read(self, count)?;
                count += 1;
                if self.peek() != Some(',') {
                    break;
                }
                self.at += 1;
            }
        }
        self.close()?;
        Ok(count)
    }

    fn count(&mut self, name: &str, [fewest, most]: [usize; 2], count: usize, start: usize) -> Result<(), String> {
        if count >= fewest && count <= most {
            return Ok(());
        }
        self.at = start;
        let expected = if fewest == most { fewest.to_string() } else { format!("{fewest} to {most}") };
        Err(format!("`{name}` takes {expected} values, not {count}"))
    }
}
