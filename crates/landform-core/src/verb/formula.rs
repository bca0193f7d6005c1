//! Formulas of the position.
//!
//! Variables: `x`, `y` (m), `u`, `v` (0 to 1, east and north), `r` (0 at the centre, 1 from the
//! nearest edge outwards), `z` (m). Constants `pi`, `e`. Operators `+ - * / ^`, comparisons (1 or
//! 0), brackets. Functions
//! `abs sqrt exp ln log10 sin cos tan floor ceil min max step clamp smoothstep lerp if`, and
//! `noise()` in about [−1, 1]: five octaves of gradient noise whose coarsest waves are an eighth of
//! the terrain wide, `noise(w)` with waves of w metres, `noise(a, b)` at any position (one unit a
//! wave).
//!
//! No crate is used: elementary functions must give the same bits on every platform, functions of
//! three arguments are needed, and errors must name the character.

use super::super::algo::noise::fbm;
use crate::random::Seed;
use crate::{Error, Result, math};

/// A formula, read and ready.
///
/// ```
/// use landform_core::random::Seed;
/// use landform_core::verb::Formula;
///
/// let cone = Formula::parse("max(0, 100 * (1 - r))")?;
/// let bounds = [[0.0, 0.0], [200.0, 200.0]];
/// assert_eq!(cone.at(bounds, [100.0, 100.0], 0.0, Seed(0)), 100.0);
/// assert_eq!(cone.at(bounds, [150.0, 100.0], 0.0, Seed(0)), 50.0);
/// assert!(Formula::parse("max(0").is_err());
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    text: String,
    program: Vec<Op>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Op {
    Number(f64),
    Variable(usize),
    Negate,
    Binary(char),
    Call(usize, usize),
}

const VARIABLES: [&str; 6] = ["x", "y", "u", "v", "r", "z"];
const DEEPEST: usize = 64;

/// Name, fewest and most arguments.
const FUNCTIONS: &[(&str, usize, usize)] = &[
    ("abs", 1, 1),
    ("sqrt", 1, 1),
    ("exp", 1, 1),
    ("ln", 1, 1),
    ("log10", 1, 1),
    ("sin", 1, 1),
    ("cos", 1, 1),
    ("tan", 1, 1),
    ("floor", 1, 1),
    ("ceil", 1, 1),
    ("min", 2, 2),
    ("max", 2, 2),
    ("step", 2, 2),
    ("clamp", 3, 3),
    ("smoothstep", 3, 3),
    ("lerp", 3, 3),
    ("if", 3, 3),
    ("noise", 0, 2),
];

struct Place {
    variables: [f64; 6],
    size: f64,
    seed: Seed,
}

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// [`Error::Formula`] if the text is no formula, with the position of the wrong character.
    pub fn parse(text: &str) -> Result<Self> {
        let mut parser = Parser { text: text.chars().collect(), at: 0, depth: 0, program: Vec::new() };
        let result = parser.expression(0).and_then(|()| match parser.peek() {
            None => Ok(()),
            Some(c) => Err(format!("`{c}` was not expected here")),
        });
        match result {
            Ok(()) => Ok(Self { text: text.into(), program: parser.program }),
            Err(why) => Err(Error::Formula { formula: text.into(), at: parser.at + 1, why }),
        }
    }

    /// The formula as written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Value, in the unit that goes with the formula, at a position (m) within bounds.
    pub fn at(&self, [lo, hi]: [[f64; 2]; 2], [x, y]: [f64; 2], z: f64, seed: Seed) -> f64 {
        let (w, h) = (hi[0] - lo[0], hi[1] - lo[1]);
        let unit = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.5 };
        let from_centre = math::hypot(x - 0.5 * (lo[0] + hi[0]), y - 0.5 * (lo[1] + hi[1]));
        let shorter = if w > 0.0 && h > 0.0 { w.min(h) } else { w.max(h) };
        let r = unit(from_centre, 0.5 * shorter).min(1.0);
        let variables = [x, y, unit(x - lo[0], w), unit(y - lo[1], h), r, z];
        self.run(&Place { variables, size: w.max(h), seed })
    }

    fn run(&self, place: &Place) -> f64 {
        let mut stack = [0.0; DEEPEST * 4];
        let mut top = 0;
        for op in &self.program {
            match *op {
                Op::Number(v) => {
                    stack[top] = v;
                    top += 1;
                }
                Op::Variable(k) => {
                    stack[top] = place.variables[k];
                    top += 1;
                }
                Op::Negate => stack[top - 1] = -stack[top - 1],
                Op::Binary(op) => {
                    top -= 1;
                    stack[top - 1] = binary(op, stack[top - 1], stack[top]);
                }
                Op::Call(function, count) => {
                    top -= count;
                    stack[top] = call(FUNCTIONS[function].0, &stack[top..top + count], place);
                    top += 1;
                }
            }
        }
        stack[0]
    }
}

fn binary(op: char, a: f64, b: f64) -> f64 {
    match op {
        '+' => a + b,
        '-' => a - b,
        '*' => a * b,
        '/' => a / b,
        '^' => math::pow(a, b),
        '<' => f64::from(u8::from(a < b)),
        '>' => f64::from(u8::from(a > b)),
        '{' => f64::from(u8::from(a <= b)),
        _ => f64::from(u8::from(a >= b)),
    }
}

fn call(name: &str, a: &[f64], place: &Place) -> f64 {
    let [x, y, ..] = place.variables;
    let noise = |x: f64, y: f64| fbm(place.seed.named("formula"), x, y, 5, 2.0, 0.5);
    match (name, a) {
        ("abs", [v]) => v.abs(),
        ("sqrt", [v]) => v.sqrt(),
        ("exp", [v]) => math::exp(*v),
        ("ln", [v]) => math::log(*v),
        ("log10", [v]) => math::log10(*v),
        ("sin", [v]) => math::sin(*v),
        ("cos", [v]) => math::cos(*v),
        ("tan", [v]) => math::tan(*v),
        ("floor", [v]) => math::floor(*v),
        ("ceil", [v]) => math::ceil(*v),
        ("min", [v, w]) => v.min(*w),
        ("max", [v, w]) => v.max(*w),
        ("step", [edge, v]) => f64::from(u8::from(v >= edge)),
        ("clamp", [v, lo, hi]) => v.max(*lo).min(*hi),
        ("smoothstep", [e0, e1, v]) => math::smoothstep(*e0, *e1, *v),
        ("lerp", [v, w, t]) => math::lerp(*v, *w, *t),
        ("if", [c, v, w]) => {
            if *c != 0.0 {
                *v
            } else {
                *w
            }
        }
        ("noise", []) => noise(8.0 * x / place.size, 8.0 * y / place.size),
        ("noise", [wave]) => noise(x / wave, y / wave),
        ("noise", [v, w]) => noise(*v, *w),
        _ => f64::NAN,
    }
}

struct Parser {
    text: Vec<char>,
    at: usize,
    depth: usize,
    program: Vec<Op>,
}

impl Parser {
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
            self.program.push(Op::Binary(op));
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
                self.program.push(Op::Negate);
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
        self.program.push(Op::Number(value));
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
            _ => None,
        };
        if let Some(value) = constant {
            self.program.push(Op::Number(value));
        } else if let Some(k) = VARIABLES.iter().position(|v| *v == name) {
            self.program.push(Op::Variable(k));
        } else {
            self.at = start;
            return Err(format!("`{name}` is not known; variables are {}", VARIABLES.join(", ")));
        }
        Ok(())
    }

    fn call(&mut self, name: &str, start: usize) -> Result<(), String> {
        let Some(k) = FUNCTIONS.iter().position(|f| f.0 == name) else {
            self.at = start;
            let near = crate::error::nearest(name, FUNCTIONS.iter().map(|f| f.0));
            let hint = near.map(|n| format!("; did you mean `{n}`?")).unwrap_or_default();
            return Err(format!("function `{name}` is not known{hint}"));
        };
        self.at += 1;
        let mut count = 0;
        if self.peek() != Some(')') {
            loop {
                self.expression(0)?;
                count += 1;
                if self.peek() != Some(',') {
                    break;
                }
                self.at += 1;
            }
        }
        self.close()?;
        let (_, fewest, most) = FUNCTIONS[k];
        if count < fewest || count > most {
            self.at = start;
            let expected = if fewest == most { fewest.to_string() } else { format!("{fewest} to {most}") };
            return Err(format!("`{name}` takes {expected} values, not {count}"));
        }
        self.program.push(Op::Call(k, count));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        Formula::parse(text).unwrap().at([[0.0, 0.0], [100.0, 200.0]], [25.0, 150.0], 7.0, Seed(1))
    }

    #[test]
    fn formulas_mean_what_mathematics_means() {
        for (text, expected) in [
            ("1 + 2*3", 7.0),
            ("(1 + 2)*3", 9.0),
            ("2^3^2", 512.0),
            ("-2^2", -4.0),
            ("2^-1", 0.5),
            ("8/4/2", 1.0),
            ("5 - 3 - 1", 1.0),
            ("1e-3*1E3", 1.0),
            ("u", 0.25),
            ("v", 0.75),
            ("z*2", 14.0),
            ("max(x, y)", 150.0),
            ("clamp(9, 0, 1)", 1.0),
            ("smoothstep(0, 1, 0.5)", 0.5),
            ("if(x > 20, 3, 4)", 3.0),
            ("step(30, x) + (y >= 150)", 1.0),
            ("lerp(1, 3, 0.5)", 2.0),
            ("ln(e)", 1.0),
        ] {
            assert!((value(text) - expected).abs() < 1e-12, "{text} = {}", value(text));
        }
        assert!((value("r") - math::hypot(25.0, 50.0) / 50.0).abs() < 1e-12 || value("r") == 1.0);
        assert!(value("noise()").abs() < 1.0 && value("noise(30)") != value("noise(31)"));
    }

    #[test]
    fn wrong_formulas_name_the_character() {
        for (text, at, why) in [
            ("", 1, "missing at the end"),
            ("1 +", 4, "missing at the end"),
            ("(1", 3, "closing bracket"),
            ("1 2", 3, "not expected"),
            ("q + 1", 1, "`q` is not known"),
            ("smothstep(0,1,x)", 1, "did you mean `smoothstep`?"),
            ("min(1)", 1, "takes 2 values, not 1"),
            ("1..2", 5, "not a number"),
            ("$", 1, "not expected"),
        ] {
            match Formula::parse(text).unwrap_err() {
                Error::Formula { at: found, why: found_why, .. } => {
                    assert_eq!(found, at, "{text}");
                    assert!(found_why.contains(why), "{text}: {found_why}");
                }
                other => panic!("{other}"),
            }
        }
        assert!(Formula::parse(&"(".repeat(100_000)).is_err());
        assert!(Formula::parse(&format!("{}1{}", "(".repeat(50), ")".repeat(50))).is_ok());
    }
}
