//! Basins as polygons.
//!
//! # Sources
//! Strahler (1952) for the hypsometric integral, (mean − least)/(greatest − least) elevation (Pike
//! & Wilson 1971).

use super::{Drainage, Polygon, polygon};
use crate::algo::outline::{label_regions, outlines};
use crate::grid::{Domain, Status};
use crate::terrain::{HeightField, NodeSurface};

/// Ground that drains through one outlet.
#[derive(Clone, Debug, PartialEq)]
pub struct Basin {
    /// Area, m².
    pub area: f64,
    /// Position of the outlet, m.
    pub outlet: [f64; 2],
    /// Least, mean and greatest elevation, m.
    pub elevation: [f64; 3],
    /// Ratio (mean − least)/(greatest − least).
    pub hypsometric_integral: f64,
    /// Outline; a basin whose parts touch at corners only has several polygons.
    pub outline: Vec<Polygon>,
}

/// The basins of a raster that cover at least `least_area` (m²), the largest first. **Cost**
/// O(cells).
pub fn basins<D: Domain>(field: &HeightField, drainage: &Drainage<D>, least_area: f64) -> Vec<Basin> {
    let z = field.elevation();
    let status = drainage.domain.status();
    let of = drainage.flow.basins(status);
    let count = of.iter().copied().max().unwrap_or(0) as usize;
    // Cells at sea are outlets, not ground.
    let ground = |i: usize| status[i] != Status::Masked && drainage.flow.receivers()[i] as usize != i;
    let mut basins = vec![None; count];
    let cell = field.grid().cell_area();
    for i in (0..z.len()).filter(|&i| ground(i)) {
        let basin = basins[of[i] as usize - 1].get_or_insert_with(|| Basin {
            area: 0.0,
            outlet: [0.0; 2],
            elevation: [f64::INFINITY, 0.0, f64::NEG_INFINITY],
            hypsometric_integral: 0.0,
            outline: Vec::new(),
        });
        basin.area += cell;
        basin.elevation =
            [basin.elevation[0].min(z[i]), basin.elevation[1] + z[i] * cell, basin.elevation[2].max(z[i])];
        let r = drainage.flow.receivers()[i] as usize;
        if drainage.flow.receivers()[r] as usize == r {
            basin.outlet = field.grid().position(r);
        }
    }
    let large =
        |i: usize| ground(i) && basins[of[i] as usize - 1].as_ref().is_some_and(|b: &Basin| b.area >= least_area);
    let label = label_regions(field.grid().shape, large, |i, j| of[i] == of[j]);
    let rings = outlines(field.grid().shape, &label);
    let mut first = vec![usize::MAX; rings.len()];
    for i in (0..label.len()).rev().filter(|&i| label[i] != 0) {
        first[label[i] as usize - 1] = i;
    }
    for (rings, &i) in rings.iter().zip(&first) {
        if let Some(basin) = &mut basins[of[i] as usize - 1] {
            basin.outline.push(polygon(field.grid(), rings));
        }
    }
    let mut basins: Vec<Basin> = basins.into_iter().flatten().filter(|b| b.area >= least_area).collect();
    for basin in &mut basins {
        let [least, sum, greatest] = basin.elevation;
        let mean = sum / basin.area;
        basin.elevation[1] = mean;
        basin.hypsometric_integral = if greatest > least { (mean - least) / (greatest - least) } else { 0.0 };
    }
    basins.sort_by(|a, b| b.area.total_cmp(&a.area));
    basins
}
