//! A representation and a process that landform does not know: each is one file, and everything
//! that asks for capabilities takes them.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on panics")]

use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::Arc;

use landform::core::algo::flow::{Flow, node_areas};
use landform::core::feature::Features;
use landform::core::field::Fields;
use landform::core::grid::{Domain, Grid, Link, Neighbours, RasterDomain, Shape, Status};
use landform::core::random::Seed;
use landform::core::sim::{Every, Simulation, Stop};
use landform::core::terrain::{HeightField, Kind, Layers, NodeSurface, Terrain};
use landform::core::units::{Length, Rate, YEAR};
use landform::core::verb::{Change, Context, Params, Process, Source, Step};
use landform::core::{Error, Result};
use landform::process::hillslope::LinearDiffusion;
use landform::process::stream_power::StreamPower;
use landform::process::uplift::Uplift;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A river valley as a line of nodes, each the neighbour of the next; the first is the mouth.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Valley {
    elevation: Vec<f64>,
    status: Vec<Status>,
    layers: Option<Box<Layers>>,
    fields: Fields,
    features: Features,
}

const STEP: f64 = 100.0;

thread_local! {
    /// How often a valley was cloned.
    static CLONES: Cell<usize> = const { Cell::new(0) };
}

impl Clone for Valley {
    fn clone(&self) -> Self {
        CLONES.set(CLONES.get() + 1);
        Self {
            elevation: self.elevation.clone(),
            status: self.status.clone(),
            layers: self.layers.clone(),
            fields: self.fields.clone(),
            features: self.features.clone(),
        }
    }
}

#[derive(Clone, Debug)]
struct Line(Vec<Status>);

impl Neighbours for Line {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn neighbours(&self, node: usize) -> impl Iterator<Item = Link> {
        let up = (node + 1 < self.0.len()).then(|| Link { to: node + 1, distance: STEP, slot: 0 });
        let down = node.checked_sub(1).map(|to| Link { to, distance: STEP, slot: 1 });
        up.into_iter().chain(down)
    }
}

impl Domain for Line {
    fn area(&self, _: usize) -> f64 {
        STEP * STEP
    }

    fn status(&self) -> &[Status] {
        &self.0
    }

    fn set_status(&mut self, status: Vec<Status>) {
        self.0 = status;
    }

    fn conductance(&self, _: usize, _: u8) -> f64 {
        1.0
    }
}

impl Terrain for Valley {
    const KIND: Kind = Kind::Mesh;
    const BYTES_A_NODE: u64 = 40;

    fn nodes(&self) -> usize {
        self.elevation.len()
    }

    fn volume(&self) -> f64 {
        self.elevation.iter().sum::<f64>() * STEP * STEP
    }

    fn check_finite(&self) -> Result<(), (&'static str, usize)> {
        self.elevation.iter().position(|z| !z.is_finite()).map_or(Ok(()), |i| Err(("elevation", i)))
    }
}

impl NodeSurface for Valley {
    type Domain = Line;

    fn domain(&self) -> Arc<Line> {
        Arc::new(Line(self.status.clone()))
    }

    fn set_status(&mut self, status: Option<Vec<Status>>) {
        self.status = status.unwrap_or_else(|| self.border());
    }

    fn border(&self) -> Vec<Status> {
        (0..self.elevation.len()).map(|i| if i == 0 { Status::BaseLevel } else { Status::Interior }).collect()
    }

    fn elevation(&self) -> &[f64] {
        &self.elevation
    }

    fn layers(&self) -> Option<&Layers> {
        self.layers.as_deref()
    }

    fn parts_mut(&mut self) -> (&mut [f64], &mut Option<Box<Layers>>) {
        (&mut self.elevation, &mut self.layers)
    }

    fn position(&self, node: usize) -> [f64; 2] {
        [node as f64 * STEP, 0.0]
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        [[0.0, 0.0], self.position(self.elevation.len() - 1)]
    }

    fn fields(&self) -> &Fields {
        &self.fields
    }

    fn fields_mut(&mut self) -> &mut Fields {
        &mut self.fields
    }

    fn features(&self) -> &Features {
        &self.features
    }

    fn features_mut(&mut self) -> &mut Features {
        &mut self.features
    }
}

fn valley(nodes: usize) -> Valley {
    let mut valley = Valley {
        elevation: (0..nodes).map(|i| 0.1 * i as f64).collect(),
        status: Vec::new(),
        layers: None,
        fields: Fields::sized(nodes),
        features: Features::default(),
    };
    valley.set_status(None);
    valley
}

/// Rain of ash: every node rises alike.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
struct Ashfall {
    /// Depth of a fall.
    depth: Length,
}

impl Default for Ashfall {
    fn default() -> Self {
        Self { depth: Length::of(0.01) }
    }
}

impl Params for Ashfall {
    const NAME: &'static str = "ashfall";
    const SOURCES: &'static [Source] = &[];
}

impl<T: NodeSurface> Process<T> for Ashfall {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = ();

    fn start(&self, _: &mut T, _: &Context) -> Result<()> {
        Ok(())
    }

    fn step(&self, terrain: &mut T, (): &mut (), _: &Step) -> Result<Change> {
        let (domain, depth) = (terrain.domain(), self.depth.si());
        terrain.change(landform::core::terrain::Layer::Bedrock, |z| z.iter_mut().for_each(|z| *z += depth));
        let supplied = (0..domain.len()).map(|i| domain.area(i) * depth).sum();
        Ok(Change { supplied, raised: depth, ..Change::default() })
    }
}

mod rows {
    use super::Ashfall;
    landform::core::stages! {
        process Ashfall where landform::core::terrain::HeightField, landform::core::terrain::Mesh;
    }
}

#[test]
fn rivers_uplift_and_creep_run_on_ground_that_nobody_knows() {
    // Without creep and with m = 0.5, n = 1: slope times the square root of area is U / K at the
    // steady state.
    let (rate, erodibility) = (1e-3, 2e-5);
    let erodibility_of_rock = Some(landform::core::units::Erodibility::of(erodibility).into());
    let law = StreamPower { erodibility: erodibility_of_rock, limiting_slope: Some(0.0), ..StreamPower::default() };
    let run = |creep: bool| {
        let mut simulation = Simulation::new(valley(60))
            .process(Uplift { rate: Rate::of(1e3 * rate).into() })
            .and_then(|s| s.process(law.clone()))
            .unwrap();
        if creep {
            simulation = simulation.process(LinearDiffusion::default()).unwrap();
        }
        let mut simulation = simulation.dt(2e4 * YEAR).until(Stop::time(2e7 * YEAR));
        let outcome = simulation.run().unwrap();
        assert!(outcome.budget.imbalance() < 1e-9);
        simulation.into_terrain()
    };
    let ground = run(false);
    for node in 1..ground.elevation.len() {
        let area = (60 - node) as f64 * STEP * STEP;
        let slope = (ground.elevation[node] - ground.elevation[node - 1]) / STEP;
        assert!((slope * area.sqrt() / (rate / erodibility) - 1.0).abs() < 1e-3, "{node}: {slope}");
    }
    assert!(run(true).elevation[59] < ground.elevation[59], "creep lowers the head");
}

#[test]
fn neither_looks_nor_checkpoints_copy_the_ground() {
    let (mut looks, mut saved) = (0, 0);
    let mut simulation = Simulation::new(valley(9)).process(Ashfall::default()).unwrap().dt(YEAR).until(Stop::steps(5));
    simulation = simulation.observe(Every::Steps(1), |view| {
        looks += view.terrain.elevation.len();
        Ok(ControlFlow::Continue(()))
    });
    simulation = simulation.save_every(0.0, |model| {
        saved += model.save("test")?.len();
        Ok(())
    });
    let before = CLONES.get();
    simulation.run().unwrap();
    drop(simulation);
    assert!(CLONES.get() == before && looks == 45 && saved > 0, "{} copies", CLONES.get() - before);
}

#[test]
fn a_process_of_one_file_has_a_row_a_schema_and_a_clock() {
    let stage = rows::STAGES.first().unwrap();
    let read = stage.read(&serde_json::json!({ "depth": "2 cm" })).unwrap();
    assert_eq!(read.parameters()["depth"], "0.02 m");
    assert!(stage.read(&serde_json::json!({ "dephth": "2 cm" })).is_err());
    assert!((stage.form.schema)()["properties"]["depth"]["x-unit"] == "m" && stage.summary().contains("ash"));
    let mut model = landform::core::sim::Model::new(valley(5));
    model.add(Ashfall { depth: Length::of(0.5) }).unwrap();
    let mut model = model.dt(YEAR);
    model.advance_steps(4).unwrap();
    assert_eq!(model.terrain().elevation()[4], 2.4);
    let field = HeightField::new(Grid::new(Shape::new(3, 3), [10.0, 10.0]).unwrap(), vec![0.0; 9]).unwrap();
    let mut raster = landform::core::sim::Model::new(field);
    read.add_to(Kind::HeightField, &mut raster).unwrap();
    assert!(matches!(read.add_to(Kind::Mesh, &mut raster), Err(Error::Unsupported { .. })));
}

/// A raster that has no kernels of its own.
#[derive(Clone)]
struct Plain(RasterDomain);

impl Neighbours for Plain {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn neighbours(&self, node: usize) -> impl Iterator<Item = Link> {
        self.0.neighbours(node)
    }
}

impl Domain for Plain {
    fn area(&self, node: usize) -> f64 {
        self.0.area(node)
    }

    fn status(&self) -> &[Status] {
        self.0.status()
    }

    fn set_status(&mut self, status: Vec<Status>) {
        self.0.set_status(status);
    }

    fn conductance(&self, node: usize, slot: u8) -> f64 {
        self.0.conductance(node, slot)
    }
}

#[test]
fn kernels_that_follow_from_six_methods_route_as_the_fast_ones() {
    let grid = Grid::new(Shape::new(37, 41), [10.0, 10.0]).unwrap();
    let heights = |levels: f64| -> Vec<f64> {
        let z = |i: usize| Seed(9).uniform(i as u64) * 100.0;
        (0..grid.len()).map(|i| if levels > 0.0 { (z(i) / levels).floor() * levels } else { z(i) }).collect()
    };
    // Rough ground, and ground of many ties.
    for z in [heights(0.0), heights(25.0)] {
        let fast = RasterDomain::new(&grid, &[]);
        let plain = Plain(fast.clone());
        let (mut a, mut b) = (node_areas(&fast), node_areas(&plain));
        let (mut by_fast, mut by_plain) = (Flow::new(), Flow::new());
        by_fast.route(&fast, &z, &mut a);
        by_plain.route(&plain, &z, &mut b);
        let (mut r, mut s) = ((vec![0; z.len()], vec![0; z.len()]), (vec![0; z.len()], vec![0; z.len()]));
        fast.steepest_descent(&z, &mut r.0, &mut r.1);
        plain.steepest_descent(&z, &mut s.0, &mut s.1);
        assert!(r == s, "steepest descent");
        let (mut r, mut s) = (vec![0; z.len()], vec![0; z.len()]);
        fast.saddles(&z, &mut r);
        plain.saddles(&z, &mut s);
        assert!(r == s, "saddles");
        for node in 0..z.len() {
            let (mut r, mut s) = (Vec::new(), Vec::new());
            fast.lower_arcs(&z, node, 3, |k| r.push(k));
            plain.lower_arcs(&z, node, 3, |k| s.push(k));
            assert!(r == s, "arcs of {node}");
        }
        assert!(a == b && by_fast.receivers() == by_plain.receivers(), "routing");
    }
}
