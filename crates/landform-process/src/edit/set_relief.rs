//! Gives the ground a relief.
//!
//! # Model
//! z' = b + f (z − b) with f = relief/(highest − b), where b is the lowest ground or the sea. What
//! stands at b stays.
//!
//! # What it does to land that has been eroded
//! Slopes change by f. Where erosion and creep are linear in slope (`stream_power` with slope
//! exponent 1 and without a limiting slope, deposition, `linear_diffusion`) the scaled land is
//! exactly the land of f times the uplift at the same times, from a start f times as high. Where
//! slopes approach a limit, or stand at an angle of repose, it is not: with f above 1 they then
//! exceed it.
//!
//! # Checked by
//! `tests`: the relief, what stays, and rivers under twice the uplift.

use landform_core::terrain::{Layer, NodeSurface};
use landform_core::units::Length;
use landform_core::verb::{Context, Edit, Params, Source};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Gives the ground a relief: scales its heights, so that the highest stands so far above the
/// lowest, or the sea. Slopes are scaled too: with twice the relief every slope is twice as steep.
///
/// A hill of 200 m becomes one of 1200 m:
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{HeightField, NodeSurface};
/// use landform_core::units::Length;
/// use landform_core::verb::{Context, Edit};
/// use landform_process::edit::SetRelief;
///
/// let grid = Grid::new(Shape::new(1, 3), [100.0, 100.0])?;
/// let mut ground = HeightField::new(grid, vec![50.0, 250.0, 100.0])?;
/// SetRelief { relief: Length::of(1200.0), ..SetRelief::default() }.edit(&mut ground, &Context::default())?;
/// assert_eq!(ground.elevation(), [50.0, 1250.0, 350.0]);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SetRelief {
    /// Height of the highest ground above `above`.
    #[schemars(extend("x-above" = 0.0))]
    pub relief: Length,
    /// What it is counted from, which stays where it is: the lowest ground, or the environment's
    /// sea level, under which the sea floor is scaled too.
    pub above: ReliefAbove,
}

/// What relief is counted from.
///
/// ```
/// use landform_process::edit::{ReliefAbove, SetRelief};
///
/// assert_eq!(SetRelief::default().above, ReliefAbove::Lowest);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ReliefAbove {
    /// The lowest ground.
    #[default]
    Lowest,
    /// The environment's sea level, or 0 m.
    SeaLevel,
}

impl Default for SetRelief {
    fn default() -> Self {
        Self { relief: Length::of(1000.0), above: ReliefAbove::Lowest }
    }
}

impl Params for SetRelief {
    const NAME: &'static str = "set_relief";
    const SOURCES: &'static [Source] = &[];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(8)
    }
}

impl<T: NodeSurface> Edit<T> for SetRelief {
    fn edit(&self, terrain: &mut T, context: &Context) -> Result<()> {
        let z = terrain.elevation();
        let of = |i: usize, sign: f64| if z[i].is_nan() { f64::NEG_INFINITY } else { sign * z[i] };
        let highest = parallel::max(z.len(), |i| of(i, 1.0));
        let base = match self.above {
            ReliefAbove::Lowest => -parallel::max(z.len(), |i| of(i, -1.0)),
            ReliefAbove::SeaLevel => context.environment.sea_level_at(context.time),
        };
        let now = highest - base;
        let factor = self.relief.si() / now;
        if !(now > 0.0 && factor.is_finite()) {
            let found = format!("{} of ground whose highest point stands {now} m above that", self.relief);
            return Err(Error::parameter("relief", found, "ground with some relief above it"));
        }
        terrain.change(Layer::Bedrock, |z| parallel::update(z, |_, z| *z = base + factor * (*z - base)));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Edge, Edges, Grid, Shape};
    use landform_core::sim::Model;
    use landform_core::terrain::HeightField;
    use landform_core::units::{Diffusivity, KYR, Rate};

    use super::*;
    use crate::hillslope::LinearDiffusion;
    use crate::stream_power::StreamPower;
    use crate::uplift::Uplift;

    fn relief(metres: f64, above: ReliefAbove) -> SetRelief {
        SetRelief { relief: Length::of(metres), above }
    }

    fn row(z: Vec<f64>) -> HeightField {
        HeightField::new(Grid::new(Shape::new(1, z.len()), [100.0; 2]).unwrap(), z).unwrap()
    }

    #[test]
    fn the_highest_stands_so_far_above_what_stays() {
        let mut ground = row(vec![-50.0, f64::NAN, 200.0, 100.0]);
        relief(1000.0, ReliefAbove::SeaLevel).edit(&mut ground, &Context::default()).unwrap();
        assert_eq!((ground.elevation()[0], ground.elevation()[2], ground.elevation()[3]), (-250.0, 1000.0, 500.0));
        assert!(ground.elevation()[1].is_nan());
        relief(625.0, ReliefAbove::Lowest).edit(&mut ground, &Context::default()).unwrap();
        assert_eq!((ground.elevation()[0], ground.elevation()[2], ground.elevation()[3]), (-250.0, 375.0, 125.0));
    }

    #[test]
    fn level_ground_and_ground_under_the_sea_are_refused() {
        for (z, above) in [(vec![5.0; 4], ReliefAbove::Lowest), (vec![-9.0, -4.0], ReliefAbove::SeaLevel)] {
            let error = relief(1000.0, above).edit(&mut row(z), &Context::default()).unwrap_err();
            assert_eq!(error.parameter_name(), Some("relief"), "{error}");
        }
    }

    #[test]
    fn linear_land_of_twice_the_relief_is_that_of_twice_the_uplift() {
        let land = |share: f64| {
            let mut grid = Grid::new(Shape::new(24, 24), [200.0; 2]).unwrap();
            grid.edges = Edges { south: Edge::Open, ..Edges::all(Edge::Closed) };
            let start = (0..576).map(|i| share * (i * 7919 % 101) as f64 / 101.0).collect();
            let mut model = Model::new(HeightField::new(grid, start).unwrap()).dt(50.0 * KYR);
            model.add(Uplift { rate: Rate::of(0.2 * share).into() }).unwrap();
            let rivers = StreamPower { limiting_slope: Some(0.0), deposition: 0.5, ..StreamPower::default() };
            model.add(rivers).unwrap();
            model.add(LinearDiffusion { diffusivity: Diffusivity::of(0.05).into() }).unwrap();
            model.advance_steps(20).unwrap();
            model.terrain().clone()
        };
        let (mut low, high) = (land(1.0), land(2.0));
        let top = high.elevation().iter().copied().fold(f64::MIN, f64::max);
        let foot = high.elevation().iter().copied().fold(f64::MAX, f64::min);
        relief(top - foot, ReliefAbove::Lowest).edit(&mut low, &Context::default()).unwrap();
        let shift = low.elevation().iter().copied().fold(f64::MAX, f64::min) - foot;
        let worst =
            low.elevation().iter().zip(high.elevation()).map(|(a, b)| (a - shift - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-5 * top, "{worst} m of {top} m");
    }
}
