//! Masks of places with given properties.

use landform_core::algo::derivative::{gradient, position_index};
use landform_core::field::{Values, names};
use landform_core::terrain::{HeightField, NodeSurface};
use landform_core::units::{Angle, Length, RatioDimension};
use landform_core::verb::{Context, Edit, Params, Reach, Source, Varying};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Adds a mask, a field from 0 to 1: it is 1 within all the given ranges of elevation, slope,
/// direction and position, and is multiplied by a map. Other stages use it as { field = "mask" }.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Mask {
    /// Name of the field.
    pub name: String,
    /// Range of elevation, lowest and highest.
    pub elevation: Option<[Length; 2]>,
    /// Range of slope, least and greatest.
    #[schemars(extend("x-min" = 0.0, "x-max" = 90.0))]
    pub slope: Option<[Angle; 2]>,
    /// Range of the compass direction that the ground faces, from the first clockwise to the
    /// second.
    pub aspect: Option<[Angle; 2]>,
    /// Range of height above the mean of the surrounding ground: ridges are above 0, valleys below.
    pub position: Option<[Length; 2]>,
    /// Position: half of the side of the square around each node.
    #[schemars(extend("x-above" = 0.0))]
    pub radius: Length,
    /// Map by which the mask is multiplied.
    pub map: Option<Varying<RatioDimension>>,
    /// Fraction of each range over which the mask rises and falls at its ends. With 0 edges are
    /// sharp.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub softness: f64,
    /// Whether the mask chooses everything else instead.
    pub invert: bool,
}

impl Default for Mask {
    fn default() -> Self {
        Self {
            name: names::MASK.name.into(),
            elevation: None,
            slope: None,
            aspect: None,
            position: None,
            radius: Length::of(500.0),
            map: None,
            softness: 0.2,
            invert: false,
        }
    }
}

impl Params for Mask {
    const NAME: &'static str = "mask";
    const SOURCES: &'static [Source] = &[];

    fn leaves(&self) -> Vec<String> {
        vec![self.name.clone()]
    }

    fn reach(&self) -> Reach {
        let map = self.map.as_ref().map_or(Reach::Point, Varying::reach);
        let sides = if self.slope.is_some() || self.aspect.is_some() { Reach::Cells(1) } else { Reach::Point };
        // Sums slide along rows.
        let position = if self.position.is_some() { Reach::Whole } else { Reach::Point };
        map.or(sides).or(position)
    }

    fn check(&self) -> Result<()> {
        if self.name.is_empty() || self.name == names::ELEVATION.name {
            return Err(Error::parameter("name", format!("\"{}\"", self.name), "a name of its own, such as \"mask\""));
        }
        let wrong = |name: &str, [a, b]: [f64; 2]| {
            (a > b).then(|| Error::parameter(name, "a range that runs down", "the lesser value first"))
        };
        let ranges = [
            ("elevation", self.elevation.map(|r| r.map(Length::si))),
            ("slope", self.slope.map(|r| r.map(Angle::si))),
            ("position", self.position.map(|r| r.map(Length::si))),
        ];
        match ranges.into_iter().find_map(|(name, range)| wrong(name, range?)) {
            Some(error) => Err(error),
            None => Ok(()),
        }
    }
}

impl Mask {
    /// 1 within a range, 0 outside, rising and falling about its ends.
    fn within(&self, [from, to]: [f64; 2], value: f64) -> f64 {
        let half = 0.5 * self.softness * (to - from);
        math::smoothstep(from - half, from + half, value) * (1.0 - math::smoothstep(to - half, to + half, value))
    }

    /// As [`Mask::within`], on the circle.
    fn facing(&self, [from, to]: [f64; 2], aspect: f64) -> f64 {
        let turn = std::f64::consts::TAU;
        let width = (to - from).rem_euclid(turn);
        // Distance from the middle of the range.
        let middle = from + 0.5 * width;
        let d = ((aspect - middle + 0.5 * turn).rem_euclid(turn) - 0.5 * turn).abs();
        let half = 0.5 * self.softness * width;
        1.0 - math::smoothstep(0.5 * width - half, 0.5 * width + half, d)
    }
}

impl Edit<HeightField> for Mask {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        let map = self.map.as_ref().map(|m| m.resolve("map", terrain, context)).transpose()?;
        let (grid, z) = (terrain.grid(), terrain.elevation());
        let cell = grid.spacing[0].max(grid.spacing[1]);
        let radius = (self.radius.si() / cell).round().max(1.0) as usize;
        let position = self.position.map(|range| (range.map(Length::si), position_index(grid.shape, z, radius)));
        let values = parallel::map(z.len(), |i| {
            let mut mask = map.as_ref().map_or(1.0, |m| m.at(i).clamp(0.0, 1.0));
            if let Some(range) = self.elevation {
                mask *= self.within(range.map(Length::si), z[i]);
            }
            if self.slope.is_some() || self.aspect.is_some() {
                let g = gradient(grid, z, i);
                if let Some(range) = self.slope {
                    mask *= self.within(range.map(Angle::si), math::atan(g.slope()));
                }
                if let Some(range) = self.aspect {
                    let aspect = g.aspect();
                    mask *= if aspect.is_nan() { 0.0 } else { self.facing(range.map(Angle::si), aspect) };
                }
            }
            if let Some((range, index)) = &position {
                mask *= self.within(*range, index[i]);
            }
            let chosen = if self.invert { 1.0 - mask } else { mask };
            if z[i].is_nan() { 0.0 } else { chosen }
        });
        terrain.fields.insert_values(&self.name, Values::F64(values))?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::{Grid, Shape};
    use landform_core::random::Seed;

    fn masked(json: &str) -> Vec<f64> {
        // A roof: the west side rises eastwards to 500 m, the east side falls again, both at 45
        // degrees.
        let grid = Grid::new(Shape::new(3, 11), [100.0, 100.0]).unwrap();
        let z = (0..33).map(|i| 500.0 - 100.0 * (grid.position(i)[0] / 100.0 - 5.0).abs()).collect();
        let mut terrain = HeightField::new(grid, z).unwrap();
        let mask: Mask = serde_json::from_str(json).unwrap();
        mask.validate().unwrap();
        mask.edit(&mut terrain, &Context { seed: Seed(1), ..Context::default() }).unwrap();
        terrain.real("mask", "a test").unwrap()[11..22].to_vec()
    }

    #[test]
    fn places_are_chosen_by_what_they_are() {
        let high = masked(r#"{"elevation":["250 m","900 m"],"softness":0}"#);
        assert_eq!(high, [0., 0., 0., 1., 1., 1., 1., 1., 0., 0., 0.]);
        let west = masked(r#"{"aspect":["225 deg","315 deg"],"softness":0}"#);
        assert_eq!(west, [1., 1., 1., 1., 1., 0., 0., 0., 0., 0., 0.]);
        let round_north = masked(r#"{"aspect":["315 deg","135 deg"],"softness":0}"#);
        assert_eq!(round_north, [0., 0., 0., 0., 0., 0., 1., 1., 1., 1., 1.]);
        let level = masked(r#"{"slope":["40 deg","90 deg"],"softness":0,"invert":true}"#);
        assert_eq!((level[5], level[2]), (1.0, 0.0));
        let ridge = masked(r#"{"position":["10 m","1000 m"],"radius":"200 m","softness":0}"#);
        assert!(ridge[5] == 1.0 && ridge[2] == 0.0);
        let soft = masked(r#"{"elevation":["200 m","400 m"],"softness":1}"#);
        assert!(soft[3] == 1.0 && soft[2] > 0.4 && soft[2] < 0.6);
    }

    #[test]
    fn a_range_the_wrong_way_round_is_refused() {
        let mask: Mask = serde_json::from_str(r#"{"elevation":["900 m","250 m"]}"#).unwrap();
        assert!(mask.check().unwrap_err().to_string().contains("lesser value first"));
        assert!(serde_json::from_str::<Mask>(r#"{"name":"elevation"}"#).unwrap().check().is_err());
    }
}
