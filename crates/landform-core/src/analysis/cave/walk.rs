//! Where one can walk in a cave, and its largest chamber.
//!
//! # Method
//! A capsule stands on a floor where the voxels that it fills are open; its lower end is round, so
//! that ground as high as its radius may rise beside it. It walks to a neighbouring floor that is
//! no further up or down than away. The largest chamber is where the largest ball fits: distances
//! to the nearest box of rock, found axis by axis (Felzenszwalb & Huttenlocher 2012).

use serde::Serialize;

use crate::algo::DisjointSets;
use crate::algo::lattice::{FACES, Lattice};
use crate::terrain::VoxelGrid;

/// Radius and height of who walks, m.
const WALKER: [f64; 2] = [0.4, 1.8];

/// Where the largest ball fits.
///
/// ```
/// use landform_core::analysis::cave::Chamber;
///
/// let chamber = Chamber { middle_m: [5.0, 5.0, 2.5], radius_m: 2.5 };
/// assert_eq!(chamber.middle_m[2] - chamber.radius_m, 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Chamber {
    /// The middle of its voxel: east, north and elevation, m.
    pub middle_m: [f64; 3],
    /// Distance from there to the nearest rock, m, to half a voxel less than what fits.
    pub radius_m: f64,
}

/// Part of the floors' area over which one can walk in one go, 0 to 1.
pub(super) fn walkable(lattice: &Lattice, cave: &[bool], voxels: &[usize]) -> f64 {
    let floors: Vec<usize> = voxels.iter().copied().filter(|&i| !cave[lattice.neighbour(i, FACES[0])]).collect();
    let stands = stands(lattice, cave);
    let good: Vec<usize> = floors.iter().copied().filter(|&i| stands(i)).collect();
    let mut is_good = vec![false; lattice.stored()];
    good.iter().for_each(|&i| is_good[i] = true);
    let mut hanging = DisjointSets::new(lattice.stored());
    let [dx, dy, dz] = lattice.sides();
    let [nx, ny, nz] = lattice.size();
    for &i in &good {
        let [x, y, z] = lattice.place(i);
        for (east, south) in [(1_i32, 0_u8), (0, 1), (1, 1), (-1, 1)] {
            let away = [f64::from(east.abs()) * dx, f64::from(south) * dy];
            let most = ((away[0] * away[0] + away[1] * away[1]).sqrt() / dz) as usize;
            let (Some(x), y) = (x.checked_add_signed(east as isize).filter(|x| *x < nx), y + usize::from(south)) else {
                continue;
            };
            let levels = z.saturating_sub(most)..=(z + most).min(nz - 1);
            for to in levels.filter(|_| y < ny).map(|z| lattice.at([x, y, z])).filter(|&to| is_good[to]) {
                hanging.join(i as u32, to as u32);
            }
        }
    }
    let mut count = vec![0_u32; lattice.stored()];
    good.iter().for_each(|&i| count[hanging.root(i as u32) as usize] += 1);
    f64::from(count.into_iter().max().unwrap_or(0)) / floors.len().max(1) as f64
}

/// Whether the walker stands in a voxel whose floor is rock.
fn stands<'a>(lattice: &'a Lattice, cave: &'a [bool]) -> impl Fn(usize) -> bool + 'a {
    let ([dx, dy, dz], [radius, height]) = (lattice.sides(), WALKER);
    let beside = |side: f64| ((radius - 0.5 * side) / side).ceil().max(0.0) as isize;
    let (rx, ry) = (beside(dx).min(1024), beside(dy).min(1024));
    let (high, low) = ((height / dz).ceil() as usize, (radius / dz).ceil() as usize);
    let columns: Vec<[isize; 2]> = (-ry..=ry).flat_map(|y| (-rx..=rx).map(move |x| [x, y])).collect();
    let size = lattice.size();
    move |i| {
        let [x, y, z] = lattice.place(i);
        columns.iter().all(|&[east, south]| {
            let gap = [(east, dx), (south, dy)].map(|(n, side)| ((n.abs() as f64 - 0.5) * side).max(0.0));
            if gap[0] * gap[0] + gap[1] * gap[1] >= radius * radius {
                return true;
            }
            let from = if east == 0 && south == 0 { 0 } else { low };
            let place = [x.checked_add_signed(east), y.checked_add_signed(south)];
            let [Some(x), Some(y)] = place else { return false };
            x < size[0] && y < size[1] && (from..high).all(|up| z + up < size[2] && cave[lattice.at([x, y, z + up])])
        })
    }
}

/// Where the largest ball fits; of equal ones the first from below.
pub(super) fn largest_chamber(ground: &VoxelGrid, lattice: &Lattice, cave: &[bool], voxels: &[usize]) -> Chamber {
    let [nx, ny, _] = lattice.size().map(|n| n + 2);
    let mut square: Vec<f64> = cave.iter().map(|c| if *c { f64::INFINITY } else { 0.0 }).collect();
    for (stride, side) in [1, nx, nx * ny].into_iter().zip(lattice.sides()) {
        let before = square.clone();
        for &i in voxels {
            // The border is rock, so that the way out of the box is never passed.
            for n in 1.. {
                let gap = (n as f64 - 0.5) * side;
                if gap * gap >= square[i] {
                    break;
                }
                for at in [i.checked_sub(n * stride), Some(i + n * stride)].into_iter().flatten() {
                    if let Some(there) = before.get(at) {
                        square[i] = square[i].min(there + gap * gap);
                    }
                }
            }
        }
    }
    let widest = voxels.iter().copied().fold(voxels[0], |best, i| if square[i] > square[best] { i } else { best });
    Chamber { middle_m: lattice.middle(ground, widest), radius_m: square[widest].sqrt() }
}

#[cfg(test)]
mod tests {
    use super::super::cave_voxels;
    use super::*;
    use crate::grid::{Grid, Shape};
    use crate::terrain::{Bounds, Materials};

    fn rock(cuts: &[([f64; 3], [f64; 3])]) -> (VoxelGrid, Lattice, Vec<bool>, Vec<usize>) {
        let plan = Grid::new(Shape::new(30, 40), [0.5, 0.5]).unwrap();
        let mut ground = VoxelGrid::from_fn(plan, 30, 0.0, 0.5, &Materials::default(), |_, _| Some(0)).unwrap();
        cuts.iter().for_each(|(low, high)| {
            ground.empty(Bounds { low: *low, high: *high }, |p| (0..3).all(|k| low[k] < p[k] && p[k] < high[k]));
        });
        let (lattice, cave) = cave_voxels(&ground);
        let voxels = lattice.voxels().filter(|&i| cave[i]).collect();
        (ground, lattice, cave, voxels)
    }

    fn share(cuts: &[([f64; 3], [f64; 3])]) -> f64 {
        let (_, lattice, cave, voxels) = rock(cuts);
        walkable(&lattice, &cave, &voxels)
    }

    #[test]
    fn a_corridor_is_walked_but_for_its_rim_and_a_crawl_is_not() {
        // 15 m long, 2 m wide (four voxels), 2 m high: beside the walls no capsule of 0.4 m stands.
        let corridor = ([2.2, 4.7, 1.0], [17.2, 6.7, 3.0]);
        let inner = 28.0 * 2.0 / (30.0 * 4.0);
        assert_eq!(share(&[corridor]), inner);
        assert_eq!(share(&[([2.2, 4.7, 1.0], [17.2, 6.7, 2.5])]), 0.0);
        assert_eq!(share(&[([2.2, 4.7, 1.0], [17.2, 5.2, 3.0])]), 0.0);
    }

    #[test]
    fn steps_are_climbed_up_to_45_degrees() {
        // Halls of 2 m width whose floors rise by the step at each of their half metres.
        let stairs = |step: f64| -> Vec<([f64; 3], [f64; 3])> {
            let at = |n: usize| {
                ([2.2 + 0.5 * n as f64, 4.7, 1.0 + step * n as f64], [2.7 + 0.5 * n as f64, 6.7, 6.0 + step * n as f64])
            };
            (0..8).map(at).collect()
        };
        assert!(share(&stairs(0.5)) > 0.3, "{}", share(&stairs(0.5)));
        assert!(share(&stairs(1.0)) < 0.1, "{}", share(&stairs(1.0)));
    }

    #[test]
    fn the_largest_ball_stands_in_the_chamber() {
        // Seven voxels each way: 3.5 m.
        let (ground, lattice, cave, voxels) =
            rock(&[([2.2, 4.7, 1.0], [17.2, 5.7, 2.0]), ([6.2, 4.2, 1.0], [9.7, 7.7, 4.5])]);
        let chamber = largest_chamber(&ground, &lattice, &cave, &voxels);
        assert_eq!(chamber.radius_m, 1.75);
        assert_eq!(chamber.middle_m, [8.0, 6.0, 2.75]);
    }
}
