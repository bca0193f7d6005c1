//! Rivers as lines.
//!
//! # Sources
//! Moody & Troutman (2002) for the width and depth of rivers, w = 7.2 Q^0.50, d = 0.27 Q^0.39 (m,
//! m³/s). Cells are too coarse to measure the width of most rivers on the water itself.

use super::Drainage;
use crate::algo::network::reaches;
use crate::grid::{Domain, Status};
use crate::math;
use crate::terrain::NodeSurface;

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
    /// Depth at the lower end, m.
    pub depth: f64,
    /// Whether most of it lies in a lake, where width and depth are those of the river beyond.
    pub in_lake: bool,
    /// Length on the map, m.
    pub length: f64,
    /// Whether it ends at a base level rather than in another reach or in a closed depression.
    pub leaves: bool,
    /// x, y and elevation of the water, m, from the upper end down.
    pub points: Vec<[f64; 3]>,
    /// Nodes of the points.
    pub nodes: Vec<u32>,
}

/// The rivers of a terrain that drain at least `least` m², rivers in turn, reaches from the mouth
/// upwards.
pub fn rivers<T: NodeSurface>(
    terrain: &T,
    drainage: &Drainage<T::Domain>,
    least: f64,
    width: Width,
) -> Vec<RiverReach> {
    let list = reaches(&drainage.flow, &drainage.area, least);
    let status = drainage.domain.status();
    let width_of = |i: usize| width.coefficient * math::pow(drainage.discharge[i], width.exponent);
    let depth_of = |i: usize| 0.27 * math::pow(drainage.discharge[i], 0.39);
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
                depth: depth_of(last),
                in_lake: crosses_lake(terrain, drainage, &reach.nodes),
                length,
                leaves: reach.to.is_none() && status[end] == Status::BaseLevel,
                points,
                nodes: reach.nodes.clone(),
            }
        })
        .collect()
}

/// Depth of standing water over which a reach crosses a lake, m.
const LAKE: f64 = 1.0;

/// Whether most of a reach lies in a lake.
fn crosses_lake<T: NodeSurface>(terrain: &T, drainage: &Drainage<T::Domain>, nodes: &[u32]) -> bool {
    let z = terrain.elevation();
    let wet = nodes.iter().map(|&i| i as usize).filter(|&i| drainage.level[i] - z[i] > LAKE).count();
    2 * wet > nodes.len()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()
}

/// The nodes' positions at the surface of the water. A last step from above the sea to below ends
/// at the shore.
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
