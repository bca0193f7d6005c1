//! The line along the passages of a cave, as surveyors would draw it.
//!
//! # Method
//! Thinning to a line of voxels; two that touch are joined unless a third lies between them over
//! shorter steps. Walls are where a ray from the line first meets rock.

use super::cave_voxels;
use crate::algo::lattice::{Lattice, NEIGHBOURS, Thinning, thin};
use crate::feature::{ConduitNetwork, Passage};
use crate::math::distance;
use crate::terrain::VoxelGrid;

/// Stations of a cave, the legs between them, and the walls around each.
///
/// ```
/// use landform_core::analysis::cave::Centreline;
///
/// let line = Centreline { stations: vec![[0.0; 3], [3.0, 4.0, 0.0]], legs: vec![[0, 1]], ..Centreline::default() };
/// assert_eq!(line.length(), 5.0);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Centreline {
    /// Places, m.
    pub stations: Vec<[f64; 3]>,
    /// Pairs of stations.
    pub legs: Vec<[u32; 2]>,
    /// Distances to the walls at each station, m.
    pub passages: Vec<Passage>,
}

impl Centreline {
    /// Length of all legs, m.
    ///
    /// ```
    /// assert_eq!(landform_core::analysis::cave::Centreline::default().length(), 0.0);
    /// ```
    pub fn length(&self) -> f64 {
        self.legs.iter().map(|l| l.map(|s| self.stations[s as usize])).map(|[a, b]| distance(a, b)).sum()
    }

    /// Length of what lies under an elevation (m), such as that of standing water, m.
    ///
    /// ```
    /// use landform_core::analysis::cave::Centreline;
    ///
    /// let stations = vec![[0.0; 3], [3.0, 0.0, 4.0]];
    /// let line = Centreline { stations, legs: vec![[0, 1]], ..Centreline::default() };
    /// assert_eq!([-1.0, 1.0, 9.0].map(|level| line.length_under(level)), [0.0, 1.25, 5.0]);
    /// ```
    pub fn length_under(&self, level: f64) -> f64 {
        let under = |leg: &[u32; 2]| {
            let [a, b] = leg.map(|s| self.stations[s as usize]);
            let (low, high) = (a[2].min(b[2]), a[2].max(b[2]));
            let part = if high > low {
                ((level - low) / (high - low)).clamp(0.0, 1.0)
            } else {
                f64::from(u8::from(low < level))
            };
            part * distance(a, b)
        };
        self.legs.iter().map(under).sum()
    }

    /// The same as a network of conduits.
    ///
    /// ```
    /// use landform_core::analysis::cave::Centreline;
    ///
    /// assert!(Centreline::default().network().conduits.is_empty());
    /// ```
    pub fn network(&self) -> ConduitNetwork {
        let passage = |n: u32| self.passages.get(n as usize).copied().unwrap_or_default();
        ConduitNetwork::from_edges(self.stations.clone(), &self.legs, passage)
    }
}

/// The line along the passages of the cave in some ground.
///
/// **Cost** O(voxels), about 0.3 µs for each of the cave.
///
/// ```
/// use landform_core::analysis::cave::centreline;
/// use landform_core::grid::{Grid, Shape};
/// use landform_core::terrain::{Bounds, Materials, VoxelGrid};
///
/// let plan = Grid::new(Shape::new(9, 30), [1.0, 1.0])?;
/// let mut ground = VoxelGrid::from_fn(plan, 9, 0.0, 1.0, &Materials::default(), |_, _| Some(0))?;
/// ground.empty(Bounds { low: [0.0, 2.6, 2.0], high: [29.0, 5.4, 5.0] }, |_| true);
/// let line = centreline(&ground);
/// assert!((27.0..=30.0).contains(&line.length()));
/// assert!(line.passages.iter().all(|p| p.width() == 3.0));
/// # Ok::<(), landform_core::Error>(())
/// ```
pub fn centreline(ground: &VoxelGrid) -> Centreline {
    let (lattice, cave) = cave_voxels(ground);
    line_of(ground, &lattice, &cave)
}

/// The line along passages that are known.
pub(super) fn line_of(ground: &VoxelGrid, lattice: &Lattice, cave: &[bool]) -> Centreline {
    let mut line = cave.to_vec();
    thin(lattice, &mut line, Thinning::Line);
    let mut number = vec![u32::MAX; lattice.stored()];
    let stations: Vec<usize> = lattice.voxels().filter(|&i| line[i]).collect();
    stations.iter().zip(0..).for_each(|(&i, n)| number[i] = n);
    let mut legs = Vec::new();
    for &i in &stations {
        // Each pair once, from the one of the higher index.
        for k in (0..NEIGHBOURS / 2).filter(|&k| line[lattice.neighbour(i, k)]) {
            if is_direct(lattice, &line, i, k) {
                legs.push([number[lattice.neighbour(i, k)], number[i]]);
            }
        }
    }
    let places = stations.iter().map(|&i| lattice.middle(ground, i)).collect();
    let mut line = Centreline { stations: places, legs, passages: Vec::new() };
    let mut along = vec![[0.0; 2]; stations.len()];
    for [a, b] in &line.legs {
        let (from, to) = (line.stations[*a as usize], line.stations[*b as usize]);
        let way = [to[0] - from[0], to[1] - from[1]];
        for s in [*a as usize, *b as usize] {
            // Legs that run to and from add up, whichever way they are told.
            let turn = if along[s][0] * way[0] + along[s][1] * way[1] < 0.0 { -1.0 } else { 1.0 };
            along[s] = [along[s][0] + turn * way[0], along[s][1] + turn * way[1]];
        }
    }
    line.passages = stations.iter().zip(&along).map(|(&i, along)| walls(lattice, cave, i, *along)).collect();
    line
}

/// Whether no third voxel of the line lies between two over shorter steps.
fn is_direct(lattice: &Lattice, line: &[bool], i: usize, k: usize) -> bool {
    let axes = |a: [i8; 3]| a.iter().filter(|s| **s != 0).count();
    let step = lattice.step(k);
    !(0..NEIGHBOURS).any(|j| {
        let other = lattice.step(j);
        let rest = [0, 1, 2].map(|a| step[a] - other[a]);
        let is_near = rest.iter().all(|r| r.abs() <= 1);
        is_near && axes(other) < axes(step) && axes(rest) < axes(step) && line[lattice.neighbour(i, j)]
    })
}

/// Distances to the walls, left and right of a direction in the plane.
fn walls(lattice: &Lattice, cave: &[bool], i: usize, along: [f64; 2]) -> Passage {
    let [dx, dy, dz] = lattice.sides();
    let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
    // Rows run from the north, so south is along +y of the lattice.
    let left = if length > 0.0 { [-along[1] / length, -along[0] / length] } else { [-1.0, 0.0] };
    let start = lattice.place(i).map(|v| v as f64 + 0.5);
    let size = lattice.size();
    let far = |way: [f64; 3]| {
        let tick = 0.25 * dx.min(dy).min(dz);
        let ticks = (0..).take_while(|n| {
            let d = (f64::from(*n) + 0.5) * tick;
            let at = [start[0] + way[0] * d / dx, start[1] + way[1] * d / dy, start[2] + way[2] * d / dz];
            let is_in = (0..3).all(|k| at[k] >= 0.0 && at[k] < size[k] as f64);
            is_in && cave[lattice.at(at.map(|v| v as usize))]
        });
        ticks.count() as f64 * tick
    };
    Passage {
        left: far([left[0], left[1], 0.0]),
        right: far([-left[0], -left[1], 0.0]),
        up: far([0.0, 0.0, 1.0]),
        down: far([0.0, 0.0, -1.0]),
    }
}
