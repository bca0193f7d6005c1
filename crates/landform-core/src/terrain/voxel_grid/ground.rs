//! The surface of a voxel grid.

use super::VoxelGrid;
use crate::terrain::{Bounds, Ground};

impl VoxelGrid {
    /// Column, row and level of a place, counted from the outer corner of the first voxel.
    pub(super) fn lattice(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [col, row] = self.plan.col_row([x, y]);
        [col + 0.5, row + 0.5, (z - self.bottom) / self.height]
    }

    /// Whether a voxel of the lattice is solid; none beyond it.
    fn is_solid(&self, [col, row, level]: [i64; 3]) -> Option<bool> {
        let within = |i: i64, n: usize| usize::try_from(i).ok().filter(|i| *i < n);
        let (col, row) = (within(col, self.plan.shape.cols)?, within(row, self.plan.shape.rows)?);
        Some(self.material(within(level, self.levels)?, self.plan.shape.index(row, col)).is_some())
    }
}

impl Ground for VoxelGrid {
    /// The box around all voxels, empty ones too.
    fn bounding_box(&self) -> Bounds {
        let [sw, ne] = self.plan.bounds();
        let [dx, dy] = self.plan.spacing.map(|d| 0.5 * d);
        let top = self.bottom + self.levels as f64 * self.height;
        Bounds { low: [sw[0] - dx, sw[1] - dy, self.bottom], high: [ne[0] + dx, ne[1] + dy, top] }
    }

    fn height_at(&self, [x, y]: [f64; 2]) -> Option<f64> {
        let [col, row, _] = self.lattice([x, y, 0.0]).map(|v| v.floor() as i64);
        self.is_solid([col, row, 0])?;
        self.top(self.plan.shape.index(row as usize, col as usize))
    }

    /// By how full voxels are, linear between their middles; no more than half a voxel.
    fn depth_at(&self, place: [f64; 3]) -> Option<f64> {
        self.fill_at(place).map(|part| (part - 0.5) * self.resolution())
    }

    /// On the surface that the voxels' parts add up to, along columns of the axis that it faces.
    fn contact(&self, place: [f64; 3]) -> Option<([f64; 3], [f64; 3])> {
        self.fill_at(place).map(|_| self.nearest_surface(place))
    }

    fn resolution(&self) -> f64 {
        self.plan.spacing[0].min(self.plan.spacing[1]).min(self.height)
    }

    /// Voxel by voxel along the line (Amanatides & Woo 1987): roofs and walls of caves are met
    /// too. **Cost** O(voxels on the line).
    fn hit(&self, from: [f64; 3], to: [f64; 3]) -> Option<f64> {
        let (start, end) = (self.lattice(from), self.lattice(to));
        let along: [f64; 3] = std::array::from_fn(|k| end[k] - start[k]);
        let mut voxel = start.map(|v| v.floor() as i64);
        let step = along.map(|v| if v > 0.0 { 1 } else { -1 });
        // Where the line leaves the voxel along each axis, and how far from one face to the next.
        let to_face = |k: usize, voxel: [i64; 3]| {
            let face = voxel[k] as f64 + if step[k] > 0 { 1.0 } else { 0.0 };
            if along[k] == 0.0 { f64::INFINITY } else { (face - start[k]) / along[k] }
        };
        let mut at = 0.0;
        loop {
            if self.is_solid(voxel) == Some(true) {
                return Some(at);
            }
            let leave: [f64; 3] = std::array::from_fn(|k| to_face(k, voxel));
            let axis = (0..3).min_by(|&a, &b| leave[a].total_cmp(&leave[b]))?;
            at = leave[axis];
            if !(at <= 1.0) {
                return None;
            }
            voxel[axis] += step[axis];
        }
    }
}
