//! Creep that grows without limit towards a critical slope.
//!
//! Crests are round, hillsides below them nearly straight: where slopes are steep, material slides rather than creeps.
//!
//! # Model
//! ∂z/∂t = ∇·(D ∇z/(1 − (S/S_c)²)), with z held at base levels and no flux across closed sides and around holes. Beyond 0.995 S_c
//! the factor stays at 100.
//!
//! # Method
//! Backward Euler: the factor is that of the slope at the end of the step, found by repeated linear steps, each with the geometric
//! mean of the factors of the last two, until no node moves by more than a millimetre. Slopes by central differences at nodes, the
//! factor of a face is the mean of its ends.
//!
//! # Limits
//! Rasters only. All ground creeps alike, rock too. On layered ground the deposit is soil.
//!
//! # Sources
//! Roering, Kirchner & Dietrich (1999), eq. 8; Perron (2011) for implicit steps.
//!
//! # Checked by
//! `tests`: the steady profile from parabola to plane, mass, long steps.

use landform_core::algo::derivative::gradient_of_four;
use landform_core::grid::Domain;
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Diffusivity, DiffusivityDimension};
use landform_core::verb::{Change, Context, Params, Process, Resolved, Source, Step, Varying};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::implicit::System;

/// Greatest factor of the diffusivity.
const GREATEST: f64 = 100.0;
const MOST_ROUNDS: usize = 12;
/// Change between two rounds that ends them, m.
const CLOSE: f64 = 1e-3;

/// Nonlinear creep: ground moves downhill the faster the nearer its slope comes to a critical one. Round crests, straight hillsides.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct NonlinearDiffusion {
    /// Diffusivity D on gentle slopes; may vary in space or change in time.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e6))]
    pub diffusivity: Varying<DiffusivityDimension>,
    /// Critical slope S_c, rise over run.
    #[schemars(extend("x-above" = 0.0, "x-max" = 20.0))]
    pub critical_slope: f64,
}

impl Default for NonlinearDiffusion {
    fn default() -> Self {
        Self { diffusivity: Diffusivity::of(0.01).into(), critical_slope: 1.2 }
    }
}

impl Params for NonlinearDiffusion {
    const NAME: &'static str = "nonlinear_diffusion";
    const IN_TIME: &'static [&'static str] = &["diffusivity"];
    const SOURCES: &'static [Source] = &[
        Source {
            authors: "Roering, Kirchner & Dietrich (1999)",
            title: "Evidence for nonlinear, diffusive sediment transport on hillslopes and implications for landscape morphology, Water Resources Research 35(3)",
            doi: "10.1029/1998WR900090",
        },
        Source {
            authors: "Perron (2011)",
            title: "Numerical methods for nonlinear hillslope transport laws, JGR Earth Surface 116",
            doi: "10.1029/2010JF001801",
        },
    ];
}

/// Diffusivity on the nodes.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    diffusivity: Resolved,
}

impl Process<HeightField> for NonlinearDiffusion {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        let diffusivity = self.diffusivity.resolve("diffusivity", terrain, context)?;
        if let Resolved::PerNode(d) = &diffusivity
            && let Some(i) = parallel::find_first(d.len(), |i| d[i] < 0.0)
        {
            return Err(Error::parameter("diffusivity", format!("negative at node {i}"), "at least 0 everywhere"));
        }
        Ok(State { diffusivity })
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        if let Some(now) = self.diffusivity.in_time(at.time, at.time + at.dt) {
            state.diffusivity = Resolved::Uniform(now);
        }
        let (domain, grid) = (terrain.domain(), terrain.grid().clone());
        let heights =
            domain.centres().map_or(terrain.elevation().to_vec(), |centres| centres.values(terrain.elevation()));
        let factor = |z: &[f64]| {
            parallel::map(z.len(), |i| {
                let slope = gradient_of_four(&grid, z, i).slope() / self.critical_slope;
                let left = 1.0 - slope * slope;
                // Beside nodata there is no slope.
                if left.is_nan() { 1.0 } else { 1.0 / left.max(1.0 / GREATEST) }
            })
        };
        let mut factors = factor(&heights);
        let mut before: Option<Vec<f64>> = None;
        let mut rounds = 0;
        loop {
            let varied = parallel::map(heights.len(), |i| factors[i] * state.diffusivity.at(i));
            let mut system = System::new(&*domain, &Resolved::PerNode(varied));
            let [rise, end] = system.rise(&heights, at.dt)?;
            let moved = |old: &Vec<f64>| parallel::max(rise.len(), |i| (rise[i] - old[i]).abs());
            rounds += 1;
            if rounds == MOST_ROUNDS || before.as_ref().is_some_and(|old| moved(old) < CLOSE) {
                return Ok(system.settle(terrain, &heights, &rise, &end, at.dt));
            }
            let after = parallel::map(rise.len(), |i| heights[i] + rise[i]);
            let new = factor(&after);
            parallel::update(&mut factors, |i, f| *f = (*f * new[i]).sqrt());
            before = Some(rise);
        }
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Edge, Edges, Grid, Shape};
    use landform_core::sim::{Simulation, Stop};
    use landform_core::units::{KYR, Rate, YEAR};

    use super::*;
    use crate::uplift::Uplift;

    fn strip(n: usize, dx: f64, z: Vec<f64>) -> HeightField {
        let mut grid = Grid::new(Shape::new(3, n), [dx, dx]).unwrap();
        grid.edges = Edges { north: Edge::Closed, south: Edge::Closed, ..Edges::default() };
        HeightField::new(grid, z).unwrap()
    }

    #[test]
    fn uplift_and_creep_go_from_a_parabola_to_a_plane() {
        // Roering et al. (1999): D S/(1 − (S/S_c)²) = U x from the crest, so S/S_c = (√(1 + 4a²) − 1)/(2a), a = U x/(D S_c).
        let (n, dx, critical) = (201, 2.0, 0.8);
        let (uplift, diffusivity) = (0.2e-3 / YEAR, 0.01 / YEAR);
        let creep = NonlinearDiffusion { diffusivity: Diffusivity::of(0.01).into(), critical_slope: critical };
        let mut sim = Simulation::new(strip(n, dx, vec![0.0; 3 * n]))
            .process(Uplift { rate: Rate::of(0.2).into() })
            .unwrap()
            .process(creep)
            .unwrap()
            .dt(200.0 * KYR)
            .until(Stop::steps(200));
        let outcome = sim.run().unwrap();
        assert!(outcome.budget.imbalance() < 1e-10 && outcome.budget.sediment_imbalance() < 1e-9);
        let z = &sim.terrain().elevation()[n..2 * n];
        let slope = |x: f64| {
            let a = uplift * x / (diffusivity * critical);
            critical * ((1.0 + 4.0 * a * a).sqrt() - 1.0) / (2.0 * a)
        };
        let mut steepest = 0.0_f64;
        for k in 101..200 {
            let x = (k as f64 + 0.5 - 100.0) * dx;
            let found = (z[k] - z[k + 1]) / dx;
            assert!((found / slope(x) - 1.0).abs() < 0.01, "{x}: {found} {}", slope(x));
            steepest = steepest.max(found);
        }
        // Far from the crest it is nearly the plane.
        assert!(steepest > 0.88 * critical && steepest < critical, "{steepest}");
    }

    #[test]
    fn a_cliff_comes_down_without_overshoot_in_one_long_step() {
        let n = 60;
        let z: Vec<f64> = (0..3 * n).map(|i| if i % n < n / 2 { 100.0 } else { 0.0 }).collect();
        let mut sim = Simulation::new(strip(n, 10.0, z))
            .process(NonlinearDiffusion::default())
            .unwrap()
            .dt(100.0 * KYR)
            .until(Stop::steps(3));
        let outcome = sim.run().unwrap();
        let z = sim.terrain().elevation();
        assert!(z.iter().all(|z| (-1e-9..=100.0 + 1e-9).contains(z)));
        assert!(outcome.budget.sediment_imbalance() < 1e-9);
        assert!((n + 1..2 * n).all(|i| z[i] <= z[i - 1] + 1e-9), "it falls all the way");
    }
}
