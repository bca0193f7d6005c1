//! The front between land and sea on grains.

use std::sync::Arc;

use landform_core::agents::Group;
use landform_core::{math, parallel};

use super::{Beyond, Grains};
use crate::coast::front::{Drive, Round, WHOLE_EVENT, yields};
use crate::coast::params::{Exposure, Perimeter, Search};

/// Sides of a cell: exposure counts the open part of a grain's sides in these.
const CELL_SIDES: f64 = 4.0;
/// Exposure from which on the squared rule leaves no resistance.
const LOST: f64 = 2.5;

/// How much stronger a force acts on grains than on cells: a sea that needs no exposure finds its
/// way through where half of the grains are weaker than it is, three of which meet at every corner;
/// of cells it takes 0.593 (the thresholds of percolation). With this a square of 1.9 km keeps as
/// much land as on cells of 15 m, by the thesis' forces.
const STRONGER: f64 = 1.2;

/// The front between land and sea on grains.
#[derive(Clone, Debug)]
pub(in crate::coast) struct GrainFront {
    pub(in crate::coast) grains: Arc<Grains>,
    pub(in crate::coast) land: Vec<bool>,
    /// What is left of each grain's resistance.
    pub(in crate::coast) material: Vec<f64>,
    /// Land grains that the sea reaches, with the length of their sides that it does, m.
    coast: Group<f64>,
    exposure: Exposure,
    perimeter: Perimeter,
    /// Length of all coasts at the start, m.
    pub(in crate::coast) start_length: f64,
    weakening_radius: Option<f64>,
}

impl GrainFront {
    /// A front between `land` and all other grains; `start_length` of a front that is taken up
    /// again.
    pub(in crate::coast) fn new(
        grains: Grains,
        land: Vec<bool>,
        material: Vec<f64>,
        (exposure, perimeter): (Exposure, Perimeter),
        weakening_radius: Option<f64>,
        start_length: Option<f64>,
    ) -> Self {
        let mut front = Self {
            coast: Group::new(land.len()),
            grains: Arc::new(grains),
            land,
            material,
            exposure,
            perimeter,
            start_length: 0.0,
            weakening_radius,
        };
        (0..front.land.len()).for_each(|grain| front.look(grain));
        front.start_length = start_length.unwrap_or_else(|| front.coast.iter().map(|(_, &s)| s).sum());
        front
    }

    /// Makes a land grain part of the coast if the sea reaches it, and only then.
    fn look(&mut self, grain: usize) {
        let is_sea = |to: usize| match self.grains.beyond[to] {
            None => !self.land[to],
            Some(beyond) => beyond == Beyond::Sea,
        };
        let open = if self.land[grain] {
            self.grains.sides(grain).filter(|&(to, _)| is_sea(to)).map(|(_, side)| side).sum()
        } else {
            0.0
        };
        match self.coast.at_mut(grain) {
            _ if open <= 0.0 => {
                self.coast.leave(grain);
            }
            Some(known) => *known = open,
            None => {
                self.coast.join(grain, open);
            }
        }
    }

    fn look_around(&mut self, grain: usize) {
        let grains = self.grains.clone();
        grains.sides(grain).for_each(|(to, _)| self.look(to));
    }

    /// Takes over which grains are land; returns those that changed.
    pub(in crate::coast) fn take_over(&mut self, land: Vec<bool>) -> Vec<usize> {
        let changed: Vec<usize> = (0..land.len()).filter(|&g| land[g] != self.land[g]).collect();
        self.land = land;
        for &grain in &changed {
            self.look(grain);
            self.look_around(grain);
        }
        changed
    }

    /// Whether land under a level lies beside any of these grains.
    pub(in crate::coast) fn opens_lows(&self, grains: &[usize], z: &[f64], level: f64) -> bool {
        let is_low = |to: usize| self.land[to] && self.grains.nodes(to).iter().any(|&i| z[i as usize] <= level);
        grains.iter().any(|&g| self.grains.sides(g).any(|(to, _)| is_low(to)))
    }

    /// Whether no land is reached.
    pub(in crate::coast) fn is_done(&self) -> bool {
        self.coast.is_empty()
    }

    /// The resistance that the open sides leave.
    fn resistance(&self, grain: usize, open: f64) -> f64 {
        let material = self.material[grain].max(0.0);
        let sides = (CELL_SIDES * open / self.grains.around[grain]).min(CELL_SIDES);
        match self.exposure {
            Exposure::None => material,
            Exposure::Proportional => material * (1.0 - sides / CELL_SIDES),
            Exposure::Squared if sides >= LOST => 0.0,
            Exposure::Squared => math::pow(material, sides.max(1.0)),
        }
    }

    /// One round: the force of the sea is that at the start of the round, and all grains that it
    /// exceeds fall at once.
    pub(in crate::coast) fn round(&mut self, drive: &Drive) -> Round {
        let sites = self.coast.sites();
        let open: Vec<f64> = sites.iter().map(|&s| self.coast.at(s).copied().unwrap_or(0.0)).collect();
        let resistance = parallel::map(sites.len(), |k| self.resistance(sites[k], open[k]));
        let force = |k: usize| (drive.force)(sites[k]) / STRONGER;
        let wanted: Vec<bool> =
            (0..sites.len()).map(|k| resistance[k] < force(k) || (drive.wear)(sites[k]) > 0.0).collect();
        let ratio = self.ratios(&sites, &open, &wanted);
        let pressure = |k: usize| force(k) / (1.0 + (drive.damping)(sites[k]) * ratio[k]);
        let round = yields((&sites, &wanted), &resistance, pressure, drive, &mut self.material);
        self.fall(&round.fallen, drive);
        round
    }

    fn fall(&mut self, grains: &[usize], drive: &Drive) {
        for &grain in grains {
            self.land[grain] = false;
            self.coast.leave(grain);
        }
        for &grain in grains {
            self.look_around(grain);
            let amount = (drive.weakening)(grain);
            if let Some(radius) = self.weakening_radius
                && amount > 0.0
            {
                let part = self.grains.size / (WHOLE_EVENT * radius);
                let event = amount * (part * part).min(1.0);
                let material = &mut self.material;
                self.grains.near(grain, radius).for_each(|(to, d)| material[to] -= event * (1.0 - d / radius));
            }
        }
    }

    /// L / L0 for every grain of the coast that is wanted.
    fn ratios(&self, sites: &[usize], open: &[f64], wanted: &[bool]) -> Vec<f64> {
        let all = || vec![open.iter().sum::<f64>() / self.start_length.max(f64::MIN_POSITIVE); sites.len()];
        let Perimeter::Local { local, search } = self.perimeter else { return all() };
        let radius = local.si();
        let straight = 2.0 * radius * self.grains.ragged;
        let reference = straight.min(self.start_length).max(f64::MIN_POSITIVE);
        let shore = match search {
            Search::All => vec![0; self.land.len()],
            Search::Contiguous => self.shores(sites),
        };
        parallel::map(sites.len(), |k| {
            if !wanted[k] {
                return 0.0;
            }
            let near = self.grains.near(sites[k], radius).map(|n| n.0);
            let same = near.filter(|&g| shore[g] == shore[sites[k]]);
            same.map(|g| self.coast.at(g).copied().unwrap_or(0.0)).sum::<f64>() / reference
        })
    }

    /// Number of the shore that each grain of the coast belongs to: those that steps from grain to
    /// grain along the coast join.
    fn shores(&self, sites: &[usize]) -> Vec<u32> {
        let mut shore = vec![u32::MAX; self.land.len()];
        let mut stack = Vec::new();
        for (number, &first) in sites.iter().enumerate() {
            if shore[first] != u32::MAX {
                continue;
            }
            shore[first] = number as u32;
            stack.push(first);
            while let Some(g) = stack.pop() {
                for (to, _) in self.grains.sides(g) {
                    if shore[to] == u32::MAX && self.coast.at(to).is_some() {
                        shore[to] = number as u32;
                        stack.push(to);
                    }
                }
            }
        }
        shore
    }
}
