//! Strokes into a model that runs or is held.

use std::collections::VecDeque;
use std::sync::Mutex;
use std::time::Instant;

use landform::core::grid::Neighbours;
use landform::core::terrain::{AnyTerrain, Body, Surface, Visit};
use landform::core::verb::covered;
use landform::recipe::Moment;
use landform::{Error, Result};
use serde::Deserialize;

use crate::hub::lock;

/// Strokes that wait.
const MOST_WAITING: usize = 64;
/// Points of a stroke.
const MOST_POINTS: usize = 1_000;
/// A touch counts as so long, s.
const TOUCH: f64 = 0.1;

/// What a stroke does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Tool {
    Raise,
    Lower,
    Smooth,
    Level,
}

/// A piece of a stroke.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) tool: Tool,
    /// Distance from its line up to which it reaches, m.
    pub(crate) radius: f64,
    /// Metres in its middle after a second at full pressure.
    pub(crate) strength: f64,
    /// [x, y, pressure, seconds].
    pub(crate) points: Vec<Vec<f64>>,
}

/// Strokes on their way to the model.
#[derive(Default)]
pub(crate) struct Easel {
    pieces: Mutex<VecDeque<Piece>>,
    last: Mutex<Option<Instant>>,
}

impl Piece {
    fn check(&self) -> Result<()> {
        let finite = |value: f64, most: f64| value.is_finite() && value.abs() <= most;
        if !(self.radius > 0.0 && finite(self.radius, 1e9)) {
            return Err(Error::parameter("radius", self.radius, "> 0 m"));
        }
        if !finite(self.strength, 1e6) {
            return Err(Error::parameter("strength", self.strength, "at most 1000 km"));
        }
        let places = self.points.iter().all(|p| (2..=4).contains(&p.len()) && p.iter().all(|&x| finite(x, 1e12)));
        let pressed = self.points.iter().all(|p| p.get(2).is_none_or(|p| (0.0..=1.0).contains(p)));
        if self.points.is_empty() || self.points.len() > MOST_POINTS || !places || !pressed {
            return Err(Error::parameter(
                "points",
                format!("{} points", self.points.len()),
                "1 to 1000 of [x, y, pressure 0 to 1, seconds]",
            ));
        }
        Ok(())
    }

    fn seconds(&self) -> f64 {
        let at = |point: Option<&Vec<f64>>| point.and_then(|p| p.get(3)).copied().unwrap_or(0.0);
        (at(self.points.last()) - at(self.points.first())).clamp(TOUCH, 1.0)
    }
}

impl Easel {
    /// Puts a piece to those that wait.
    ///
    /// # Errors
    /// [`Error::Parameter`] for numbers that make no stroke, or too many of them.
    pub(crate) fn put(&self, piece: Piece) -> Result<()> {
        piece.check()?;
        let mut pieces = lock(&self.pieces);
        if pieces.len() >= MOST_WAITING {
            return Err(Error::parameter("points", "more strokes than the model takes", "a slower brush"));
        }
        pieces.push_back(piece);
        *lock(&self.last) = Some(Instant::now());
        Ok(())
    }

    pub(crate) fn clear(&self) {
        lock(&self.pieces).clear();
        *lock(&self.last) = None;
    }

    /// Seconds since the last stroke.
    pub(crate) fn idle(&self) -> f64 {
        lock(&self.last).map_or(f64::INFINITY, |last| last.elapsed().as_secs_f64())
    }

    /// Paints what waits; whether anything changed.
    pub(crate) fn paint(&self, moment: &mut dyn Moment) -> Result<bool> {
        let mut changed = false;
        loop {
            let Some(piece) = lock(&self.pieces).pop_front() else { return Ok(changed) };
            changed |= apply(&piece, moment)?;
        }
    }
}

fn apply(piece: &Piece, moment: &mut dyn Moment) -> Result<bool> {
    let much = piece.strength * piece.seconds();
    let cover = |at: [f64; 2]| covered(&piece.points, piece.radius, at);
    match piece.tool {
        Tool::Raise => moment.edit(&|_, at, z| z + much * cover(at)),
        Tool::Lower => moment.edit(&|_, at, z| z - much * cover(at)),
        Tool::Level => {
            let first = [piece.points[0][0], piece.points[0][1]];
            let level = moment.ground().visit(Nearest(first));
            moment.edit(&|_, at, z| if level.is_finite() { z + (level - z) * cover(at) } else { z })
        }
        Tool::Smooth => {
            let means = means(&moment.ground());
            moment.edit(&|i, at, z| match means.get(i) {
                Some(mean) if mean.is_finite() => z + (mean - z) * cover(at),
                _ => z,
            })
        }
    }
}

/// The elevation of the node nearest to a place.
struct Nearest([f64; 2]);

impl Visit for Nearest {
    type Out = f64;

    fn surface<T: Surface>(self, terrain: &T) -> f64 {
        let z = terrain.elevation();
        let away = |i: usize| {
            let [x, y] = terrain.position(i);
            (x - self.0[0]) * (x - self.0[0]) + (y - self.0[1]) * (y - self.0[1])
        };
        let valid = (0..z.len()).filter(|&i| z[i].is_finite());
        valid.min_by(|&a, &b| away(a).total_cmp(&away(b))).map_or(f64::NAN, |i| z[i])
    }

    fn body<T: Body>(self, _: &T) -> f64 {
        f64::NAN
    }
}

/// The mean of each node's neighbours and itself.
fn means(ground: &AnyTerrain) -> Vec<f64> {
    struct Means;
    impl Visit for Means {
        type Out = Vec<f64>;

        fn surface<T: Surface>(self, terrain: &T) -> Vec<f64> {
            let (domain, z) = (terrain.domain(), terrain.elevation());
            let mean = |i: usize| {
                let around = domain.neighbours(i).map(|link| z[link.to]).filter(|z| z.is_finite());
                let (sum, n) = around.fold((z[i], 1.0), |(sum, n), z| (sum + z, n + 1.0));
                sum / n
            };
            (0..z.len()).map(mean).collect()
        }

        fn body<T: Body>(self, _: &T) -> Vec<f64> {
            Vec::new()
        }
    }
    ground.visit(Means)
}
