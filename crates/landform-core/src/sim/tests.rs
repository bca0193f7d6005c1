use std::ops::ControlFlow;
use std::sync::Mutex;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::*;
use crate::grid::{Grid, Shape};
use crate::random::Seed;
use crate::terrain::{HeightField, NodeSurface};
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
        for (i, z) in terrain.elevation_mut().iter_mut().enumerate() {
            let rise = self.amount * at.dt * at.seed.uniform(i as u64);
            *z += rise;
            supplied += rise;
        }
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
        let saved = first.checkpoint("k").unwrap();
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
    let mut sim = simulation().save_every(0.0, |sim| {
        saved.lock().unwrap().push(sim.checkpoint("k")?);
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
