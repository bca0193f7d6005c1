//! Blending of two surfaces.

use landform_core::grid::Grid;
use landform_core::terrain::{HeightField, NodeSurface, Visit};
use landform_core::units::{Length, Ratio, RatioDimension};
use landform_core::verb::{Context, Edit, Params, Reach, Source, Varying};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GridParams, Layer, Noise, OnGrid};

/// Blends another surface with the ground: another landscape of the recipe (`with = ["label"]`), or
/// any generator on the landscape's own raster. It is added or subtracted, replaces the ground, or
/// the higher or lower of the two is kept; everywhere or within a mask. Where the other landscape
/// has no ground, this one stays as it is.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Blend {
    /// The other surface: a generator (`use`) and its parameters, without a grid. If neither it nor
    /// `with` is given, it is noise.
    pub layer: Option<Layer>,
    /// How the two are put together.
    pub mode: BlendMode,
    /// Fraction of the blend, from 0 (the ground as it was) to 1; may vary in space, as a mask.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1.0))]
    pub amount: Varying<RatioDimension>,
    /// Higher and lower: height over which one surface passes into the other.
    #[schemars(extend("x-min" = 0.0))]
    pub softness: Length,
}

/// How two surfaces are put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum BlendMode {
    /// The sum.
    #[default]
    Add,
    /// The ground less the layer.
    Subtract,
    /// The layer alone: with a mask, a crossfade.
    Replace,
    /// The higher of the two.
    Higher,
    /// The lower of the two.
    Lower,
}

impl Default for Blend {
    fn default() -> Self {
        Self { layer: None, mode: BlendMode::Add, amount: Ratio::of(1.0).into(), softness: Length::of(0.0) }
    }
}

/// What [`Blend`] needs of a generator.
pub(super) trait LayerGenerator {
    fn on(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>>;
    fn check_layer(&self) -> Result<()>;
    fn reach_of_layer(&self) -> Reach;
}

impl<P: OnGrid> LayerGenerator for P {
    fn on(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>> {
        self.elevations(grid, context)
    }

    fn check_layer(&self) -> Result<()> {
        self.validate()?;
        if *self.grid() != *P::default().grid() {
            let GridParams { size, cell_size } = self.grid();
            let value = format!("size {} x {}, cell_size {cell_size}", size[0], size[1]);
            return Err(Error::parameter(
                "layer",
                value,
                "a generator without a grid: it takes the landscape's own raster",
            ));
        }
        Ok(())
    }

    fn reach_of_layer(&self) -> Reach {
        self.reach()
    }
}

impl Params for Blend {
    const NAME: &'static str = "blend";
    const SOURCES: &'static [Source] = &[];
    const WITH: bool = true;

    fn check(&self) -> Result<()> {
        self.layer.as_ref().map_or(Ok(()), |layer| layer.generator().check_layer())
    }

    fn reach(&self) -> Reach {
        let layer = self.layer.as_ref().map_or(Reach::Point, |layer| layer.generator().reach_of_layer());
        layer.or(self.amount.reach())
    }
}

impl Blend {
    /// The other surface on the nodes of a raster; NaN where it has no ground.
    fn other(&self, grid: &Grid, context: &Context) -> Result<Vec<f64>> {
        match (&self.layer, context.with) {
            (Some(layer), []) => layer.generator().on(grid, context),
            (None, []) => Noise::default().elevations(grid, context),
            (None, [(_, landscape)]) => landscape.visit(OnNodes(grid)),
            (Some(_), _) => Err(Error::parameter("layer", "a generator", "no layer where `with` names a landscape")),
            (None, many) => Err(Error::parameter("with", many.len(), "one landscape")),
        }
    }
}

/// Elevation of a landscape on the nodes of a raster, m.
struct OnNodes<'a>(&'a Grid);

impl Visit for OnNodes<'_> {
    type Out = Result<Vec<f64>>;

    fn surface<T: landform_core::terrain::Surface>(self, terrain: &T) -> Self::Out {
        let raster = terrain.rasterized()?;
        Ok(parallel::map(self.0.shape.len(), |i| raster.elevation_at(self.0.position(i))))
    }

    fn body<T: landform_core::terrain::Body>(self, terrain: &T) -> Self::Out {
        Ok(parallel::map(self.0.shape.len(), |i| terrain.height_at(self.0.position(i)).unwrap_or(f64::NAN)))
    }
}

impl Edit<HeightField> for Blend {
    fn edit(&self, terrain: &mut HeightField, context: &Context) -> Result<()> {
        let amount = self.amount.resolve("amount", terrain, context)?;
        let layer = self.other(terrain.grid(), context)?;
        let (mode, softness) = (self.mode, self.softness.si());
        let blend = |i: usize, z: &mut f64| {
            let b = layer[i];
            if b.is_nan() {
                return;
            }
            let whole = match mode {
                BlendMode::Add => *z + b,
                BlendMode::Subtract => *z - b,
                BlendMode::Replace => b,
                BlendMode::Higher => -lower(-*z, -b, softness),
                BlendMode::Lower => lower(*z, b, softness),
            };
            *z = math::lerp(*z, whole, amount.at(i).clamp(0.0, 1.0));
        };
        terrain.change(landform_core::terrain::Layer::Bedrock, |z| parallel::update(z, blend));
        Ok(())
    }
}

/// The lower of two, rounded by a parabola where they differ by less than `softness`.
fn lower(a: f64, b: f64, softness: f64) -> f64 {
    let near = (softness - (a - b).abs()).max(0.0);
    let round = if softness > 0.0 { near * near / (4.0 * softness) } else { 0.0 };
    a.min(b) - round
}

#[cfg(test)]
mod tests {
    use super::*;
    use landform_core::grid::Shape as GridShape;
    use landform_core::random::Seed;
    use landform_core::terrain::Representation;

    fn blended(json: &str) -> Vec<f64> {
        let grid = Grid::new(GridShape::new(5, 5), [10.0, 10.0]).unwrap();
        let mut terrain = HeightField::new(grid, (0..25).map(f64::from).collect()).unwrap();
        let blend: Blend = serde_json::from_str(json).unwrap();
        blend.validate().unwrap();
        blend.edit(&mut terrain, &Context { seed: Seed(1), ..Context::default() }).unwrap();
        terrain.elevation().to_vec()
    }

    #[test]
    fn modes_do_as_they_say() {
        let with = |rest: &str| blended(&format!(r#"{{"layer":{{"use":"flat","elevation":"10 m"}},{rest}}}"#));
        assert_eq!(with(r#""mode":"add""#)[3], 13.0);
        assert_eq!(with(r#""mode":"subtract""#)[3], -7.0);
        assert_eq!(with(r#""mode":"replace","amount":0.5"#)[4], 7.0);
        assert_eq!(with(r#""mode":"higher""#)[3], 10.0);
        assert_eq!(with(r#""mode":"lower""#)[24], 10.0);
        let soft = with(r#""mode":"lower","softness":"4 m""#);
        assert_eq!((soft[10], soft[24], soft[2]), (9.0, 10.0, 2.0));
        // A mask: the eastern half only.
        let half = with(r#""amount":{"formula":"smoothstep(0.5, 0.5, u)"}"#);
        assert_eq!((half[0], half[4]), (0.0, 14.0));
    }

    #[test]
    fn another_landscape_is_laid_over_the_ground_where_it_has_ground() {
        let grid = Grid::new(GridShape::new(5, 5), [10.0, 10.0]).unwrap();
        let mut terrain = HeightField::new(grid, vec![1.0; 25]).unwrap();
        let small = Grid::new(GridShape::new(3, 3), [10.0, 10.0]).unwrap();
        let other = std::sync::Arc::new(HeightField::new(small, vec![7.0; 9]).unwrap().wrap());
        let with = [("hill".to_string(), other)];
        let context = Context { with: &with, ..Context::default() };
        let blend = Blend { mode: BlendMode::Higher, ..Blend::default() };
        blend.edit(&mut terrain, &context).unwrap();
        let high = terrain.elevation().iter().filter(|&&z| z == 7.0).count();
        assert_eq!((high, terrain.elevation().iter().sum::<f64>()), (9, 9.0 * 7.0 + 16.0));
        let both = Blend { layer: Some(Layer::Noise(Noise::default())), ..blend };
        assert!(both.edit(&mut terrain, &context).unwrap_err().to_string().contains("layer"));
    }

    #[test]
    fn a_layer_of_its_own_size_is_refused() {
        let blend: Blend = serde_json::from_str(r#"{"layer":{"use":"noise","grid":{"cell_size":"3 m"}}}"#).unwrap();
        assert!(blend.check().unwrap_err().to_string().contains("landscape's own raster"));
        assert!(serde_json::from_str::<Blend>(r#"{"layer":{"use":"noise","wavelenth":"3 m"}}"#).is_err());
    }
}
