use std::ops::ControlFlow;
use std::sync::Mutex;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::*;
use crate::grid::{Grid, Shape};
use crate::random::Seed;
use crate::terrain::{HeightField, Layer, NodeSurface};
use crate::verb::{CancelToken, Change, Context, Params, Process, Source, Step};
use crate::{Error, Result};

/// Adds a random amount to every node; counts its steps.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
struct Jitter {
    amount: f64,
}

impl Default for Jitter {
    fn default() -> Self {
        Self { amount: 1.0 }
    }
}

impl Params for Jitter {
    const NAME: &'static str = "jitter";
    const SOURCES: &'static [Source] = &[];
}

impl Process<HeightField> for Jitter {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = u64;

    fn start(&self, _: &mut HeightField, _: &Context) -> Result<u64> {
        Ok(0)
    }

    fn max_step(&self, _: &HeightField, steps: &u64) -> Option<f64> {
        Some(if *steps % 3 == 2 { 0.4 } else { 9.0 })
    }

    fn step(&self, terrain: &mut HeightField, steps: &mut u64, at: &Step) -> Result<Change> {
        *steps += 1;
        let mut supplied = 0.0;
        terrain.change(Layer::Bedrock, |z| {
            for (i, z) in z.iter_mut().enumerate() {
                let rise = self.amount * at.dt * at.seed.uniform(i as u64);
                *z += rise;
                supplied += rise;
            }
        });
        Ok(Change { supplied, raised: self.amount * at.dt, ..Change::default() })
    }
}

fn terrain() -> HeightField {
    HeightField::new(Grid::new(Shape::new(6, 7), [1.0, 1.0]).unwrap(), vec![0.0; 42]).unwrap()
}

fn simulation<'a>() -> Simulation<'a, HeightField> {
    Simulation::new(terrain()).process(Jitter::default()).unwrap().dt(1.0).until(Stop::time(9.5)).seed(Seed(4))
}

#[test]
fn a_run_ends_exactly_at_its_time_and_its_budget_closes() {
    let mut sim = simulation();
    let outcome = sim.run().unwrap();
    assert_eq!(outcome.stopped, Stopped::EndTime);
    assert!((outcome.time - 9.5).abs() < 1e-9);
    assert!(outcome.budget.imbalance() < 1e-12);
}

#[test]
fn resuming_at_any_step_gives_the_same_bits() {
    let mut whole = simulation();
    let total = whole.run().unwrap();
    for stop_at in 1..total.steps {
        let cancel = CancelToken::default();
        let token = cancel.clone();
        let mut first = simulation().cancel(cancel).observe(Every::Steps(1), move |view| {
            if view.steps == stop_at {
                token.cancel();
            }
            Ok(ControlFlow::Continue(()))
        });
        assert_eq!(first.run().unwrap().stopped, Stopped::Cancelled);
        let saved = first.model().save("k").unwrap();
        let mut second = simulation().resume("k", &saved).unwrap();
        assert_eq!(second.run().unwrap(), total);
        assert_eq!(second.into_terrain(), *whole.terrain());
        assert!(simulation().resume("other", &saved).is_err());
    }
}

#[test]
fn observers_are_called_on_their_times() {
    let times = Mutex::new(Vec::new());
    let mut sim = simulation().observe(Every::Time(2.5), |view| {
        times.lock().unwrap().push(view.time);
        Ok(ControlFlow::Continue(()))
    });
    sim.run().unwrap();
    drop(sim);
    assert_eq!(*times.lock().unwrap(), [2.5, 5.0, 7.5]);
}

#[test]
fn an_observer_can_end_a_run_and_a_guard_finds_numbers_that_are_not() {
    let mut sim = simulation().observe(Every::Steps(2), |_| Ok(ControlFlow::Break(())));
    assert_eq!(sim.run().unwrap().stopped, Stopped::ByObserver);
    let mut sim =
        Simulation::new(terrain()).process(Jitter { amount: f64::MAX }).unwrap().dt(9.0).until(Stop::time(1e3));
    match sim.run().unwrap_err() {
        Error::NonFinite { after, .. } => assert!(after.contains("jitter")),
        other => panic!("{other}"),
    }
}

#[test]
fn clocks_that_cannot_run_are_refused() {
    for (dt, stop) in
        [(0.0, Stop::time(1.0)), (f64::NAN, Stop::time(1.0)), (1.0, Stop::default()), (1.0, Stop::time(-1.0))]
    {
        assert!(Simulation::new(terrain()).process(Jitter::default()).unwrap().dt(dt).until(stop).run().is_err());
    }
}

#[test]
fn wall_clock_saving_sees_a_state_that_resumes() {
    let saved = Mutex::new(Vec::new());
    let mut sim = simulation().save_every(0.0, |model| {
        saved.lock().unwrap().push(model.save("k")?);
        Ok(())
    });
    let outcome = sim.run().unwrap();
    let end = sim.into_terrain();
    let saved = saved.into_inner().unwrap();
    assert_eq!(saved.len() as u64, outcome.steps);
    let mut again = simulation().resume("k", &saved[2]).unwrap();
    again.run().unwrap();
    assert_eq!(again.into_terrain(), end);
}

#[test]
fn a_model_is_stepped_edited_saved_and_given_other_parameters() {
    let mut model = Model::new(terrain()).dt(1.0).seed(Seed(4));
    model.add(Jitter::default()).unwrap();
    model.advance(3.0).unwrap();
    assert!((model.time() - 3.0).abs() < 1e-12);
    let before = model.terrain().elevation().to_vec();
    model.edit(|t| t.change(Layer::Bedrock, |z| z[3] += 5.0)).unwrap();
    model.edit(|t| t.change(Layer::Bedrock, |z| z[9] -= 2.0)).unwrap();
    assert!((model.terrain().elevation()[3] - before[3] - 5.0).abs() < 1e-12);
    let budget = model.budget();
    assert!(budget.imbalance() < 1e-12 && budget.sediment_imbalance() < 1e-12);
    assert!((budget.change.exported - 2.0).abs() < 1e-12);
    let saved = model.save("m").unwrap();
    model.advance_steps(4).unwrap();
    let mut other = Model::new(terrain()).dt(1.0).seed(Seed(4));
    other.add(Jitter::default()).unwrap();
    other.restore("m", &saved).unwrap();
    other.advance_steps(4).unwrap();
    assert!(model.terrain() == other.terrain() && model.time() == other.time());
    model.set(0, Jitter { amount: 0.0 }).unwrap();
    let still = model.terrain().elevation().to_vec();
    model.advance(2.0).unwrap();
    assert_eq!(model.terrain().elevation(), still);
    assert!(model.set(1, Jitter::default()).is_err() && model.step(0.0).is_err());
}

#[test]
fn a_model_can_be_sent_to_another_thread() {
    let mut model = Model::new(terrain()).dt(1.0);
    model.add(Jitter::default()).unwrap();
    let model = std::thread::spawn(move || model.advance(2.0).map(|_| model)).join().unwrap().unwrap();
    assert!((model.time() - 2.0).abs() < 1e-12);
}
