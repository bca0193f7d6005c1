//! Where water enters and leaves the rock.

use landform_core::algo::lattice::Lattice;
use landform_core::grid::Side;
use landform_core::terrain::{Bounds, Ground, VoxelGrid};
use landform_core::units::Length;
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A place where water enters the rock.
///
/// ```
/// use landform_process::cave::InletParams;
///
/// let inlet: InletParams = serde_json::from_str(r#"{"at":["4 m","20 m","17 m"]}"#).unwrap();
/// assert_eq!(inlet.pressure, 1.0);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InletParams {
    /// x, y and elevation.
    pub at: [Length; 3],
    /// Pressure there as a number, over that of the outlets.
    #[serde(default = "one")]
    #[schemars(extend("x-above" = 0.0, "x-max" = 1000.0))]
    pub pressure: f64,
    /// Radius within which all voxels take water; if not given, it is one voxel.
    #[schemars(extend("x-above" = 0.0))]
    pub radius: Option<Length>,
}

fn one() -> f64 {
    1.0
}

/// A part of the rock where water leaves it: a part of a side, or a place.
///
/// ```
/// use landform_process::cave::OutletParams;
///
/// let outlet: OutletParams = serde_json::from_str(r#"{"side":"east","below":"5 m"}"#).unwrap();
/// assert!(outlet.at.is_none());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OutletParams {
    /// Side of the block.
    pub side: Option<Side>,
    /// x, y and elevation of a place, instead of a side.
    pub at: Option<[Length; 3]>,
    /// Radius around the place; if not given, it is one voxel.
    #[schemars(extend("x-above" = 0.0))]
    pub radius: Option<Length>,
    /// Elevation below which water leaves.
    pub below: Option<Length>,
    /// Elevation above which water leaves.
    pub above: Option<Length>,
    /// Part of the side along it, from its western or southern end: [from, to], 0 to 1. If not
    /// given, all of it.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub along: Option<[f64; 2]>,
}

fn near(ground: &VoxelGrid, lattice: &Lattice, at: [Length; 3], radius: Option<Length>) -> Vec<usize> {
    let at = at.map(Length::si);
    let square = |i: usize| {
        let m = lattice.middle(ground, i);
        (0..3).map(|k| (m[k] - at[k]) * (m[k] - at[k])).sum::<f64>()
    };
    let within = radius.map_or(0.0, |r| r.si() * r.si());
    let all: Vec<usize> = lattice.voxels().filter(|&i| square(i) < within).collect();
    if all.is_empty() {
        lattice.voxels().min_by(|&a, &b| square(a).total_cmp(&square(b))).into_iter().collect()
    } else {
        all
    }
}

fn check_inside(ground: &VoxelGrid, name: &str, at: [Length; 3]) -> Result<()> {
    let Bounds { low, high } = ground.bounding_box();
    let at = at.map(Length::si);
    if (0..3).all(|k| low[k] <= at[k] && at[k] <= high[k]) {
        return Ok(());
    }
    let expected = format!("a place in the rock, which lies between {low:?} and {high:?} m");
    Err(Error::parameter(name, format!("{at:?} m"), &expected))
}

impl InletParams {
    /// Its voxels.
    pub(super) fn voxels(&self, ground: &VoxelGrid, lattice: &Lattice) -> Result<Vec<usize>> {
        check_inside(ground, "inlets.at", self.at)?;
        Ok(near(ground, lattice, self.at, self.radius))
    }
}

impl OutletParams {
    /// Refuses numbers that contradict each other.
    pub(super) fn check(&self) -> Result<()> {
        if self.side.is_some() == self.at.is_some() {
            return Err(Error::parameter("outlets", "both or none of `side` and `at`", "one of them for each"));
        }
        if let (Some(_), Some(radius)) = (self.side, self.radius) {
            return Err(Error::parameter("outlets.radius", format!("{radius} with a `side`"), "no radius, or `at`"));
        }
        if let Some([from, to]) = self.along.filter(|[from, to]| !(from < to)) {
            let given = format!("[{from}, {to}]");
            return Err(Error::parameter("outlets.along", given, "[from, to], of which the first is less"));
        }
        match (self.below, self.above) {
            (Some(below), Some(above)) if !(above.si() < below.si()) => {
                Err(Error::parameter("outlets.below", below, &format!("more than `above`, which is {above}")))
            }
            _ => Ok(()),
        }
    }

    /// Its voxels.
    pub(super) fn voxels(&self, ground: &VoxelGrid, lattice: &Lattice) -> Result<Vec<usize>> {
        let Bounds { low, high } = ground.bounding_box();
        let mut voxels = match (self.side, self.at) {
            (None, Some(at)) => {
                check_inside(ground, "outlets.at", at)?;
                near(ground, lattice, at, self.radius)
            }
            (Some(side), None) => {
                let [nx, ny, _] = lattice.size();
                let on = |[x, y, _]: [usize; 3]| match side {
                    Side::North => y == 0,
                    Side::South => y + 1 == ny,
                    Side::West => x == 0,
                    Side::East => x + 1 == nx,
                };
                lattice.voxels().filter(|&i| on(lattice.place(i))).collect()
            }
            _ => Vec::new(),
        };
        let axis = usize::from(matches!(self.side, Some(Side::West | Side::East)));
        voxels.retain(|&i| {
            let m = lattice.middle(ground, i);
            let along = (m[axis] - low[axis]) / (high[axis] - low[axis]);
            self.below.is_none_or(|z| m[2] < z.si())
                && self.above.is_none_or(|z| m[2] > z.si())
                && self.along.is_none_or(|[from, to]| from <= along && along <= to)
        });
        if !voxels.is_empty() {
            return Ok(voxels);
        }
        let half = 0.5 * ground.height();
        let is_off =
            self.below.is_some_and(|z| z.si() <= low[2] + half) || self.above.is_some_and(|z| z.si() >= high[2] - half);
        Err(if is_off {
            let expected =
                format!("elevations of voxels, whose middles lie from {} to {} m", low[2] + half, high[2] - half);
            Error::parameter("outlets", "`below` or `above` without a voxel", &expected)
        } else {
            Error::parameter("outlets", "a part that lies between two voxels", "a part that holds the middle of one")
        })
    }
}
