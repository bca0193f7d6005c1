//! A passage through solid ground.

use landform_core::terrain::{Bounds, Ground, VoxelGrid};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit, Estimate, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Hollows out a round passage along a line of places, in voxels: all those whose middle lies
/// within its radius become empty.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Tunnel {
    /// Places that it leads through, each x, y and elevation; two at least. There is no default.
    pub along: Vec<[Length; 3]>,
    /// Half of its width.
    #[schemars(extend("x-above" = 0.0))]
    pub radius: Length,
}

impl Default for Tunnel {
    fn default() -> Self {
        Self { along: Vec::new(), radius: Length::of(5.0) }
    }
}

impl Params for Tunnel {
    const NAME: &'static str = "tunnel";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        match self.along.len() {
            1 => Err(too_few(1)),
            _ => Ok(()),
        }
    }
}

fn too_few(places: usize) -> Error {
    Error::parameter("along", format!("{places} places"), "at least two, each [\"x\", \"y\", \"elevation\"]")
}

impl Edit<VoxelGrid> for Tunnel {
    fn edit(&self, terrain: &mut VoxelGrid, _: &Context) -> Result<()> {
        let along: Vec<[f64; 3]> = self.along.iter().map(|place| place.map(Length::si)).collect();
        if along.len() < 2 {
            return Err(too_few(along.len()));
        }
        let radius = self.radius.si();
        let within = |ends: &[[f64; 3]]| Bounds {
            low: [0, 1, 2].map(|k| ends[0][k].min(ends[1][k]) - radius),
            high: [0, 1, 2].map(|k| ends[0][k].max(ends[1][k]) + radius),
        };
        let cut = |ends: &[[f64; 3]]| {
            terrain.empty(within(ends), |at| square_of_distance(at, ends[0], ends[1]) <= radius * radius)
        };
        if along.windows(2).map(cut).sum::<usize>() > 0 {
            return Ok(());
        }
        let Bounds { low, high } = terrain.bounding_box();
        let range = |k: usize| format!("{} to {} m", low[k], high[k]);
        let expected = format!(
            "a way through solid ground, wide enough to hold the middle of a voxel; the ground lies within x {}, y {}, elevation {}",
            range(0),
            range(1),
            range(2)
        );
        Err(Error::parameter("along", "nowhere near a solid voxel", &expected))
    }

    fn estimate(&self, before: Estimate) -> Estimate {
        Estimate { bytes: 2 * before.nodes, ..before }
    }
}

/// Square of the distance from a place to a straight line between two others, m².
fn square_of_distance(at: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (line, there) = (minus(to, from), minus(at, from));
    let length = dot(line, line);
    let t = if length > 0.0 { (dot(there, line) / length).clamp(0.0, 1.0) } else { 0.0 };
    let off = minus(there, line.map(|v| v * t));
    dot(off, off)
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::{Materials, Terrain};

    use super::*;

    #[test]
    fn a_passage_has_the_volume_of_its_tube() {
        let plan = Grid::new(Shape::new(41, 101), [1.0, 1.0]).unwrap();
        let mut ground = VoxelGrid::from_fn(plan, 40, 0.0, 1.0, &Materials::default(), |_, _| Some(0)).unwrap();
        let before = ground.volume();
        let ends = [[20.0, 20.3, 20.6], [80.0, 20.3, 20.6]];
        let tunnel = Tunnel { along: ends.map(|end| end.map(Length::of)).to_vec(), radius: Length::of(12.0) };
        tunnel.edit(&mut ground, &Context::default()).unwrap();
        let ball = 4.0 / 3.0 * std::f64::consts::PI * 1728.0;
        let tube = 60.0 * std::f64::consts::PI * 144.0 + ball;
        assert!(((before - ground.volume()) / tube - 1.0).abs() < 0.01);
        assert!(ground.hit([21.0, 20.0, 20.0], [79.0, 20.0, 20.0]).is_none());
        assert!(tunnel.edit(&mut ground, &Context::default()).is_err(), "nothing is left to remove");
        let short = Tunnel { along: vec![ends[0].map(Length::of)], ..tunnel };
        assert!(short.check().is_err());
    }
}
