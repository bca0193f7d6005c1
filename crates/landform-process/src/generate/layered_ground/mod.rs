//! Ground of bedded rock with loose layers on it.

use landform_core::field::names;
use landform_core::grid::Grid;
use landform_core::random::Seed;
use landform_core::terrain::{Bed, HeightField, Layers, Materials, NodeSurface};
use landform_core::units::{Angle, Length, LengthDimension};
use landform_core::verb::{Context, Estimate, Generator, Params, Reach, Resolved, Source, Varying};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::GridParams;

mod joints;
mod rock;

pub use joints::JointParams;
pub use rock::{FoldParams, RockKind, SequenceParams};

/// Ground in beds of rock that dip to a side, with loose layers such as soil on them. Each bed has
/// its own erodibility and angle of repose, from which mesas, cuestas and ledges follow. A kind of
/// rock draws the beds by the seed, and says how they dip and are folded.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LayeredGround {
    /// Extent and distance between nodes.
    pub grid: GridParams,
    /// Elevation of the surface, loose layers included; may vary in space.
    pub surface: Varying<LengthDimension>,
    /// Kind of rock: its beds are drawn by the seed, each with an erodibility and a limiting slope
    /// of its own, and `dip`, `dip_direction` and `folds` are the kind's where they are not given.
    pub rock: Option<RockKind>,
    /// Laws that beds are drawn by, in place of the kind's.
    pub sequence: Option<SequenceParams>,
    /// Beds from the top, repeated downwards: { material, thickness }. If none are given, the
    /// ground is one rock without beds. They may not be given beside `rock` or `sequence`, which
    /// draw them.
    pub beds: Vec<BedParams>,
    /// Elevation of the upper face of the first bed, before it dips about the middle of the map and
    /// is folded. If not given, it is the highest ground, for drawn beds 0 m. Beds are bent where
    /// it varies in space.
    pub top: Option<Varying<LengthDimension>>,
    /// Angle by which beds dip. If not given, it is the rock's, or else 0.
    #[schemars(extend("x-min" = 0.0, "x-max" = 80.0))]
    pub dip: Option<Angle>,
    /// Compass direction towards which they dip. If not given, it is the rock's, or else north.
    pub dip_direction: Option<Angle>,
    /// Folds of the beds. If not given, they are the rock's, or else none.
    pub folds: Option<FoldParams>,
    /// Sets of joints and faults: zones of weaker rock along wavy lines, across which faults offset
    /// the beds. They leave the field `joints`, how many times as fast rock wears there, for
    /// `weakness = { field = "joints" }` of `stream_power`.
    pub joints: Vec<JointParams>,
    /// Loose layers, lowest first: { material, depth }. The depth may vary in space.
    pub layers: Vec<LooseParams>,
}

/// A bed of rock.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BedParams {
    /// Name of the material.
    pub material: String,
    /// Thickness across the bed.
    #[schemars(extend("x-above" = 0.0))]
    pub thickness: Length,
}

/// A loose layer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LooseParams {
    /// Name of the material.
    pub material: String,
    /// Depth; may vary in space.
    #[schemars(extend("x-min" = 0.0))]
    pub depth: Varying<LengthDimension>,
}

/// Beds where none are said.
fn usual_beds() -> Vec<BedParams> {
    let bed = |material: &str, thickness| BedParams { material: material.into(), thickness: Length::of(thickness) };
    vec![bed("sandstone", 60.0), bed("shale", 90.0)]
}

impl Default for LayeredGround {
    fn default() -> Self {
        Self {
            grid: GridParams::default(),
            surface: Length::of(400.0).into(),
            rock: None,
            sequence: None,
            beds: usual_beds(),
            top: None,
            dip: None,
            dip_direction: None,
            folds: None,
            joints: Vec::new(),
            layers: Vec::new(),
        }
    }
}

impl Params for LayeredGround {
    const NAME: &'static str = "layered_ground";
    const SOURCES: &'static [Source] = &[];

    fn check(&self) -> Result<()> {
        self.grid.check()?;
        if let Some(bed) = self.beds.iter().find(|b| !(b.thickness.si() > 0.0)) {
            return Err(Error::parameter("beds", format!("a bed of {}", bed.thickness), "beds thicker than 0 m"));
        }
        if self.is_drawn() && self.beds != usual_beds() {
            let found = format!("{} beds beside rock or sequence", self.beds.len());
            return Err(Error::parameter("beds", found, "either beds, or a rock or sequence that draws them"));
        }
        Ok(())
    }

    fn leaves(&self) -> Vec<String> {
        if self.joints.is_empty() { Vec::new() } else { vec![names::JOINTS.name.into()] }
    }

    fn reach(&self) -> Reach {
        if self.beds.is_empty() || self.top.is_some() || self.is_drawn() { Reach::Point } else { Reach::Whole }
    }
}

impl LayeredGround {
    /// Sets of joints, each with a seed of its own.
    fn sets(&self, context: &Context) -> impl Iterator<Item = (&JointParams, Seed)> {
        let seed = context.seed.named("joints");
        self.joints.iter().enumerate().map(move |(k, set)| (set, seed.with(k as u64)))
    }

    /// Whether beds are drawn rather than given.
    fn is_drawn(&self) -> bool {
        self.rock.is_some() || self.sequence.is_some()
    }

    /// The materials, and the beds with their thickness across them.
    fn sequence(&self, context: &Context) -> Result<(Materials, Vec<Bed>)> {
        let materials = &context.environment.materials;
        if self.is_drawn() {
            let laws = self.sequence.clone().unwrap_or_default();
            return rock::draw(self.rock, &laws, materials, context.seed);
        }
        let bed = |b: &BedParams| {
            let material = materials.need(&b.material, "beds.material")?;
            Ok(Bed { material, thickness: b.thickness.si() })
        };
        Ok((materials.clone(), self.beds.iter().map(bed).collect::<Result<_>>()?))
    }

    fn strata(&self, terrain: &HeightField, context: &Context) -> Result<Layers> {
        let grid = terrain.grid();
        let (materials, mut sequence) = self.sequence(context)?;
        if sequence.is_empty() {
            return Ok(Layers::rock(&materials, grid.len()));
        }
        let kind = self.rock.map(RockKind::kind);
        let of_kind = |k: usize| kind.as_ref().map_or(Angle::of(0.0), |kind| Angle::of(kind.dip[k]));
        let dip = self.dip.unwrap_or_else(|| of_kind(0)).si();
        let azimuth = self.dip_direction.unwrap_or_else(|| of_kind(1)).si();
        let folds = self.folds.as_ref().or(kind.as_ref().and_then(|kind| kind.folds.as_ref()));
        // Thickness is across the bed, depth is measured straight down.
        let upright = 1.0 / math::cos(dip);
        sequence.iter_mut().for_each(|bed| bed.thickness *= upright);
        let z = terrain.elevation();
        let top = match &self.top {
            Some(top) => top.resolve("top", terrain, context)?,
            None if self.is_drawn() => Resolved::Uniform(0.0),
            None => Resolved::Uniform(parallel::max(z.len(), |i| z[i])),
        };
        let [lo, hi] = terrain.whole_bounds();
        let middle = [0, 1].map(|k| 0.5 * (lo[k] + hi[k]));
        let fall = math::tan(dip);
        let towards = [math::sin(azimuth), math::cos(azimuth)];
        let datum = parallel::map(z.len(), |i| {
            let [x, y] = grid.position(i);
            let fold = folds.map_or(0.0, |folds| folds.rise(context.seed, [x, y]));
            let raised = self.sets(context).map(|(set, seed)| set.raised(seed, [x, y])).sum::<f64>();
            top.at(i) + fold + raised - fall * ((x - middle[0]) * towards[0] + (y - middle[1]) * towards[1])
        });
        Layers::bedded(&materials, sequence, datum)
    }
}

impl Generator<HeightField> for LayeredGround {
    fn generate(&self, context: &Context) -> Result<HeightField> {
        let grid: Grid = context.wanted(self.grid.grid()?)?;
        let nodes = grid.len();
        let mut terrain = HeightField::new(grid, vec![0.0; nodes])?;
        let surface = self.surface.resolve("surface", &terrain, context)?;
        let depths = self.layers.iter().map(|layer| {
            context.environment.materials.need(&layer.material, "layers.material")?;
            let depth = layer.depth.resolve("layers.depth", &terrain, context)?;
            match parallel::find_first(nodes, |i| !(depth.at(i) >= 0.0)) {
                Some(i) => {
                    Err(Error::parameter("layers.depth", format!("{} m", depth.at(i)), "at least 0 m everywhere"))
                }
                None => Ok((layer.material.as_str(), parallel::map(nodes, |i| depth.at(i)))),
            }
        });
        let depths = depths.collect::<Result<Vec<_>>>()?;
        // Rock first: loose layers raise the surface to its elevation.
        let rock = |i: usize| depths.iter().fold(surface.at(i), |z, (_, depth)| z - depth[i]);
        terrain = HeightField::new(terrain.grid().clone(), parallel::map(nodes, rock))?;
        let strata = self.strata(&terrain, context)?;
        terrain.set_layers(Some(strata));
        if !self.joints.is_empty() {
            let grid = terrain.grid();
            let weakness =
                |i: usize| self.sets(context).map(|(set, seed)| set.weakness(seed, grid.position(i))).product();
            let weakness = parallel::map(nodes, weakness);
            terrain.fields_mut().insert(&names::JOINTS, weakness)?;
        }
        depths.iter().try_for_each(|(material, depth)| terrain.change_depth(material, depth))?;
        Ok(terrain)
    }

    fn estimate(&self, _: &Context) -> Result<Estimate> {
        let nodes = self.grid.grid()?.len() as u64;
        let bytes = nodes * (60 + 24 * self.layers.len() as u64 + if self.joints.is_empty() { 0 } else { 8 });
        Ok(Estimate {
            nodes,
            bytes,
            extent: self.grid.size.map(Length::si),
            origin: Some([0.0; 2]),
            ..Estimate::default()
        })
    }
}

#[cfg(test)]
mod rock_tests;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beds_dip_and_loose_layers_reach_the_surface() {
        let ground: LayeredGround = serde_json::from_str(
            r#"{"grid":{"size":["1 km","1 km"],"cell_size":"100 m"},"surface":"500 m","top":"500 m","dip":"10 deg",
                "dip_direction":"90 deg","beds":[{"material":"sandstone","thickness":"40 m"},
                {"material":"shale","thickness":"60 m"}],"layers":[{"material":"soil","depth":{"formula":"2*u","unit":"m"}}]}"#,
        )
        .unwrap();
        ground.validate().unwrap();
        let terrain = ground.generate(&Context::default()).unwrap();
        assert!(terrain.elevation().iter().all(|z| (z - 500.0).abs() < 1e-9));
        let layers = terrain.layers().unwrap();
        assert_eq!(layers.depth("soil").unwrap()[5 * 11 + 10], 2.0);
        assert_eq!(layers.surface(5 * 11 + 10, 500.0).name, "soil");
        // 500 m from the middle the first bed's top lies 500 tan 10° = 88 m lower in the east and
        // higher in the west. In the east the sequence, 101.5 m thick straight down, repeats above
        // it: sandstone, then shale down to that top.
        let rock =
            |node: usize| layers.column(node, 500.0).filter(|s| s.material.name != "soil").take(2).collect::<Vec<_>>();
        let (east, west) = (rock(5 * 11 + 10), rock(5 * 11));
        let top = 500.0 - 500.0 * math::tan(10.0_f64.to_radians());
        assert_eq!((&*east[0].material.name, &*east[1].material.name), ("sandstone", "shale"));
        assert!((east[1].bottom - top).abs() < 1e-9, "{} {top}", east[1].bottom);
        assert_eq!(&*west[0].material.name, "shale");
        let wrong = LayeredGround {
            beds: vec![BedParams { material: "shalle".into(), thickness: Length::of(3.0) }],
            ..ground.clone()
        };
        assert!(wrong.generate(&Context::default()).unwrap_err().to_string().contains("\"shale\"?"));
    }
}
