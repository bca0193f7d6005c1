//! Protection instead of shadows (Pytel 2015, 4.1.2).
//!
//! A site protects the cone downwind of it: sand that is deposited there adds to the protection of
//! every site of the cone, and sand that is eroded reduces it. A site is sheltered while its
//! protection is positive. Lines of sight are not computed; shadows emerge.
//!
//! The thesis does not give the protection at the start. Here every site protects by the sand that
//! it holds above the mean depth, so that sand which was there before counts as deposited sand.

use landform_core::agents::{Connectivity, Falloff, RasterSites, Stencil};
use landform_core::grid::{Edge, Edges, Grid};
use landform_core::verb::Rose;
use serde::{Deserialize, Serialize};

use super::field::Field;
use super::params::{Borders, Dunes};

/// The protection of every site, for each wind of the rose, units.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Protection {
    /// Depths for which `maps` hold.
    known: Vec<i32>,
    maps: Vec<Vec<i64>>,
    #[serde(skip)]
    cones: Option<Cones>,
    grid: Grid,
    reach: f64,
    half_angle: f64,
    towards: Vec<[f64; 2]>,
}

#[derive(Clone, Debug)]
struct Cones {
    sites: RasterSites,
    stencils: Vec<Stencil>,
}

impl Protection {
    pub(super) fn new(params: &Dunes, rose: &Rose, grid: &Grid, field: &Field) -> Self {
        let n = grid.len();
        let mean = (field.sand.total() / n as i64) as i32;
        let edge = if params.borders == Borders::Periodic { Edge::Periodic } else { Edge::Open };
        let mut protection = Self {
            known: vec![mean; n],
            maps: vec![vec![0; n]; rose.winds().len()],
            cones: None,
            grid: Grid { edges: Edges::all(edge), ..grid.clone() },
            reach: params.reach().si(),
            half_angle: params.cone(),
            towards: rose.winds().iter().map(|w| w.towards()).collect(),
        };
        protection.update(field);
        protection
    }

    fn cones(&self) -> Option<Cones> {
        let sites = RasterSites::new(&self.grid, Connectivity::Eight).ok()?;
        let cone = |&w: &[f64; 2]| Stencil::cone(self.grid.spacing, self.reach, w, self.half_angle, Falloff::Constant);
        Some(Cones { sites, stencils: self.towards.iter().map(cone).collect() })
    }

    /// Updates the protection downwind of the sand that was eroded and deposited since the last
    /// call. **Cost** O(sites that changed · cone).
    pub(super) fn update(&mut self, field: &Field) {
        let Some(cones) = self.cones.take().or_else(|| self.cones()) else { return };
        for (site, depth) in field.sand.depths().enumerate() {
            let change = i64::from(depth - self.known[site]);
            if change != 0 {
                self.known[site] = depth;
                for (stencil, map) in cones.stencils.iter().zip(&mut self.maps) {
                    stencil.apply(&cones.sites, site, |downwind, _| map[downwind] += change);
                }
            }
        }
        self.cones = Some(cones);
    }

    /// The protection of every site from a wind, units.
    pub(super) fn from(&self, wind: usize) -> &[i64] {
        &self.maps[wind]
    }
}
