//! Blocks of samples as one node.

use landform_core::grid::{Grid, Shape};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::{Error, Result, parallel};

/// The grid of blocks of `side` by `side` samples, each a node at its middle. Samples that fill no
/// block are left out.
pub(super) fn grid_of_blocks(grid: &Grid, side: usize) -> Result<Grid> {
    let shape = Shape::new(grid.shape.rows / side, grid.shape.cols / side);
    if shape.rows == 0 || shape.cols == 0 {
        let (rows, cols) = (grid.shape.rows, grid.shape.cols);
        return Err(Error::parameter("coarsen", side, &format!("at most the file's {cols} x {rows} samples")));
    }
    let [dx, dy] = grid.spacing;
    let half = 0.5 * (side as f64 - 1.0);
    let spacing = [dx * side as f64, dy * side as f64];
    let mut blocks = grid.with_spacing(spacing, shape)?;
    blocks.origin = [grid.origin[0] + half * dx, grid.origin[1] - half * dy];
    Ok(blocks)
}

/// Means of blocks of samples; nodata where more than half of a block is.
pub(super) fn blocks(source: &HeightField, side: usize) -> Result<HeightField> {
    let grid = grid_of_blocks(source.grid(), side)?;
    let (shape, z) = (source.grid().shape, source.elevation());
    let mean = |i: usize| {
        let cell = grid.shape.cell(i);
        let (mut sum, mut count) = (0.0, 0_usize);
        for row in cell.row * side..(cell.row + 1) * side {
            let first = shape.index(row, cell.col * side);
            for v in z[first..first + side].iter().filter(|v| !v.is_nan()) {
                sum += v;
                count += 1;
            }
        }
        if 2 * count >= side * side { sum / count as f64 } else { f64::NAN }
    };
    HeightField::new(grid.clone(), parallel::map(grid.len(), mean))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]
mod tests {
    use super::*;

    #[test]
    fn a_node_is_the_mean_of_its_block_and_stands_in_its_middle() {
        let mut z: Vec<f64> = (0..35).map(f64::from).collect();
        (z[2], z[4], z[5], z[11]) = (f64::NAN, f64::NAN, f64::NAN, f64::NAN);
        let source = HeightField::new(Grid::new(Shape::new(5, 7), [10.0, 10.0]).unwrap(), z).unwrap();
        let coarse = blocks(&source, 2).unwrap();
        assert_eq!((coarse.grid().shape, coarse.grid().spacing), (Shape::new(2, 3), [20.0, 20.0]));
        assert_eq!(coarse.grid().position(0), [5.0, 35.0]);
        assert_eq!(coarse.elevation()[..2], [4.0, (3.0 + 9.0 + 10.0) / 3.0]);
        assert!(coarse.elevation()[2].is_nan());
        assert!(blocks(&source, 6).unwrap_err().to_string().contains("7 x 5 samples"));
    }
}
