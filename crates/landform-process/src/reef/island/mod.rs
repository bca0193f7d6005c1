//! Coral islands from a sketch.

mod outline;
mod params;
mod profile;
#[cfg(test)]
mod tests;
mod valleys;

use landform_core::field::names;
use landform_core::grid::{Edge, Edges, Grid};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Angle, Length, Ratio};
use landform_core::verb::{Context, Estimate, Generator};
use landform_core::{Result, math, parallel};

use super::CORAL;
use super::labels::label;
use super::open_water::Shore;
use outline::Outline;
pub use params::{BandParams, CoralIsland, OutlineParams, WarpParams};
use profile::Curve;
use valleys::Valleys;

/// Parts of the radius between which the outline takes over from a circle around the summit.
const ROUND: [f64; 2] = [0.0, 0.6];

/// One island: its shape by place.
struct Island<'a> {
    params: &'a CoralIsland,
    curve: Curve,
    middle: [f64; 2],
    /// Distance of the shore without noise, m, and how much longer than in the profile.
    radius: f64,
    stretch: f64,
    /// Distance in the profile at which the reef's band ends, m.
    edge: Option<f64>,
    outline: Outline,
    valleys: Valleys,
}

/// Rock and reef at a place, heights over the sea.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Column {
    /// Height of the surface, m.
    surface: f64,
    /// Depth of coral under it, m.
    coral: f64,
}

impl<'a> Island<'a> {
    fn new(params: &'a CoralIsland, curve: &Curve, middle: [f64; 2], seed: landform_core::random::Seed) -> Self {
        let own = curve.last_at(0.0);
        let given = params.outline.radius.map(Length::si);
        let radius = given.or(own).unwrap_or_else(|| params.profile.last().map_or(1.0, |p| p[0].si())).max(1e-9);
        let stretch = own.map_or(1.0, |own| radius / own);
        let factors = params.outline.radii.iter().map(|r| r.si() / radius).collect();
        Self {
            params,
            curve: curve.clone(),
            middle,
            radius,
            stretch,
            edge: params.reef.and_then(|reef| curve.last_at(reef.low.si())),
            outline: Outline::new(seed.named("outline"), params.outline.roughness.si(), factors),
            valleys: Valleys { seed: seed.named("valleys"), radius },
        }
    }

    /// Where the wind has brought what is at a place, m from the middle.
    fn before_wind(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let Some(wind) = self.params.wind else { return [x, y] };
        let far = (x * x + y * y) / (2.0 * self.radius * self.radius);
        let drawn = wind.strength.si() * self.radius * math::exp(-far);
        let from = wind.from.si();
        [x + drawn * math::sin(from), y + drawn * math::cos(from)]
    }

    /// Rock and reef at a place, m.
    fn at(&self, [x, y]: [f64; 2]) -> Column {
        let [x, y] = self.before_wind([x - self.middle[0], y - self.middle[1]]);
        let distance = math::hypot(x, y);
        let direction = math::atan2(x, y);
        let noisy = math::smoothstep(ROUND[0], ROUND[1], distance / self.radius);
        let factor = 1.0 + noisy * (self.outline.factor(direction) - 1.0);
        let along = distance / (factor * self.stretch);
        let height = self.curve.at(along);
        let depth = Ratio::si(self.params.valleys);
        let was = if height > 0.0 && depth > 0.0 {
            height * (1.0 - depth * self.valleys.cut([x, y], direction))
        } else {
            height
        };
        let now = was - self.params.subsidence.si();
        let reef = self.params.reef.and_then(|reef| self.reef(&reef, was, along, factor));
        match reef {
            Some(top) if top > now => Column { surface: top, coral: top - now },
            _ => Column { surface: now, coral: 0.0 },
        }
    }

    /// Height of a reef that kept up, m: on the band level with low water, before it in a slope of
    /// rubble; none behind it.
    fn reef(&self, reef: &BandParams, was: f64, along: f64, factor: f64) -> Option<f64> {
        let top = -reef.low_water.si();
        let low = reef.low.si();
        if was > low {
            return (was < reef.high.si()).then_some(top);
        }
        // What lies outside of the edge, and the edge itself in spite of rounding.
        let edge = self.edge.filter(|edge| along >= edge * (1.0 - 1e-9))?;
        let before = (along - edge).max(0.0) * factor * self.stretch;
        Some(top - math::tan(Angle::si(reef.talus_angle)) * before)
    }
}

impl CoralIsland {
    fn columns(&self, grid: &Grid, context: &Context) -> Result<Vec<Column>> {
        let curve = self.curve()?;
        let whole = grid.whole().bounds();
        let middle = [0, 1].map(|k| 0.5 * (whole[0][k] + whole[1][k]));
        let mut middles: Vec<[f64; 2]> = self.at.iter().map(|p| [0, 1].map(|k| whole[0][k] + p[k].si())).collect();
        if middles.is_empty() {
            middles.push(middle);
        }
        let islands: Vec<Island> = middles
            .into_iter()
            .enumerate()
            .map(|(k, middle)| Island::new(self, &curve, middle, context.seed.with(k as u64)))
            .collect();
        Ok(parallel::map(grid.len(), |i| {
            let place = grid.position(i);
            let higher = |a: Column, b: Column| if b.surface > a.surface { b } else { a };
            islands.iter().map(|island| island.at(place)).reduce(higher).unwrap_or_default()
        }))
    }
}

impl Generator<HeightField> for CoralIsland {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let mut grid = context.wanted(self.grid.grid()?)?;
        grid.edges = Edges::all(Edge::Closed);
        let level = context.environment.level_or(self.sea_level, 0.0);
        let columns = self.columns(&grid, context)?;
        let rock = parallel::map(columns.len(), |i| level + columns[i].surface - columns[i].coral);
        let mut terrain = HeightField::new(grid, rock)?;
        let coral = if self.reef.is_some() { parallel::map(columns.len(), |i| columns[i].coral) } else { Vec::new() };
        if self.reef.is_some() {
            terrain.make_layered(&context.environment.materials);
            terrain.change_depth(CORAL, &coral)?;
        }
        let parts = label(&Shore::of(&terrain), &*terrain.domain(), terrain.elevation(), &coral, level);
        terrain.fields_mut().insert(&names::LABELS, parts)?;
        Ok(terrain)
    }

    fn estimate(&self, context: &Context) -> Result<Estimate> {
        let grid = context.wanted(self.grid.grid()?)?;
        let (nodes, extent) = (grid.len() as u64, grid.extent());
        // Columns, elevations and layers, labels with their distances.
        Ok(Estimate { nodes, bytes: 90 * nodes, extent, origin: Some([0.0; 2]), ..Estimate::default() })
    }
}
