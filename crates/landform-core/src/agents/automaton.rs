//! A rule for all cells at once: (cell, eight neighbours) → cell.

use crate::grid::Shape;
use crate::{Error, Result, parallel};

/// Input of a rule.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood<C> {
    /// The cell.
    pub cell: C,
    /// North-west, north, north-east, west, east, south-west, south, south-east.
    pub around: [C; 8],
    /// Index of the cell, for rules that draw random numbers or read maps.
    pub index: usize,
}

/// A cellular automaton on a raster, double-buffered: every cell reads its neighbours as they were
/// before the step. Rows run in parallel; the result does not depend on threads.
///
/// ```
/// use landform_core::agents::Automaton;
/// use landform_core::grid::Shape;
///
/// let mut cells = vec![false; 25];
/// cells[12] = true;
/// let mut fire = Automaton::new(Shape::new(5, 5), cells, Some(false))?;
/// fire.step(|n| n.cell || n.around.contains(&true));
/// assert_eq!(fire.cells().iter().filter(|burns| **burns).count(), 9);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Automaton<C> {
    shape: Shape,
    /// The cell beyond the sides; with none, opposite sides are joined.
    beyond: Option<C>,
    cells: Vec<C>,
    next: Vec<C>,
}

impl<C: Copy + Send + Sync> Automaton<C> {
    /// From cells, row-major. `beyond` is the neighbour of cells at the sides; with none, sides
    /// wrap around.
    ///
    /// # Errors
    /// [`Error::Shape`] if there are not as many cells as the shape has.
    pub fn new(shape: Shape, cells: Vec<C>, beyond: Option<C>) -> Result<Self> {
        if cells.len() != shape.len() || cells.is_empty() {
            return Err(Error::Shape {
                what: "cells".into(),
                found: format!("{} cells", cells.len()),
                expected: format!("{} ({shape})", shape.len()),
            });
        }
        Ok(Self { shape, beyond, next: cells.clone(), cells })
    }

    /// The cells.
    pub fn cells(&self) -> &[C] {
        &self.cells
    }

    /// The cells, to change from outside.
    pub fn cells_mut(&mut self) -> &mut [C] {
        &mut self.cells
    }

    /// Applies a rule to every cell. **Cost** O(n).
    pub fn step(&mut self, rule: impl Fn(Neighbourhood<C>) -> C + Sync) {
        let (Shape { rows, cols }, beyond, cells) = (self.shape, self.beyond, &self.cells);
        parallel::for_rows_mut(&mut self.next, cols, |r, out| {
            let row = |r: Option<usize>| r.map(|r| &cells[r * cols..(r + 1) * cols]);
            let wrap = beyond.is_none();
            let above = row(if r > 0 { Some(r - 1) } else { wrap.then(|| rows - 1) });
            let below = row(if r + 1 < rows { Some(r + 1) } else { wrap.then_some(0) });
            let here = &cells[r * cols..(r + 1) * cols];
            // Without anything beyond there is always a row and a column.
            let outside = beyond.unwrap_or(here[0]);
            let get = |row: Option<&[C]>, c: Option<usize>| row.zip(c).map_or(outside, |(row, c)| row[c]);
            for (c, cell) in out.iter_mut().enumerate() {
                let west = if c > 0 { Some(c - 1) } else { wrap.then(|| cols - 1) };
                let east = if c + 1 < cols { Some(c + 1) } else { wrap.then_some(0) };
                let (mid, here) = (Some(c), Some(here));
                let around = [
                    get(above, west),
                    get(above, mid),
                    get(above, east),
                    get(here, west),
                    get(here, east),
                    get(below, west),
                    get(below, mid),
                    get(below, east),
                ];
                *cell = rule(Neighbourhood { cell: get(here, mid), around, index: r * cols + c });
            }
        });
        std::mem::swap(&mut self.cells, &mut self.next);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn life(n: Neighbourhood<bool>) -> bool {
        let alive = n.around.iter().filter(|a| **a).count();
        alive == 3 || n.cell && alive == 2
    }

    fn world(lines: [&str; 6], beyond: Option<bool>) -> Automaton<bool> {
        let cells = lines.iter().flat_map(|l| l.chars().map(|c| c == '#')).collect();
        Automaton::new(Shape::new(6, 6), cells, beyond).unwrap()
    }

    #[test]
    fn a_glider_comes_back_around_a_torus() {
        let mut glider = world([".#....", "..#...", "###...", "......", "......", "......"], None);
        let start = glider.cells().to_vec();
        for _ in 0..24 {
            glider.step(life);
        }
        assert!(glider.cells() == start, "a glider moves one cell along the diagonal in four steps");
    }

    #[test]
    fn beyond_a_wall_nothing_lives() {
        let mut blinker = world([".#....", ".#....", ".#....", "......", "......", "......"], Some(false));
        blinker.step(life);
        assert_eq!(blinker.cells().iter().filter(|c| **c).count(), 3);
        assert!(blinker.cells()[6] && blinker.cells()[7] && blinker.cells()[8]);
        assert!(Automaton::new(Shape::new(2, 2), vec![0; 3], None).is_err());
    }
}
