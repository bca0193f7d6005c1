//! Deep landslides and their deposits.
//!
//! # Model
//! A node at a height h above its lowest neighbour down the steepest slope, of angle β, fails in a
//! step with the probability (h/h_c) Δt/t, at most 1, if β is above the angle of friction φ; h_c is
//! Culmann's critical height ([`stability`]). The rupture surface goes through the lower node and
//! rises at (β + φ)/2 away from it; all ground above it that hangs together slides ([`scar`]). It
//! runs down and comes to rest where the ground is less steep than the runout angle ([`runout`]).
//!
//! # Method
//! Failures are found over the surface at the start of the step, all nodes at once; draws are keyed
//! by step and node. They slide one after the other, the smallest draw first; one whose ground has
//! meanwhile become stable does not. **Cost** O(nodes + volume slid).
//!
//! # Limits
//! Ground at a base level never moves, and nothing is dug below the sea. Debris has no momentum.
//! The chance counts the drop to a neighbour, as HyLands does: halved cells fail twice as often on
//! a given area, and slides reach as far up the slope. A step should be short beside the return
//! time of what fails most readily; longer ones let all of it fail once.
//!
//! # Sources
//! Campforts et al. (2020); the runout is ours.
//!
//! # Checked by
//! `tests`: Culmann's height, wedges and bowls of known volume, cones of debris, mass, threads,
//! resuming, base levels. `cargo xtask validate`: areas of slides on a steady range of 256² nodes.
//! Above x_min their density falls with the exponents 2.6 (cells of 10 m, friction 25 degrees,
//! cohesion 10 kPa), 2.7 (40 kPa), 2.0 (20 degrees), 3.1 (cells of 20 m) and 4.0 (33 degrees).
//! Nature has 2.1 to 2.7 (Hovius et al. 1997). The curve bends all the way, steeper where slides
//! are as large as hillsides: it is one power law over a factor of ten in area at most.
//!
//! # Example
//! A cliff comes down in one step that is longer than the return time:
//!
//! ```
//! use landform_core::grid::{Edge, Edges, Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::units::MYR;
//! use landform_process::hillslope::Landslides;
//!
//! let mut grid = Grid::new(Shape::new(1, 40), [10.0, 10.0])?;
//! grid.edges = Edges::all(Edge::Closed);
//! let cliff = (0..40).map(|i| if i < 20 { 100.0 } else { 0.0 }).collect();
//! let mut model = Model::new(HeightField::new(grid, cliff)?).dt(100.0 * MYR);
//! model.add(Landslides::default())?;
//! model.advance_steps(1)?;
//! let z = model.terrain().elevation();
//! assert!(z[19] < 100.0 && z[20] > 0.0);
//! # Ok::<(), landform_core::Error>(())
//! ```

mod params;
mod runout;
mod scar;
mod stability;
#[cfg(test)]
mod tests;

use landform_core::field::names;
use landform_core::terrain::{HeightField, Layer, Mesh, NodeSurface};
use landform_core::units::Angle;
use landform_core::verb::{Change, Context, Environment, Process, Resolved, Step};
use landform_core::{Error, Result, math, parallel};
use serde::{Deserialize, Serialize};

pub use params::Landslides;
use runout::{Debris, run_out};
use scar::{Places, Rupture, Search};
use stability::Strength;

const GRAVITY: f64 = 9.81;
/// Angle of friction where none is given, deg.
const DEFAULT_FRICTION: f64 = 35.0;
/// 85 degrees.
const STEEPEST: f64 = 85.0 * std::f64::consts::PI / 180.0;

/// What slides have left so far, and scratch.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    /// Tangent of the angle of friction; none if materials have their own.
    friction: Option<Resolved>,
    /// Deposits of the run that later slides have not taken away, m.
    deposit: Vec<f64>,
    /// Area of the slide of the last step that took the node, m².
    area: Vec<f64>,
    #[serde(skip)]
    search: Search,
    #[serde(skip)]
    way: Vec<u32>,
}

/// Ground that may repeat beyond its sides.
///
/// ```
/// use landform_core::grid::{Edge, Edges};
///
/// assert!(Edges::all(Edge::Periodic).wraps_cols());
/// ```
pub trait Periodic: NodeSurface {
    /// Distance after which it repeats, east and north, m; infinite where it ends.
    fn periods(&self) -> [f64; 2];
}

impl Periodic for HeightField {
    fn periods(&self) -> [f64; 2] {
        let (grid, edges) = (self.grid(), self.grid().edges);
        let (wraps, count) = ([edges.wraps_cols(), edges.wraps_rows()], [grid.shape.cols, grid.shape.rows]);
        [0, 1].map(|k| if wraps[k] { count[k] as f64 * grid.spacing[k] } else { f64::INFINITY })
    }
}

impl Periodic for Mesh {
    fn periods(&self) -> [f64; 2] {
        [f64::INFINITY; 2]
    }
}

impl<T: Periodic> Process<T> for Landslides {
    const WRITES: &'static [&'static str] = &["elevation", "landslide_area", "landslide_deposit"];
    type State = State;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<State> {
        if self.loose {
            terrain.make_layered(&context.environment.materials);
        }
        let nodes = terrain.elevation().len();
        let nothing = || vec![0.0; nodes];
        let friction = self.friction(terrain, context)?;
        Ok(State { friction, deposit: nothing(), area: nothing(), search: Search::default(), way: Vec::new() })
    }

    fn step(&self, terrain: &mut T, state: &mut State, at: &Step) -> Result<Change> {
        let domain = terrain.domain();
        let State { friction, deposit, area, search, way } = state;
        let strength = Strength {
            cohesion_height: 4.0 * self.cohesion / (self.density * GRAVITY),
            chance: at.dt / self.return_time.si(),
        };
        let mut z = terrain.elevation().to_vec();
        let friction = tangents(friction, terrain);
        let friction = |i: usize| friction.at(i);
        let failures = strength.failures(&*domain, &z, friction, at.seed);
        parallel::fill(area, |_| 0.0);
        let sea = at.environment.sea_level_at(at.time + at.dt);
        let places = Places { position: &|i| terrain.position(i), periods: terrain.periods() };
        let rest = math::tan(self.runout_angle.si());
        let mut change = Change::default();
        for failure in &failures {
            let (node, foot) = (failure.node as usize, failure.foot as usize);
            let (slope, friction) = ((z[node] - z[foot]) / failure.distance, friction(node));
            // The ground may have slid with another.
            if !(slope > friction) {
                continue;
            }
            let rupture = Rupture {
                foot,
                slope: math::tan(0.5 * (math::atan(slope) + math::atan(friction))),
                floor: sea,
                greatest_area: self.greatest_area.map_or(f64::INFINITY, |a| a.si()),
            };
            let scar = search.dig(&*domain, &places, &rupture, &mut z);
            for &(i, depth) in &search.dug {
                let i = i as usize;
                deposit[i] = (deposit[i] - depth).max(0.0);
                area[i] = scar.area;
            }
            let volume = scar.volume * (1.0 - self.fines);
            let debris = Debris { volume, slope: rest, parts: 1e4 + 64.0 * search.dug.len() as f64 };
            let left = run_out(&*domain, foot, &debris, &mut z, way, |i, rise| deposit[i] += rise);
            change.eroded += scar.volume;
            change.deposited += volume - left;
            change.exported += scar.volume - volume + left;
        }
        if change.eroded > 0.0 {
            terrain.change(Layer::Surface("gravel"), |old| old.copy_from_slice(&z));
        }
        Ok(change)
    }

    fn finish(&self, terrain: &mut T, state: &mut State, _: &Environment) -> Result<()> {
        let z = terrain.elevation();
        let shown = |values: &[f64]| parallel::map(z.len(), |i| if z[i].is_nan() { f64::NAN } else { values[i] });
        let (deposit, area) = (shown(&state.deposit), shown(&state.area));
        let fields = terrain.fields_mut();
        fields.insert(&names::LANDSLIDE_DEPOSIT, deposit)?;
        fields.insert(&names::LANDSLIDE_AREA, area)
    }
}

impl Landslides {
    /// Tangents of the angle of friction; none if materials have their own.
    fn friction<T: NodeSurface>(&self, terrain: &T, context: &Context) -> Result<Option<Resolved>> {
        let angle = match (&self.friction_angle, terrain.layers()) {
            (None, Some(_)) => return Ok(None),
            (None, None) => Resolved::Uniform(Angle::of(DEFAULT_FRICTION).si()),
            (Some(angle), _) => angle.resolve("friction_angle", terrain, context)?,
        };
        let z = terrain.elevation();
        let is_wrong = |i: usize| !(z[i].is_nan() || angle.at(i) > 0.0 && angle.at(i) <= STEEPEST);
        if let Some(i) = parallel::find_first(z.len(), is_wrong) {
            let expected = "an angle (rad) from 0 to 1.48, 85 deg,";
            return Err(Error::AtNode { name: "friction_angle".into(), node: i, value: angle.at(i), expected });
        }
        Ok(Some(match angle {
            Resolved::Uniform(angle) => Resolved::Uniform(math::tan(angle)),
            Resolved::PerNode(angle) => Resolved::PerNode(parallel::map(angle.len(), |i| math::tan(angle[i]))),
        }))
    }
}

/// Tangents of the angle of friction as it is now.
fn tangents<'a, T: NodeSurface>(friction: &'a Option<Resolved>, terrain: &T) -> std::borrow::Cow<'a, Resolved> {
    use std::borrow::Cow;
    match (friction, terrain.layers()) {
        (Some(friction), _) => Cow::Borrowed(friction),
        (None, None) => Cow::Owned(Resolved::Uniform(math::tan(Angle::of(DEFAULT_FRICTION).si()))),
        (None, Some(layers)) => {
            let by_number: Vec<f64> = layers.materials().all().iter().map(|m| math::tan(m.repose)).collect();
            let z = terrain.elevation();
            let of = |i: usize| by_number[usize::from(layers.surface_number(i, z[i]))];
            Cow::Owned(Resolved::PerNode(parallel::map(z.len(), of)))
        }
    }
}
