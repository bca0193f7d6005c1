//! Cellular automata written in recipes.
//!
//! # Model
//! A cell has states: `height` (m), which is the ground, and others, which are fields. Effects are
//! run in sequence; an effect is a number of steps, a step its rules in sequence, a rule a formula
//! for all cells at once. `set` gives a state a new value; `move` carries an amount of it to other
//! cells, and nothing of it is lost but over open sides.
//!
//! # Method
//! Each rule reads the states as the rule before left them; with `together` as they were at the
//! start of the step. Formulas are read once and run row by row. Amounts are cut to what there is
//! (of `height` there is always enough), and those below 0 do not move. Of neighbours of equal
//! value the first counter-clockwise from the east is the lowest, of nearer rings first.
//!
//! # Limits
//! The ground is held on open sides and at other base levels: what comes there is exported. Other
//! states live there as elsewhere. Beyond open sides and in nodata there are no neighbours; `at`
//! tells the cell's own value there, and an amount that is sent there is gone. A ground that is
//! `set` comes from nowhere: what it gains counts as supplied, what it loses as exported.
//!
//! # Sources
//! Koh (2002), chapter 4: effects are automata, applied one after the other to the same heights;
//! the sequence is ours to write. The words of rules are ours.
//!
//! # Checked by
//! `tests`: Conway's blinker and glider; the rules of `stream_automaton`, in words, give its ground
//! to the bit; heaps come to their angle and keep their volume; threads; wrong recipes.

mod apply;
mod around;
mod params;
mod program;
mod value;
mod words;
mod world;

#[cfg(test)]
mod tests;

pub use params::{Automaton, Effect, Neighbourhood, Rule, Until};
pub use value::Value;

use landform_core::field::Values;
use landform_core::grid::Status;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, Layer, NodeSurface};
use landform_core::units::YEAR;
use landform_core::verb::{Change, Context, OwnClock, Params, Process, Source, Step};
use landform_core::{Error, Result, parallel};
use serde::{Deserialize, Serialize};

use apply::{Told, apply};
use around::Around;
use program::{Plan, PlannedRule, Start};
use words::GROUND;
use world::World;

landform_core::stages! {
    process Automaton where HeightField;
}

impl Params for Automaton {
    const NAME: &'static str = "automaton";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Koh (2002)",
        title: "Dramatic Landscapes: Cellular Automata Modeling of Landscape Phenomena, thesis, Monash University, chapter 4",
        doi: "",
    }];

    fn leaves(&self) -> Vec<String> {
        self.states.keys().cloned().collect()
    }

    fn check(&self) -> Result<()> {
        Plan::new(self).map(drop)
    }
}

/// Where in the sequence of effects an automaton is. The states are fields of the terrain.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::HeightField;
/// use landform_core::verb::{Context, Process};
/// use landform_process::automaton::Automaton;
///
/// let mut ground = HeightField::new(Grid::new(Shape::new(3, 3), [10.0; 2])?, vec![0.0; 9])?;
/// let state = Automaton::default().start(&mut ground, &Context::default())?;
/// assert!(!Automaton::default().is_at_rest(&ground, &state));
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct State {
    /// How often the sequence has been run.
    iteration: u64,
    effect: usize,
    /// Step of the effect.
    step: u64,
    /// Seed of noise.
    seed: Seed,
    /// Rules that have been read, and neighbours.
    #[serde(skip)]
    ready: Option<(Plan, Around)>,
}

impl Automaton {
    fn ready(&self, terrain: &HeightField) -> Result<(Plan, Around)> {
        let around = Around::new(terrain.grid(), &*terrain.domain(), self.neighbourhood, self.radius)?;
        Ok((Plan::new(self)?, around))
    }

    fn is_over(&self, state: &State) -> bool {
        state.iteration >= self.iterations
    }

    /// Goes on to the next step, or to the next effect if `ends`.
    fn go_on(&self, state: &mut State, ends: bool) {
        state.step += 1;
        if ends || state.step >= self.effects[state.effect].steps {
            (state.effect, state.step) = (state.effect + 1, 0);
        }
        if state.effect >= self.effects.len() {
            (state.iteration, state.effect) = (state.iteration + 1, 0);
        }
    }

    /// Where an automaton is after so many steps of full length.
    fn after(&self, steps: u64, seed: Seed) -> State {
        let all = Plan::steps(self).max(1);
        let (iteration, mut step, mut effect) = (steps / all, steps % all, 0);
        while self.effects.get(effect).is_some_and(|e| step >= e.steps) {
            step -= self.effects[effect].steps;
            effect += 1;
        }
        State { iteration, effect, step, seed, ready: None }
    }
}

/// The states of all cells, `height` first.
fn states_of(plan: &Plan, terrain: &HeightField) -> Result<Vec<Vec<f64>>> {
    let mut states = vec![terrain.elevation().to_vec()];
    for name in &plan.states[1..] {
        states.push(terrain.real(name, "`automaton`")?);
    }
    Ok(states)
}

impl Process<HeightField> for Automaton {
    const WRITES: &'static [&'static str] = &["elevation"];
    type State = State;

    fn own_clock(&self) -> Option<OwnClock> {
        let rounds = Plan::steps(self).saturating_mul(self.iterations);
        Some(OwnClock { dt: YEAR, rounds, is_timed: false })
    }

    fn is_at_rest(&self, _: &HeightField, state: &State) -> bool {
        self.is_over(state)
    }

    fn start(&self, terrain: &mut HeightField, context: &Context) -> Result<State> {
        let (plan, around) = self.ready(terrain)?;
        let mut states = vec![vec![0.0; terrain.grid().len()]; plan.states.len()];
        states[GROUND].copy_from_slice(terrain.elevation());
        for (state, start) in &plan.starts {
            let name = &plan.states[*state];
            // A run that goes on keeps its states.
            let kept = terrain.fields().find(name).filter(|_| context.step > 0).map(Values::to_f64);
            let values = match (kept, start) {
                (Some(kept), _) => kept,
                (None, Start::Field(source)) => terrain.real(source, "`automaton`")?,
                (None, Start::Formula(formula)) => {
                    let draws = context.seed.named(name);
                    let world = World {
                        grid: terrain.grid(),
                        around: &around,
                        states: &states,
                        step: 0,
                        seed: context.seed,
                        draws,
                    };
                    let mut values = vec![0.0; terrain.grid().len()];
                    formula.write(&world, &mut values);
                    values
                }
            };
            let holes = around.status();
            let is_wrong = |i: usize| !values[i].is_finite() && holes[i] != Status::Masked;
            if let Some(node) = parallel::find_first(values.len(), is_wrong) {
                let after = "the start of `automaton`".into();
                return Err(Error::NonFinite { field: format!("`{name}`"), node, after });
            }
            states[*state] = values;
        }
        for (name, values) in plan.states.iter().zip(states).skip(1) {
            terrain.fields_mut().insert_values(name, Values::F64(values))?;
        }
        Ok(State { ready: Some((plan, around)), ..self.after(context.step, context.seed) })
    }

    fn reconcile(&self, terrain: &mut HeightField, state: &mut State, context: &Context) -> Result<()> {
        let State { iteration, effect, step, seed, .. } = *state;
        let is_inside = effect < self.effects.len();
        let anew = self.start(terrain, context)?;
        // Effects may have ended before their time.
        *state = if is_inside { State { iteration, effect, step, seed, ..anew } } else { anew };
        Ok(())
    }

    fn step(&self, terrain: &mut HeightField, state: &mut State, at: &Step) -> Result<Change> {
        if self.is_over(state) {
            return Ok(Change::default());
        }
        let (plan, around) = match state.ready.take() {
            Some(ready) => ready,
            None => self.ready(terrain)?,
        };
        let Some(effect) = plan.effects.get(state.effect) else { return Ok(Change::default()) };
        let mut now = states_of(&plan, terrain)?;
        let start = (effect.together || effect.is_until_still).then(|| now.clone());
        let mut change = Change::default();
        for (k, rule) in effect.rules.iter().enumerate() {
            let draws = at.seed.with(k as u64);
            let mut values = now[rule.state].clone();
            let states = start.as_ref().filter(|_| effect.together).unwrap_or(&now);
            let world =
                World { grid: terrain.grid(), around: &around, states, step: state.step, seed: state.seed, draws };
            let told = Told { state: &plan.states[rule.state], rule: [state.effect, k] };
            change = change.plus(apply(rule, &world, &mut values, told)?);
            now[rule.state] = values;
        }
        let is_still = effect.is_until_still && start.as_ref() == Some(&now);
        put_back(&plan, terrain, now)?;
        self.go_on(state, is_still);
        state.ready = Some((plan, around));
        Ok(change)
    }
}

/// Writes the states to the terrain.
fn put_back(plan: &Plan, terrain: &mut HeightField, mut now: Vec<Vec<f64>>) -> Result<()> {
    let others = now.split_off(GROUND + 1);
    for (name, values) in plan.states.iter().skip(1).zip(others) {
        terrain.fields_mut().insert_values(name, Values::F64(values))?;
    }
    if plan.effects.iter().flat_map(|e| &e.rules).any(PlannedRule::is_of_ground) {
        terrain.change(Layer::Surface("sediment"), |z| z.copy_from_slice(&now[GROUND]));
    }
    Ok(())
}
