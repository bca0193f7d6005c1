//! Ground in voxels from a file.

use std::path::Path;

use landform_core::grid::{Grid, Shape};
use landform_core::terrain::VoxelGrid;
use landform_core::units::{Length, Ratio};
use landform_core::verb::{Context, Estimate, Generator, Params, Source};
use landform_core::{Error, Result};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::format::{Array, VolumeFile, read_volume};

/// Reads voxels: VTI (VTK image data, appended raw), NRRD or NPY, as `write_volume` writes them. An
/// array named "material" has numbers of materials, of which 255 is empty; others become fields.
///
/// ```
/// assert_eq!(landform_io::import::VolumeFileParams::default().field, "porosity");
/// ```
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct VolumeFileParams {
    /// Path of the file, relative to the recipe.
    pub path: String,
    /// Side of a voxel, where the file does not say it.
    #[schemars(extend("x-above" = 0.0))]
    pub cell_size: Length,
    /// Name of the values, where the file does not say it.
    pub field: String,
    /// Material of the rock, where the file has no numbers of materials.
    pub material: String,
    /// Value of `field` above which a voxel is empty. If not given, none is, but for those that the
    /// numbers of materials say.
    pub empty_above: Option<Ratio>,
}

impl Default for VolumeFileParams {
    fn default() -> Self {
        Self {
            path: String::new(),
            cell_size: Length::of(1.0),
            field: "porosity".into(),
            material: "limestone".into(),
            empty_above: None,
        }
    }
}

impl Params for VolumeFileParams {
    const NAME: &'static str = "volume_file";
    const SOURCES: &'static [Source] = &[];
    const INPUTS: &'static [&'static str] = &["path"];

    fn leaves(&self) -> Vec<String> {
        ["rock", "material", &self.field].map(String::from).to_vec()
    }

    fn check(&self) -> Result<()> {
        if self.path.is_empty() {
            return Err(Error::parameter("path", "\"\"", "the path of a volume: .vti, .nrrd or .npy"));
        }
        Ok(())
    }
}

impl VolumeFileParams {
    fn read(&self, context: &Context) -> Result<VolumeFile> {
        let bytes = context.maps.bytes(Path::new(&self.path))?;
        let beside = || {
            let text = context.maps.bytes(Path::new(&format!("{}.landform.json", self.path))).ok()?;
            serde_json::from_slice(&text).ok()
        };
        read_volume(&self.path, &bytes, beside)
    }

    /// The low corner and the sides of a voxel, m.
    fn place(&self, volume: &VolumeFile) -> Result<([f64; 3], [f64; 3])> {
        let (low, side) = volume.place.unwrap_or(([0.0; 3], [self.cell_size.si(); 3]));
        const SIZES: std::ops::RangeInclusive<f64> = 1e-6..=1e6;
        if !side.iter().all(|s| SIZES.contains(s)) {
            let what = format!("its voxels measure {side:?} m; expected sizes from 1e-6 to 1e6 m");
            return Err(Error::format("volume", what));
        }
        if !low.iter().all(|v| v.abs() <= 1e9) {
            return Err(Error::format("volume", format!("it begins at {low:?} m; expected a place within 1e9 m of 0")));
        }
        Ok((low, side))
    }
}

impl Generator<VoxelGrid> for VolumeFileParams {
    fn generate(&self, context: &Context) -> Result<VoxelGrid> {
        let volume = self.read(context)?;
        let (low, [dx, dy, dz]) = self.place(&volume)?;
        let [nx, ny, nz] = volume.size;
        let mut plan = Grid::new(Shape::new(ny, nx), [dx, dy])?;
        plan.origin = [low[0] + 0.5 * dx, low[1] + (ny as f64 - 0.5) * dy];
        let materials = &context.environment.materials;
        let plain = materials.need(&self.material, "material")?;
        let (mut numbers, mut fields) = (None, Vec::new());
        for (name, array) in volume.arrays {
            let name = name.unwrap_or_else(|| self.field.clone());
            match array {
                Array::Bytes(values) if name == "material" => numbers = Some(values),
                Array::Bytes(values) => fields.push((name, values.into_iter().map(f32::from).collect::<Vec<_>>())),
                Array::Real(values) => fields.push((name, values)),
            }
        }
        if let Some((name, _)) = fields.iter().find(|f| f.1.iter().any(|v| !v.is_finite())) {
            return Err(Error::format("volume", format!("`{name}` has a value that is no finite number")));
        }
        let open = match (self.empty_above, fields.iter().find(|f| f.0 == self.field)) {
            (None, _) => None,
            (Some(most), Some((_, values))) => Some((values, most.si() as f32)),
            (Some(_), None) => {
                let available = fields.iter().map(|f| f.0.clone()).collect();
                return Err(Error::MissingField {
                    name: self.field.clone(),
                    needed_by: "`empty_above`".into(),
                    available,
                });
            }
        };
        let material = |level: usize, node: usize| {
            let i = level * nx * ny + node;
            let is_open = open.is_some_and(|(values, most)| values[i] > most);
            let number = numbers.as_ref().map_or(plain, |n| n[i]);
            (!is_open && number != u8::MAX).then_some(number)
        };
        let mut ground = VoxelGrid::from_fn(plan, nz, low[2], dz, materials, material)?;
        for (name, values) in fields {
            ground.set_field(&name, values)?;
        }
        Ok(ground)
    }

    fn estimate(&self, context: &Context) -> Result<Estimate> {
        let volume = self.read(context)?;
        let (low, side) = self.place(&volume)?;
        let [nx, ny, nz] = volume.size.map(|n| n as u64);
        let (nodes, fields) = (nx * ny * nz, volume.arrays.len() as u64);
        let extent = [nx as f64 * side[0], ny as f64 * side[1]];
        let origin = Some([low[0], low[1]]);
        Ok(Estimate { nodes, columns: nx * ny, bytes: nodes * (2 + 12 * fields), extent, origin })
    }
}
