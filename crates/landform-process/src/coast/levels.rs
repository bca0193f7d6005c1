//! Level sets of land: the coasts that a sea of growing force would leave (Pytel 2015, listing
//! 4.1).
//!
//! # Method
//! The sea goes on eroding. Where it stops, its force is raised just enough to bring down the
//! weakest site. When the front is farther than `spacing` from the last level set anywhere, sites
//! that have not moved since then are made to fall, and the front is the next level set.
//!
//! # Limits
//! A level set closes when any one finger of the front has come too far, so sets lie closer than
//! `spacing`. They are the closer, the finer the cells and the weaker the weakening.

use landform_core::Result;
use landform_core::agents::{Connectivity, RasterSites};
use landform_core::error::Error;
use landform_core::grid::{Grid, Neighbours};
use landform_core::random::Seed;
use landform_core::units::Ratio;

use super::front::{Drive, Front};
use super::params::{Exposure, Perimeter, Weakening};
use super::weakest::Weakest;

/// The erosion that makes level sets.
pub(super) struct FrontErosion {
    pub(super) force: Ratio,
    pub(super) damping: Ratio,
    pub(super) perimeter: Perimeter,
    pub(super) exposure: Exposure,
    pub(super) weakening: Option<Weakening>,
    /// Farthest that a level set lies from the one before, m.
    pub(super) spacing: f64,
}

impl FrontErosion {
    /// Number of the level set that each site of the land lies within, from 1; 0 at sea.
    pub(super) fn levels(&self, grid: &Grid, land: &[bool], seed: Seed) -> Result<Vec<u32>> {
        let material = (0..land.len()).map(|i| seed.uniform(i as u64)).collect();
        let radius = self.weakening.map(|w| w.radius.si());
        let mut front = Front::new(grid, land.to_vec(), material, (self.exposure, self.perimeter), radius, None)?;
        let sites = RasterSites::new(grid, Connectivity::Four)?;
        let amount = self.weakening.map_or(0.0, |w| w.amount);
        // Where a fall weakens much of the coast, rounds are few and large.
        let is_slow = amount == 0.0 && matches!(self.perimeter, Perimeter::Whole(_));
        let mut weakest = is_slow.then(|| Weakest::new(&mut front));
        // Steps from the last level set, in cells, of what fell since then.
        let most = (self.spacing / grid.spacing[0].min(grid.spacing[1])).max(1.0);
        let (mut levels, mut steps) = (vec![0u32; land.len()], vec![0f64; land.len()]);
        let (mut level, mut force) = (1u32, self.force.si());
        while !front.is_done() {
            let current = force;
            let drive =
                Drive { force: &|_| current, damping: &|_| self.damping.si(), wear: &|_| 0.0, weakening: &|_| amount };
            let round = match &mut weakest {
                Some(weakest) => weakest.round(&mut front, (current, self.damping.si()), &drive),
                None => front.round(&drive),
            };
            if round.fallen.is_empty() {
                if !round.needed.is_finite() {
                    return Err(Error::parameter("force", self.force, "a force that the coast feels"));
                }
                force *= round.needed.max(1.0) * (1.0 + 1e-9);
                continue;
            }
            let mark = |fallen: &[usize], levels: &mut [u32], steps: &mut [f64]| {
                for &site in fallen {
                    levels[site] = level;
                    let behind = sites
                        .neighbours(site)
                        .filter(|n| levels[n.to] > 0 && n.to != site)
                        .map(|n| if levels[n.to] == level { steps[n.to] } else { 0.0 });
                    let nearest = behind.fold(f64::INFINITY, f64::min);
                    steps[site] = if nearest.is_finite() { nearest + 1.0 } else { 1.0 };
                }
            };
            mark(&round.fallen, &mut levels, &mut steps);
            if round.fallen.iter().any(|&s| steps[s] > most) {
                // Sites whose neighbours at sea were all there before this level: they have not
                // moved since.
                let stuck: Vec<usize> = front
                    .coast_sites()
                    .into_iter()
                    .filter(|&s| sites.neighbours(s).all(|n| front.land[n.to] || levels[n.to] < level))
                    .collect();
                front.fall(&stuck, &drive);
                mark(&stuck, &mut levels, &mut steps);
                level += 1;
                force = self.force.si();
            }
        }
        Ok(levels)
    }
}
