//! Places that a network must reach: sinkholes and the feet of their shafts, waypoints.

use landform_core::random::{Draws, Seed};
use landform_core::units::Length;
use landform_core::{Error, Result, math};

use super::rock::Rock;
use super::space::{Vector, plus, unit};
use super::{KarstNetwork, Sinkholes};

/// What a network joins.
pub(super) struct Keys {
    /// From each sinkhole down to the water table.
    pub(super) shafts: Vec<Vec<Vector>>,
    pub(super) waypoints: Vec<Vector>,
}

impl Keys {
    /// # Errors
    /// [`Error::Parameter`] where there is no ground for sinkholes.
    pub(super) fn new(params: &KarstNetwork, rock: &Rock<'_>) -> Result<Self> {
        let seed = rock.seed;
        let places = match &params.sinkholes {
            Sinkholes::Count(count) => at_random(*count as usize, rock, seed.named("sinkholes"))?,
            Sinkholes::Places(places) => {
                places.iter().map(|p| given(p.map(Length::si), rock)).collect::<Result<_>>()?
            }
        };
        let shafts: Vec<Vec<Vector>> =
            (0..).zip(&places).map(|(k, p)| shaft(*p, rock, &mut seed.named("shafts").with(k).draws())).collect();
        let waypoints = params.waypoints.iter().map(|w| rock.held(w.map(Length::si))).collect();
        Ok(Self { shafts, waypoints })
    }

    /// Feet of shafts and waypoints.
    pub(super) fn ends(&self) -> Vec<Vector> {
        let feet = self.shafts.iter().map(|s| s[s.len() - 1]);
        feet.chain(self.waypoints.iter().copied()).collect()
    }
}

fn given([x, y]: [f64; 2], rock: &Rock<'_>) -> Result<Vector> {
    let z = rock.surface(x, y);
    if z.is_finite() {
        return Ok([x, y, z]);
    }
    Err(Error::parameter("sinkholes", format!("{x}, {y} m"), "places on the map, on ground with data"))
}

/// Sinkholes on ground well above the water table, denser where noise is high: they lie in groups.
fn at_random(count: usize, rock: &Rock<'_>, seed: Seed) -> Result<Vec<Vector>> {
    let [low, high] = rock.bounds;
    let mut draws = seed.draws();
    let mut found: Vec<Vector> = Vec::with_capacity(count);
    let least = 2.0 * rock.step;
    for tries in 0..400 * count + 4_000 {
        if found.len() == count {
            break;
        }
        let part = [draws.uniform(), draws.uniform()].map(|u| 0.02 + 0.96 * u);
        let [x, y] = [0, 1].map(|k| math::lerp(low[k], high[k], part[k]));
        let z = rock.surface(x, y);
        let above = z - rock.water_table([x, y, 0.0]);
        let grouped = Rock::noise(seed, [x, y, 0.0], 8.0 * rock.bend) > 1.2 * draws.uniform() - 0.8;
        // Room runs short on a small map; then they may lie nearer to each other.
        let apart = least * 1.0_f64.min(2.0 - 4.0 * tries as f64 / (400 * count + 4_000) as f64).max(0.0);
        let is_free = found.iter().all(|f| math::hypot(f[0] - x, f[1] - y) >= apart);
        if above > 2.0 * rock.cover() && grouped && is_free {
            found.push([x, y, z]);
        }
    }
    if found.len() == count {
        return Ok(found);
    }
    let expected = format!("at most {}: there is no more ground above the water table", found.len());
    Err(Error::parameter("sinkholes", count, &expected))
}

/// The way of water from a sinkhole down: shafts, and short meanders where it meets less soluble
/// beds.
fn shaft(from: Vector, rock: &Rock<'_>, draws: &mut Draws) -> Vec<Vector> {
    let level = rock.water_table(from);
    // Passages begin mostly near the water table, some far under it.
    let u = draws.uniform();
    let foot = (level - u * u * rock.depth).min(from[2] - rock.cover());
    let mut way = vec![from];
    let mut at = from;
    let turn = std::f64::consts::TAU * draws.uniform();
    let mut heading = [math::sin(turn), math::cos(turn), 0.0];
    while at[2] - foot > 0.5 * rock.step {
        let is_shaft = draws.uniform() < 0.6;
        let turn = std::f64::consts::PI * (draws.uniform() - 0.5);
        let (s, c) = (math::sin(turn), math::cos(turn));
        heading = [c * heading[0] - s * heading[1], s * heading[0] + c * heading[1], 0.0];
        let slope = if is_shaft { 4.0 } else { 0.6 };
        let direction = unit(plus([heading[0], heading[1], 0.0], [0.0, 0.0, -1.0], slope));
        let guided = rock.guided(at, direction);
        let direction = if guided[2] < -0.3 { guided } else { direction };
        // The last step ends at the foot.
        let far = rock.step.min((at[2] - foot) / -direction[2]);
        at = rock.inside(plus(at, direction, far), 0.0);
        at[2] = at[2].max(foot);
        way.push(at);
        if way.len() > 5_000 {
            break;
        }
    }
    if way.len() == 1 {
        way.push(rock.held([from[0], from[1], foot]));
    }
    way
}
