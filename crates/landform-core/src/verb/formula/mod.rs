//! Formulas of the position.
//!
//! Variables: `x`, `y` (m), `u`, `v` (0 to 1, east and north), `r` (0 at the centre, 1 from the
//! nearest edge outwards), `z` (m). Constants `pi`, `e`. Operators `+ - * / ^`, comparisons (1 or
//! 0: `< <= > >= == !=`), brackets. Functions
//! `abs sqrt exp ln log10 sin cos tan floor ceil min max step clamp smoothstep lerp if`, and
//! `noise()` in about [−1, 1]: five octaves of gradient noise whose coarsest waves are an eighth of
//! the terrain wide, `noise(w)` with waves of w metres, `noise(a, b)` at any position (one unit a
//! wave).
//!
//! No crate is used: elementary functions must give the same bits on every platform, functions of
//! three arguments are needed, and errors must name the character.

mod cells;
mod functions;
mod parser;
mod words;

pub use cells::{CellCall, CellFormula, Cells};
pub use words::{CellFunction, Words};

use crate::Result;
use crate::random::Seed;
use functions::{Place, operator};
use parser::{DEEPEST, Op, parse};

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
    steps: Vec<Op>,
}

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// [`Error::Formula`](crate::Error::Formula) if the text is no formula, with the position of
    /// the wrong character.
    pub fn parse(text: &str) -> Result<Self> {
        Ok(Self { text: text.into(), steps: parse(text, None)?.steps })
    }

    /// The formula as written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Value, in the unit that goes with the formula, at a position (m) within bounds.
    pub fn at(&self, bounds: [[f64; 2]; 2], position: [f64; 2], z: f64, seed: Seed) -> f64 {
        run(&self.steps, &Place::new(bounds, position, z, seed))
    }
}

/// The value of a program without words of a stage; NaN for one that has some.
fn run(steps: &[Op], place: &Place) -> f64 {
    let mut stack = [0.0; DEEPEST * 4];
    let mut top = 0;
    for step in steps {
        match *step {
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
                stack[top - 1] = operator(op)(stack[top - 1], stack[top]);
            }
            Op::Call(function, count) => {
                top -= count;
                stack[top] = place.call(function, &stack[top..top + count]);
                top += 1;
            }
            Op::Own(_) | Op::OwnCall(_) => return f64::NAN,
        }
    }
    stack[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Error, math};

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
            ("(x == 25) + 2*(x != 25) + 4*(y != 0)", 5.0),
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
            ("1 = 1", 3, "not expected"),
            ("noise + 1", 1, "`noise` is a function"),
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
