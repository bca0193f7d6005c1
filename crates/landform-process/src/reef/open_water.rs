//! How far places in the sea are from open water.
//!
//! Open water is deep water that the sea beyond the map reaches through deep water, and whatever
//! sea lies on the map's border. Distances run over the sea, straight to the nearest open water
//! that the way there began from: around a headland they are somewhat short.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use landform_core::grid::{Domain, Status};
use landform_core::terrain::NodeSurface;

/// What does not change while a run lasts: places, and which nodes lie on the border.
#[derive(Clone, Debug)]
pub(super) struct Shore {
    position: Vec<[f64; 2]>,
    border: Vec<u32>,
}

/// Width of a cell, m: of the first node with ground, as all are much the same.
pub(super) fn cell_width(domain: &impl Domain, surface: &[f64]) -> f64 {
    surface.iter().position(|z| !z.is_nan()).map_or(1.0, |i| domain.area(i)).sqrt()
}

/// Distance of open water itself.
pub(super) const OPEN: f64 = 0.0;

impl Shore {
    pub(super) fn of<T: NodeSurface>(terrain: &T) -> Self {
        let n = terrain.elevation().len();
        let [lo, hi] = terrain.bounds();
        let near = 1e-6 * (hi[0] - lo[0]).max(hi[1] - lo[1]);
        let status = terrain.border();
        let position: Vec<[f64; 2]> = (0..n).map(|i| terrain.position(i)).collect();
        let is_on = |i: usize| {
            let p = position[i];
            status[i] == Status::BaseLevel || (0..2).any(|k| p[k] - lo[k] <= near || hi[k] - p[k] <= near)
        };
        let border = (0..n).filter(|&i| status[i] != Status::Masked && is_on(i)).map(|i| i as u32).collect();
        Self { position, border }
    }

    /// Places of the nodes, m.
    pub(super) fn positions(&self) -> &[[f64; 2]] {
        &self.position
    }

    /// Whether each node is open water: where it is deeper than `deep` (m).
    pub(super) fn open(&self, domain: &impl Domain, depth: impl Fn(usize) -> f64, deep: f64) -> Vec<bool> {
        let mut open = vec![false; self.position.len()];
        let mut stack: Vec<u32> = self.border.iter().copied().filter(|&i| depth(i as usize) > 0.0).collect();
        stack.iter().for_each(|&i| open[i as usize] = true);
        while let Some(i) = stack.pop() {
            for link in domain.neighbours(i as usize) {
                if !open[link.to] && depth(link.to) > deep {
                    open[link.to] = true;
                    stack.push(link.to as u32);
                }
            }
        }
        open
    }

    /// Distance (m) of every node of the sea to open water; infinite on land, and where it is more
    /// than `most`.
    pub(super) fn distance(
        &self,
        domain: &impl Domain,
        depth: impl Fn(usize) -> f64,
        open: &[bool],
        most: f64,
    ) -> Vec<f64> {
        let mut distance: Vec<f64> = open.iter().map(|&o| if o { OPEN } else { f64::INFINITY }).collect();
        let mut heap = BinaryHeap::new();
        let reach = |heap: &mut BinaryHeap<_>, distance: &mut [f64], from: usize, to: usize| {
            let ([ax, ay], [bx, by]) = (self.position[from], self.position[to]);
            let d = ((ax - bx) * (ax - bx) + (ay - by) * (ay - by)).sqrt();
            if d < distance[to] && d <= most && depth(to) >= 0.0 {
                distance[to] = d;
                // Numbers that are not negative are in the order of their bits.
                heap.push(Reverse((d.to_bits(), to as u32, from as u32)));
            }
        };
        for i in (0..open.len()).filter(|&i| open[i]) {
            for link in domain.neighbours(i).filter(|l| !open[l.to]) {
                reach(&mut heap, &mut distance, i, link.to);
            }
        }
        while let Some(Reverse((d, at, from))) = heap.pop() {
            if d == distance[at as usize].to_bits() {
                for link in domain.neighbours(at as usize) {
                    reach(&mut heap, &mut distance, from as usize, link.to);
                }
            }
        }
        distance
    }
}

#[cfg(test)]
mod tests {
    use landform_core::grid::{Grid, Shape};
    use landform_core::terrain::HeightField;

    use super::*;

    #[test]
    fn distances_are_straight_and_a_ring_closes_a_lagoon() {
        // Water 50 m deep, a ring of reef under 1 m from 200 to 260 m around the middle.
        let grid = Grid::new(Shape::new(101, 101), [10.0; 2]).unwrap();
        let radius = |i: usize| {
            let [x, y] = grid.position(i);
            ((x - 500.0) * (x - 500.0) + (y - 500.0) * (y - 500.0)).sqrt()
        };
        let depth = |i: usize| if (200.0..=260.0).contains(&radius(i)) { 1.0 } else { 50.0 };
        let field = HeightField::new(grid.clone(), (0..grid.len()).map(|i| -depth(i)).collect()).unwrap();
        let (shore, domain) = (Shore::of(&field), field.domain());
        let open = shore.open(&*domain, depth, 20.0);
        assert!((0..open.len()).all(|i| open[i] == (radius(i) > 260.0)));
        let distance = shore.distance(&*domain, depth, &open, 300.0);
        for i in (0..open.len()).filter(|&i| !open[i]) {
            // The ring's outer side is a staircase of cells.
            let expected = 260.0 - radius(i);
            assert!((distance[i] - expected).abs() < 15.0, "{} {expected}", distance[i]);
        }
        // A gap in the ring lets the sea in.
        let gap = |i: usize| if grid.position(i)[1] > 500.0 && grid.position(i)[0] == 500.0 { 50.0 } else { depth(i) };
        assert!(
            shore.open(&*domain, gap, 20.0).iter().filter(|&&o| o).count() > 1000 + open.iter().filter(|&&o| o).count()
        );
    }
}
