//! Removal of small islands.

use landform_core::Result;
use landform_core::agents::{Connectivity, RasterSites};
use landform_core::grid::Neighbours;
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::front::flood;

/// Removes islands with a short coast, of which `coast_erosion` leaves many; the sea covers them.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct PruneIslands {
    /// Islands with a shorter coast are removed. If not given, it is 24 cells.
    #[schemars(extend("x-min" = 0.0))]
    pub perimeter: Option<Length>,
    /// Sea level. If not given, it is the environment's, or else 0 m.
    pub sea_level: Option<Length>,
    /// Depth of the water where islands were.
    #[schemars(extend("x-above" = 0.0))]
    pub depth: Length,
}

impl Default for PruneIslands {
    fn default() -> Self {
        Self { perimeter: None, sea_level: None, depth: Length::of(5.0) }
    }
}

impl Params for PruneIslands {
    const NAME: &'static str = "prune_islands";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Pytel (2015)",
        title: "Erosion, Self-Organization, and Procedural Modeling, thesis, University of Waterloo, section 4.2.1",
        doi: "",
    }];
}

impl Edit<HeightField> for PruneIslands {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        let level = context.environment.level_or(self.sea_level, context.time);
        let sea = flood(terrain.grid(), terrain.elevation(), level)?;
        let sites = RasterSites::new(terrain.grid(), Connectivity::Four)?;
        let cell = 0.5 * (terrain.grid().spacing[0] + terrain.grid().spacing[1]);
        let least = self.perimeter.map_or(24.0 * cell, Length::si);
        let mut seen = sea.clone();
        for first in 0..sea.len() {
            if std::mem::replace(&mut seen[first], true) {
                continue;
            }
            let (mut island, mut next, mut sides) = (vec![first], 0, 0);
            while let Some(&site) = island.get(next) {
                next += 1;
                // Beyond the map lies the sea.
                sides += 4 - sites.neighbours(site).count();
                for near in sites.neighbours(site) {
                    if sea[near.to] {
                        sides += 1;
                    } else if !std::mem::replace(&mut seen[near.to], true) {
                        island.push(near.to);
                    }
                }
            }
            if sides as f64 * cell < least {
                let floor = level - self.depth.si();
                terrain.change(Layer::Surface("sediment"), |z| {
                    island
                        .iter()
                        .for_each(|&site| z[site] = if z[site].is_nan() { z[site] } else { z[site].min(floor) });
                });
            }
        }
        Ok(())
    }
}
