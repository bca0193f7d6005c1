//! Where water leaves a terrain, as a parameter.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Context, Varying};
use crate::algo::outlets::{at_or_under, chosen, holes, on_sides, valleys};
use crate::grid::{Domain, Side, Status};
use crate::terrain::NodeSurface;
use crate::units::RatioDimension;
use crate::{Error, Result};

/// Where water leaves: at these nodes the elevation is a base level, which is held.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "expected \"border\", \"valleys\", \"holes\", \"sea\", a list of \"north\", \"east\", \"south\", \"west\", or a table with `border_where` and `below`, or with `mask`"
)]
pub enum Outlets {
    /// By name.
    Named(NamedOutlets),
    /// These sides of the bounding rectangle, and no others.
    Sides(Vec<Side>),
    /// Parts of the border, by a map.
    Border(BorderWhere),
    /// Anywhere, by a map.
    Mask(Mask),
}

/// Outlets by name.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum NamedOutlets {
    /// The terrain's whole border, the rim of outer nodata included.
    Border,
    /// The low points of the border; between them the border rises and falls with the land, as on a
    /// cut-out of real ground.
    Valleys,
    /// As "valleys", and the rims of nodata inside: water leaves into lakes that were cut out.
    Holes,
    /// Every node at or under sea level.
    Sea,
}

/// Border nodes where a map is below a fraction of its greatest value. With the map of uplift this
/// is the rule of Bell's thesis (0.33).
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

    /// Makes these nodes, and no others, the terrain's base level, for every process that follows.
    /// `sea_level` in m.
    ///
    /// # Errors
    /// If a map cannot be read, or if the outlets have no node; then a hint says where water could
    /// leave.
    pub fn apply<T: NodeSurface>(&self, terrain: &mut T, sea_level: f64, context: &Context) -> Result<()> {
        terrain.set_status(None);
        let status = match self {
            Self::Named(NamedOutlets::Border) => return Ok(()),
            Self::Named(NamedOutlets::Valleys) => valleys(terrain),
            Self::Named(NamedOutlets::Holes) => holes(terrain),
            Self::Named(NamedOutlets::Sea) => at_or_under(sea_level, terrain),
            Self::Sides(sides) => on_sides(sides, terrain),
            Self::Border(rule) => {
                let map = rule.border_where.resolve("outlets.border_where", terrain, context)?;
                let border = terrain.domain();
                let limit = rule.below * map.max();
                chosen(terrain, |i| border.status()[i] == Status::BaseLevel && map.at(i) < limit)
            }
            Self::Mask(rule) => {
                let map = rule.mask.resolve("outlets.mask", terrain, context)?;
                chosen(terrain, |i| map.at(i) >= 0.5)
            }
        };
        if !status.contains(&Status::BaseLevel) {
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

    /// Checks that ranges cannot express.
    ///
    /// # Errors
    /// If the list of sides is empty, or the part is not between 0 and 1.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::random::Seed;
    use crate::terrain::HeightField;

    fn base_count(terrain: &HeightField) -> usize {
        terrain.domain().status().iter().filter(|&&s| s == Status::BaseLevel).count()
    }

    #[test]
    fn outlets_are_set_and_set_back() {
        let grid = Grid::new(Shape::new(10, 10), [1.0, 1.0]).unwrap();
        let z = (0..100).map(|i| f64::from((i * 37) % 11)).collect();
        let mut terrain = HeightField::new(grid, z).unwrap();
        assert_eq!(base_count(&terrain), 36);
        let context = Context { seed: Seed(1), ..Context::default() };
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
    fn water_leaves_into_holes_where_it_may() {
        let grid = Grid::new(Shape::new(9, 9), [1.0, 1.0]).unwrap();
        // A bowl whose bottom is cut out, and a corner without data, which is outside.
        let cut = |i: usize| (i / 9 == 4 && i % 9 == 4) || i == 80;
        let height = |i: usize| (i as f64 / 9.0 - 4.0).abs() + (i % 9) as f64 * 0.1;
        let z = (0..81).map(|i| if cut(i) { f64::NAN } else { height(i) }).collect();
        let mut terrain = HeightField::new(grid, z).unwrap();
        let context = Context::default();
        let mut count = |word: NamedOutlets| {
            Outlets::Named(word).apply(&mut terrain, 0.0, &context).unwrap();
            base_count(&terrain)
        };
        assert_eq!(count(NamedOutlets::Holes), count(NamedOutlets::Valleys) + 8);
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
