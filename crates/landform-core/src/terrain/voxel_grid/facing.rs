//! The surface of voxels as heights of columns along the axis that it faces most.
//!
//! # Method
//! How full the voxels of a column are, from the full one behind the surface to the empty one
//! before it, adds up to where the surface is: on ground with one height a node this is that
//! height, and between columns it is bilinear as on a raster. Walls and roofs have columns of their
//! own axes.
//!
//! # Sources
//! The height functions of methods with volumes of fluid: Cummins, Francois & Kothe (2005),
//! Estimating curvature from volume fractions, Computers & Structures 83.

use super::VoxelGrid;

/// Voxels along a column that are looked at on each side.
const REACH: i64 = 3;
/// Voxels along its axis within which a surface is beside a place.
const FARTHEST: f64 = 2.0;
/// A voxel that is so full ends a column.
const FULL: f32 = 0.999;

/// The axis that a surface faces most, and whether it faces the end of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Facing {
    pub(super) axis: usize,
    pub(super) out: i64,
}

impl Facing {
    pub(super) const UP: Self = Self { axis: 2, out: 1 };

    /// The two other axes.
    pub(super) fn across(self) -> [usize; 2] {
        [[1, 2], [0, 2], [0, 1]][self.axis]
    }
}

impl VoxelGrid {
    /// Numbers of voxels along columns, rows and levels.
    pub(super) fn counts(&self) -> [i64; 3] {
        [self.plan.shape.cols as i64, self.plan.shape.rows as i64, self.levels as i64]
    }

    /// Sides of a voxel along columns, rows and levels, m.
    pub(super) fn sides(&self) -> [f64; 3] {
        [self.plan.spacing[0], self.plan.spacing[1], self.height]
    }

    /// Index of a voxel of the lattice.
    pub(super) fn index_of(&self, [col, row, level]: [i64; 3]) -> usize {
        level as usize * self.plan.len() + row as usize * self.plan.shape.cols + col as usize
    }

    /// Part of a voxel that is solid; beyond the sides and the underside as at them, empty over the
    /// top.
    pub(super) fn part_at(&self, voxel: [i64; 3]) -> f32 {
        let counts = self.counts();
        if voxel[2] >= counts[2] {
            return 0.0;
        }
        self.part(self.index_of([0, 1, 2].map(|k| voxel[k].clamp(0, counts[k] - 1))))
    }

    /// Which way the surface beside a voxel faces; up where nothing tells.
    pub(super) fn facing(&self, voxel: [i64; 3]) -> Facing {
        let sides = self.sides();
        let fall = |k: usize| {
            let beside = |by: i64| {
                let mut beside = voxel;
                beside[k] += by;
                self.part_at(beside)
            };
            f64::from(beside(-1) - beside(1) + beside(-2) - beside(2)) / sides[k]
        };
        let falls = [fall(0), fall(1), fall(2)];
        let steeper = |a: usize, b: usize| if falls[b].abs() > falls[a].abs() { b } else { a };
        let axis = steeper(steeper(2, 0), 1);
        Facing { axis, out: if falls[axis] < 0.0 { -1 } else { 1 } }
    }

    /// Where the surface is in the column of a voxel, along its axis in voxels.
    fn surface_in(&self, Facing { axis, out }: Facing, voxel: [i64; 3]) -> f64 {
        let at = |along: i64| {
            let mut there = voxel;
            there[axis] = along;
            self.part_at(there)
        };
        let mut behind = voxel[axis];
        while (behind - voxel[axis]).abs() < REACH && at(behind) < FULL {
            behind -= out;
        }
        let (mut before, mut sum) = (behind + out, 0.0);
        for _ in 0..2 * REACH {
            let part = at(before);
            if !(part > 0.0) {
                break;
            }
            sum += f64::from(part);
            before += out;
        }
        let face = if out > 0 { behind + 1 } else { behind };
        face as f64 + out as f64 * sum
    }

    /// The surface at a place of the lattice: where it is along its axis, and its slopes along the
    /// two others, all in voxels.
    fn sheet(&self, facing: Facing, at: [f64; 3]) -> (f64, [f64; 2]) {
        let (counts, [a, b]) = (self.counts(), facing.across());
        let between = |k: usize| {
            let at = (at[k] - 0.5).clamp(0.0, (counts[k] - 1) as f64);
            let first = (at as i64).min((counts[k] - 2).max(0));
            (first, (first + 1).min(counts[k] - 1), at - first as f64)
        };
        let (u, v) = (between(a), between(b));
        let near = (at[facing.axis].floor() as i64).clamp(0, counts[facing.axis] - 1);
        let single = |i: i64, j: i64| {
            let mut voxel = [near; 3];
            (voxel[a], voxel[b]) = (i, j);
            self.surface_in(facing, voxel)
        };
        // Whole voxels are steps: what is on them feels their mean.
        let height = |i: i64, j: i64| match self.fill {
            Some(_) => single(i, j),
            None => {
                let around = (-1..=1).flat_map(|dj| (-1..=1).map(move |di| (i + di, j + dj)));
                around.map(|(i, j)| single(i, j)).sum::<f64>() / 9.0
            }
        };
        let corners = [height(u.0, v.0), height(u.1, v.0), height(u.0, v.1), height(u.1, v.1)];
        let lower = corners[0] + (corners[1] - corners[0]) * u.2;
        let upper = corners[2] + (corners[3] - corners[2]) * u.2;
        let slope = (corners[1] - corners[0]) * (1.0 - v.2) + (corners[3] - corners[2]) * v.2;
        (lower + (upper - lower) * v.2, [slope, upper - lower])
    }

    /// The point of the surface beside a place, and its unit normal out of the ground, m.
    pub(super) fn nearest_surface(&self, place: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let (from, sides) = (self.lattice(place), self.sides());
        let facing = self.facing(from.map(|v| v.floor() as i64));
        let (axis, [a, b], out) = (facing.axis, facing.across(), facing.out as f64);
        let normal = |[u, v]: [f64; 2]| {
            let mut normal = [0.0; 3];
            (normal[a], normal[b], normal[axis]) = (-u * sides[axis] / sides[a], -v * sides[axis] / sides[b], 1.0);
            let length = (normal[a] * normal[a] + normal[b] * normal[b] + 1.0).sqrt();
            normal.map(|v| out * v / length)
        };
        let (height, slopes) = self.sheet(facing, from);
        // Where the column shows another surface, as deep in rock, the place is left where it is.
        let is_beside = |height: f64| (height - from[axis]).abs() <= FARTHEST;
        if !is_beside(height) {
            let [x, y, z] = normal([0.0; 2]);
            return (place, [x, -y, z]);
        }
        let off = normal(slopes);
        let depth = (height - from[axis]) * sides[axis] * off[axis];
        let mut at = from;
        at[axis] = height;
        (at[a], at[b]) = (at[a] + depth * off[a] / sides[a], at[b] + depth * off[b] / sides[b]);
        let (beside, slopes) = self.sheet(facing, at);
        at[axis] = if is_beside(beside) { beside } else { height };
        let moved = [0, 1, 2].map(|k| (at[k] - from[k]) * sides[k]);
        // Rows run from the north.
        let turned = |[x, y, z]: [f64; 3]| [x, -y, z];
        let moved = turned(moved);
        ([0, 1, 2].map(|k| place[k] + moved[k]), turned(normal(slopes)))
    }
}
