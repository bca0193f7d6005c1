//! Lakes as polygons.

use super::{Drainage, Polygon, polygon};
use crate::algo::outline::{label_regions, outlines};
use crate::grid::Domain;
use crate::terrain::{HeightField, NodeSurface};

/// Standing water.
#[derive(Clone, Debug, PartialEq)]
pub struct Lake {
    /// Elevation of its surface, m.
    pub level: f64,
    /// Greatest depth, m.
    pub depth: f64,
    /// Area, m².
    pub area: f64,
    /// Volume, m³.
    pub volume: f64,
    /// Position of its outlet, m; none for water at sea level.
    pub outlet: Option<[f64; 2]>,
    /// Discharge through it, m³/s.
    pub discharge: f64,
    /// Shore.
    pub shore: Polygon,
}

/// Water whose surface differs by less from node to node is one lake, m.
const LEVEL: f64 = 1e-6;
/// Known water no deeper than this is a film that runs, m.
const SHALLOW: f64 = 0.01;

/// The lakes of a raster that are somewhere deeper than `least_depth` (m) and cover at least
/// `least_area` (m²), the largest first. **Cost** O(cells).
///
/// ```
/// use landform_core::analysis::{Drainage, lakes};
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
///
/// let grid = Grid::new(Shape::new(3, 3), [10.0, 10.0])?;
/// let hollow = HeightField::new(grid, vec![5.0, 5.0, 5.0, 5.0, 1.0, 3.0, 5.0, 5.0, 5.0])?;
/// let found = lakes(&hollow, &Drainage::of(&hollow, None, 0.0), 0.0, 0.0);
/// assert_eq!((found.len(), found[0].level, found[0].volume), (1, 3.0, 200.0));
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn lakes<D: Domain>(field: &HeightField, drainage: &Drainage<D>, least_depth: f64, least_area: f64) -> Vec<Lake> {
    let z = field.elevation();
    let known: Option<Vec<f64>> =
        drainage.known_depth.as_ref().map(|depth| depth.iter().zip(z).map(|(d, z)| z + d).collect());
    let level = known.as_ref().unwrap_or(&drainage.level);
    // Surfaces that a process left are level but for rounding; those of rivers slope.
    let shallow = if known.is_some() { SHALLOW } else { 0.0 };
    let even = if known.is_some() { LEVEL } else { 0.0 };
    let label =
        label_regions(field.grid().shape, |i| level[i] > z[i] + shallow, |i, j| (level[i] - level[j]).abs() <= even);
    let rings = outlines(field.grid().shape, &label);
    let cell = field.grid().cell_area();
    let empty =
        Lake { level: f64::NAN, depth: 0.0, area: 0.0, volume: 0.0, outlet: None, discharge: 0.0, shore: Vec::new() };
    let mut lakes = vec![empty; rings.len()];
    for i in (0..z.len()).filter(|&i| label[i] != 0) {
        let lake = &mut lakes[label[i] as usize - 1];
        let depth = level[i] - z[i];
        lake.level = level[i];
        lake.depth = lake.depth.max(depth);
        lake.area += cell;
        lake.volume += depth * cell;
        let r = drainage.flow.receivers()[i] as usize;
        if r == i {
            lake.discharge += drainage.discharge[i];
        } else if label[r] != label[i] && level[i] >= drainage.level[i] - LEVEL {
            lake.outlet = Some(field.grid().position(r));
            lake.discharge = drainage.discharge[i];
        }
    }
    for (lake, rings) in lakes.iter_mut().zip(&rings) {
        lake.shore = polygon(field.grid(), rings);
    }
    lakes.retain(|l| l.depth >= least_depth && l.area >= least_area);
    lakes.sort_by(|a, b| b.area.total_cmp(&a.area));
    lakes
}
