//! Slip of loose slopes.
//!
//! # Model
//! Where a slope is steeper than the talus angle, the excess drop moves down: flux = c (z_i − z_j −
//! d tan α) between neighbours, with c = 1/8 a round, so that it never overshoots.
//!
//! # Method
//! All neighbours at once; what one node loses, another gains. On layered ground the material that
//! comes to rest is gravel. **Cost** 20 ns a node and round.
//!
//! # Sources
//! Musgrave, Kolb & Mace (1989), thermal weathering.
//!
//! # Checked by
//! `tests`: mass, a heap that comes to rest at the angle.

use landform_core::grid::{Domain, Neighbours, Status};
use landform_core::terrain::{Layer, NodeSurface};
use landform_core::units::{Angle, AngleDimension, YEAR};
use landform_core::verb::{Change, Context, OwnClock, Params, Process, Resolved, Source, Step, Varying};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Part of the excess that moves over a link in a round.
const PART: f64 = 0.125;
/// Talus angle where none is given, deg.
const DEFAULT_ANGLE: f64 = 34.0;
/// 85 degrees.
const STEEPEST: f64 = 85.0 * std::f64::consts::PI / 180.0;

/// Thermal erosion: loose ground slips where it is steeper than its talus angle, and comes to rest
/// below. Runs without a clock, or beside other processes with one round a step.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ThermalErosion {
    /// Steepest slope that the ground stands at; may vary in space. If not given, it is the angle
    /// of repose of the uppermost material on layered ground, and 34 deg on other ground.
    #[schemars(extend("x-above" = 0.0, "x-max" = 85.0))]
    pub talus_angle: Option<Varying<AngleDimension>>,
    /// Number of rounds, if there is no clock.
    #[schemars(extend("x-min" = 1, "x-max" = 1_000_000))]
    pub iterations: u64,
}

impl Default for ThermalErosion {
    fn default() -> Self {
        Self { talus_angle: None, iterations: 200 }
    }
}

impl Params for ThermalErosion {
    const NAME: &'static str = "thermal_erosion";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Musgrave, Kolb & Mace (1989)",
        title: "The synthesis and rendering of eroded fractal terrains, SIGGRAPH 89",
        doi: "10.1145/74333.74337",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(20)
    }
}

/// The angle on the nodes; none if materials have their own.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    angle: Option<Resolved>,
}

impl<T: NodeSurface> Process<T> for ThermalErosion {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        Some(OwnClock { dt: YEAR, rounds: self.iterations, is_timed: false })
    }

    fn start(&self, terrain: &mut T, context: &Context) -> Result<State> {
        let given = || Angle::of(DEFAULT_ANGLE).into();
        let angle = match (&self.talus_angle, terrain.layers()) {
            (None, Some(_)) => return Ok(State { angle: None }),
            (angle, _) => angle.clone().unwrap_or_else(given).resolve("talus_angle", terrain, context)?,
        };
        let z = terrain.elevation();
        let is_wrong = |i: usize| !(z[i].is_nan() || angle.at(i) > 0.0 && angle.at(i) <= STEEPEST);
        if let Some(i) = parallel::find_first(z.len(), is_wrong) {
            let expected = "an angle (rad) from 0 to 1.48, 85 deg,";
            return Err(Error::AtNode { name: "talus_angle".into(), node: i, value: angle.at(i), expected });
        }
        Ok(State { angle: Some(angle) })
    }

    fn step(&self, terrain: &mut T, state: &mut State, _: &Step) -> Result<Change> {
        let domain = terrain.domain();
        let status = domain.status();
        let z = terrain.elevation();
        let angle = |i: usize| match (&state.angle, terrain.layers()) {
            (Some(angle), _) => angle.at(i),
            (None, Some(layers)) => layers.surface(i, z[i]).repose,
            (None, None) => Angle::of(DEFAULT_ANGLE).si(),
        };
        let steepest = parallel::map(z.len(), |i| math::tan(angle(i)));
        // What moves from `i` to `j`, as a height on a node of mean size; the angle is that of the
        // ground that slips.
        let least =
            (0..z.len()).filter(|&i| status[i] != Status::Masked).map(|i| domain.area(i)).fold(f64::INFINITY, f64::min);
        let moves = |i: usize, j: usize, distance: f64| PART * least * (z[i] - z[j] - distance * steepest[i]).max(0.0);
        let gain = parallel::map(z.len(), |i| {
            if status[i] == Status::Masked {
                return 0.0;
            }
            domain.neighbours(i).map(|l| moves(l.to, i, l.distance) - moves(i, l.to, l.distance)).sum::<f64>()
        });
        let is_held = |i: usize| status[i] == Status::BaseLevel;
        let exported = parallel::sum(z.len(), |i| if is_held(i) { gain[i] } else { 0.0 });
        let volume = |sign: f64| parallel::sum(z.len(), |i| if is_held(i) { 0.0 } else { (sign * gain[i]).max(0.0) });
        let (eroded, deposited) = (volume(-1.0), volume(1.0));
        let rise = |i: usize| if is_held(i) { 0.0 } else { gain[i] / domain.area(i) };
        terrain.change(Layer::Surface("gravel"), |z| {
            parallel::update(z, |i, z| {
                if status[i] != Status::Masked {
                    *z += rise(i);
                }
            });
        });
        Ok(Change { eroded, deposited, exported, ..Change::default() })
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Edge, Edges, Grid, Shape};
    use landform_core::sim::{Simulation, Stop};
    use landform_core::terrain::HeightField;

    use super::*;

    #[test]
    fn a_heap_comes_to_rest_at_its_angle() {
        let mut grid = Grid::new(Shape::new(41, 41), [2.0; 2]).unwrap();
        grid.edges = Edges::all(Edge::Closed);
        let mut z = vec![0.0; 1681];
        for (r, c) in (16..25).flat_map(|r| (16..25).map(move |c| (r, c))) {
            z[r * 41 + c] = 30.0;
        }
        let field = HeightField::new(grid, z).unwrap();
        let mut sim =
            Simulation::new(field).process(ThermalErosion::default()).unwrap().dt(YEAR).until(Stop::steps(20_000));
        let outcome = sim.run().unwrap();
        assert!(outcome.budget.imbalance() < 1e-10 && outcome.budget.sediment_imbalance() < 1e-10);
        let z = sim.terrain().elevation();
        let steepest = (0..1680).filter(|i| i % 41 < 40).map(|i| (z[i] - z[i + 1]).abs() / 2.0).fold(0.0, f64::max);
        assert!((steepest / math::tan(34.0f64.to_radians()) - 1.0).abs() < 1e-3, "{steepest}");
        assert!(z[20 * 41 + 20] < 30.0);
    }
}
