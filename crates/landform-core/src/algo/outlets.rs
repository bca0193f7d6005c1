//! Where water leaves a terrain.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::flow::Flow;
use crate::grid::{BASE_LEVEL, Domain, INTERIOR, MASKED, Side};
use crate::terrain::NodeSurface;
use crate::units::RatioDimension;
use crate::verb::{Context, Varying};
use crate::{Error, Result};

/// Where water leaves: at these nodes the elevation is a base level, which is held.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "expected \"border\", \"valleys\", \"sea\", a list of \"north\", \"east\", \"south\", \"west\", or a table with `border_where` and `below`, or with `mask`"
)]
pub enum Outlets {
    /// By a word.
    Named(NamedOutlets),
    /// These sides of the bounding rectangle, and no others.
    Sides(Vec<Side>),
    /// Parts of the border, by a map.
    Border(BorderWhere),
    /// Anywhere, by a map.
    Mask(Mask),
}

/// Outlets by a word.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum NamedOutlets {
    /// The terrain's whole border, the rim of outer nodata included.
    Border,
    /// The low points of the border; between them the border rises and falls with the land, as on a cut-out of real ground.
    Valleys,
    /// Every node at or under sea level.
    Sea,
}

/// Border nodes where a map is below a part of its greatest value: with the map of uplift, the seed's rule (0.33).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BorderWhere {
    /// The map.
    pub border_where: Varying<RatioDimension>,
    /// Part of the map's greatest value.
    pub below: f64,
}

/// Nodes where a map is at least one half.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mask {
    /// The map.
    pub mask: Varying<RatioDimension>,
}

impl Outlets {
    /// Whether every node at or under sea level is an outlet.
    pub fn is_sea(&self) -> bool {
        matches!(self, Self::Named(NamedOutlets::Sea))
    }

    /// Makes these nodes, and no others, the terrain's base level, for every process that follows. `sea_level` in m.
    ///
    /// # Errors
    /// A map that cannot be read, or outlets without a node, with the hint where water could leave.
    pub fn apply<T: NodeSurface>(&self, terrain: &mut T, sea_level: f64, context: &Context) -> Result<()> {
        terrain.set_status(None);
        let status = match self {
            Self::Named(NamedOutlets::Border) => return Ok(()),
            Self::Named(NamedOutlets::Valleys) => valleys(terrain),
            Self::Named(NamedOutlets::Sea) => at_or_under(sea_level, terrain),
            Self::Sides(sides) => on_sides(sides, terrain),
            Self::Border(rule) => {
                let map = rule.border_where.resolve("outlets.border_where", terrain, context)?;
                let border = terrain.domain();
                let limit = rule.below * map.max();
                chosen(terrain, |i| border.status()[i] == BASE_LEVEL && map.at(i) < limit)
            }
            Self::Mask(rule) => {
                let map = rule.mask.resolve("outlets.mask", terrain, context)?;
                chosen(terrain, |i| map.at(i) >= 0.5)
            }
        };
        if !status.contains(&BASE_LEVEL) {
            return Err(self.nowhere(sea_level));
        }
        terrain.set_status(Some(status));
        Ok(())
    }

    /// The error of outlets without a node.
    fn nowhere(&self, sea_level: f64) -> Error {
        let expected = match self {
            Self::Named(NamedOutlets::Sea) => format!("ground at or under sea level, {sea_level} m, somewhere"),
            Self::Border(rule) => format!("a map with values below {} of its greatest one on the border", rule.below),
            Self::Mask(_) => "a map with values of at least 0.5 somewhere".into(),
            _ => "at least one node where water leaves".into(),
        };
        Error::parameter("outlets", "without a single node", &expected)
    }

    /// What ranges cannot say.
    ///
    /// # Errors
    /// An empty list of sides, or a part that is not between 0 and 1.
    pub fn check(&self) -> Result<()> {
        match self {
            Self::Sides(sides) if sides.is_empty() => {
                Err(Error::parameter("outlets", "[]", "at least one side, for example [\"south\"]"))
            }
            Self::Border(rule) if !(rule.below > 0.0 && rule.below <= 1.0) => {
                Err(Error::parameter("outlets.below", rule.below, "> 0 and at most 1"))
            }
            _ => Ok(()),
        }
    }
}

/// Base level where `is_outlet`, interior elsewhere, nodata as it is.
fn chosen<T: NodeSurface>(terrain: &T, is_outlet: impl Fn(usize) -> bool) -> Vec<u8> {
    let domain = terrain.domain();
    let status = domain.status();
    let new = |i: usize| match status[i] {
        MASKED => MASKED,
        _ if is_outlet(i) => BASE_LEVEL,
        _ => INTERIOR,
    };
    (0..status.len()).map(new).collect()
}

/// The status that makes every node at or under a level a base level.
pub fn at_or_under<T: NodeSurface>(level: f64, terrain: &T) -> Vec<u8> {
    chosen(terrain, |i| terrain.elevation()[i] <= level)
}

/// The level of the sea, where base levels look like one: all at or under it, all other ground above. 0 m if it may be that,
/// else the highest base level.
pub fn sea_level(status: &[u8], elevation: &[f64]) -> Option<f64> {
    let of = |kind: u8| (0..status.len()).filter(move |&i| status[i] == kind).map(|i| elevation[i]);
    let (sea, land) = (of(BASE_LEVEL).fold(f64::NEG_INFINITY, f64::max), of(INTERIOR).fold(f64::INFINITY, f64::min));
    (sea.is_finite() && sea < land).then_some(if sea <= 0.0 && land > 0.0 { 0.0 } else { sea })
}

/// Raises the water to the level of the sea at base levels below it that the sea does not reach: lagoons and hollows, which
/// are lakes to whoever stands at their shore. The sea comes in over the border, the rim of outer nodata included.
pub fn fill_inland_water<T: NodeSurface>(terrain: &T, domain: &T::Domain, sea_level: f64, water: &mut [f64]) {
    let status = domain.status();
    let [lo, hi] = terrain.bounds();
    let near = 1e-6 * (hi[0] - lo[0]).max(hi[1] - lo[1]);
    let border = terrain.border();
    let on_border = |i: usize| {
        let p = terrain.position(i);
        border[i] == BASE_LEVEL || (0..2).any(|k| p[k] - lo[k] <= near || hi[k] - p[k] <= near)
    };
    let is_water = |i: usize| status[i] == BASE_LEVEL && terrain.elevation()[i] <= sea_level;
    let mut open = vec![false; status.len()];
    let mut stack: Vec<usize> = (0..status.len()).filter(|&i| is_water(i) && on_border(i)).collect();
    stack.iter().for_each(|&i| open[i] = true);
    while let Some(i) = stack.pop() {
        for link in domain.neighbours(i) {
            if !open[link.to] && is_water(link.to) {
                open[link.to] = true;
                stack.push(link.to);
            }
        }
    }
    for i in (0..status.len()).filter(|&i| is_water(i) && !open[i]) {
        water[i] = sea_level;
    }
}

/// Of the border's base levels stay the low points of the border at which water from inside leaves when all of it is open;
/// the lowest of all, if there is none. A valley that enters from outside is no outlet.
fn valleys<T: NodeSurface>(terrain: &T) -> Vec<u8> {
    let (domain, z) = (terrain.domain(), terrain.elevation());
    let status = domain.status();
    let (mut flow, mut donors) = (Flow::new(), vec![1.0; z.len()]);
    flow.route(&*domain, z, &mut donors);
    let is_border = |i: usize| status[i] == BASE_LEVEL;
    let below = |i: usize, j: usize| (z[i], i) < (z[j], j);
    let is_low = |i: usize| domain.neighbours(i).all(|l| !is_border(l.to) || below(i, l.to));
    let mut outlets: Vec<usize> = (0..z.len()).filter(|&i| is_border(i) && donors[i] > 1.0 && is_low(i)).collect();
    if outlets.is_empty() {
        outlets.extend((0..z.len()).filter(|&i| is_border(i)).reduce(|a, b| if below(b, a) { b } else { a }));
    }
    let mut new: Vec<u8> = status.iter().map(|&s| if s == BASE_LEVEL { INTERIOR } else { s }).collect();
    for i in outlets {
        new[i] = BASE_LEVEL;
    }
    new
}

fn on_sides<T: NodeSurface>(sides: &[Side], terrain: &T) -> Vec<u8> {
    let [lo, hi] = terrain.bounds();
    let near = 1e-6 * (hi[0] - lo[0]).max(hi[1] - lo[1]);
    let on = |i: usize| {
        let [x, y] = terrain.position(i);
        sides.iter().any(|side| match side {
            Side::North => hi[1] - y <= near,
            Side::East => hi[0] - x <= near,
            Side::South => y - lo[1] <= near,
            Side::West => x - lo[0] <= near,
        })
    };
    chosen(terrain, on)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::random::Seed;
    use crate::terrain::HeightField;
    use crate::verb::NoMaps;

    fn base_count(terrain: &HeightField) -> usize {
        terrain.domain().status().iter().filter(|&&s| s == BASE_LEVEL).count()
    }

    #[test]
    fn outlets_are_set_and_set_back() {
        let grid = Grid::new(Shape::new(10, 10), [1.0, 1.0]).unwrap();
        let z = (0..100).map(|i| f64::from((i * 37) % 11)).collect();
        let mut terrain = HeightField::new(grid, z).unwrap();
        assert_eq!(base_count(&terrain), 36);
        let context = Context { seed: Seed(1), maps: &NoMaps };
        let mut apply = |outlets: &str| {
            let outlets: Outlets = serde_json::from_str(outlets).unwrap();
            outlets.check().unwrap();
            outlets.apply(&mut terrain, 3.0, &context).map(|()| base_count(&terrain))
        };
        assert!((1..18).contains(&apply("\"valleys\"").unwrap()));
        assert_eq!(apply("[\"west\"]").unwrap(), 10);
        assert_eq!(apply("\"border\"").unwrap(), 36);
        // Residues 0 to 3 of 11.
        assert_eq!(apply("\"sea\"").unwrap(), (0..100).filter(|i| (i * 37) % 11 <= 3).count());
        assert_eq!(apply(r#"{"border_where":{"formula":"u"},"below":0.3}"#).unwrap(), 10 + 2 * 2);
        assert_eq!(
            apply(r#"{"mask":{"formula":"u*v"}}"#).unwrap(),
            (0..100).filter(|i| (i % 10) * (9 - i / 10) >= 41).count()
        );
        assert!(apply(r#"{"mask":{"formula":"0*u"}}"#).unwrap_err().to_string().contains("without a single node"));
    }

    #[test]
    fn wrong_outlets_are_refused() {
        for text in ["[]", r#"{"border_where":{"formula":"u"},"below":2}"#] {
            assert!(serde_json::from_str::<Outlets>(text).unwrap().check().is_err());
        }
        let error = serde_json::from_str::<Outlets>("\"beach\"").unwrap_err().to_string();
        assert!(error.contains("\"sea\""), "{error}");
    }
}
