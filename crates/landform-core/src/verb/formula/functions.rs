//! The functions and operators of formulas.

use super::super::super::algo::noise::fbm;
use crate::math;
use crate::random::Seed;

/// Variables of every formula.
pub(super) const VARIABLES: [&str; 6] = ["x", "y", "u", "v", "r", "z"];

/// How a function is computed, by the number of its values.
#[derive(Clone, Copy)]
pub(super) enum Kernel {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
    Three(fn(f64, f64, f64) -> f64),
    Noise,
}

impl Kernel {
    /// Fewest and most values.
    pub(super) fn counts(self) -> [usize; 2] {
        match self {
            Self::One(_) => [1, 1],
            Self::Two(_) => [2, 2],
            Self::Three(_) => [3, 3],
            Self::Noise => [0, 2],
        }
    }
}

/// Name and kernel of every function.
pub(super) const FUNCTIONS: &[(&str, Kernel)] = &[
    ("abs", Kernel::One(f64::abs)),
    ("sqrt", Kernel::One(f64::sqrt)),
    ("exp", Kernel::One(math::exp)),
    ("ln", Kernel::One(math::log)),
    ("log10", Kernel::One(math::log10)),
    ("sin", Kernel::One(math::sin)),
    ("cos", Kernel::One(math::cos)),
    ("tan", Kernel::One(math::tan)),
    ("floor", Kernel::One(math::floor)),
    ("ceil", Kernel::One(math::ceil)),
    ("min", Kernel::Two(f64::min)),
    ("max", Kernel::Two(f64::max)),
    ("step", Kernel::Two(|edge, v| truth(v >= edge))),
    ("clamp", Kernel::Three(|v, lo, hi| v.max(lo).min(hi))),
    ("smoothstep", Kernel::Three(math::smoothstep)),
    ("lerp", Kernel::Three(math::lerp)),
    ("if", Kernel::Three(|c, v, w| if c != 0.0 { v } else { w })),
    ("noise", Kernel::Noise),
];

/// 1 for true, 0 for false.
fn truth(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// What an operator computes.
pub(super) fn operator(op: char) -> fn(f64, f64) -> f64 {
    match op {
        '+' => |a, b| a + b,
        '-' => |a, b| a - b,
        '*' => |a, b| a * b,
        '/' => |a, b| a / b,
        '^' => math::pow,
        '<' => |a, b| truth(a < b),
        '>' => |a, b| truth(a > b),
        '{' => |a, b| truth(a <= b),
        '=' => |a, b| truth(a == b),
        '!' => |a, b| truth(a != b),
        _ => |a, b| truth(a >= b),
    }
}

/// Position and seed that a formula is evaluated with.
pub(super) struct Place {
    pub(super) variables: [f64; 6],
    pub(super) size: f64,
    pub(super) seed: Seed,
}

impl Place {
    /// At a position (m) within bounds.
    pub(super) fn new([lo, hi]: [[f64; 2]; 2], [x, y]: [f64; 2], z: f64, seed: Seed) -> Self {
        let (w, h) = (hi[0] - lo[0], hi[1] - lo[1]);
        let unit = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.5 };
        let from_centre = math::hypot(x - 0.5 * (lo[0] + hi[0]), y - 0.5 * (lo[1] + hi[1]));
        let shorter = if w > 0.0 && h > 0.0 { w.min(h) } else { w.max(h) };
        let r = unit(from_centre, 0.5 * shorter).min(1.0);
        Self { variables: [x, y, unit(x - lo[0], w), unit(y - lo[1], h), r, z], size: w.max(h), seed }
    }

    fn noise(&self, values: &[f64]) -> f64 {
        let [x, y, ..] = self.variables;
        let [a, b] = match values {
            [wave] => [x / wave, y / wave],
            [a, b, ..] => [*a, *b],
            [] => [8.0 * x / self.size, 8.0 * y / self.size],
        };
        fbm(self.seed.named("formula"), a, b, 5, 2.0, 0.5)
    }

    /// The value of a function, by its number.
    pub(super) fn call(&self, function: usize, values: &[f64]) -> f64 {
        match (FUNCTIONS[function].1, values) {
            (Kernel::One(f), [a]) => f(*a),
            (Kernel::Two(f), [a, b]) => f(*a, *b),
            (Kernel::Three(f), [a, b, c]) => f(*a, *b, *c),
            (Kernel::Noise, values) => self.noise(values),
            _ => f64::NAN,
        }
    }
}
