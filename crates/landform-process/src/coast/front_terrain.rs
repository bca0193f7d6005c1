//! Ground grown from a mask by fronts of erosion: the first stage of two-stage terrain (Pytel 2015,
//! 4.3.4).
//!
//! # Model
//! The mask chooses the lowest ground: rivers, seas. From there fronts erode the rest as the sea
//! erodes a coast. At equal distances they leave level sets. Heights rise from set to set and are
//! greatest where the fronts met last. If the ground is flooded to any level, its shore has the
//! shape that fronts leave.
//!
//! # Limits
//! No front starts at the sides of the map: hills continue beyond them.
//!
//! # Sources
//! Pytel (2015), listing 4.1 and figures 4.16, 4.17.

use landform_core::field::names;
use landform_core::grid::{Edge, Edges, Grid, Lattice};
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::{Length, Ratio, RatioDimension};
use landform_core::verb::{Context, Estimate, Generator, Params, Source, Varying};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::heights::{LevelInterpolation, heights};
use super::levels::FrontErosion;
use super::params::{CoastErosion, Exposure, Perimeter, Weakening, Whole};
use crate::mechanism::{GridParams, within_map};

/// Level sets along the longer side, if their spacing is not given.
const SETS_ACROSS: f64 = 24.0;

/// Hills from a mask: the lowest ground lies where the mask is at least one half, and level sets
/// shaped like coasts rise from there.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct FrontTerrain {
    /// Mask of the lowest ground, where it is at least one half: a picture such as { image =
    /// "strokes.png", black = 0.0, white = 1.0 }, or a formula.
    pub mask: Varying<RatioDimension>,
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Elevation of the lowest ground.
    pub lowest: Length,
    /// Greatest height above the lowest ground.
    #[schemars(extend("x-above" = 0.0))]
    pub relief: Length,
    /// How heights between level sets are found.
    pub interpolation: LevelInterpolation,
    /// Greatest distance of a level set from the one before. If not given, it is a 24th of the
    /// longer side.
    #[schemars(extend("x-above" = 0.0))]
    pub spacing: Option<Length>,
    /// Force of the fronts at the start, as in `coast_erosion`.
    #[schemars(extend("x-above" = 0.0))]
    pub force: Ratio,
    /// Damping by the length of the fronts.
    #[schemars(extend("x-min" = 0.0))]
    pub damping: Ratio,
    /// Fronts whose length damps, as the coast in `coast_erosion`.
    pub perimeter: Perimeter,
    /// How the resistance of sites falls with the number of their sides that the fronts reach.
    pub exposure: Exposure,
    /// Weakening of sites near one that falls, for smoother level sets.
    pub weakening: Option<Weakening>,
}

impl Default for FrontTerrain {
    fn default() -> Self {
        Self {
            mask: Ratio::of(1.0).into(),
            grid: GridParams::of([2560.0; 2], 10.0),
            lowest: Length::of(0.0),
            relief: Length::of(300.0),
            interpolation: LevelInterpolation::Variational,
            spacing: None,
            force: Ratio::of(0.225),
            damping: Ratio::of(0.15),
            perimeter: Perimeter::Whole(Whole::Global),
            exposure: Exposure::Proportional,
            weakening: Some(Weakening { amount: 0.3, radius: Length::of(60.0) }),
        }
    }
}

impl Params for FrontTerrain {
    const NAME: &'static str = "front_terrain";
    const RENAMED: &'static [(&'static str, &'static str)] = GridParams::RENAMED;
    const SOURCES: &'static [Source] = CoastErosion::SOURCES;

    fn leaves(&self) -> Vec<String> {
        vec![names::LEVEL_SET.name.into()]
    }

    fn check(&self) -> Result<()> {
        CoastErosion { perimeter: self.perimeter, weakening: self.weakening, ..CoastErosion::default() }.check()
    }
}

impl Generator<HeightField> for FrontTerrain {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let grid = self.grid.grid()?;
        if let Some(w) = self.weakening {
            within_map("weakening", w.radius, &grid)?;
        }
        let mut terrain = HeightField::new(grid, vec![self.lowest.si(); self.grid.grid()?.len()])?;
        let mask = self.mask.resolve("mask", &terrain, context)?;
        let land: Vec<bool> = (0..terrain.grid().len()).map(|i| mask.at(i) < 0.5).collect();
        if land.iter().all(|l| *l) {
            return Err(Error::parameter("mask", "below one half everywhere", "a map that chooses some of the ground"));
        }
        let longer = terrain.grid().extent()[0].max(terrain.grid().extent()[1]);
        let spacing = self.spacing.map_or(longer / SETS_ACROSS, Length::si);
        // The map's sides are no sea.
        let closed = Grid { edges: Edges::all(Edge::Closed), ..terrain.grid().clone() };
        let erosion = FrontErosion {
            force: self.force,
            damping: self.damping,
            perimeter: self.perimeter,
            exposure: self.exposure,
            weakening: self.weakening,
            spacing,
        };
        let levels = erosion.levels(&closed, &land, context.seed)?;
        let count = levels.iter().copied().max().unwrap_or(0).max(1);
        let interval = self.relief.si() / f64::from(count);
        let lattice = Lattice::of(&closed);
        let heights = heights(&lattice, &levels, interval, interval / spacing, self.interpolation, |_| false);
        terrain.change(Layer::Bedrock, |z| z.iter_mut().zip(&heights).for_each(|(z, h)| *z += h));
        terrain.fields_mut().insert(&names::LEVEL_SET, levels)?;
        Ok(terrain)
    }

    fn estimate(&self, _: &Context) -> Result<Estimate> {
        let nodes = self.grid.grid()?.len() as u64;
        Ok(Estimate {
            nodes,
            bytes: nodes * 135,
            extent: self.grid.size.map(Length::si),
            origin: Some([0.0; 2]),
            ..Estimate::default()
        })
    }
}
