//! Uplift of the ground.
//!
//! # Model
//! ∂z/∂t = U wherever the ground is not held at base level.
//!
//! # Method
//! Explicit. A rate that changes in time acts by its mean over each step. Beds of rock move with
//! the ground. O(n).
//!
//! # Limits
//! Vertical only. With a negative rate the ground subsides.
//!
//! # Checked by
//! `tests`, and by the steady states of `stream_power`.
//!
//! # Example
//! An uplift of 1 mm/yr raises the ground by 2 m in 2 kyr. The border is held:
//!
//! ```
//! use landform_core::grid::{Grid, Shape};
//! use landform_core::sim::Model;
//! use landform_core::terrain::{HeightField, NodeSurface};
//! use landform_core::units::{KYR, Rate};
//! use landform_process::uplift::Uplift;
//!
//! let ground = HeightField::new(Grid::new(Shape::new(3, 3), [100.0, 100.0])?, vec![0.0; 9])?;
//! let mut model = Model::new(ground).dt(KYR);
//! model.add(Uplift { rate: Rate::of(1.0).into() })?;
//! model.advance_steps(2)?;
//! let z = model.terrain().elevation();
//! assert!((z[4] - 2.0).abs() < 1e-9 && z[0] == 0.0);
//! # Ok::<(), landform_core::Error>(())
//! ```

use landform_core::grid::{Domain, Status};
use landform_core::terrain::{HeightField, Layer, Mesh, NodeSurface};
use landform_core::units::{Rate, RateDimension};
use landform_core::verb::{Change, Context, Params, Process, Reach, Resolved, Source, Step, Varying};
use landform_core::{Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

landform_core::stages! {
    process Uplift where HeightField, Mesh;
}

/// Tectonic uplift: raises every node that is not held at base level.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Uplift {
    /// Rate of uplift; may vary in space or change in time. It is negative where the ground
    /// subsides.
    pub rate: Varying<RateDimension>,
}

impl Default for Uplift {
    fn default() -> Self {
        Self { rate: Rate::of(0.5).into() }
    }
}

impl Params for Uplift {
    const NAME: &'static str = "uplift";
    const IN_TIME: &'static [&'static str] = &["rate"];
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(12)
    }

    fn reach(&self) -> Reach {
        self.rate.reach()
    }

    fn raises(&self) -> Option<f64> {
        match &self.rate {
            Varying::Uniform(rate) => Some(rate.si()),
            Varying::InTime(course) => course.greatest(),
            _ => None,
        }
    }
}

/// Rates, and scratch for the nodes that they raise.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    rate: Resolved,
    #[serde(skip)]
    raised: Option<Raised>,
}

#[derive(Clone, Debug)]
struct Raised {
    /// Area of raised nodes, m²; 0 for the others.
    area: Vec<f64>,
    /// Area of all raised nodes, m².
    whole: f64,
    /// Greatest rate, m/s.
    greatest: f64,
    /// Volume raised a second, m³/s.
    supply: f64,
}

impl Raised {
    fn new<D: Domain>(domain: &D, rate: &Resolved) -> Self {
        let status = domain.status();
        let area = parallel::map(domain.len(), |i| if status[i] == Status::Interior { domain.area(i) } else { 0.0 });
        let greatest = parallel::max(area.len(), |i| if area[i] > 0.0 { rate.at(i) } else { 0.0 }).max(0.0);
        let supply = parallel::sum(area.len(), |i| if area[i] > 0.0 { rate.at(i) * area[i] } else { 0.0 });
        let whole = parallel::sum(area.len(), |i| area[i]);
        Self { area, whole, greatest, supply }
    }
}

impl<T: NodeSurface> Process<T> for Uplift {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<State> {
        Ok(State { rate: self.rate.resolve("rate", terrain, context)?, raised: None })
    }

    fn step(&self, terrain: &mut T, state: &mut State, at: &Step) -> Result<Change> {
        let State { rate, raised } = state;
        let raised = raised.get_or_insert_with(|| Raised::new(&*terrain.domain(), rate));
        if let Some(now) = self.rate.in_time(at.time, at.time + at.dt) {
            *rate = Resolved::Uniform(now);
            (raised.greatest, raised.supply) = (now.max(0.0), now * raised.whole);
        }
        let Raised { area, greatest, supply, .. } = raised;
        terrain.change(Layer::Bedrock, |z| {
            parallel::update(z, |i, z| {
                if area[i] > 0.0 {
                    *z += rate.at(i) * at.dt;
                }
            });
        });
        Ok(Change { supplied: *supply * at.dt, raised: *greatest * at.dt, ..Change::default() })
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::sim::{Simulation, Stop};
    use landform_core::terrain::HeightField;
    use landform_core::units::YEAR;

    use super::*;

    #[test]
    fn inner_nodes_rise_and_base_levels_stay() {
        let grid = Grid::new(Shape::new(5, 5), [10.0, 10.0]).unwrap();
        let field = HeightField::new(grid, vec![1.0; 25]).unwrap();
        let mut sim =
            Simulation::new(field).process(Uplift::default()).unwrap().dt(30.0 * YEAR).until(Stop::time(100.0 * YEAR));
        let outcome = sim.run().unwrap();
        assert!((sim.terrain().elevation()[12] - 1.05).abs() < 1e-12);
        assert_eq!(sim.terrain().elevation()[0], 1.0);
        assert!(outcome.budget.imbalance() < 1e-9);
    }

    #[test]
    fn a_rate_that_changes_in_time_raises_by_its_integral_and_carries_the_beds() {
        let grid = Grid::new(Shape::new(5, 5), [10.0, 10.0]).unwrap();
        let mut field = HeightField::new(grid, vec![1.0; 25]).unwrap();
        let all = landform_core::terrain::Materials::default();
        let bed = |name: &str| landform_core::terrain::Bed { material: all.find(name).unwrap(), thickness: 2.0 };
        let beds = landform_core::terrain::Layers::bedded(&all, vec![bed("shale"), bed("sandstone")], vec![1.0; 25]);
        field.set_layers(Some(beds.unwrap()));
        let rate = r#"{"rate":{"times":["0 yr","1 kyr","3 kyr"],"values":["0 mm/yr","2 mm/yr","0 mm/yr"]}}"#;
        let uplift: Uplift = serde_json::from_str(rate).unwrap();
        let mut sim =
            Simulation::new(field).process(uplift).unwrap().dt(700.0 * YEAR).until(Stop::time(5_000.0 * YEAR));
        let outcome = sim.run().unwrap();
        let z = sim.terrain().elevation()[12];
        assert!((z - 4.0).abs() < 1e-9 && outcome.budget.imbalance() < 1e-9, "{z}");
        assert_eq!(sim.terrain().layers().unwrap().surface(12, z).name, "shale");
    }
}
