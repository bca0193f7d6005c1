//! Snow.
//!
//! # Model
//! A winter is a series of storms. In each, snow falls: in full above the snow line, less below it,
//! none a band further down. Snowfall grows with height. Wind takes up snow until it carries as
//! much as its strength allows, and deposits it where it slackens, in the lee of ridges and in
//! hollows. Snow that its slope cannot hold slides: the steeper the slope, the less stays. It comes
//! to rest where the ground levels out.
//!
//! # Method
//! Strength of the wind from the shelter of the ground upwind (a shadow at 15 degrees) and from its
//! slope along the wind, swept downwind with what it carries; what a line passes on is split
//! between the two nodes beside where it arrives, so snow is conserved to rounding. Slides visit
//! nodes from the highest surface down, once a storm; snow that does not hold goes to lower
//! neighbours in proportion to slope. **Cost** O(n log n) a storm.
//!
//! # Limits
//! Snow is one depth of one density; elevation and volumes count its surface. Rounds are storms and
//! have no length in time: with a clock, each step is a storm. Snow that falls on the sea does not
//! melt. Wind from beyond the map comes loaded: what drifts in over the sides and out is booked,
//! and the map may gain (0.12 % in the gallery's recipe).
//!
//! # Sources
//! Bernhardt & Schulz (2010), SnowSlide, for holding depths that fall with slope; Winstral, Elder &
//! Davis (2002) for shelter by upwind ground; Koh (2002), 2.3, who planned all this. How repose
//! depends on wetness is ours: fresh dry snow holds to 38 degrees, moist snow sticks to 50, soaked
//! snow runs at 20.
//!
//! # Checked by
//! `tests`: mass, level plains stay level, less on steeper ground, lee against windward, spread of
//! depths.
//!
//! # Example
//! Two of the winter's twenty storms bring a tenth of its 3 m to a level plain at the snow line:
//!
//! ```
//! use landform_core::grid::{Edge, Edges, Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::units::Length;
//! use landform_process::snow::Snow;
//!
//! let mut grid = Grid::new(Shape::new(9, 9), [10.0, 10.0])?;
//! grid.edges = Edges::all(Edge::Closed);
//! let mut model = Model::new(HeightField::new(grid, vec![100.0; 81])?).dt(1.0);
//! model.add(Snow { snow_line: Some(Length::of(100.0)), ..Snow::default() })?;
//! model.advance_steps(2)?;
//! let depth = model.terrain().depth("snow").map(|d| d[40]);
//! assert!(depth.is_some_and(|d| (d - 0.3).abs() < 1e-6));
//! # Ok::<(), landform_core::Error>(())
//! ```

#[cfg(test)]
mod tests;

use landform_core::algo::derivative::gradient;
use landform_core::grid::Grid;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Angle, Length, LengthDimension, Ratio, YEAR};
use landform_core::verb::{
    Change, Context, Environment, OwnClock, Params, Process, Resolved, Rose, Source, Step, Varying, Wind,
};
use landform_core::{Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::mechanism::wind::WindScan;

landform_core::stages! {
    process Snow where HeightField;
}

/// A winter's snow: it grows with height, drifts with the wind and slides off steep ground. Its
/// depth is a layer on the ground. Runs without a clock; one round is a storm.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Snow {
    /// Total depth of snow that falls above the snow line.
    #[schemars(extend("x-min" = 0.0))]
    pub snowfall: Varying<LengthDimension>,
    /// Number of storms that bring it.
    #[schemars(extend("x-min" = 1, "x-max" = 10000))]
    pub iterations: u64,
    /// Elevation above which all precipitation is snow. If not given, it is the elevation at which
    /// the environment's temperature is 0 degrees Celsius, or else 0 m.
    pub snow_line: Option<Length>,
    /// Height below the snow line at which no snow falls any more.
    #[schemars(extend("x-min" = 0.0))]
    pub band: Length,
    /// Fraction by which snowfall grows for each km above the snow line.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1000.0))]
    pub growth: f64,
    /// Depth that melts in the winter at the foot of the band. Nothing melts at the snow line.
    #[schemars(extend("x-min" = 0.0))]
    pub melt: Length,
    /// Winds, and the fraction of the storms that each brings.
    pub wind: Vec<Wind>,
    /// Greatest fraction of a storm's snow that the wind takes from open ground.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub drift: f64,
    /// Distance over which the wind takes up its load and deposits it.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1e6))]
    pub carry: Length,
    /// How wet the snow is: 0 dry, 0.3 moist and sticking, 1 soaked.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub wetness: Ratio,
    /// Angle of the wind shadow behind a rise: the wind does not reach the ground below it.
    #[schemars(extend("x-above" = 0.0, "x-max" = 80.0))]
    pub shadow: Angle,
}

impl Default for Snow {
    fn default() -> Self {
        Self {
            snowfall: Length::of(3.0).into(),
            iterations: 20,
            snow_line: None,
            band: Length::of(200.0),
            growth: 0.3,
            melt: Length::of(0.0),
            wind: Vec::new(),
            drift: 0.6,
            carry: Length::of(60.0),
            wetness: Ratio::of(0.1),
            shadow: Angle::of(15.0),
        }
    }
}

impl Params for Snow {
    const NAME: &'static str = "snow";
    const RENAMED: &'static [(&'static str, &'static str)] = &[("storms", "iterations")];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Bernhardt & Schulz (2010)",
            title: "SnowSlide: a simple routine for calculating gravitational snow transport, Geophysical Research Letters 37",
            doi: "10.1029/2010GL043086",
        },
        Source {
            authors: "Winstral, Elder & Davis (2002)",
            title: "Spatial snow modeling of wind-redistributed snow using terrain-based parameters, Journal of Hydrometeorology 3",
            doi: "",
        },
    ];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(62)
    }

    fn check(&self) -> Result<()> {
        if self.wind.is_empty() { Ok(()) } else { Rose::new("wind", &self.wind).map(drop) }
    }
}

/// The layer that falls.
const SNOW: &str = "snow";

/// Snowfall, and the seed of its random draws.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    snowfall: Resolved,
    seed: Seed,
}

impl Process<HeightField> for Snow {
    const WRITES: &'static [&'static str] = &["elevation", "snow_depth", "surface_material"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        Some(OwnClock { dt: YEAR / self.iterations as f64, rounds: self.iterations, is_timed: false })
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        let n = terrain.grid().len();
        let snowfall = self.snowfall.resolve("snowfall", terrain, context)?;
        terrain.make_layered(&context.environment.materials);
        let depth = terrain.depth(SNOW).map_or_else(|| vec![0.0; n], <[f64]>::to_vec);
        terrain.change_depth(SNOW, &depth)?;
        Ok(State { snowfall, seed: context.seed })
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        let rose = at.environment.rose(&self.wind)?;
        let line = self.line(&at.environment);
        let wind = rose.winds()[rose.draw(state.seed.named("wind"), at.index)].towards();
        let n = terrain.grid().len();
        let before = terrain.depth(SNOW).map_or_else(|| vec![0.0; n], <[f64]>::to_vec);
        let mut depth = before.clone();
        let ground: Vec<f64> = (0..n).map(|i| terrain.elevation()[i] - before[i]).collect();
        let fallen = self.fall(&ground, &state.snowfall, line);
        depth.iter_mut().zip(&fallen).for_each(|(d, f)| *d += f);
        let melted = self.thaw(&ground, &mut depth, line);
        let blown = self.blow(terrain, &ground, &fallen, &mut depth, wind);
        slide(terrain.grid(), &ground, &mut depth, holding_angle(self.wetness.si()));
        let area = terrain.grid().cell_area();
        let sum = |f: &(dyn Fn(usize) -> f64 + Sync)| {
            parallel::sum(n, |i| if ground[i].is_nan() { 0.0 } else { f(i) }) * area
        };
        let lost = sum(&|i| (before[i] + fallen[i] - depth[i]).max(0.0));
        let supplied = sum(&|i| fallen[i]);
        terrain.change_depth(SNOW, &depth)?;
        // Volume changes by supplied + deposited - eroded, and what was taken up was laid down or
        // left.
        let exported = (melted + blown) * area;
        let moved = lost.max(exported);
        Ok(Change { supplied, eroded: moved, deposited: moved - exported, exported, ..Change::default() })
    }
}

/// The slope up to which snow holds, radians.
fn holding_angle(wetness: f64) -> f64 {
    let degrees = if wetness < 0.3 { 38.0 + 12.0 * wetness / 0.3 } else { 50.0 - 30.0 * (wetness - 0.3) / 0.7 };
    degrees.to_radians()
}

impl Snow {
    /// Elevation of the snow line, m.
    fn line(&self, environment: &Environment) -> f64 {
        self.snow_line.map(Length::si).or(environment.freezing_level()).unwrap_or(0.0)
    }

    /// Snow of one storm on every node.
    fn fall(&self, ground: &[f64], snowfall: &Resolved, line: f64) -> Vec<f64> {
        let band = self.band.si();
        parallel::map(ground.len(), |i| {
            let z = ground[i];
            if z.is_nan() {
                return 0.0;
            }
            let frozen =
                if band > 0.0 { ((z - line + band) / band).clamp(0.0, 1.0) } else { f64::from(u8::from(z >= line)) };
            let more = 1.0 + self.growth * (z - line).max(0.0) / 1000.0;
            snowfall.at(i).max(0.0) / self.iterations as f64 * frozen * more
        })
    }

    /// Melts; the depth that went, summed over nodes.
    fn thaw(&self, ground: &[f64], depth: &mut [f64], line: f64) -> f64 {
        let most = self.melt.si() / self.iterations as f64;
        if most == 0.0 {
            return 0.0;
        }
        let mut gone = 0.0;
        for i in 0..ground.len() {
            let warmth = ((line - ground[i]) / self.band.si().max(1e-9)).max(0.0);
            let melted = (most * warmth).min(depth[i]);
            if melted > 0.0 {
                depth[i] -= melted;
                gone += melted;
            }
        }
        gone
    }

    /// Sweeps snow downwind; the depth that left over the sides, summed over nodes.
    fn blow(&self, terrain: &HeightField, ground: &[f64], fresh: &[f64], depth: &mut [f64], towards: [f64; 2]) -> f64 {
        let grid = terrain.grid();
        let sweep = WindScan::new(grid.shape, grid.spacing, false, towards);
        let surface: Vec<f64> = (0..ground.len()).map(|i| ground[i] + depth[i]).collect();
        let mut shelter = vec![0.0f32; surface.len()];
        let fall = (math::tan(self.shadow.si()) * sweep.line_spacing) as f32;
        let heights = |first: usize, run: &mut [f32]| {
            for (h, &z) in run.iter_mut().zip(&surface[first..]) {
                *h = if z.is_nan() { f32::NEG_INFINITY } else { z as f32 };
            }
        };
        // Relief only matters on a torus.
        sweep.shelter(heights, 0.0, fall, |first, air| shelter[first..first + air.len()].copy_from_slice(air));
        let slope = parallel::map(surface.len(), |i| {
            let g = gradient(grid, &surface, i);
            let along = g.x * towards[0] + g.y * towards[1];
            if along.is_nan() { 0.0 } else { along }
        });
        // 1 in the open; faster up a slope that faces the wind, slower down one that turns from it,
        // and little in shelter.
        let strength = |i: usize| {
            let hidden = (f64::from(shelter[i]) - surface[i]).max(0.0);
            let open = math::exp(-hidden / 4.0);
            (open * (1.0 + 1.5 * slope[i])).clamp(0.0, 2.0)
        };
        let part = 1.0 - math::exp(-sweep.line_spacing / self.carry.si());
        // Loads are depths on one node, gathered over the distance in which wind loads up.
        let capacity = |i: usize| self.drift * strength(i) * fresh[i] / part;
        let (lines, length) = sweep.scan_lines();
        let (mut load, mut next) = (vec![0.0; length], vec![0.0; length]);
        let mut left = 0.0;
        // How much of what arrives at a node came from nodes of the map; the rest is wind from
        // beyond, which has its load already.
        let (mut known, mut next_known) = (vec![0.0; length], vec![0.0; length]);
        for line in 0..lines {
            next.fill(0.0);
            next_known.fill(0.0);
            for at in 0..length {
                let i = sweep.node(line, at);
                if !ground[i].is_nan() {
                    let brought = (1.0f64 - known[at]).max(0.0) * capacity(i);
                    load[at] += brought;
                    left -= brought;
                    let taken = (part * (capacity(i) - load[at])).max(-load[at]).min(depth[i]);
                    depth[i] -= taken;
                    load[at] += taken;
                }
                // To the two nodes beside where it arrives.
                let to = at as f64 + sweep.lateral_offset();
                let low = to.floor();
                for (node, share) in [(low, 1.0 - (to - low)), (low + 1.0, to - low)] {
                    let amount = load[at] * share;
                    if line + 1 < lines && node >= 0.0 && node < length as f64 {
                        next[node as usize] += amount;
                        next_known[node as usize] += share;
                    } else {
                        left += amount;
                    }
                }
            }
            std::mem::swap(&mut load, &mut next);
            std::mem::swap(&mut known, &mut next_known);
        }
        left
    }
}

/// Lets snow slide that its slope does not hold, from the highest down.
fn slide(grid: &Grid, ground: &[f64], depth: &mut [f64], holds: f64) {
    let mut order: Vec<u32> = (0..ground.len() as u32).filter(|&i| ground[i as usize].is_finite()).collect();
    let surface: Vec<f64> = (0..ground.len()).map(|i| ground[i] + depth[i]).collect();
    parallel::sort_by(&mut order, |&a, &b| surface[b as usize].total_cmp(&surface[a as usize]).then(a.cmp(&b)));
    let shape = grid.shape;
    let around = [(-1i64, -1i64), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)]
        .map(|(r, c)| (r, c, math::hypot(c as f64 * grid.spacing[0], r as f64 * grid.spacing[1])));
    for i in order.into_iter().map(|i| i as usize) {
        let cell = shape.cell(i);
        let mut lower = [(0usize, 0.0f64); 8];
        let (mut count, mut total, mut steepest) = (0, 0.0, 0.0f64);
        for (r, c, distance) in around {
            let (rr, cc) = (cell.row as i64 + r, cell.col as i64 + c);
            if rr < 0 || cc < 0 || rr >= shape.rows as i64 || cc >= shape.cols as i64 {
                continue;
            }
            let j = shape.index(rr as usize, cc as usize);
            let slope = (ground[i] + depth[i] - ground[j] - depth[j]) / distance;
            if slope > 0.0 {
                lower[count] = (j, slope);
                count += 1;
                total += slope;
                steepest = steepest.max(slope);
            }
        }
        let held = holding_depth(steepest, holds);
        let excess = (depth[i] - held).max(0.0);
        if excess > 0.0 && count > 0 {
            depth[i] -= excess;
            for &(j, slope) in &lower[..count] {
                depth[j] += excess * slope / total;
            }
        }
    }
}

/// Depth that a slope holds, m: anything well below the angle, a metre at it, next to nothing 15
/// degrees above.
fn holding_depth(slope: f64, holds: f64) -> f64 {
    let over = (math::atan(slope) - holds).to_degrees();
    if over < -12.0 { f64::INFINITY } else { math::exp(-0.35 * over) }
}
