//! Outlines of labelled regions of a raster.
//!
//! # Method
//! The sides between a region's cells and others are walked with the region on the left, so that
//! outer rings run counter-clockwise seen from above and holes clockwise (as GeoJSON asks). Where
//! two cells of the region touch at a corner only, the walk stays with the cell it came along:
//! regions are joined by sides, not corners. Rings that touch themselves there are parted, as OGC's
//! simple features ask.
//!
//! # Example
//! Cells that touch at a corner only belong to different regions:
//!
//! ```
//! use landform_core::algo::outline::label_regions;
//! use landform_core::grid::Shape;
//!
//! let land = [true, false, false, true];
//! let islands = label_regions(Shape::new(2, 2), |i| land[i], |_, _| true);
//! assert_eq!(islands, [1, 0, 0, 2]);
//! ```

use std::collections::HashMap;

use crate::grid::Shape;

/// A ring of corners as (column, row) of the raster's lattice of corners: (0, 0) is the north-west
/// corner of the north-west cell. Closed: the first corner is repeated at the end.
pub type Ring = Vec<[u32; 2]>;

/// Numbers cells that are joined by sides and for which `same` holds, from 1 in order of their
/// first cell; 0 where `is_in` does not hold. **Cost** O(cells).
pub fn label_regions(shape: Shape, is_in: impl Fn(usize) -> bool, same: impl Fn(usize, usize) -> bool) -> Vec<u32> {
    let mut label = vec![0; shape.len()];
    let (mut count, mut stack) = (0, Vec::new());
    for first in 0..label.len() {
        if label[first] != 0 || !is_in(first) {
            continue;
        }
        count += 1;
        label[first] = count;
        stack.push(first);
        while let Some(i) = stack.pop() {
            for j in beside(shape, i).into_iter().flatten() {
                if label[j] == 0 && is_in(j) && same(i, j) {
                    label[j] = count;
                    stack.push(j);
                }
            }
        }
    }
    label
}

fn beside(shape: Shape, i: usize) -> [Option<usize>; 4] {
    let cell = shape.cell(i);
    [
        (cell.col + 1 < shape.cols).then_some(i + 1),
        (cell.row > 0).then(|| i - shape.cols),
        (cell.col > 0).then(|| i - 1),
        (cell.row + 1 < shape.rows).then_some(i + shape.cols),
    ]
}

/// The rings of every region, by label: position k holds those of label k + 1, the outer ring
/// first. Corners in line are left out. **Cost** O(cells).
pub fn outlines(shape: Shape, label: &[u32]) -> Vec<Vec<Ring>> {
    let count = label.iter().copied().max().unwrap_or(0) as usize;
    let mut rings: Vec<Vec<Ring>> = vec![Vec::new(); count];
    // Sides of each cell that were walked: east 1, north 2, west 4, south 8.
    let mut walked = vec![0u8; label.len()];
    for i in 0..label.len() {
        for side in 0..4 {
            if label[i] != 0 && walked[i] >> side & 1 == 0 && is_border(shape, label, i, side) {
                let ring = walk(shape, label, i, side, &mut walked);
                rings[label[i] as usize - 1].extend(parted(ring));
            }
        }
    }
    for of_region in &mut rings {
        let outer = of_region.iter().position(|r| area(r) > 0.0);
        if let Some(k) = outer {
            of_region.swap(0, k);
        }
    }
    rings
}

fn is_border(shape: Shape, label: &[u32], i: usize, side: usize) -> bool {
    beside(shape, i)[side].is_none_or(|j| label[j] != label[i])
}

/// Walks from the start of a cell's side with the region on the left until the side comes round
/// again.
fn walk(shape: Shape, label: &[u32], first: usize, first_side: usize, walked: &mut [u8]) -> Ring {
    let (mut i, mut side) = (first, first_side);
    let mut ring: Ring = Vec::new();
    loop {
        walked[i] |= 1 << side;
        let corner = start_corner(shape, i, side);
        let in_line = ring.len() >= 2 && {
            let (a, b) = (ring[ring.len() - 2], ring[ring.len() - 1]);
            (a[0] == b[0] && b[0] == corner[0]) || (a[1] == b[1] && b[1] == corner[1])
        };
        if in_line {
            ring.pop();
        }
        ring.push(corner);
        // Round the corner of the same cell, else along the next cell, else round the inner corner.
        let next_side = (side + 1) % 4;
        if is_border(shape, label, i, next_side) {
            side = next_side;
        } else {
            i = beside(shape, i)[next_side].unwrap_or(i);
            if !is_border(shape, label, i, side) {
                i = beside(shape, i)[side].unwrap_or(i);
                side = (side + 3) % 4;
            }
        }
        if (i, side) == (first, first_side) {
            ring.push(ring[0]);
            return ring;
        }
    }
}

/// A ring that comes to a corner twice as rings that touch there: no ring touches itself.
fn parted(ring: Ring) -> Vec<Ring> {
    let (mut parts, mut open): (Vec<Ring>, Ring) = (Vec::new(), Vec::new());
    let mut place = HashMap::new();
    for corner in ring {
        if let Some(&at) = place.get(&corner) {
            let mut part = open.split_off(at);
            for corner in &part {
                place.remove(corner);
            }
            part.push(corner);
            parts.push(part);
        }
        place.insert(corner, open.len());
        open.push(corner);
    }
    parts
}

/// The corner from which a cell's side is walked, counter-clockwise with north up.
fn start_corner(shape: Shape, i: usize, side: usize) -> [u32; 2] {
    let cell = shape.cell(i);
    let (c, r) = (cell.col as u32, cell.row as u32);
    [[c + 1, r + 1], [c + 1, r], [c, r], [c, r + 1]][side]
}

/// Signed area in cells, positive counter-clockwise with north up.
fn area(ring: &Ring) -> f64 {
    let cross = |a: &[u32; 2], b: &[u32; 2]| f64::from(a[0]) * f64::from(b[1]) - f64::from(b[0]) * f64::from(a[1]);
    // Rows grow southwards.
    -0.5 * ring.windows(2).map(|w| cross(&w[0], &w[1])).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Seed;

    #[test]
    fn a_ring_with_a_hole_has_two_rings_and_the_right_turns() {
        let picture = ["....", ".##.", ".#.#", ".###"];
        let cells: Vec<char> = picture.iter().flat_map(|r| r.chars()).collect();
        let shape = Shape::new(4, 4);
        let label = label_regions(shape, |i| cells[i] == '#', |_, _| true);
        let rings = &outlines(shape, &label)[0];
        assert_eq!(rings.len(), 2, "the hole touches the outer ring at its corner: {rings:?}");
        let cells: Vec<char> = "#####...##...#####".chars().collect();
        let shape = Shape::new(3, 6);
        let label = label_regions(shape, |i| cells[i] == '#', |_, _| true);
        assert_eq!(label.iter().max(), Some(&1));
        assert_eq!(outlines(shape, &label).len(), 1);
    }

    #[test]
    fn areas_of_rings_sum_to_the_cells() {
        for seed in 0..8 {
            let shape = Shape::new(23, 31);
            let noise: Vec<bool> = (0..shape.len()).map(|i| Seed(seed).uniform(i as u64) < 0.55).collect();
            let label = label_regions(shape, |i| noise[i], |_, _| true);
            let all = outlines(shape, &label);
            for (k, rings) in all.iter().enumerate() {
                let cells = label.iter().filter(|&&l| l as usize == k + 1).count() as f64;
                let total: f64 = rings.iter().map(area).sum();
                assert!((total - cells).abs() < 1e-9, "region {k}: {total} of {cells} cells");
                assert!(area(&rings[0]) >= cells && rings[1..].iter().all(|r| area(r) < 0.0));
                assert!(rings.iter().all(|r| r.len() >= 5 && r.first() == r.last()));
                for ring in rings {
                    let once: std::collections::BTreeSet<_> = ring[1..].iter().collect();
                    assert_eq!(once.len() + 1, ring.len(), "region {k}: a ring touches itself: {ring:?}");
                }
            }
        }
    }
}
