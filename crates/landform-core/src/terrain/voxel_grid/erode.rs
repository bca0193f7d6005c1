//! Voxels that a brush removes and deposits: whole ones, or parts where they may be full in part.
//!
//! # Sources
//! Hartley (thesis), Equations 6.13 and 6.14: parts of voxels, and whole ones. A weight of 1 - d/R
//! in a ball, as there, makes ground under the surface porous: parts are taken at the surface, by
//! the half-sphere of Equation 6.9 across it. Its `floor` of negative numbers would erode more than
//! was asked for, so the rest stays with who asks.

use super::facing::Facing;
use super::{EMPTY, VoxelGrid};
use crate::terrain::{Brush, Erodible, Materials};

/// Rounds in which what finds no room in a voxel is shared among the others.
const ROUNDS: usize = 4;

/// Least part of a voxel that is moved.
const LEAST: f64 = 1e-6;

impl VoxelGrid {
    /// Voxels under a brush, nearest first, with the squares of their distances (m²); the one at
    /// its middle alone where it is finer than they are.
    fn under(&self, brush: Brush) -> Vec<(usize, f64)> {
        let (n, rows, cols) = (self.plan.len(), self.plan.shape.rows, self.plan.shape.cols);
        let (at, [dx, dy]) = (self.lattice(brush.at).map(|v| v - 0.5), self.plan.spacing);
        let side = [dx, dy, self.height];
        let range = |k: usize, n: usize| {
            let reach = brush.radius / side[k];
            let low = (at[k] - reach).ceil().clamp(0.0, n as f64) as usize;
            low..((at[k] + reach).floor() + 1.0).clamp(low as f64, n as f64) as usize
        };
        let mut near = Vec::new();
        let (of_cols, of_rows) = (range(0, cols), range(1, rows));
        for level in range(2, self.levels) {
            for (row, col) in of_rows.clone().flat_map(|row| of_cols.clone().map(move |col| (row, col))) {
                let off = [col as f64 - at[0], row as f64 - at[1], level as f64 - at[2]];
                let square = (0..3).map(|k| off[k] * side[k] * (off[k] * side[k])).sum::<f64>();
                if square < brush.radius * brush.radius {
                    near.push((level * n + row * cols + col, square));
                }
            }
        }
        if near.is_empty() {
            let nearest =
                |v: f64, n: usize| (v >= -0.5 && v <= n as f64 - 0.5).then(|| (v.round().max(0.0) as usize).min(n - 1));
            if let (Some(col), Some(row), Some(level)) =
                (nearest(at[0], cols), nearest(at[1], rows), nearest(at[2], self.levels))
            {
                near.push((level * n + row * cols + col, 0.0));
            }
        }
        near.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        near
    }

    /// Whole voxels in a volume.
    fn whole(&self, volume: f64) -> usize {
        (volume / self.voxel_volume() + 1e-9).max(0.0) as usize
    }

    /// Takes whole voxels, the nearest first.
    fn take_whole(&mut self, brush: Brush, volume: f64, load: &mut [f64]) -> f64 {
        let most = self.whole(volume);
        if most == 0 {
            return 0.0;
        }
        let solid = self.under(brush).into_iter().map(|v| v.0).filter(|&i| self.voxels[i] != EMPTY);
        let solid: Vec<usize> = solid.take(most).collect();
        for &i in &solid {
            load[usize::from(std::mem::replace(&mut self.voxels[i], EMPTY))] += self.voxel_volume();
        }
        solid.len() as f64 * self.voxel_volume()
    }

    /// Lays whole voxels, each on a solid one or on the underside, the lowest first.
    fn lay_whole(&mut self, brush: Brush, volume: f64, material: u8) -> f64 {
        let (most, n, mut laid) = (self.whole(volume), self.plan.len(), 0);
        let under = if most == 0 { Vec::new() } else { self.under(brush) };
        while laid < most {
            let rests = |i: usize| self.voxels[i] == EMPTY && (i < n || self.voxels[i - n] != EMPTY);
            let free = under.iter().filter(|v| rests(v.0));
            // Those under the brush are in order of distance, and the first of equals is taken.
            let Some((lowest, _)) = free.min_by_key(|v| v.0 / n) else { break };
            self.voxels[*lowest] = material;
            laid += 1;
        }
        laid as f64 * self.voxel_volume()
    }

    /// Columns under a brush along the axis that the surface faces, each with its voxel beside the
    /// brush and a weight: a half-sphere; the nearest alone where the brush is finer than they are.
    fn columns(&self, facing: Facing, brush: Brush) -> Vec<([i64; 3], f64)> {
        let (at, sides, counts, [a, b]) = (self.lattice(brush.at), self.sides(), self.counts(), facing.across());
        let near = (at[facing.axis].floor() as i64).clamp(0, counts[facing.axis] - 1);
        let range = |k: usize| {
            let (middle, reach) = (at[k] - 0.5, brush.radius / sides[k]);
            let within = |v: f64| v.clamp(0.0, counts[k] as f64) as i64;
            within((middle - reach).ceil())..within((middle + reach).floor() + 1.0)
        };
        let voxel = |i: i64, j: i64| {
            let mut voxel = [near; 3];
            (voxel[a], voxel[b]) = (i, j);
            voxel
        };
        let off = |k: usize, i: i64| (i as f64 + 0.5 - at[k]) * sides[k];
        let mut under = Vec::new();
        for j in range(b) {
            for i in range(a) {
                let left = brush.radius * brush.radius - off(a, i) * off(a, i) - off(b, j) * off(b, j);
                if left > 0.0 {
                    under.push((voxel(i, j), left.sqrt()));
                }
            }
        }
        let is_beside = |k: usize| at[k] >= 0.0 && at[k] <= counts[k] as f64;
        if under.is_empty() && is_beside(a) && is_beside(b) {
            let nearest = |k: usize| (at[k] as i64).min(counts[k] - 1);
            under.push((voxel(nearest(a), nearest(b)), 1.0));
        }
        under
    }

    /// Voxels of a column beside a brush within which its surface is looked for.
    fn reach(&self, facing: Facing, brush: Brush) -> i64 {
        (brush.radius / self.sides()[facing.axis]).ceil().min(1e6) as i64 + 2
    }

    /// Takes parts of the voxels at the surface, and of those behind them.
    fn take_parts(&mut self, brush: Brush, volume: f64, load: &mut [f64]) -> f64 {
        let facing = self.facing(self.lattice(brush.at).map(|v| v.floor() as i64));
        let (under, reach) = (self.columns(facing, brush), self.reach(facing, brush));
        self.in_rounds(&under, volume, |grid, voxel, wanted| grid.take_from_column(facing, voxel, reach, wanted, load))
    }

    /// Lays parts of voxels from above, on what is there.
    fn lay_parts(&mut self, brush: Brush, volume: f64, material: u8) -> f64 {
        let (under, reach) = (self.columns(Facing::UP, brush), self.reach(Facing::UP, brush));
        self.in_rounds(&under, volume, |grid, voxel, wanted| grid.lay_on_column(voxel, reach, wanted, material))
    }

    /// Moves a volume (m³) column by column by weight; what one has no room for, or does not hold,
    /// is the others'. Returns the volume moved.
    fn in_rounds(
        &mut self,
        columns: &[([i64; 3], f64)],
        volume: f64,
        mut in_column: impl FnMut(&mut Self, [i64; 3], f64) -> f64,
    ) -> f64 {
        let (unit, whole) = (self.voxel_volume(), columns.iter().map(|c| c.1).sum::<f64>());
        // No more is asked for than the voxels of a column hold.
        let mut left = volume.min(unit * self.voxels.len() as f64);
        for _ in 0..ROUNDS {
            // Less than nothing is left where numbers of single precision took a little more.
            if !(left > LEAST * unit && whole > 0.0) {
                break;
            }
            let share = left / whole;
            for &(voxel, weight) in columns {
                left -= in_column(self, voxel, share * weight);
            }
        }
        volume.min(unit * self.voxels.len() as f64) - left
    }

    /// Adds a volume (m³; negative: takes it) to a voxel as far as it has room; returns the volume
    /// moved in truth, in numbers of single precision.
    fn add_to(&mut self, i: usize, volume: f64) -> f64 {
        let unit = self.voxel_volume();
        let Some(fill) = &mut self.fill else { return 0.0 };
        let before = f64::from(fill[i]);
        fill[i] = (before + volume / unit).clamp(0.0, 1.0) as f32;
        (f64::from(fill[i]) - before).abs() * unit
    }

    fn take_from_column(
        &mut self,
        Facing { axis, out }: Facing,
        mut voxel: [i64; 3],
        reach: i64,
        wanted: f64,
        load: &mut [f64],
    ) -> f64 {
        let count = self.counts()[axis];
        let is_in = |along: i64| (0..count).contains(&along);
        let near = voxel[axis];
        let solid = |grid: &Self, mut voxel: [i64; 3], along: i64| {
            voxel[axis] = along;
            is_in(along) && grid.part(grid.index_of(voxel)) > 0.0
        };
        let (mut at, mut looked) = (near, 0);
        if solid(self, voxel, at) {
            while looked < reach && solid(self, voxel, at + out) {
                (at, looked) = (at + out, looked + 1);
            }
        } else {
            while looked < reach && !solid(self, voxel, at) {
                (at, looked) = (at - out, looked + 1);
            }
        }
        // Rock whose surface is not within reach is not worn, nor are the cut sides of the block.
        if solid(self, voxel, at + out) || axis < 2 && !is_in(at + out) {
            return 0.0;
        }
        let mut left = wanted;
        while left > 0.0 && solid(self, voxel, at) && (at - near).abs() <= 2 * reach {
            voxel[axis] = at;
            let i = self.index_of(voxel);
            let moved = self.add_to(i, -left);
            load[usize::from(self.voxels[i])] += moved;
            if self.part(i) == 0.0 {
                self.voxels[i] = EMPTY;
            }
            left -= moved;
            if self.part(i) > 0.0 {
                break;
            }
            at -= out;
        }
        wanted - left
    }

    fn lay_on_column(&mut self, mut voxel: [i64; 3], reach: i64, wanted: f64, material: u8) -> f64 {
        let (n, unit, levels) = (self.plan.len(), self.voxel_volume(), self.levels as i64);
        let near = voxel[2];
        voxel[2] = 0;
        let foot = self.index_of(voxel);
        let part = |grid: &Self, level: i64| grid.part(foot + level as usize * n);
        let mut at = near;
        if part(self, at) > 0.0 {
            while at < levels && at - near <= reach && part(self, at) >= 1.0 {
                at += 1;
            }
        }
        while at > 0 && near - at <= reach && at < levels && part(self, at) == 0.0 && part(self, at - 1) < 1.0 {
            at -= 1;
        }
        let rests = at == 0 || at < levels && (part(self, at) > 0.0 || part(self, at - 1) > 0.0);
        let mut left = wanted;
        while rests && left > 0.0 && at < levels && at - near <= reach && part(self, at) < 1.0 {
            let i = foot + at as usize * n;
            let moved = self.add_to(i, left);
            // A voxel is of one material: the one of which it holds more.
            if self.voxels[i] == EMPTY || moved > 0.5 * f64::from(self.part(i)) * unit {
                self.voxels[i] = material;
            }
            left -= moved;
            if self.part(i) < 1.0 {
                break;
            }
            at += 1;
        }
        wanted - left
    }
}

impl Erodible for VoxelGrid {
    fn table(&self) -> Option<&Materials> {
        Some(&self.materials)
    }

    fn make_divisible(&mut self) {
        self.make_fillable();
    }

    /// That of the voxel at the surface in the column there, along the axis that it faces.
    fn material_at(&self, place: [f64; 3]) -> u8 {
        let counts = self.counts();
        let near = self.lattice(place).map(|v| v.floor() as i64);
        let mut voxel = [0, 1, 2].map(|k| near[k].clamp(0, counts[k] - 1));
        let facing = self.facing(voxel);
        let solid = |voxel: [i64; 3]| self.part(self.index_of(voxel)) > 0.0;
        for _ in 0..4 {
            if solid(voxel) {
                return self.voxels[self.index_of(voxel)];
            }
            voxel[facing.axis] = (voxel[facing.axis] - facing.out).clamp(0, counts[facing.axis] - 1);
        }
        0
    }

    /// Whole voxels, the nearest first, and what is left of the volume stays; or parts of voxels.
    /// **Cost** O(voxels under the brush).
    fn take(&mut self, brush: Brush, volume: f64, load: &mut [f64]) -> f64 {
        match self.fill {
            Some(_) => self.take_parts(brush, volume, load),
            None => self.take_whole(brush, volume, load),
        }
    }

    /// Whole voxels, each on a solid one or on the underside, the lowest first and then the
    /// nearest; or parts of voxels. **Cost** O(voxels under the brush), of whole ones its square.
    fn lay(&mut self, brush: Brush, volume: f64, material: u8) -> f64 {
        match self.fill {
            Some(_) => self.lay_parts(brush, volume, material),
            None => self.lay_whole(brush, volume, material),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::terrain::{Bounds, Ground, Materials, Terrain};

    /// A plain of rock at 20 m with a cave under it.
    fn ground() -> VoxelGrid {
        let plan = Grid::new(Shape::new(9, 11), [2.0, 2.0]).unwrap();
        let materials = Materials::default();
        let mut ground =
            VoxelGrid::from_fn(plan, 14, 0.0, 2.0, &materials, |level, _| (level < 10).then_some(0)).unwrap();
        let middle = ground.middle(5, 4 * 11 + 5);
        let near = Bounds { low: middle.map(|v| v - 3.0), high: middle.map(|v| v + 3.0) };
        let cut = ground.empty(near, |p| (0..3).all(|k| (p[k] - middle[k]).abs() < 3.0));
        assert_eq!(cut, 27);
        ground
    }

    #[test]
    fn lines_meet_roofs_and_walls_of_caves() {
        let ground = ground();
        let [x, y, z] = ground.middle(5, 4 * 11 + 5);
        assert_eq!(ground.height_at([x, y]), Some(20.0));
        let hit = |from: [f64; 3], to: [f64; 3]| ground.hit(from, to);
        // From above onto the plain, from the cave to its roof, its floor and its east wall, three
        // metres away.
        assert!((hit([x, y, 30.0], [x, y, 10.0]).unwrap() - 0.5).abs() < 1e-12);
        for to in [[x, y, z + 10.0], [x, y, z - 10.0], [x + 10.0, y, z], [x, y - 10.0, z]] {
            assert!((hit([x, y, z], to).unwrap() - 0.3).abs() < 1e-12, "{to:?}");
        }
        assert_eq!(hit([x, y, z], [x + 2.0, y, z]), None);
        assert_eq!(hit([x, y, z - 8.0], [x, y, z]), Some(0.0), "it begins in rock");
        assert_eq!(hit([-50.0, y, 25.0], [50.0, y, 25.0]), None);
        assert_eq!(ground.height_at([1e3, 0.0]), None);
    }

    #[test]
    fn a_brush_moves_whole_voxels_and_tells_what_moved() {
        let mut ground = ground();
        let [x, y, _] = ground.middle(0, 2 * 11 + 2);
        let brush = Brush { at: [x, y, 20.0], radius: 5.0 };
        let before = ground.volume();
        let laid = ground.deposit(brush, 30.0, "sand").unwrap();
        assert_eq!(laid, 24.0, "three voxels of 8 m3");
        assert_eq!(ground.volume() - before, 24.0);
        assert_eq!(ground.height_at([x, y]), Some(22.0));
        let removed = ground.remove(brush, 40.0);
        assert_eq!(removed.volume, 40.0);
        assert_eq!(removed.by_material.iter().map(|m| m.1).sum::<f64>(), 40.0);
        assert!(removed.by_material.iter().any(|m| m.0 == "sand"));
        assert_eq!(ground.volume() - before, 24.0 - 40.0);
        assert!(ground.deposit(brush, 8.0, "cheese").is_err());
        // No room: no more than there is.
        let all = ground.deposit(Brush { radius: 0.1, ..brush }, 1e9, "sand").unwrap();
        assert!(all <= 8.0);
    }
}
