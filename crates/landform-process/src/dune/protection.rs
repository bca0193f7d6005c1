//! Protection instead of shadows (Pytel 2015, 4.1.2).
//!
//! A site protects the cone downwind of it: sand that is deposited there adds to the protection of
//! every site of the cone, and sand that is eroded reduces it. Lines of sight are not computed;
//! shadows emerge. The thesis gives neither the protection at the start nor what makes it enough.
//!
//! Heights are those of the sand above its mean depth, so that sand which was there before counts
//! as deposited sand. With a constant reach, which is the thesis' own rule, all heights in the cone
//! are summed, those below the mean as less than nothing; a site is sheltered while its protection
//! is positive.
//!
//! Else the cone of a heap is as long as its shadow: height / tan 15 degrees. Protection falls off
//! linearly, from the height to nothing at the end. A site is sheltered while it receives more than
//! a part of what it gives, so that heaps protect what lies behind them more than themselves. The
//! part is ours: a quarter, found by trial. With more of it dunes get lower; with none, more is
//! sheltered that the wind could see.

use landform_core::agents::{Connectivity, Falloff, RasterSites, Stencil};
use landform_core::grid::{Edge, Edges, Grid};
use landform_core::math;
use landform_core::units::Length;
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
    /// Constant reach, m; none if it follows from the height of the sand.
    reach: Option<f64>,
    half_angle: f64,
    towards: Vec<[f64; 2]>,
    /// Mean depth at the start, units, from which heights count.
    base: i32,
    /// Height of a unit, m.
    unit: f64,
}

#[derive(Clone, Debug)]
struct Cones {
    sites: RasterSites,
    /// Length, m.
    reach: f64,
    /// For each wind the sites of the cone, nearest first: columns east, rows south, and the height
    /// that is lost on the way, units.
    sites_of: Vec<Vec<(i32, i32, i32)>>,
}

impl Protection {
    pub(super) fn new(params: &Dunes, rose: &Rose, grid: &Grid, field: &Field) -> Self {
        let n = grid.len();
        let reach = params.reach.map(Length::si);
        let base = (field.sand.total() / n as i64) as i32;
        let edge = if params.borders == Borders::Periodic { Edge::Periodic } else { Edge::Open };
        let mut protection = Self {
            known: vec![base; n],
            maps: vec![vec![0; n]; rose.winds().len()],
            cones: None,
            grid: Grid { edges: Edges::all(edge), ..grid.clone() },
            reach,
            half_angle: params.cone(),
            towards: rose.winds().iter().map(|w| w.towards()).collect(),
            base,
            unit: field.unit,
        };
        protection.update(field);
        protection
    }

    /// Cones of a length, m.
    fn cones(&self, reach: f64) -> Option<Cones> {
        let sites = RasterSites::new(&self.grid, Connectivity::Eight).ok()?;
        let lost = |c: i32, r: i32| match self.reach {
            Some(_) => 0,
            None => {
                let [x, y] = self.grid.spacing;
                let distance = math::hypot(f64::from(c) * x, f64::from(r) * y);
                (distance * math::tan(SHADOW.to_radians()) / self.unit).round() as i32
            }
        };
        let cone = |&w: &[f64; 2]| {
            let stencil = Stencil::cone(self.grid.spacing, reach, w, self.half_angle, Falloff::Constant);
            let mut sites: Vec<_> = stencil.offsets().map(|(c, r, _)| (c, r, lost(c, r))).collect();
            sites.sort_by_key(|&(c, r, lost)| (lost, r, c));
            sites
        };
        Some(Cones { sites, reach, sites_of: self.towards.iter().map(cone).collect() })
    }

    /// How far sand of a depth protects, m: no farther than the map is wide.
    fn reach_of(&self, depth: i32) -> f64 {
        let [x, y] = self.grid.spacing;
        let widest = (self.grid.shape.cols as f64 * x).min(self.grid.shape.rows as f64 * y);
        let height = f64::from(depth - self.base) * self.unit;
        self.reach.unwrap_or((height / math::tan(SHADOW.to_radians())).min(0.5 * widest))
    }

    /// Updates the protection downwind of the sand that was eroded and deposited since the last
    /// call. **Cost** O(sites that changed · cone).
    pub(super) fn update(&mut self, field: &Field) {
        let reach = self.reach_of(field.sand.depths().max().unwrap_or(0));
        let kept = self.cones.take().filter(|cones| cones.reach >= reach);
        // Longer than is needed now, lest every new crest needs new ones.
        let longer = if self.reach.is_some() { reach } else { 1.25 * reach };
        let Some(cones) = kept.or_else(|| self.cones(longer)) else { return };
        for (site, depth) in field.sand.depths().enumerate() {
            let (old, new) = (self.known[site] - self.base, depth - self.base);
            if old == new {
                continue;
            }
            self.known[site] = depth;
            for (cone, map) in cones.sites_of.iter().zip(&mut self.maps) {
                for &(c, r, lost) in cone {
                    let change = match self.reach {
                        Some(_) => new - old,
                        None if lost >= old.max(new) => break,
                        None => (new - lost).max(0) - (old - lost).max(0),
                    };
                    if let Some(downwind) = cones.sites.moved(site, i64::from(c), i64::from(r)) {
                        map[downwind] += i64::from(change);
                    }
                }
            }
        }
        self.cones = Some(cones);
    }

    /// Whether each site is sheltered from a wind.
    pub(super) fn find(&self, wind: usize) -> impl Iterator<Item = bool> {
        let cone = self.cones.as_ref().map_or(&[][..], |cones| &cones.sites_of[wind]);
        // Sums of what is lost on the way, nearest first.
        let sums: Vec<i64> = std::iter::once(0)
            .chain(cone.iter().scan(0, |sum, &(.., lost)| {
                *sum += i64::from(lost);
                Some(*sum)
            }))
            .collect();
        self.maps[wind].iter().zip(&self.known).map(move |(&protection, &depth)| {
            if self.reach.is_some() {
                return protection > 0;
            }
            let height = depth - self.base;
            let reached = cone.partition_point(|&(.., lost)| lost < height);
            let given = i64::from(height) * reached as i64 - sums[reached];
            protection * OWN_SHARE > given
        })
    }
}

/// Angle of a heap's shadow, degrees.
const SHADOW: f64 = 15.0;
/// A site is sheltered that receives more than one such part of what it gives.
const OWN_SHARE: i64 = 4;
