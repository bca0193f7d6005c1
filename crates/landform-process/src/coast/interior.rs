//! The inside of islands, from coasts that the sea would come to (Pytel 2015, 4.2.4 and listing 4.1).
//!
//! # Method
//! The sea goes on gnawing. Where it stands still, its force is raised by just as much as brings down the weakest site. When the front
//! has come farther than `spacing` from the last level set anywhere, what has not moved since then is forced, and the front is the next
//! level set. Level sets rise by `interval`; between them heights follow from the distances to the lower and the upper one, measured
//! within the band between them by fast marching, linearly or by Hermite's polynomials with limited slopes at the level sets, so that the
//! ground has no creases there. On summits, within the last level set, the slope at it goes on, up to one interval.
//!
//! # Limits
//! A level set closes when any one finger of the front has come too far, so sets lie closer than `spacing`, the closer the finer the cells
//! and the less weakening there is; slopes are steeper than interval over spacing.
//!
//! # Sources
//! Pytel (2015), listing 4.1; Hormann, Spinello & Schroeder (2003) for slopes across level sets; Fritsch & Carlson (1980) for their limit.

use landform_core::agents::{Connectivity, RasterSites, Sites};
use landform_core::algo::fast_marching::{Order, march};
use landform_core::field::names;
use landform_core::grid::Lattice;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Length, Ratio};
use landform_core::verb::{Context, Edit, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::front::{Drive, Front, flood};
use super::params::{CoastErosion, Exposure, Perimeter, Weakening, Whole};

/// How heights between level sets are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LevelInterpolation {
    /// Those of the lower level set: terraces.
    Nearest,
    /// In proportion to the distances.
    Linear,
    /// Smooth across level sets.
    #[default]
    Hermite,
}

/// Gives islands an inside: coasts that a sea with more and more force would gnaw become level sets of hills. Land keeps its outline; what
/// height it had is lost.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct IslandInterior {
    /// Force of the sea at the start.
    #[schemars(extend("x-above" = 0.0))]
    pub force: Ratio,
    /// Damping of the sea by the length of the coast.
    #[schemars(extend("x-min" = 0.0))]
    pub damping: Ratio,
    /// Whose length damps, as in `coast_erosion`.
    pub perimeter: Perimeter,
    /// How places grow weaker with the sides that the sea reaches.
    pub exposure: Exposure,
    /// Weakening of what lies near a place that falls, for smoother level sets.
    pub weakening: Option<Weakening>,
    /// Farthest that a level set lies from the one before.
    #[schemars(extend("x-above" = 0.0))]
    pub spacing: Length,
    /// Height from one level set to the next.
    #[schemars(extend("x-above" = 0.0))]
    pub interval: Length,
    /// How heights between level sets are found.
    pub interpolation: LevelInterpolation,
    /// Level of the sea.
    pub sea_level: Length,
}

impl Default for IslandInterior {
    fn default() -> Self {
        Self {
            force: Ratio::of(0.3),
            damping: Ratio::of(0.15),
            perimeter: Perimeter::Whole(Whole::Global),
            exposure: Exposure::Proportional,
            weakening: Some(Weakening { amount: 0.3, radius: Length::of(60.0) }),
            spacing: Length::of(100.0),
            interval: Length::of(20.0),
            interpolation: LevelInterpolation::Hermite,
            sea_level: Length::of(0.0),
        }
    }
}

impl Params for IslandInterior {
    const NAME: &'static str = "island_interior";
    const SOURCES: &'static [Source] = CoastErosion::SOURCES;

    fn check(&self) -> Result<()> {
        CoastErosion { perimeter: self.perimeter, weakening: self.weakening, ..CoastErosion::default() }.check()
    }
}

impl Edit<HeightField> for IslandInterior {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        if let Some(w) = self.weakening {
            crate::mechanism::within_map("weakening", w.radius, &terrain.grid)?;
        }
        let z = terrain.elevation();
        let sea = flood(&terrain.grid, z, self.sea_level.si())?;
        let land: Vec<bool> = (0..z.len()).map(|i| !sea[i] && !z[i].is_nan()).collect();
        let levels = self.levels(terrain, &land, context)?;
        let slope = self.interval.si() / self.spacing.si();
        // The sea beyond the map's open sides.
        let (shape, edges) = (terrain.grid.shape, terrain.grid.edges);
        let shore = |i: usize| levels[i] == 1 && edges.open_sides_at(shape, i) > 0;
        let lattice = Lattice::of(&terrain.grid);
        let heights = heights(&lattice, &levels, self.interval.si(), slope, self.interpolation, shore);
        for i in 0..land.len() {
            if land[i] {
                terrain.elevation_mut()[i] = self.sea_level.si() + heights[i];
            }
        }
        terrain.fields_mut().insert(&names::LEVEL_SET, levels);
        Ok(())
    }
}

impl IslandInterior {
    /// Number of the level set that each site of the land lies within, from 1; 0 at sea.
    fn levels(&self, terrain: &HeightField, land: &[bool], context: &Context) -> Result<Vec<u32>> {
        let material = (0..land.len()).map(|i| context.seed.uniform(i as u64)).collect();
        let radius = self.weakening.map(|w| w.radius.si());
        let mut front =
            Front::new(&terrain.grid, land.to_vec(), material, (self.exposure, self.perimeter), radius, None)?;
        let grid = &terrain.grid;
        let sites = RasterSites::new(grid, Connectivity::Four)?;
        let amount = self.weakening.map_or(0.0, |w| w.amount);
        // Steps from the last level set, in cells, of what fell since then.
        let most = (self.spacing.si() / grid.spacing[0].min(grid.spacing[1])).max(1.0);
        let (mut levels, mut steps) = (vec![0u32; land.len()], vec![0f64; land.len()]);
        let (mut level, mut force) = (1u32, self.force.si());
        while !front.is_done() {
            let current = force;
            let drive =
                Drive { force: &|_| current, damping: &|_| self.damping.si(), wear: &|_| 0.0, weakening: &|_| amount };
            let round = front.round(&drive);
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
                        .filter(|n| levels[n.site] > 0 && n.site != site)
                        .map(|n| if levels[n.site] == level { steps[n.site] } else { 0.0 });
                    let nearest = behind.fold(f64::INFINITY, f64::min);
                    steps[site] = if nearest.is_finite() { nearest + 1.0 } else { 1.0 };
                }
            };
            mark(&round.fallen, &mut levels, &mut steps);
            if round.fallen.iter().any(|&s| steps[s] > most) {
                // Sites whose neighbours at sea were all there before this level: they have not moved since.
                let stuck: Vec<usize> = front
                    .coast_sites()
                    .into_iter()
                    .filter(|&s| sites.neighbours(s).all(|n| front.land[n.site] || levels[n.site] < level))
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

/// Heights above the sea of land in numbered bands, m; 0 at sea. `typical_slope` is that of islets within which no level set lies.
pub(super) fn heights(
    lattice: &Lattice,
    levels: &[u32],
    interval: f64,
    typical_slope: f64,
    interpolation: LevelInterpolation,
    shore: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let floor = |i: usize| f64::from(levels[i].saturating_sub(1)) * interval;
    if interpolation == LevelInterpolation::Nearest {
        // Half an interval up, so that the lowest terrace is land.
        return (0..levels.len()).map(|i| if levels[i] == 0 { 0.0 } else { floor(i) + 0.5 * interval }).collect();
    }
    let below = Bands::distances(lattice, levels, |other, own| other < own, shore);
    let above = Bands::distances(lattice, levels, |other, own| other > own, |_| false);
    let width = |i: usize| below.distance[i] + above.distance[i];
    let slope = |i: usize| if width(i).is_finite() { interval / width(i) } else { f64::NAN };
    let of = |i: usize| {
        if levels[i] == 0 {
            return 0.0;
        }
        // The slope of the band on the other side of a level set, where the way from here crosses it.
        let beyond = |bands: &Bands| bands.foot(i).map_or(f64::NAN, slope);
        let (d, w, own) = (below.distance[i], width(i), slope(i));
        let at_set = |other: f64| match (own.is_nan(), other.is_nan()) {
            (false, false) => (2.0 / (1.0 / own + 1.0 / other)).min(3.0 * own.min(other)),
            (false, true) => own,
            (true, false) => other,
            (true, true) => typical_slope,
        };
        let outer = at_set(beyond(&below));
        if !w.is_finite() {
            return floor(i) + if d.is_finite() { (outer * d).min(interval) } else { 0.0 };
        }
        let t = d / w;
        if interpolation == LevelInterpolation::Linear {
            return floor(i) + t * interval;
        }
        let inner = at_set(beyond(&above));
        let (h10, h01, h11) = (t * (1.0 - t) * (1.0 - t), t * t * (3.0 - 2.0 * t), t * t * (t - 1.0));
        floor(i) + h10 * w * outer + h01 * interval + h11 * w * inner
    };
    (0..levels.len()).map(of).collect()
}

/// Distances within bands to one of their borders, and where the way there crosses it.
struct Bands {
    distance: Vec<f64>,
    /// The site beyond the border at the end of the way; own index if none.
    foot: Vec<u32>,
}

impl Bands {
    fn distances(
        lattice: &Lattice,
        levels: &[u32],
        is_border: impl Fn(u32, u32) -> bool,
        shore: impl Fn(usize) -> bool,
    ) -> Self {
        let n = levels.len();
        let half = 0.5 * lattice.spacing[0].min(lattice.spacing[1]);
        let around = |i: usize| {
            let place = lattice.place(i);
            [[-1, 0, 0], [1, 0, 0], [0, -1, 0], [0, 1, 0]].into_iter().filter_map(move |by| lattice.moved(place, by))
        };
        let mut foot: Vec<u32> = (0..n as u32).collect();
        let mut distance = vec![f64::INFINITY; n];
        let mut bands: Vec<Vec<u32>> = Vec::new();
        for i in 0..n {
            if levels[i] == 0 {
                continue;
            }
            let beyond = around(i).find(|&j| is_border(levels[j], levels[i]));
            if beyond.is_some() || shore(i) {
                foot[i] = beyond.unwrap_or(i) as u32;
                let band = levels[i] as usize;
                bands.resize(bands.len().max(band + 1), Vec::new());
                bands[band].push(i as u32);
            }
        }
        for (band, seeds) in bands.iter().enumerate().filter(|b| !b.1.is_empty()) {
            let mut order = Vec::new();
            let start = seeds.iter().map(|&s| (s as usize, half));
            let inside = |i: usize| levels[i] as usize == band;
            let d = march(
                lattice,
                start,
                |f, i| if inside(i) { f.eikonal(i, 1.0, Order::First) } else { f64::INFINITY },
                |i, _| order.push(i),
            );
            for i in order.into_iter().filter(|&i| d[i].is_finite()) {
                distance[i] = d[i];
                if foot[i] == i as u32 {
                    // Back the way that the front came.
                    let from = around(i).filter(|&j| inside(j)).min_by(|&a, &b| d[a].total_cmp(&d[b]));
                    foot[i] = from.map_or(i as u32, |j| foot[j]);
                }
            }
        }
        Self { distance, foot }
    }

    fn foot(&self, i: usize) -> Option<usize> {
        let foot = self.foot[i] as usize;
        (foot != i && self.distance[i].is_finite()).then_some(foot)
    }
}
