//! The front between land and sea, for any force that drives it.

use landform_core::agents::{Connectivity, Falloff, Group, RasterSites, Stencil};
use landform_core::grid::{Edge, Edges, Grid, Neighbours, Shape};
use landform_core::{Result, parallel};

use super::params::{Exposure, Perimeter};
use super::perimeter::{self, Coast};

/// Result of a round.
#[derive(Clone, Debug, Default)]
pub(super) struct Round {
    /// Sites that fell, by index.
    pub(super) fallen: Vec<usize>,
    /// The least factor on the force that would have brought a site down, if none fell.
    pub(super) needed: f64,
}

/// Side of the square, in radii of weakening, whose fall weakens by the whole amount; smaller cells
/// weaken by their part of it, so that the weakening by an area that falls does not depend on them.
/// The thesis' sites of 15 m and radius of 25 m are of this size.
pub(super) const WHOLE_EVENT: f64 = 0.6;

/// What drives the sea at each site.
pub(super) struct Drive<'a> {
    pub(super) force: &'a (dyn Fn(usize) -> f64 + Sync),
    pub(super) damping: &'a (dyn Fn(usize) -> f64 + Sync),
    pub(super) wear: &'a (dyn Fn(usize) -> f64 + Sync),
    /// Amount of weakening around a site that falls.
    pub(super) weakening: &'a (dyn Fn(usize) -> f64 + Sync),
}

/// The front between land and sea on a raster.
#[derive(Clone, Debug)]
pub(super) struct Front {
    sites: RasterSites,
    shape: Shape,
    /// The sea lies beyond open sides.
    edges: Edges,
    pub(super) land: Vec<bool>,
    /// What is left of each site's resistance.
    pub(super) material: Vec<f64>,
    /// Land sites that the sea reaches, with the number of their sides that it does.
    coast: Group<u8>,
    exposure: Exposure,
    perimeter: Perimeter,
    /// Length of all coasts at the start, sides.
    pub(super) start_length: f64,
    stencil: Option<Stencil>,
    /// Part of the amount of weakening that the fall of one site carries.
    event: f64,
    /// Sides of all sites of the coast.
    length: u64,
    /// Sites whose resistance may have changed, if that is followed.
    changed: Option<Vec<usize>>,
}

impl Front {
    /// A front between `land` and all other sites; `start_length` of a front that is taken up
    /// again.
    pub(super) fn new(
        grid: &Grid,
        land: Vec<bool>,
        material: Vec<f64>,
        (exposure, perimeter): (Exposure, Perimeter),
        weakening_radius: Option<f64>,
        start_length: Option<f64>,
    ) -> Result<Self> {
        let mut front = Self {
            sites: RasterSites::new(grid, Connectivity::Four)?,
            shape: grid.shape,
            edges: grid.edges,
            coast: Group::new(land.len()),
            land,
            material,
            exposure,
            perimeter,
            start_length: 0.0,
            event: weakening_radius.map_or(1.0, |r| (grid.cell_area() / (WHOLE_EVENT * WHOLE_EVENT * r * r)).min(1.0)),
            length: 0,
            changed: None,
            stencil: weakening_radius.map(|r| Stencil::disc(grid.spacing, r, Falloff::Linear)),
        };
        for site in 0..front.land.len() {
            front.look(site);
        }
        front.start_length = start_length.unwrap_or(front.length as f64);
        Ok(front)
    }

    /// Sides of a site that the sea reaches.
    fn sides(&self, site: usize) -> u8 {
        let near = self.sites.neighbours(site).filter(|n| !self.land[n.to]).count() as u8;
        near + self.edges.open_sides_at(self.shape, site) as u8
    }

    /// Makes a land site part of the coast if the sea reaches it, and only then.
    fn look(&mut self, site: usize) {
        let sides = if self.land[site] { self.sides(site) } else { 0 };
        self.length += u64::from(sides);
        self.length -= self.coast.at(site).map_or(0, |&known| u64::from(known));
        if let Some(changed) = &mut self.changed {
            changed.push(site);
        }
        match self.coast.at_mut(site) {
            _ if sides == 0 => {
                self.coast.leave(site);
            }
            Some(known) => *known = sides,
            None => {
                self.coast.join(site, sides);
            }
        }
    }

    /// Takes over which sites are land, after others moved ground or sea; returns those that
    /// changed.
    pub(super) fn take_over(&mut self, land: Vec<bool>) -> Vec<usize> {
        let changed: Vec<usize> = (0..land.len()).filter(|&i| land[i] != self.land[i]).collect();
        self.land = land;
        for &site in &changed {
            self.look(site);
            self.near(site).into_iter().flatten().for_each(|n| self.look(n));
        }
        changed
    }

    fn near(&self, site: usize) -> [Option<usize>; 4] {
        let mut it = self.sites.neighbours(site).map(|n| n.to);
        std::array::from_fn(|_| it.next())
    }

    /// Whether land under a level lies beside any of these sites.
    pub(super) fn opens_lows(&self, sites: &[usize], z: &[f64], level: f64) -> bool {
        sites.iter().flat_map(|&site| self.near(site)).flatten().any(|n| self.land[n] && z[n] <= level)
    }

    /// Whether no land is reached.
    pub(super) fn is_done(&self) -> bool {
        self.coast.is_empty()
    }

    /// Sites of the coast, by index.
    pub(super) fn coast_sites(&self) -> Vec<usize> {
        self.coast.sites()
    }

    /// The factor on resistance that the exposed sides leave.
    fn resistance(&self, site: usize, sides: u8) -> f64 {
        let material = self.material[site].max(0.0);
        match (self.exposure, sides) {
            (Exposure::None, _) => material,
            (Exposure::Proportional, s) => material * f64::from(4 - s.min(4)) / 4.0,
            (Exposure::Squared, 1) => material,
            (Exposure::Squared, 2) => material * material,
            (Exposure::Squared, _) => 0.0,
        }
    }

    /// One round: the force of the sea is that at the start of the round, and all sites that it
    /// exceeds fall at once.
    pub(super) fn round(&mut self, drive: &Drive) -> Round {
        let sites = self.coast.sites();
        let sides: Vec<u8> = sites.iter().map(|&s| self.coast.at(s).copied().unwrap_or(0)).collect();
        let coast = Coast { sites: &sites, sides: &sides, shape: self.shape, land: &self.land, wraps: self.wraps() };
        let resistance = parallel::map(sites.len(), |k| self.resistance(sites[k], sides[k]));
        // The damping is not needed at a site that the undamped sea would not bring down, unless it
        // wears or the round may stall.
        let force = |k: usize| (drive.force)(sites[k]);
        let wanted: Vec<bool> =
            (0..sites.len()).map(|k| resistance[k] < force(k) || (drive.wear)(sites[k]) > 0.0).collect();
        let ratio = perimeter::ratios(self.perimeter, &coast, self.start_length, self.sites.spacing(), &wanted);
        let pressure = |k: usize| force(k) / (1.0 + (drive.damping)(sites[k]) * ratio[k]);
        let round = yields((&sites, &wanted), &resistance, pressure, drive, &mut self.material);
        self.fall(&round.fallen, drive);
        round
    }

    /// Makes sites fall, whatever their resistance.
    pub(super) fn fall(&mut self, sites: &[usize], drive: &Drive) {
        for &site in sites {
            self.land[site] = false;
            self.look(site);
        }
        for &site in sites {
            self.near(site).into_iter().flatten().for_each(|n| self.look(n));
            let amount = self.event * (drive.weakening)(site);
            if let Some(stencil) = &self.stencil
                && amount > 0.0
            {
                let (material, changed) = (&mut self.material, &mut self.changed);
                stencil.apply(&self.sites, site, |at, weight| {
                    material[at] -= amount * weight;
                    changed.iter_mut().for_each(|list| list.push(at));
                });
            }
        }
    }

    /// Begins to follow which resistances change; returns the sites of the coast.
    pub(super) fn follow(&mut self) -> Vec<usize> {
        self.changed = Some(Vec::new());
        self.coast.sites()
    }

    /// Sites whose resistance may have changed since this was last asked.
    pub(super) fn take_changed(&mut self) -> Vec<usize> {
        self.changed.as_mut().map(std::mem::take).unwrap_or_default()
    }

    /// What a site of the coast resists with; none of a site that is not.
    pub(super) fn resists(&self, site: usize) -> Option<f64> {
        self.coast.at(site).map(|&sides| self.resistance(site, sides))
    }

    /// Length of all coasts over that at the start.
    pub(super) fn lengthened(&self) -> f64 {
        self.length as f64 / self.start_length.max(1.0)
    }

    fn wraps(&self) -> [bool; 2] {
        // A torus shows in a neighbour on the far side.
        let far = |a: usize, b: usize| a != b && self.sites.neighbours(a).any(|n| n.to == b);
        let Shape { rows, cols } = self.shape;
        [cols > 2 && far(0, cols - 1), rows > 2 && far(0, self.shape.index(rows - 1, 0))]
    }
}

/// What a pressure on the sites of a coast does: which fall, and wear of the others; sites that are
/// not wanted stand. All but the material is by position in the list.
pub(super) fn yields(
    (sites, wanted): (&[usize], &[bool]),
    resistance: &[f64],
    pressure: impl Fn(usize) -> f64,
    drive: &Drive,
    material: &mut [f64],
) -> Round {
    let mut round = Round { fallen: Vec::new(), needed: f64::INFINITY };
    for (k, &site) in sites.iter().enumerate() {
        let (pressure, wear) = (pressure(k), (drive.wear)(site));
        let falls = if wear > 0.0 {
            // Wear acts through as many sides as the sea reaches.
            material[site] -= wear * pressure * (material[site] / resistance[k].max(1e-9)).clamp(1.0, 4.0);
            material[site] <= 0.0
        } else {
            wanted[k] && resistance[k] < pressure
        };
        if falls {
            round.fallen.push(site);
        } else if pressure > 0.0 {
            round.needed = round.needed.min(resistance[k] / pressure);
        }
    }
    round
}

/// The sea: sites at or under a level that connect to the open border, or to sites that were sea
/// before.
pub(super) fn flood(grid: &Grid, z: &[f64], level: f64) -> Result<Vec<bool>> {
    let sites = RasterSites::new(grid, Connectivity::Four)?;
    let mut sea = vec![false; z.len()];
    let low = |i: usize| !(z[i] > level);
    let Edges { north, east, south, west } = grid.edges;
    // Where nothing lies beyond the map, what is low is sea.
    let is_closed = ![north, east, south, west].contains(&Edge::Open);
    let borders_sea = |i: usize| grid.edges.open_sides_at(grid.shape, i) > 0;
    let mut pending: Vec<usize> = (0..z.len()).filter(|&i| low(i) && (is_closed || borders_sea(i))).collect();
    pending.iter().for_each(|&i| sea[i] = true);
    while let Some(site) = pending.pop() {
        for near in sites.neighbours(site) {
            if low(near.to) && !sea[near.to] {
                sea[near.to] = true;
                pending.push(near.to);
            }
        }
    }
    Ok(sea)
}
