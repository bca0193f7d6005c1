//! Parts of a raster.

use super::coarsen::{pick, thinned};
use super::{HeightField, NodeSurface};
use crate::Result;
use crate::grid::{Frame, Grid, Status};

impl HeightField {
    /// The part of this raster that a grid made by [`Grid::window`] of its own grid covers:
    /// elevation, layers and fields. Receivers and features are left, since they name what may lie
    /// outside.
    ///
    /// # Errors
    /// [`Error::Empty`](crate::Error::Empty) if the part has no data.
    pub fn window(&self, part: &Grid) -> Result<Self> {
        let of = |grid: &Grid| grid.frame.map_or([0, 0], |Frame { first, .. }| first);
        let [row, col] = [0, 1].map(|k| of(part)[k].saturating_sub(of(self.grid())[k]));
        let shape = self.grid().shape;
        let kept: Vec<u32> = (0..part.len())
            .map(|i| {
                let cell = part.shape.cell(i);
                shape.index((row + cell.row).min(shape.rows - 1), (col + cell.col).min(shape.cols - 1)) as u32
            })
            .collect();
        let z = kept.iter().map(|&i| self.elevation()[i as usize]).collect();
        let mut field = Self::new(part.clone(), z)?;
        if let Some(status) = self.chosen_status() {
            let status: Vec<Status> = kept.iter().map(|&i| status[i as usize]).collect();
            field.set_status(Some(status));
        }
        field.set_layers(self.layers().map(|l| thinned(l, &kept)));
        field.fields = pick(&self.fields, &kept);
        Ok(field)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Values;
    use crate::grid::Shape;

    #[test]
    fn a_window_has_what_the_whole_has_there() {
        let grid = Grid::new(Shape::new(6, 7), [10.0, 10.0]).unwrap();
        let mut whole = HeightField::new(grid.clone(), (0..42).map(f64::from).collect()).unwrap();
        whole.fields.insert_values("number", Values::U32((0..42).collect())).unwrap();
        let part = whole.window(&grid.window([1, 2], [3, 5]).unwrap()).unwrap();
        assert_eq!(part.elevation()[..5], [9.0, 10.0, 11.0, 12.0, 16.0]);
        assert_eq!(part.fields.find("number").unwrap().to_f64(), part.elevation());
        assert_eq!(part.position(0), whole.position(9));
        assert_eq!(part.whole_bounds(), whole.bounds());
        let smaller = part.window(&part.grid().window([1, 1], [2, 2]).unwrap()).unwrap();
        assert_eq!(smaller.elevation(), [17.0, 18.0, 24.0, 25.0]);
    }
}
