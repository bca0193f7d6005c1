//! A block of rock in voxels, with what dissolution needs to know of it.

mod fractures;

use landform_core::algo::noise::fbm;
use landform_core::grid::{Grid, Shape};
use landform_core::random::Seed;
use landform_core::terrain::VoxelGrid;
use landform_core::units::{Angle, Length, Ratio};
use landform_core::verb::{Context, Estimate, Generator, Params, Source};
use landform_core::{Error, Result, math, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use fractures::FractureParams;
use fractures::{Fall, Planes};

/// A block of rock in voxels, with porosity, permeability and solubility in each: beds of any dip,
/// and sets of fractures. The permeability is over that of plain rock. Caves are dissolved in it.
///
/// ```
/// assert_eq!(landform_process::volume::RockVolume::default().porosity.si(), 0.05);
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct RockVolume {
    /// Extent, and side of a voxel.
    pub grid: BlockParams,
    /// Elevation of the underside.
    pub bottom: Length,
    /// Part of the rock that is pores.
    #[schemars(extend("x-min" = 0.0001, "x-max" = 0.9))]
    pub porosity: Ratio,
    /// Beds from the top, repeated downwards: { material, thickness }. If none are given, all of
    /// it is limestone.
    pub beds: Vec<RockBed>,
    /// Angle by which beds dip about the middle of the block.
    #[schemars(extend("x-min" = 0.0, "x-max" = 80.0))]
    pub dip: Angle,
    /// Compass direction towards which they dip.
    pub dip_direction: Angle,
    /// Permeability along the planes between beds as a factor on that of plain rock.
    #[schemars(extend("x-min" = 0.01, "x-max" = 1000.0))]
    pub bedding_permeability: f64,
    /// Sets of fractures: { dip_direction, dip, spacing, permeability, aperture }.
    pub fractures: Vec<FractureParams>,
    /// Balls in which porosity and permeability fall towards the middle, as obstacles, or rise: {
    /// at, radius, factor }.
    pub spheres: Vec<SphereParams>,
    /// By which number the permeability of plain rock varies from place to place: the logarithm of
    /// its ratio to the mean reaches about this far to either side. 0 is even rock.
    #[schemars(extend("x-min" = 0.0, "x-max" = 4.0))]
    pub variation: f64,
    /// Distance over which it varies. If not given, it is eight voxels.
    #[schemars(extend("x-above" = 0.0))]
    pub variation_length: Option<Length>,
}

/// Extent of a block and side of a voxel.
///
/// ```
/// assert_eq!(landform_process::volume::BlockParams::default().cell_size.si(), 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct BlockParams {
    /// Extent east, north and up.
    #[schemars(extend("x-above" = 0.0))]
    pub size: [Length; 3],
    /// Side of a voxel; adjusted so that a whole number of them fits.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub cell_size: Length,
}

/// A bed of rock.
///
/// ```
/// let bed = r#"{"material":"marl","thickness":"1 m"}"#;
/// let bed: landform_process::volume::RockBed = serde_json::from_str(bed).unwrap();
/// assert_eq!(bed.thickness.si(), 1.0);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RockBed {
    /// Name of the material.
    pub material: String,
    /// Thickness across the bed.
    #[schemars(extend("x-above" = 0.0))]
    pub thickness: Length,
}

/// A ball of other rock.
///
/// ```
/// let ball = r#"{"at":["3 m","4 m","5 m"],"radius":"2 m","factor":0.1}"#;
/// let ball: landform_process::volume::SphereParams = serde_json::from_str(ball).unwrap();
/// assert_eq!(ball.radius.si(), 2.0);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereParams {
    /// Its middle: x, y and elevation.
    pub at: [Length; 3],
    /// Its radius.
    #[schemars(extend("x-above" = 0.0))]
    pub radius: Length,
    /// Factor on porosity and permeability in the middle; 1 at its rim.
    #[schemars(extend("x-min" = 0.0, "x-max" = 1000.0))]
    pub factor: f64,
}

impl Default for BlockParams {
    fn default() -> Self {
        Self { size: [60.0, 60.0, 20.0].map(Length::of), cell_size: Length::of(1.0) }
    }
}

impl Default for RockVolume {
    fn default() -> Self {
        Self {
            grid: BlockParams::default(),
            bottom: Length::of(0.0),
            porosity: Ratio::of(0.05),
            beds: Vec::new(),
            dip: Angle::of(0.0),
            dip_direction: Angle::of(90.0),
            bedding_permeability: 2.0,
            fractures: Vec::new(),
            spheres: Vec::new(),
            variation: 0.7,
            variation_length: None,
        }
    }
}

impl BlockParams {
    /// Voxels east, north and up, and the sides of one, m.
    fn voxels(&self) -> Result<([usize; 3], [f64; 3])> {
        let (size, cell) = (self.size.map(Length::si), self.cell_size.si());
        let whole = size.map(|s| (s / cell).round().max(1.0));
        let count = whole.iter().product::<f64>();
        if !(cell > 0.0 && size.iter().all(|s| *s >= 0.5 * cell)) {
            let given = format!("{size:?} m in voxels of {cell:?} m");
            return Err(Error::parameter("grid.size", given, "at least one voxel each way"));
        }
        if count >= f64::from(u32::MAX) {
            let given = format!("{cell:?} m: {count:.3e} voxels");
            return Err(Error::parameter("grid.cell_size", given, "fewer than 4.29e9 voxels in all"));
        }
        Ok((whole.map(|n| n as usize), [0, 1, 2].map(|k| size[k] / whole[k])))
    }
}

impl Params for RockVolume {
    const NAME: &'static str = "rock_volume";
    const SOURCES: &'static [Source] = &[];

    fn leaves(&self) -> Vec<String> {
        ["rock", "material", "porosity", "permeability", "solubility"].map(String::from).to_vec()
    }

    fn check(&self) -> Result<()> {
        let ([_, _, nz], [dx, dy, dz]) = self.grid.voxels()?;
        VoxelGrid::check_span(self.bottom.si(), nz, dz)?;
        // Shorter ones are lost in voxels, and in rounding.
        let least = 1e-3 * dx.min(dy).min(dz);
        let beds = self.beds.iter().map(|b| ("beds.thickness", b.thickness));
        let spacings = self.fractures.iter().map(|f| ("fractures.spacing", f.spacing));
        let lengths = beds.chain(spacings).chain(self.variation_length.map(|l| ("variation_length", l)));
        match lengths.into_iter().find(|(_, length)| !(length.si() >= least)) {
            Some((name, given)) => {
                let expected = format!("at least {} (a thousandth of a voxel)", Length::of(least));
                Err(Error::parameter(name, given, &expected))
            }
            None => Ok(()),
        }
    }
}

/// What a place in the rock is.
#[derive(Clone, Copy, Default)]
struct Rock {
    material: u8,
    porosity: f32,
    permeability: f32,
}

/// Where a place lies in the beds.
struct Beds {
    /// Material and depth of the lower face of each, m across.
    below: Vec<(u8, f64)>,
    fall: Fall,
    /// Distance across the beds of the top of the first, m.
    top: f64,
}

impl Beds {
    fn at(&self, place: [f64; 3]) -> (u8, f64) {
        let total = self.below.last().map_or(f64::INFINITY, |b| b.1);
        let depth = self.top - self.fall.across(place);
        let within = depth - (depth / total).floor() * total;
        let k = self.below.iter().position(|b| within < b.1).unwrap_or(0);
        let above = if k > 0 { self.below[k - 1].1 } else { 0.0 };
        // Depth under the plane over the bed.
        (self.below[k].0, within - above)
    }
}

impl RockVolume {
    fn beds(&self, context: &Context, middle: [f64; 3], top: f64) -> Result<Beds> {
        let materials = &context.environment.materials;
        let mut below = Vec::new();
        let mut depth = 0.0;
        for bed in &self.beds {
            depth += bed.thickness.si();
            below.push((materials.need(&bed.material, "beds.material")?, depth));
        }
        if below.is_empty() {
            below.push((materials.need("limestone", "beds.material")?, f64::INFINITY));
        }
        let fall = Fall::new(self.dip.si(), self.dip_direction.si());
        let top = fall.across([middle[0], middle[1], top]);
        Ok(Beds { below, fall, top })
    }

    fn factor(&self, seed: Seed, length: f64, place: [f64; 3]) -> f64 {
        let mut factor = 1.0;
        if self.variation > 0.0 {
            // Three sections through noise of the plane, none of which is along an axis.
            let [x, y, z] = place.map(|v| v / length);
            let noise = |k: u64, u: f64, v: f64| fbm(seed.with(k), u, v, 3, 2.0, 0.5);
            let sum = noise(1, x + 0.37 * z, y - 0.21 * z)
                + noise(2, y + 0.31 * x, 1.6 * z - 0.2 * x)
                + noise(3, x - 0.43 * y, 1.6 * z + 0.3 * y);
            factor = math::exp(self.variation * 1.4 * sum);
        }
        for sphere in &self.spheres {
            let d = [0, 1, 2].map(|k| place[k] - sphere.at[k].si());
            let far = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt() / sphere.radius.si();
            if far < 1.0 {
                factor *= math::lerp(sphere.factor, 1.0, far);
            }
        }
        factor
    }
}

impl Generator<VoxelGrid> for RockVolume {
    fn generate(&self, context: &Context) -> Result<VoxelGrid> {
        let ([nx, ny, nz], [dx, dy, dz]) = self.grid.voxels()?;
        let bottom = self.bottom.si();
        let mut plan = Grid::new(Shape::new(ny, nx), [dx, dy])?;
        // Nodes stand in the middle of voxels, which fill the extent.
        plan.origin = [0.5 * dx, (ny as f64 - 0.5) * dy];
        let top = bottom + nz as f64 * dz;
        let middle = [0.5 * nx as f64 * dx, 0.5 * ny as f64 * dy, 0.5 * (bottom + top)];
        let beds = self.beds(context, middle, top)?;
        let planes: Vec<Planes> = (0..).zip(&self.fractures).map(|(k, f)| f.planes(context.seed.with(k))).collect();
        let length = self.variation_length.map_or(8.0 * dx, Length::si);
        let (porosity, seed) = (self.porosity.si(), context.seed.named("variation"));
        let rock = parallel::map(nx * ny * nz, |i| {
            let [x, y] = plan.position(i % (nx * ny));
            let place = [x, y, bottom + ((i / (nx * ny)) as f64 + 0.5) * dz];
            let (material, under) = beds.at(place);
            let factor = self.factor(seed, length, place);
            let on_plane = under < dz && !self.beds.is_empty();
            let bedding = if on_plane { self.bedding_permeability } else { 1.0 };
            let (open, wide) = planes.iter().fold((0.0, bedding), |(open, wide): (f64, f64), planes| {
                if planes.meets(place, [dx, dy, dz]) {
                    (open + planes.aperture / dx.min(dy).min(dz), wide.max(planes.permeability))
                } else {
                    (open, wide)
                }
            });
            // Obstacles hold less water as well.
            let pores = (porosity * factor.min(1.0) + open).clamp(1e-4, 0.95);
            Rock { material, porosity: pores as f32, permeability: (factor * wide).clamp(1e-3, 1e4) as f32 }
        });
        let materials = &context.environment.materials;
        let number = |level: usize, node: usize| Some(rock[level * nx * ny + node].material);
        let mut ground = VoxelGrid::from_fn(plan, nz, bottom, dz, materials, number)?;
        ground.set_field(VoxelGrid::POROSITY, rock.iter().map(|r| r.porosity).collect())?;
        ground.set_field(VoxelGrid::PERMEABILITY, rock.iter().map(|r| r.permeability).collect())?;
        let solubility = |r: &Rock| materials.get(r.material).solubility as f32;
        ground.set_field(VoxelGrid::SOLUBILITY, rock.iter().map(solubility).collect())?;
        Ok(ground)
    }

    fn estimate(&self, _: &Context) -> Result<Estimate> {
        let ([nx, ny, nz], _) = self.grid.voxels()?;
        let nodes = (nx * ny) as u64 * nz as u64;
        let extent = [self.grid.size[0].si(), self.grid.size[1].si()];
        Ok(Estimate { nodes, columns: (nx * ny) as u64, bytes: nodes * 26, extent, origin: Some([0.0; 2]) })
    }
}

#[cfg(test)]
mod tests {
    use landform_core::terrain::Ground;

    use super::*;

    fn rock(text: &str) -> VoxelGrid {
        let rock: RockVolume = serde_json::from_str(text).unwrap();
        rock.validate().unwrap();
        rock.generate(&Context::default()).unwrap()
    }

    #[test]
    fn beds_fill_the_block_by_their_thickness_and_dip() {
        let text = r#"{"grid":{"size":["40 m","30 m","20 m"],"cell_size":"1 m"},"variation":0,
            "beds":[{"material":"limestone","thickness":"4 m"},{"material":"shale","thickness":"1 m"}]}"#;
        let ground = rock(text);
        let shale = ground.materials().find("shale").unwrap();
        let is_shale = |level: usize| ground.material(level, 17) == Some(shale);
        assert_eq!((0..20).filter(|l| is_shale(*l)).collect::<Vec<_>>(), [0, 5, 10, 15]);
        let all = ground.bounding_box();
        assert_eq!((all.low, all.high), ([0.0; 3], [40.0, 30.0, 20.0]));
        assert!(ground.field("porosity").unwrap().iter().all(|p| *p == 0.05));
        let solubility = ground.field("solubility").unwrap();
        assert_eq!((solubility[0], solubility[40 * 30]), (0.0, 1.0));
        // Beds that dip east lie lower in the east.
        let dipping = rock(&text.replace("\"variation\"", "\"dip\":\"20 deg\",\"variation\""));
        let is_shale = |level: usize, col: usize| dipping.material(level, 15 * 40 + col) == Some(shale);
        // 11 m east the beds lie 11 tan 20° = 4.0 m lower.
        let same = (4..20)
            .flat_map(|l| (0..29).map(move |c| (l, c)))
            .filter(|&(l, c)| is_shale(l, c) == is_shale(l - 4, c + 11));
        assert!(same.count() > 16 * 29 * 9 / 10);
        assert!((0..40).any(|c| is_shale(10, c)) && !(0..40).all(|c| is_shale(10, c)));
    }

    #[test]
    fn fractures_stand_at_their_spacing_and_hang_together() {
        let ground = rock(
            r#"{"grid":{"size":["60 m","60 m","20 m"],"cell_size":"1 m"},"variation":0,"bedding_permeability":1,
            "fractures":[{"dip_direction":"120 deg","dip":"85 deg","spacing":"9 m","permeability":4.0}]}"#,
        );
        let wide = ground.field("permeability").unwrap();
        let share = wide.iter().filter(|k| **k == 4.0).count() as f64 / wide.len() as f64;
        // A plane of one voxel every nine metres, thicker by its direction.
        assert!((0.08..0.16).contains(&share), "{share}");
        assert!(wide.iter().all(|k| *k == 4.0 || *k == 1.0));
    }

    #[test]
    fn lengths_that_voxels_cannot_tell_apart_are_refused() {
        let error = |text: &str| serde_json::from_str::<RockVolume>(text).unwrap().validate().unwrap_err().to_string();
        for (text, name) in [
            (r#"{"bottom":"1e8 m"}"#, "`bottom`"),
            (r#"{"bottom":"-1e308 m"}"#, "`bottom`"),
            (r#"{"variation_length":"1e-308 m"}"#, "`variation_length`"),
            (r#"{"beds":[{"material":"marl","thickness":"1e-9 m"}]}"#, "`beds.thickness`"),
            (r#"{"fractures":[{"dip_direction":"0 deg","dip":"90 deg","spacing":"1e-300 m"}]}"#, "`fractures.spacing`"),
            (r#"{"grid":{"size":["1e-9 m","20 m","20 m"],"cell_size":"1 m"}}"#, "`grid.size`"),
        ] {
            let told = error(text);
            assert!(told.contains(name) && told.len() < 200, "{told}");
        }
        let short = rock(r#"{"grid":{"size":["4 m","4 m","4 m"],"cell_size":"1 m"},"variation_length":"0.001 m"}"#);
        assert!(short.field("permeability").unwrap().iter().all(|k| k.is_finite()));
    }

    #[test]
    fn a_block_of_too_many_voxels_is_refused() {
        let rock: RockVolume =
            serde_json::from_str(r#"{"grid":{"size":["100 km","100 km","100 km"],"cell_size":"1 m"}}"#).unwrap();
        assert!(rock.validate().unwrap_err().to_string().contains("voxels"));
    }
}
