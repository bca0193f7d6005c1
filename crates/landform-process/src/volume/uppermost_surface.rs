//! From voxels to a raster.

use landform_core::Result;
use landform_core::terrain::{HeightField, VoxelGrid, nothing_solid};
use landform_core::verb::{Convert, Estimate, Params, Source};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Turns voxels into a raster of their uppermost surface; what lies under a roof is lost, and an
/// empty column is nodata.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct UppermostSurface {}

impl Params for UppermostSurface {
    const NAME: &'static str = "uppermost_surface";
    const SOURCES: &'static [Source] = &[];
}

impl Convert<VoxelGrid, HeightField> for UppermostSurface {
    fn convert(&self, source: &VoxelGrid) -> Result<HeightField> {
        if source.solids() == 0 {
            return Err(nothing_solid());
        }
        let top = |node: usize| source.top(node).unwrap_or(f64::NAN);
        HeightField::new(source.plan().clone(), (0..source.plan().len()).map(top).collect())
    }

    fn estimate(&self, source: Estimate) -> Estimate {
        Estimate { nodes: source.columns, columns: 0, bytes: source.nodes + source.columns * 60, ..source }
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::{NodeSurface, Terrain};
    use landform_core::units::Length;

    use super::*;
    use crate::volume::ToVoxels;

    #[test]
    fn a_raster_comes_back_and_of_whole_voxels_within_half_of_one() {
        let grid = Grid::new(Shape::new(15, 19), [10.0, 10.0]).unwrap();
        let z: Vec<f64> = (0..285).map(|i| 40.0 + 0.37 * i as f64 % 61.0).collect();
        let field = HeightField::new(grid, z).unwrap();
        for (partial, off, share) in [(true, 1e-6, 1e-7), (false, 1.0 + 1e-9, 0.01)] {
            let params = ToVoxels { voxel_height: Some(Length::of(2.0)), partial, ..ToVoxels::default() };
            let voxels = params.convert(&field).unwrap();
            let again = UppermostSurface {}.convert(&voxels).unwrap();
            assert!(field.elevation().iter().zip(again.elevation()).all(|(a, b)| (a - b).abs() <= off));
            assert!((voxels.volume() / field.volume() - 1.0).abs() < share);
        }
    }
}
