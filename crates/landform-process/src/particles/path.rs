//! The way of one particle over ground that does not change.
//!
//! # Method
//! Steps of half a cell. A particle in the air moves as [`super::motion`] says until it meets the
//! ground, from which it bounces or on which it rolls. One that rolls moves along the surface under
//! what pushes it there, less friction, until the ground falls away faster than the particle does.
//! A hop that is lower than a part of the radius is no hop: the particle goes on rolling, and a
//! kink of the ground is no blow unless it is steep. What the way up would add to its energy is
//! taken from its velocity, so that energy never grows on ground without friction. Contact lasts as
//! long as the particle rolls; a blow lasts for the time since the last one, and no longer than the
//! particle needs for its radius.

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
/// Part of the radius by which a particle may be over the ground and still touch it.
const TOUCH: f64 = 0.05;
/// Part of its speed with which a particle that rolls may run into a kink without a blow.
const KINK: f64 = 0.5;

/// Follows a particle to its end.
pub(super) fn trace<T: Erodible>(ground: &T, fluids: &Fluids, law: &Law, particle: Particle) -> Result<Trace> {
    let cell = ground.resolution();
    let Particle { body, state, load } = particle;
    let trace =
        Trace { radius: body.radius, brought: load, exchanges: Vec::new(), end: End::Left, last: state, steps: 0 };
    let touch = TOUCH * body.radius.max(cell);
    let least = (2.0 * super::motion::GRAVITY * touch).sqrt();
    let walk = Walk { ground, law, body, cell, touch, least, volume: body.volume(), state, load, hits: 0, trace };
    walk.end(fluids)
}

/// A particle on its way.
struct Walk<'a, T> {
    ground: &'a T,
    law: &'a Law,
    body: Body,
    cell: f64,
    /// Height up to which it touches the ground, m, and the speed with which it would rise so far.
    touch: f64,
    least: f64,
    volume: f64,
    state: State,
    load: f64,
    hits: u32,
    trace: Trace,
}

/// What surrounds it in a step.
#[derive(Clone, Copy)]
struct Around {
    /// Densities of the particle with its load, and of the fluid, kg/m³.
    density: f64,
    fluid: f64,
    flow: [f64; 3],
    /// Acceleration upwards, m/s².
    rise: f64,
}

/// How it goes on.
enum Next {
    Flies,
    /// Rolls on ground of this normal.
    Rolls([f64; 3]),
    Ends(End),
}

/// A flight: depth under the ground (negative, m) where it is, time since the last contact, and how
/// high it has been over the ground.
struct Flight {
    depth: f64,
    since: f64,
    highest: f64,
}

impl<T: Erodible> Walk<'_, T> {
    fn end(mut self, fluids: &Fluids) -> Result<Trace> {
        let depth = self.ground.depth_at(self.state.at).unwrap_or(0.0);
        let mut flight = Flight { depth, since: 0.0, highest: -depth };
        let (mut rolling, mut stuck) = (None, 0);
        while self.trace.steps < self.law.most_steps {
            self.trace.steps += 1;
            self.trace.last = self.state;
            let density = self.body.loaded(self.load / self.volume);
            let fluid = fluids.density(self.state.at[2]);
            let flow = fluids.velocity(self.state.at)?;
            let around = Around { density, fluid, flow, rise: self.body.weight(density, fluid) };
            let before = self.state.at;
            let next = match rolling {
                Some(normal) => self.roll(around, normal),
                None => self.fly(around, &mut flight),
            };
            match next {
                Next::Ends(end) => {
                    self.trace.end = end;
                    return Ok(self.trace);
                }
                Next::Rolls(normal) => rolling = Some(normal),
                Next::Flies if rolling.is_some() => {
                    flight = Flight { depth: 0.0, since: 0.0, highest: 0.0 };
                    rolling = None;
                }
                Next::Flies => {}
            }
            stuck = if self.state.at == before { stuck + 1 } else { 0 };
            if stuck > MOST_STUCK {
                break;
            }
        }
        (self.trace.end, self.trace.last) = (End::Here(self.state.at), self.state);
        Ok(self.trace)
    }

    /// Length of a step of half a cell, s; none where nothing moves the particle.
    fn step(&self, around: &Around, push: f64) -> Option<f64> {
        let speed = dot(self.state.velocity, self.state.velocity).max(dot(around.flow, around.flow)).sqrt();
        let half = 0.5 * self.cell;
        Some(half / (speed + (push * half).sqrt())).filter(|dt| dt.is_finite())
    }

    /// A step through air or water.
    fn fly(&mut self, around: Around, flight: &mut Flight) -> Next {
        let Some(mut dt) = self.step(&around, around.rise.abs()) else { return Next::Ends(End::Here(self.state.at)) };
        let moved = |dt: f64| self.body.fly(self.state, around.density, around.fluid, around.flow, dt);
        let mut next = moved(dt);
        let Some(depth) = self.ground.depth_at(next.at) else { return Next::Ends(End::Left) };
        if !(depth > 0.0) {
            self.state = next;
            (flight.depth, flight.since) = (depth, flight.since + dt);
            flight.highest = flight.highest.max(-depth);
            return Next::Flies;
        }
        if flight.depth < 0.0 {
            dt *= flight.depth / (flight.depth - depth);
            next = moved(dt);
        }
        let Some((point, normal)) = self.ground.contact(next.at) else { return Next::Ends(End::Left) };
        let time = flight.since + dt;
        let hops = flight.highest > self.touch;
        *flight = Flight { depth: 0.0, since: 0.0, highest: 0.0 };
        let speed = dot(next.velocity, next.velocity).sqrt();
        let time = if hops { time.min(self.body.radius / speed.max(1e-9)) } else { time };
        let away = if hops { self.law.leave(next.velocity, normal, self.least) } else { along(next.velocity, normal) };
        let bounces = hops && dot(away, normal) > 0.0;
        self.settle_at(point, away, &around);
        match self.exchange(point, normal, speed, time, &around) {
            Some(end) => Next::Ends(end),
            None if bounces => Next::Flies,
            None => Next::Rolls(normal),
        }
    }

    /// A step along the ground.
    fn roll(&mut self, around: Around, normal: [f64; 3]) -> Next {
        let push = push(&self.body, around.density, around.rise, around.flow, self.state.velocity);
        let into = -dot(push, normal);
        if !(into > 0.0) {
            return Next::Flies;
        }
        if self.law.rests(&self.body, self.state.velocity, normal, push) {
            return Next::Ends(End::Here(self.state.at));
        }
        let weight = tangent([0.0, 0.0, around.rise], normal);
        let pull = tangent(push, normal);
        let Some(dt) = self.step(&around, dot(pull, pull).sqrt()) else { return Next::Ends(End::Here(self.state.at)) };
        let flow = tangent(around.flow, normal);
        let rubs = rubbed(weight, self.law.friction * into, self.state.velocity, pull);
        let mut next = self.body.drift(self.state, around.density, rubs, flow, dt);
        let Some((point, there)) = self.ground.contact(next.at) else { return Next::Ends(End::Left) };
        let gap = dot([0, 1, 2].map(|k| next.at[k] - point[k]), there);
        if gap > 0.5 * into * dt * dt + 1e-9 * self.cell {
            return Next::Flies;
        }
        if self.law.friction > 0.0 && dot(next.velocity, self.state.velocity) < 0.0 && dot(weight, next.velocity) <= 0.0
        {
            // Friction stops it, and does not push it back.
            next.velocity = [0.0; 3];
        }
        let blow = -dot(next.velocity, there);
        let speed = dot(next.velocity, next.velocity).sqrt();
        let bounces = blow > self.least && blow > KINK * speed && self.law.restitution > 0.0;
        let away = if bounces { self.law.leave(next.velocity, there, self.least) } else { along(next.velocity, there) };
        self.settle_at(point, away, &around);
        match self.exchange(point, there, speed, dt, &around) {
            Some(end) => Next::Ends(end),
            None if bounces => Next::Flies,
            None => Next::Rolls(there),
        }
    }

    /// Puts it on the ground with a velocity, or leaves it where it is, at rest, where it has not
    /// the energy to come up.
    fn settle_at(&mut self, point: [f64; 3], velocity: [f64; 3], around: &Around) {
        let most = if around.flow == [0.0; 3] { Some(2.0 * around.rise * (point[2] - self.state.at[2])) } else { None };
        self.state = match no_faster(velocity, self.state.velocity, most, around.rise.abs() * self.cell) {
            Some(velocity) => State { at: point, velocity },
            None => State { velocity: [0.0; 3], ..self.state },
        };
    }

    /// Wears and lays down in a contact; the end, if it was the last that it has.
    fn exchange(&mut self, point: [f64; 3], normal: [f64; 3], speed: f64, time: f64, around: &Around) -> Option<End> {
        let q = self.law.exchange(&self.body, self.load, speed, time, around.fluid, |material| {
            material(self.ground.material_at(point))
        });
        let laid = if normal[2] > 0.0 { q.deposited } else { 0.0 };
        if q.detached != laid {
            self.trace.exchanges.push(Exchange { at: point, volume: laid - q.detached });
            self.load = (self.load + q.detached - laid).max(0.0);
        }
        self.hits += 1;
        self.law.most_hits.is_some_and(|most| self.hits >= most).then_some(End::Left)
    }
}

/// The part of a vector along ground of a normal.
fn tangent(vector: [f64; 3], normal: [f64; 3]) -> [f64; 3] {
    let across = dot(vector, normal);
    [0, 1, 2].map(|k| vector[k] - across * normal[k])
}

/// A velocity turned along the ground, as fast as it was.
fn along(velocity: [f64; 3], normal: [f64; 3]) -> [f64; 3] {
    let turned = tangent(velocity, normal);
    let (before, after) = (dot(velocity, velocity), dot(turned, turned));
    let scale = if after > 0.0 { (before / after).sqrt() } else { 0.0 };
    turned.map(|v| v * scale)
}

/// An acceleration along the ground less that of friction, which acts against the motion, or
/// against the pull on what is at rest.
fn rubbed(weight: [f64; 3], friction: f64, velocity: [f64; 3], pull: [f64; 3]) -> [f64; 3] {
    let against = if velocity == [0.0; 3] { pull } else { velocity };
    let length = dot(against, against).sqrt();
    let scale = if length > 0.0 { friction / length } else { 0.0 };
    [0, 1, 2].map(|k| weight[k] - scale * against[k])
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

/// Steepest slope on which a load lies: 35 degrees.
const LIES: f64 = 0.7;
/// Radii that a load slides at most.
const MOST_SLIDES: usize = 32;
const DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Ways to slide, east and north.
const WAYS: [[f64; 2]; 8] = [
    [1.0, 0.0],
    [DIAGONAL, DIAGONAL],
    [0.0, 1.0],
    [-DIAGONAL, DIAGONAL],
    [-1.0, 0.0],
    [-DIAGONAL, -DIAGONAL],
    [0.0, -1.0],
    [DIAGONAL, -DIAGONAL],
];

/// Where a load that is dropped comes to lie: on the ground below, and from there down as long as
/// it is steeper than a heap over the radius of the particle.
pub(super) fn lies<T: Erodible>(ground: &T, bounds: &Bounds, at: [f64; 3], radius: f64) -> [f64; 3] {
    let reach = radius.max(ground.resolution());
    let mut place = below(ground, bounds, at);
    for _ in 0..MOST_SLIDES {
        let beside = WAYS.map(|[x, y]| [place[0] + reach * x, place[1] + reach * y, place[2]]);
        let open = beside.into_iter().filter(|&start| ground.depth_at(start).is_some_and(|depth| depth < 0.0));
        let lowest = open.map(|start| below(ground, bounds, start)).min_by(|a, b| a[2].total_cmp(&b[2]));
        match lowest.filter(|lowest| place[2] - lowest[2] > LIES * reach) {
            Some(lowest) => place = lowest,
            None => break,
        }
    }
    place
}

/// The ground straight below a place.
fn below<T: Erodible>(ground: &T, bounds: &Bounds, at: [f64; 3]) -> [f64; 3] {
    let step = 0.5 * ground.resolution();
    let most = ((at[2] - bounds.low[2]) / step).clamp(0.0, 1e6) as usize;
    let mut place = at;
    for _ in 0..most {
        let under = [place[0], place[1], place[2] - step];
        match ground.depth_at(under) {
            // Where the way to the ground is known it is gone at once.
            Some(depth) if depth < 0.0 => place = [under[0], under[1], under[2] - (-depth - step).max(0.0)],
            _ => break,
        }
    }
    ground.contact(place).map_or(place, |contact| contact.0)
}
