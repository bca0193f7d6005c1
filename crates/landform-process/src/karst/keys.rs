//! Places that a network must reach: sinkholes and the feet of their shafts, waypoints.

use landform_core::units::{Length, place_text};
use landform_core::{Error, Result, math};

use super::rock::Rock;
use super::space::{Vector, distance, plus, unit};
use super::{KarstNetwork, Sinkholes};

/// What a network joins.
pub(super) struct Keys {
    /// From each sinkhole down to the water table.
    pub(super) shafts: Vec<Vec<Vector>>,
    pub(super) waypoints: Vec<Vector>,
}

/// More places along shafts than this are refused.
const MOST_PLACES: f64 = 1e6;

impl Keys {
    /// # Errors
    /// [`Error::Parameter`] for sinkholes off the ground, in forbidden spheres or from which no way
    /// leads down; [`Error::Recipe`] where there is no ground for sinkholes at random.
    pub(super) fn new(params: &KarstNetwork, rock: &Rock<'_>) -> Result<Self> {
        let shafts = match &params.sinkholes {
            Sinkholes::Count(count) => at_random(*count as usize, rock)?,
            Sinkholes::Places(places) => {
                (0..).zip(places).map(|(k, p)| given(k, p.map(Length::si), rock)).collect::<Result<_>>()?
            }
        };
        let waypoints = params.waypoints.iter().map(|w| w.map(Length::si)).collect();
        Ok(Self { shafts, waypoints })
    }

    /// Feet of shafts and waypoints.
    pub(super) fn ends(&self) -> Vec<Vector> {
        let feet = self.shafts.iter().map(|s| s[s.len() - 1]);
        feet.chain(self.waypoints.iter().copied()).collect()
    }
}

fn given(number: u64, [x, y]: [f64; 2], rock: &Rock<'_>) -> Result<Vec<Vector>> {
    let z = rock.surface(x, y);
    let refused = |expected: &str| Err(Error::parameter("sinkholes", place_text([x, y]), expected));
    if !z.is_finite() {
        return refused("places on the map, on ground with data");
    }
    if !rock.is_free([x, y, z]) {
        return refused("places outside `forbidden` spheres");
    }
    check_height(1, z - rock.water_table([x, y, z]), rock)?;
    match shaft(number, [x, y, z], rock) {
        Some(shaft) => Ok(shaft),
        None => refused("places from which water can fall to the water table, past `forbidden` spheres and nodata"),
    }
}

/// Refuses shafts of so many steps that they would fill memory.
fn check_height(count: usize, height: f64, rock: &Rock<'_>) -> Result<()> {
    let places = count as f64 * (height / rock.step).max(1.0);
    if places <= MOST_PLACES {
        return Ok(());
    }
    let given = format!("{} m: {places:.0} places along shafts", rock.step);
    Err(Error::parameter(
        "step",
        given,
        &format!("steps of which shafts have at most {MOST_PLACES:.0}; try longer ones"),
    ))
}

/// Why places are no sinkholes, and how many.
#[derive(Default)]
struct Refused {
    /// Greatest height above the water table of ground at all, m.
    highest: Option<f64>,
    /// High enough, and in a forbidden sphere.
    in_spheres: usize,
    /// High enough, and without a way down.
    without_way: usize,
}

/// Sinkholes on ground well above the water table, denser where noise is high: they lie in groups.
fn at_random(count: usize, rock: &Rock<'_>) -> Result<Vec<Vec<Vector>>> {
    let seed = rock.seed.named("sinkholes");
    let [low, high] = rock.bounds;
    let mut draws = seed.draws();
    let mut found: Vec<Vec<Vector>> = Vec::with_capacity(count);
    let mut refused = Refused::default();
    let least = 2.0 * rock.step;
    let most_tries = 400 * count + 4_000;
    for tries in 0..most_tries {
        if found.len() == count {
            break;
        }
        let part = [draws.uniform(), draws.uniform()].map(|u| 0.02 + 0.96 * u);
        let [x, y] = [0, 1].map(|k| math::lerp(low[k], high[k], part[k]));
        let z = rock.surface(x, y);
        let above = z - rock.water_table([x, y, 0.0]);
        let is_late = 2 * tries > most_tries;
        let grouped = Rock::noise(seed, [x, y, 0.0], 8.0 * rock.bend) > 1.2 * draws.uniform() - 0.8;
        // Room runs short on a small map; then they may lie nearer to each other.
        let apart = least * 1.0_f64.min(2.0 - 4.0 * tries as f64 / most_tries as f64).max(0.0);
        let is_alone = found.iter().all(|f| math::hypot(f[0][0] - x, f[0][1] - y) >= apart);
        if above.is_finite() {
            refused.highest = Some(refused.highest.map_or(above, |h| h.max(above)));
        }
        if !(above > 2.0 * rock.cover() && (grouped || is_late) && is_alone) {
            continue;
        }
        check_height(count, above, rock)?;
        if !rock.is_free([x, y, z]) {
            refused.in_spheres += 1;
        } else if let Some(shaft) = shaft(found.len() as u64, [x, y, z], rock) {
            found.push(shaft);
        } else {
            refused.without_way += 1;
        }
    }
    if found.len() == count { Ok(found) } else { Err(refused.told(found.len(), count, rock)) }
}

impl Refused {
    fn told(&self, found: usize, count: usize, rock: &Rock<'_>) -> Error {
        let needed = 2.0 * rock.cover();
        let highest = self.highest.unwrap_or(f64::NEG_INFINITY);
        let fewer = if found > 0 { format!("ask for at most {found} sinkholes, or ") } else { String::new() };
        let (why, hint) = if self.highest.is_none() {
            ("hardly any of the ground has data".to_string(), "give the places of sinkholes".into())
        } else if highest <= 0.0 {
            let why = format!("all ground lies under the water table, {:.1} m at least", -highest);
            (why, "give a lower `water_table`, or springs lower down".into())
        } else if highest <= needed {
            let why = format!(
                "the ground rises {highest:.1} m above the water table; {needed:.1} m are needed, twice the rock over the thinnest passage"
            );
            (why, "give a lower `water_table` or a smaller thinnest `radius`".into())
        } else if self.in_spheres > self.without_way {
            ("`forbidden` spheres take the rest of the ground".to_string(), format!("{fewer}give smaller spheres"))
        } else if self.without_way > 0 {
            let why = "`forbidden` spheres or nodata leave no way down to the water table elsewhere".to_string();
            (why, format!("{fewer}give smaller spheres"))
        } else {
            let why = "too little ground stands high enough above the water table".to_string();
            (why, format!("{fewer}give a lower `water_table`"))
        };
        Error::Recipe { at: None, what: format!("{found} of {count} sinkholes have a place: {why}"), hint: Some(hint) }
    }
}

/// The way of water from a sinkhole down: shafts, and short meanders where it meets less soluble
/// beds. None where spheres or nodata are in the way.
fn shaft(number: u64, from: Vector, rock: &Rock<'_>) -> Option<Vec<Vector>> {
    let mut draws = rock.seed.named("shafts").with(number).draws();
    let level = rock.water_table(from);
    // Passages begin mostly near the water table, some far under it.
    let u = draws.uniform();
    let foot = (level - u * u * rock.depth).min(from[2] - rock.cover());
    let mut way = vec![from];
    let mut at = from;
    let turn = std::f64::consts::TAU * draws.uniform();
    let mut heading = [math::sin(turn), math::cos(turn), 0.0];
    let most = 8 * ((from[2] - foot) / rock.step) as usize + 1_000;
    while at[2] - foot > 0.5 * rock.step || way.len() == 1 {
        let is_shaft = draws.uniform() < 0.6;
        let turn = std::f64::consts::PI * (draws.uniform() - 0.5);
        let (s, c) = (math::sin(turn), math::cos(turn));
        heading = [c * heading[0] - s * heading[1], s * heading[0] + c * heading[1], 0.0];
        let slope = if is_shaft { 4.0 } else { 0.6 };
        let direction = unit(plus([heading[0], heading[1], 0.0], [0.0, 0.0, -1.0], slope));
        let guided = rock.guided(at, direction);
        let direction = if guided[2] < -0.3 { guided } else { direction };
        at = fall(at, direction, heading, foot, rock)?;
        way.push(at);
        if way.len() > most {
            return None;
        }
    }
    Some(way)
}

/// A step down: in a direction, or straight down, or along the wall of a sphere.
fn fall(at: Vector, direction: Vector, heading: Vector, foot: f64, rock: &Rock<'_>) -> Option<Vector> {
    let wall = rock.along_wall(at, heading);
    let ways = [direction, [0.0, 0.0, -1.0], wall];
    let places = ways.into_iter().map(|way| {
        // The last step ends at the foot.
        let far = if way[2] < 0.0 { rock.step.min((at[2] - foot) / -way[2]) } else { rock.step };
        let mut to = rock.inside(plus(at, way, far), 0.0);
        to[2] = to[2].max(foot);
        to
    });
    let gains = |to: &Vector| to[2] < at[2] - 1e-3 * rock.step;
    let places: Vec<Vector> = places.filter(|to| rock.is_in_rock(*to)).collect();
    // On top of a sphere a step along its wall hardly falls.
    places
        .iter()
        .find(|to| gains(to))
        .or_else(|| places.iter().find(|to| distance(**to, at) > 0.5 * rock.step))
        .copied()
}
