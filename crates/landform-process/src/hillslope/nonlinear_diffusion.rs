//! Creep that grows without limit towards a critical slope.
//!
//! Crests are round, hillsides below them nearly straight: where slopes are steep, material slides
//! rather than creeps.
//!
//! # Model
//! ∂z/∂t = ∇·(D ∇z/(1 − (S/S_c)²)), with z held at base levels and no flux across closed sides and
//! around holes. Beyond 0.97 S_c the flux goes on along its tangent.
//!
//! # Method
//! Backward Euler by Newton's iteration: fluxes over the four faces of a cell with the whole
//! gradient there, their derivative by the slope normal to the face; each linear system as for
//! linear creep ([`super::implicit`]), but only to a fiftieth, until no node moves by 0.1 mm.
//! Volumes follow from the fluxes of the last iteration. **Cost** a few linear systems a step.
//!
//! # Limits
//! Rasters whose sides do not wrap. All ground creeps alike, rock too. On layered ground the
//! deposit is soil.
//!
//! # Sources
//! Roering, Kirchner & Dietrich (1999), eq. 8; Perron (2011) for implicit steps.
//!
//! # Checked by
//! `tests`: the steady profile from parabola to plane, mass, long steps.

use landform_core::grid::{Domain, Grid, Status};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Diffusivity, DiffusivityDimension};
use landform_core::verb::{Change, Context, Params, Process, Resolved, Source, Step, Varying};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::implicit::{Cells, Rows, resolve_diffusivity};

/// Slope over the critical one beyond which the flux goes on along its tangent.
const TANGENT: f64 = 0.97;
const MAX_ITERATIONS: usize = 80;
/// Error of an iteration's linear system over the greatest change: the next iteration mends it.
const ENOUGH: f64 = 0.02;
/// Greatest change of an iteration that ends them, m.
const TOLERANCE: f64 = 1e-4;

/// Nonlinear creep: ground moves downhill the faster the nearer its slope comes to a critical one.
/// Round crests, straight hillsides.
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

    fn bytes_a_node(&self) -> Option<u64> {
        Some(160)
    }
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
        let diffusivity = resolve_diffusivity(&self.diffusivity, terrain, context)?;
        Ok(State { diffusivity })
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        if let Some(now) = self.diffusivity.in_time(at.time, at.time + at.dt) {
            state.diffusivity = Resolved::Uniform(now);
        }
        let (domain, grid) = (terrain.domain(), terrain.grid().clone());
        let Some(shape) = domain.five_point() else {
            return Err(Error::parameter("edges", "sides that wrap", "open or closed sides for `nonlinear_diffusion`"));
        };
        let cells = Cells::new(&*domain);
        let start = cells.heights(terrain.elevation()).into_owned();
        let status = domain.status();
        let flux = Fluxes { grid: &grid, status, diffusivity: &state.diffusivity, critical: self.critical_slope };
        let (mut z, area) = (start.clone(), grid.cell_area());
        let mut rows = Rows::unlinked(shape, area);
        for _ in 0..MAX_ITERATIONS {
            let faces = flux.faces(&z);
            let into = flux.inflow(&faces);
            rows.link(status, |i| faces[i].conductance);
            let inner = |i: usize| status[i] == Status::Interior;
            let residual =
                parallel::map(z.len(), |i| if inner(i) { into[i] - (z[i] - start[i]) * area / at.dt } else { 0.0 });
            let change = rows.change_by(&residual, at.dt, ENOUGH)?;
            let moved = parallel::max(change.len(), |i| change[i].abs());
            parallel::update(&mut z, |i, z| *z += change[i]);
            if moved < TOLERANCE {
                let into = flux.inflow(&flux.faces(&z));
                let change = parallel::map(z.len(), |i| if inner(i) { into[i] * at.dt / area } else { 0.0 });
                let held = |i: usize| status[i] == Status::BaseLevel;
                let exported = parallel::sum(z.len(), |i| if held(i) { into[i] * at.dt } else { 0.0 });
                return Ok(cells.apply(terrain, &change, exported));
            }
        }
        Err(Error::NotConverged { what: "nonlinear diffusion".into(), iterations: MAX_ITERATIONS, residual: f64::NAN })
    }
}

/// The faces of a cell to the east and to the south.
#[derive(Clone, Copy, Default)]
struct Faces {
    /// Volume flux over them, m³/s.
    flux: [f64; 2],
    /// Its growth with the drop, m²/s.
    conductance: [f64; 2],
}

/// What fluxes need.
struct Fluxes<'a> {
    grid: &'a Grid,
    status: &'a [Status],
    diffusivity: &'a Resolved,
    critical: f64,
}

impl Fluxes<'_> {
    fn faces(&self, z: &[f64]) -> Vec<Faces> {
        let shape = self.grid.shape;
        let there = |i: usize| self.status[i] != Status::Masked;
        // The slope along an axis at a node, one-sided beside a side or nodata.
        let axis_slope = |i: usize, can: [bool; 2], step: usize, length: f64| {
            let before = if can[0] && there(i - step) { i - step } else { i };
            let after = if can[1] && there(i + step) { i + step } else { i };
            let cells = (usize::from(before != i) + usize::from(after != i)).max(1);
            (z[after] - z[before]) / (cells as f64 * length)
        };
        let [dx, dy] = self.grid.spacing;
        let x_slope = |i: usize| {
            let col = shape.cell(i).col;
            axis_slope(i, [col > 0, col + 1 < shape.cols], 1, dx)
        };
        let y_slope = |i: usize| {
            let row = shape.cell(i).row;
            axis_slope(i, [row > 0, row + 1 < shape.rows], shape.cols, dy)
        };
        parallel::map(z.len(), |i| {
            let (mut faces, cell) = (Faces::default(), shape.cell(i));
            if !there(i) {
                return faces;
            }
            if cell.col + 1 < shape.cols && there(i + 1) {
                let tangential = 0.5 * (y_slope(i) + y_slope(i + 1));
                self.face(&mut faces, 0, [i, i + 1], (z[i] - z[i + 1]) / dx, tangential, [dy, dx]);
            }
            if cell.row + 1 < shape.rows && there(i + shape.cols) {
                let to = i + shape.cols;
                let tangential = 0.5 * (x_slope(i) + x_slope(to));
                self.face(&mut faces, 1, [i, to], (z[i] - z[to]) / dy, tangential, [dx, dy]);
            }
            faces
        })
    }

    /// The face between two nodes with the slope normal to it and tangential to it; its width and
    /// the distance.
    fn face(
        &self,
        faces: &mut Faces,
        k: usize,
        [a, b]: [usize; 2],
        normal: f64,
        tangential: f64,
        [width, length]: [f64; 2],
    ) {
        let diffusivity = 0.5 * (self.diffusivity.at(a) + self.diffusivity.at(b));
        let (n, t) = (normal / self.critical, tangential / self.critical);
        let g = (n * n + t * t).sqrt();
        let plain = g.min(TANGENT);
        let denominator = 1.0 - plain * plain;
        let growth = (1.0 + plain * plain) / (denominator * denominator);
        // The flux over g, and its growth with the slope normal to the face.
        let factor = if g > TANGENT { (plain / denominator + growth * (g - plain)) / g } else { 1.0 / denominator };
        let share = if g > 0.0 { n * n / (g * g) } else { 1.0 };
        faces.flux[k] = diffusivity * width * factor * normal;
        faces.conductance[k] = diffusivity * width / length * (factor + (growth - factor) * share);
    }

    /// Volume flux into every node, m³/s.
    fn inflow(&self, faces: &[Faces]) -> Vec<f64> {
        let shape = self.grid.shape;
        parallel::map(faces.len(), |i| {
            let cell = shape.cell(i);
            let west = if cell.col > 0 { faces[i - 1].flux[0] } else { 0.0 };
            let north = if cell.row > 0 { faces[i - shape.cols].flux[1] } else { 0.0 };
            (west + north) - (faces[i].flux[0] + faces[i].flux[1])
        })
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
        // Roering et al. (1999): D S/(1 − (S/S_c)²) = U x from the crest, so S/S_c = (√(1 + 4a²) −
        // 1)/(2a), a = U x/(D S_c).
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
