//! The greatest elevation over blocks of cells: lets a ray leap over what it cannot hit.

use landform_core::grid::Shape;
use landform_core::parallel;

/// Level 0 holds the greatest corner of each cell (a square of four nodes); each further level
/// halves rows and columns.
pub(super) struct Pyramid {
    pub(super) levels: Vec<(Shape, Vec<f32>)>,
}

impl Pyramid {
    pub(super) fn new(shape: Shape, z: &[f64]) -> Self {
        let cells = Shape::new((shape.rows - 1).max(1), (shape.cols - 1).max(1));
        let base = parallel::map(cells.len(), |i| {
            let cell = cells.cell(i);
            let at = |r: usize, c: usize| {
                z[shape.index((cell.row + r).min(shape.rows - 1), (cell.col + c).min(shape.cols - 1))]
            };
            // Rounding to f32 must not lower the bound.
            (at(0, 0).max(at(0, 1)).max(at(1, 0)).max(at(1, 1)) as f32).next_up()
        });
        let mut levels = vec![(cells, base)];
        while let Some((below, values)) = levels.last().filter(|(s, _)| s.rows > 1 || s.cols > 1) {
            let above = Shape::new(below.rows.div_ceil(2), below.cols.div_ceil(2));
            let greatest = (0..above.len()).map(|i| {
                let cell = above.cell(i);
                let at = |r: usize, c: usize| {
                    let (r, c) = ((2 * cell.row + r).min(below.rows - 1), (2 * cell.col + c).min(below.cols - 1));
                    values[below.index(r, c)]
                };
                at(0, 0).max(at(0, 1)).max(at(1, 0)).max(at(1, 1))
            });
            let greatest = greatest.collect();
            levels.push((above, greatest));
        }
        Self { levels }
    }
}
