//! Linear creep.
//!
//! Soil moves downhill at a rate proportional to slope: crests round off, hollows fill.
//!
//! # Model
//! ∂z/∂t = ∇·(D ∇z), with z held at base levels and no flux across closed sides and around holes.
//!
//! # Method
//! Finite volumes over the graph: on a raster the five-point stencil, on a mesh Voronoi faces; D at
//! a face is the mean of its ends. Backward Euler, first order in time, second in space, stable and
//! without overshoot for any Δt. Solved for the change of elevation, to 1e-12 of the greatest: on a
//! raster by over-relaxation in two colours ([`super::implicit`]), on a mesh by conjugate gradients
//! with diagonal scaling; a few sweeps while D Δt is below a cell's area, growing with the square
//! root of D Δt over it. Where nodes stand off the centres of their cells, creep acts on the
//! heights at the centres.
//!
//! # Limits
//! All ground creeps alike, rock too. On layered ground the deposit is soil. On a mesh faces of
//! obtuse border triangles are dropped where their conductance is negative.
//!
//! # Sources
//! Culling (1960); Young (1954) and Golub & Varga (1961) on rasters, Hestenes & Stiefel (1952) on
//! meshes.
//!
//! # Checked by
//! `tests`: the parabola of uplift and creep (VP5), decay of a sine, mass, mesh against raster.

use landform_core::Result;
use landform_core::terrain::NodeSurface;
use landform_core::units::{Diffusivity, DiffusivityDimension};
use landform_core::verb::{Change, Context, Params, Process, Resolved, Source, Step, Varying};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::implicit::{System, resolve_diffusivity};

/// Soil creep: ground moves downhill at a rate in proportion to its slope.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LinearDiffusion {
    /// Diffusivity D of the soil; may vary in space or change in time.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1e6))]
    pub diffusivity: Varying<DiffusivityDimension>,
}

impl Default for LinearDiffusion {
    fn default() -> Self {
        Self { diffusivity: Diffusivity::of(0.01).into() }
    }
}

impl Params for LinearDiffusion {
    const NAME: &'static str = "linear_diffusion";
    const IN_TIME: &'static [&'static str] = &["diffusivity"];
    const SOURCES: &'static [Source] = &[Source {
        authors: "Culling (1960)",
        title: "Analytical theory of erosion, Journal of Geology 68(3)",
        doi: "10.1086/626663",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(105)
    }
}

/// Diffusivity on the nodes, and the matrix as scratch.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    diffusivity: Resolved,
    #[serde(skip)]
    system: Option<System>,
}

impl<T: NodeSurface> Process<T> for LinearDiffusion {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<State> {
        let diffusivity = resolve_diffusivity(&self.diffusivity, terrain, context)?;
        Ok(State { diffusivity, system: None })
    }

    fn step(&self, terrain: &mut T, state: &mut State, at: &Step) -> Result<Change> {
        if let Some(now) = self.diffusivity.in_time(at.time, at.time + at.dt) {
            *state = State { diffusivity: Resolved::Uniform(now), system: None };
        }
        let system = state.system.get_or_insert_with(|| System::new(&*terrain.domain(), &state.diffusivity));
        let heights = system.cells.heights(terrain.elevation()).into_owned();
        let [change, end] = system.change(&heights, at.dt)?;
        let outflow = system.outflow(&heights, &end) * at.dt;
        Ok(system.cells.apply(terrain, &change, outflow))
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Edge, Edges, Grid, Shape};
    use landform_core::math;
    use landform_core::sim::{Simulation, Stop};
    use landform_core::terrain::{HeightField, Mesh, Rasterize};
    use landform_core::units::{KYR, YEAR};

    use super::*;

    fn strip(n: usize, dx: f64) -> Grid {
        let mut grid = Grid::new(Shape::new(3, n), [dx, dx]).unwrap();
        grid.edges = Edges { north: Edge::Closed, south: Edge::Closed, ..Edges::default() };
        grid
    }

    #[test]
    fn a_sine_decays_at_its_rate() {
        let (n, dx) = (201, 5.0);
        let grid = strip(n, dx);
        let length = (n - 1) as f64 * dx;
        let wave = |i: usize| 10.0 * math::sin(std::f64::consts::PI * grid.position(i)[0] / length);
        let field = HeightField::new(grid.clone(), (0..grid.len()).map(wave).collect()).unwrap();
        let rate = 0.01 / YEAR * math::pow(std::f64::consts::PI / length, 2.0);
        let duration = 1.0 / rate;
        let mut sim = Simulation::new(field)
            .process(LinearDiffusion::default())
            .unwrap()
            .dt(duration / 400.0)
            .until(Stop::time(duration));
        let outcome = sim.run().unwrap();
        let peak = sim.terrain().elevation()[n + n / 2];
        assert!((peak / (10.0 * math::exp(-1.0)) - 1.0).abs() < 2e-3, "{peak}");
        assert!(outcome.budget.imbalance() < 1e-10 && outcome.budget.sediment_imbalance() < 1e-10);
    }

    #[test]
    fn a_single_step_of_any_length_never_overshoots() {
        let grid = Grid::new(Shape::new(21, 21), [10.0, 10.0]).unwrap();
        let mut z = vec![0.0; 441];
        z[220] = 100.0;
        let field = HeightField::new(grid, z).unwrap();
        let mut sim =
            Simulation::new(field).process(LinearDiffusion::default()).unwrap().dt(1e4 * KYR).until(Stop::steps(1));
        sim.run().unwrap();
        assert!(sim.terrain().elevation().iter().all(|&z| (-1e-9..=100.0).contains(&z)));
    }

    #[test]
    fn uplift_and_creep_make_the_parabola_on_a_mesh() {
        // VP5: h = U (l² − x²)/(2D) between two open sides.
        let sites =
            landform_core::algo::sampling::poisson_disk([1000.0, 300.0], 15.0, landform_core::random::Seed(2)).unwrap();
        let edges = Edges { north: Edge::Closed, south: Edge::Closed, ..Edges::default() };
        let mesh = Mesh::delaunay(&sites, edges).unwrap();
        let uplift = crate::uplift::Uplift { rate: landform_core::units::Rate::of(0.1).into() };
        let mut sim = Simulation::new(mesh)
            .process(uplift)
            .unwrap()
            .process(LinearDiffusion::default())
            .unwrap()
            .dt(1e6 * KYR)
            .until(Stop::steps(30));
        sim.run().unwrap();
        let mesh = sim.terrain();
        for (p, z) in mesh.positions().iter().zip(mesh.elevation()) {
            let x = p[0] - 500.0;
            let expected = 1e-4 * (500.0 * 500.0 - x * x) / (2.0 * 0.01);
            assert!((z - expected).abs() < 1e-3 * 1250.0, "{x} {z} {expected}");
        }
    }

    #[test]
    fn creep_leaves_a_plane_on_jittered_nodes() {
        let grid = Grid::new(Shape::new(40, 50), [10.0; 2]).unwrap();
        let z = (0..grid.len()).map(|i| 0.6 * grid.position(i)[0]).collect();
        let field = HeightField::new(grid, z).unwrap().jittered(landform_core::random::Seed(1)).unwrap();
        let before = field.elevation().to_vec();
        let mut sim =
            Simulation::new(field).process(LinearDiffusion::default()).unwrap().dt(20.0 * KYR).until(Stop::steps(5));
        sim.run().unwrap();
        let after = sim.terrain().elevation();
        assert!((0..before.len()).all(|i| (after[i] - before[i]).abs() < 1e-3));
    }

    #[test]
    fn a_hole_lets_nothing_through() {
        let grid = Grid::new(Shape::new(9, 9), [10.0, 10.0]).unwrap();
        let mut z: Vec<f64> = (0..81).map(|i| (i % 9) as f64).collect();
        z[40] = f64::NAN;
        let field = HeightField::new(grid, z).unwrap();
        let mut sim = Simulation::new(field).process(LinearDiffusion::default()).unwrap().dt(KYR).until(Stop::steps(5));
        let outcome = sim.run().unwrap();
        assert!(sim.terrain().elevation()[40].is_nan() && outcome.budget.imbalance() < 1e-10);
    }
}
