//! Formulas with words of a stage's own, for all cells of a raster at once.

use std::borrow::Cow;

use super::functions::{FUNCTIONS, Kernel, Place, operator};
use super::parser::{Op, OwnCall, Program, parse};
use super::run;
use super::words::Words;
use crate::grid::Grid;
use crate::random::Seed;
use crate::{Result, parallel};

/// A formula with words of a stage's own, evaluated for all cells of a raster at once.
///
/// Each step of it works on a row of values, so that which step it is, is asked once a row. An
/// expression that a function reads at other cells is evaluated for all cells before.
///
/// ```
/// use std::collections::BTreeMap;
/// use landform_core::verb::{CellFormula, Words};
///
/// let constants = BTreeMap::from([("half".to_string(), 0.5)]);
/// let words = Words { variables: &["sand".into()], constants: &constants, functions: &[] };
/// assert_eq!(CellFormula::parse("3 * half", words)?.constant(), Some(1.5));
/// assert_eq!(CellFormula::parse("sand * half", words)?.constant(), None);
/// assert!(CellFormula::parse("snad * half", words).unwrap_err().to_string().contains("`sand`"));
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CellFormula {
    program: Program,
}

/// What a stage's words mean on a raster.
///
/// ```
/// use std::collections::BTreeMap;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::random::Seed;
/// use landform_core::verb::{CellCall, CellFormula, Cells, Words};
///
/// struct Sand(Grid, Vec<f64>);
///
/// impl Cells for Sand {
///     fn grid(&self) -> &Grid {
///         &self.0
///     }
///     fn seed(&self) -> Seed {
///         Seed(1)
///     }
///     fn plane(&self, _: usize) -> Option<&[f64]> {
///         Some(&self.1)
///     }
///     fn variable(&self, _: usize, row: usize, out: &mut [f64]) {
///         out.copy_from_slice(&self.1[2 * row..2 * row + 2]);
///     }
///     fn call(&self, _: CellCall, _: usize, _: &mut [f64]) {}
/// }
///
/// let words = Words { variables: &["sand".into()], constants: &BTreeMap::new(), functions: &[] };
/// let sand = Sand(Grid::new(Shape::new(1, 2), [10.0; 2])?, vec![3.0, 5.0]);
/// let mut twice = [0.0; 2];
/// CellFormula::parse("2*sand", words)?.write(&sand, &mut twice);
/// assert_eq!(twice, [6.0, 10.0]);
/// # Ok::<(), landform_core::Error>(())
/// ```
pub trait Cells: Sync {
    /// The raster.
    fn grid(&self) -> &Grid;

    /// Seed of noise.
    fn seed(&self) -> Seed;

    /// The values of a variable at all cells, row-major, where they are kept so.
    fn plane(&self, variable: usize) -> Option<&[f64]>;

    /// Writes the values of a variable along a row.
    fn variable(&self, variable: usize, row: usize, out: &mut [f64]);

    /// Writes the values of a function along a row.
    fn call(&self, call: CellCall<'_>, row: usize, out: &mut [f64]);
}

/// A call of a function of a stage.
///
/// ```
/// use landform_core::verb::CellCall;
///
/// let values = [1.0, 2.0];
/// let call = CellCall { function: 0, call: 0, expressions: &[&values], numbers: &[vec![0.5, 0.5]] };
/// assert_eq!(call.expressions[0][1] * call.numbers[0][1], 1.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CellCall<'a> {
    /// Its place in [`Words::functions`].
    pub function: usize,
    /// Which call of the formula it is, from 0.
    pub call: usize,
    /// Its expressions: values at all cells, row-major, in their own units.
    pub expressions: &'a [&'a [f64]],
    /// Its numbers: values along the row, in their own units.
    pub numbers: &'a [Vec<f64>],
}

impl CellFormula {
    /// Reads a formula.
    ///
    /// # Errors
    /// [`crate::Error::Formula`] if the text is no formula, with the position of the wrong
    /// character.
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use landform_core::verb::{CellFormula, Words};
    ///
    /// let words = Words { variables: &["sand".into()], constants: &BTreeMap::new(), functions: &[] };
    /// assert!(CellFormula::parse("max(0, sand - 1)", words).is_ok());
    /// assert!(CellFormula::parse("max(0, sand", words).is_err());
    /// ```
    pub fn parse(text: &str, words: Words) -> Result<Self> {
        Ok(Self { program: parse(text, Some(words))? })
    }

    /// Whether a variable of the stage is used, by its place in [`Words::variables`].
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use landform_core::verb::{CellFormula, Words};
    ///
    /// let words = Words { variables: &["sand".into()], constants: &BTreeMap::new(), functions: &[] };
    /// assert!(CellFormula::parse("2*sand", words)?.uses(0));
    /// assert!(!CellFormula::parse("2*x", words)?.uses(0));
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn uses(&self, variable: usize) -> bool {
        let all = std::iter::once(&self.program.steps).chain(&self.program.expressions);
        all.flatten().any(|step| *step == Op::Own(variable))
    }

    /// Its value, in the unit that goes with it, where that is the same at every cell and in every
    /// run.
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use landform_core::verb::{CellFormula, Words};
    ///
    /// let words = Words { variables: &["sand".into()], constants: &BTreeMap::new(), functions: &[] };
    /// assert_eq!(CellFormula::parse("2^3", words)?.constant(), Some(8.0));
    /// assert_eq!(CellFormula::parse("noise()", words)?.constant(), None);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn constant(&self) -> Option<f64> {
        let varies = |step: &Op| match *step {
            Op::Variable(_) | Op::Own(_) | Op::OwnCall(_) => true,
            Op::Call(function, _) => matches!(FUNCTIONS[function].1, Kernel::Noise),
            Op::Number(_) | Op::Negate | Op::Binary(_) => false,
        };
        let place = Place { variables: [0.0; 6], size: 1.0, seed: Seed::default() };
        (!self.program.steps.iter().any(varies)).then(|| run(&self.program.steps, &place))
    }

    /// Writes its values at all cells, row-major, in the unit that goes with it. `out` has a value
    /// a cell.
    ///
    /// **Cost** O(cells · steps of the formula).
    ///
    /// ```
    /// # use landform_core::grid::{Grid, Shape};
    /// # use landform_core::random::Seed;
    /// # use landform_core::verb::{CellCall, CellFormula, Cells, Words};
    /// # struct Plain(Grid);
    /// # impl Cells for Plain {
    /// #     fn grid(&self) -> &Grid { &self.0 }
    /// #     fn seed(&self) -> Seed { Seed(1) }
    /// #     fn plane(&self, _: usize) -> Option<&[f64]> { None }
    /// #     fn variable(&self, _: usize, _: usize, _: &mut [f64]) {}
    /// #     fn call(&self, _: CellCall, _: usize, _: &mut [f64]) {}
    /// # }
    /// # let constants = std::collections::BTreeMap::new();
    /// # let words = Words { variables: &[], constants: &constants, functions: &[] };
    /// # let cells = Plain(Grid::new(Shape::new(1, 3), [10.0; 2])?);
    /// let mut east = [0.0; 3];
    /// CellFormula::parse("x/10", words)?.write(&cells, &mut east);
    /// assert_eq!(east, [0.0, 1.0, 2.0]);
    /// # Ok::<(), landform_core::Error>(())
    /// ```
    pub fn write(&self, cells: &dyn Cells, out: &mut [f64]) {
        let sheet = Sheet { cells, bounds: cells.grid().whole().bounds() };
        let mut planes: Vec<Cow<[f64]>> = Vec::with_capacity(self.program.expressions.len());
        for steps in &self.program.expressions {
            let kept = match steps.as_slice() {
                [Op::Own(variable)] => cells.plane(*variable),
                _ => None,
            };
            let plane = kept.map_or_else(
                || {
                    let mut values = vec![0.0; out.len()];
                    sheet.write(steps, &planes, &mut values);
                    Cow::Owned(values)
                },
                Cow::Borrowed,
            );
            planes.push(plane);
        }
        sheet.write(&self.program.steps, &planes, out);
    }
}

/// A raster on which a program runs.
struct Sheet<'a> {
    cells: &'a dyn Cells,
    bounds: [[f64; 2]; 2],
}

impl Sheet<'_> {
    fn write(&self, steps: &[Op], planes: &[Cow<[f64]>], out: &mut [f64]) {
        let cols = self.cells.grid().shape.cols;
        parallel::for_rows_mut(out, cols, |row, out| {
            let mut stack: Vec<Vec<f64>> = Vec::new();
            for step in steps {
                self.step(*step, row, planes, &mut stack, out.len());
            }
            if let Some(values) = stack.pop() {
                out.copy_from_slice(&values);
            }
        });
    }

    fn place(&self, row: usize, col: usize) -> Place {
        let grid = self.cells.grid();
        Place::new(self.bounds, [grid.x(col), grid.y(row)], 0.0, self.cells.seed())
    }

    /// One step of a program, on a row of values.
    fn step(&self, step: Op, row: usize, planes: &[Cow<[f64]>], stack: &mut Vec<Vec<f64>>, cols: usize) {
        match step {
            Op::Number(value) => stack.push(vec![value; cols]),
            Op::Variable(k) => stack.push((0..cols).map(|col| self.place(row, col).variables[k]).collect()),
            Op::Own(variable) => {
                let mut values = vec![0.0; cols];
                self.cells.variable(variable, row, &mut values);
                stack.push(values);
            }
            Op::Negate => stack.iter_mut().last().into_iter().flatten().for_each(|v| *v = -*v),
            Op::Binary(op) => {
                let (f, b) = (operator(op), stack.pop().unwrap_or_default());
                stack.iter_mut().last().into_iter().flatten().zip(b).for_each(|(a, b)| *a = f(*a, b));
            }
            Op::Call(function, count) => {
                let numbers = stack.split_off(stack.len().saturating_sub(count));
                stack.push(self.function(function, numbers, row, cols));
            }
            Op::OwnCall(OwnCall { function, call, expressions, count, numbers }) => {
                let numbers = stack.split_off(stack.len().saturating_sub(numbers));
                let read = expressions.map(|k| planes.get(k).map_or(&[][..], |plane| plane));
                let mut values = vec![0.0; cols];
                let call = CellCall { function, call, expressions: &read[..count], numbers: &numbers };
                self.cells.call(call, row, &mut values);
                stack.push(values);
            }
        }
    }

    /// A function of all formulas, along a row.
    fn function(&self, function: usize, mut numbers: Vec<Vec<f64>>, row: usize, cols: usize) -> Vec<f64> {
        match (FUNCTIONS[function].1, numbers.as_mut_slice()) {
            (Kernel::One(f), [a]) => a.iter_mut().for_each(|a| *a = f(*a)),
            (Kernel::Two(f), [a, b]) => a.iter_mut().zip(b).for_each(|(a, b)| *a = f(*a, *b)),
            (Kernel::Three(f), [a, b, c]) => {
                a.iter_mut().zip(b).zip(c).for_each(|((a, b), c)| *a = f(*a, *b, *c));
            }
            (_, numbers) => {
                let at = |col: usize| numbers.iter().map(|n| n[col]).collect::<Vec<f64>>();
                return (0..cols).map(|col| self.place(row, col).call(function, &at(col))).collect();
            }
        }
        numbers.swap_remove(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Shape;
    use crate::verb::{CellFunction, Formula};
    use std::collections::BTreeMap;

    /// One variable, and a function that tells the value a column to the east.
    struct World(Grid, Vec<f64>);

    impl Cells for World {
        fn grid(&self) -> &Grid {
            &self.0
        }
        fn seed(&self) -> Seed {
            Seed(1)
        }
        fn plane(&self, _: usize) -> Option<&[f64]> {
            Some(&self.1)
        }
        fn variable(&self, _: usize, row: usize, out: &mut [f64]) {
            out.copy_from_slice(&self.1[row * 5..row * 5 + 5]);
        }
        fn call(&self, call: CellCall<'_>, row: usize, out: &mut [f64]) {
            let east = |col: usize| call.expressions[0][row * 5 + (col + 1).min(4)];
            out.iter_mut().enumerate().for_each(|(col, out)| *out = east(col) + call.numbers[0][col]);
        }
    }

    fn values(text: &str) -> Vec<f64> {
        let world = World(Grid::new(Shape::new(3, 5), [10.0; 2]).unwrap(), (0..15).map(f64::from).collect());
        let functions = [CellFunction { name: "east", expressions: [1, 1], numbers: 1 }];
        let constants = BTreeMap::from([("two".to_string(), 2.0)]);
        let words = Words { variables: &["sand".into()], constants: &constants, functions: &functions };
        let mut out = vec![0.0; 15];
        CellFormula::parse(text, words).unwrap().write(&world, &mut out);
        out
    }

    #[test]
    fn rows_are_what_single_cells_are() {
        let grid = Grid::new(Shape::new(3, 5), [10.0; 2]).unwrap();
        for text in ["x + 2*y", "noise() + noise(30) - noise(u, v)", "if(r > 0.5, -u^2, clamp(v, 0, min(u, 0.4)))"] {
            let formula = Formula::parse(text).unwrap();
            let single: Vec<f64> = (0..15).map(|i| formula.at(grid.bounds(), grid.position(i), 0.0, Seed(1))).collect();
            assert_eq!(values(text), single, "{text}");
        }
    }

    #[test]
    fn functions_read_expressions_at_other_cells() {
        assert_eq!(values("east(sand, 0)")[..5], [1.0, 2.0, 3.0, 4.0, 4.0]);
        assert_eq!(values("east(two*sand, sand)")[..5], [2.0, 5.0, 8.0, 11.0, 12.0]);
        assert_eq!(values("east(east(sand, 0) > 3, 0)")[..5], [0.0, 0.0, 1.0, 1.0, 1.0]);
    }

    #[test]
    fn words_of_the_stage_are_told_with_the_others() {
        let constants = BTreeMap::new();
        let functions = [CellFunction { name: "east", expressions: [1, 1], numbers: 1 }];
        let words = Words { variables: &["sand".into()], constants: &constants, functions: &functions };
        for (text, why) in [
            ("snad", "`snad` is not known (did you mean `sand`?); variables are sand, x"),
            ("east", "is a function"),
            ("esat(sand, 1)", "did you mean `east`?"),
            ("east(sand)", "takes 2 values, not 1"),
        ] {
            let error = CellFormula::parse(text, words).unwrap_err().to_string();
            assert!(error.contains(why), "{text}: {error}");
        }
        let deep = format!("{}sand{}", "east(".repeat(200), ", 0)".repeat(200));
        assert!(CellFormula::parse(&deep, words).is_err());
    }
}
