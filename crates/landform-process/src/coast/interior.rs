//! The interior of islands, from the coasts that a stronger sea would leave (Pytel 2015, 4.2.4).
//!
//! # Sources
//! Pytel (2015), listing 4.1.

use landform_core::Result;
use landform_core::field::names;
use landform_core::grid::Lattice;
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::{Length, Ratio};
use landform_core::verb::{Context, Edit, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::front::flood;
use super::heights::{LevelInterpolation, heights};
use super::levels::FrontErosion;
use super::params::{CoastErosion, Exposure, Perimeter, Weakening, Whole};

/// Gives islands an interior: the coasts that a sea of growing force would leave become level sets
/// of hills. Land keeps its outline and loses the heights that it had.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct IslandInterior {
    /// Force of the sea at the start.
    #[schemars(extend("x-above" = 0.0))]
    pub force: Ratio,
    /// Damping of the sea by the length of the coast.
    #[schemars(extend("x-min" = 0.0))]
    pub damping: Ratio,
    /// Coast whose length damps the sea, as in `coast_erosion`.
    pub perimeter: Perimeter,
    /// How the resistance of sites falls with the number of their sides that the sea reaches.
    pub exposure: Exposure,
    /// Weakening of sites near one that falls, for smoother level sets.
    pub weakening: Option<Weakening>,
    /// Greatest distance of a level set from the one before.
    #[schemars(extend("x-above" = 0.0))]
    pub spacing: Length,
    /// Height from one level set to the next.
    #[schemars(extend("x-above" = 0.0))]
    pub interval: Length,
    /// How heights between level sets are found.
    pub interpolation: LevelInterpolation,
    /// Sea level. If not given, it is the environment's, or else 0 m.
    pub sea_level: Option<Length>,
}

impl Default for IslandInterior {
    fn default() -> Self {
        Self {
            force: Ratio::of(0.225),
            damping: Ratio::of(0.15),
            perimeter: Perimeter::Whole(Whole::Global),
            exposure: Exposure::Proportional,
            weakening: Some(Weakening { amount: 0.3, radius: Length::of(60.0) }),
            spacing: Length::of(100.0),
            interval: Length::of(20.0),
            interpolation: LevelInterpolation::Hermite,
            sea_level: None,
        }
    }
}

impl Params for IslandInterior {
    const NAME: &'static str = "island_interior";
    const SOURCES: &'static [Source] = CoastErosion::SOURCES;

    fn leaves(&self) -> Vec<String> {
        vec![names::LEVEL_SET.name.into()]
    }

    fn check(&self) -> Result<()> {
        CoastErosion { perimeter: self.perimeter, weakening: self.weakening, ..CoastErosion::default() }.check()
    }
}

impl Edit<HeightField> for IslandInterior {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        if let Some(w) = self.weakening {
            crate::mechanism::within_map("weakening", w.radius, terrain.grid())?;
        }
        let z = terrain.elevation();
        let level = context.environment.level_or(self.sea_level, context.time);
        let sea = flood(terrain.grid(), z, level)?;
        let land: Vec<bool> = (0..z.len()).map(|i| !sea[i] && !z[i].is_nan()).collect();
        let erosion = FrontErosion {
            force: self.force,
            damping: self.damping,
            perimeter: self.perimeter,
            exposure: self.exposure,
            weakening: self.weakening,
            spacing: self.spacing.si(),
        };
        let levels = erosion.levels(terrain.grid(), &land, context.seed)?;
        let slope = self.interval.si() / self.spacing.si();
        // The sea beyond the map's open sides.
        let (shape, edges) = (terrain.grid().shape, terrain.grid().edges);
        let shore = |i: usize| levels[i] == 1 && edges.open_sides_at(shape, i) > 0;
        let lattice = Lattice::of(terrain.grid());
        let heights = heights(&lattice, &levels, self.interval.si(), slope, self.interpolation, shore);
        terrain.change(Layer::Bedrock, |z| {
            for i in (0..land.len()).filter(|&i| land[i]) {
                z[i] = level + heights[i];
            }
        });
        terrain.fields_mut().insert(&names::LEVEL_SET, levels)
    }
}
