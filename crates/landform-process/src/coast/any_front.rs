//! A front on cells or on grains.

use std::sync::Arc;

use landform_core::Result;
use landform_core::random::Seed;
use landform_core::terrain::HeightField;

use super::front::{Drive, Front, Round};
use super::grains::{GrainFront, Grains};
use super::params::CoastErosion;

/// A front on cells or on grains; its sites are either.
#[derive(Clone, Debug)]
pub(super) enum AnyFront {
    Cells(Box<Front>),
    Grains(Box<GrainFront>),
}

impl AnyFront {
    /// A front with the land that the raster's nodes are, each site with the resistance that
    /// `fresh` gives by site and node.
    pub(super) fn new(
        params: &CoastErosion,
        terrain: &HeightField,
        land: Vec<bool>,
        seed: Seed,
        fresh: impl Fn(usize, usize) -> f64,
    ) -> Result<Self> {
        let Some(size) = params.grain else {
            let material = (0..land.len()).map(|i| fresh(i, i)).collect();
            return Self::resume(params, terrain, (land, material), None, seed);
        };
        let grains = Grains::new(terrain, size.si(), seed.named("grains"))?;
        let (land, material) = (grains.land(&land), (0..grains.len()).map(|g| fresh(g, grains.node(g))).collect());
        Ok(Self::on_grains(params, grains, (land, material), None))
    }

    /// A front as it was left: land and what is left of the resistance, by site.
    pub(super) fn resume(
        params: &CoastErosion,
        terrain: &HeightField,
        (land, material): (Vec<bool>, Vec<f64>),
        length: Option<f64>,
        seed: Seed,
    ) -> Result<Self> {
        if let Some(size) = params.grain {
            let grains = Grains::new(terrain, size.si(), seed.named("grains"))?;
            return Ok(Self::on_grains(params, grains, (land, material), length));
        }
        let radius = params.weakening.map(|w| w.radius.si());
        let front = Front::new(terrain.grid(), land, material, (params.exposure, params.perimeter), radius, length)?;
        Ok(Self::Cells(Box::new(front)))
    }

    fn on_grains(
        params: &CoastErosion,
        grains: Grains,
        (land, material): (Vec<bool>, Vec<f64>),
        length: Option<f64>,
    ) -> Self {
        let radius = params.weakening.map(|w| w.radius.si());
        let front = GrainFront::new(grains, land, material, (params.exposure, params.perimeter), radius, length);
        Self::Grains(Box::new(front))
    }

    /// Which sites are land, and what is left of their resistance.
    pub(super) fn parts(&mut self) -> (&mut Vec<bool>, &mut Vec<f64>) {
        match self {
            Self::Cells(front) => (&mut front.land, &mut front.material),
            Self::Grains(front) => (&mut front.land, &mut front.material),
        }
    }

    /// Length of all coasts at the start, in sides of cells or m.
    pub(super) fn start_length(&self) -> f64 {
        match self {
            Self::Cells(front) => front.start_length,
            Self::Grains(front) => front.start_length,
        }
    }

    /// The grains, if sites are grains.
    pub(super) fn grains(&self) -> Option<Arc<Grains>> {
        match self {
            Self::Cells(_) => None,
            Self::Grains(front) => Some(front.grains.clone()),
        }
    }

    /// The raster's node that stands for a site.
    pub(super) fn node(&self, site: usize) -> usize {
        match self {
            Self::Cells(_) => site,
            Self::Grains(front) => front.grains.node(site),
        }
    }

    /// Calls `visit` with every node of a site.
    pub(super) fn each_node(&self, site: usize, mut visit: impl FnMut(usize)) {
        match self {
            Self::Cells(_) => visit(site),
            Self::Grains(front) => front.grains.nodes(site).iter().for_each(|&i| visit(i as usize)),
        }
    }

    /// Takes over which nodes are land, after others moved ground or sea; returns the sites that
    /// changed.
    pub(super) fn take_over(&mut self, land: Vec<bool>) -> Vec<usize> {
        match self {
            Self::Cells(front) => front.take_over(land),
            Self::Grains(front) => {
                let land = front.grains.land(&land);
                front.take_over(land)
            }
        }
    }

    /// One round, with forces by site.
    pub(super) fn round(&mut self, drive: &Drive) -> Round {
        match self {
            Self::Cells(front) => front.round(drive),
            Self::Grains(front) => front.round(drive),
        }
    }

    /// Whether land under a level lies beside any of these sites.
    pub(super) fn opens_lows(&self, sites: &[usize], z: &[f64], level: f64) -> bool {
        match self {
            Self::Cells(front) => front.opens_lows(sites, z, level),
            Self::Grains(front) => front.opens_lows(sites, z, level),
        }
    }

    /// Whether no land is reached.
    pub(super) fn is_done(&self) -> bool {
        match self {
            Self::Cells(front) => front.is_done(),
            Self::Grains(front) => front.is_done(),
        }
    }
}
