//! From a raster to voxels.

use landform_core::terrain::{HeightField, Interpolation, Materials, NodeSurface, VoxelGrid, resample};
use landform_core::units::Length;
use landform_core::verb::{Convert, Estimate, Params, Source};
use landform_core::{Error, Result, parallel};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Turns a raster into voxels, a column under each node, so that the ground can have caves and
/// overhangs. Layers give each voxel its material. Voxels at the surface are full in part; fields,
/// features, chosen outlets and the place of nodata are lost.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToVoxels {
    /// Width of a voxel: the surface is taken on such cells, linear between its own. If not given,
    /// it is the size of its cells.
    #[schemars(extend("x-above" = 0.0, "x-role" = "resolution"))]
    pub cell_size: Option<Length>,
    /// Height of a voxel. If not given, the size of a cell.
    #[schemars(extend("x-min" = 0.001, "x-role" = "resolution"))]
    pub voxel_height: Option<Length>,
    /// Ground under the lowest node.
    #[schemars(extend("x-min" = 0.0, "x-max" = 100_000.0))]
    pub depth: Length,
    /// Whether voxels at the surface may be full in part, so that the ground keeps its volume; else
    /// a voxel is solid where its middle lies under the surface, and takes a fifth of the memory.
    pub partial: bool,
    /// Empty room over the highest node.
    #[schemars(extend("x-min" = 0.0, "x-max" = 100_000.0))]
    pub headroom: Length,
}

impl Default for ToVoxels {
    fn default() -> Self {
        Self { cell_size: None, voxel_height: None, depth: Length::of(50.0), partial: true, headroom: Length::of(0.0) }
    }
}

impl Params for ToVoxels {
    const NAME: &'static str = "to_voxels";
    const SOURCES: &'static [Source] = &[];

    fn leaves(&self) -> Vec<String> {
        ["rock", "material"].map(String::from).to_vec()
    }
}

impl Convert<HeightField, VoxelGrid> for ToVoxels {
    fn convert(&self, source: &HeightField) -> Result<VoxelGrid> {
        let resampled = match self.cell_size {
            Some(cell) => Some(resample(source, &source.grid().with_cell_size(cell.si())?, Interpolation::Linear)?),
            None => None,
        };
        let source = resampled.as_ref().unwrap_or(source);
        let z = source.elevation();
        let height = self.voxel_height.map_or(source.grid().spacing[0], Length::si);
        let range = |(low, high): (f64, f64), z: &f64| (low.min(*z), high.max(*z));
        let (low, high) = z.iter().fold((f64::INFINITY, f64::NEG_INFINITY), range);
        if !low.is_finite() {
            return Err(Error::Empty { what: "the ground: all of it is nodata".into() });
        }
        let bottom = ((low - self.depth.si()) / height).floor() * height;
        let levels = ((high + self.headroom.si() - bottom) / height).ceil().max(1.0);
        if levels > 1e6 || levels * z.len() as f64 > f64::from(u32::MAX) {
            let given = format!("{height} m over {} m of ground: {levels} levels on {} nodes", high - bottom, z.len());
            return Err(Error::parameter("voxel_height", given, "at most a million levels and 4 billion voxels"));
        }
        let materials = source.layers().map_or_else(Materials::default, |layers| layers.materials().clone());
        let nodes = z.len();
        let part = |level: usize, node: usize| {
            let part = (z[node] - bottom) / height - level as f64;
            // Nodata is empty.
            if part.is_nan() { 0.0 } else { part.clamp(0.0, 1.0) }
        };
        let material = |level: usize, node: usize| {
            let part = part(level, node);
            if !(part > if self.partial { 0.0 } else { 0.5 }) {
                return None;
            }
            let middle = bottom + (level as f64 + 0.5 * part.min(1.0)) * height;
            let strata = source.layers().map(|layers| layers.column(node, z[node]));
            Some(strata.and_then(|mut s| s.find(|s| s.bottom < middle)).map_or(0, |stratum| stratum.number))
        };
        let mut ground =
            VoxelGrid::from_fn(source.grid().clone(), levels as usize, bottom, height, &materials, material)?;
        if self.partial {
            let count = nodes * levels as usize;
            ground.set_fill(parallel::map(count, |i| part(i / nodes, i % nodes) as f32))?;
        }
        Ok(ground)
    }

    /// As if the ground were a tenth as high as it is wide.
    fn estimate(&self, source: Estimate) -> Estimate {
        let side = source.extent[0].max(1.0);
        let own = (source.extent[0] * source.extent[1] / source.nodes.max(1) as f64).sqrt().max(1e-3);
        let cell = self.cell_size.map_or(own, Length::si);
        let columns = self.cell_size.map_or(source.nodes, |_| source.raster_nodes(cell));
        let height = self.voxel_height.map_or(cell, Length::si);
        let levels = ((0.1 * side + self.depth.si() + self.headroom.si()) / height).ceil();
        let nodes = (columns as f64 * levels) as u64;
        Estimate {
            nodes,
            columns,
            bytes: (source.nodes + columns).saturating_mul(60).saturating_add(nodes.saturating_mul(if self.partial {
                6
            } else {
                2
            })),
            ..source
        }
    }
}
