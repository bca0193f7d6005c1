//! Uplift of the ground.
//!
//! # Model
//! ∂z/∂t = U wherever the ground is not held at base level.
//!
//! # Method
//! Explicit; exact for a rate that is constant in time. O(n).
//!
//! # Limits
//! Vertical only. A negative rate subsides.
//!
//! # Checked by
//! `tests`, and by the steady states of `stream_power`.

use landform_core::grid::{Domain, INTERIOR};
use landform_core::terrain::NodeSurface;
use landform_core::units::{Rate, RateDimension};
use landform_core::verb::{Change, Context, Params, Process, Resolved, Source, Step, Varying};
use landform_core::{Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Tectonic uplift: raises every node that is not held at base level.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Uplift {
    /// Rate of uplift; may vary in space, negative where the ground subsides.
    pub rate: Varying<RateDimension>,
}

impl Default for Uplift {
    fn default() -> Self {
        Self { rate: Rate::of(0.5).into() }
    }
}

impl Params for Uplift {
    const NAME: &'static str = "uplift";
    const SOURCES: &'static [Source] = &[];
}

/// Rates, and as scratch where they act.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    rate: Resolved,
    #[serde(skip)]
    reach: Option<Reach>,
}

#[derive(Clone, Debug)]
struct Reach {
    /// Area of raised nodes, m²; 0 for the others.
    area: Vec<f64>,
    /// Greatest rate, m/s.
    greatest: f64,
    /// Volume raised a second, m³/s.
    supply: f64,
}

impl Reach {
    fn new<D: Domain>(domain: &D, rate: &Resolved) -> Self {
        let status = domain.status();
        let area = parallel::map(domain.len(), |i| if status[i] == INTERIOR { domain.area(i) } else { 0.0 });
        let greatest = parallel::max(area.len(), |i| if area[i] > 0.0 { rate.at(i) } else { 0.0 }).max(0.0);
        let supply = parallel::sum(area.len(), |i| if area[i] > 0.0 { rate.at(i) * area[i] } else { 0.0 });
        Self { area, greatest, supply }
    }
}

impl<T: NodeSurface> Process<T> for Uplift {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn start(&self, terrain: &mut T, context: &Context) -> Result<State> {
        Ok(State { rate: self.rate.resolve("rate", terrain, context)?, reach: None })
    }

    fn step(&self, terrain: &mut T, state: &mut State, at: &Step) -> Result<Change> {
        let State { rate, reach } = state;
        let Reach { area, greatest, supply } = reach.get_or_insert_with(|| Reach::new(&*terrain.domain(), rate));
        parallel::update(terrain.elevation_mut(), |i, z| {
            if area[i] > 0.0 {
                *z += rate.at(i) * at.dt;
            }
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
}
