//! Voxels that a brush removes and deposits.

use std::collections::BTreeMap;

use super::{EMPTY, VoxelGrid};
use crate::Result;
use crate::terrain::{Brush, Erodible, Removed};

impl VoxelGrid {
    /// Voxels under a brush, nearest first; the one at its middle alone where it is finer than they
    /// are.
    fn under(&self, brush: Brush) -> Vec<(usize, f64)> {
        let n = self.plan.len();
        let square = |i: usize| {
            let middle = self.middle(i / n, i % n);
            (0..3).map(|k| (middle[k] - brush.at[k]) * (middle[k] - brush.at[k])).sum::<f64>()
        };
        let all = (0..self.voxels.len()).map(|i| (i, square(i)));
        let mut near: Vec<(usize, f64)> = all.clone().filter(|v| v.1 < brush.radius * brush.radius).collect();
        if near.is_empty() {
            near.extend(all.min_by(|a, b| a.1.total_cmp(&b.1)));
        }
        near.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        near
    }

    /// Whole voxels in a volume.
    fn whole(&self, volume: f64) -> usize {
        (volume / self.voxel_volume() + 1e-9).max(0.0) as usize
    }
}

impl Erodible for VoxelGrid {
    /// Whole voxels, the nearest first; what is left of the volume stays. **Cost** O(voxels).
    fn remove(&mut self, brush: Brush, volume: f64) -> Removed {
        let under = self.under(brush);
        let solid: Vec<usize> = under.iter().map(|v| v.0).filter(|&i| self.voxels[i] != EMPTY).collect();
        let mut counts = BTreeMap::new();
        for &i in solid.iter().take(self.whole(volume)) {
            *counts.entry(std::mem::replace(&mut self.voxels[i], EMPTY)).or_insert(0_usize) += 1;
        }
        let volume_of = |count: usize| count as f64 * self.voxel_volume();
        let name = |number: u8| self.materials.get(number).name.clone();
        let by_material = counts.iter().map(|(number, count)| (name(*number), volume_of(*count))).collect();
        Removed { volume: volume_of(counts.values().sum()), by_material }
    }

    /// Whole voxels, each on a solid one or on the underside, the lowest first and then the
    /// nearest. **Cost** O(voxels) and the square of those under the brush.
    fn deposit(&mut self, brush: Brush, volume: f64, material: &str) -> Result<f64> {
        let number = self.materials.need(material, "material")?;
        let (under, n) = (self.under(brush), self.plan.len());
        let mut laid = 0;
        while laid < self.whole(volume) {
            let rests = |i: usize| self.voxels[i] == EMPTY && (i < n || self.voxels[i - n] != EMPTY);
            let free = under.iter().filter(|v| rests(v.0));
            // Those under the brush are in order of distance, and the first of equals is taken.
            let Some((lowest, _)) = free.min_by_key(|v| v.0 / n) else { break };
            self.voxels[*lowest] = number;
            laid += 1;
        }
        Ok(laid as f64 * self.voxel_volume())
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
