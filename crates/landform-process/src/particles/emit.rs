//! Where particles start.

use landform_core::Result;
use landform_core::random::{Draws, Seed};
use landform_core::terrain::{Bounds, Erodible};

use super::flow::Fluids;
use super::motion::{Body, State};
use super::surroundings::Emitter;

/// Draws of a place before a particle is given up.
const TRIES: usize = 64;

/// What starts are drawn from.
pub(super) struct Source<'a, T> {
    pub(super) ground: &'a T,
    pub(super) bounds: Bounds,
    pub(super) fluids: &'a Fluids,
    pub(super) emitter: Emitter,
    /// Direction of the flow over the map, east and north.
    pub(super) towards: Option<[f64; 2]>,
}

impl<T: Erodible> Source<'_, T> {
    /// A start for a particle; none where there is no place.
    pub(super) fn draw(&self, body: &Body, seed: Seed) -> Result<Option<State>> {
        let mut draws = seed.draws();
        for _ in 0..TRIES {
            let Some(at) = self.place(body, &mut draws) else { continue };
            if self.ground.depth_at(at).is_none() {
                continue;
            }
            return Ok(Some(State { at, velocity: self.fluids.velocity(at)? }));
        }
        Ok(None)
    }

    fn place(&self, body: &Body, draws: &mut Draws) -> Option<[f64; 3]> {
        let Bounds { low, high } = self.bounds;
        let mut within = |a: f64, b: f64| a + (b - a) * draws.uniform();
        let open = |at: [f64; 3]| self.ground.depth_at(at).is_some_and(|depth| depth < 0.0).then_some(at);
        match &self.emitter {
            Emitter::Sky => {
                let place = [within(low[0], high[0]), within(low[1], high[1])];
                self.ground.height_at(place).map(|z| [place[0], place[1], z + 2.0 * body.radius])
            }
            Emitter::Water => {
                let at = [within(low[0], high[0]), within(low[1], high[1]), within(0.0, 2.0 * body.radius)];
                open([at[0], at[1], self.fluids.level - at[2]])
            }
            Emitter::Upwind => {
                let towards = self.towards?;
                let along = [0, 1].map(|k| towards[1 - k].abs() * (high[k] - low[k]));
                let side = usize::from(within(0.0, along[0] + along[1]) < along[0]);
                let mut at =
                    [within(low[0], high[0]), within(low[1], high[1]), within(low[2], high[2] + 2.0 * body.radius)];
                at[side] = if towards[side] > 0.0 { low[side] } else { high[side] };
                open(at)
            }
            Emitter::Point(ball) => {
                let off = [within(-1.0, 1.0), within(-1.0, 1.0), within(-1.0, 1.0)];
                let is_in = off.iter().map(|v| v * v).sum::<f64>() <= 1.0;
                let at = [0, 1, 2].map(|k| ball.at[k].si() + off[k] * ball.radius.si());
                is_in.then(|| self.lifted(at, body))
            }
            Emitter::Box(sides) => {
                let at = [0, 1, 2].map(|k| within(sides.low[k].si(), sides.high[k].si()));
                Some(self.lifted(at, body))
            }
        }
    }

    /// A place, or one over the ground where it lies under it: a vent rises with what it builds.
    fn lifted(&self, at: [f64; 3], body: &Body) -> [f64; 3] {
        let [x, y, z] = at;
        let is_under = self.ground.depth_at(at).is_some_and(|depth| depth >= 0.0);
        let surface = if is_under { self.ground.height_at([x, y]) } else { None };
        [x, y, surface.map_or(z, |surface| surface + 0.5 * body.radius)]
    }
}
