//! Rivers, lakes and basins as things with properties.
//!
//! # Sources
//! Moody & Troutman (2002) for the width of rivers, w = 7.2 Q^0.5 (m, m³/s); Strahler (1952) for the hypsometric integral of a
//! basin, (mean − least)/(greatest − least) elevation (Pike & Wilson 1971).

use std::sync::Arc;

use crate::algo::flow::{Flow, node_areas};
use crate::algo::network::reaches;
use crate::algo::outlets::{at_or_under, fill_inland_water};
use crate::algo::outline::{Ring, label_regions, outlines};
use crate::field::names;
use crate::grid::{BASE_LEVEL, Domain, Grid, MASKED};
use crate::terrain::{HeightField, NodeSurface, sea_level as terrain_sea_level};
use crate::{math, parallel};

/// Where water goes on a terrain: what rivers, lakes and basins are read from.
#[derive(Clone, Debug)]
pub struct Drainage<D> {
    /// The graph, with the outlets that were used.
    pub domain: Arc<D>,
    /// Receivers and order.
    pub flow: Flow,
    /// Drainage area, m²; 0 where there is no data.
    pub area: Vec<f64>,
    /// Discharge, m³/s.
    pub discharge: Vec<f64>,
    /// Surface of the water, m.
    pub level: Vec<f64>,
    /// Level of the sea, m, if there is one.
    pub sea_level: Option<f64>,
}

impl<D: Domain> Drainage<D> {
    /// Routes flow over a terrain. Rivers end at the terrain's outlets, or at `sea_level` if given; `rainfall` (m/s) holds
    /// where the terrain has no field of it. **Cost** O(n).
    pub fn of<T: NodeSurface<Domain = D>>(terrain: &T, sea_level: Option<f64>, rainfall: f64) -> Self {
        let mut domain = terrain.domain();
        if let Some(level) = sea_level {
            Arc::make_mut(&mut domain).set_status(at_or_under(level, terrain));
        }
        let mut flow = Flow::new();
        let mut area = node_areas(&*domain);
        let mut discharge: Vec<f64> = match terrain.fields().get(&names::RAINFALL, "rivers") {
            Ok(rain) => parallel::map(area.len(), |i| if area[i] > 0.0 { area[i] * rain[i] } else { 0.0 }),
            Err(_) => parallel::map(area.len(), |i| area[i] * rainfall),
        };
        flow.route(&*domain, terrain.elevation(), &mut area);
        for &i in flow.order() {
            let (i, r) = (i as usize, flow.receivers()[i as usize] as usize);
            if r != i {
                discharge[r] += discharge[i];
            }
        }
        let mut level = flow.water_level(terrain.elevation());
        let sea_level = sea_level.or_else(|| terrain_sea_level(domain.status(), terrain.elevation()));
        if let Some(sea) = sea_level {
            fill_inland_water(terrain, &*domain, sea, &mut level);
        }
        Self { domain, flow, area, discharge, level, sea_level }
    }
}

/// Width of a river from its discharge: `coefficient` · Q^`exponent`, in m and m³/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Width {
    /// Width at 1 m³/s, m.
    pub coefficient: f64,
    /// Exponent.
    pub exponent: f64,
}

impl Default for Width {
    fn default() -> Self {
        Self { coefficient: 7.2, exponent: 0.5 }
    }
}

/// A reach of a river: a line that only runs downhill (level across lakes).
#[derive(Clone, Debug, PartialEq)]
pub struct RiverReach {
    /// Number of the river, from 1, the greatest drainage area at its end first.
    pub river: u32,
    /// Number of the reach in its river, from 1 at the mouth.
    pub reach: u32,
    /// River and reach that it flows into.
    pub to: Option<(u32, u32)>,
    /// Strahler's order.
    pub order: u32,
    /// Drainage area at the lower end, m².
    pub area: f64,
    /// Discharge at the lower end, m³/s.
    pub discharge: f64,
    /// Width at the lower end, m.
    pub width: f64,
    /// Width at the upper end, m.
    pub width_above: f64,
    /// Length on the map, m.
    pub length: f64,
    /// Whether it ends at a base level rather than in another reach or in a closed hollow.
    pub leaves: bool,
    /// x, y and elevation of the water, m, from the upper end down.
    pub points: Vec<[f64; 3]>,
    /// Nodes of the points.
    pub nodes: Vec<u32>,
}

/// The rivers of a terrain that drain at least `least` m², rivers in turn, reaches from the mouth upwards.
pub fn rivers<T: NodeSurface>(
    terrain: &T,
    drainage: &Drainage<T::Domain>,
    least: f64,
    width: Width,
) -> Vec<RiverReach> {
    let list = reaches(&drainage.flow, &drainage.area, least);
    let status = drainage.domain.status();
    let width_of = |i: usize| width.coefficient * math::pow(drainage.discharge[i], width.exponent);
    let name = |k: usize| (list[k].river, list[k].number);
    list.iter()
        .map(|reach| {
            let (first, last) = (reach.nodes[0] as usize, reach.last_own());
            let end = reach.nodes[reach.nodes.len() - 1] as usize;
            let points = points(terrain, drainage, &reach.nodes);
            let length = points.windows(2).map(|p| distance(p[0], p[1])).sum();
            RiverReach {
                river: reach.river,
                reach: reach.number,
                to: reach.to.map(name),
                order: reach.order,
                area: drainage.area[last],
                discharge: drainage.discharge[last],
                width: width_of(last),
                width_above: width_of(first),
                length,
                leaves: reach.to.is_none() && status[end] == BASE_LEVEL,
                points,
                nodes: reach.nodes.clone(),
            }
        })
        .collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()
}

/// The nodes' positions at the surface of the water. A last step from above the sea to below ends at the shore.
fn points<T: NodeSurface>(terrain: &T, drainage: &Drainage<T::Domain>, nodes: &[u32]) -> Vec<[f64; 3]> {
    let at = |i: u32| {
        let [x, y] = terrain.position(i as usize);
        [x, y, drainage.level[i as usize]]
    };
    let mut points: Vec<_> = nodes.iter().map(|&i| at(i)).collect();
    if let ([.., above, below], Some(sea)) = (&points[..], drainage.sea_level)
        && above[2] > sea
        && below[2] < sea
    {
        let part = (above[2] - sea) / (above[2] - below[2]);
        let last = [math::lerp(above[0], below[0], part), math::lerp(above[1], below[1], part), sea];
        let end = points.len() - 1;
        points[end] = last;
    }
    points
}

/// Part of the ground, as polygons in map coordinates: rings of (x, y), the outer one first.
pub type Polygon = Vec<Vec<[f64; 2]>>;

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
    /// Where it overflows, m; nowhere for water at the level of the sea.
    pub outlet: Option<[f64; 2]>,
    /// Discharge through it, m³/s.
    pub discharge: f64,
    /// Shore.
    pub shore: Polygon,
}

/// The lakes of a raster that are somewhere deeper than `least_depth` (m) and cover at least `least_area` (m²), the largest
/// first. **Cost** O(cells).
pub fn lakes<D: Domain>(field: &HeightField, drainage: &Drainage<D>, least_depth: f64, least_area: f64) -> Vec<Lake> {
    let z = field.elevation();
    let level = &drainage.level;
    let label = label_regions(field.grid.shape, |i| level[i] > z[i], |i, j| level[i] == level[j]);
    let rings = outlines(field.grid.shape, &label);
    let cell = field.grid.cell_area();
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
        } else if label[r] != label[i] {
            lake.outlet = Some(field.grid.position(r));
            lake.discharge = drainage.discharge[i];
        }
    }
    for (lake, rings) in lakes.iter_mut().zip(&rings) {
        lake.shore = polygon(&field.grid, rings);
    }
    lakes.retain(|l| l.depth >= least_depth && l.area >= least_area);
    lakes.sort_by(|a, b| b.area.total_cmp(&a.area));
    lakes
}

/// Ground that drains through one outlet.
#[derive(Clone, Debug, PartialEq)]
pub struct Basin {
    /// Area, m².
    pub area: f64,
    /// Position of the outlet, m.
    pub outlet: [f64; 2],
    /// Least, mean and greatest elevation, m.
    pub elevation: [f64; 3],
    /// (mean − least)/(greatest − least).
    pub hypsometric_integral: f64,
    /// Outline; a basin whose parts touch at corners only has several polygons.
    pub outline: Vec<Polygon>,
}

/// The basins of a raster that cover at least `least_area` (m²), the largest first. **Cost** O(cells).
pub fn basins<D: Domain>(field: &HeightField, drainage: &Drainage<D>, least_area: f64) -> Vec<Basin> {
    let z = field.elevation();
    let status = drainage.domain.status();
    let of = drainage.flow.basins(status);
    let count = of.iter().copied().max().unwrap_or(0) as usize;
    // Cells at sea are outlets, not ground.
    let ground = |i: usize| status[i] != MASKED && drainage.flow.receivers()[i] as usize != i;
    let mut basins = vec![None; count];
    let cell = field.grid.cell_area();
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
            basin.outlet = field.grid.position(r);
        }
    }
    let large =
        |i: usize| ground(i) && basins[of[i] as usize - 1].as_ref().is_some_and(|b: &Basin| b.area >= least_area);
    let label = label_regions(field.grid.shape, large, |i, j| of[i] == of[j]);
    let rings = outlines(field.grid.shape, &label);
    let mut first = vec![usize::MAX; rings.len()];
    for i in (0..label.len()).rev().filter(|&i| label[i] != 0) {
        first[label[i] as usize - 1] = i;
    }
    for (rings, &i) in rings.iter().zip(&first) {
        if let Some(basin) = &mut basins[of[i] as usize - 1] {
            basin.outline.push(polygon(&field.grid, rings));
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

/// Rings of corners in map coordinates; nodes are the middles of cells.
fn polygon(grid: &Grid, rings: &[Ring]) -> Polygon {
    let corner = |[c, r]: [u32; 2]| {
        [
            grid.origin[0] + (f64::from(c) - 0.5) * grid.spacing[0],
            grid.origin[1] - (f64::from(r) - 0.5) * grid.spacing[1],
        ]
    };
    rings.iter().map(|ring| ring.iter().map(|&c| corner(c)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Edges, Shape};
    use crate::random::Seed;

    fn field() -> HeightField {
        let shape = Shape::new(60, 70);
        let grid = Grid { edges: Edges::default(), ..Grid::new(shape, [50.0, 50.0]).unwrap() };
        let z = (0..shape.len()).map(|i| {
            let cell = shape.cell(i);
            let tilt = 3.0 * (cell.row as f64 - 20.0).abs();
            tilt + 20.0 * Seed(6).uniform(i as u64) + 12.0 * math::sin(cell.col as f64 * 0.4) - 10.0
        });
        HeightField::new(grid, z.collect()).unwrap()
    }

    #[test]
    fn rivers_only_run_downhill_and_end_at_the_sea() {
        let field = field();
        let drainage = Drainage::of(&field, Some(0.0), 1.0 / crate::units::YEAR);
        let list = rivers(&field, &drainage, 15.0 * 2500.0, Width::default());
        assert!(list.len() > 10 && list.iter().any(|r| r.order > 1), "{}", list.len());
        for r in &list {
            assert!(r.points.windows(2).all(|p| p[1][2] <= p[0][2]), "{r:?}");
            assert!(r.width >= r.width_above && r.length > 0.0);
            let expected = r.area / crate::units::YEAR;
            assert!((r.discharge / expected - 1.0).abs() < 1e-9);
            if let Some(to) = r.to {
                let below = list.iter().find(|b| (b.river, b.reach) == to).unwrap();
                assert_eq!(below.points[0], r.points[r.points.len() - 1]);
            } else {
                assert!(r.leaves && (r.points[r.points.len() - 1][2] == 0.0 || r.points[0][2] < 0.0));
            }
        }
    }

    #[test]
    fn lakes_are_flat_and_their_volumes_sum() {
        let field = field();
        let drainage = Drainage::of(&field, None, 0.0);
        let list = lakes(&field, &drainage, 0.0, 0.0);
        let volume: f64 = (0..field.grid.len()).map(|i| (drainage.level[i] - field.elevation()[i]) * 2500.0).sum();
        let total: f64 = list.iter().map(|l| l.volume).sum();
        assert!(list.len() > 5 && (total / volume - 1.0).abs() < 1e-9);
        assert!(list.windows(2).all(|l| l[0].area >= l[1].area) && list.iter().all(|l| l.depth > 0.0));
        let some = lakes(&field, &drainage, 2.0, 4.0 * 2500.0);
        assert!(!some.is_empty() && some.len() < list.len());
    }

    #[test]
    fn basins_cover_the_ground() {
        let field = field();
        let drainage = Drainage::of(&field, None, 0.0);
        let list = basins(&field, &drainage, 0.0);
        let inner = 58 * 68;
        let total: f64 = list.iter().map(|b| b.area).sum();
        assert!((total - inner as f64 * 2500.0).abs() < 1e-3);
        assert!(list.iter().all(|b| !b.outline.is_empty() && (0.0..=1.0).contains(&b.hypsometric_integral)));
    }
}
