//! Objects that stand on the ground: trees, rocks, by rules.
//!
//! # Model
//! Places at least `spacing` apart fill the map (Poisson disks). One stays if the ground there
//! keeps the rules, with a chance of `density`: where that is 1 as many stay as there is room for,
//! about 0.69 a square of the spacing.
//!
//! # Limits
//! Rules are of the nearest node. Objects of different stages do not keep away from each other but
//! by a rule of distance.
//!
//! # Sources
//! Bridson (2007) for the places.
//!
//! # Checked by
//! `tests`: distances, density, each rule, the same on any number of threads, hostile values.

#[cfg(test)]
mod tests;

use landform_core::algo::derivative::gradient;
use landform_core::algo::sampling::scattered;
use landform_core::feature::{Feature, FeatureKind, Geometry, Property, near};
use landform_core::field::names;
use landform_core::random::Seed;
use landform_core::terrain::{HeightField, Interpolation, NodeSurface, sample_by};
use landform_core::units::{Length, RatioDimension};
use landform_core::verb::{
    Context, Edit, Estimate, FeatureWord, LengthSpan, Params, Resolved, SlopeSpan, Source, Varying, is_plain_name,
};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Scatters objects of a kind, such as trees, over the ground: no two nearer than `spacing`, where
/// slope, height and distance from features allow it, as dense as a map says. They never stand in
/// water or on a road. They are kept as a feature (`objects`) with a direction and a scale each;
/// `write_points` writes them.
///
/// Trees where it is not too steep:
///
/// ```
/// use landform_core::feature::{FeatureKind, Geometry};
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{HeightField, NodeSurface};
/// use landform_core::units::{Angle, Length};
/// use landform_core::verb::{Context, Edit, SlopeSpan};
/// use landform_process::edit::Scatter;
///
/// let grid = Grid::new(Shape::new(21, 21), [10.0, 10.0])?;
/// let mut ground = HeightField::new(grid, (0..441).map(|i| f64::from(i % 21)).collect())?;
/// let slope = SlopeSpan { above: None, below: Some(Angle::of(30.0)) };
/// Scatter { spacing: Length::of(8.0), slope, ..Scatter::default() }.edit(&mut ground, &Context::default())?;
/// let trees = ground.features().of(FeatureKind::Object).next().unwrap();
/// assert!(matches!(&trees.geometry, Geometry::Points(points) if points.len() > 300));
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Scatter {
    /// Kind of the objects, a word of your own: "tree".
    pub kind: String,
    /// Least distance between two of them.
    #[schemars(extend("x-above" = 0.0))]
    pub spacing: Length,
    /// Slopes on which they stand: { below = "30 deg" }.
    pub slope: SlopeSpan,
    /// Heights at which they stand: { above = "5 m", below = "900 m" }.
    pub height: LengthSpan,
    /// Distances from features at which they stand: [ { feature = "rivers", below = "60 m" } ].
    pub distance: Vec<DistanceRule>,
    /// Chance that a place that the rules allow is taken; may vary in space.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub density: Varying<RatioDimension>,
    /// Least and greatest scale, 1 for an object as it is; each has one between them.
    #[schemars(extend("x-above" = 0.0, "x-max" = 1000.0))]
    pub scale: [f64; 2],
}

/// A distance from features of a kind.
///
/// ```
/// use landform_process::edit::Scatter;
///
/// let json = r#"{"distance":[{"feature":"rivers","above":"4 m","below":"60 m"}]}"#;
/// let reeds: Scatter = serde_json::from_str(json).unwrap();
/// assert_eq!(reeds.distance[0].above.unwrap().si(), 4.0);
/// ```
#[derive(Clone, Copy, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DistanceRule {
    /// Features that the landscape has.
    pub feature: FeatureWord,
    /// Least distance.
    pub above: Option<Length>,
    /// Greatest distance.
    pub below: Option<Length>,
}

impl Default for Scatter {
    fn default() -> Self {
        Self {
            kind: "tree".into(),
            spacing: Length::of(20.0),
            slope: SlopeSpan::default(),
            height: LengthSpan::default(),
            distance: Vec::new(),
            density: Varying::Uniform(landform_core::units::Ratio::of(1.0)),
            scale: [0.8, 1.2],
        }
    }
}

/// Places a square of the spacing, at most.
const MOST_A_SQUARE: f64 = 0.75;

impl Params for Scatter {
    const NAME: &'static str = "scatter";
    const SOURCES: &'static [Source] = &[Source {
        authors: "Bridson (2007)",
        title: "Fast Poisson disk sampling in arbitrary dimensions, SIGGRAPH sketches",
        doi: "10.1145/1278780.1278807",
    }];

    fn bytes_a_node(&self) -> Option<u64> {
        Some(60)
    }

    fn check(&self) -> Result<()> {
        if !is_plain_name(&self.kind) {
            let expected = "a word of letters, digits, spaces, _ and -, at most 60 long";
            return Err(Error::parameter("kind", format!("{:?}", self.kind), expected));
        }
        if !(self.scale[0] <= self.scale[1]) {
            return Err(Error::parameter("scale", format!("{:?}", self.scale), "the least, then the greatest"));
        }
        self.slope.check("slope")?;
        self.height.check("height")?;
        self.distance.iter().try_for_each(|rule| rule.span().check("distance"))
    }

    fn check_on(&self, [w, h]: [f64; 2]) -> Result<()> {
        let most = 0.5 * w.min(h);
        if self.spacing.si() <= most {
            return Ok(());
        }
        let expected = format!("at most half of the map's shorter side, {most} m");
        Err(Error::parameter("spacing", self.spacing, &expected))
    }
}

impl DistanceRule {
    fn span(&self) -> LengthSpan {
        LengthSpan { above: self.above, below: self.below }
    }
}

/// Candidates for places, and those that are out.
struct Places {
    at: Vec<[f64; 2]>,
    out: Vec<bool>,
}

impl Places {
    fn rule_out(&mut self, which: &[bool], within: bool) {
        self.out.iter_mut().zip(which).for_each(|(out, &is_near)| *out |= is_near == within);
    }
}

impl Scatter {
    /// Places all over the map, at least the spacing apart.
    fn candidates(&self, terrain: &HeightField, seed: Seed) -> Result<Vec<[f64; 2]>> {
        let extent = terrain.grid().extent();
        self.check_on(extent)?;
        let [west, south] = terrain.bounds()[0];
        let places = scattered(extent, self.spacing.si(), seed.named("places"))?;
        Ok(places.into_iter().map(|[x, y]| [west + x, south + y]).collect())
    }

    /// Whether the ground at a place allows an object.
    fn is_allowed(&self, terrain: &HeightField, water: &[bool], at: [f64; 2]) -> bool {
        let (grid, z) = (terrain.grid(), terrain.elevation());
        let Some(node) = grid.node_at(at).filter(|&i| !water[i]) else { return false };
        let height = terrain.elevation_at(at);
        let slope = math::atan(gradient(grid, z, node).slope());
        height.is_finite()
            && slope.is_finite()
            && self.height.share(height, 0.0) > 0.0
            && self.slope.share(slope, 0.0) > 0.0
    }

    /// Rules out what lies too near to features, or too far, and what lies on roads.
    fn keep_distance(&self, terrain: &HeightField, places: &mut Places) -> Result<()> {
        for rule in &self.distance {
            let features = terrain.features().need(rule.feature.kind(), "`scatter`")?;
            let within = |distance: Length| near(features.iter().copied(), distance.si(), &places.at);
            let (too_near, near_enough) = (rule.above.map(within), rule.below.map(within));
            too_near.iter().for_each(|near| places.rule_out(near, true));
            near_enough.iter().for_each(|near| places.rule_out(near, false));
        }
        for road in terrain.features().of(FeatureKind::Path) {
            let width = road.number("strip_m").or(road.number("width_m")).unwrap_or(0.0);
            let on = near(std::iter::once(road), 0.5 * width, &places.at);
            places.rule_out(&on, true);
        }
        Ok(())
    }
}

/// Nodes under the sea, and in lakes and rivers whose depth is known.
fn water(terrain: &HeightField, context: &Context) -> Vec<bool> {
    /// Shallower water is left out of account, m.
    const SHALLOW: f64 = 0.3;
    let z = terrain.elevation();
    let sea = context.environment.sea(None).unwrap_or(f64::NEG_INFINITY);
    let fields = terrain.fields();
    let depths: Vec<&[f64]> =
        [&names::LAKE_DEPTH, &names::WATER_DEPTH].into_iter().filter_map(|key| fields.get(key, "").ok()).collect();
    parallel::map(z.len(), |i| z[i] < sea || depths.iter().any(|depth| depth[i] > SHALLOW))
}

impl Edit<HeightField> for Scatter {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        let at = self.candidates(terrain, context.seed)?;
        let water = water(terrain, context);
        let density = self.density.resolve("density", terrain, context)?;
        let grid = terrain.grid();
        let chance = |at: [f64; 2]| match &density {
            Resolved::Uniform(chance) => *chance,
            Resolved::PerNode(values) => sample_by(Interpolation::Linear, grid, values, at),
        };
        let lots = context.seed.named("lots");
        let out = parallel::map(at.len(), |k| {
            !(lots.uniform(k as u64) < chance(at[k])) || !self.is_allowed(terrain, &water, at[k])
        });
        let mut places = Places { at, out };
        self.keep_distance(terrain, &mut places)?;
        let kept: Vec<usize> = (0..places.at.len()).filter(|&k| !places.out[k]).collect();
        let points = kept.iter().map(|&k| {
            let [x, y] = places.at[k];
            [x, y, terrain.elevation_at([x, y])]
        });
        let points: Vec<[f64; 3]> = points.collect();
        let [turns, sizes] = ["yaw", "scale"].map(|name| context.seed.named(name));
        let yaw = kept.iter().map(|&k| 360.0 * turns.uniform(k as u64)).collect();
        let scale = kept.iter().map(|&k| math::lerp(self.scale[0], self.scale[1], sizes.uniform(k as u64))).collect();
        let properties = [
            ("object", Property::Text(self.kind.clone())),
            ("count", Property::Whole(points.len() as u32)),
            ("spacing_m", Property::Number(self.spacing.si())),
            ("yaw_deg", Property::Numbers(yaw)),
            ("scale", Property::Numbers(scale)),
        ];
        let properties = properties.into_iter().map(|(name, p)| (name.to_string(), p)).collect();
        let geometry = Geometry::Points(points);
        let feature = Feature { id: self.kind.clone(), kind: FeatureKind::Object, geometry, properties };
        terrain.features_mut().add(feature);
        Ok(())
    }

    fn estimate(&self, before: Estimate) -> Estimate {
        let [w, h] = before.extent;
        let places = MOST_A_SQUARE * w * h / (self.spacing.si() * self.spacing.si());
        // The lattice of the search, places, and what is known of each.
        let bytes = before.nodes * 76 + (120.0 * places).clamp(0.0, 1e15) as u64;
        Estimate { bytes, ..before }
    }
}
