//! Caves in voxels: which voxels are one, the line along its passages, and its form in numbers.
//!
//! Passages hang together over faces, edges and corners of voxels, as in meshes of caves.

mod centreline;
mod morphometry;
mod walk;

pub use centreline::{Centreline, centreline};
pub use morphometry::{CaveClass, Morphometry, Share, morphometry};
pub use walk::Chamber;

use crate::algo::lattice::Lattice;
use crate::terrain::VoxelGrid;

/// A lattice over the voxels of the ground: columns along x, rows from the north along y, levels
/// along z; and which of them are cave. In a block of rock, which has a permeability, these are all
/// empty voxels; in other ground those under a roof.
///
/// **Cost** O(voxels).
///
/// ```
/// use landform_core::analysis::cave::cave_voxels;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{Materials, VoxelGrid};
///
/// let plan = Grid::new(Shape::new(1, 2), [1.0, 1.0])?;
/// let is_rock = |level: usize, node: usize| (level != 1 && node == 0) || level == 0;
/// let ground = VoxelGrid::from_fn(plan, 3, 0.0, 1.0, &Materials::default(), |l, n| is_rock(l, n).then_some(0))?;
/// let (lattice, cave) = cave_voxels(&ground);
/// // One lies under a roof, two under the sky.
/// assert_eq!(lattice.voxels().filter(|&i| cave[i]).count(), 1);
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn cave_voxels(ground: &VoxelGrid) -> (Lattice, Vec<bool>) {
    let (plan, levels) = (ground.plan(), ground.levels());
    let lattice = Lattice::over(ground);
    let is_block = ground.field(VoxelGrid::PERMEABILITY).is_some();
    let roof = |node: usize| (0..levels).rev().find(|&l| ground.material(l, node).is_some()).unwrap_or(0);
    let roofs: Vec<usize> = (0..plan.len()).map(|node| if is_block { levels } else { roof(node) }).collect();
    let is_cave = |i: usize| {
        let (level, node) = (i / plan.len(), i % plan.len());
        level < roofs[node] && ground.material(level, node).is_none()
    };
    let cave = lattice.padded((0..plan.len() * levels).map(is_cave), false);
    (lattice, cave)
}
