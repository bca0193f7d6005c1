//! Ground in voxels: each of one material, or empty. It may have caves, arches and overhangs.
//!
//! A column of voxels stands over each node of a raster. Levels count upwards from the underside.

mod erode;
mod ground;

use serde::{Deserialize, Serialize};

use super::{Kind, Materials, Terrain};
use crate::grid::Grid;
use crate::{Error, Result, parallel};

/// What an empty voxel holds instead of a material's number.
const EMPTY: u8 = u8::MAX;

/// Ground in voxels of one size.
///
/// ```
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{Materials, Terrain, VoxelGrid};
///
/// let plan = Grid::new(Shape::new(2, 3), [10.0, 10.0])?;
/// // Two levels of 5 m over z = 0; the lower one is rock.
/// let ground = VoxelGrid::from_fn(plan, 2, 0.0, 5.0, &Materials::default(), |level, _| (level == 0).then_some(0))?;
/// assert_eq!(ground.solids(), 6);
/// assert_eq!(ground.volume(), 6.0 * 10.0 * 10.0 * 5.0);
/// # Ok::<(), landform_core::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VoxelGrid {
    plan: Grid,
    levels: usize,
    bottom: f64,
    height: f64,
    materials: Materials,
    /// Numbers of materials, level by level from the underside, each in the order of the plan's nodes.
    voxels: Vec<u8>,
}

impl VoxelGrid {
    /// Voxels of `height` m in `levels` above the elevation `bottom` (m), one column over each node of `plan`.
    /// `material(level, node)` is the number of a voxel's material in the table; none where it is empty.
    ///
    /// **Cost** O(voxels).
    ///
    /// # Errors
    /// [`Error::Parameter`] without levels, for a height that is not positive, or for a number that is not in the table.
    pub fn from_fn(
        plan: Grid,
        levels: usize,
        bottom: f64,
        height: f64,
        materials: &Materials,
        material: impl Fn(usize, usize) -> Option<u8> + Sync,
    ) -> Result<Self> {
        if levels == 0 || !(height > 0.0 && height.is_finite() && bottom.is_finite()) {
            let given = format!("{levels} levels of {height} m from {bottom} m");
            return Err(Error::parameter("levels", given, "at least one level of a positive height"));
        }
        let nodes = plan.len();
        let Some(count) = nodes.checked_mul(levels).filter(|n| *n < u32::MAX as usize) else {
            return Err(Error::parameter("levels", format!("{levels} over {nodes} nodes"), "fewer than 2^32 voxels"));
        };
        let voxels = parallel::map(count, |i| material(i / nodes, i % nodes).unwrap_or(EMPTY));
        let most = materials.all().len() as u8;
        if let Some(i) = parallel::find_first(count, |i| voxels[i] != EMPTY && voxels[i] >= most) {
            return Err(Error::parameter("material", voxels[i], &format!("a number below {most}")));
        }
        Ok(Self { plan, levels, bottom, height, materials: materials.clone(), voxels })
    }

    /// The raster over whose nodes the columns stand.
    pub fn plan(&self) -> &Grid {
        &self.plan
    }

    /// Number of levels.
    pub fn levels(&self) -> usize {
        self.levels
    }

    /// Elevation of the underside, m.
    pub fn bottom(&self) -> f64 {
        self.bottom
    }

    /// Height of a voxel, m.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The materials that numbers stand for.
    pub fn materials(&self) -> &Materials {
        &self.materials
    }

    /// Volume of a voxel, m³.
    pub fn voxel_volume(&self) -> f64 {
        self.plan.cell_area() * self.height
    }

    /// The number of the material of a voxel; none where it is empty.
    pub fn material(&self, level: usize, node: usize) -> Option<u8> {
        Some(self.voxels[level * self.plan.len() + node]).filter(|v| *v != EMPTY)
    }

    /// How many voxels are not empty. **Cost** O(voxels).
    pub fn solids(&self) -> usize {
        parallel::map_pieces(self.voxels.len(), |r| self.voxels[r].iter().filter(|v| **v != EMPTY).count()).iter().sum()
    }

    /// The uppermost level of a column that is not empty.
    pub fn top(&self, node: usize) -> Option<usize> {
        (0..self.levels).rev().find(|&level| self.material(level, node).is_some())
    }

    /// The middle of a voxel, m.
    pub fn middle(&self, level: usize, node: usize) -> [f64; 3] {
        let [x, y] = self.plan.position(node);
        [x, y, self.bottom + (level as f64 + 0.5) * self.height]
    }

    /// Empties voxels whose middle `cut` holds for; returns how many were not empty before. **Cost** O(voxels).
    pub fn empty(&mut self, cut: impl Fn([f64; 3]) -> bool + Sync) -> usize {
        let (before, nodes) = (self.solids(), self.plan.len());
        let mut voxels = std::mem::take(&mut self.voxels);
        parallel::update(&mut voxels, |i, v| {
            if *v != EMPTY && cut(self.middle(i / nodes, i % nodes)) {
                *v = EMPTY;
            }
        });
        self.voxels = voxels;
        before - self.solids()
    }
}

impl Terrain for VoxelGrid {
    const KIND: Kind = Kind::VoxelGrid;
    const BYTES_A_NODE: u64 = 3;

    fn nodes(&self) -> usize {
        self.voxels.len()
    }

    /// Under the underside all is solid, down to z = 0.
    fn volume(&self) -> f64 {
        self.plan.cell_area() * self.bottom * self.plan.len() as f64 + self.solids() as f64 * self.voxel_volume()
    }

    fn check_finite(&self) -> Result<(), (&'static str, usize)> {
        Ok(())
    }
}
