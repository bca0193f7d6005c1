//! Rivers, lakes and basins with their properties.

mod basins;
mod lakes;
mod rivers;

use std::sync::Arc;

pub use basins::{Basin, basins};
pub use lakes::{Lake, lakes};
pub use rivers::{RiverReach, Width, rivers};

use crate::algo::flow::{Flow, node_areas};
use crate::algo::outlets::{at_or_under, fill_inland_water, open_holes};
use crate::algo::outline::Ring;
use crate::field::names;
use crate::grid::{Domain, Grid, Status};
use crate::parallel;
use crate::terrain::{NodeSurface, sea_level as terrain_sea_level};

/// The drainage of a terrain, from which rivers, lakes and basins are read.
#[derive(Clone, Debug)]
pub struct Drainage<D> {
    /// The graph, with the outlets that were used.
    pub domain: Arc<D>,
    /// Receivers and order.
    pub flow: Flow,
    /// Drainage area, m²; 0 where there is no data.
    pub area: Vec<f64>,
    /// Discharge, m³/s: what was supplied upstream; evaporation and sinkholes are not taken off.
    pub discharge: Vec<f64>,
    /// Surface of the water, m.
    pub level: Vec<f64>,
    /// Level of the sea, m, if there is one.
    pub sea_level: Option<f64>,
    /// Depth of water as a process left it, m, if one did; depressions need not be full then.
    pub known_depth: Option<Vec<f64>>,
}

impl<D: Domain> Drainage<D> {
    /// Routes flow over a terrain. Rivers end at the terrain's outlets, or at `sea_level` if given;
    /// `rainfall` (m/s) holds where the terrain has no field of it. Where a process left the
    /// discharge of every node, each node drains to the lower neighbour through which most water
    /// runs. Lakes are crossed on their surface, along the middle. Area and discharge are summed
    /// over the same tree, so that a river has all water of its width; its springs are in the field
    /// of what was supplied. **Cost** O(n).
    pub fn of<T: NodeSurface<Domain = D>>(terrain: &T, sea_level: Option<f64>, rainfall: f64) -> Self {
        let mut domain = terrain.domain();
        if let Some(level) = sea_level {
            Arc::make_mut(&mut domain).set_status(at_or_under(level, terrain));
        }
        Self::over(terrain, domain, sea_level, rainfall)
    }

    /// As [`Drainage::of`], for measures of ground: what drains into nodata inside has left, as it
    /// has at the border.
    pub fn with_open_holes<T: NodeSurface<Domain = D>>(terrain: &T) -> Self {
        let mut domain = terrain.domain();
        let mut status = domain.status().to_vec();
        if status.contains(&Status::Masked) {
            open_holes(&*domain, &mut status);
            Arc::make_mut(&mut domain).set_status(status);
        }
        Self::over(terrain, domain, None, 0.0)
    }

    fn over<T: NodeSurface<Domain = D>>(terrain: &T, domain: Arc<D>, sea_level: Option<f64>, rainfall: f64) -> Self {
        let mut flow = Flow::new();
        let mut area = node_areas(&*domain);
        let field = |key| terrain.fields().get(key, "rivers").ok();
        let mut discharge: Vec<f64> = match field(&names::WATER_SUPPLY).or_else(|| field(&names::RAINFALL)) {
            Some(rain) => parallel::map(area.len(), |i| if area[i] > 0.0 { area[i] * rain[i] } else { 0.0 }),
            None => parallel::map(area.len(), |i| area[i] * rainfall),
        };
        let z = terrain.elevation();
        flow.route(&*domain, z, &mut area);
        let mut level = flow.water_level(z);
        let known = field(&names::DISCHARGE);
        if known.is_some() || parallel::find_first(z.len(), |i| level[i] > z[i]).is_some() {
            // Rivers cross lakes on their surface, not along the floor.
            area = node_areas(&*domain);
            match known {
                Some(known) => flow.route_by(&*domain, &level, &mut area, |i| {
                    let lower = domain.neighbours(i).filter(|l| level[l.to] < level[i]);
                    lower.reduce(|a, b| if known[b.to] > known[a.to] { b } else { a }).map(|l| (l.to, l.slot))
                }),
                None => flow.route(&*domain, &level, &mut area),
            }
        }
        for &i in flow.order() {
            let (i, r) = (i as usize, flow.receivers()[i as usize] as usize);
            if r != i {
                discharge[r] += discharge[i];
            }
        }
        let sea_level = sea_level.or_else(|| terrain_sea_level(domain.status(), terrain.elevation()));
        if let Some(sea) = sea_level {
            fill_inland_water(terrain, &*domain, sea, &mut level);
        }
        let known_depth = terrain.fields().get(&names::WATER_DEPTH, "rivers").ok().map(<[f64]>::to_vec);
        Self { domain, flow, area, discharge, level, sea_level, known_depth }
    }
}

pub use crate::feature::Polygon;

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
mod tests;
