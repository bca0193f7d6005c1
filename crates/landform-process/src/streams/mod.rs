//! Koh's stream automaton.
//!
//! # Model
//! A pass floods the land: every cell gets a unit of water. In each step water moves to the lowest
//! neighbour and takes a unit of height with it; pits absorb it. The pass ends when no water is
//! left.
//!
//! # Method
//! All cells at once, from the heights at the start of the step. A cell loses at most half of its
//! drop. (By Koh's own rule it loses a whole unit: it could fall below its neighbour, and both
//! would be lowered for ever.) Water leaves over open sides.
//!
//! # Limits
//! A cell has water or none: flows that meet become one unit. So the erosion of a cell follows the
//! length of the path above it, not its drainage area. With `counted`, units add up.
//!
//! # Sources
//! Koh (2002), 5.1, figures 9 to 13 (the softness map).
//!
//! # Checked by
//! `tests`: passes end, removed volume is unit times moves (where half a drop is more), softness
//! scales it, no drilling.

#[cfg(test)]
mod tests;

use landform_core::field::names;
use landform_core::grid::{Domain, Neighbours, RasterDomain, Status};
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::{Length, Ratio, RatioDimension, YEAR};
use landform_core::verb::{Change, Context, OwnClock, Params, Process, Resolved, Source, Step, Varying};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

landform_core::stages! {
    process StreamAutomaton where HeightField;
}

/// Gullies by a simple automaton: the land is flooded, and water moves to the lowest neighbour and
/// takes some height with it. Runs without a clock; one round is a flooding.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct StreamAutomaton {
    /// Number of floodings.
    #[schemars(extend("x-min" = 1, "x-max" = 100_000))]
    pub iterations: u64,
    /// Height that a unit of water takes from a cell it leaves.
    #[schemars(extend("x-above" = 0.0))]
    pub unit: Length,
    /// Factor on the unit: how easily the ground erodes; may vary in space.
    #[schemars(extend("x-min" = 0.0))]
    pub softness: Varying<RatioDimension>,
    /// Whether units of water that meet add up.
    pub counted: bool,
    /// Whether the whole land is flooded; otherwise only `springs` bring water.
    pub flood: bool,
    /// Positions where water is added in every step of the first part of a pass.
    pub springs: Vec<[Length; 2]>,
    /// Steps of a pass in which springs run.
    #[schemars(extend("x-min" = 0, "x-max" = 1_000_000))]
    pub spring_steps: u64,
}

impl Default for StreamAutomaton {
    fn default() -> Self {
        Self {
            iterations: 1,
            unit: Length::of(0.25),
            softness: Ratio::of(1.0).into(),
            counted: false,
            flood: true,
            springs: Vec::new(),
            spring_steps: 200,
        }
    }
}

impl Params for StreamAutomaton {
    const NAME: &'static str = "stream_automaton";
    const RENAMED: &'static [(&'static str, &'static str)] = &[("passes", "iterations")];
    const SOURCES: &'static [Source] = &[Source {
        authors: "Koh (2002)",
        title: "Dramatic Landscapes: Cellular Automata Modeling of Landscape Phenomena, thesis, Monash University, section 5.1",
        doi: "",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(65)
    }

    fn places(&self) -> Vec<(&'static str, [f64; 2])> {
        self.springs.iter().map(|at| ("springs", at.map(Length::si))).collect()
    }

    fn check(&self) -> Result<()> {
        if !self.flood && (self.springs.is_empty() || self.spring_steps == 0) {
            return Err(Error::parameter(
                "flood",
                "false, without springs that run",
                "true, or springs and `spring_steps`",
            ));
        }
        Ok(())
    }
}

/// Softness, springs, and how often water left each cell.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    softness: Resolved,
    springs: Vec<usize>,
    /// Units of water that have left each cell in all passes.
    moves: Vec<f64>,
}

impl Process<HeightField> for StreamAutomaton {
    const WRITES: &'static [&'static str] = &["elevation", "stream_visits"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        Some(OwnClock { dt: YEAR, rounds: self.iterations, is_timed: false })
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        let softness = self.softness.resolve("softness", terrain, context)?;
        let status = terrain.domain().status().to_vec();
        let springs = self.springs.iter().map(|at| {
            let at = at.map(Length::si);
            terrain.grid().node_at(at).filter(|&i| status[i] == Status::Interior).ok_or_else(|| {
                let value = format!("one at {:.0}, {:.0} m", at[0], at[1]);
                Error::parameter("springs", value, "a place inside the map, not on its open border")
            })
        });
        let springs = springs.collect::<Result<_>>()?;
        Ok(State { softness, springs, moves: vec![0.0; terrain.grid().len()] })
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, _: &Step) -> Result<Change> {
        let domain = terrain.domain();
        let taken = terrain.change(Layer::Surface("sediment"), |z| self.pass(&domain, z, state));
        let eroded = taken * terrain.grid().cell_area();
        terrain.fields_mut().insert(&names::STREAM_VISITS, state.moves.clone())?;
        Ok(Change { eroded, exported: eroded, ..Change::default() })
    }
}

impl StreamAutomaton {
    /// One flooding; the sum of heights taken.
    fn pass(&self, domain: &RasterDomain, z: &mut [f64], state: &mut State) -> f64 {
        let status = domain.status();
        let mut water: Vec<f64> =
            (0..z.len()).map(|i| f64::from(u8::from(self.flood && status[i] == Status::Interior))).collect();
        let mut wet: Vec<usize> = (0..z.len()).filter(|&i| water[i] > 0.0).collect();
        let mut removed = 0.0;
        for step in 0..z.len() as u64 + self.spring_steps {
            if step < self.spring_steps {
                for &i in &state.springs {
                    if water[i] == 0.0 {
                        wet.push(i);
                    }
                    water[i] = if self.counted { water[i] + 1.0 } else { 1.0 };
                }
            } else if wet.is_empty() {
                break;
            }
            // All cells choose before any water moves.
            let moves: Vec<Option<(usize, f64)>> = parallel::map(wet.len(), |k| {
                let i = wet[k];
                let lowest =
                    domain.neighbours(i).min_by(|a, b| z[a.to].total_cmp(&z[b.to]).then(a.slot.cmp(&b.slot)))?;
                let drop = z[i] - z[lowest.to];
                let unit = self.unit.si() * state.softness.at(i) * water[i];
                (drop > 0.0).then(|| (lowest.to, unit.min(0.5 * drop)))
            });
            let units: Vec<f64> = wet.iter().map(|&i| std::mem::take(&mut water[i])).collect();
            let mut next = Vec::with_capacity(wet.len());
            for ((&i, moved), units) in wet.iter().zip(&moves).zip(units) {
                let Some((to, height)) = *moved else { continue };
                z[i] -= height;
                removed += height;
                state.moves[i] += units;
                if status[to] == Status::Interior {
                    if water[to] == 0.0 {
                        next.push(to);
                    }
                    water[to] = if self.counted { water[to] + units } else { 1.0 };
                }
            }
            next.sort_unstable();
            wet = next;
        }
        removed
    }
}
