//! The way of one particle over ground that does not change.
//!
//! # Method
//! Steps of half a cell: through air or water as [`super::motion`] says; where it has come into the
//! ground it goes back to the surface. What the way up would add to its energy is taken from its
//! velocity, so that energy never grows on ground without friction. Contact lasts for the time since
//! the last one, and no longer than the particle needs for its radius: what rolls is in contact all
//! the time, and the length of steps does not show.

use landform_core::Result;
use landform_core::terrain::{Bounds, Erodible};

use super::flow::Fluids;
use super::law::Law;
use super::motion::{Body, State, dot};

/// A volume laid at a place, m³; one that is removed is negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Exchange {
    pub(super) at: [f64; 3],
    pub(super) volume: f64,
}

/// How a particle ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum End {
    /// Its load falls to the ground here.
    Here([f64; 3]),
    /// It left, and its load with it.
    Left,
}

/// What a particle did.
#[derive(Clone, Debug)]
pub(super) struct Trace {
    pub(super) radius: f64,
    /// Load at the start, m³.
    pub(super) brought: f64,
    pub(super) exchanges: Vec<Exchange>,
    pub(super) end: End,
    /// Where it was last, and its velocity.
    pub(super) last: State,
    pub(super) steps: u32,
}

/// A particle at its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Particle {
    pub(super) body: Body,
    pub(super) state: State,
    /// m³.
    pub(super) load: f64,
}

/// Steps in a row that lead nowhere, after which a particle is at rest.
const MOST_STUCK: u32 = 3;
/// Part of a cell that counts as on the surface.
const TOUCH: f64 = 1e-3;

/// Follows a particle to its end.
pub(super) fn trace<T: Erodible>(ground: &T, fluids: &Fluids, law: &Law, particle: Particle) -> Result<Trace> {
    let Particle { body, mut state, mut load } = particle;
    let (cell, volume) = (ground.resolution(), body.volume());
    let least = law.least_bounce(&body);
    let mut trace =
        Trace { radius: body.radius, brought: load, exchanges: Vec::new(), end: End::Left, last: state, steps: 0 };
    let (mut depth, mut since) = (ground.depth_at(state.at).unwrap_or(0.0), 0.0);
    let (mut hits, mut stuck) = (0, 0);
    while trace.steps < law.most_steps {
        trace.steps += 1;
        trace.last = state;
        let density = body.loaded(load / volume);
        let fluid = fluids.density(state.at[2]);
        let flow = fluids.velocity(state.at)?;
        let rise = body.weight(density, fluid);
        let speed = dot(state.velocity, state.velocity).max(dot(flow, flow)).sqrt();
        let mut dt = 0.5 * cell / (speed + (rise.abs() * 0.5 * cell).sqrt());
        if !dt.is_finite() {
            trace.end = End::Here(state.at);
            return Ok(trace);
        }
        let mut next = body.fly(state, density, fluid, flow, dt);
        let Some(next_depth) = ground.depth_at(next.at) else { return Ok(trace) };
        if !(next_depth > 0.0) {
            (state, depth, since) = (next, next_depth, since + dt);
            continue;
        }
        if depth < -TOUCH * cell {
            dt *= depth / (depth - next_depth);
            next = body.fly(state, density, fluid, flow, dt);
        }
        let Some((point, normal)) = ground.contact(next.at) else { return Ok(trace) };
        let most = if flow == [0.0; 3] { Some(2.0 * rise * (point[2] - state.at[2])) } else { None };
        let Some(away) = no_faster(law.leave(next.velocity, normal, least), state.velocity, most, rise.abs() * cell)
        else {
            // Where it cannot come up it stays.
            stuck += 1;
            state.velocity = [0.0; 3];
            if stuck > MOST_STUCK {
                break;
            }
            continue;
        };
        stuck = 0;
        let velocity = next.velocity;
        let time = (since + dt).min(body.radius / dot(velocity, velocity).sqrt().max(1e-9));
        let q = law.exchange(&body, load, dot(velocity, velocity).sqrt(), time, fluid, |material| {
            material(ground.material_at(point))
        });
        let laid = if normal[2] > 0.0 { q.deposited } else { 0.0 };
        if q.detached != laid {
            trace.exchanges.push(Exchange { at: point, volume: laid - q.detached });
            load = (load + q.detached - laid).max(0.0);
        }
        hits += 1;
        if law.most_hits.is_some_and(|most| hits >= most) {
            return Ok(trace);
        }
        state = State { at: point, velocity: away };
        (depth, since) = (0.0, 0.0);
        let push = push(&body, density, rise, flow, state.velocity);
        if law.rests(&body, state.velocity, normal, push) {
            break;
        }
    }
    (trace.end, trace.last) = (End::Here(state.at), state);
    Ok(trace)
}

/// A velocity whose square is no greater than that of the one before and what the way has added,
/// where that is known; none where the way takes more than there was. `scale` is a square of a
/// velocity beside which rounding is looked for.
fn no_faster(velocity: [f64; 3], before: [f64; 3], added: Option<f64>, scale: f64) -> Option<[f64; 3]> {
    let Some(added) = added else { return Some(velocity) };
    let (square, most) = (dot(velocity, velocity), dot(before, before) + added);
    if square <= most {
        return Some(velocity);
    }
    let part = if most > 0.0 { (most / square).sqrt() } else { 0.0 };
    (most > -1e-12 * scale).then(|| velocity.map(|v| v * part))
}

/// Acceleration by weight and flow, m/s².
fn push(body: &Body, density: f64, rise: f64, flow: [f64; 3], velocity: [f64; 3]) -> [f64; 3] {
    if !(body.viscosity > 0.0) {
        return [0.0, 0.0, rise];
    }
    let slow = body.relaxation(density);
    let drag = |k: usize| (flow[k] - velocity[k]) / slow;
    [drag(0), drag(1), drag(2) + rise]
}

/// The ground straight below a place, on which a load falls.
pub(super) fn below<T: Erodible>(ground: &T, bounds: &Bounds, at: [f64; 3]) -> [f64; 3] {
    let step = 0.5 * ground.resolution();
    let most = ((at[2] - bounds.low[2]) / step).clamp(0.0, 1e6) as usize;
    let mut place = at;
    for _ in 0..most {
        let under = [place[0], place[1], place[2] - step];
        match ground.depth_at(under) {
            Some(depth) if depth < 0.0 => place = under,
            _ => break,
        }
    }
    ground.contact(place).map_or(place, |contact| contact.0)
}
