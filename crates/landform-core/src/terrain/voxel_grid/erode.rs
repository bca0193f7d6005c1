//! Voxels that a brush removes and deposits: whole ones, or parts where they may be full in part.
//!
//! # Sources
//! Hartley (thesis), Equations 6.13 and 6.14: a weight of 1 - d/R, and whole voxels; its `floor` of
//! negative numbers would erode more than was asked for, so the rest stays with who asks.

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

    /// Weights 1 - d/R of voxels under a brush, of which the middle one is not 0.
    fn weights(&self, brush: Brush) -> Vec<(usize, f64)> {
        let weight = |square: f64| (1.0 - square.sqrt() / brush.radius).max(1e-9);
        self.under(brush).into_iter().map(|(i, square)| (i, weight(square))).collect()
    }

    /// Takes parts of voxels by weight; what a voxel does not hold comes from the others.
    fn take_parts(&mut self, brush: Brush, volume: f64, load: &mut [f64]) -> f64 {
        let unit = self.voxel_volume();
        let under: Vec<_> = self.weights(brush).into_iter().filter(|v| self.part(v.0) > 0.0).collect();
        let mut left = volume;
        for _ in 0..ROUNDS {
            // Less than nothing is left where numbers of single precision took a little more.
            if !(left > LEAST * unit) {
                break;
            }
            left -= self.share(&under, -left, unit, |grid, i, moved| {
                load[usize::from(grid.voxels[i])] += moved;
                if grid.part(i) == 0.0 {
                    grid.voxels[i] = EMPTY;
                }
            });
        }
        volume - left
    }

    /// Lays parts of voxels by weight, on those that hold something or rest on what is half full;
    /// what has no room goes to the others, and to those above them.
    fn lay_parts(&mut self, brush: Brush, volume: f64, material: u8) -> f64 {
        let (unit, n, mut left) = (self.voxel_volume(), self.plan.len(), volume);
        let under = self.weights(brush);
        for _ in 0..ROUNDS {
            if !(left > LEAST * unit) {
                break;
            }
            let rests = |i: usize| self.part(i) > 0.0 || i < n || self.part(i - n) >= 0.5;
            let free: Vec<_> = under.iter().copied().filter(|v| self.part(v.0) < 1.0 && rests(v.0)).collect();
            left -= self.share(&free, left, unit, |grid, i, moved| {
                // A voxel is of one material: the one of which it holds more.
                if grid.voxels[i] == EMPTY || moved > 0.5 * f64::from(grid.part(i)) * unit {
                    grid.voxels[i] = material;
                }
            });
        }
        volume - left
    }

    /// Adds a volume (m³; negative: takes it) to voxels by weight, as far as each can hold or give;
    /// returns the volume moved, which `tell` is given voxel by voxel.
    fn share(
        &mut self,
        voxels: &[(usize, f64)],
        volume: f64,
        unit: f64,
        mut tell: impl FnMut(&mut Self, usize, f64),
    ) -> f64 {
        let whole: f64 = voxels.iter().map(|v| v.1).sum();
        if !(whole > 0.0) {
            return 0.0;
        }
        let mut moved = 0.0;
        for &(i, weight) in voxels {
            let Some(fill) = &mut self.fill else { break };
            let before = f64::from(fill[i]);
            let after = (before + volume / unit * weight / whole).clamp(0.0, 1.0);
            fill[i] = after as f32;
            // What was moved in truth, in numbers of single precision.
            let part = (f64::from(fill[i]) - before).abs() * unit;
            if part > 0.0 {
                moved += part;
                tell(self, i, part);
            }
        }
        moved
    }
}

impl Erodible for VoxelGrid {
    fn table(&self) -> Option<&Materials> {
        Some(&self.materials)
    }

    fn make_divisible(&mut self) {
        self.make_fillable();
    }

    /// That of the voxel there, or of the nearest beside it that holds something.
    fn material_at(&self, place: [f64; 3]) -> u8 {
        let radius = 1.8 * self.plan.spacing[0].max(self.plan.spacing[1]).max(self.height);
        let under = self.under(Brush { at: place, radius });
        under.into_iter().map(|v| self.voxels[v.0]).find(|v| *v != EMPTY).unwrap_or(0)
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
