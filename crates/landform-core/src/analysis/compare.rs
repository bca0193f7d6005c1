//! Two rasters of the same ground: before and after.

use serde::{Deserialize, Serialize};

use crate::terrain::{HeightField, NodeSurface};
use crate::{Error, Result, parallel};

/// How B differs from A, over nodes where both have data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// Nodes where both have data.
    pub nodes: usize,
    /// Their area, m².
    pub area: f64,
    /// Root mean square of B − A, m.
    pub rmse: f64,
    /// Mean of B − A, m.
    pub mean: f64,
    /// Mean amount of B − A, m.
    pub mean_amount: f64,
    /// Greatest raise, m.
    pub greatest_raise: f64,
    /// Greatest cut, m (positive).
    pub greatest_cut: f64,
    /// Volume removed, m³.
    pub eroded: f64,
    /// Volume added, m³.
    pub deposited: f64,
    /// Volume added less volume removed, m³.
    pub net: f64,
    /// Share of nodes that did not change.
    pub unchanged: f64,
    /// Correlation of the elevations.
    pub correlation: f64,
}

/// Compares B with A and gives B − A in m (NaN where either lacks data). **Cost** O(n).
///
/// ```
/// use landform_core::analysis::compare;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
///
/// let grid = Grid::new(Shape::new(2, 2), [10.0, 10.0])?;
/// let before = HeightField::new(grid.clone(), vec![5.0, 6.0, 7.0, 8.0])?;
/// let after = HeightField::new(grid, vec![5.0, 6.0, 7.0, 6.0])?;
/// let (comparison, difference) = compare(&before, &after)?;
/// assert_eq!(comparison.eroded, 200.0);
/// assert_eq!(difference, [0.0, 0.0, 0.0, -2.0]);
/// # Ok::<(), landform_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Shape`] if the rasters do not lie node on node, [`Error::Empty`] if no node has data in
/// both.
pub fn compare(a: &HeightField, b: &HeightField) -> Result<(Comparison, Vec<f64>)> {
    let near = |k: usize| (a.grid().spacing[k] / b.grid().spacing[k] - 1.0).abs() < 1e-6;
    if a.grid().shape != b.grid().shape || !near(0) || !near(1) {
        let text = |f: &HeightField| {
            format!("{} of {:.6} x {:.6} m", f.grid().shape, f.grid().spacing[0], f.grid().spacing[1])
        };
        return Err(Error::Shape { what: "the second landscape".into(), found: text(b), expected: text(a) });
    }
    let (za, zb) = (a.elevation(), b.elevation());
    let difference: Vec<f64> = parallel::map(za.len(), |i| zb[i] - za[i]);
    let sum = |f: &(dyn Fn(usize) -> f64 + Sync)| {
        parallel::sum(za.len(), |i| if difference[i].is_nan() { 0.0 } else { f(i) })
    };
    let n = sum(&|_| 1.0);
    if n == 0.0 {
        return Err(Error::Empty { what: "what both landscapes cover".into() });
    }
    let cell = a.grid().cell_area();
    let (eroded, deposited) = (sum(&|i| (-difference[i]).max(0.0)) * cell, sum(&|i| difference[i].max(0.0)) * cell);
    let (ma, mb) = (sum(&|i| za[i]) / n, sum(&|i| zb[i]) / n);
    let product = |x: &[f64], mx: f64, y: &[f64], my: f64| {
        parallel::sum(x.len(), |i| if difference[i].is_nan() { 0.0 } else { (x[i] - mx) * (y[i] - my) })
    };
    let spread = (product(za, ma, za, ma) * product(zb, mb, zb, mb)).sqrt();
    let comparison = Comparison {
        nodes: n as usize,
        area: n * cell,
        rmse: (sum(&|i| difference[i] * difference[i]) / n).sqrt(),
        mean: sum(&|i| difference[i]) / n,
        mean_amount: sum(&|i| difference[i].abs()) / n,
        greatest_raise: parallel::max(za.len(), |i| difference[i]).max(0.0),
        greatest_cut: parallel::max(za.len(), |i| -difference[i]).max(0.0),
        eroded,
        deposited,
        net: deposited - eroded,
        unchanged: sum(&|i| f64::from(u8::from(difference[i] == 0.0))) / n,
        correlation: product(za, ma, zb, mb) / spread,
    };
    Ok((comparison, difference))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};

    #[test]
    fn volumes_are_those_of_what_was_moved() {
        let grid = Grid::new(Shape::new(10, 10), [10.0, 20.0]).unwrap();
        let before: Vec<f64> = (0..100).map(f64::from).collect();
        let mut after = before.clone();
        after[5] -= 3.0;
        after[50] += 1.0;
        after[99] = f64::NAN;
        let field = |z: &[f64]| HeightField::new(grid.clone(), z.to_vec()).unwrap();
        let (c, difference) = compare(&field(&before), &field(&after)).unwrap();
        assert_eq!((c.nodes, c.eroded, c.deposited, c.net), (99, 600.0, 200.0, -400.0));
        assert!((c.rmse - (10.0_f64 / 99.0).sqrt()).abs() < 1e-12 && difference[99].is_nan());
        assert_eq!((c.greatest_cut, c.greatest_raise), (3.0, 1.0));
        let other = Grid::new(Shape::new(10, 11), [10.0, 20.0]).unwrap();
        let other = HeightField::new(other, vec![0.0; 110]).unwrap();
        assert!(compare(&field(&before), &other).is_err());
    }
}
