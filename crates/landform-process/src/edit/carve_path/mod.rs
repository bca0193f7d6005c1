//! Roads: a line between places, and the ground that is cut and filled along it.
//!
//! # Model
//! Of all lines from place to place the road takes the one of least cost, ∫ (1 + ½ q²) ds with q
//! the grade over the steepest one that is allowed; where the ground is steeper the cost grows
//! ([`route`]). Its profile is as near to the ground as the grade allows ([`profile`]): with L the
//! greatest profile under the ground and U the least above it whose grades are allowed, (L + U)/2
//! departs from the ground the least of all, and so does what is shifted with it. It is shifted
//! until fill is `balance` times the cut. The ground is level across the road but for its camber,
//! and meets what lies beside it by slopes of cut and fill ([`earthwork`]).
//!
//! # Limits
//! The flattened strip is at least two cells wide, so that it shows. Where the land falls as
//! steeply as fill can stand, fill ends at a wall. Low fill over a small stream dams it, as if
//! there were no culvert: water then spills over the road. Fields that follow from the ground, such
//! as drainage_area, are not renewed.
//!
//! # Sources
//! Galin, Peytavie, Maréchal & Guérin (2010) for roads as shortest paths over masks of many
//! directions, with costs of slope. McShane (1934) for L and U, the extremal Lipschitz functions.
//!
//! # Checked by
//! `tests`: a level road on level ground moves nothing; grade, balance, cross-section; a
//! switchback where the straight line is too steep; ground that is not touched; strange ground.

mod earthwork;
mod profile;
mod route;
#[cfg(test)]
mod tests;

use landform_core::feature::{Feature, FeatureKind, Geometry, Property};
use landform_core::field::names;
use landform_core::grid::Grid;
use landform_core::terrain::{HeightField, Interpolation, Layer, NodeSurface, sample_by};
use landform_core::units::{Angle, Length, place_text};
use landform_core::verb::{Context, Edit, Params, Source};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use earthwork::{Corridor, Section};
use profile::Profile;

/// Finds a road between places and lays it into the ground: level across, no steeper than asked,
/// with slopes of cut and fill beside it. It is kept as a feature (`paths`) with its length, its
/// grade and the volumes that were moved; later stages may use it, as in { feature = "paths",
/// buffer = "10 m" }.
///
/// Over a ridge, by a cutting:
///
/// ```
/// use landform_core::feature::{FeatureKind, Property};
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::math::exp;
/// use landform_core::terrain::{HeightField, NodeSurface};
/// use landform_core::units::Length;
/// use landform_core::verb::{Context, Edit};
/// use landform_process::edit::{CarvePath, PathRoute};
///
/// let ridge = |i: usize| 20.0 * exp(-0.01 * ((i % 101) as f64 - 50.0) * ((i % 101) as f64 - 50.0));
/// let grid = Grid::new(Shape::new(41, 101), [5.0, 5.0])?;
/// let mut ground = HeightField::new(grid, (0..41 * 101).map(ridge).collect())?;
/// let top = ground.elevation()[20 * 101 + 50];
/// let points = vec![[0.0, 100.0].map(Length::of), [500.0, 100.0].map(Length::of)];
/// CarvePath { points, route: PathRoute::Straight, ..CarvePath::default() }.edit(&mut ground, &Context::default())?;
/// let road = ground.features().of(FeatureKind::Path).next().unwrap();
/// assert!(matches!(road.property("cut_m3"), Some(Property::Number(cut)) if *cut > 1_000.0));
/// assert!(ground.elevation()[20 * 101 + 50] < top - 1.0);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct CarvePath {
    /// Places east and north that the road leads to, in order. If not given, it leads from the
    /// middle of the west side to that of the east side.
    pub points: Vec<[Length; 2]>,
    /// "found": the shortest way that is not too steep; "straight": from place to place.
    pub route: PathRoute,
    /// Width of the road.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1000.0))]
    pub width: Length,
    /// Steepest grade along the road.
    #[schemars(extend("x-min" = 0.1, "x-max" = 45.0))]
    pub steepest: Angle,
    /// Slope across the road, m/m, down from its middle to both edges.
    #[schemars(extend("x-min" = 0.0, "x-max" = 0.3))]
    pub camber: f64,
    /// Slope at which ground stands that is cut beside the road.
    #[schemars(extend("x-min" = 5.0, "x-max" = 85.0))]
    pub cut_slope: Angle,
    /// Slope at which fill stands beside the road.
    #[schemars(extend("x-min" = 5.0, "x-max" = 85.0))]
    pub fill_slope: Angle,
    /// Fill as a part of the cut: with 1 all that is dug is used. With 0 they are not balanced, and
    /// the road lies as near to the ground as its grade allows.
    #[schemars(extend("x-min" = 0.0, "x-max" = 10.0))]
    pub balance: f64,
    /// Height over the ground, or the water of a lake or the sea, from which the road is a bridge,
    /// with no fill under it.
    #[schemars(extend("x-above" = 0.0))]
    pub bridge_above: Length,
}

/// How a road finds its way.
///
/// ```
/// use landform_process::edit::{CarvePath, PathRoute};
///
/// assert_eq!(CarvePath::default().route, PathRoute::Found);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PathRoute {
    /// The way of least cost.
    #[default]
    Found,
    /// Straight from place to place.
    Straight,
}

impl Default for CarvePath {
    fn default() -> Self {
        Self {
            points: Vec::new(),
            route: PathRoute::Found,
            width: Length::of(8.0),
            steepest: Angle::of(8.0),
            camber: 0.02,
            cut_slope: Angle::of(45.0),
            fill_slope: Angle::of(34.0),
            balance: 1.0,
            bridge_above: Length::of(8.0),
        }
    }
}

/// The most places of a road.
const MOST_POINTS: usize = 1_000;

impl Params for CarvePath {
    const NAME: &'static str = "carve_path";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Galin, Peytavie, Maréchal & Guérin (2010)",
        title: "Procedural generation of roads, Computer Graphics Forum 29(2)",
        doi: "10.1111/j.1467-8659.2009.01612.x",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(110)
    }

    fn places(&self) -> Vec<(&'static str, [f64; 2])> {
        self.points.iter().map(|p| ("points", p.map(Length::si))).collect()
    }

    fn check(&self) -> Result<()> {
        let count = self.points.len();
        if count == 1 || count > MOST_POINTS {
            let expected = format!("from 2 to {MOST_POINTS} places, each [east, north]");
            return Err(Error::parameter("points", format!("{count} places"), &expected));
        }
        Ok(())
    }
}

impl Edit<HeightField> for CarvePath {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        let places = self.places_on(terrain)?;
        let water = dry_ground(terrain, context);
        let steepest = math::tan(self.steepest.si());
        let grid = terrain.grid();
        let pace = 0.5 * grid.spacing[0].min(grid.spacing[1]);
        // The strip shows where it holds nodes all along.
        let half = (0.5 * self.width.si()).max(grid.spacing[0].max(grid.spacing[1]));
        let line = match self.route {
            PathRoute::Straight => places,
            PathRoute::Found => route::find(grid, &water, &places, steepest, half)?,
        };
        let rounding = if self.route == PathRoute::Found { 4.0 * half } else { 0.0 };
        let ease = 4.0 * half;
        let profile = Profile::along(&line, pace, rounding, |at| level_at(grid, &water.level, at), steepest, ease)?;
        let section = Section {
            half,
            camber: self.camber,
            cut: math::tan(self.cut_slope.si()),
            fill: math::tan(self.fill_slope.si()),
        };
        let corridor = Corridor::of(terrain, &profile, section, self.bridge_above.si());
        let shift = if self.balance > 0.0 { corridor.balanced(self.balance) } else { 0.0 };
        let [cut, fill] = corridor.volumes(shift);
        let id = format!("path {}", terrain.features().of(FeatureKind::Path).count() + 1);
        let feature = self.feature(id, &profile, &corridor, shift, [cut, fill]);
        let moved = corridor.moved(shift);
        terrain.change(Layer::Surface("gravel"), |z| moved.iter().for_each(|&(i, new)| z[i as usize] = new));
        terrain.features_mut().add(feature);
        Ok(())
    }
}

impl CarvePath {
    /// The places that it leads to, all on ground.
    fn places_on(&self, terrain: &HeightField) -> Result<Vec<[f64; 2]>> {
        let [[w, s], [e, n]] = terrain.bounds();
        let mut places: Vec<[f64; 2]> = self.points.iter().map(|p| p.map(Length::si)).collect();
        if places.is_empty() {
            places = vec![[w, 0.5 * (s + n)], [e, 0.5 * (s + n)]];
        }
        places.dedup();
        if places.len() < 2 {
            let expected = "at least two different places on the map";
            return Err(Error::parameter("points", format!("{} different places", places.len()), expected));
        }
        let is_on = |&p: &[f64; 2]| terrain.grid().node_at(p).is_some_and(|i| !terrain.elevation()[i].is_nan());
        match places.iter().find(|p| !is_on(p)) {
            Some(&p) => {
                let expected = format!("places with ground, {w:.0} to {e:.0} m east and {s:.0} to {n:.0} m north");
                Err(Error::parameter("points", place_text(p), &expected))
            }
            None => Ok(places),
        }
    }

    fn feature(
        &self,
        id: String,
        profile: &Profile,
        corridor: &Corridor,
        shift: f64,
        [cut, fill]: [f64; 2],
    ) -> Feature {
        let height: Vec<f64> = profile.height.iter().map(|h| h + shift).collect();
        let grades = (1..height.len()).map(|k| {
            let length = profile.at[k] - profile.at[k - 1];
            if length > 0.0 { (height[k] - height[k - 1]).abs() / length } else { 0.0 }
        });
        let steepest = math::atan(grades.fold(0.0, f64::max)).to_degrees();
        let bridges = corridor.bridges();
        let points = profile.line.iter().zip(&height).map(|(p, h)| [p[0], p[1], *h]).collect();
        let properties = [
            ("width_m", Property::Number(self.width.si())),
            ("length_m", Property::Number(profile.at[profile.at.len() - 1])),
            ("steepest_deg", Property::Number(steepest)),
            ("cut_m3", Property::Number(cut)),
            ("fill_m3", Property::Number(fill)),
            ("strip_m", Property::Number(2.0 * corridor.half())),
            ("bridges", Property::Whole(bridges.len() as u32)),
            ("bridges_m", Property::Numbers(bridges.into_iter().flatten().collect())),
        ];
        let properties = properties.into_iter().map(|(name, p)| (name.to_string(), p)).collect();
        Feature { id, kind: FeatureKind::Path, geometry: Geometry::Line(points), properties }
    }
}

/// Ground and water as a road sees them.
struct Dry {
    /// The ground, or the surface of the water over it, m.
    level: Vec<f64>,
    /// Whether water stands there.
    wet: Vec<bool>,
}

/// Height of a road over the water that it crosses, m.
const OVER_WATER: f64 = 1.0;
/// Shallower water is no lake, m.
const SHALLOW: f64 = 0.3;

fn dry_ground(terrain: &HeightField, context: &Context) -> Dry {
    let z = terrain.elevation();
    let sea = context.environment.sea(None).unwrap_or(f64::NEG_INFINITY);
    let fields = terrain.fields();
    let depth = fields.get(&names::LAKE_DEPTH, "").or_else(|_| fields.get(&names::WATER_DEPTH, "")).ok();
    let water = |i: usize| depth.map_or(0.0, |d| if d[i] > SHALLOW { d[i] } else { 0.0 }).max(sea - z[i]);
    let wet = parallel::map(z.len(), |i| water(i) > 0.0);
    let level = parallel::map(z.len(), |i| if wet[i] { z[i] + water(i) + OVER_WATER } else { z[i] });
    Dry { level, wet }
}

/// Bilinear value at a place; NaN beside nodata.
fn level_at(grid: &Grid, level: &[f64], at: [f64; 2]) -> f64 {
    sample_by(Interpolation::Linear, grid, level, at)
}
